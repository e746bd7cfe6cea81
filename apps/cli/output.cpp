// SPDX-License-Identifier: MIT
#include "output.hpp"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <functional>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include <graze/io/file/atomic_file.hpp>
#include <graze/io/file/utf8_path.hpp>
#include <graze/io/output_error.hpp>

#include "system.hpp"
#include "usage.hpp"

namespace graze::cli {
namespace {

/// A buffer for the standard output that, unlike the standard library's, reports why a write failed.
class StandardOutput final : public std::streambuf {
 public:
  StandardOutput() { make_room(); }

 protected:
  int_type overflow(int_type character) override {
    write_out();
    if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
    return sputc(traits_type::to_char_type(character));
  }

  int sync() override {
    write_out();
    return 0;
  }

 private:
  void make_room() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

  void write_out() {
    const char* next = pbase();
    const char* const end = pptr();
    make_room();  // before a possible failure: bytes that could not be written are not written again
    while (next != end) {
      const std::ptrdiff_t count = write_to_output(next, static_cast<std::size_t>(end - next));
      if (count >= 0) {
        next += count;
      } else if (errno == EPIPE) {
        throw ClosedPipe{};
      } else if (errno != EINTR) {
        throw io::OutputError(fmt::format("the standard output cannot be written: {}", std::strerror(errno)));
      }
    }
  }

  std::array<char, 65536> buffer_{};
};

}  // namespace

bool is_standard_stream(const std::string& name) { return name == "-"; }

bool name_same_file(const std::string& a, const std::string& b) {
  if (is_standard_stream(a) || is_standard_stream(b)) return a == b;
  const std::filesystem::path path_a = io::path_from_utf8(a);
  const std::filesystem::path path_b = io::path_from_utf8(b);
  std::error_code error;
  if (std::filesystem::equivalent(path_a, path_b, error)) return true;
  return std::filesystem::absolute(path_a, error).lexically_normal() ==
         std::filesystem::absolute(path_b, error).lexically_normal();
}

void require_not_overwritten(const std::string& scene, const std::string& output) {
  if (is_standard_stream(output) || !name_same_file(output, scene)) return;
  throw UsageError("the scene " + io::in_quotes(output) + " would be overwritten; name another file to write to");
}

void write_output(const std::string& target, const std::function<void(std::ostream&)>& write) {
  if (!is_standard_stream(target)) {
    io::write_atomically(io::path_from_utf8(target), write);
    return;
  }
  StandardOutput buffer;
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit);  // makes the stream pass on the exceptions of its buffer
  write(out);
  out.flush();
}

}  // namespace graze::cli
