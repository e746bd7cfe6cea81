// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string_view>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <graze/io/file/temporary_file.hpp>
#include <graze/io/file/utf8_path.hpp>

#include "system.hpp"

namespace graze::cli {
namespace {

/// The console's events: Ctrl+C, closing its window, the end of the session. Then the usual handler ends the program.
BOOL WINAPI end_by_event(DWORD) {
  io::remove_temporary_files();
  return FALSE;
}

HANDLE handle_of(Stream stream) {
  return GetStdHandle(stream == Stream::output ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

std::string utf8(const wchar_t* text) { return io::utf8_from_path(std::filesystem::path(text)); }

}  // namespace

bool is_terminal(Stream stream) {
  DWORD mode = 0;
  const HANDLE handle = handle_of(stream);
  return GetConsoleMode(handle, &mode) != 0 && SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::size_t terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  const bool known = GetConsoleScreenBufferInfo(handle_of(Stream::error), &info) != 0;
  const int columns = known ? info.srWindow.Right - info.srWindow.Left + 1 : 0;
  return columns > 0 ? static_cast<std::size_t>(columns) : std::size_t{80};
}

std::ptrdiff_t write_to_output(const char* bytes, std::size_t count) {
  constexpr std::size_t most = std::numeric_limits<int>::max();
  return _write(static_cast<int>(Stream::output), bytes, static_cast<unsigned>(std::min(count, most)));
}

void prepare_process() {
  _setmode(0, _O_BINARY);
  _setmode(static_cast<int>(Stream::output), _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
  SetConsoleCtrlHandler(end_by_event, TRUE);
}

std::vector<std::string> arguments_in_utf8(int count, const char* const* arguments) {
  int found = 0;
  wchar_t** const wide = CommandLineToArgvW(GetCommandLineW(), &found);
  if (wide == nullptr) return {arguments, arguments + count};
  std::vector<std::string> texts;
  for (int i = 0; i < found; ++i) texts.push_back(utf8(wide[i]));
  LocalFree(wide);
  return texts;
}

std::string environment(const char* name) {
  const std::string_view narrow(name);
  const wchar_t* const value = _wgetenv(std::wstring(narrow.begin(), narrow.end()).c_str());
  return value == nullptr ? std::string() : utf8(value);
}

std::filesystem::path program_path() {
  std::array<wchar_t, 32768> path{};  // the longest path on Windows
  const DWORD size = GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size()));
  return {path.data(), path.data() + size};
}

void die_of_closed_pipe() { std::_Exit(141); }  // as shells report SIGPIPE

}  // namespace graze::cli
