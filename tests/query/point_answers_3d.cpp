// SPDX-License-Identifier: MIT
#include "query/point_answers_instances.hpp"

namespace graze::test {

template PointAnswers<3, float> answers(const AnyShape<3, float>&, const Vec<3, float>&);
template PointAnswers<3, double> answers(const AnyShape<3, double>&, const Vec<3, double>&);

}  // namespace graze::test
