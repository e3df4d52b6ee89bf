// SPDX-License-Identifier: MIT
//
// The scene of a puzzle in 50 digits: replays of a launch, how far it misses, its condition, what counts for its
// margin and its success, and scratches.
#include "truth/arrival.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

using truth::Arrived;

/// A puzzle with its best shot.
struct Solved {
  Puzzle puzzle;
  Shot shot;
};

Puzzle puzzle(const std::string& more, const std::string& physics = "rolling") {
  return read_puzzle(R"({"table": {"preset": "pool-9ft", "jaws": false}, "physics": ")" + physics +
                     R"(", "ball": {"at": [0.635, 0.4]}, )" + more + "}");
}

Solved solved(const std::string& more, const std::string& physics = "rolling") {
  Puzzle p = puzzle(more, physics);
  const Answer a = bankshot::solve(p);
  REQUIRE(a.status == Status::solved);
  return {std::move(p), a.shots.front()};
}

constexpr const char* to_rest = R"("target": {"point": [1.7, 0.9]}, "cushions": 1)";
constexpr const char* to_pocket = R"("target": {"pocket": "top-right"}, "cushions": 1)";
constexpr const char* to_ball = R"("others": [{"id": "1", "at": [1.6, 0.7]}], "target": {"ball": "1", "cut": 20},
  "cushions": 0)";
constexpr const char* pot = R"("others": [{"id": "1", "at": [1.9, 0.8]}],
  "target": {"ball": "1", "then": {"pocket": "top-right"}}, "cushions": 0)";

}  // namespace

TEST_CASE("the launch of a shot is made where, when and how fast it says") {
  const auto [words, physics] = GENERATE(table<std::string, std::string>({{to_rest, "rolling"},
                                                                          {to_rest, "spin"},
                                                                          {to_pocket, "rolling"},
                                                                          {to_pocket, "spin"},
                                                                          {to_ball, "spin"},
                                                                          {pot, "spin"}}));
  INFO(words << ", " << physics);
  const Solved s = solved(words, physics);
  const truth::Scene scene(s.puzzle);
  const Arrived there = scene.replay(s.shot.launch, s.shot, 0);
  REQUIRE(there.made());
  CHECK(there.cushions == s.shot.path.cushions);
  CHECK(there.ball == s.shot.arriving());
  CHECK(norm(there.at - s.shot.path.arrival.at) < 1e-9);
  CHECK(std::abs(there.time - s.shot.path.arrival.time) < 1e-8);
  CHECK(std::abs(there.speed - s.shot.path.arrival.speed) < 1e-8);
  CHECK(std::abs(scene.miss(there) - s.shot.verification.miss) < 1e-9);
  // A launch a tenth of a radian beside it makes nothing.
  CHECK(!scene.replay({s.shot.launch.speed, s.shot.launch.angle + 0.1}, s.shot, 0).made());
}

TEST_CASE("a shot is no shot with the cushions of another") {
  Solved s = solved(to_rest);
  const truth::Scene scene(s.puzzle);
  REQUIRE(s.shot.path.cushions.size() == 1);
  s.shot.path.cushions[0] = Contact::rail((s.shot.path.cushions[0].index + 1) % 4);
  const Arrived there = scene.replay(s.shot.launch, s.shot, 0);
  CHECK(!there.in_order);
  CHECK(!there.made());
}

TEST_CASE("slack forgives a rest that is a little too far off") {
  const Solved s = solved(to_rest);
  const truth::Scene scene(s.puzzle);
  const double within = point_of(s.puzzle.target)->within, by = s.shot.verification.condition;
  // Turned by 3/2 of the ring or pushed likewise, the ball rests outside the ring, but near it.
  const Launch turned{s.shot.launch.speed * (1 + 1.5 * within / by), s.shot.launch.angle};
  const Arrived there = scene.replay(turned, s.shot, within);
  REQUIRE(there.made());
  CHECK(there.passed > within);
  CHECK(scene.miss(there) == there.passed);
  CHECK(!scene.replay(turned, s.shot, 0).made());
}

TEST_CASE("a ball must stop only at a point, and only if no speed is asked for there") {
  CHECK(truth::Scene(puzzle(to_rest)).stops);
  CHECK(!truth::Scene(puzzle(R"("target": {"point": [1.7, 0.9]}, "arrive": {"speed": 0.5})")).stops);
  CHECK(!truth::Scene(puzzle(to_pocket)).stops);
  CHECK(!truth::Scene(puzzle(to_ball)).stops);
}

TEST_CASE("the condition is how far the end of a shot moves, by differences of simulations in double") {
  const Solved s = solved(to_rest);
  const truth::Scene scene(s.puzzle);
  const auto end = [&](double turned, double pushed) {
    ShotRequest r{.table = s.puzzle.table, .physics = s.puzzle.physics, .ball = s.puzzle.ball};
    r.launch = {s.shot.launch.speed * (1 + pushed), s.shot.launch.angle + turned};
    return simulate(r).events.back().state.at;
  };
  constexpr double h = 1e-6;
  const double by_aim = norm(end(h, 0) - end(-h, 0)) / (2 * h), by_speed = norm(end(0, h) - end(0, -h)) / (2 * h);
  const auto found = scene.condition(s.shot, {});
  REQUIRE(found);
  CHECK(found->metres == Approx(std::max(by_aim, by_speed)).epsilon(1e-5));
  CHECK(found->metres == Approx(s.shot.verification.condition).epsilon(1e-6));
  CHECK((found->rounding >= 0 && found->rounding < 1e-6));
  for (const truth::Scene::Sides& sides : {truth::Scene::Sides{-1, 1}, {1, -1}, {-1, -1, true}, {1, 1, true}}) {
    const auto side = scene.condition(s.shot, sides);
    REQUIRE(side);
    CHECK(side->metres == Approx(found->metres).epsilon(1e-9));  // the path is smooth here
  }
}

