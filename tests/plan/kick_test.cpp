// SPDX-License-Identifier: MIT
//
// An object ball as the target: the cue ball touches it first, at the cut angle and speed asked for.
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/found_again.hpp"

using namespace bankshot;
using Catch::Matchers::WithinAbs;

namespace {

constexpr const char* balls = R"("others": [{"id": "8", "at": [1.4, 0.63]}, {"id": "9", "at": [2.0, 0.9]}])";

Answer solved(const std::string& keys, const SolveOptions& options = {}) {
  return solve(read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, )" + keys + ", " + balls + "}"),
               options);
}

}  // namespace

TEST_CASE("every kick that a shot made is found, at its cut and speed", "[heavy]") {
  const auto [model, count] = GENERATE(table<test::Model, int>(
      {{test::Model::ideal, 300}, {test::Model::rolling, 300}, {test::Model::spin, 200}, {test::Model::mathavan, 30}}));
  const test::FoundAgain found = test::find_again("kicks", model, count, 42, 10);
  CAPTURE(found.unsolved);
  CHECK(found.unsolved.empty());
  CHECK(found.off_centre == 0);
}

TEST_CASE("a full hit leads through both centres, a cut ball leaves to the side that is asked") {
  const double to_8 = std::atan2(0.63 - 0.4, 1.4 - 0.635);
  const Answer full = solved(R"("target": {"ball": "8", "cut": 0}, "cushions": 0)");
  REQUIRE(full.status == Status::solved);
  CHECK_THAT(full.shots.front().launch.angle, WithinAbs(to_8, 1e-12));
  CHECK(full.shots.front().path.arrival.speed == Approx(0.5));
  const Answer left = solved(R"("target": {"ball": "8", "cut": 30}, "cushions": 0, "speed": 2)");
  REQUIRE(left.status == Status::solved);
  const Hit& hit = left.shots.front().path.hits.at(0);
  CHECK(hit.ball == 1);
  CHECK(degrees(hit.cut) == Approx(30));
  CHECK(left.shots.front().launch.angle < to_8);  // it passes to the right of the ball's middle
}

TEST_CASE("a ball of another size is met where spheres touch, at the cut that is asked") {
  int solved = 0;
  for (const double radius : {0.022, 0.035})
    for (const double cut : {-60.0, 0.0, 25.0}) {
      Puzzle p = read_puzzle(R"({"table": "pool-9ft", "physics": "rolling", "ball": {"at": [0.635, 0.4]},
        "target": {"ball": "8"}, "cushions": 1, "others": [{"id": "8", "at": [1.4, 0.63]}]})");
      p.others[0].body.radius = radius;
      std::get<BallTarget>(p.target).cut = radians(cut);
      const Answer a = solve(p);
      CAPTURE(radius, cut);
      REQUIRE(a.status == Status::solved);
      const Shot& shot = a.shots.front();
      CHECK(norm(shot.path.hits.at(0).at - p.others[0].at) == Approx(2 * std::sqrt(radius * p.ball.body.radius)));
      CHECK(degrees(shot.path.hits.at(0).cut) == Approx(cut).margin(1e-6));
      CHECK(shot.verification.miss < 1e-9);
      ++solved;
    }
  CHECK(solved == 6);
}

TEST_CASE("a ball behind another is reached by a cushion, not through it") {
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"ball": "9"},
    "cushions": 0, "others": [{"id": "8", "at": [1.3, 0.4]}, {"id": "9", "at": [2.0, 0.4]}]})");
  const Answer straight = solve(p);
  CHECK(straight.status == Status::no_shot);
  CHECK(straight.message.find(R"(without ball "8" there is a shot)") != std::string::npos);
  Puzzle kick = p;
  kick.cushions = CushionRule::exactly(1);
  const Answer a = solve(kick);
  REQUIRE(a.status == Status::solved);
  CHECK(a.shots.front().path.hits.at(0).ball == 2);
}

TEST_CASE("of several balls each may be touched, and the first contact counts") {
  const Answer a = solved(R"("target": {"ball": "any"}, "cushions": {"max": 1})", {.all = true});
  REQUIRE(a.status == Status::solved);
  bool seen[3] = {};
  for (const Shot& s : a.shots) seen[s.path.hits.at(0).ball] = true;
  CHECK(seen[1]);
  CHECK(seen[2]);
}

TEST_CASE("a shot after which the cue ball falls says so, and ranks last") {
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "physics": "rolling", "ball": {"at": [1.9, 0.5]},
    "target": {"ball": "8", "within": 80}, "cushions": {"max": 2}, "arrive": {"speed": [1, 6]}, "aim": "centre",
    "others": [{"id": "8", "at": [2.4, 0.16]}]})");
  const Answer all = solve(p, {.all = true});
  REQUIRE(all.shots.size() > 2);
  bool scratched = false;
  for (const Shot& s : all.shots) {
    ShotRequest request = as_request(p, s);
    request.until = {};
    const Trajectory t = simulate(request);
    CHECK(s.path.scratch == (t.end == EventKind::pocket));
    CHECK((s.path.scratch || !scratched));
    scratched = scratched || s.path.scratch;
  }
}
