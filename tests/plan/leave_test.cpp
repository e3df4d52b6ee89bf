// SPDX-License-Identifier: MIT
//
// The place where the cue ball rests after the shot, and shots chosen by it.
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

Puzzle pot(const std::string& prefer) {
  return read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.8, 0.5]}, "prefer": )" + prefer + R"(,
    "others": [{"id": "8", "at": [1.5, 0.7]}], "cushions": {"max": 1},
    "target": {"ball": "8", "then": {"pocket": "any", "cushions": {"max": 1}}}})");
}

}  // namespace

TEST_CASE("where the cue ball rests is where the simulation of all balls leaves it") {
  const Puzzle p = pot(R"("robust")");
  int resting = 0;
  for (const Shot& s : solve(p, {.all = true}).shots) {
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, s.launch, s.spin, {}});
    const Record& end = end_of(t, 0);
    const bool fell =
        std::ranges::any_of(t.events, [](const Record& e) { return e.kind == EventKind::pocket && e.ball == 0; });
    CHECK(s.path.scratch == fell);
    CHECK(s.path.cue_rests.has_value() == !fell);
    if (s.path.cue_rests) CHECK(norm(*s.path.cue_rests - end.state.at) < 1e-9);
    resting += s.path.cue_rests.has_value();
  }
  CHECK(resting > 3);
}

TEST_CASE("of shots that are as likely the one is chosen that leaves the cue ball best", "[heavy]") {
  const Vec2d leave = GENERATE(Vec2d{2.2, 0.3}, Vec2d{0.4, 1.0}, Vec2d{1.2, 0.2});
  const std::string keys = "{\"leave\": [" + std::to_string(leave.x) + ", " + std::to_string(leave.y) + "]}";
  const Puzzle p = pot(keys);
  const Answer all = solve(p, {.all = true}), robust = solve(pot(R"("robust")"), {.all = true});
  REQUIRE(all.shots.size() == robust.shots.size());
  constexpr double as_likely = 0.02 + 1e-12;  // stated in docs/format.md
  const Shot& best = all.shots.front();
  CHECK(*best.robustness.value >= *robust.shots.front().robustness.value - as_likely);
  for (const Shot& s : all.shots)
    if (!s.path.scratch && *s.robustness.value >= *robust.shots.front().robustness.value - as_likely)
      CHECK(norm(*best.path.cue_rests - leave) <= norm(*s.path.cue_rests - leave) + 1e-12);
  CHECK(write_puzzle(read_puzzle(write_puzzle(p))) == write_puzzle(p));
}

TEST_CASE("a place to leave the cue ball at needs another ball to touch, and friction") {
  const auto refused = [](const std::string& text) {
    try {
      validate(read_puzzle(text));
    } catch (const InvalidInput& e) {
      return e.path;
    }
    return std::string("accepted");
  };
  const std::string scene =
      R"({"table": "pool-9ft", "ball": {"at": [0.8, 0.5]}, "others": [{"id": "8", "at": [1.5, 0.7]}], )";
  CHECK(refused(scene + R"("target": {"pocket": "any"}, "prefer": {"leave": [1, 0.5]}})") == "/prefer/leave");
  CHECK(refused(scene + R"("target": {"ball": "8"}, "physics": "ideal", "prefer": {"leave": [1, 0.5]}})") ==
        "/prefer/leave");
  CHECK(refused(scene + R"("target": {"ball": "8"}, "prefer": {"leave": [9, 0.5]}})") == "/prefer/leave");
  CHECK(refused(scene + R"("target": {"ball": "8"}, "prefer": {"lead": [1, 0.5]}})") == "/prefer/lead");
  CHECK(refused(scene + R"("target": {"ball": "8"}, "prefer": {"leave": [1, 0.5]}})") == "accepted");
}