TEST_CASE("launches inside the margin count, those beyond it do not, and double agrees") {
  for (const char* words : {to_pocket, to_rest}) {
    INFO(words);
    const Solved s = solved(words);
    const truth::Scene scene(s.puzzle);
    REQUIRE(s.shot.robustness.margin);
    int ends = 0;
    for (const std::optional<double>& end : s.shot.robustness.margin->angle) {
      if (!end) continue;
      ++ends;
      const auto turned = [&](double share) { return Launch{s.shot.launch.speed, s.shot.launch.angle + share * *end}; };
      for (const double share : {0.0, 0.5, 0.99}) {
        CHECK(scene.counts(turned(share), s.shot));
        CHECK(scene.seems_to_count(turned(share), s.shot));
      }
      CHECK(!scene.counts(turned(1.01), s.shot));
      CHECK(!scene.seems_to_count(turned(1.01), s.shot));
    }
    CHECK(ends == 2);
    CHECK(!scene.counts({0, s.shot.launch.angle}, s.shot));
    CHECK(!scene.seems_to_count({-1, s.shot.launch.angle}, s.shot));
  }
}

TEST_CASE("a sample of tries makes the shot as often as its success says") {
  for (const char* words : {to_pocket, to_rest, pot}) {
    INFO(words);
    Solved s = solved(words);
    REQUIRE(s.shot.robustness.success);
    const double p = *s.shot.robustness.success;
    constexpr int draws = 1000;
    const truth::Scene scene(s.puzzle);
    const double seen = scene.chance(s.shot, draws);
    CHECK(std::abs(seen - p) <= 0.005 + 5 * std::sqrt(std::max(p * (1 - p), 1.0 / draws) / draws));
    CHECK(seen == scene.chance(s.shot, draws));  // the draws are seeded
    s.puzzle.noise = {.angle = 0, .speed = 0};
    CHECK(truth::Scene(s.puzzle).chance(s.shot, 10) == 1);
    s.puzzle.noise = {.angle = 1, .speed = 1};
    CHECK(truth::Scene(s.puzzle).chance(s.shot, 200) < p);
  }
}

TEST_CASE("errors of spin and of positions make a shot fail more often") {
  Solved s = solved(to_rest, "spin");
  s.puzzle.noise = {.angle = 0, .speed = 0};
  CHECK(truth::Scene(s.puzzle).chance(s.shot, 20) == 1);
  s.puzzle.noise.at = 0.02;
  CHECK(truth::Scene(s.puzzle).chance(s.shot, 100) < 0.9);
  s.puzzle.noise.at = 0, s.puzzle.noise.side = 0.5;
  CHECK(truth::Scene(s.puzzle).chance(s.shot, 100) < 0.9);
}

TEST_CASE("the cue ball that follows an object ball into the pocket scratches") {
  // A full hit along the line to the corner: with stun the cue ball stops, with follow it runs on into the pocket.
  const Puzzle p =
      puzzle(R"("others": [{"id": "1", "at": [1.04, 0.4]}], "target": {"ball": "1"}, "cushions": 0)", "spin");
  Puzzle straight = p;
  const Vec2d pocket = straight.table.pockets[0].at, towards = pocket - straight.ball.at;
  straight.others[0].at = straight.ball.at + towards * 0.5;
  const truth::Scene scene(straight);
  CHECK(scene.may_scratch());
  const Launch hard{4, std::atan2(towards.y, towards.x)};
  CHECK(scene.scratches(hard, {.top = 1}));
  CHECK(!scene.scratches({0.4, hard.angle}, {.top = 0}));
  CHECK(!scene.scratches({4, hard.angle + radians(180.0)}, {.top = -1, .side = 0}) ==
        !scene.scratches({4, hard.angle + radians(180.0)}, {.top = -1, .side = 0}));

  CHECK(!truth::Scene(puzzle(to_pocket)).may_scratch());
  CHECK(!truth::Scene(puzzle(to_pocket)).scratches({3, 0}, {}));  // it is the cue ball that must fall
  Puzzle closed = straight, ideal = straight;
  closed.table.pockets.clear();
  ideal.physics = ideal_physics();
  CHECK(!truth::Scene(closed).may_scratch());
  CHECK(!truth::Scene(ideal).may_scratch());
  CHECK(!truth::Scene(closed).scratches(hard, {.top = 1}));
}

TEST_CASE("each ball has the boundary of its own size, in which it does not meet itself") {
  const Puzzle p = puzzle(R"("others": [{"id": "1", "at": [1.6, 0.7], "radius": 0.02}, {"id": "2", "at": [2, 1]}],
    "target": {"ball": "1", "then": {"pocket": "any"}}, "cushions": 0)");
  const truth::Scene scene(p);
  CHECK(&scene.boundary_of(0) == &scene.boundary);
  CHECK(scene.boundary_of(0).body == p.ball.body);
  CHECK(scene.boundary_of(1).body.radius == 0.02);
  CHECK(scene.boundary_of(0).rim(Contact::ball(1)) != nullptr);
  CHECK(scene.boundary_of(1).rim(Contact::ball(1)) == nullptr);
  CHECK(scene.boundary_of(1).rim(Contact::ball(2)) != nullptr);
  CHECK(scene.boundary_of(2).rim(Contact::ball(1)) != nullptr);
}
