// SPDX-License-Identifier: MIT
#include "page_server.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace graze::cli {
namespace {

/// Longer than any browser's request for a page.
constexpr std::size_t longest_request = 65536;

/// The request up to the empty line; less if the client stops early or sends too much.
std::string read_request(const Connection& connection) {
  std::string request;
  while (request.find("\r\n\r\n") == std::string::npos && request.size() < longest_request) {
    const std::string received = connection.receive();
    if (received.empty()) break;
    request += received;
  }
  return request;
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

PageServer::PageServer(std::string page) : page_(std::move(page)) {}

std::string PageServer::address() const { return fmt::format("http://127.0.0.1:{}/", listener_.port()); }

void PageServer::serve() {
  for (;;) {
    const Connection connection = listener_.accept();
    const std::string request = read_request(connection);
    if (!request.empty()) connection.send(reply_to(request));  // browsers open connections in advance
  }
}

std::string PageServer::reply_to(const std::string& request) const {
  constexpr std::string_view text = "text/plain";
  const std::string_view host = host_of(request);
  if (host != fmt::format("127.0.0.1:{}", listener_.port()) && host != fmt::format("localhost:{}", listener_.port())) {
    return reply("403 Forbidden", text, "This page is shown at " + address() + " only.\n");
  }
  const std::string_view line = std::string_view(request).substr(0, request.find("\r\n"));
  if (line.substr(0, 4) != "GET ") return reply("405 Method Not Allowed", text, "Only GET is supported.\n");
  const std::string_view target = line.substr(4, line.substr(4).find_first_of(" ?"));
  if (target != "/") return reply("404 Not Found", text, "The only page is /\n");
  return reply("200 OK", "text/html", page_);
}

}  // namespace graze::cli
