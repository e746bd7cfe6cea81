// SPDX-License-Identifier: MIT
// description_of<S>: the names and meanings of a shape's fields, declared once, in the shape's own header. Ordering,
// NaN checks, validation, conversion between number types, scaling, scene files and the WebAssembly bridge derive from
// it.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <graze/math/vec.hpp>

namespace graze::detail {

enum class FieldKind {
  point,         ///< A position that moves with the shape.
  direction,     ///< A vector of any nonzero length.
  length,        ///< A non-negative number.
  half_extents,  ///< A vector of non-negative numbers.
  offset,        ///< A number: the position of a plane along its `normal`, a `direction`.
  axes,          ///< A matrix whose columns are orthonormal.
  corners,       ///< An array of points.
  hull,          ///< The corners of a convex hull, of any number. Read-only: `convex_hull` creates it.
  parts,         ///< A vector of `Part`s.
  vertices,      ///< Points, of any number. Read-only, as the next two: `mesh_of` makes all three.
  faces,         ///< Three indices of vertices each.
  mesh_kind,     ///< A `MeshKind`.
};

/// Whether a field is the result of a function, so that the shape is not made from it in place.
constexpr bool is_read_only(FieldKind kind) {
  return kind == FieldKind::hull || kind == FieldKind::vertices || kind == FieldKind::faces ||
         kind == FieldKind::mesh_kind;
}

/// A short text that is concatenated at compile time.
class ShortText {
 public:
  constexpr ShortText(std::initializer_list<std::string_view> pieces) {
    for (const std::string_view piece : pieces) {
      for (const char letter : piece) letters_[size_++] = letter;  // too many letters fail to compile
    }
  }
  constexpr std::string_view view() const { return {letters_.data(), size_}; }

 private:
  std::array<char, 64> letters_{};
  std::size_t size_ = 0;
};

constexpr std::string_view article_of(std::string_view noun) {
  return std::string_view("aeiou").find(noun.front()) == std::string_view::npos ? "a " : "an ";
}

/// "a sphere", "an aabb"
inline std::string with_article(std::string_view noun) { return std::string(article_of(noun)) += noun; }

/// The member of a shape that is its own single field, such as a point.
struct Itself {};

/// A field: its name in scene files and how to access it in a shape.
template <FieldKind kind_of_field, class Member>
class Field {
 public:
  static constexpr FieldKind kind = kind_of_field;

  /// `noun` is how messages name the field, or each of its elements.
  constexpr Field(std::string_view field_name, Member member, std::string_view noun)
      : name(field_name), not_finite(flaw_of(noun)), refused(refusal_of(noun)), member_(member) {}

  /// The field's value in a shape, by reference if it is a member, not a function.
  template <class S>
  constexpr decltype(auto) in(S& shape) const {
    if constexpr (std::is_same_v<Member, Itself>) {
      return (shape);
    } else if constexpr (std::is_member_function_pointer_v<Member>) {
      return (shape.*member_)();
    } else {
      return (shape.*member_);
    }
  }

  std::string_view name;
  ShortText not_finite;  ///< The message for a number that is not finite.
  ShortText refused;     ///< The message for finite numbers that are invalid for this kind.

 private:
  static constexpr bool is_plural = kind == FieldKind::half_extents || kind == FieldKind::axes;

  static constexpr ShortText flaw_of(std::string_view noun) {
    if (is_plural) return {"has ", noun, " that are not finite"};
    return {"has ", article_of(noun), noun, " that is not finite"};
  }
  static constexpr ShortText refusal_of(std::string_view noun) {
    switch (kind) {
      case FieldKind::direction:
        return {"has ", article_of(noun), noun, " of length zero"};
      case FieldKind::length:
        return {"has a negative ", noun};
      case FieldKind::half_extents:
        return {"has a negative half extent"};
      case FieldKind::axes:
        return {"has ", noun, " that are not orthonormal (unit length, at right angles)"};
      case FieldKind::parts:
        return {"has a part that is not valid"};
      default:
        return {};
    }
  }

