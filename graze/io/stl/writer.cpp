// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include <graze/io/mesh/bytes.hpp>
#include <graze/io/mesh/joined.hpp>
#include <graze/io/output_error.hpp>
#include <graze/io/stl/layout.hpp>
#include <graze/io/stl/writer.hpp>
#include <graze/math/vec.hpp>

namespace graze::io {
namespace {

/// Readers take a header that begins with "solid" for text.
std::string header_of(std::span<const MeshPart> parts) {
  constexpr std::string_view mark_of_text = "solid";
  std::string header;
  if (parts.size() == 1 && parts[0].name.size() < stl_name_bytes && !parts[0].name.starts_with(mark_of_text)) {
    header = parts[0].name;
  }
  header.resize(stl_name_bytes, '\0');
  return header;
}

/// Of length 1; zero if there is none. Scaled first, so that no product over- or underflows.
Vec<3, double> normal_of(const Triangle<3, double>& triangle) {
  Vec<3, double> u = triangle.b - triangle.a;
  Vec<3, double> v = triangle.c - triangle.a;
  const double largest_u = max_abs(u);
  const double largest_v = max_abs(v);
  if (!(largest_u > 0 && largest_v > 0 && std::isfinite(largest_u) && std::isfinite(largest_v))) {
    return Vec<3, double>(0);
  }
  u /= largest_u;
  v /= largest_v;
  const Vec<3, double> normal = cross(u, v);
  const double length = std::sqrt(dot(normal, normal));
  return length > 0 ? normal / length : Vec<3, double>(0);
}

void append_vector(std::string& out, const Vec<3, double>& vector) {
  for (Dim i = 0; i < 3; ++i) append_number(out, as_float(vector[i], "STL"));
}

}  // namespace

void write_stl(std::ostream& out, std::span<const MeshPart> parts) {
  std::uint64_t count = 0;
  for (const MeshPart& part : parts) count += part.mesh.faces().size();
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    throw OutputError("STL holds at most 2^32 - 1 triangles, and there are more");
  }
  std::string record = header_of(parts);
  append_number(record, static_cast<std::uint32_t>(count));
  out << record;
  for (const MeshPart& part : parts) {
    for (std::size_t face = 0; face < part.mesh.faces().size(); ++face) {
      const Triangle<3, double> triangle = part.mesh.triangle(face);
      record.clear();
      append_vector(record, normal_of(triangle));
      for (const Vec<3, double>& corner : triangle.vertices()) append_vector(record, corner);
      append_number(record, std::uint16_t{0});
      out << record;
    }
  }
}

}  // namespace graze::io
