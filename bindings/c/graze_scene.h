/* SPDX-License-Identifier: MIT */
/* Scenes in graze's C interface: include <graze.h>. A scene is a world of shapes that are added, moved and removed.
 *
 * Queries may run in many threads at once while none changes the scene. Changes are: add, move, remove, except, accept,
 * layer, update, snapshot and destroy. A snapshot never changes. A call that fails leaves the scene unchanged.
 */
#ifndef GRAZE_SCENE_H
#define GRAZE_SCENE_H

#include "graze_types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The handle of a scene or snapshot. Zero names none; that of a scene that was destroyed is refused. */
typedef struct graze_scene {
  uint64_t handle;
} graze_scene;

/* Names an object of a scene during its lifetime. That of a removed object, or of another scene, is refused with
 * GRAZE_OUT_OF_RANGE. Ids are ordered by index, which is used again. A struct of zeros names none. */
typedef struct graze_id {
  uint32_t index, generation, owner;
} graze_id;

/* Two objects; a has the lower index. */
typedef struct graze_id_pair {
  graze_id a, b;
} graze_id_pair;

/* A set of layers, 0 to 63, by its bits. Options name the layers to leave out, so that zero means all. */
typedef uint64_t graze_layers;

/* The properties of an object beside its shape; all zero by default. */
typedef struct graze_object_options {
  const char* name;            /* In UTF-8, unique in the scene; null or empty for none. The library copies it. */
  uint64_t user;               /* For the caller. */
  graze_layers ignored_layers; /* It is no pair with objects on these. */
  uint32_t layer;              /* The layer that it is on, 0 to 63. */
  bool is_fixed;               /* Part of the world: two fixed objects are never a pair. */
} graze_object_options;

/* An object as graze_scene_object tells it: the options it was added with, and the bounds of its shape. The name is
 * never null, and valid until the scene changes. */
typedef struct graze_object {
  graze_object_options options;
  graze_box box;
} graze_object;

/* Which objects a query may find. A null pointer and a struct of zeros mean all. */
typedef struct graze_query {
  graze_layers ignored_layers; /* Those on other layers. */
  const graze_id* except;      /* Leaves these out; may be null if the count is 0. */
  size_t except_count;
  bool ignore_initial_touch; /* For shape casts: as in graze_cast_options. */
} graze_query;

/* How pairs changed in the last update. */
typedef int32_t graze_event;
enum { GRAZE_BEGAN = 0, GRAZE_STAYED = 1, GRAZE_ENDED = 2 };

typedef struct graze_near_object {
  graze_id id;
  double distance; /* 0 if it touches. */
} graze_near_object;

typedef struct graze_near_pair {
  graze_id_pair pair;
  double distance; /* 0 if they touch. */
} graze_near_pair;

typedef struct graze_object_hit {
  graze_id id;
  graze_ray_hit hit; /* Without the face of a mesh. */
} graze_object_hit;

typedef struct graze_object_impact {
  graze_id id;
  graze_impact impact; /* The normal points towards the object. */
} graze_object_impact;

typedef struct graze_object_touch {
  graze_id id;
  graze_manifold manifold; /* From the shape to the object. */
} graze_object_touch;

typedef struct graze_object_contact {
  graze_id_pair pair;
  graze_manifold manifold; /* From pair.a to pair.b. */
} graze_object_contact;

/* ---- Making and changing scenes ---- */

/* An empty scene. The caller destroys it. */
GRAZE_API graze_status graze_create_scene(graze_world world, graze_scene* out);

/* The scene of a file: JSON, CSV or a Tiled map, told apart by content. Its world is GRAZE_2D or GRAZE_3D. `path` is in
 * UTF-8. GRAZE_INPUT_ERROR if it cannot be read. The caller destroys the scene. */
GRAZE_API graze_status graze_read_scene(const char* path, graze_scene* out);

/* A copy of the current state for queries, which refuses changes; it accepts the same ids and copies no objects. The
 * caller destroys it. Of a snapshot: another handle of it. */
GRAZE_API graze_status graze_scene_snapshot(graze_scene scene, graze_scene* out);

/* Ends a scene or snapshot. Does nothing for a handle of zero. */
GRAZE_API graze_status graze_destroy_scene(graze_scene scene);

/* Adds an object. Options may be null. */
GRAZE_API graze_status graze_scene_add(graze_scene scene, const graze_shape* shape, const graze_object_options* options,
                                       graze_id* out);

/* Replaces an object's shape, or the shapes of many objects: of all, or of none if there is an error. */
GRAZE_API graze_status graze_scene_move(graze_scene scene, graze_id id, const graze_shape* shape);
GRAZE_API graze_status graze_scene_move_many(graze_scene scene, const graze_id* ids, const graze_shape* shapes,
                                             size_t count);

/* Removes an object; its id is never valid again. */
GRAZE_API graze_status graze_scene_remove(graze_scene scene, graze_id id);

