// SPDX-License-Identifier: MIT
// The orientation of three points, the side of a plane on which a point lies, and the comparison of two products:
// exactly, even if rounding hides the answer.
#include <array>
#include <cstdio>

#include <graze/graze.hpp>
#include <graze/math/orientation_3d.hpp>

int main() {
  // A point a few units in the last place beside a line, whose true side is the sign of y - x.
  const graze::Vec<2, double> q(12, 12);
  const graze::Vec<2, double> r(24, 24);
  int wrong = 0;
  int wrong_by_rounding = 0;
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 64; ++y) {
      const graze::Vec<2, double> p(0.5 + x * 0x1p-53, 0.5 + y * 0x1p-53);
      const int side = (y > x ? 1 : 0) - (y < x ? 1 : 0);
      const double area = graze::cross_2d(q - p, r - p);
      wrong_by_rounding += (area > 0 ? 1 : 0) - (area < 0 ? 1 : 0) != side ? 1 : 0;
      wrong += graze::orientation(p, q, r) != side ? 1 : 0;
    }
  }
  std::printf("of 4096 turns doubles get %d wrong, orientation %d\n", wrong_by_rounding, wrong);

  // On a plane through three points, and one step of a double above it.
  const std::array<graze::Vec<3, double>, 3> corners = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto side_of = [&corners](double z) {
    return graze::orientation(corners[0], corners[1], corners[2], graze::Vec<3, double>(0.5, 0.25, z));
  };
  std::printf("on the plane: %d, a step above it: %d\n", side_of(0.25), side_of(graze::next_up(0.25)));

  // n * n and (n + 1) * (n - 1) differ by 1, but round to the same double.
  const double n = 94906266;
  const graze::Rounded square = graze::two_product(n, n);
  const graze::Rounded product = graze::two_product(n + 1, n - 1);
  std::printf("rounded they differ by %g, exactly by %g\n", square.value - product.value,
              graze::difference_of_products(n, n, n + 1, n - 1));

  // A sum whose terms cancel. two_sum gives one addition together with its rounding error.
  const std::array<double, 3> terms = {1e16, 1, -1e16};
  const graze::Rounded sum = graze::two_sum(terms[0], terms[1]);
  std::printf("1e16 + 1 is %.0f with an error of %g\n", sum.value, sum.error);

  const bool are_exact = wrong == 0 && side_of(0.25) == 0 && side_of(graze::next_up(0.25)) == 1;
  return are_exact && wrong_by_rounding > 0 && graze::sign_of_difference(square, product) == 1 &&
                 graze::sign_of_sum(terms) == 1 && sum.error == 1
             ? 0
             : 1;
}
