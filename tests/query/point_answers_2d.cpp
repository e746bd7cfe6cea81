// SPDX-License-Identifier: MIT
#include "query/point_answers_instances.hpp"

namespace graze::test {

template PointAnswers<2, float> answers(const AnyShape<2, float>&, const Vec<2, float>&);
template PointAnswers<2, double> answers(const AnyShape<2, double>&, const Vec<2, double>&);

}  // namespace graze::test
