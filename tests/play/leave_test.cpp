// SPDX-License-Identifier: MIT
//
// Shots that leave the cue ball as a puzzle asks. The judge is the plain simulator, with draws of its own.
#include "planners/play/leave.hpp"

#include <random>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "planners/play/leave_success.hpp"
#include "planners/play/worth.hpp"
#include "support/catch.hpp"
#include "support/played.hpp"

using namespace bankshot;
using test::played;

namespace {

const std::string spins = R"("spin": {"top": [-1, 1], "side": [-0.75, 0.75]})";

Puzzle asked(const std::string& rest, const std::string& spin = spins) {
  return read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4])" + (spin.empty() ? "" : ", " + spin) +
                     R"(}, "others": [{"id": "1", "at": [1.6, 0.9]}, {"id": "2", "at": [0.9, 1.0]}], )" + rest + "}");
}

}  // namespace

TEST_CASE("with the aim `centre` the cue ball stops on the place asked for", "[heavy]") {
  const char* const place = GENERATE("[1.9, 0.4]", "[1.2, 0.9]", "[2.2, 0.8]");
  const Puzzle p = asked(
      std::string(R"("target": {"ball": "1", "pocket": "any"}, "aim": "centre", "leave": {"point": )") + place + "}");
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const Shot& shot = a.shots.front();
  REQUIRE(shot.leave);
  CHECK(shot.leave->miss < 1e-8);
  CHECK(shot.verification.miss < 1e-8);
  const auto places = played(p, shot.launch, shot.spin);
  REQUIRE(places[0]);
  CHECK(norm(*places[0] - std::get<LeavePlace>(*p.leave).at) < 1e-8);
  CHECK_FALSE(places[1]);
}

TEST_CASE("the success of a leave is that of plays which the simulator judges", "[heavy]") {
  const char* const leave =
      GENERATE(R"({"point": [1.9, 0.4], "within": 0.2})",
               R"({"polygon": [[1.5, 0.2], [2.1, 0.2], [2.1, 0.7], [1.5, 0.7]]})", R"({"for": "2"})");
  const Puzzle p = asked(std::string(R"("target": {"ball": "1", "pocket": "any"}, "cushions": 0, "leave": )") + leave);
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const Shot& shot = a.shots.front();
  REQUIRE(shot.leave);
  CHECK(shot.leave->success > 0.1);
  CHECK(shot.leave->success <= *shot.robustness.success);
  CHECK(*shot.robustness.value < shot.leave->success);
  const planning::play::LeaveWorth worth(p);
  const Pocket* const pocket = pocket_reached(p, shot);
  REQUIRE(pocket);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int plays = 3000;
  double sum = 0;
  for (int i = 0; i < plays; ++i) {
    const double speed = shot.launch.speed + p.noise.speed_at(shot.launch.speed) * normal(random);
    const Launch struck{speed, shot.launch.angle + p.noise.angle * normal(random)};
    const auto places = played(p, struck, shot.spin);
    if (!places[1] && places[2]) sum += worth({.places = places});
  }
  CHECK(shot.leave->success == Approx(sum / plays).margin(0.04));
}

TEST_CASE("a place that no launch reaches is said to be so, with the nearest rest") {
  const Puzzle p = asked(R"("target": {"ball": "1", "pocket": "top-right"}, "speed": [0.5, 1.2], "cushions": 0,
    "aim": "centre", "leave": {"point": [0.2, 0.2]})");
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  REQUIRE(a.shots.front().leave);
  const double nearest = a.shots.front().leave->miss;
  CHECK(nearest > 0.1);
  CHECK(a.message.find("no shot was found that stops the cue ball there") != std::string::npos);
}

TEST_CASE("a wider question is never answered worse: free spin leaves the cue ball no farther away") {
  const std::string rest =
      R"("target": {"ball": "1", "pocket": "any"}, "cushions": 0, "aim": "centre", "leave": {"point": [1.9, 0.4]})";
  const Answer narrow = solve(asked(rest, "")), wide = solve(asked(rest));
  REQUIRE(narrow.status == Status::solved);
  REQUIRE(wide.status == Status::solved);
  CHECK(wide.shots.front().leave->miss <= narrow.shots.front().leave->miss + 1e-9);
}

TEST_CASE("a mirrored question has the mirrored answer") {
  const Puzzle p = asked(R"("target": {"ball": "1", "pocket": "any"}, "cushions": 0, "leave": {"point": [1.9, 0.4]})");
  Puzzle m = p;
  const double width = p.table.highest().y - p.table.lowest().y;
  const auto mirror = [&](Vec2d& at) { at.y = width - at.y; };
  mirror(m.ball.at);
  for (Ball& other : m.others) mirror(other.at);
  mirror(std::get<LeavePlace>(*m.leave).at);
  const Answer a = solve(p), b = solve(m);
  REQUIRE(a.status == Status::solved);
  REQUIRE(b.status == Status::solved);
  CHECK(a.shots.front().leave->success == Approx(b.shots.front().leave->success).margin(0.05));
}

TEST_CASE("a snooker leaves no direct hit") {
  const Puzzle p = asked(R"("target": {"ball": "2"}, "cushions": 0, "leave": {"safe": ["1"]})");
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  REQUIRE(a.shots.front().leave);
  const auto places = played(p, a.shots.front().launch, a.shots.front().spin);
  REQUIRE(places[0]);
  if (a.shots.front().leave->success > 0.3) CHECK_FALSE(planning::play::can_be_hit(p, 1, places));
}

TEST_CASE("a list has every way to leave the cue ball once, best first") {
  const Puzzle p = asked(
      R"("target": {"ball": "1", "pocket": "any"}, "cushions": 0, "leave": {"point": [1.9, 0.4], "within": 0.3})");
  const Answer a = solve(p, {.all = true});
  REQUIRE(a.shots.size() > 1);
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    REQUIRE(a.shots[i].leave);
    REQUIRE(a.shots[i].robustness.margin);
    if (i > 0) CHECK(*a.shots[i].robustness.value <= *a.shots[i - 1].robustness.value);
  }
}

TEST_CASE("without robustness an answer has the leave, and neither success nor margin") {
  const Puzzle p = asked(R"("target": {"ball": "1", "pocket": "any"}, "cushions": 0, "leave": {"point": [1.9, 0.4]})");
  const Answer a = solve(p, {.robustness = false});
  REQUIRE(a.status == Status::solved);
  CHECK(a.shots.front().leave);
  CHECK_FALSE(a.shots.front().robustness.success);
  CHECK_FALSE(a.shots.front().robustness.value);
  CHECK_FALSE(a.shots.front().robustness.margin);
}

TEST_CASE("only the planner `auto` plans a leave") {
  const Puzzle p = asked(R"("target": {"ball": "1"}, "leave": {"point": [1.9, 0.4]})");
  CHECK_THROWS_AS(solve(p, {.planner = "sweep"}), InvalidInput);
}
