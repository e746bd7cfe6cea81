// SPDX-License-Identifier: MIT
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include <graze/io/file/temporary_file.hpp>

#include "system.hpp"

namespace graze::cli {
namespace {

/// Removes incomplete files and lets the signal end the program as usual.
extern "C" void end_by_signal(int signal) {
  io::remove_temporary_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Ignored signals, as under nohup, stay ignored.
void clean_up_on_signals() {
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
    action.sa_handler = end_by_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
    sigaction(number, &action, nullptr);
  }
}

void claim_standard_streams() {
  // Opened in the wrong direction: reading from the input and writing to the others must fail, as on closed streams.
  constexpr std::array<int, 3> modes{O_WRONLY, O_RDONLY, O_RDONLY};
  for (int number = 0; number < 3; ++number) {
    const bool closed = fcntl(number, F_GETFD) == -1 && errno == EBADF;
    if (closed && open("/dev/null", modes[static_cast<std::size_t>(number)]) != number) return;
  }
}

}  // namespace

bool is_terminal(Stream stream) { return isatty(static_cast<int>(stream)) == 1; }

std::size_t terminal_columns() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : std::size_t{80};
}

std::ptrdiff_t write_to_output(const char* bytes, std::size_t count) { return ::write(STDOUT_FILENO, bytes, count); }

void prepare_process() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  clean_up_on_signals();
  claim_standard_streams();
}

std::vector<std::string> arguments_in_utf8(int count, const char* const* arguments) {
  return {arguments, arguments + count};
}

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

std::filesystem::path program_path() {
#ifdef __APPLE__
  std::array<char, 4096> path{};
  std::uint32_t size = path.size();
  return _NSGetExecutablePath(path.data(), &size) == 0 ? std::filesystem::path(path.data()) : std::filesystem::path();
#else
  std::error_code error;
  std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : program;
#endif
}

void die_of_closed_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  std::_Exit(128 + SIGPIPE);
}

}  // namespace graze::cli
