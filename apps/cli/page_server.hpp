// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "connection.hpp"

namespace graze::cli {

/// Serves one page to browsers on this machine: HTTP on 127.0.0.1, one request at a time. Answers only requests whose
/// host is this address, so that a foreign page cannot read the page by DNS rebinding.
class PageServer {
 public:
  /// Listens on a free port. Throws OutputError if the system refuses.
  explicit PageServer(std::string page);

  /// "http://127.0.0.1:41234/"
  std::string address() const;

  /// Answers requests until the process ends.
  [[noreturn]] void serve();

 private:
  std::string reply_to(const std::string& request) const;

  std::string page_;
  Listener listener_;
};

}  // namespace graze::cli
