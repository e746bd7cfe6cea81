// SPDX-License-Identifier: MIT
// Prints a hash of the first 10,000, 100,000 and 1,000,000 answers to each query, up to a number; a quarter of them in
// each space. They are the same on every machine: with a file of such lines, the program fails if one differs.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "answers/hash.hpp"
#include "answers/questions.hpp"

namespace graze::answers {
namespace {

constexpr std::size_t per_block = 250;
constexpr std::size_t spaces = 4;

std::string line_of(std::string_view query, std::size_t answers, const Hash& hash) {
  std::ostringstream line;
  line << query << ' ' << answers << ' ' << std::hex << std::setfill('0') << std::setw(16) << hash.value();
  return line.str();
}

/// The lines for as many answers.
std::vector<std::string> lines_up_to(std::size_t most) {
  std::array<Hash, query_names.size()> hashes;
  Questions<2, float> flat_floats(1);
  Questions<3, float> floats(2);
  Questions<2, double> flat_doubles(3);
  Questions<3, double> doubles(4);
  std::vector<std::string> lines;
  std::size_t next = 10'000;
  for (std::size_t answers = spaces * per_block; answers <= most; answers += spaces * per_block) {
    flat_floats.answer(per_block, hashes);
    floats.answer(per_block, hashes);
    flat_doubles.answer(per_block, hashes);
    doubles.answer(per_block, hashes);
    if (answers != next) continue;
    next *= 10;
    for (std::size_t i = 0; i < hashes.size(); ++i) lines.push_back(line_of(query_names[i], answers, hashes[i]));
  }
  return lines;
}

/// Prints the lines; those that the file lacks are marked.
int print(const std::vector<std::string>& lines, const char* path) {
  std::set<std::string> expected;
  if (path != nullptr) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) expected.insert(line);
  }
  std::size_t different = 0;
  for (const std::string& line : lines) {
    const bool differs = path != nullptr && !expected.contains(line);
    different += differs ? 1 : 0;
    std::cout << line << (differs ? "  differs" : "") << '\n';
  }
  if (different > 0)
    std::cout << different << " of " << lines.size() << " hashes differ from those in " << path << '\n';
  return different == 0 && !lines.empty() ? 0 : 1;
}

}  // namespace
}  // namespace graze::answers

int main(int count, char** arguments) {
  if (count != 2 && count != 3) {
    std::cerr << "usage: graze_answer_hashes ANSWERS [EXPECTED]\n";
    return 2;
  }
  try {
    return graze::answers::print(graze::answers::lines_up_to(std::strtoull(arguments[1], nullptr, 10)),
                                 count == 3 ? arguments[2] : nullptr);
  } catch (const std::exception& error) {
    std::cerr << "graze_answer_hashes: " << error.what() << '\n';
    return 1;
  }
}
