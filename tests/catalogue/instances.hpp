// SPDX-License-Identifier: MIT
// The instances that the catalogue compiles once: the same list declares them (LINKAGE is extern) and defines them
// (LINKAGE is empty), hence the macros. Include it after catalogue.hpp.
#pragma once

#define GRAZE_TEST_NUMBERS(LINKAGE)                                                  \
  LINKAGE template class rc::Gen<float>;                                             \
  LINKAGE template class rc::Gen<double>;                                            \
  LINKAGE template class rc::Gen<int>;                                               \
  LINKAGE template class rc::Gen<std::size_t>;                                       \
  LINKAGE template rc::Shrinkable<float> graze::test::shrinking_to_simpler(float);   \
  LINKAGE template rc::Shrinkable<double> graze::test::shrinking_to_simpler(double); \
  LINKAGE template rc::Shrinkable<int> graze::test::shrinking_to_simpler(int);       \
  LINKAGE template rc::Shrinkable<std::size_t> graze::test::shrinking_to_simpler(std::size_t);

// The instances of a space: what graze needs of any shape, and the generators with their sources.
#define GRAZE_TEST_SPACE(LINKAGE, N, T)                                                                                \
  LINKAGE template graze::Aabb<N, T> graze::bounds(const AnyShape<N, T>&);                                             \
  LINKAGE template std::string_view graze::defect(const AnyShape<N, T>&);                                              \
  LINKAGE template graze::Compound<N, T> graze::compound_of<N, T>(std::vector<AnyShape<N, T>>);                        \
  LINKAGE template graze::Polytope<N, T> graze::convex_hull<N, T>(std::span<const Vec<N, T>>);                         \
  LINKAGE template class rc::Gen<graze::Vec<N, T>>;                                                                    \
  LINKAGE template class rc::Gen<graze::Pose<N, T>>;                                                                   \
  LINKAGE template class rc::Gen<graze::AnyShape<N, T>>;                                                               \
  LINKAGE template class rc::Gen<graze::test::AnyPair<N, T>>;                                                          \
  LINKAGE template class rc::Gen<std::vector<graze::Vec<N, T>>>;                                                       \
  LINKAGE template rc::Gen<std::vector<graze::Vec<N, T>>> graze::test::some(std::size_t, const rc::Gen<Vec<N, T>>&);   \
  LINKAGE template class rc::Gen<std::vector<graze::AnyShape<N, T>>>;                                                  \
  LINKAGE template rc::Gen<std::vector<graze::AnyShape<N, T>>> graze::test::some(std::size_t,                          \
                                                                                 const rc::Gen<AnyShape<N, T>>&);      \
  LINKAGE template rc::Gen<graze::Vec<N, T>> graze::test::vector_of<N, T>(const rc::Gen<T>&);                          \
  LINKAGE template graze::test::Source<N, T> graze::test::source_of<N, T>(Kind);                                       \
  LINKAGE template graze::test::Source<N, T> graze::test::sharing<N, T>(const Source<N, T>&, const Vec<N, T>&,         \
                                                                        const Vec<N, T>&);                             \
  LINKAGE template graze::test::Source<N, T> graze::test::draw_source<N, T>();                                         \
  LINKAGE template graze::AnyShape<N, T> graze::test::draw_shape<N, T>(const Source<N, T>&, int);                      \
  LINKAGE template graze::AnyShape<N, T> graze::test::draw_shape_at<N, T>(std::size_t, const Source<N, T>&, int);      \
  LINKAGE template rc::Gen<graze::AnyShape<N, T>> graze::test::any_shape<N, T>();                                      \
  LINKAGE template rc::Gen<graze::AnyShape<N, T>> graze::test::any_shape_at<N, T>(std::size_t);                        \
  LINKAGE template rc::Gen<graze::AnyShape<N, T>> graze::test::any_shape_from<N, T>(const Source<N, T>&, std::size_t); \
  LINKAGE template rc::Gen<graze::Pose<N, T>> graze::test::any_pose<N, T>();                                           \
  LINKAGE template rc::Gen<graze::test::AnyPair<N, T>> graze::test::any_pair_at<N, T>(std::size_t, std::size_t);       \
  LINKAGE template std::string graze::test::to_source<N, T>(const AnyShape<N, T>&);                                    \
  LINKAGE template struct graze::test::Drawing<graze::AnyShape<N, T>>;                                                 \
  GRAZE_TEST_TYPE(LINKAGE, Vec, N, T)                                                                                  \
  GRAZE_TEST_TYPE(LINKAGE, Segment, N, T)                                                                              \
  GRAZE_TEST_TYPE(LINKAGE, Ray, N, T)                                                                                  \
  GRAZE_TEST_TYPE(LINKAGE, Sphere, N, T)                                                                               \
  GRAZE_TEST_TYPE(LINKAGE, Aabb, N, T)                                                                                 \
  GRAZE_TEST_TYPE(LINKAGE, Obb, N, T)                                                                                  \
  GRAZE_TEST_TYPE(LINKAGE, Plane, N, T)                                                                                \
  GRAZE_TEST_TYPE(LINKAGE, HalfSpace, N, T)                                                                            \
  GRAZE_TEST_TYPE(LINKAGE, Triangle, N, T)                                                                             \
  GRAZE_TEST_TYPE(LINKAGE, Capsule, N, T)                                                                              \
  GRAZE_TEST_TYPE(LINKAGE, Polytope, N, T)                                                                             \
  GRAZE_TEST_TYPE(LINKAGE, Compound, N, T)                                                                             \
  GRAZE_TEST_TYPE(LINKAGE, Mesh, N, T)                                                                                 \
  GRAZE_TEST_TYPE(LINKAGE, Pose, N, T)

#define GRAZE_TEST_TYPE(LINKAGE, S, N, T)                       \
  LINKAGE template struct graze::test::Drawing<graze::S<N, T>>; \
  LINKAGE template std::string graze::test::to_source(const graze::S<N, T>&);
