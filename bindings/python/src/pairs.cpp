// SPDX-License-Identifier: MIT
// All overlapping pairs of many boxes, and exact tests of many pairs of shapes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/broad/contacts.hpp>
#include <graze/broad/pairs.hpp>
#include <graze/broad/touching/pair_tasks.hpp>
#include <graze/broad/touching_pairs.hpp>

#include "contact_columns.hpp"
#include "module.hpp"
#include "results.hpp"

namespace graze::python {
namespace {

/// The options of a call, and the executor behind them.
class PairArguments {
 public:
  PairArguments(const char* function, const py::object& margin, bool sorted, const std::string& method,
                const py::object& threads)
      : threads_(function, threads) {
    options_.margin = length_of({function, "margin"}, margin);
    options_.order = sorted ? PairOrder::sorted : PairOrder::any;
    const auto found = pair_method_named(method);
    if (!found) {
      std::string names;
      for (const PairMethod known : all_pair_methods())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", name_of(known));
      throw py::value_error(fmt::format("{}: method is '{}'; it is one of {}", function, method, names));
    }
    options_.method = *found;
    options_.executor = &threads_.executor();
  }

  const PairOptions& options() const { return options_; }

 private:
  Threads threads_;
  PairOptions options_;
};

World world_of_boxes(const Rows& boxes) { return {boxes.columns == 4 ? 2 : 3, boxes.is_double}; }

/// The second sequence, which must be of the world of the first.
Rows boxes_like(const char* function, const Rows& first, const py::object& second) {
  return rows_in({function, "boxes_b"}, second, first.columns, world_of_boxes(first), "boxes");
}

py::array overlapping_pairs_of(const py::object& boxes_a, const py::object& boxes_b, const py::object& margin,
                               bool sorted, const std::string& method, const py::object& threads) {
  const PairArguments arguments("overlapping_pairs", margin, sorted, method, threads);
  const Rows a = rows_of({"overlapping_pairs", "boxes"}, boxes_a, {4, 6});
  return in_world(world_of_boxes(a), [&]<Dim N, class T>(In<N, T>) {
    using Box = Aabb<N, T>;
    if (boxes_b.is_none()) {
      return array_of(without_gil([&] { return overlapping_pairs<N, T>(a.as<Box>(), arguments.options()); }));
    }
    const Rows b = boxes_like("overlapping_pairs", a, boxes_b);
    return array_of(
        without_gil([&] { return overlapping_pairs<N, T>(a.as<Box>(), b.as<Box>(), arguments.options()); }));
  });
}

/// A finder of any world; its calls from several threads take turns.
struct HeldFinder {
  InAnyWorld<PairFinder> any;
  std::unique_ptr<std::mutex> turn = std::make_unique<std::mutex>();
};

}  // namespace

template <>
struct BoxedName<HeldFinder> {
  static constexpr auto name = py::detail::const_name("PairFinder");
};

namespace {

World world_of_finder(const HeldFinder& finder) {
  return std::visit([]<Dim N, class T>(const PairFinder<N, T>&) { return In<N, T>::world; }, finder.any);
}

py::object new_finder(const py::object& dimension, const py::object& dtype) {
  return in_world(world_of_words("PairFinder", dimension, dtype),
                  []<Dim N, class T>(In<N, T>) { return boxed(HeldFinder{PairFinder<N, T>()}); });
}

py::array find_pairs(HeldFinder& finder, const py::object& boxes_a, const py::object& boxes_b, const py::object& margin,
                     bool sorted, const std::string& method, const py::object& threads) {
  const PairArguments arguments("PairFinder.find", margin, sorted, method, threads);
  const World world = world_of_finder(finder);
  const std::size_t columns = 2 * static_cast<std::size_t>(world.dimension);
  const Rows a = rows_in({"PairFinder.find", "boxes"}, boxes_a, columns, world, "the finder");
  Rows b;
  if (!boxes_b.is_none()) b = boxes_like("PairFinder.find", a, boxes_b);
  return std::visit(
      [&]<Dim N, class T>(PairFinder<N, T>& of_world) {
        using Box = Aabb<N, T>;
        return array_of(without_gil([&] {
          const std::scoped_lock lock(*finder.turn);
          const std::span<const Pair> found = boxes_b.is_none()
                                                  ? of_world.find(a.as<Box>(), arguments.options())
                                                  : of_world.find(a.as<Box>(), b.as<Box>(), arguments.options());
          return std::vector<Pair>(found.begin(), found.end());
        }));
      },
      finder.any);
}

// ---- Exact tests

/// ask(shapes, pairs, options) without the GIL, and its answer as Python has it.
template <class Ask>
py::object ask_candidates(const char* function, const py::object& shapes, const py::object& pairs,
                          const py::object& threads, const Ask& ask) {
  return in_world(world_of_shapes(function, shapes), [&]<Dim N, class T>(In<N, T> world) {
    const ShapeSequence<N, T> all(function, shapes);
    const PairRows candidates({function, "pairs"}, pairs);
    const Threads used(function, threads);
    return ask(world, all.any(), candidates.pairs(), TouchOptions{&used.executor()});
  });
}

py::object touching_pairs_of(const py::object& shapes, const py::object& pairs, const py::object& threads) {
  return ask_candidates("touching_pairs", shapes, pairs, threads,
                        []<Dim N, class T>(In<N, T>, auto all, auto candidates, TouchOptions options) -> py::object {
                          return array_of(without_gil([&] { return touching_pairs<N, T>(all, candidates, options); }));
                        });
}

py::object relations_of_pairs(const py::object& shapes, const py::object& pairs, const py::object& threads) {
  return ask_candidates("relations", shapes, pairs, threads,
                        []<Dim N, class T>(In<N, T>, auto all, auto candidates, TouchOptions options) -> py::object {
                          auto numbers = without_gil([&] {
                            const auto found = relations<N, T>(all, candidates, options);
                            std::vector<std::uint8_t> result(found.size());
                            for (std::size_t i = 0; i < found.size(); ++i)
                              result[i] = static_cast<std::uint8_t>(found[i]);
                            return result;
                          });
                          return array_of<std::uint8_t>(std::move(numbers), 0);
                        });
}

/// Asks for some candidates at a time, so that their contacts are still in the cache when they are copied.
template <Dim N, class T>
ContactColumns<N, T, Pair> contact_columns(std::span<const AnyShape<N, T>> shapes, std::span<const Pair> candidates,
                                           TouchOptions options) {
  constexpr std::size_t candidates_at_a_time = 8192;
  detail::check_pairs(candidates, shapes.size(), "contacts");  // here, because a part would count from its own first
  ContactColumns<N, T, Pair> columns;
  for (std::size_t first = 0; first < candidates.size(); first += candidates_at_a_time) {
    const std::size_t count = std::min(candidates_at_a_time, candidates.size() - first);
    for (const auto& found : contacts<N, T>(shapes, candidates.subspan(first, count), options)) {
      columns.add(found.pair, found.manifold);
    }
  }
  return columns;
}

py::object contacts_of_pairs(const py::object& shapes, const py::object& pairs, const py::object& threads) {
  return ask_candidates("contacts", shapes, pairs, threads,
                        []<Dim N, class T>(In<N, T>, auto all, auto candidates, TouchOptions options) -> py::object {
                          return without_gil([&] { return contact_columns<N, T>(all, candidates, options); })
                              .template to_python<std::uint32_t>();
                        });
}

}  // namespace

void add_pairs(py::module_& module) {
  const py::arg boxes("boxes");
  const py::arg_v boxes_b("boxes_b", py::none(), "None");
  const py::arg_v margin("margin", 0.0);
  const py::arg_v sorted("sorted", true);
  const py::arg_v method("method", "automatic");
  const py::arg_v threads("threads", py::none(), "None");
  module.def("overlapping_pairs", &overlapping_pairs_of, boxes, boxes_b, py::kw_only(), margin, sorted, method, threads,
             "All pairs of boxes that share a point, (n, 2) of uint32, a < b. boxes: (n, 2 * N) of float32 or float64, "
             "minima, then maxima. With boxes_b: pairs of a box of each.");
  const py::arg shapes("shapes");
  const py::arg pairs("pairs");
  module.def("touching_pairs", &touching_pairs_of, shapes, pairs, py::kw_only(), threads,
             "Those of the pairs (n, 2) whose shapes intersect, in their order.");
  module.def("relations", &relations_of_pairs, shapes, pairs, py::kw_only(), threads,
             "For each pair 0 (apart), 1 (touching) or 2 (overlapping): (n,) of uint8.");
  module.def("contacts", &contacts_of_pairs, shapes, pairs, py::kw_only(), threads,
             "The contact points of the pairs (n, 2) whose shapes intersect: Contacts.");
  TypeMaker finder = TypeMaker::of<HeldFinder>(module, "graze.PairFinder",
                                               "PairFinder(dimension=3, dtype=numpy.float64)\n--\n\noverlapping_pairs "
                                               "for boxes that move: faster from the second "
                                               "call on.");
  finder.constructor(&new_finder, py::arg("dimension") = 3, py::arg("dtype") = py::none());
  finder.method("find", &find_pairs, boxes, boxes_b, py::kw_only(), margin, sorted, method, threads,
                "As overlapping_pairs, of arrays of the finder's dimension and dtype.");
  finder.finish();
}

}  // namespace graze::python
