// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <graze/broad/index/key_table.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/json/ids.hpp>

namespace graze::io {
namespace {

constexpr std::uint64_t largest_id = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t last_generation = detail::KeyTable::used_up - 1;  // the last generation of an object

/// [index, generation]; `last_bit` is 1 for generations of objects, 0 for those of vacant ids.
ObjectId read_id(JsonValue value, std::string_view name, unsigned last_bit, const JsonPlace& place) {
  const JsonValue array = read_array(value, {name}, place);
  std::uint64_t numbers[2] = {};
  std::size_t count = 0;
  for (const JsonValue number : array.items()) {
    if (count < 2) numbers[count] = read_whole(number, {name, count}, place);
    ++count;
  }
  if (count != 2) throw place.error(value.offset(), fmt::format("\"{}\" has {} numbers; an id has two", name, count));
  if (numbers[0] > largest_id || numbers[1] > largest_id) {
    throw place.error(value.offset(), fmt::format("\"{}\" has a number above {}", name, largest_id));
  }
  if ((numbers[1] & 1U) != last_bit) {
    throw place.error(value.offset(), fmt::format("\"{}\" has the generation {}; that of {}", name, numbers[1],
                                                  last_bit == 1 ? "an object is odd" : "a vacant id is even"));
  }
  if (last_bit == 1 && numbers[1] > last_generation) {
    throw place.error(value.offset(), fmt::format("\"{}\" has the generation {}; the last of an object is {}", name,
                                                  numbers[1], last_generation));
  }
  return {static_cast<std::uint32_t>(numbers[0]), static_cast<std::uint32_t>(numbers[1]), 0};
}

/// Checks that the indexes are 0, 1, ..., each once.
class Indexes {
 public:
  explicit Indexes(std::size_t count) : is_taken_(count, false) {}

  void take(const ObjectId& id, JsonValue value, const JsonPlace& place) {
    if (id.index >= is_taken_.size()) {
      throw place.error(value.offset(), fmt::format("the index {} is too high; objects and vacant ids are {} together",
                                                    id.index, is_taken_.size()));
    }
    if (is_taken_[id.index]) {
      throw place.error(value.offset(), fmt::format("the index {} appears twice; ids must be unique", id.index));
    }
    is_taken_[id.index] = true;
  }

 private:
  std::vector<bool> is_taken_;
};

std::optional<JsonValue> id_of(JsonValue object) {
  return object.kind() == JsonKind::object ? object.find("id") : std::nullopt;
}

}  // namespace

SavedIds read_saved_ids(const JsonFields& scene) {
  const JsonPlace& document = scene.place();
  const auto vacant = scene.find("vacant_ids");
  std::size_t places = 0;
  std::size_t with_ids = 0;
  for (const JsonValue object : scene.array("objects").items()) {
    ++places;
    if (id_of(object)) ++with_ids;
  }
  SavedIds ids;
  if (!vacant && with_ids == 0) return ids;
  if (vacant) {
    for ([[maybe_unused]] const JsonValue id : read_array(*vacant, {"vacant_ids"}, document).items()) ++places;
  }
  Indexes indexes(places);
  std::size_t index = 0;
  for (const JsonValue object : scene.array("objects").items()) {
    const JsonPlace place{document.document, nullptr, "object", index++};
    const auto id = id_of(object);
    if (!id) throw place.error(object.offset(), "there is no \"id\"; in a scene with saved ids every object has one");
    ids.next.push_back(read_id(*id, "id", 1, place));
    indexes.take(ids.next.back(), *id, place);
  }
  if (!vacant) return ids;
  for (const JsonValue id : vacant->items()) {
    ids.vacant.push_back(read_id(id, "vacant_ids", 0, document));
    indexes.take(ids.vacant.back(), id, document);
  }
  return ids;
}

}  // namespace graze::io
