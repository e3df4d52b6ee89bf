// SPDX-License-Identifier: MIT
//
// Choices of the planner: a spin inside a range, a launch inside what counts as made. Also tests what an answer says
// when there is nothing to choose.
#include <algorithm>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/claims.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

Puzzle read(const std::string& more) {
  return read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4])" + more);
}

}  // namespace

TEST_CASE("of a range of spin the one that prefer likes best is used") {
  for (const char* prefer : {"soft", "quick"}) {
    Puzzle p = read(
        std::string(
            R"(, "spin": {"top": [0, 1], "side": [-1, 1]}}, "target": {"point": [1.9, 0.9]}, "cushions": 1, "prefer": ")") +
        prefer + "\"}");
    const auto worth = [&](const Answer& a) {
      REQUIRE(a.status == Status::solved);
      CHECK_THAT(test::check_shot(p, a.shots[0]).problem, Catch::Equals(""));
      return p.prefer == Prefer::soft ? a.shots[0].launch.speed : a.shots[0].path.arrival.time;
    };
    const double best = worth(solve(p, {.robustness = false}));
    p.spin_range.reset();
    for (int i = 0; i < 9; ++i)
      for (int k = 0; k < 9; ++k) {
        p.spin = {i / 8.0, k / 4.0 - 1, 0};
        INFO(prefer << ", top " << p.spin.top << ", side " << p.spin.side);
        CHECK(best <= worth(solve(p, {.all = true, .robustness = false})) * 1.001);
      }
  }
}

TEST_CASE("of all shots none is there twice: two that are tuned into one were of one family") {
  const Puzzle p = read_puzzle(
      R"({"table": "pool-9ft", "ball": {"at": [0.6, 0.5]}, "target": {"pocket": "top-right"}, "cushions": 2})");
  const Answer a = solve(p, {.all = true});
  REQUIRE(a.shots.size() > 1);
  for (std::size_t i = 0; i < a.shots.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      CHECK(std::abs(a.shots[i].launch.angle - a.shots[k].launch.angle) > radians(0.01));
  CHECK_THAT(a.message, Catch::Contains(std::to_string(a.shots.size()) + " distinct shots"));
}

TEST_CASE("margin and chance of a free spin are the shot's own") {
  int shots = 0;
  for (const char* prefer : {"robust", "soft", "quick"})
    for (const char* aim : {"centre", "safest"}) {
      const Puzzle p = read(
          std::string(
              R"(, "spin": {"top": [0.3, 1], "side": [-0.8, 0.5]}}, "target": {"point": [1.9, 0.9]}, "cushions": 1, "arrive": {"speed": [0.5, 2]}, "prefer": ")") +
          prefer + R"(", "aim": ")" + aim + "\"}");
      const Answer a = solve(p);
      REQUIRE(a.status == Status::solved);
      CHECK(*a.shots[0].robustness.success > 0);
      INFO(prefer << ", " << aim);
      test::check_claims(p, a);
      ++shots;
    }
  CHECK(shots == 6);
}

TEST_CASE("spin is used where nothing works without") {
  // Straight at the cushion and back: only side spin makes it leave at an angle.
  Puzzle p =
      read(R"(, "spin": {"side": [-1, 1]}}, "target": {"point": [0.75, 0.635], "within": 0.001}, "cushions": ["top"],
                  "arrive": {"speed": [0.2, 5]}, "angle": [89.9, 90.1]})");
  const Answer a = solve(p, {.robustness = false});
  INFO(a.message);
  REQUIRE(a.status == Status::solved);
  CHECK(a.shots[0].spin.side != 0);
  CHECK_THAT(test::check_shot(p, a.shots[0]).problem, Catch::Equals(""));
}

TEST_CASE("of a range of arrival speeds one that can be reached is found") {
  // No launch up to 3 m/s arrives at 6 m/s, and none with that bound arrives at 5 m/s.
  for (const char* prefer : {"robust", "soft", "quick"}) {
    const Puzzle p = read(
        std::string(
            R"(}, "target": {"point": [1.9, 0.9]}, "cushions": 1, "speed": [2, 3], "arrive": {"speed": [0.5, 6]}, "prefer": ")") +
        prefer + "\"}");
    const Answer a = solve(p, {.robustness = false});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(a.shots[0].verification.miss < 1e-9);
    CHECK(p.arrive->contains(a.shots[0].path.arrival.speed));
  }
}

TEST_CASE("the safest launch is made and no less likely than the centred one") {
  Puzzle p = read(R"(}, "target": {"pocket": "top-right"}, "cushions": ["bottom"], "arrive": {"speed": 0.3}})");
  const Answer centred = solve(p);
  p.aim = Aim::safest;
  const Answer safest = solve(p);
  REQUIRE(centred.status == Status::solved);
  REQUIRE(safest.status == Status::solved);
  CHECK(*safest.shots[0].robustness.success >= *centred.shots[0].robustness.success);
  CHECK(safest.shots[0].path.cushions == centred.shots[0].path.cushions);
  CHECK(safest.shots[0].verification.miss < p.table.pockets[5].radius);
}

