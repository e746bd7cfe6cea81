// SPDX-License-Identifier: MIT
// What is timed, and the list of contestants.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <graze/broad/pair.hpp>

#include "course.hpp"

namespace mesh_bench {

enum class Work {
  build,
  refit,       ///< Other vertices, same faces.
  moved_rays,  ///< One by one, after `refit`.
  rays,        ///< First hits, one by one.
  rays_batch,
  closest,  ///< Distances of points, one by one.
  closest_batch,
  inside,  ///< Of points, one by one.
  inside_batch,
  meshes_touch,
  face_pairs,
  mesh_distance,
  sphere,  ///< Whether it touches the mesh.
  box,
  capsule,
  sphere_contact,  ///< Whether it touches, and the contacts.
  box_contact,
  capsule_contact,
};
constexpr int works = static_cast<int>(Work::capsule_contact) + 1;

/// One number for each query: the t of a ray, infinity for none; a distance; 1 for yes and 0 for no. For `face_pairs`
/// one list each, in any order.
struct Answers {
  std::vector<double> numbers;
  std::vector<std::vector<graze::Pair>> pairs;
};

/// A contestant in one work.
struct Entry {
  Work work;
  std::string name;
  bool is_graze = false;          ///< The first of graze's is compared with the targets.
  std::function<void()> prepare;  ///< Called before each run and not timed. Builds what queries need.
  std::function<void(Answers&)> run;
};
using Entries = std::vector<Entry>;

/// Answers the queries one by one: ask(query) returns a number or a bool.
template <class Queries, class Ask>
void answer_each(const Queries& queries, Answers& answers, const Ask& ask) {
  answers.numbers.resize(queries.size());
  for (std::size_t k = 0; k < queries.size(); ++k) answers.numbers[k] = static_cast<double>(ask(queries[k]));
}

/// Adds the entries of one adapter, which all share.
template <class Adapter>
class Enrolment {
 public:
  Enrolment(std::string name, bool is_graze, std::shared_ptr<Adapter> adapter, Entries& field)
      : name_(std::move(name)), is_graze_(is_graze), adapter_(std::move(adapter)), field_(field) {}

  /// `prepare` and `run` are members of the adapter; `run` takes the answers if it gives any. `variant` tells apart
  /// entries for the same work.
  template <class Prepare, class Run>
  void add(Work work, Prepare prepare, Run run, const std::string& variant = "") {
    Entry entry;
    entry.work = work;
    entry.name = variant.empty() ? name_ : name_ + " " + variant;
    entry.is_graze = is_graze_;
    entry.prepare = [adapter = adapter_, prepare] { ((*adapter).*prepare)(); };
    entry.run = [adapter = adapter_, run]([[maybe_unused]] Answers& answers) {
      if constexpr (std::is_invocable_v<Run, Adapter&, Answers&>) {
        ((*adapter).*run)(answers);
      } else {
        ((*adapter).*run)();
      }
    };
    field_.push_back(std::move(entry));
  }

 private:
  std::string name_;
  bool is_graze_;
  std::shared_ptr<Adapter> adapter_;
  Entries& field_;
};

// Each adds the library's entries. The course must outlive them.
void enter_graze(const Course& course, Entries& field);
void enter_bullet(const Course& course, Entries& field);
void enter_cgal(const Course& course, Entries& field);
void enter_embree(const Course& course, Entries& field);
void enter_fcl(const Course& course, Entries& field);

}  // namespace mesh_bench
