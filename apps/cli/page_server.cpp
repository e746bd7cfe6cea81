// SPDX-License-Identifier: MIT
#include "page_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <utility>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <graze/io/output_error.hpp>

namespace graze::cli {
namespace {

/// Longer than any browser's request for a page.
constexpr std::size_t longest_request = 65536;

/// Clients that send nothing for this long are dropped, so that others need not wait.
constexpr timeval patience{.tv_sec = 5, .tv_usec = 0};

[[noreturn]] void refuse(std::string_view what) {
  throw io::OutputError(fmt::format("a page cannot be served on 127.0.0.1: {}: {}", what, std::strerror(errno)));
}

/// The socket interface takes addresses of every family by a pointer to their common part.
sockaddr* general(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
}

/// The request up to the empty line; less if the client stops early or sends too much.
std::string read_request(int connection) {
  std::string request;
  std::array<char, 4096> block{};
  while (request.find("\r\n\r\n") == std::string::npos && request.size() < longest_request) {
    const ssize_t count = ::recv(connection, block.data(), block.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    request.append(block.data(), static_cast<std::size_t>(count));
  }
  return request;
}

void send_all(int connection, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::send(connection, text.data(), text.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;  // the client has closed the connection
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string reply(std::string_view status, std::string_view type, std::string_view body) {
  return fmt::format(
      "HTTP/1.1 {}\r\nContent-Type: {}; charset=utf-8\r\nContent-Length: {}\r\nCache-Control: no-store\r\n"
      "X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n{}",
      status, type, body.size(), body);
}

/// The value of the header "Host"; HTTP header names are case-insensitive.
std::string_view host_of(std::string_view request) {
  constexpr std::string_view name = "\r\nhost:";
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b; };
  const auto* const found = std::search(request.begin(), request.end(), name.begin(), name.end(), same);
  if (found == request.end()) return {};
  std::string_view value = request.substr(static_cast<std::size_t>(found - request.begin()) + name.size());
  value = value.substr(0, value.find("\r\n"));
  value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size()));
  return value.substr(0, value.find_last_not_of(" \t") + 1);
}

}  // namespace

PageServer::PageServer(std::string page)
    : page_(std::move(page)), listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (listener_ < 0) refuse("no socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool listens = ::bind(listener_, general(address), size) == 0 && ::listen(listener_, 16) == 0 &&
                       ::getsockname(listener_, general(address), &size) == 0;
  if (!listens) {
    const int error = errno;
    ::close(listener_);
    errno = error;
    refuse("no port to listen on");
  }
  port_ = ntohs(address.sin_port);
}

PageServer::~PageServer() { ::close(listener_); }

std::string PageServer::address() const { return fmt::format("http://127.0.0.1:{}/", port_); }

void PageServer::serve() {
  for (;;) {
    const int connection = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection >= 0) {
      answer(connection);
      ::close(connection);
    } else if (errno != EINTR && errno != ECONNABORTED) {
      refuse("no connection");
    }
  }
}

void PageServer::answer(int connection) const {
  ::setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(connection, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  const std::string request = read_request(connection);
  if (request.empty()) return;  // browsers open connections in advance
  send_all(connection, reply_to(request));
}

std::string PageServer::reply_to(const std::string& request) const {
  constexpr std::string_view text = "text/plain";
  const std::string_view host = host_of(request);
  if (host != fmt::format("127.0.0.1:{}", port_) && host != fmt::format("localhost:{}", port_)) {
    return reply("403 Forbidden", text, "This page is shown at " + address() + " only.\n");
  }
  const std::string_view line = std::string_view(request).substr(0, request.find("\r\n"));
  if (line.substr(0, 4) != "GET ") return reply("405 Method Not Allowed", text, "Only GET is supported.\n");
  const std::string_view target = line.substr(4, line.substr(4).find_first_of(" ?"));
  if (target != "/") return reply("404 Not Found", text, "The only page is /\n");
  return reply("200 OK", "text/html", page_);
}

}  // namespace graze::cli
