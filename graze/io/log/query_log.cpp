// SPDX-License-Identifier: MIT
#include <ostream>

#include <fmt/format.h>

#include <graze/io/log/query_log.hpp>

namespace graze::io {

std::string_view name_of(NumberType numbers) { return numbers == NumberType::single_precision ? "float" : "double"; }

std::string log_head(Dim dimension, NumberType numbers) {
  return fmt::format(R"({{"schema": "{}", "dimension": {}, "numbers": "{}"}})", query_log_schema, dimension,
                     name_of(numbers));
}

template <Dim N>
void write_query_log(std::ostream& out, const QueryLog<N>& log) {
  out << log_head(N, log.numbers) << '\n';
  for (const LogEntry<N>& entry : log.entries) {
    out << call_line(entry.call) << '\n';
    if (entry.answer) out << answer_line(*entry.answer) << '\n';
  }
}

template void write_query_log(std::ostream&, const QueryLog<2>&);
template void write_query_log(std::ostream&, const QueryLog<3>&);

}  // namespace graze::io
