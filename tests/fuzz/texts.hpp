// SPDX-License-Identifier: MIT
// The laws for everything that reads files, for any input.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <graze/io/input_error.hpp>
#include <graze/io/json_scene.hpp>
#include <graze/io/scene_file.hpp>
#include <graze/io/text/printable.hpp>

#include "fuzz/require.hpp"
#include "io/shape_bits.hpp"

namespace graze::test::fuzz {

/// The result of `read`; none if it rejects the input with an InputError that can be displayed. Any other exception is
/// a failure.
template <class Read>
auto read_or_refuse(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const io::InputError& error) {
    const std::string message = error.what();
    require(!message.empty() && io::printable(message) == message,
            [&](std::ostream& out) { out << "the message of a rejection must be displayable, but is: " << message; });
    return std::nullopt;
  }
}

/// The result of `read(text)` for a text that the library wrote, so it must be readable.
template <class Read>
auto read_again(const std::string& text, const Read& read) -> decltype(read(text)) {
  try {
    return read(text);
  } catch (const io::InputError& error) {
    require(false, [&](std::ostream& out) {
      out << "what was written must be readable, but " << error.what() << "\n" << text;
    });
    throw;
  }
}

inline std::string written(const io::SceneFile& file) {
  std::ostringstream out;
  io::write_json_scene(out, file);
  return out.str();
}

/// Whether a file preserves the shape bit for bit: polygons are rebuilt from their corners, which is exact for
/// coordinates of magnitude 1e-140 to 1e140.
template <Dim N>
bool comes_back(const AnyShape<N, double>& shape) {
  const auto is_in_range = [](const Vec<N, double>& corner) {
    for (Dim i = 0; i < N; ++i) {
      const double size = std::fabs(corner[i]);
      if (size != 0 && (size < 1e-140 || size > 1e140)) return false;
    }
    return true;
  };
  if (const auto* compound = std::get_if<Compound<N, double>>(&shape)) {
    return std::all_of(compound->parts.begin(), compound->parts.end(),
                       [](const Part<N, double>& part) { return comes_back<N>(part.shape); });
  }
  const auto* polygon = N == 2 ? std::get_if<Polytope<N, double>>(&shape) : nullptr;
  return polygon == nullptr || std::all_of(polygon->vertices().begin(), polygon->vertices().end(), is_in_range);
}

template <Dim N>
bool comes_back(const Scene<N, double>& scene) {
  const std::vector<ObjectId> ids = scene.ids();
  return std::all_of(ids.begin(), ids.end(), [&](const ObjectId& id) { return comes_back<N>(scene.object(id).shape); });
}

/// Whether two ids denote the same object of two scenes.
inline bool same_id(const ObjectId& a, const ObjectId& b) { return a.index == b.index && a.generation == b.generation; }

inline bool same_ids(const std::vector<ObjectId>& a, const std::vector<ObjectId>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_id);
}

/// Whether `b` equals `a` after a round trip through a file, which names objects without a name.
template <Dim N>
bool same_object(const Object<N, double>& a, const Object<N, double>& b) {
  return (a.name.empty() || a.name == b.name) && a.layer == b.layer && a.mask == b.mask && a.mobility == b.mobility &&
         a.user == b.user && io::bits_of<N>(a.shape) == io::bits_of<N>(b.shape) && a.box == b.box;
}

template <Dim N>
void require_same_scene(const Scene<N, double>& read, const Scene<N, double>& again, const std::string& text) {
  const auto say = [&text](std::string_view what) {
    return [&text, what](std::ostream& out) {
      out << what << " must be unchanged after writing and reading, except in\n" << text;
    };
  };
  require(same_ids(read.ids(), again.ids()) && same_ids(read.vacant_ids(), again.vacant_ids()), say("ids"));
  require(read.excepted_pairs().size() == again.excepted_pairs().size(), say("excepted pairs"));
  const std::vector<ObjectId> ids = read.ids();
  const std::vector<ObjectId> ids_again = again.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    require(same_object(read.object(ids[i]), again.object(ids_again[i])), say("objects"));
  }
}

inline bool same_velocity(const io::ObjectVelocity& a, const io::ObjectVelocity& b) {
  return same_id(a.id, b.id) && a.velocity == b.velocity;
}

/// A scene from a file of any format can be written in graze's own, is read back bit for bit, and is written
/// identically again.
inline void require_survival(const io::SceneFile& file) {
  for (const io::Omission& omission : file.omissions) {
    require(!omission.what.empty() && omission.count > 0,
            [](std::ostream& out) { out << "an omission must name what was omitted, and how often"; });
  }
  const std::string text = written(file);
  const io::SceneFile again = read_again(text, [](const std::string& of) { return io::parse_json_scene(of, "again"); });
  if (!std::visit([](const auto& scene) { return comes_back(scene); }, file.scene)) return;
  require(file.scene.index() == again.scene.index() && file.y_axis == again.y_axis, [&](std::ostream& out) {
    out << "dimension and axis must be unchanged after writing and reading, except in\n" << text;
  });
  std::visit(
      [&](const auto& scene) { require_same_scene(scene, std::get<std::decay_t<decltype(scene)>>(again.scene), text); },
      file.scene);
  require(std::equal(file.velocities.begin(), file.velocities.end(), again.velocities.begin(), again.velocities.end(),
                     same_velocity),
          [&](std::ostream& out) {
            out << "velocities must be unchanged after writing and reading, except in\n" << text;
          });
  require(written(again) == text, [&](std::ostream& out) {
    out << "what was read back must be written identically, except\n" << text;
  });
}

}  // namespace graze::test::fuzz
