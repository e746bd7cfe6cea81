// SPDX-License-Identifier: MIT
// Queries on two shapes: whether they intersect, their distance, the depth of their overlap, and ray casts.
#include <cmath>
#include <cstdio>
#include <optional>

#include <graze/graze.hpp>

int main() {
  const graze::Capsule<3> pole{{0, 0, 0}, {0, 0, 4}, 0.5F};
  const graze::Sphere<3> ball{{2, 0, 2}, 1};
  const graze::Sphere<3> near_ball{{1.25F, 0, 2}, 1};

  // Apart: the distance.
  const float gap = graze::distance(pole, ball);
  std::printf("the ball is %g from the pole\n", static_cast<double>(gap));

  // Overlapping: the contact. Moving the ball by normal * depth leaves the two touching.
  const std::optional<graze::Contact<3>> contact = graze::contact(pole, near_ball);
  if (!contact) return 1;
  std::printf("the near ball is %g deep, along (%g, %g, %g)\n", static_cast<double>(contact->depth),
              static_cast<double>(contact->normal.x), static_cast<double>(contact->normal.y),
              static_cast<double>(contact->normal.z));
  const graze::Sphere<3> pushed_ball{near_ball.center + contact->normal * contact->depth, near_ball.radius};
  std::printf("pushed out, it is %s\n", graze::name_of(graze::relation(pole, pushed_ball)).data());

  // Both in one call: a signed distance, negative if they overlap.
  const float separation = graze::separation(pole, near_ball).distance;

  // A ray, and a segment that ends before the ball.
  const std::optional<graze::RayHit<3>> hit = graze::ray_cast(ball, graze::Ray<3>{{5, 0, 2}, {-1, 0, 0}});
  const std::optional<graze::RayHit<3>> none = graze::ray_cast(ball, graze::Segment<3>{{5, 0, 2}, {3.5F, 0, 2}});
  if (!hit) return 1;
  std::printf("the ray hits the ball at t = %g\n", static_cast<double>(hit->t));

  return gap == 0.5F && contact->depth == 0.25F && separation == -contact->depth &&
                 graze::relation(pole, pushed_ball) == graze::Relation::touching && hit->t == 2 && !none
             ? 0
             : 1;
}
