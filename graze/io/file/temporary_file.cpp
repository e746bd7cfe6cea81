// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <graze/io/file/temporary_file.hpp>
#include <graze/io/file/utf8_path.hpp>

#ifdef _WIN32
#include <wchar.h>
#elif __has_include(<unistd.h>)
#include <unistd.h>
#else
#include <cstdio>
#endif

namespace graze::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporary_name_start = ".graze-";
constexpr std::string_view temporary_name_end = ".tmp";
constexpr std::size_t name_digits = 16;

/// The path of a file being written. Global and of fixed size, because a signal handler can access nothing else.
struct Slot {
  enum State : int { vacant, filling, filled };

  std::atomic<int> state = vacant;
  std::array<fs::path::value_type, 4096> path = {};
};

constexpr std::size_t slot_count = 16;
std::array<Slot, slot_count> slots;
static_assert(std::atomic<int>::is_always_lock_free);

/// Reserves a slot for a path. Returns slot_count if all are taken or the path is too long; then no handler removes the
/// file, but the next program that writes to the folder does.
std::size_t take_slot(const fs::path& path) {
  const fs::path::string_type& text = path.native();
  if (text.size() >= slots[0].path.size()) return slot_count;
  for (std::size_t i = 0; i < slot_count; ++i) {
    int expected = Slot::vacant;
    if (!slots[i].state.compare_exchange_strong(expected, Slot::filling)) continue;
    std::copy(text.begin(), text.end(), slots[i].path.begin());
    slots[i].path[text.size()] = fs::path::value_type{};
    slots[i].state = Slot::filled;
    return i;
  }
  return slot_count;
}

void release_slot(std::size_t slot) {
  if (slot < slot_count) slots[slot].state = Slot::vacant;
}

std::string random_name() {
  std::random_device random;
  return fmt::format("{}{:08x}{:08x}{}", temporary_name_start, random(), random(), temporary_name_end);
}

bool is_temporary_name(std::string_view name) {
  if (name.size() != temporary_name_start.size() + name_digits + temporary_name_end.size()) return false;
  const std::string_view digits = name.substr(temporary_name_start.size(), name_digits);
  return name.starts_with(temporary_name_start) && name.ends_with(temporary_name_end) &&
         digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Removes files left by programs that could not clean up. Files that cannot be read or removed stay.
void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (!is_temporary_name(utf8_from_path(entry->path().filename()))) continue;
    const OpenFileLock lock = OpenFileLock::of_existing(entry->path());
    std::error_code ignored;
    if (lock.is_held()) fs::remove(entry->path(), ignored);
  }
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& folder) : slot_(slot_count) {
  remove_leftovers(folder);
  // Retried if another program removed the new file as a leftover before it was locked. Files that cannot be locked are
  // written without a lock.
  constexpr int most_tries = 8;
  for (int tries = 0; tries < most_tries && !lock_.is_held(); ++tries) {
    release_slot(slot_);
    path_ = folder / random_name();
    slot_ = take_slot(path_);  // before the file exists, so that a signal in between is handled
    lock_ = OpenFileLock::of_new(path_);
    std::error_code error;
    if (!lock_.is_held() && fs::exists(path_, error)) break;
  }
  out_.open(path_, std::ios::binary);
}

TemporaryFile::~TemporaryFile() {
  out_.close();
  std::error_code ignored;
  fs::remove(path_, ignored);  // no effect if it was renamed
  release_slot(slot_);
}

void remove_temporary_files() noexcept {
  for (Slot& slot : slots) {
    if (slot.state != Slot::filled) continue;
#ifdef _WIN32
    _wunlink(slot.path.data());
#elif __has_include(<unistd.h>)
    unlink(slot.path.data());
#else
    std::remove(slot.path.data());
#endif
  }
}

}  // namespace graze::io
