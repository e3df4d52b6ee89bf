// SPDX-License-Identifier: MIT
//
// Tests `advise` as typed in a shell.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::Run;
using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Json = nlohmann::json;

/// Returns a recorded attempt that was meant at 2 m/s and struck 3 % harder.
std::string attempt(int i) {
  Json shot{{"id", i},
            {"table", "pool-9ft"},
            {"physics", "spin"},
            {"ball", {{"at", {0.5 + 0.05 * i, 0.4}}}},
            {"shot", {{"speed", 2.06}, {"angle", 20 + 30 * i}}},
            {"until", {{"time", 2}}}};
  const Run run = run_program("simulate - --record 60 --noise 1 --seed " + std::to_string(i), shot.dump());
  REQUIRE(run.exit == 0);
  Json recording = Json::parse(run.out);
  recording["shot"] = {{"speed", 2}, {"angle", 20 + 30 * i}};
  return recording.dump() + "\n";
}

TEST_CASE("advise tells a player's noise and bias, and goes on after bad lines") {
  std::string lines;
  for (int i = 0; i < 8; ++i) lines += attempt(i);
  Json aimless = Json::parse(attempt(1));
  aimless.erase("shot");
  const ScratchFile attempts("attempts.jsonl"), noise("noise.json"), puzzles("puzzles.jsonl");
  attempts.write(lines + aimless.dump() + "\n" +
                 R"({"table": "pool-9ft", "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 2, "angle": 3}})" + "\n");
  const Json puzzle{
      {"id", "bank"}, {"table", "pool-9ft"}, {"ball", {{"at", {0.5, 0.5}}}}, {"target", {{"pocket", "top-right"}}}};
  puzzles.write(puzzle.dump() + "\n");
  const Run run = run_program("advise " + attempts.path + " --shots " + puzzles.path + " -o " + noise.path);
  CHECK(run.exit == 0);
  CHECK_THAT(run.err, Contains(attempts.path + ":9:"));
  CHECK_THAT(run.err, Contains("must say what was meant: \"shot\" or \"puzzle\""));
  CHECK_THAT(run.err, Contains("lines were left out"));
  CHECK_THAT(run.err, Contains("% too hard on average"));
  const Json advice = Json::parse(run.out);
  REQUIRE(advice["errors"].size() == 4);
  const Json& speed = advice["errors"][1];
  CHECK(speed["name"] == "speed");
  CHECK(speed["bias"]["mean"].get<double>() == Approx(0.03).margin(0.01));
  CHECK(advice["attempts"].size() == 8);
  CHECK(advice["attempts"][3]["id"] == 3);
  CHECK(advice["shots"][0]["id"] == "bank");
  CHECK(advice["shots"][0]["success"].get<double>() > 0);
  CHECK(Json::parse(noise.text()) == advice["noise"]);
  Json own = puzzle;
  own["noise"] = advice["noise"];
  CHECK(run_program("solve --json", own.dump()).exit == 0);
}

TEST_CASE("of an attempt it is said what is missing") {
  const ScratchFile file("attempt.jsonl");
  file.write(R"({"table": "pool-9ft", "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 2, "angle": 3}})");
  const Run unseen = run_program("advise " + file.path);
  CHECK(unseen.exit == 2);
  CHECK_THAT(unseen.err, Contains(R"(must say what happened: "track", "rest" or "made")"));
  CHECK_THAT(unseen.err, Contains("no attempt in it that can be read"));
  file.write(
      R"({"table": "pool-9ft", "ball": {"at": [0.5, 0.5]}, "made": true, "puzzle": {"table": "pool-9ft", "ball": {"at": [9, 0.5]}, "target": {"pocket": "any"}}})");
  CHECK_THAT(run_program("advise " + file.path).err, Contains("/puzzle/ball/at"));
}

}  // namespace
