// SPDX-License-Identifier: MIT
//
// The success of a shot on a table whose coefficients are uncertain.
#include <cmath>

#include "bankshot/bankshot.hpp"
#include "bankshot/scene/coefficients.hpp"
#include "support/catch.hpp"

namespace {

using namespace bankshot;

Puzzle bank() {
  return read_puzzle(
      R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "target": {"point": [1.9, 0.9], "within": 0.01},
    "cushions": ["top", "right"], "arrive": {"speed": 0.5}})");
}

TEST_CASE("what is not known of the table lowers the chance") {
  Puzzle known = bank();
  known.noise.side = 1e-9;  // makes all errors sampled, also without errors of the table
  Puzzle vague = known, exact = known;
  vague.physics.errors = {{"cushion.restitution"}, {0.03 * 0.03}};
  exact.physics.errors = {{"cushion.restitution"}, {0}};
  const Answer a = solve(known), b = solve(vague), c = solve(exact);
  REQUIRE(a.status == Status::solved);
  CHECK(a.shots[0].launch.angle == b.shots[0].launch.angle);
  CHECK(b.shots[0].robustness.success.value() < a.shots[0].robustness.success.value() - 0.05);
  CHECK(std::abs(c.shots[0].robustness.success.value() - a.shots[0].robustness.success.value()) <
        0.02);  // the draws differ
}

TEST_CASE("draws have the covariance that they are drawn from, and stay what a table can have") {
  Physics p = spin_physics();
  p.errors = {{"cushion.friction", "sliding_friction"}, {4e-4, 3e-4, 3e-4, 9e-4}};
  const DrawnPhysics drawn(p);
  REQUIRE(drawn.count() == 2);
  const auto off = [&](double first, double second) {
    const double normal[] = {first, second};
    Physics q = drawn.draw(normal, Body{});
    return Vec2d{*coefficient(q, "cushion.friction").at(0) - 0.2, *coefficient(q, "sliding_friction").at(0) - 0.2};
  };
  const Vec2d x = off(1, 0), y = off(0, 1);
  CHECK(x.x * x.x + y.x * y.x == Approx(4e-4));
  CHECK(x.x * x.y + y.x * y.y == Approx(3e-4));
  CHECK(x.y * x.y + y.y * y.y == Approx(9e-4));
  CHECK(off(-100, 0).x == Approx(-0.2));
}

TEST_CASE("a covariance that is none is refused") {
  const auto refused = [](const std::string& covariance) {
    try {
      read_scene("\"pool-9ft\"", R"({"model": "spin", "covariance": )" + covariance + "}");
    } catch (const InvalidInput& e) {
      return e.path + " " + e.what();
    }
    return std::string("read");
  };
  CHECK(refused(R"({"names": ["cushion.friction"], "matrix": [[0.01]]})") == "read");
  CHECK_THAT(refused(R"({"names": ["cushion.fiction"], "matrix": [[0.01]]})"),
             Catch::StartsWith("/physics/covariance/names/0") && Catch::Contains("did you mean \"cushion.friction\""));
  CHECK_THAT(refused(R"({"names": ["cushion.friction"], "matrix": [[-0.01]]})"), Catch::Contains("negative variance"));
  CHECK_THAT(refused(R"({"names": ["cushion.friction"], "matrix": []})"), Catch::Contains("a row for each name"));
  CHECK_THAT(refused(R"({"names": ["cushion.friction", "sliding_friction"], "matrix": [[1, 0.5], [0.4, 1]]})"),
             Catch::Contains("not symmetric"));
}

}  // namespace
