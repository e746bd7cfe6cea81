// SPDX-License-Identifier: MIT
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <graze/broad/executor.hpp>
#include <graze/query/bounds.hpp>
#include <graze/scene/scene.hpp>

#include "catalogue.hpp"

namespace graze::scene_test {
namespace {

using World = Scene<2, double>;
using Ball = Sphere<2, double>;
using V2 = Vec<2, double>;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST(Scene, HandsBackWhatWasAdded) {
  World scene;
  const ObjectId id = scene.add(Ball{{1, 2}, 3}, {.name = "ball", .layer = 4, .mask = only_layer(4), .user = 77});
  ASSERT_TRUE(scene.contains(id));
  const Object<2, double>& object = scene.object(id);
  EXPECT_EQ(std::get<Ball>(object.shape).radius, 3);
  EXPECT_EQ(object.box, (Aabb<2, double>{{-2, -1}, {4, 5}}));
  EXPECT_EQ(object.name, "ball");
  EXPECT_EQ(object.layer, 4);
  EXPECT_EQ(object.mask, only_layer(4));
  EXPECT_EQ(object.user, 77U);
  EXPECT_EQ(scene.find("ball"), id);
  EXPECT_EQ(scene.find("bell"), std::nullopt);
  EXPECT_EQ(scene.find(""), std::nullopt);
  EXPECT_EQ(scene.size(), 1U);
}

TEST(Scene, FindsPairsInOrderOfAdding) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{5, 0}, 1});
  const ObjectId c = scene.add(Ball{{2, 0}, 1});  // touches a
  const ObjectId d = scene.add(HalfSpace<2, double>{{0, 1}, 0});
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{a, c}, {a, d}, {b, d}, {c, d}}));
}

TEST(Scene, TestsExactlyWhatOnlyTheBoxesSuggest) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{1.5, 1.5}, 1});
  EXPECT_EQ(scene.candidates(), (std::vector<ObjectPair>{{a, b}}));
  EXPECT_TRUE(scene.pairs().empty());
}

TEST(Scene, AsksBothMasks) {
  World scene;
  const Layer walls = scene.layer("walls");
  const Layer ghosts = scene.layer("ghosts");
  EXPECT_EQ(scene.layer("walls"), walls);
  EXPECT_EQ(scene.layer_names(), (std::vector<std::string>{"walls", "ghosts"}));
  const ObjectId wall = scene.add(Ball{}, {.layer = walls});
  const ObjectId ghost = scene.add(Ball{}, {.layer = ghosts, .mask = only_layer(ghosts)});
  const ObjectId other_ghost = scene.add(Ball{}, {.layer = ghosts});
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{wall, other_ghost}, {ghost, other_ghost}}));
}

TEST(Scene, AStaleIdIsAnErrorAndNeverAnotherObject) {
  World scene;
  const ObjectId first = scene.add(Ball{}, {.name = "first"});
  scene.remove(first);
  const ObjectId second = scene.add(Ball{}, {.name = "second"});
  EXPECT_EQ(second.index, first.index);  // the slot is reused
  EXPECT_FALSE(scene.contains(first));
  EXPECT_THROW(scene.object(first), std::out_of_range);
  EXPECT_THROW(scene.remove(first), std::out_of_range);
  EXPECT_THROW(scene.move(first, Ball{}), std::out_of_range);
  EXPECT_EQ(scene.find("first"), std::nullopt);
  EXPECT_EQ(scene.object(second).name, "second");
}

TEST(Scene, AnIdThatIsNotOfThisSceneIsAnError) {
  World scene;
  World other;
  scene.add(Ball{}, {.name = "mine"});
  const ObjectId foreign = other.add(Ball{});
  EXPECT_FALSE(scene.contains(foreign));
  EXPECT_FALSE(scene.contains(ObjectId{}));
  EXPECT_EQ(message_of([&] { scene.object(foreign); }),
            "Scene: the id (index 0, generation 1) belongs to another scene");
  EXPECT_EQ(message_of([&] { scene.remove(ObjectId{}); }),
            "Scene: the id (index 0, generation 0) is default-constructed; only add returns ids");
  const ObjectId gone = scene.add(Ball{});
  scene.remove(gone);
  EXPECT_EQ(message_of([&] { scene.move(gone, Ball{}); }),
            "Scene: the id (index 1, generation 1) names no object any more; it was removed");
  EXPECT_EQ(scene.size(), 1U);
  World copy = scene;
  const ObjectId of_copy = copy.add(Ball{});
  EXPECT_EQ(message_of([&] { scene.remove(of_copy); }),
            "Scene: the id (index 1, generation 3) belongs to another scene");
}

