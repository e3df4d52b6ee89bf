// SPDX-License-Identifier: MIT
//
// `play` as typed in a shell: a layout needs no target, and the options choose the game.
#include <nlohmann/json.hpp>

#include "app/layout.hpp"
#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::Run;
using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Json = nlohmann::json;

const char* const layout =
    R"({"table": "pool-9ft", "ball": {"at": [0.7, 0.5]}, "noise": {"angle": 0.125, "speed": 0.075},
  "others": [{"id": "9", "at": [1.6, 0.9]}, {"id": "2", "at": [2.2, 0.4]}, {"id": "8", "at": [0.5, 1.0]}]})";

std::string first_ball(const std::string& options) {
  const Run run = run_program("play --json --depth 1 " + options, layout);
  CAPTURE(options, run.err);
  CHECK(run.exit == 0);
  return Json::parse(run.out)["shots"][0]["then"]["ball"];
}

}  // namespace

TEST_CASE("a layout becomes a puzzle: the game asked for, else its own target, else rotation") {
  const auto target = [](const char* text, const std::optional<Json>& game) {
    return Json::parse(bankshot::app::as_puzzle(text, game))["target"];
  };
  const Json any{{"game", "any"}}, eight{{"game", "eight"}};
  CHECK(target(R"({"budget": 1})", std::nullopt) == Json{{"game", "rotation"}});
  CHECK(target(R"({"target": {"game": "any"}})", std::nullopt) == any);
  CHECK(target(R"({"target": {"game": "any"}})", eight) == eight);
  CHECK(bankshot::app::as_puzzle("[1]", eight) == "[1]");
}

TEST_CASE("play: the game decides which ball is potted") {
  CHECK(first_ball("") == "2");
  CHECK(first_ball("--game rotation") == "2");
  CHECK(first_ball("--group stripes") == "9");
  CHECK(first_ball("--game eight --group solids") == "2");
  CHECK(first_ball("--order 8,2,9") == "8");
}

TEST_CASE("play: text, picture and JSON tell the shots after the first", "[heavy]") {
  const ScratchFile svg("plan.svg");
  const Run text = run_program("play --svg \"" + svg.path + "\"", layout);
  CHECK(text.exit == 0);
  CHECK_THAT(text.out, !Contains("\n  next ") && Contains("\n  then ") && Contains("\n  clears    the table in ") &&
                           Contains("\n  leave "));
  CHECK_THAT(svg.text(), Contains("the table in "));
  const Json a = Json::parse(run_program("play --json", layout).out), plan = a["plan"];
  REQUIRE(plan["next"].size() == 2);
  CHECK(plan["next"][0]["ball"] == "8");
  CHECK(plan["next"][1]["ball"] == "9");
  CHECK(plan["table"] == true);
  CHECK(plan["clears"].size() == 3);
  CHECK(plan["clears"][0] == a["shots"][0]["success"]);
  CHECK(plan["clears"][1] == a["shots"][0]["leave"]["success"]);
  CHECK(a["shots"][0]["leave"]["next"]["ball"] == "8");
  const Json shorter = Json::parse(run_program("play --json --depth 1", layout).out);
  CHECK(shorter["plan"]["next"].empty());
  CHECK(shorter["shots"] == a["shots"]);
}

TEST_CASE("play: what a game lacks is said with its place") {
  const Run no_group = run_program("play --game eight", layout);
  CHECK(no_group.exit == 2);
  CHECK_THAT(no_group.err, Contains("/target/group"));
  const Run no_ball = run_program("play --order 7,2", layout);
  CHECK(no_ball.exit == 2);
  CHECK_THAT(no_ball.err, Contains("/target/order/0") && Contains("\"7\""));
  const Run no_game = run_program("play --game golf", layout);
  CHECK(no_game.exit == 2);
  CHECK_THAT(no_game.err, Contains("golf"));
  const Run broken = run_program("play", "{\n\"table\": \n");
  CHECK(broken.exit == 2);
  CHECK_THAT(broken.err, Contains("3:"));
}
