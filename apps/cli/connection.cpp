// SPDX-License-Identifier: MIT
#include "connection.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <system_error>

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <winsock2.h>
#else
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#endif

#include <fmt/format.h>

#include <graze/io/output_error.hpp>

namespace graze::cli {
namespace {

constexpr int patience_seconds = 5;

// Windows has the same functions with other types and errors.
#ifdef _WIN32

using Native = SOCKET;
using Size = int;
constexpr DWORD patience = patience_seconds * 1000;  // in milliseconds

/// Sockets can be used after this, once per program.
bool start_sockets() {
  WSADATA data;
  return WSAStartup(MAKEWORD(2, 2), &data) == 0;
}
int last_error() { return WSAGetLastError(); }
bool was_interrupted() { return last_error() == WSAEINTR; }
bool was_aborted() { return last_error() == WSAECONNABORTED || last_error() == WSAECONNRESET; }
void close_socket(Native socket) { closesocket(socket); }
int length_of(std::size_t bytes) { return static_cast<int>(std::min(bytes, std::size_t{1} << 20U)); }

#else

using Native = int;
using Size = socklen_t;
constexpr timeval patience{.tv_sec = patience_seconds, .tv_usec = 0};

bool start_sockets() { return true; }
int last_error() { return errno; }
bool was_interrupted() { return last_error() == EINTR; }
bool was_aborted() { return last_error() == ECONNABORTED; }
void close_socket(Native socket) { ::close(socket); }
std::size_t length_of(std::size_t bytes) { return bytes; }

#endif

Native native(const Socket& socket) { return static_cast<Native>(socket.handle()); }

[[noreturn]] void refuse(std::string_view what) {
  throw io::OutputError(
      fmt::format("a page cannot be served on 127.0.0.1: {}: {}", what, std::system_category().message(last_error())));
}

/// The socket interface takes addresses of every family by a pointer to their common part.
sockaddr* general(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
}

Socket new_socket() {
  static const bool started = start_sockets();
  return Socket(started ? static_cast<Socket::Handle>(::socket(AF_INET, SOCK_STREAM, 0)) : -1);
}

}  // namespace

Socket::~Socket() {
  if (is_open()) close_socket(native(*this));
}

Connection::Connection(Socket socket) : socket_(std::move(socket)) {
  const char* const time =
      reinterpret_cast<const char*>(&patience);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
  ::setsockopt(native(socket_), SOL_SOCKET, SO_RCVTIMEO, time, sizeof patience);
  ::setsockopt(native(socket_), SOL_SOCKET, SO_SNDTIMEO, time, sizeof patience);
}

std::string Connection::receive() const {
  std::array<char, 4096> block{};
  for (;;) {
    const auto count = ::recv(native(socket_), block.data(), length_of(block.size()), 0);
    if (count > 0) return {block.data(), static_cast<std::size_t>(count)};
    if (count == 0 || !was_interrupted()) return {};
  }
}

void Connection::send(std::string_view text) const {
  while (!text.empty()) {
    const auto count = ::send(native(socket_), text.data(), length_of(text.size()), 0);
    if (count < 0 && was_interrupted()) continue;
    if (count <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

Listener::Listener() : socket_(new_socket()) {
  if (!socket_.is_open()) refuse("no socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  Size size = sizeof address;
  const bool listens = ::bind(native(socket_), general(address), size) == 0 && ::listen(native(socket_), 16) == 0 &&
                       ::getsockname(native(socket_), general(address), &size) == 0;
  if (!listens) refuse("no port to listen on");
  port_ = ntohs(address.sin_port);
}

Connection Listener::accept() const {
  for (;;) {
    Socket socket(static_cast<Socket::Handle>(::accept(native(socket_), nullptr, nullptr)));
    if (socket.is_open()) return Connection(std::move(socket));
    if (!was_interrupted() && !was_aborted()) refuse("no connection");
  }
}

}  // namespace graze::cli