TEST(Scene, ACopyAnswersToTheSameIdsAndGoesItsOwnWay) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1}, {.name = "a"});
  const ObjectId b = scene.add(Ball{{1, 0}, 1});
  scene.update();
  World copy = scene;
  copy.remove(a);
  EXPECT_EQ(copy.update().ended, (std::vector<ObjectPair>{{a, b}}));
  EXPECT_EQ(scene.object(a).name, "a");
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{a, b}}));
  EXPECT_EQ(scene.overlapping(V2(0, 0)), (std::vector<ObjectId>{a, b}));
  EXPECT_EQ(copy.overlapping(V2(0, 0)), (std::vector<ObjectId>{b}));
}

TEST(Scene, AnIdThatACopyGaveOutNamesNothingInTheOriginal) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  World copy = scene;
  const ObjectId later = copy.add(Ball{{1, 0}, 1});
  copy.remove(a);
  const ObjectId again = copy.add(Ball{{2, 0}, 1});
  for (const ObjectId& id : {later, again}) {
    EXPECT_FALSE(scene.contains(id));
    EXPECT_THROW(scene.move(id, Ball{}), std::out_of_range);
    EXPECT_THROW(scene.remove(id), std::out_of_range);
  }
  EXPECT_EQ(scene.ids(), std::vector<ObjectId>{a});
}

TEST(Scene, ManyObjectsMoveTogetherOrNotAtAll) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{5, 0}, 1});
  using Move = ObjectMove<2, double>;
  EXPECT_THROW(scene.move(std::vector<Move>{{a, Ball{{3, 0}, 1}}, {b, Ball{{3, 0}, -1}}}), std::invalid_argument);
  EXPECT_THROW(scene.move(std::vector<Move>{{a, Ball{{3, 0}, 1}}, {ObjectId{}, Ball{}}}), std::out_of_range);
  EXPECT_EQ(std::get<Ball>(scene.object(a).shape).center, V2(0, 0));
  EXPECT_TRUE(scene.pairs().empty());
  scene.move(std::vector<Move>{{a, Ball{{9, 0}, 1}}, {b, Ball{{3, 0}, 1}}, {a, Ball{{2, 0}, 1}}});
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{a, b}}));
}

TEST(Scene, ObjectsMoveToShapesOfOneTypeTogetherOrNotAtAll) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Aabb<2, double>{{5, 0}, {6, 1}}, {.name = "crate"});
  const auto before = scene.snapshot();
  using Balls = std::vector<Ball>;
  EXPECT_EQ(message_of([&] {
              scene.move({a, b}, Balls{{{3, 0}, 1}});
            }),
            "Scene: 1 shapes for 2 objects to be moved; each needs one");
  EXPECT_EQ(message_of([&] {
              scene.move({a, b}, Balls{{{3, 0}, 1}, {{3, 0}, -1}});
            }),
            "Scene: object \"crate\", a sphere, has a negative radius");
  EXPECT_THROW(scene.move({a, ObjectId{}}, Balls{{{3, 0}, 1}, {{3, 0}, 1}}), std::out_of_range);
  EXPECT_EQ(std::get<Ball>(scene.object(a).shape).center, V2(0, 0));
  EXPECT_TRUE(scene.pairs().empty());
  scene.move({a, b, a}, Balls{{{9, 0}, 1}, {{3, 0}, 1}, {{2, 0}, 1}});
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{a, b}}));
  EXPECT_EQ(std::get<Ball>(scene.object(b).shape).center, V2(3, 0));
  EXPECT_EQ(scene.object(b).box, (Aabb<2, double>{{2, -1}, {4, 1}}));
  EXPECT_TRUE(std::holds_alternative<Ball>(before->object(a).shape));
  EXPECT_TRUE((std::holds_alternative<Aabb<2, double>>(before->object(b).shape)));
  scene.move({}, Balls{});
  EXPECT_EQ(scene.update().began, (std::vector<ObjectPair>{{a, b}}));
}

