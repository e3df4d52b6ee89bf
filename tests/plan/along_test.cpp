// SPDX-License-Identifier: MIT
//
// Shots that begin exactly along a cushion that the ball touches. Aims slightly beside lead to other cushions.
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/replay_check.hpp"

using namespace bankshot;

namespace {

/// The ball curves into the top cushion, so that it runs along it; made from a launch at 4 m/s and 0 degrees.
constexpr const char* into_top =
    R"({"table": {"length": 2, "width": 2}, "physics": {"model": "spin", "cushion": {"model": "han2005", "height": 0.08}},
  "ball": {"at": [1, 1.9375], "radius": 0.0625, "spin": {"top": 1.0400644326852726, "side": -0.552328482749644, "masse": -0.4644164460374691}},
  "target": {"point": [0.6872873723573849, 1.2407430919580533]}, "cushions": ["right", "top", "left", "right"], "speed": [2, 8], "angle": [-0.1, 0.1]})";

/// The ball curves into the right cushion; made from a launch at 3 m/s and 90 degrees.
constexpr const char* into_right =
    R"({"table": {"length": 1, "width": 1}, "physics": {"model": "spin", "cushion": {"model": "han2005", "height": 0.08}},
  "ball": {"at": [0.9375, 0.609375], "radius": 0.0625, "spin": {"top": 0.8670364109325073, "side": -0.33211143775884944, "masse": 0.42153720507118364}},
  "target": {"point": [0.7585153545221149, 0.1017575894831163]}, "cushions": ["top", "bottom", "top", "bottom"], "speed": [1.5, 6], "angle": [89.9, 90.1]})";

}  // namespace

TEST_CASE("a shot that runs exactly along the cushion the ball touches is found") {
  for (const auto& [text, angle, speed] : {std::tuple{into_top, 0.0, 4.0}, std::tuple{into_right, 90.0, 3.0}}) {
    const Puzzle p = read_puzzle(text);
    const Answer a = solve(p, {.robustness = false, .suggest = false});
    INFO(a.message);
    REQUIRE(a.status == Status::solved);
    CHECK(degrees(a.shots[0].launch.angle) == Approx(angle).margin(1e-9));
    CHECK(a.shots[0].launch.speed == Approx(speed).epsilon(1e-9));
    CHECK(a.shots[0].verification.miss <= 1e-9 * p.table.diagonal());
    CHECK(test::check_shot(p, a.shots[0]).problem == "");
  }
}
