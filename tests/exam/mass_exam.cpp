// SPDX-License-Identifier: MIT
#include "exam/mass_exam.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "catalogue.hpp"
#include "exam/stopwatch.hpp"
#include "query/case_maker.hpp"
#include "query/mass_judgement.hpp"
#include "query/regressions.hpp"

namespace graze::exam {
namespace {

template <Dim N, class T>
void put(MassTally& tally, const AnyShape<N, T>& shape, RegressionLog& regressions) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const test::MassErrors errors = test::mass_errors<N, T>(shape);
  ++tally.cases;
  if (errors.true_volume > 0) ++tally.solid;
  tally.volume = std::max(tally.volume, errors.volume / epsilon);
  tally.centroid = std::max(tally.centroid, errors.centroid / epsilon);
  tally.inertia = std::max(tally.inertia, errors.inertia / epsilon);
  if (errors.are_within_bounds()) return;
  ++tally.wrong;
  regressions.add_failure(
      test::regression_row<N, T>("mass_properties", shape, Compound<N, T>{}, test::number_text(errors.true_volume)));
}

}  // namespace

template <Dim N, class T>
MassTally examine_mass(std::size_t type, const Settings& settings, RegressionLog& regressions) {
  constexpr std::uint64_t seeds_apart = 8000;  // not those of the verdicts
  constexpr std::size_t point = 0;
  test::CaseMaker<N, T> maker(type, point, settings.seed * seeds_apart + type);
  MassTally tally;
  tally.space = space_name<N, T>();
  tally.shape = shape_type_names[type];
  const Stopwatch watch;
  for (std::size_t turn = 0; tally.cases < settings.masses && watch.is_within(settings.seconds); ++turn) {
    const auto kind = static_cast<test::CaseKind>(turn % test::case_kind_count);
    put<N, T>(tally, maker.make(kind).front().first, regressions);
  }
  return tally;
}

template MassTally examine_mass<2, float>(std::size_t, const Settings&, RegressionLog&);
template MassTally examine_mass<2, double>(std::size_t, const Settings&, RegressionLog&);
template MassTally examine_mass<3, float>(std::size_t, const Settings&, RegressionLog&);
template MassTally examine_mass<3, double>(std::size_t, const Settings&, RegressionLog&);

}  // namespace graze::exam
