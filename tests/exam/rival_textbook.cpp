// SPDX-License-Identifier: MIT
#include <optional>
#include <variant>

#include "exam/rival.hpp"
#include "exam/textbook.hpp"

namespace graze::exam {
namespace {

template <class T>
std::optional<bool> answer(const Solid3<T>& a, const Solid3<T>& b) {
  return std::visit(
      [](const auto& held_a, const auto& held_b) -> std::optional<bool> {
        if constexpr (requires { textbook::meet(held_a, held_b); }) {
          return textbook::meet(held_a, held_b);
        } else {
          return std::nullopt;
        }
      },
      a, b);
}

}  // namespace

std::optional<bool> textbook_answer(const Solid3<float>& a, const Solid3<float>& b) { return answer<float>(a, b); }
std::optional<bool> textbook_answer(const Solid3<double>& a, const Solid3<double>& b) { return answer<double>(a, b); }

}  // namespace graze::exam