/// Boxes are validated together first: an invalid one is found wherever it is, and then nothing has moved.
TEST(Scene, ManyBoxesMoveTogetherOrNotAtAll) {
  using Crate = Aabb<2, double>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  World scene;
  std::vector<ObjectId> ids;
  std::vector<Crate> crates;
  for (int k = 0; k < 37; ++k) {
    crates.push_back({{k, 0}, {k + 0.5, 1}});
    ids.push_back(scene.add(crates.back()));
  }
  std::vector<Crate> places = crates;
  for (Crate& place : places) place = {place.min + 1.0, place.max + 1.0};
  for (const std::size_t at : {std::size_t{0}, std::size_t{17}, std::size_t{36}}) {
    for (const Crate& faulty : {Crate{{0, nan}, {1, 1}}, Crate{{0, 0}, {infinity, 1}}, Crate{{0, 0}, {1, -1}}}) {
      std::vector<Crate> some = places;
      some[at] = faulty;
      EXPECT_THROW(scene.move(ids, some), std::invalid_argument);
    }
    std::vector<ObjectId> strangers = ids;
    strangers[at] = ObjectId{};
    EXPECT_THROW(scene.move(strangers, places), std::out_of_range);
    for (std::size_t k = 0; k < ids.size(); ++k) EXPECT_EQ(scene.object(ids[k]).box, crates[k]);
  }
  scene.move(ids, places);
  for (std::size_t k = 0; k < ids.size(); ++k) EXPECT_EQ(scene.object(ids[k]).box, places[k]);
}

/// Moving an object that is already a box takes a shortcut, also after a snapshot, and if it was another shape in
/// between.
TEST(Scene, ManyBoxesMoveTogetherWhateverTheyWereAndWhoeverReads) {
  using Crate = Aabb<2, double>;
  World scene;
  std::vector<ObjectId> ids;
  std::vector<Crate> places;
  for (int k = 0; k < 70; ++k) {
    places.push_back({{2 * k, 0}, {2 * k + 1, 1}});
    ids.push_back(k % 3 == 0 ? scene.add(Ball{{k, 50}, 1}) : scene.add(places.back()));
  }
  const auto before = scene.snapshot();
  for (int round = 0; round < 3; ++round) {
    if (round == 1) scene.move(ids[4], Ball{{0, 90}, 1});
    for (Crate& place : places) place = {place.min + V2(1, 0), place.max + V2(round == 0 ? 2 : 1, 0)};
    scene.move(ids, places);
    EXPECT_EQ(scene.pairs().size(), ids.size() - 1) << "each reaches to the next";
    EXPECT_EQ(scene.update().began.size(), round == 0 ? ids.size() - 1 : 0);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      EXPECT_EQ(scene.object(ids[k]).box, places[k]);
      EXPECT_EQ(std::get<Crate>(scene.object(ids[k]).shape), places[k]);
    }
  }
  for (int k = 0; k < 70; ++k) {
    const auto& object = before->object(ids[static_cast<std::size_t>(k)]);
    EXPECT_EQ(std::holds_alternative<Ball>(object.shape), k % 3 == 0);
    EXPECT_EQ(object.box, k % 3 == 0 ? (Crate{{k - 1, 49}, {k + 1, 51}}) : (Crate{{2 * k, 0}, {2 * k + 1, 1}}));
  }
  EXPECT_TRUE(before->pairs().empty());
}

TEST(Scene, TellsWhatBeganWhatStaysAndWhatEnded) {
  World scene;
  using Pairs = std::vector<ObjectPair>;
  const ObjectId wall = scene.add(HalfSpace<2, double>{{0, 1}, 0}, {.mobility = Mobility::fixed});
  const ObjectId floor = scene.add(Aabb<2, double>{{0, -1}, {9, 1}}, {.mobility = Mobility::fixed});
  const ObjectId sphere = scene.add(Ball{{2, 5}, 1});
  EXPECT_TRUE(scene.update().began.empty());  // wall and floor overlap, but both are fixed
  scene.move(sphere, Ball{{2, 2}, 1});
  EXPECT_EQ(scene.update().began, (Pairs{{floor, sphere}}));
  scene.move(sphere, Ball{{2, 0.5}, 1});
  EXPECT_EQ(scene.update().began, (Pairs{{wall, sphere}}));
  EXPECT_EQ(scene.events().stayed, (Pairs{{floor, sphere}}));
  EXPECT_EQ(scene.update().stayed, (Pairs{{wall, sphere}, {floor, sphere}}));
  scene.remove(floor);
  const ObjectId other = scene.add(Ball{{2, 0.5}, 1});
  EXPECT_EQ(other.index, floor.index);
  scene.update();
  EXPECT_EQ(scene.events().began, (Pairs{{wall, other}, {other, sphere}}));
  EXPECT_EQ(scene.events().stayed, (Pairs{{wall, sphere}}));
  EXPECT_EQ(scene.events().ended, (Pairs{{floor, sphere}}));
}

