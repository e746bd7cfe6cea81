// SPDX-License-Identifier: MIT
// Two spheres touch if the distance of their centers is at most the sum of their radii.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <graze/query/intersects.hpp>

#include "picture.hpp"

using Disc = graze::Circle<>;

bool naive(const Disc& a, const Disc& b) {
  const float radii = a.radius + b.radius;
  return dot(b.center - a.center, b.center - a.center) <= radii * radii;
}

int main(int argc, char** argv) {
  // Integers, so that exact answers are known: centers at (0, 0) and (x, y), radii that almost suffice.
  int cases = 0;
  int naive_wrong = 0;
  int wrong = 0;
  for (std::int64_t x = 5000; x < 6000; x += 3) {
    for (std::int64_t y = 5000; y < 6000; y += 7) {
      const auto radii = static_cast<std::int64_t>(std::lround(std::sqrt(static_cast<double>(x * x + y * y))));
      if (std::abs(x * x + y * y - radii * radii) > 100) continue;
      const bool touch = x * x + y * y <= radii * radii;
      const Disc a{{0, 0}, 1000};
      const Disc b{{x, y}, static_cast<float>(radii - 1000)};
      ++cases;
      naive_wrong += naive(a, b) != touch ? 1 : 0;
      wrong += graze::intersects(a, b) != touch ? 1 : 0;
    }
  }
  std::printf("%d close calls: intersects errs %d times, squares in float %d times\n", cases, wrong, naive_wrong);

  const Disc here{{0, 0}, 1e19F};
  const Disc there{{1e20F, 0}, 1e19F};
  std::printf("8e19 apart: intersects %d, squares in float %d\n", graze::intersects(here, there) ? 1 : 0,
              naive(here, there) ? 1 : 0);
  std::printf("touching: %s, one step of float apart: %s\n",
              graze::name_of(graze::relation(Disc{{0, 0}, 2}, Disc{{3, 4}, 3})).data(),
              graze::name_of(graze::relation(Disc{{0, 0}, 2}, Disc{{3, std::nextafter(4.0F, 5.0F)}, 3})).data());

  cookbook::Picture<2> picture("spheres");
  picture.add(Disc{{0, 0}, 2}, "radius 2");
  picture.add(Disc{{3, 4}, 3}, "radius 3, center 5 away");
  picture.add(Disc{{9, 0}, 2.5F}, "radius 2.5");
  picture.add(Disc{{12, 1}, 1.5F}, "radius 1.5");
  picture.add(Disc{{9, 5.5F}, 1.9F}, "apart");
  return picture.save(argc, argv);
}
