// SPDX-License-Identifier: MIT
#include "results.hpp"

namespace graze::python {
namespace {

/// Words are made once.
py::str kept_word(const char* word) { return py::reinterpret_steal<py::str>(PyUnicode_InternFromString(word)); }

py::object python_feature(const Feature& feature) {
  static ResultClass feature_class("Feature");
  const char* const kind = feature.kind == FeatureKind::vertex ? "vertex"
                           : feature.kind == FeatureKind::edge ? "edge"
                                                               : "face";
  return feature_class(kept_word(kind), feature.index);
}

py::object python_id(const ContactId& id) {
  static ResultClass id_class("ContactId");
  return id_class(python_feature(id.a), python_feature(id.b), id.part_a, id.part_b);
}

}  // namespace

py::str python_word(Relation relation) {
  return kept_word(relation == Relation::apart ? "apart" : relation == Relation::touching ? "touching" : "overlapping");
}

py::str python_word(Status status) { return kept_word(status == Status::converged ? "converged" : "best_bound"); }

template <Dim N, class T>
py::object python_result(const Proximity<N, T>& proximity) {
  static ResultClass proximity_class("Proximity");
  return proximity_class(proximity.distance, frozen_vector<N, T>(proximity.point_a),
                         frozen_vector<N, T>(proximity.point_b), frozen_vector<N, T>(proximity.normal),
                         python_word(proximity.relation), python_word(proximity.status), proximity.error);
}

template <Dim N, class T>
py::object python_result(const Contact<N, T>& contact) {
  static ResultClass contact_class("Contact");
  return contact_class(frozen_vector<N, T>(contact.point), frozen_vector<N, T>(contact.normal), contact.depth,
                       frozen_vector<N, T>(contact.point_a), frozen_vector<N, T>(contact.point_b),
                       python_word(contact.status), contact.error);
}

template <Dim N, class T>
py::object python_result(const Manifold<N, T>& manifold) {
  static ResultClass manifold_class("Manifold");
  static ResultClass point_class("ManifoldPoint");
  py::tuple points(manifold.size);
  for (std::size_t i = 0; i < manifold.size; ++i) {
    const ManifoldPoint<N, T>& point = manifold.points[i];
    points[i] = point_class(frozen_vector<N, T>(point.point), frozen_vector<N, T>(point.point_a),
                            frozen_vector<N, T>(point.point_b), point.depth, python_id(point.id));
  }
  return manifold_class(points, frozen_vector<N, T>(manifold.normal), python_word(manifold.status), manifold.error);
}

template <Dim N, class T>
py::object python_result(const RayHit<N, T>& hit) {
  static ResultClass hit_class("RayHit");
  return hit_class(hit.t, frozen_vector<N, T>(hit.point), frozen_vector<N, T>(hit.normal), python_word(hit.status),
                   hit.error);
}

template <Dim N, class T>
py::object python_result(const MeshHit<N, T>& hit) {
  static ResultClass hit_class("MeshHit");
  const py::object face = hit.face == no_face ? py::object(py::none()) : py::object(py::int_(hit.face));
  return hit_class(hit.t, frozen_vector<N, T>(hit.point), frozen_vector<N, T>(hit.normal), python_word(hit.status),
                   hit.error, face, frozen_vector<3, T>(hit.barycentric));
}

template <Dim N, class T>
py::object python_result(const Impact<N, T>& impact) {
  static ResultClass impact_class("Impact");
  return impact_class(impact.t, frozen_vector<N, T>(impact.point), frozen_vector<N, T>(impact.normal),
                      python_word(impact.status), impact.error);
}

#define GRAZE_PYTHON_RESULTS(N, T)                           \
  template py::object python_result(const Proximity<N, T>&); \
  template py::object python_result(const Contact<N, T>&);   \
  template py::object python_result(const Manifold<N, T>&);  \
  template py::object python_result(const RayHit<N, T>&);    \
  template py::object python_result(const MeshHit<N, T>&);   \
  template py::object python_result(const Impact<N, T>&);
GRAZE_PYTHON_RESULTS(2, float)
GRAZE_PYTHON_RESULTS(2, double)
GRAZE_PYTHON_RESULTS(3, float)
GRAZE_PYTHON_RESULTS(3, double)
#undef GRAZE_PYTHON_RESULTS

}  // namespace graze::python