/// Runs this many tasks, and fails at the next.
class FailingExecutor : public Executor {
 public:
  explicit FailingExecutor(std::size_t tasks) : tasks_(tasks) {}

  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    for (std::size_t i = 0; i < count; ++i) {
      if (tasks_ == 0) throw std::runtime_error("no more");
      --tasks_;
      task(i);
    }
  }
  std::size_t concurrency() const override { return 1; }

 private:
  mutable std::size_t tasks_;
};

TEST(Scene, AnUpdateThatFailsLeavesEventsAndPairsAsTheyWere) {
  World scene;
  using Pairs = std::vector<ObjectPair>;
  std::vector<ObjectId> ids;
  for (int k = 0; k < 100; ++k) ids.push_back(scene.add(Ball{{2.0 * k, 0}, 1}));
  scene.update();
  const ObjectId other = ids[50];
  std::size_t failed = 0;
  for (const double away : {5.0, 0.0}) {
    scene.move(other, Ball{{100, away}, 1});
    const Pairs began = away > 0 ? Pairs{} : Pairs{{ids[49], other}, {other, ids[51]}};
    const Pairs ended = away > 0 ? Pairs{{ids[49], other}, {other, ids[51]}} : Pairs{};
    const SceneEvents before = scene.events();
    for (std::size_t tasks = 0;; ++tasks, ++failed) {
      try {
        scene.update(FailingExecutor(tasks));
        break;
      } catch (const std::runtime_error&) {
        EXPECT_EQ(scene.events().began, before.began);
        EXPECT_EQ(scene.events().stayed, before.stayed);
        EXPECT_EQ(scene.pairs().size(), away > 0 ? 97U : 99U);
      }
    }
    EXPECT_EQ(scene.events().began, began);
    EXPECT_EQ(scene.events().ended, ended);
    EXPECT_EQ(scene.events().stayed.size(), 97U);
  }
  EXPECT_GE(failed, 2U);
}

TEST(Scene, ASnapshotStaysWhileTheSceneMovesOn) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1}, {.name = "a"});
  const ObjectId b = scene.add(Ball{{1, 0}, 1}, {.name = "b"});
  scene.update();
  const auto before = scene.snapshot();
  scene.remove(a);
  scene.move(b, Ball{{9, 9}, 1});
  const ObjectId c = scene.add(Ball{{9, 9}, 1}, {.name = "c"});
  const auto after = scene.snapshot();
  scene.remove(c);

  EXPECT_EQ(before->size(), 2U);
  EXPECT_EQ(before->find("a"), a);
  EXPECT_EQ(before->object(a).name, "a");
  EXPECT_EQ(before->pairs(), (std::vector<ObjectPair>{{a, b}}));
  EXPECT_EQ(before->overlapping(V2(0.5, 0)), (std::vector<ObjectId>{a, b}));
  EXPECT_EQ(before->nearest({9, 9}, 1).front().id, b);
  EXPECT_FALSE(before->contains(c));
  EXPECT_EQ(after->find("a"), std::nullopt);
  EXPECT_EQ(after->overlapping(V2(9, 9)), (std::vector<ObjectId>{c, b}));
  EXPECT_TRUE(after->overlapping(V2(0.5, 0)).empty());
  EXPECT_EQ(scene.overlapping(V2(9, 9)), (std::vector<ObjectId>{b}));
}

TEST(Scene, MoveReplacesTheShapeAndItsBox) {
  World scene;
  const ObjectId a = scene.add(Ball{{0, 0}, 1});
  const ObjectId b = scene.add(Ball{{9, 0}, 1});
  EXPECT_TRUE(scene.pairs().empty());
  scene.move(b, Aabb<2, double>{{1, 0}, {2, 1}});
  EXPECT_EQ(scene.pairs(), (std::vector<ObjectPair>{{a, b}}));
  EXPECT_EQ(scene.object(b).box, (Aabb<2, double>{{1, 0}, {2, 1}}));
}