/* From now on the two objects are never a pair; graze_scene_accept undoes it. */
GRAZE_API graze_status graze_scene_except(graze_scene scene, graze_id a, graze_id b);
GRAZE_API graze_status graze_scene_accept(graze_scene scene, graze_id a, graze_id b);

/* The number of the layer with this name, created if there is none. GRAZE_TOO_MANY beyond 64. */
GRAZE_API graze_status graze_scene_layer(graze_scene scene, const char* name, uint32_t* out);

/* `update` finds the pairs that touch now, and how they changed since the last update; `events` reads a list of these
 * changes, ascending. A pair whose object was removed has ended, and its id no longer names an object. */
GRAZE_API graze_status graze_scene_update(graze_scene scene);
GRAZE_API graze_status graze_scene_events(graze_scene scene, graze_event event, graze_id_pair* out, size_t capacity,
                                          size_t* count);

/* ---- Objects ---- */

/* The world of its shapes, and the number of its objects. */
GRAZE_API graze_status graze_scene_world(graze_scene scene, graze_world* out);
GRAZE_API graze_status graze_scene_size(graze_scene scene, size_t* out);

/* Whether an id names an object now. */
GRAZE_API graze_status graze_scene_has(graze_scene scene, graze_id id, bool* out);

/* All ids, ascending. */
GRAZE_API graze_status graze_scene_ids(graze_scene scene, graze_id* out, size_t capacity, size_t* count);

/* The object with a name; GRAZE_NONE if there is none. */
GRAZE_API graze_status graze_scene_find(graze_scene scene, const char* name, graze_id* out);

/* What an object has beside its shape. */
GRAZE_API graze_status graze_scene_object(graze_scene scene, graze_id id, graze_object* out);

/* An object's shape. If it is a polytope, compound or mesh, it has a new geometry, which the caller destroys. */
GRAZE_API graze_status graze_scene_shape(graze_scene scene, graze_id id, graze_shape* out);

/* ---- Pairs of objects, except those that layers, fixed objects or graze_scene_except exclude; ascending ---- */

/* Those that touch or overlap, exactly tested, and their contact points. */
GRAZE_API graze_status graze_scene_pairs(graze_scene scene, graze_id_pair* out, size_t capacity, size_t* count);
GRAZE_API graze_status graze_scene_contacts(graze_scene scene, graze_object_contact* out, size_t capacity,
                                            size_t* count);

/* Those at most `within` apart, and their distances. */
GRAZE_API graze_status graze_scene_closest_pairs(graze_scene scene, double within, graze_near_pair* out,
                                                 size_t capacity, size_t* count);

/* ---- Objects by place. The query may be null. ---- */

/* The objects that a shape touches or overlaps, ascending, and their contact points. */
GRAZE_API graze_status graze_scene_overlapping(graze_scene scene, const graze_shape* region, const graze_query* query,
                                               graze_id* out, size_t capacity, size_t* count);
GRAZE_API graze_status graze_scene_contacts_with(graze_scene scene, const graze_shape* shape, const graze_query* query,
                                                 graze_object_touch* out, size_t capacity, size_t* count);

/* The objects whose boxes a shape's box touches: cheaper, and never fewer. */
GRAZE_API graze_status graze_scene_cull(graze_scene scene, const graze_shape* region, const graze_query* query,
                                        graze_id* out, size_t capacity, size_t* count);

/* The nearest objects to a shape, at most `capacity`, by distance; `count` becomes the number written. */
GRAZE_API graze_status graze_scene_nearest(graze_scene scene, const graze_shape* shape, const graze_query* query,
                                           graze_near_object* out, size_t capacity, size_t* count);

/* The first object that a ray hits, or GRAZE_NONE, and all, by t. The limit of the options counts; is_exit does not. */
GRAZE_API graze_status graze_scene_ray_cast(graze_scene scene, const graze_ray* ray, const graze_ray_options* options,
                                            const graze_query* query, graze_object_hit* out);
GRAZE_API graze_status graze_scene_ray_cast_all(graze_scene scene, const graze_ray* ray,
                                                const graze_ray_options* options, const graze_query* query,
                                                graze_object_hit* out, size_t capacity, size_t* count);

/* The first object that a shape touches as it moves from t = 0 to 1, or GRAZE_NONE, and all, by t. */
GRAZE_API graze_status graze_scene_shape_cast(graze_scene scene, const graze_shape* shape, graze_vec motion,
                                              const graze_query* query, graze_object_impact* out);
GRAZE_API graze_status graze_scene_shape_cast_all(graze_scene scene, const graze_shape* shape, graze_vec motion,
                                                  const graze_query* query, graze_object_impact* out, size_t capacity,
                                                  size_t* count);

/* The first object that a shape touches as it moves and rotates, or GRAZE_NONE. */
GRAZE_API graze_status graze_scene_time_of_impact(graze_scene scene, const graze_shape* shape,
                                                  const graze_motion* motion, const graze_query* query,
                                                  graze_object_impact* out);

#ifdef __cplusplus
}
#endif

#endif
