// SPDX-License-Identifier: MIT
//
// Other balls as obstacles: shots past them are found and are correct, and the message says why there is none.
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/found_again.hpp"

using namespace bankshot;

namespace {

Answer solved(const std::string& keys, const SolveOptions& options = {}) {
  return solve(read_puzzle(R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, )" + keys + "}"), options);
}

}  // namespace

TEST_CASE("a shot past other balls is found, and touches none", "[heavy]") {
  const auto [model, count] = GENERATE(table<test::Model, int>(
      {{test::Model::ideal, 300}, {test::Model::rolling, 300}, {test::Model::spin, 150}, {test::Model::mathavan, 30}}));
  const test::FoundAgain found = test::find_again("obstacles", model, count, 41, 10);
  CAPTURE(found.unsolved);
  CHECK(found.unsolved.empty());
}

TEST_CASE("balls away from the path change nothing") {
  const Answer alone = solved(R"("target": {"pocket": "top-right"}, "cushions": ["bottom"])"),
               among = solved(R"("target": {"pocket": "top-right"}, "cushions": ["bottom"],
                                 "others": [{"id": "8", "at": [0.2, 1]}, {"id": "9", "at": [1, 1.1]}])");
  REQUIRE(among.status == Status::solved);
  CHECK(among.shots.front().launch.angle == alone.shots.front().launch.angle);
  CHECK(among.shots.front().launch.speed == alone.shots.front().launch.speed);
  CHECK(among.shots.front().robustness.success == alone.shots.front().robustness.success);
  CHECK(among.simulations == alone.simulations);
  CHECK(among.modelled.back() == "balls");
}

TEST_CASE("a ball in the way is named, and that its absence would open the shot") {
  const Answer a = solved(R"("target": {"point": [1.9, 0.4]}, "cushions": 0,
                             "others": [{"id": "9", "at": [2, 0.9]}, {"id": "8", "at": [1, 0.4]}])");
  CHECK(a.status == Status::no_shot);
  CHECK(a.message.find(R"(it runs into ball "8" first)") != std::string::npos);
  CHECK(a.message.find(R"(without ball "8" there is a shot)") != std::string::npos);
  CHECK(a.message.find("certified") == std::string::npos);
}

TEST_CASE("a ball on the target is said to cover it") {
  const Answer a =
      solved(R"("target": {"point": [1.9, 0.4]}, "others": [{"id": "8", "at": [1.87, 0.42]}], "physics": "rolling")");
  CHECK(a.status == Status::no_shot);
  CHECK(a.message.find(R"(certified: ball "8" covers the target)") != std::string::npos);
  CHECK(a.simulations == 0);
}

TEST_CASE("where a ball hides the middle of a pocket the ball goes in beside it") {
  for (const char* physics : {"ideal", "rolling", "spin"}) {
    CAPTURE(physics);
    const Answer a = solved(R"("target": {"pocket": "top-middle"}, "cushions": 0, "aim": "centre", "physics": ")" +
                            std::string(physics) + R"(", "others": [{"id": "1", "at": [1.0082, 0.8383]}])");
    REQUIRE(a.status == Status::solved);
    CHECK(a.shots.front().verification.off_centre);
    CHECK(a.message.find(R"(it runs into ball "1" first)") != std::string::npos);
  }
}

TEST_CASE("a ball that touches another may leave it, and not drive into it") {
  const std::string touching = R"("others": [{"id": "1", "at": [0.69215, 0.4]}], "target": {"point": )";
  CHECK(solved(touching + R"([0.3, 0.4]}, "cushions": 0)").status == Status::solved);
  CHECK(solved(touching + R"([0.635, 0.9]}, "cushions": 0)").status == Status::solved);
  CHECK(solved(touching + R"([1.2, 0.4]}, "cushions": 0)").status == Status::no_shot);
}