TEST(Scene, ARefusedAddNamesTheFactAndChangesNothing) {
  World scene;
  const ObjectId a = scene.add(Ball{}, {.name = "a"});
  EXPECT_EQ(message_of([&] {
              scene.add(Ball{{0, 0}, -1}, {.name = "b"});
            }),
            "Scene: object \"b\", a sphere, has a negative radius");
  EXPECT_EQ(message_of([&] { scene.add(Ball{}, {.name = "a"}); }), "Scene: there is already an object \"a\"");
  EXPECT_EQ(message_of([&] { scene.add(Ball{}, {.layer = 64}); }),
            "Scene: layer 64 of the object does not exist; layers are 0 to 63");
  EXPECT_EQ(message_of([&] {
              scene.move(a, Ball{{std::numeric_limits<double>::quiet_NaN(), 0}, 1});
            }),
            "Scene: object \"a\", a sphere, has a center that is not finite");
  EXPECT_EQ(scene.size(), 1U);
  EXPECT_EQ(scene.find("b"), std::nullopt);
  EXPECT_EQ(std::get<Ball>(scene.object(a).shape).center, (Vec<2, double>(0)));
  const ObjectId b = scene.add(Ball{}, {.name = "b"});
  EXPECT_EQ(b.index, 1U);
}

TEST(Scene, HasSixtyFourLayersAndSaysSo) {
  World scene;
  for (int i = 0; i < 64; ++i) scene.layer("layer " + std::to_string(i));
  EXPECT_EQ(message_of([&] { scene.layer("wolf"); }),
            "Scene: layer \"wolf\" is one too many; a scene has at most 64 layers");
  EXPECT_EQ(scene.layer("layer 63"), 63);
}

template <Dim N, class T>
void check_pairs_against_all_pairs() {
  const auto shapes = *rc::gen::container<std::vector<AnyShape<N, T>>>(test::any_shape<N, T>());
  Scene<N, T> scene;
  std::vector<ObjectId> ids;
  for (const AnyShape<N, T>& shape : shapes) ids.push_back(scene.add(shape));
  std::vector<ObjectPair> expected;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = i + 1; j < shapes.size(); ++j) {
      if (relation(shapes[i], shapes[j]) != Relation::apart) expected.push_back({ids[i], ids[j]});
    }
  }
  RC_ASSERT(scene.pairs() == expected);
}

RC_GTEST_PROP(Scene, PairsAreThoseOfEveryObjectWithEveryOther2f, ()) { check_pairs_against_all_pairs<2, float>(); }
RC_GTEST_PROP(Scene, PairsAreThoseOfEveryObjectWithEveryOther3f, ()) { check_pairs_against_all_pairs<3, float>(); }
RC_GTEST_PROP(Scene, PairsAreThoseOfEveryObjectWithEveryOther2d, ()) { check_pairs_against_all_pairs<2, double>(); }
RC_GTEST_PROP(Scene, PairsAreThoseOfEveryObjectWithEveryOther3d, ()) { check_pairs_against_all_pairs<3, double>(); }

RC_GTEST_PROP(Scene, SurvivesAnySequenceOfAddsMovesAndRemoves, (const std::vector<std::uint32_t>& steps)) {
  World scene;
  std::vector<std::pair<ObjectId, double>> alive;  // the oracle: each sphere's radius
  std::set<ObjectId> dead;
  for (const std::uint32_t step : steps) {
    const double radius = step % 100;
    if (step % 3 == 0 || alive.empty()) {
      const ObjectId id = scene.add(Ball{{0, 0}, radius},
                                    {.name = step % 2 == 0 ? "" : "n" + std::to_string(alive.size() + dead.size())});
      RC_ASSERT(!dead.contains(id));
      alive.emplace_back(id, radius);
    } else if (auto& [id, held] = alive[step % alive.size()]; step % 3 == 1) {
      scene.move(id, Ball{{0, 0}, radius});
      held = radius;
    } else {
      scene.remove(id);
      dead.insert(id);
      alive.erase(alive.begin() + static_cast<std::ptrdiff_t>(step % alive.size()));
    }
  }
  RC_ASSERT(scene.size() == alive.size());
  RC_ASSERT(scene.ids().size() == alive.size());
  for (const auto& [id, radius] : alive) RC_ASSERT(std::get<Ball>(scene.object(id).shape).radius == radius);
  for (const ObjectId id : dead) RC_ASSERT(!scene.contains(id));
  RC_ASSERT(scene.pairs().size() == alive.size() * (alive.empty() ? 0 : alive.size() - 1) / 2);
}

}  // namespace
}  // namespace graze::scene_test
