// SPDX-License-Identifier: MIT
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <graze/io/omission.hpp>
#include <graze/io/text/quoting.hpp>

namespace graze::io {
namespace {

std::string_view loss_name(Loss loss) {
  if (loss == Loss::shape) return "shape";
  return loss == Loss::precision ? "precision" : "none";
}

std::string omission_json(const Omission& omission) {
  return fmt::format(R"({{"what": {}, "count": {}, "loss": "{}", "where": {}, "why": {}}})", json_string(omission.what),
                     omission.count, loss_name(omission.loss), json_string(omission.where), json_string(omission.why));
}

}  // namespace

std::vector<Omission> missing_shapes(std::span<const Omission> omissions) {
  std::vector<Omission> missing;
  for (const Omission& omission : omissions) {
    if (omission.loss == Loss::shape) missing.push_back(omission);
  }
  return missing;
}

std::string omission_text(const Omission& omission) {
  const std::string text = fmt::format("{} x {}", omission.count, omission.what);
  const bool both = !omission.where.empty() && !omission.why.empty();
  const std::string detail = omission.where + (both ? ": " : "") + omission.why;
  return omission.loss != Loss::shape || detail.empty() ? text : fmt::format("{} ({})", text, detail);
}

std::string omissions_json(std::span<const Omission> omissions) {
  std::string text;
  for (const Omission& omission : omissions) text += (text.empty() ? "" : ", ") + omission_json(omission);
  return "[" + text + "]";
}

std::string omission_ndjson(const Omission& omission) {
  return fmt::format("{{\"not_read\": {}}}\n", omission_json(omission));
}

std::string omission_csv(const Omission& omission, std::string_view header, std::string_view kind) {
  std::string row = csv_field(omission_text(omission));
  for (std::size_t comma = header.find(','); comma != std::string_view::npos; comma = header.find(',', comma + 1)) {
    const std::string_view name = header.substr(comma + 1, header.find(',', comma + 1) - comma - 1);
    row += name == kind ? ",not_read" : ",";
  }
  return row + "\n";
}

}  // namespace graze::io
