// SPDX-License-Identifier: MIT
// Connections of TCP on this machine.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace graze::cli {

/// A socket, closed by the destructor.
class Socket {
 public:
  using Handle = std::intptr_t;  // POSIX: a file descriptor; Windows: a SOCKET

  explicit Socket(Handle handle) : handle_(handle) {}
  Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, none)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  Socket& operator=(Socket&&) = delete;
  ~Socket();

  bool is_open() const { return handle_ != none; }
  Handle handle() const { return handle_; }

 private:
  static constexpr Handle none = -1;

  Handle handle_;
};

/// A connection to a client. A client that sends nothing for five seconds counts as gone, so that others need not wait.
class Connection {
 public:
  explicit Connection(Socket socket);

  /// The next bytes; none if the client is gone.
  std::string receive() const;

  /// Ends early if the client is gone.
  void send(std::string_view text) const;

 private:
  Socket socket_;
};

/// Listens on a free port of 127.0.0.1.
class Listener {
 public:
  /// Throws OutputError if the system refuses.
  Listener();

  std::uint16_t port() const { return port_; }

  /// Waits for the next connection. Throws OutputError if the system refuses.
  Connection accept() const;

 private:
  Socket socket_;
  std::uint16_t port_ = 0;
};

}  // namespace graze::cli
