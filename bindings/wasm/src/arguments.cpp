// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/io/json/shape_fields.hpp>
#include <graze/math/platform/bit_cast.hpp>
#include <graze/math/pose.hpp>
#include <graze/query/bounds.hpp>
#include <graze/shape/fields/description.hpp>
#include <graze/shape/fields/visit.hpp>

#include "bridge.hpp"
#include "meshes.hpp"
#include "shape_text.hpp"

namespace graze::wasm {
namespace {

std::vector<double> argument_numbers;

using detail::FieldKind;

/// The content of a field, by the names of the methods in js/ that write and read it.
constexpr std::string_view kind_name(FieldKind kind) {
  switch (kind) {
    case FieldKind::length:
    case FieldKind::offset:
      return "number";
    case FieldKind::axes:
      return "axes";
    case FieldKind::hull:
    case FieldKind::vertices:
      return "points";
    case FieldKind::faces:
      return "faces";
    case FieldKind::mesh_kind:
      return "meshKind";
    case FieldKind::parts:
      return "parts";
    default:
      return "vector";
  }
}

struct Field {
  std::string_view name;
  std::string_view kind;
};

/// A set of fields that defines a shape of a type, and the function that creates it.
template <Dim N>
struct Form {
  std::string_view type;
  std::span<const Field> fields;
  AnyShape<N, double> (*read)(Arguments&);
};

template <Dim N>
void read(Arguments& in, Vec<N, double>& vector) {
  vector = in.vector<N>();
}

void read(Arguments& in, double& number) { number = in.number(); }

template <Dim N>
void read(Arguments& in, Mat<N, double>& axes) {
  for (Dim i = 0; i < N; ++i) axes[i] = in.vector<N>();
}

/// A cache of hulls: programs query the same polytopes repeatedly, and finding the vertices among the points takes
/// longer than most queries. The hash of the numbers selects the few entries to compare.
template <Dim N>
class KnownHulls {
 public:
  Polytope<N, double> of(std::span<const double> numbers) {
    if (numbers.size() > most_numbers) return hull_of(numbers);
    Known* const places = known_.data() + hash_of(numbers) % sets * places_in_set;
    for (std::size_t i = 0; i < places_in_set; ++i) {
      if (places[i].hull && has_bits_of(places[i], numbers)) return *places[i].hull;
    }
    Known& replaced = places[next_++ % places_in_set];
    replaced = {{numbers.begin(), numbers.end()}, hull_of(numbers)};
    return *replaced.hull;
  }

 private:
  /// Limits the total size to a few megabytes.
  static constexpr std::size_t most_numbers = 768;
  static constexpr std::size_t sets = 64;
  static constexpr std::size_t places_in_set = 4;

  struct Known {
    std::vector<double> numbers;
    std::optional<Polytope<N, double>> hull;
  };

  static Polytope<N, double> hull_of(std::span<const double> numbers) {
    std::vector<Vec<N, double>> points(numbers.size() / static_cast<std::size_t>(N));
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = vector_at<N>(numbers, i);
    return convex_hull_in_order<N, double>(points);
  }

  static std::uint64_t bits(double number) { return bit_cast<std::uint64_t>(number); }

  /// Bitwise, because 0 and -0 are different vertices; without memcmp, because Emscripten's compares bytes.
  static bool has_bits_of(const Known& known, std::span<const double> numbers) {
    return std::equal(known.numbers.begin(), known.numbers.end(), numbers.begin(), numbers.end(),
                      [](double a, double b) { return bits(a) == bits(b); });
  }

  /// One multiplication for each number, in four independent chains. Simple numbers differ in their upper bits, which
  /// multiplication does not carry down, so these are first added to the lower ones.
  static std::size_t hash_of(std::span<const double> numbers) {
    constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
    const auto mixed = [](std::uint64_t hash, double number) {
      return (hash ^ bits(number) ^ (bits(number) >> 32U)) * factor;
    };
    std::array<std::uint64_t, 4> rows = {1, 2, 3, 4};
    std::size_t i = 0;
    for (; i + rows.size() <= numbers.size(); i += rows.size()) {
      for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = mixed(rows[k], numbers[i + k]);
    }
    std::uint64_t hash = 0;
    for (; i < numbers.size(); ++i) hash = mixed(hash, numbers[i]);
    for (const std::uint64_t row : rows) hash = (hash ^ row ^ (row >> 32U)) * factor;
    return static_cast<std::size_t>(hash >> 32U);
  }

