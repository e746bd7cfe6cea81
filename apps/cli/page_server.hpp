// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace graze::cli {

/// Shows one page to browsers on this machine: HTTP on 127.0.0.1, one request after the other. Only requests that name
/// this address are answered, so that a page from elsewhere cannot read it by giving its own name this address.
class PageServer {
 public:
  /// Listens on a port that is free. Throws OutputError when the system refuses.
  explicit PageServer(std::string page);
  ~PageServer();

  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "http://127.0.0.1:41234/"
  std::string address() const;

  /// Answers requests until the process is ended.
  [[noreturn]] void serve();

 private:
  void answer(int connection) const;
  std::string reply_to(const std::string& request) const;

  std::string page_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace graze::cli
