// SPDX-License-Identifier: MIT
// The overlapping pairs of boxes that are spread over the ranks of an MPI job: mpirun -n 4 many_machines
#include <cstdint>
#include <cstdio>
#include <vector>

#include <mpi.h>

#include <graze/distributed/distributed_index.hpp>
#include <graze/distributed/exchange.hpp>
#include <graze/distributed/overlapping_pairs.hpp>
#include <graze/distributed/partition.hpp>
#include <graze/distributed/together.hpp>

namespace {

using Ball = graze::Body<3, float, float>;  // a box with an id, and a speed as payload

void simulate() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  std::vector<Ball> balls;
  graze::together(MPI_COMM_WORLD, [&] {  // if one rank fails here, all do
    for (std::uint64_t i = 0; i < 100; ++i) {
      const auto place = static_cast<float>(rank) + static_cast<float>(i) * 0.4F;
      balls.push_back({graze::Aabb<3>::from_center({place, 0, 0}, {0.5F, 1, 1}),
                       static_cast<std::uint64_t>(rank) * 100 + i, 0.01F});
    }
  });
  const auto boxes_of = [](const std::vector<Ball>& all) {
    std::vector<graze::Aabb<3>> boxes;
    for (const Ball& ball : all) boxes.push_back(ball.box);
    return boxes;
  };
  // Bring each ball to the rank that owns its part of space.
  std::vector<graze::Aabb<3>> boxes = boxes_of(balls);
  const graze::Partition<3> cuts = graze::partition<3, float>(MPI_COMM_WORLD, boxes);
  balls = graze::exchange<3, float, float>(MPI_COMM_WORLD, balls, cuts);
  std::vector<std::uint64_t> ids;
  for (const Ball& ball : balls) ids.push_back(ball.id);
  boxes = boxes_of(balls);
  const double even = graze::balance<3, float>(MPI_COMM_WORLD, cuts, boxes);
  const std::size_t at_first = graze::overlapping_pairs<3, float>(MPI_COMM_WORLD, boxes, ids).size();

  graze::DistributedPairFinder<3> finder(MPI_COMM_WORLD, {.skin = 0.05});
  for (int frame = 0; frame < 3; ++frame) {
    for (Ball& ball : balls) ball.box.min[0] -= ball.payload;
    boxes = boxes_of(balls);
    const auto pairs = finder.find(boxes, ids);
    std::printf("rank %d, frame %d: %zu pairs, %zu ghosts\n", rank, frame, pairs.size(), finder.frame().ghosts);
  }
  int cells = 0;
  finder.partition().visit_ranks(graze::Aabb<3>{{0, 0, 0}, {1, 1, 1}}, [&](int) { ++cells; });

  graze::DistributedIndex<3> index(MPI_COMM_WORLD, boxes, ids);
  const std::vector<graze::Vec<3>> points{{static_cast<float>(rank), 5, 0}};
  const std::vector<graze::Sphere<3>> regions{{{3, 0, 0}, 1}};
  const auto near = index.nearest(points, 1);
  std::printf(
      "rank %d: balance %.2f, %zu pairs at first, nearest %llu, %zu in the sphere, %d of %d cells at the origin\n",
      rank, even, at_first, static_cast<unsigned long long>(near[0].at(0).id), index.query(regions)[0].size(), cells,
      cuts.ranks());
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  simulate();
  MPI_Finalize();
}
