// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/mesh/bytes.hpp>
#include <graze/io/mesh/parts.hpp>
#include <graze/io/mesh/tokens.hpp>
#include <graze/io/stl/layout.hpp>
#include <graze/io/stl/reader.hpp>
#include <graze/io/text/in_quotes.hpp>
#include <graze/io/text/printable.hpp>
#include <graze/io/text/utf8.hpp>
#include <graze/shape/welded.hpp>

namespace graze::io {
namespace {

using Corners = std::vector<Vec<3, double>>;

/// A surface of the triangles with these corners, three each.
Mesh<3, double> mesh_of_corners(const Corners& corners) {
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t first = 0; first + 2 < corners.size(); first += 3) faces.push_back({first, first + 1, first + 2});
  return welded(mesh_of<3, double>(corners, faces));
}

/// Reads the words of STL in any case, as programs write them.
class StlTextReader {
 public:
  StlTextReader(std::string_view text, const std::string& source)
      : tokens_(text, source, MeshSyntax::plain), source_(source) {}

  MeshFile read() {
    MeshFile file{{}, source_, "stl"};
    for (MeshToken token = tokens_.next(); !token.text.empty(); token = tokens_.next()) {
      expect(token, "solid");
      file.parts.push_back(read_solid());
    }
    return file;
  }

 private:
  static bool is(std::string_view text, std::string_view word) {
    return std::equal(text.begin(), text.end(), word.begin(), word.end(),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  }

  void expect(const MeshToken& token, std::string_view word) const {
    if (is(token.text, word)) return;
    if (token.text.empty()) {
      throw tokens_.error(token.offset,
                          fmt::format("the file ends here, where \"{}\" must follow; is it cut off?", word));
    }
    throw tokens_.error(token.offset, fmt::format("{} stands where \"{}\" must follow", in_quotes(token.text), word));
  }
  void expect(std::string_view word) { expect(tokens_.next(), word); }

  MeshPart read_solid() {
    MeshPart part;
    part.name = printable(tokens_.rest_of_line());
    Corners corners;
    for (;;) {
      const MeshToken token = tokens_.next();
      if (is(token.text, "endsolid")) break;
      if (!token.text.empty() && !is(token.text, "facet")) {
        throw tokens_.error(
            token.offset, fmt::format("{} stands where \"facet\" or \"endsolid\" must follow", in_quotes(token.text)));
      }
      expect(token, "facet");
      read_facet(corners);
    }
    tokens_.next_line();  // the name may be repeated
    part.mesh = mesh_of_corners(corners);
    return part;
  }

  void read_facet(Corners& corners) {
    expect("normal");
    for (int i = 0; i < 3; ++i) tokens_.next();  // of any length, often zero and sometimes NaN
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      Vec<3, double> point;
      for (Dim i = 0; i < 3; ++i) {
        point[i] = tokens_.number(tokens_.next(), mesh_axes[static_cast<std::size_t>(i)]);
      }
      corners.push_back(point);
    }
    expect("endloop");
    expect("endfacet");
  }

  MeshTokens tokens_;
  const std::string& source_;
};

/// The header as a name: its text up to the first zero byte; empty if it is not text. Colours of some programs follow
/// the name.
std::string name_in_header(std::string_view header) {
  std::string_view name = header.substr(0, header.find('\0'));
  name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
  name = name.substr(0, name.find_last_not_of(' ') + 1);
  const bool is_text = find_invalid_utf8(name) == std::string_view::npos && printable(name) == name;
  return is_text ? std::string(name) : "";
}

}  // namespace

MeshFile read_stl_text(std::string_view text, const std::string& source) {
  return StlTextReader(without_byte_order_mark(text), source).read();
}

MeshFile read_stl_binary(std::string_view bytes, const std::string& source) {
  const auto count = number_at<std::uint32_t>(bytes.data() + stl_name_bytes);
  const std::uint64_t needed = stl_head_bytes + std::uint64_t{stl_triangle_bytes} * count;
  if (needed > bytes.size()) {
    throw InputError(
        fmt::format("{}: byte {}: the header promises {} triangles, for which the file needs {} bytes, but "
                    "it has {}; is it cut off?",
                    source, stl_name_bytes, count, needed, bytes.size()));
  }
  Corners corners;
  corners.reserve(std::size_t{3} * count);
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    const std::size_t place = stl_head_bytes + triangle * stl_triangle_bytes + stl_normal_bytes;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec<3, double> point;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t at = place + 12 * corner + 4 * i;
        const auto value = number_at<float>(bytes.data() + at);
        if (!std::isfinite(value)) {
          throw InputError(fmt::format("{}: byte {}: triangle {}: {} of corner {} is {}; it must be a finite number",
                                       source, at, triangle, mesh_axes[i], corner, value));
        }
        point[static_cast<Dim>(i)] = value;
      }
      corners.push_back(point);
    }
  }
  MeshFile file{{}, source, "stl"};
  file.parts.push_back({name_in_header(bytes.substr(0, stl_name_bytes)), mesh_of_corners(corners)});
  if (needed < bytes.size()) {
    file.warnings.push_back(
        fmt::format("{}: {} bytes follow the {} triangles that the header promises; they were not "
                    "read",
                    source, bytes.size() - needed, count));
  }
  return file;
}

}  // namespace graze::io
