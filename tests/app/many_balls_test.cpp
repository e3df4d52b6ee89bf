// SPDX-License-Identifier: MIT
//
// Tests `simulate` with other balls on the table, as typed in a shell.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::Run;
using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Json = nlohmann::json;

/// Ball 8 is sent into the corner and the other ball does not move; "a,b" is a name that CSV must quote.
const std::string potted = R"({"table": "pool-9ft", "physics": "spin", "ball": {"at": [2.0, 0.8], "spin": {"top": 0.2}},
  "others": [{"id": "8", "at": [2.3, 1.05]}, {"id": "a,b", "at": [0.5, 0.5], "radius": 0.03, "mass": 0.2}],
  "shot": {"speed": 1.5, "angle": 39.5}, "until": {"time": 30}})";

TEST_CASE("simulate tells of every ball: text, events, rows and a picture") {
  const ScratchFile svg("potted.svg");
  const Run text = run_program("simulate --svg " + svg.path, potted);
  REQUIRE(text.exit == 0);
  CHECK_THAT(text.out, Contains("cue  launch") && Contains("cue  ball 8") && Contains("8    pocket top-right") &&
                           Contains("8 falls into top-right.") && Contains("1 of 2 other balls moved."));
  CHECK_THAT(text.out, !Contains("a,b  launch"));
  CHECK_THAT(svg.text(), Contains("8 in top-right") && Contains(">8</text>"));

  const Json all = Json::parse(run_program("simulate --json", potted).out);
  std::multiset<std::string> starts, ends;
  int meetings = 0;
  double before = 0;
  for (const Json& e : all["events"]) {
    CHECK(e["time"].get<double>() >= before);
    before = e["time"];
    if (e["type"] == "start") starts.insert(e["ball"]);
    if (e["type"] == "end") ends.insert(e["ball"]);
    if (e["type"] != "ball") continue;
    ++meetings;
    CHECK(e["ball"] == "cue");
    CHECK(e["other"]["ball"] == "8");
    for (const char* key : {"at", "velocity", "spin"}) CHECK(e["other"].contains(key));
  }
  CHECK(meetings == 1);
  CHECK(starts == std::multiset<std::string>{"8", "a,b", "cue"});
  CHECK(ends == starts);
  CHECK(all["end"]["reason"] == "rest");
  CHECK(all["energy"]["end"].get<double>() < 1e-6);

  std::istringstream rows(run_program("simulate --csv - --rate 10", potted).out);
  std::string row;
  int quoted = 0, of_8 = 0, of_cue = 0;
  for (std::getline(rows, row); std::getline(rows, row);) {
    quoted += row.find(",\"a,b\",0.5,0.5,") != std::string::npos;
    of_8 += row.find(",8,") != std::string::npos;
    of_cue += row.find(",cue,") != std::string::npos;
  }
  CHECK(quoted > 20);
  CHECK(of_8 > 5);
  CHECK(of_8 < of_cue);  // ball 8 fell
}

TEST_CASE("simulate: until is the cue ball's, and stops all") {
  const auto ended = [](const std::string& until) {
    Json shot = Json::parse(potted);
    shot["until"] = Json::parse(until);
    return Json::parse(run_program("simulate --json", shot.dump()).out);
  };
  CHECK(ended(R"({"time": 0.1})")["end"]["time"] == 0.1);
  const Json length = ended(R"({"length": 0.5})");
  CHECK(length["end"]["reason"] == "until");
  CHECK(length["end"]["length"].get<double>() == Approx(0.5).epsilon(1e-12));
  const Json past = ended(R"({"time": 100})");
  CHECK(past["end"]["reason"] == "rest");
  CHECK(past["end"]["time"].get<double>() < 30);
  Json away = Json::parse(potted);
  away["shot"]["angle"] = 200;
  away["until"] = {{"cushions", 1}};
  const Json cushion = Json::parse(run_program("simulate --json", away.dump()).out);
  CHECK(cushion["end"]["cushions"] == 1);
  CHECK(cushion["events"].back()["type"] == "end");
}

TEST_CASE("simulate: what is wrong with other balls is told with its place") {
  const auto complaint = [](const std::string& others) {
    Json shot = Json::parse(potted);
    shot["others"] = Json::parse(others);
    const Run run = run_program("simulate", shot.dump());
    CHECK(run.exit == 2);
    return run.err;
  };
  CHECK_THAT(complaint(R"([{"id": "1", "at": [2.02, 0.8]}])"),
             Contains("/others/0/at") && Contains("overlaps ball \"cue\""));
  CHECK_THAT(complaint(R"([{"id": "1", "at": [1, 1]}, {"id": "1", "at": [1, 0.5]}])"), Contains("/others/1/id"));
  CHECK_THAT(complaint(R"([{"id": "cue", "at": [1, 1]}])"), Contains("/others/0/id"));
  CHECK_THAT(complaint(R"([{"id": "1", "at": [1, 1], "radius": 0}])"), Contains("/others/0/radius"));
  CHECK_THAT(complaint(R"([{"id": "1", "at": [1, 9]}])"), Contains("/others/0/at") && Contains("inside the table"));
  CHECK_THAT(complaint(R"([{"at": [1, 1]}])"), Contains("/others/0") && Contains("id"));
}

}  // namespace