TEST_CASE("a no-shot says what would open it") {
  const auto hint = [](const std::string& more) {
    const Answer a = solve(read(more));
    CHECK(a.status == Status::no_shot);
    return a.message;
  };
  CHECK_THAT(hint(R"(}, "target": {"point": [1.9, 0.9]}, "cushions": 2, "speed": [0.1, 0.5]})"),
             Catch::Contains("m/s would do it"));
  CHECK_THAT(hint(R"(}, "target": {"point": [1.9, 0.9]}, "cushions": 0, "angle": [90, 100]})"),
             Catch::Contains("an aim of"));
  CHECK_THAT(hint(R"(}, "target": {"point": [1.9, 0.9]}, "cushions": ["top", "top", "top", "top"]})"),
             Catch::Contains("there is a shot with"));
}

TEST_CASE("a no-shot names the bound of the speed, from either side") {
  const auto message = [](const std::string& rest) {
    const Answer a = solve(read(R"(}, "target": {"point": [1.9, 0.9]}, )" + rest));
    CHECK(a.status == Status::no_shot);
    return a.message;
  };
  CHECK_THAT(message(R"("cushions": 5, "speed": [0.1, 1]})"), Catch::Contains("would do it, and the bound is 1 m/s"));
  CHECK_THAT(message(R"("cushions": 2, "speed": [8, 9], "arrive": {"speed": 0.3}})"),
             Catch::Contains("would do it, and the bound is 8 m/s") && !Catch::Contains("no path has the cushions"));
}

TEST_CASE("in ideal physics the ball keeps the speed that is asked at its target") {
  const auto with = [](const std::string& rest) {
    return read(R"(}, "physics": "ideal", "target": {"point": [1.9, 0.9]}, "cushions": 1, )" + rest + "}");
  };
  const auto speed = [&](const std::string& rest) {
    const Answer a = solve(with(rest));
    REQUIRE(a.status == Status::solved);
    return a.shots[0].launch.speed;
  };
  CHECK(speed(R"("arrive": {"speed": 0.5})") == 0.5);
  CHECK(speed(R"("arrive": {"speed": [2, 3]})") == 2);
  CHECK(speed(R"("arrive": {"speed": [0, 3]})") == 1);
  CHECK(speed(R"("arrive": {"speed": [2, 5]}, "speed": [3, 9])") == 3);
  CHECK(speed(R"("speed": 4)") == 4);
  CHECK_THROWS_WITH(solve(with(R"("arrive": {"speed": 0})")), Catch::Contains("no ball comes to rest"));
  CHECK_THROWS_WITH(solve(with(R"("arrive": {"speed": 2}, "speed": [3, 9])")), Catch::Contains("keeps its speed"));
}

TEST_CASE("puzzles with friction that grows with speed are solved") {
  const Puzzle p = read(R"(}, "physics": {"model": "spin", "rolling_friction": {"at_rest": 0.008, "per_speed": 0.004}},
                        "target": {"point": [1.9, 0.9]}, "cushions": 2})");
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  CHECK_THAT(test::check_shot(p, a.shots[0]).problem, Catch::Equals(""));
  CHECK(a.shots[0].verification.miss < 1e-9);
}

TEST_CASE("a shot that scratches is chosen only where no other is found") {
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "physics": "ideal", "ball": {"at": [2.145, 0.591]},
    "others": [{"id": "1", "at": [0.331, 0.36]}],
    "target": {"ball": "1", "then": {"pocket": "bottom-right", "cushions": {"max": 1}}}})");
  const Answer best = solve(p), all = solve(p, {.all = true});
  REQUIRE(best.status == Status::solved);
  const auto scratches = [](const Shot& shot) { return shot.path.scratch; };
  CHECK(std::ranges::any_of(all.shots, scratches));
  CHECK(!scratches(all.shots.front()));
  CHECK(!scratches(best.shots.front()));
  CHECK(*best.shots.front().robustness.value >= *all.shots.front().robustness.value - 1e-9);
}

TEST_CASE("a search does not end at a shot that scratches, where more cushions lead to one that does not") {
  const Puzzle p = read_puzzle(R"({"table": "pool-9ft", "physics": "ideal", "ball": {"at": [1.655, 0.493]},
    "others": [{"id": "1", "at": [2.166, 0.93]}], "cushions": {"max": 1},
    "target": {"ball": "1", "then": {"pocket": "top-right", "cushions": {"max": 2}}}})");
  const Answer best = solve(p), all = solve(p, {.all = true});
  REQUIRE((best.status == Status::solved && all.status == Status::solved));
  CHECK((!best.shots.front().path.scratch && !all.shots.front().path.scratch));
  CHECK(*best.shots.front().robustness.value == Approx(*all.shots.front().robustness.value).margin(0.005));
}
