// SPDX-License-Identifier: MIT
#include "shape_text.hpp"

#include <utility>

#include <fmt/format.h>

#include <graze/io/input_error.hpp>
#include <graze/io/json/document.hpp>
#include <graze/io/json/fields.hpp>
#include <graze/io/json/shape_reader.hpp>

namespace graze::wasm {

void rethrow_without_place(const std::string& message, std::string_view role) {
  const std::string place = fmt::format("{}: line 1, column ", role);
  const std::size_t end = message.find(": ", place.size());
  if (!message.starts_with(place) || end == std::string::npos) throw io::InputError(message);
  throw io::InputError(fmt::format("{}{}", role, message.substr(end)));
}

template <Dim N>
AnyShape<N, double> shape_of(const std::string& text, const char* role) {
  try {
    const io::JsonDocument document(text, role);
    return io::read_json_shape<N>(document.root(), io::JsonPlace{document}, {});
  } catch (const io::InputError& error) {
    rethrow_without_place(error.what(), role);
  }
}

template <Dim N>
std::vector<AnyShape<N, double>> shapes_of(const std::string& text) {
  constexpr const char* role = "shapes";
  try {
    const io::JsonDocument document(text, role);
    const io::JsonPlace whole{document};
    std::vector<AnyShape<N, double>> shapes;
    for (const io::JsonValue item : io::read_array(document.root(), {role}, whole).items()) {
      const io::JsonPlace place{document, nullptr, "shape", shapes.size()};
      shapes.push_back(io::read_json_shape<N>(item, place, {}));
    }
    return shapes;
  } catch (const io::InputError& error) {
    rethrow_without_place(error.what(), role);
  }
}

template AnyShape<2, double> shape_of<2>(const std::string&, const char*);
template AnyShape<3, double> shape_of<3>(const std::string&, const char*);
template std::vector<AnyShape<2, double>> shapes_of<2>(const std::string&);
template std::vector<AnyShape<3, double>> shapes_of<3>(const std::string&);

}  // namespace graze::wasm
