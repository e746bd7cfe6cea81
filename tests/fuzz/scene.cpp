// SPDX-License-Identifier: MIT
// A Scene with any calls, compared with PlainScene: the same answers and the same rejections.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

#include <graze/math/vec.hpp>
#include <graze/scene/plain_scene.hpp>
#include <graze/scene/scene.hpp>

#include "fuzz/require.hpp"
#include "fuzz/shapes.hpp"

using namespace graze;
constexpr Dim N = GRAZE_FUZZ_DIMENSION;
using T = GRAZE_FUZZ_SCALAR;

namespace {

constexpr std::size_t most_calls = 80;

/// Ids of two scenes are equal except for their owner.
bool same(const ObjectId& a, const ObjectId& b) { return a.index == b.index && a.generation == b.generation; }
bool same(const ObjectPair& a, const ObjectPair& b) { return same(a.a, b.a) && same(a.b, b.b); }
bool same(const NearObject<T>& a, const NearObject<T>& b) { return same(a.id, b.id) && a.distance == b.distance; }
bool same(const ObjectHit<N, T>& a, const ObjectHit<N, T>& b) { return same(a.id, b.id) && a.hit == b.hit; }
bool same(const ObjectContact<N, T>& a, const ObjectContact<N, T>& b) {
  return same(a.pair, b.pair) && a.manifold == b.manifold;
}
template <class Item>
bool same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Item& x, const Item& y) { return same(x, y); });
}
template <class Item>
bool same(const std::optional<Item>& a, const std::optional<Item>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
bool same(const SceneEvents& a, const SceneEvents& b) {
  return same(a.began, b.began) && same(a.stayed, b.stayed) && same(a.ended, b.ended);
}

/// An answer, or the type of the exception.
template <class Result>
struct Outcome {
  std::optional<Result> result;
  const std::type_info* thrown = nullptr;
};

template <class Call>
auto outcome_of(const Call& call) {
  Outcome<decltype(call())> outcome;
  try {
    outcome.result = call();
  } catch (const std::exception& error) {
    outcome.thrown = &typeid(error);
  }
  return outcome;
}

/// Both scenes, with the same calls.
class Both {
 public:
  explicit Both(test::fuzz::Input& input) : input_(input) {}

  void call() {
    static constexpr std::array<void (Both::*)(), 14> calls = {&Both::add,        &Both::add,
                                                               &Both::add,        &Both::move,
                                                               &Both::move,       &Both::move_many,
                                                               &Both::move_boxes, &Both::remove,
                                                               &Both::update,     &Both::update,
                                                               &Both::ask_scene,  &Both::ask_scene,
                                                               &Both::snapshot,   &Both::go_on_with_a_copy};
    (this->*calls[input_.below(calls.size())])();
  }

  void update() {
    compare(
        "update", [&] { return scene_.update(serial_executor()); }, [&] { return judge_.update(); });
  }

 private:
  struct Held {
    ObjectId id;
    ObjectId judged;
  };

  template <class Ask, class Judge>
  void compare(std::string_view what, const Ask& ask, const Judge& judge) const {
    const auto found = outcome_of(ask);
    const auto expected = outcome_of(judge);
    const bool is_right = found.thrown == nullptr ? expected.thrown == nullptr && same(*found.result, *expected.result)
                                                  : expected.thrown != nullptr && *found.thrown == *expected.thrown;
    test::fuzz::require(is_right, [&](std::ostream& out) {
      out << what << (found.thrown != nullptr ? " throws" : " answers") << ", where PlainScene "
          << (expected.thrown != nullptr ? "throws" : "answers") << ", or something else";
    });
  }

  AnyShape<N, T> shape() { return test::fuzz::any_shape<N, T>(input_); }

  /// One of all ids ever issued, including removed objects; the default id if there was none.
  Held pick() { return ever_held_.empty() ? Held{} : ever_held_[input_.below(ever_held_.size())]; }

  LayerMask layers() { return input_.below(4) == 0 ? only_layer(static_cast<Layer>(input_.below(3))) : all_layers; }

  void add() {
    ObjectOptions options;
    const std::size_t kind = input_.below(32);
    options.layer = static_cast<Layer>(kind % 3);
    if (kind == 31) options.layer = max_layers;
    if (kind % 5 == 4) options.mask = only_layer(static_cast<Layer>(input_.below(3)));
    if (kind % 7 == 6) options.mobility = Mobility::fixed;
    if (kind % 11 == 10) options.name = std::string(1, static_cast<char>('a' + input_.below(4)));
    const AnyShape<N, T> what = shape();
    Held held;
    compare(
        "add", [&] { return held.id = scene_.add(what, options); },
        [&] { return held.judged = judge_.add(what, options); });
    if (held.id != ObjectId{}) ever_held_.push_back(held);
  }

  void move() {
    const Held held = pick();
    const AnyShape<N, T> to = shape();
    compare(
        "move",
        [&] {
          scene_.move(held.id, to);
          return held.id;
        },
        [&] {
          judge_.move(held.judged, to);
          return held.judged;
        });
  }

  void move_many() {
    std::vector<ObjectMove<N, T>> moves;
    std::vector<ObjectMove<N, T>> judged;
    for (std::size_t count = input_.below(6); count > 0; --count) {
      const Held held = pick();
      moves.push_back({held.id, shape()});
      judged.push_back({held.judged, moves.back().shape});
    }
    move_all(
        "move of many", [&] { scene_.move(moves); }, judged);
  }

  void move_boxes() {
    std::vector<ObjectId> ids;
    std::vector<Aabb<N, T>> boxes;
    std::vector<ObjectMove<N, T>> judged;
    for (std::size_t count = input_.below(24); count > 0; --count) {
      const Held held = pick();
      ids.push_back(held.id);
      test::fuzz::fill(input_, boxes.emplace_back());
      judged.push_back({held.judged, boxes.back()});
    }
    move_all(
        "move of boxes", [&] { scene_.move(ids, boxes); }, judged);
  }

  template <class Move>
  void move_all(std::string_view what, const Move& move, const std::vector<ObjectMove<N, T>>& judged) {
    compare(
        what,
        [&] {
          move();
          return ObjectId{};
        },
        [&] {
          judge_.move(judged);
          return ObjectId{};
        });
  }

  void remove() {
    const Held held = pick();
    compare(
        "remove",
        [&] {
          scene_.remove(held.id);
          return held.id;
        },
        [&] {
          judge_.remove(held.judged);
          return held.judged;
        });
  }

  void ask_scene() { ask(scene_); }

  void snapshot() {
    const auto snapshot = scene_.snapshot();
    ask(*snapshot);
  }

  void ask(const SceneView<N, T>& view) {
    const LayerMask on = layers();
    const std::size_t kind = input_.below(7);
    if (kind == 0) {
      const AnyShape<N, T> region = shape();
      compare(
          "overlapping", [&] { return view.overlapping(region, on); }, [&] { return judge_.overlapping(region, on); });
    } else if (kind == 1) {
      const AnyShape<N, T> region = shape();
      compare(
          "cull", [&] { return view.cull(region, on); }, [&] { return judge_.cull(region, on); });
    } else if (kind == 2) {
      const Vec<N, T> point = input_.vec<N, T>();
      const std::size_t count = input_.below(9);
      compare(
          "nearest", [&] { return view.nearest(point, count, on); }, [&] { return judge_.nearest(point, count, on); });
    } else if (kind == 3) {
      Ray<N, T> ray;
      test::fuzz::fill(input_, ray);
      const T t_max = input_.below(2) == 0 ? std::numeric_limits<T>::infinity() : input_.number<T>();
      compare(
          "ray_cast_all", [&] { return view.ray_cast_all(ray, t_max, on); },
          [&] { return judge_.ray_cast_all(ray, t_max, on); });
      compare(
          "ray_cast", [&] { return view.ray_cast(ray, t_max, on); }, [&] { return judge_.ray_cast(ray, t_max, on); });
    } else if (kind == 4) {
      const double margin = input_.number<double>();
      compare(
          "candidates", [&] { return view.candidates(margin); }, [&] { return judge_.candidates(margin); });
    } else if (kind == 5) {
      compare(
          "contacts", [&] { return view.contacts(serial_executor()); }, [&] { return judge_.contacts(); });
    } else {
      compare(
          "pairs", [&] { return view.pairs(); }, [&] { return judge_.pairs(); });
    }
  }

  void go_on_with_a_copy() {
    Scene<N, T> copy = scene_;
    scene_ = std::move(copy);
  }

  test::fuzz::Input& input_;
  Scene<N, T> scene_;
  PlainScene<N, T> judge_;
  std::vector<Held> ever_held_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::fuzz::Input input(data, size);
  Both both(input);
  for (std::size_t calls = 0; calls < most_calls && !input.is_empty(); ++calls) both.call();
  both.update();
  return 0;
}
