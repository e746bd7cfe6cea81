// SPDX-License-Identifier: MIT
#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include <zoltan.h>

#include <graze/distributed/zoltan/bisection.hpp>

namespace graze::detail {
namespace {

struct Destroyer {
  void operator()(Zoltan_Struct* zoltan) const {
    if (zoltan != nullptr) Zoltan_Destroy(&zoltan);
  }
};
using Handle = std::unique_ptr<Zoltan_Struct, Destroyer>;

void require_zoltan(int code, const char* call) {
  if (code != ZOLTAN_OK && code != ZOLTAN_WARN) {
    throw std::runtime_error("partition: Zoltan's " + std::string(call) + " failed with code " + std::to_string(code));
  }
}

template <Dim N>
std::span<const WeightedPoint<N>> points_of(void* data) {
  return *static_cast<std::span<const WeightedPoint<N>>*>(data);
}

template <Dim N>
int count_points(void* data, int* code) {
  *code = ZOLTAN_OK;
  return static_cast<int>(points_of<N>(data).size());
}

// The parameters of the next two are as Zoltan calls them.

template <Dim N>
// NOLINTNEXTLINE(readability-function-size)
void list_points(void* data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int weights, float* weight,
                 int* code) {
  const std::span<const WeightedPoint<N>> points = points_of<N>(data);
  for (std::size_t i = 0; i < points.size(); ++i) {
    global[i] = static_cast<ZOLTAN_ID_TYPE>(i);
    local[i] = static_cast<ZOLTAN_ID_TYPE>(i);
    if (weights > 0) weight[i] = points[i].weight;
  }
  *code = ZOLTAN_OK;
}

template <Dim N>
int dimension(void*, int* code) {
  *code = ZOLTAN_OK;
  return static_cast<int>(N);
}

template <Dim N>
// NOLINTNEXTLINE(readability-function-size,readability-non-const-parameter)
void list_coordinates(void* data, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int, double* coordinates,
                      int* code) {
  const std::span<const WeightedPoint<N>> points = points_of<N>(data);
  for (int i = 0; i < count; ++i) {
    for (Dim k = 0; k < N; ++k) coordinates[i * N + k] = points[local[i]].at[k];
  }
  *code = ZOLTAN_OK;
}

template <Dim N>
Handle configured(MPI_Comm comm, std::span<const WeightedPoint<N>>& points) {
  float version = 0;
  require_zoltan(Zoltan_Initialize(0, nullptr, &version), "Zoltan_Initialize");
  Handle zoltan(Zoltan_Create(comm));
  if (!zoltan) throw std::runtime_error("partition: Zoltan_Create failed");
  constexpr std::array<std::array<const char*, 2>, 8> parameters{{{"DEBUG_LEVEL", "0"},
                                                                  {"LB_METHOD", "RCB"},
                                                                  {"RCB_OUTPUT_LEVEL", "0"},
                                                                  {"KEEP_CUTS", "1"},
                                                                  {"RETURN_LISTS", "NONE"},
                                                                  {"OBJ_WEIGHT_DIM", "1"},
                                                                  {"NUM_GID_ENTRIES", "1"},
                                                                  {"NUM_LID_ENTRIES", "1"}}};
  for (const auto& [name, value] : parameters) require_zoltan(Zoltan_Set_Param(zoltan.get(), name, value), name);
  require_zoltan(Zoltan_Set_Num_Obj_Fn(zoltan.get(), count_points<N>, &points), "Zoltan_Set_Num_Obj_Fn");
  require_zoltan(Zoltan_Set_Obj_List_Fn(zoltan.get(), list_points<N>, &points), "Zoltan_Set_Obj_List_Fn");
  require_zoltan(Zoltan_Set_Num_Geom_Fn(zoltan.get(), dimension<N>, &points), "Zoltan_Set_Num_Geom_Fn");
  require_zoltan(Zoltan_Set_Geom_Multi_Fn(zoltan.get(), list_coordinates<N>, &points), "Zoltan_Set_Geom_Multi_Fn");
  return zoltan;
}

void cut(Zoltan_Struct* zoltan) {
  int changes = 0;
  int gid_entries = 0;
  int lid_entries = 0;
  int imports = 0;
  int exports = 0;
  ZOLTAN_ID_PTR import_globals = nullptr;
  ZOLTAN_ID_PTR import_locals = nullptr;
  ZOLTAN_ID_PTR export_globals = nullptr;
  ZOLTAN_ID_PTR export_locals = nullptr;
  int* import_ranks = nullptr;
  int* import_parts = nullptr;
  int* export_ranks = nullptr;
  int* export_parts = nullptr;
  const int code = Zoltan_LB_Partition(zoltan, &changes, &gid_entries, &lid_entries, &imports, &import_globals,
                                       &import_locals, &import_ranks, &import_parts, &exports, &export_globals,
                                       &export_locals, &export_ranks, &export_parts);
  Zoltan_LB_Free_Part(&import_globals, &import_locals, &import_ranks, &import_parts);
  Zoltan_LB_Free_Part(&export_globals, &export_locals, &export_ranks, &export_parts);
  require_zoltan(code, "Zoltan_LB_Partition");
}

/// The cell of a part; Zoltan's outermost numbers stand for infinity.
template <Dim N>
Aabb<N, double> cell_of(Zoltan_Struct* zoltan, int part) {
  int dimensions = 0;
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  require_zoltan(Zoltan_RCB_Box(zoltan, part, &dimensions, &low[0], &low[1], &low[2], &high[0], &high[1], &high[2]),
                 "Zoltan_RCB_Box");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Aabb<N, double> cell;
  for (Dim k = 0; k < N; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    cell.min[k] = low[axis] <= -DBL_MAX ? -infinity : low[axis];
    cell.max[k] = high[axis] >= DBL_MAX ? infinity : high[axis];
  }
  return cell;
}

}  // namespace

template <Dim N>
std::vector<Aabb<N, double>> bisected(const Communicator& comm, std::span<const WeightedPoint<N>> points) {
  std::vector<Aabb<N, double>> cells;
  const auto whole_for_first = [&] {
    cells.assign(static_cast<std::size_t>(comm.size()), Aabb<N, double>::nothing());
    cells.front() = Aabb<N, double>::everything();
  };
  const std::uint64_t count = comm.sum(static_cast<std::uint64_t>(points.size()));
  comm.together(whole_for_first);
  if (comm.size() == 1 || count == 0) return cells;
  // Zoltan's calls on one set of points succeed or fail on all ranks alike, but for memory that one of them lacks.
  Handle zoltan;
  comm.together([&] { zoltan = configured<N>(comm.handle(), points); });
  comm.together([&] { cut(zoltan.get()); });
  comm.together([&] {
    for (int part = 0; part < comm.size(); ++part) {
      cells[static_cast<std::size_t>(part)] = cell_of<N>(zoltan.get(), part);
    }
  });
  return cells;
}

template std::vector<Aabb<2, double>> bisected<2>(const Communicator&, std::span<const WeightedPoint<2>>);
template std::vector<Aabb<3, double>> bisected<3>(const Communicator&, std::span<const WeightedPoint<3>>);

}  // namespace graze::detail