  Member member_;
};

/// Makes fields of one kind.
template <FieldKind kind>
struct FieldOf {
  template <class Member>
  constexpr Field<kind, Member> operator()(std::string_view name, Member member, std::string_view noun = {}) const {
    return {name, member, noun.empty() ? name : noun};
  }
};

/// `field::point("center", &Sphere<N, T>::center)`
namespace field {
inline constexpr FieldOf<FieldKind::point> point;
inline constexpr FieldOf<FieldKind::direction> direction;
inline constexpr FieldOf<FieldKind::length> length;
inline constexpr FieldOf<FieldKind::half_extents> half_extents;
inline constexpr FieldOf<FieldKind::offset> offset;
inline constexpr FieldOf<FieldKind::axes> axes;
inline constexpr FieldOf<FieldKind::corners> corners;
inline constexpr FieldOf<FieldKind::hull> hull;
inline constexpr FieldOf<FieldKind::parts> parts;
inline constexpr FieldOf<FieldKind::vertices> vertices;
inline constexpr FieldOf<FieldKind::faces> faces;
inline constexpr FieldOf<FieldKind::mesh_kind> mesh_kind;
}  // namespace field

// ---- A minimal tuple: std::tuple would take longer to compile than everything built on this list.

template <std::size_t place, class Field>
struct FieldAt {
  Field field;
};

template <class Places, class... Fields>
struct FieldList;
template <std::size_t... places, class... Fields>
struct FieldList<std::index_sequence<places...>, Fields...> : FieldAt<places, Fields>... {
  constexpr explicit FieldList(const Fields&... fields) : FieldAt<places, Fields>{fields}... {}

  /// Returns use(fields...).
  template <class Use>
  constexpr decltype(auto) apply(const Use& use) const {
    return use(static_cast<const FieldAt<places, Fields>*>(this)->field...);
  }
};

/// The type name of a shape in scene files and reports, and its fields in the order of aggregate initialization. The
/// name is empty if the type is not an alternative of AnyShape.
template <class... Fields>
struct Description : FieldList<std::index_sequence_for<Fields...>, Fields...> {
  constexpr explicit Description(std::string_view name_of_type, const Fields&... fields)
      : FieldList<std::index_sequence_for<Fields...>, Fields...>(fields...), name(name_of_type) {}

  std::string_view name;
};

/// For types without a description: user-defined shapes.
struct NoDescription {};

/// Each shape specialises this after its definition.
template <class S>
inline constexpr NoDescription description_of{};

/// True for graze's own shapes.
template <class S>
concept Described = !std::is_same_v<const NoDescription, decltype(description_of<S>)>;

/// Calls visit(number) for each number of a field's value: a number, a vector, a matrix or an array of vectors.
template <class Value, class Visit>
constexpr void for_each_number(Value& value, const Visit& visit) {
  if constexpr (std::is_floating_point_v<std::remove_const_t<Value>>) {
    visit(value);
  } else if constexpr (requires { value.size(); }) {
    for (auto& element : value) for_each_number(element, visit);
  } else {
    for (Dim i = 0; i < value.length(); ++i) for_each_number(value[i], visit);
  }
}

/// Calls visit(field, value) for each field of a shape, in order. Values are mutable if the shape is, except those of
/// functions.
template <class S, class Visit>
constexpr void for_each_field(S& shape, const Visit& visit) {
  const auto visit_field = [&visit](const auto& field, auto&& value) { visit(field, value); };
  description_of<std::remove_const_t<S>>.apply(
      [&](const auto&... fields) { (visit_field(fields, fields.in(shape)), ...); });
}

/// A shape whose fields are change(field, value) of another shape's fields.
template <class S, class Change>
constexpr S with_fields_changed(const S& shape, const Change& change) {
  return description_of<S>.apply([&](const auto&... fields) { return S{change(fields, fields.in(shape))...}; });
}

}  // namespace graze::detail
