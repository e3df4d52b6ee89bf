// SPDX-License-Identifier: MIT
//
// Tests `fit` and `simulate --record` as typed in a shell.
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

std::string recorded(int i, const std::string& more = "") {
  const std::string shot = fmt::format(
      R"({{"id": {}, "table": "carom-10ft", "physics": {{"model": "spin", "rolling_friction": 0.008}},
  "ball": {{"at": [{}, 0.4]}}, "shot": {{"speed": {}, "angle": {}}}, "until": {{"time": 3}}}})",
      i, 0.5 + 0.1 * i, 2 + 0.2 * i, 20 + 30 * i);
  const Run run = run_program("simulate - --record 60 --noise 1 --seed " + std::to_string(i) + more, shot);
  REQUIRE(run.exit == 0);
  return run.out;
}

TEST_CASE("a recording that is simulated has as many samples as its rate says, less those dropped") {
  const Json whole = Json::parse(recorded(1)), holes = Json::parse(recorded(1, " --drop 0.5"));
  CHECK(whole["track"]["cue"].size() == 181);
  CHECK(holes["track"]["cue"].size() < 130);
  CHECK(holes["track"]["cue"].size() > 50);
  CHECK_FALSE(whole.contains("shot"));
}

TEST_CASE("fit prints a physics that every command takes, and goes on after bad lines") {
  std::string lines;
  for (int i = 0; i < 5; ++i) lines += recorded(i);
  const ScratchFile recordings("fit.jsonl"), physics("physics.json"), picture("fit.svg");
  recordings.write(lines + "{\"table\": \"carom-10ft\"}\n" + recorded(6).substr(0, 300) + "\n");
  const Run run = run_program("fit " + recordings.path + " --free rolling_friction,sliding_friction -o " +
                                  physics.path + " --svg " + picture.path,
                              "");
  CHECK(run.exit == 0);
  CHECK_THAT(run.err, Contains(recordings.path + ":6: /ball"));
  CHECK_THAT(run.err, Contains(recordings.path + ":7:"));
  CHECK_THAT(run.err, Contains("2 of 7 lines were left out"));
  const Json fit = Json::parse(run.out);
  REQUIRE(fit["parameters"].size() == 2);
  CHECK(fit["parameters"][1]["name"] == "rolling_friction");
  CHECK(fit["parameters"][1]["value"].get<double>() == Approx(0.008).epsilon(0.02));
  CHECK(fit["shots"].size() == 5);
  const std::string again = "fit " + recordings.path + " --free rolling_friction,sliding_friction --quiet -j ";
  CHECK(run_program(again + "1").out == run.out);
  CHECK(run_program(again + "3").out == run.out);
  CHECK(fit["shots"][2]["id"] == 2);
  const std::string svg = picture.text();
  CHECK_THAT(svg, Contains("A table from 5 shots") && Contains("rolling_friction"));
  std::size_t dots = 0;  // each sample on the table and below it
  for (std::size_t at = 0; (at = svg.find("r=\"2.4", at)) != std::string::npos; ++at) ++dots;
  CHECK(dots == 2 * 5 * 181);
  const Json puzzle{{"table", "carom-10ft"},
                    {"ball", {{"at", {0.5, 0.5}}}},
                    {"target", {{"point", {2, 1}}}},
                    {"physics", Json::parse(physics.text())}};
  CHECK(puzzle["physics"] == fit["physics"]);
  CHECK(run_program("solve", puzzle.dump()).exit == 0);
}

TEST_CASE("what fit cannot do is told in a line") {
  const ScratchFile empty("empty.jsonl"), one("one.jsonl");
  empty.write("");
  one.write(recorded(1));
  CHECK_THAT(run_program("fit " + empty.path, "").err, Contains("no recording in it"));
  const Run run = run_program("fit --free cushion.colour " + one.path, "");
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains("\"cushion.colour\" is nothing that this physics lets a fit move"));
}

}  // namespace