  std::array<Known, sets * places_in_set> known_;
  std::size_t next_ = 0;  ///< Counts replacements, which cycle through each set.
};

template <Dim N>
void read(Arguments& in, Polytope<N, double>& polytope) {
  static KnownHulls<N> known;
  const std::size_t points = in.count();
  if (points == 0) throw Refused("has no points");
  polytope = known.of(in.numbers(points * static_cast<std::size_t>(N)));
}

template <Dim N>
void read(Arguments& in, Compound<N, double>& compound) {
  compound = compound_of<N, double>(in.shapes<N>());
}

/// Vertices and faces, and perhaps the kind. The message about a vertex that does not exist is left to the library's
/// reader of text.
template <Dim N>
Mesh<N, double> read_mesh(Arguments& in, bool has_kind) {
  const std::size_t count = in.count();
  const std::span<const double> numbers = in.numbers(count * static_cast<std::size_t>(N));
  std::vector<Vec<N, double>> vertices(count);
  for (std::size_t i = 0; i < count; ++i) vertices[i] = vector_at<N>(numbers, i);
  std::vector<std::array<std::uint32_t, 3>> faces(in.count());
  for (std::array<std::uint32_t, 3>& face : faces) {
    for (std::uint32_t& vertex : face) {
      const std::size_t index = in.count();
      if (index >= count) throw Refused("has a face with a vertex that does not exist");
      vertex = static_cast<std::uint32_t>(index);
    }
  }
  const bool is_solid = has_kind && in.count() == static_cast<std::size_t>(MeshKind::solid);
  return mesh_of<N, double>(vertices, faces, is_solid ? MeshKind::solid : MeshKind::surface);
}

template <Dim N>
void read(Arguments& in, Mesh<N, double>& mesh) {
  mesh = read_mesh<N>(in, true);
}

template <template <Dim, class> class S, Dim N>
void read(Arguments& in, S<N, double>& shape) {
  detail::for_each_field(shape, [&in](const auto&, auto& value) { read(in, value); });
}

template <Dim N>
AnyShape<N, double> read_aabb_by_center(Arguments& in) {
  const auto center = in.vector<N>();
  return Aabb<N, double>::from_center(center, in.vector<N>());
}

template <Dim N>
AnyShape<N, double> read_upright_obb(Arguments& in) {
  const auto center = in.vector<N>();
  return Obb<N, double>{center, in.vector<N>()};
}

/// Rotated by an angle or a rotation, in degrees.
template <Dim N>
AnyShape<N, double> read_turned_obb(Arguments& in) {
  Obb<N, double> box = std::get<Obb<N, double>>(read_upright_obb<N>(in));
  if constexpr (N == 2) {
    box.axes = rotation_matrix(in.number());
  } else {
    const auto axis = in.vector<3>();
    if (max_abs(axis) == 0) throw Refused("is rotated about an axis of length zero");
    // Scaled first, so that no square over- or underflows.
    box.axes = rotation_matrix(axis / max_abs(axis), in.number());
  }
  return box;
}

template <Dim N>
AnyShape<N, double> read_mesh_without_kind(Arguments& in) {
  return read_mesh<N>(in, false);
}

template <Dim N>
AnyShape<N, double> read_held_mesh(Arguments& in) {
  return held_mesh<N>(static_cast<std::uint32_t>(in.number()));
}

constexpr std::array<Field, 1> held_fields = {{{"held", "held"}}};
constexpr std::array<Field, 2> mesh_fields = {{{"vertices", "points"}, {"faces", "faces"}}};
constexpr std::array<Field, 2> center_fields = {{{"center", "vector"}, {"half_extents", "vector"}}};
constexpr std::array<Field, 3> angle_fields = {{center_fields[0], center_fields[1], {"angle", "number"}}};
constexpr std::array<Field, 3> rotation_fields = {{center_fields[0], center_fields[1], {"rotation", "rotation"}}};

template <class S>
constexpr auto own_fields = detail::description_of<S>.apply([]<class... Fields>(const Fields&... own) {
  return std::array{Field{own.name, kind_name(Fields::kind)}...};
});

/// A shape in the library's representation.
template <Dim N, class S>
AnyShape<N, double> read_own(Arguments& in) {
  S shape;
  read(in, shape);
  return shape;
}

/// In the order of AnyShape.
template <Dim N>
constexpr auto own_forms = detail::table_of_shapes<N, double>([]<class S>(std::type_identity<S>) {
  return Form<N>{detail::description_of<S>.name, own_fields<S>, &read_own<N, S>};
});

/// The others, whose numbers follow.
template <Dim N>
constexpr std::array other_forms = {
    Form<N>{"aabb", center_fields, &read_aabb_by_center<N>}, Form<N>{"obb", center_fields, &read_upright_obb<N>},
    Form<N>{"obb", N == 2 ? std::span<const Field>(angle_fields) : rotation_fields, &read_turned_obb<N>},
    Form<N>{"mesh", mesh_fields, &read_mesh_without_kind<N>}, Form<N>{"mesh", held_fields, &read_held_mesh<N>}};

template <Dim N>
const Form<N>& form_at(std::size_t place) {
  return place < own_forms<N>.size() ? own_forms<N>[place] : other_forms<N>[place - own_forms<N>.size()];
}

template <Dim N>
std::string described_forms() {
  std::string text;
  for (std::size_t place = 0; place < own_forms<N>.size() + other_forms<N>.size(); ++place) {
    const Form<N>& form = form_at<N>(place);
    std::string fields;
    for (const auto& [name, kind] : form.fields) {
      fields += fmt::format(R"({}["{}", "{}"])", fields.empty() ? "" : ", ", name, kind);
    }
    text += fmt::format(R"({}{{"type": "{}", "fields": [{}]}})", text.empty() ? "" : ", ", form.type, fields);
  }
  return text;
}

/// The forms of both dimensions, each by its number, and the maximum nesting of compounds.
std::string shape_forms() {
  return fmt::format(R"({{"2": [{}], "3": [{}], "mostDepth": {}}})", described_forms<2>(), described_forms<3>(),
                     io::max_compound_depth);
}

void put_value(double number) { answer().push_back(number); }

template <Dim N>
void put_value(const Vec<N, double>& vector) {
  put<N>(vector);
}

template <Dim N>
void put_value(const Mat<N, double>& axes) {
  for (Dim i = 0; i < N; ++i) put<N>(axes[i]);
}

template <Dim N>
void put_value(std::span<const Vec<N, double>> points) {
  answer().push_back(static_cast<double>(points.size()));
  for (const Vec<N, double>& point : points) put<N>(point);
}

void put_value(std::span<const std::array<std::uint32_t, 3>> faces) {
  answer().push_back(static_cast<double>(faces.size()));
  for (const std::array<std::uint32_t, 3>& face : faces) answer().insert(answer().end(), face.begin(), face.end());
}

void put_value(MeshKind kind) { answer().push_back(static_cast<double>(kind)); }

template <Dim N>
void put_value(const Parts<N, double>& parts) {
  answer().push_back(static_cast<double>(parts.size()));
  for (const Part<N, double>& part : parts) put_shape<N>(part.shape);
}

/// Makes room for this many numbers of arguments and keeps those already written.
std::size_t argument_room(std::size_t count) {
  if (count > argument_numbers.size()) argument_numbers.resize(count);
  return reinterpret_cast<std::size_t>(argument_numbers.data());
}

/// The numbers of a shape given as text.
void spelled_shape(int dimension, std::string text, std::string role) {
  in_dimension(dimension, [&](auto n) { put_shape<n>(shape_of<n>(text, role.c_str())); });
}

/// The count and the numbers of a list of shapes.
void spelled_shapes(int dimension, std::string text) {
  in_dimension(dimension, [&](auto n) {
    const std::vector<AnyShape<n, double>> shapes = shapes_of<n>(text);
    answer().push_back(static_cast<double>(shapes.size()));
    for (const AnyShape<n, double>& shape : shapes) put_shape<n>(shape);
  });
}

}  // namespace

Arguments::Arguments(std::size_t place) : numbers_(argument_numbers), place_(place) {}

template <Dim N>
AnyShape<N, double> Arguments::shape() {
  AnyShape<N, double> shape = form_at<N>(count()).read(*this);
  if (const std::string_view flaw = defect(shape); !flaw.empty()) throw Refused(std::string(flaw));
  return shape;
}

template <Dim N>
Ray<N, double> Arguments::ray() {
  return std::get<Ray<N, double>>(shape<N>());
}

template <Dim N>
std::vector<AnyShape<N, double>> Arguments::shapes() {
  std::vector<AnyShape<N, double>> shapes;
  const std::size_t size = count();
  shapes.reserve(size);
  for (std::size_t i = 0; i < size; ++i) shapes.push_back(shape<N>());
  return shapes;
}

template <Dim N>
void put_shape(const AnyShape<N, double>& shape) {
  answer().push_back(static_cast<double>(shape.index()));
  detail::visit(
      [](const auto& held) { detail::for_each_field(held, [](const auto&, const auto& value) { put_value(value); }); },
      shape);
}

template AnyShape<2, double> Arguments::shape<2>();
template AnyShape<3, double> Arguments::shape<3>();
template Ray<2, double> Arguments::ray<2>();
template Ray<3, double> Arguments::ray<3>();
template std::vector<AnyShape<2, double>> Arguments::shapes<2>();
template std::vector<AnyShape<3, double>> Arguments::shapes<3>();
template void put_shape<2>(const AnyShape<2, double>&);
template void put_shape<3>(const AnyShape<3, double>&);

EMSCRIPTEN_BINDINGS(graze_arguments) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  function("shapeForms", &shape_forms);
  function("argumentRoom", &Guarded<&argument_room>::call);
  function("spelledShape", &Guarded<&spelled_shape>::call);
  function("spelledShapes", &Guarded<&spelled_shapes>::call);
}

}  // namespace graze::wasm
