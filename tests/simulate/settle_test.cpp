// SPDX-License-Identifier: MIT
//
// Tests "settle": balls that overlap by up to 1e-4 m are moved apart before anything is checked, and the moves are
// reported.
#include "bankshot/scene/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/random_balls.hpp"
#include "support/random_shot.hpp"

using namespace bankshot;
using nlohmann::json;

namespace {

double worst_overlap(const ShotRequest& s) {
  double worst = 0;
  const int count = static_cast<int>(s.others.size()) + 1;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < i; ++j) {
      const Ball &a = ball_of(s, i), &b = ball_of(s, j);
      worst = std::max(worst, touching_distance(a.body, b.body) - norm(a.at - b.at));
    }
  return worst;
}

/// Returns a scene in which ball 8 overlaps the cue ball by `by` metres.
std::string overlapping(double by, const char* settle) {
  return fmt::format(
      R"({{"table": "pool-9ft", "ball": {{"at": [0.6, 0.5]}}, "others": [{{"id": "8", "at": [{}, 0.5]}},
      {{"id": "9", "at": [1.9, 0.9]}}], {} "shot": {{"speed": 1, "angle": 90}}}})",
      0.6 + 2 * 0.028575 - by, settle);
}

bool is_refused(const std::string& text) {
  try {
    read_shot(text);
    return false;
  } catch (const InvalidInput& e) {
    CHECK(std::string(e.what()).find("overlaps ball \"cue\"") != std::string::npos);
    return e.path == "/others/0/at";
  }
}

}  // namespace

TEST_CASE("balls that overlap a little are moved apart where the scene asks for it, and only there") {
  const std::string asked = R"("settle": true,)";
  CHECK(is_refused(overlapping(5e-5, "")));
  CHECK(is_refused(overlapping(5e-5, R"("settle": false,)")));
  CHECK(is_refused(overlapping(1.1e-4, asked.c_str())));
  const ShotRequest s = read_shot(overlapping(5e-5, asked.c_str()));
  CHECK(s.ball.at.x == Approx(0.6 - 2.5e-5).epsilon(1e-12));
  CHECK(s.others[0].at.x == Approx(0.6 + 2 * 0.028575 - 2.5e-5).epsilon(1e-12));
  REQUIRE(s.settled.size() == 3);
  CHECK(s.settled[0].x == Approx(-2.5e-5).epsilon(1e-6));
  CHECK(s.settled[2] == Vec2d{});
  const json told = json::parse(to_json(s, simulate(s)));
  CHECK(told["settled"].size() == 2);
  CHECK(told["settled"]["8"] == json{s.settled[1].x, s.settled[1].y});
  CHECK(told["settled"]["cue"] == json{s.settled[0].x, s.settled[0].y});
  const ShotRequest apart = read_shot(overlapping(-5e-5, asked.c_str()));
  CHECK(json::parse(to_json(apart, simulate(apart)))["settled"] == json::object());
  const ShotRequest not_asked = read_shot(overlapping(-5e-5, ""));
  CHECK(!json::parse(to_json(not_asked, simulate(not_asked))).contains("settled"));
}

TEST_CASE("a rack measured a tenth of a millimetre too tight is settled, as are balls beside cushions") {
  Random r(8);
  int racks = 0, layouts = 0;
  for (int i = 0; i < 100; ++i, ++racks) {
    ShotRequest shot = test::break_shot(r, -r.log_uniform(1e-7, 9.9e-5));
    INFO("rack " << i << " of seed 8: " << test::write_shot(shot));
    REQUIRE(worst_overlap(shot) > 9e-8);
    settle(shot.table, shot.ball, shot.others);
    REQUIRE_NOTHROW(validate(shot));
  }
  for (int i = 0; i < 300; ++i) {
    ShotRequest shot = test::random_balls(r, i % 2 ? test::BallFamily::frozen : test::BallFamily::sizes);
    for (Ball& ball : shot.others)
      ball.at = Boundary(shot.table, ball.body)
                    .moved_inside(ball.at + Vec2d{r.uniform(-3e-5, 3e-5), r.uniform(-3e-5, 3e-5)}, 1e-4);
    if (worst_overlap(shot) <= tolerance::overlap) continue;
    INFO("layout " << i << " of seed 8: " << test::write_shot(shot));
    const ShotRequest asked = shot;
    const std::vector<Vec2d> moves = settle(shot.table, shot.ball, shot.others);
    REQUIRE_NOTHROW(validate(shot));
    double farthest = 0;
    for (int k = 0; k <= static_cast<int>(shot.others.size()); ++k) {
      REQUIRE(moves[static_cast<std::size_t>(k)] == ball_of(shot, k).at - ball_of(asked, k).at);
      farthest = std::max(farthest, norm(moves[static_cast<std::size_t>(k)]));
    }
    CHECK(farthest < 1e-3);
    ++layouts;
  }
  CHECK(racks == 100);
  CHECK(layouts > 100);
}

TEST_CASE("balls without room stay where they are, and are refused") {
  // Three balls abreast on a table that is a hundredth of a millimetre too narrow for them.
  const double R = Body{}.radius, width = 6 * R - 1e-5;
  ShotRequest shot{.table = rectangle_table(2, width)};
  shot.ball.at = {1, R};
  shot.others = {{{1, width / 2}, shot.ball.body, "1"}, {{1, width - R}, shot.ball.body, "2"}};
  const std::vector<Vec2d> moves = settle(shot.table, shot.ball, shot.others);
  CHECK(std::ranges::all_of(moves, [](const Vec2d& by) { return by == Vec2d{}; }));
  CHECK_THROWS_AS(validate(shot), InvalidInput);
  // With one ball slightly beside the others, there is space on that side.
  shot.others[0].at.x += 1e-3;
  settle(shot.table, shot.ball, shot.others);
  CHECK_NOTHROW(validate(shot));
}

TEST_CASE("an answer says how balls were moved, and is read against the puzzle") {
  const std::string scene = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"ball": "8"},
    "cushions": 0, "others": [{"id": "8", "at": [1.4, 0.63]}, {"id": "9", "at": [1.45712, 0.63]}], "settle": true})";
  const Puzzle p = read_puzzle(scene);
  REQUIRE(p.settled.size() == 3);
  CHECK(p.settled[0] == Vec2d{});
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const std::string text = to_json(p, a);
  const json told = json::parse(text);
  CHECK(told["settled"].size() == 2);
  CHECK(told["settled"]["9"][0].get<double>() == Approx(1.5e-5).epsilon(1e-6));
  CHECK_NOTHROW(read_answer(text, &p));
  json wrong = told;
  wrong["settled"]["9"][0] = 0;
  CHECK_THROWS_AS(read_answer(wrong.dump(), &p), InvalidInput);
  // The written puzzle still asks for "settle", and nothing is left to move.
  const Puzzle again = read_puzzle(write_puzzle(p));
  CHECK(again.settled == std::vector<Vec2d>(3));
  CHECK(again.others[1].at == p.others[1].at);
}
