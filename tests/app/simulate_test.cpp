// SPDX-License-Identifier: MIT
//
// Tests `simulate` as typed in a shell, and the program's messages about itself.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Json = nlohmann::json;

/// The ball goes along a table of 2 × 1 m at 1 m/s and meets the right cushion after 1.5 s.
const char* const along = R"({"id": 3, "table": {"length": 2, "width": 1}, "physics": "ideal",
  "ball": {"at": [0.5, 0.1], "radius": 0}, "shot": {"speed": 1, "angle": 0}, "until": {"time": 2}})";

/// The ball rolls to rest: 0.5 · 1² / (0.01 · 9.81) is longer than the table, so it bounces.
const char* const rolling = R"({"table": {"length": 2, "width": 1}, "physics": "rolling",
  "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 1, "angle": 0}})";

}  // namespace

TEST_CASE("simulate lists the events in words") {
  const auto run = run_program("simulate", along);
  CHECK(run.exit == 0);
  CHECK(run.err.empty());
  CHECK_THAT(run.out, Contains("launch") && Contains("cushion right") && Contains("at (2.0000, 0.1000) m") &&
                          Contains("after 1 cushion and 2.0000 m."));
  CHECK_THAT(run_program("simulate", rolling).out, Contains("comes to rest"));
}

TEST_CASE("simulate --json prints states right after each event") {
  const auto run = run_program("simulate - --json", along);
  CHECK(run.exit == 0);
  CHECK(run.out.find('\n') == run.out.size() - 1);
  const Json a = Json::parse(run.out);
  CHECK(a.at("id") == 3);
  REQUIRE(a.at("events").size() == 3);
  const Json bounce = a["events"][1];
  CHECK(a["events"][0].at("type") == "start");
  CHECK(bounce.at("type") == "cushion");
  CHECK(bounce.at("cushion") == "right");
  CHECK(bounce.at("ball") == "cue");
  CHECK(bounce.at("time") == 1.5);
  CHECK(bounce.at("at") == Json{2, 0.1});
  CHECK(bounce.at("velocity") == Json{-1, 0});
  CHECK(bounce.at("spin").size() == 3);
  CHECK(a["events"][2].at("type") == "end");
  CHECK(a.at("end").at("reason") == "until");
  CHECK(a.at("energy").at("start") == a.at("energy").at("end"));
  CHECK_THAT(run.out, Contains("\"at\":[0.5,0.1],\"velocity\":[1,0]"));  // shortest decimals
}

TEST_CASE("a rolling ball loses its energy and rests") {
  const Json a = Json::parse(run_program("simulate --json", rolling).out);
  CHECK(a.at("end").at("reason") == "rest");
  CHECK(a.at("energy").at("start") == Approx(0.5 * 0.170097 * 1.4));  // 7/10 m v²
  CHECK(a.at("energy").at("end") == 0);
}

TEST_CASE("an ideal ball without until stops after 100 cushions") {
  Json shot = Json::parse(along);
  shot.erase("until");
  const Json a = Json::parse(run_program("simulate --json", shot.dump()).out);
  CHECK(a.at("end").at("reason") == "until");
  CHECK(a.at("end").at("cushions") == 100);
}

TEST_CASE("option --csv writes a row at every event and every step of the rate") {
  const ScratchFile csv("shot.csv");
  CHECK(run_program("simulate --rate 4 --csv \"" + csv.path + "\"", along).exit == 0);
  std::istringstream in(csv.text());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  REQUIRE(lines.size() >= 4);
  CHECK(lines[0] == "t,ball,x,y,vx,vy,wx,wy,wz");
  CHECK(lines[1] == "0,cue,0.5,0.1,1,0,0,0,0");
  CHECK(lines[2] == "0.25,cue,0.75,0.1,1,0,0,0,0");
  CHECK(std::count(lines.begin(), lines.end(), "1.5,cue,2,0.1,-1,0,0,0,0") == 1);
  CHECK(lines.back() == "2,cue,1.5,0.1,-1,0,0,0,0");
  CHECK(lines.size() == 1 + 9);  // 0, 0.25, ..., 2; the bounce falls on a step
  for (const std::string& line : lines) CHECK(std::count(line.begin(), line.end(), ',') == 8);
}

TEST_CASE("simulate --svg draws the path") {
  const ScratchFile svg("shot.svg");
  CHECK(run_program("simulate --svg \"" + svg.path + "\"", rolling).exit == 0);
  CHECK_THAT(svg.text(), Contains("<svg ") && Catch::EndsWith("</svg>\n"));
}

TEST_CASE("bad shots are refused like bad puzzles") {
  const auto [change, path] = GENERATE(table<const char*, const char*>({
      {R"({"shot": null})", "/shot"},
      {R"({"shot": {"angle": null}})", "/shot/angle"},
      {R"({"shot": {"speed": -1}})", "/shot/speed"},
      {R"({"shot": {"spin": {"top": 0.5}}})", "/shot/spin"},
      {R"({"ball": {"spin": {"top": 1}}})", "/ball/spin"},
      {R"({"shot": {"speed": 1e200}})", "/shot/speed"},
      {R"({"shot": {"speed": 1e-200}})", "/shot/speed"},
      {R"({"until": {"tmie": 1}})", "/until/tmie"},
      {R"({"physics": "spin"})", "/ball/radius"},
  }));
  Json shot = Json::parse(along);
  shot.merge_patch(Json::parse(change));
  const auto run = run_program("simulate --json", shot.dump());
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains(path));
  const Json a = Json::parse(run.out);
  CHECK(a.at("id") == 3);
  CHECK(a.at("status") == "invalid");
  CHECK(a.at("error").at("path") == path);
}

TEST_CASE("the natural roll that answers print can be simulated without the physics spin") {
  Json shot = Json::parse(along);
  const std::string plain = run_program("simulate --json", shot.dump()).out;
  shot["shot"]["spin"] = {{"top", 1}, {"side", 0}};
  CHECK(run_program("simulate --json", shot.dump()).out == plain);
}

TEST_CASE("a table of positions that would fill the disk is refused") {
  const ScratchFile csv("path.csv");
  Json shot = Json::parse(along);
  shot["until"] = {{"time", 1e9}};
  const auto run = run_program("simulate --rate 1e6 --csv \"" + csv.path + "\"", shot.dump());
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains("--rate"));
}

TEST_CASE("option --version and --help answer on standard output") {
  const auto version = run_program("--version");
  CHECK(version.exit == 0);
  CHECK_THAT(version.out, Catch::Matches("bankshot [0-9]+\\.[0-9]+\\.[0-9]+( \\(commit [0-9a-f]+\\))?\n"));
  const auto [arguments, part] = GENERATE(table<const char*, const char*>(
      {{"--help", "solve"}, {"--help", "simulate"}, {"solve --help", "--planner"}, {"simulate --help", "--rate"}}));
  const auto help = run_program(arguments);
  CHECK(help.exit == 0);
  CHECK(help.err.empty());
  CHECK_THAT(help.out, Contains(part));
}

TEST_CASE("a ball that a dead cushion holds has a path of finite length") {
  const auto run = run_program("simulate --json", R"({"table": {"length": 2, "width": 1},
    "physics": {"model": "spin", "rolling_friction": 0, "cushion": {"model": "mirror", "restitution": 0}},
    "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 1, "angle": 10}})");
  const Json end = Json::parse(run.out).at("end");
  CHECK(end.at("reason") == "rest");
  CHECK(end.at("length").is_number());
}

TEST_CASE("a ball that stands and spins for ever rests, unless a time was given") {
  const std::string shot = R"({"table": {"length": 2, "width": 1},
    "physics": {"model": "spin", "sliding_friction": 0, "cushion": {"model": "mirror", "restitution": 0}},
    "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 1, "angle": 0, "spin": {"top": 1, "side": 0}})";
  const auto reason = [&](const std::string& until) {
    return Json::parse(run_program("simulate --json", shot + until + "}").out).at("end").at("reason");
  };
  CHECK(reason("") == "rest");
  CHECK(reason(R"(, "until": {"length": 9})") == "rest");
  CHECK(reason(R"(, "until": {"time": 9})") == "until");
}

TEST_CASE("what is too large to compute with is refused, and no number is null") {
  const std::string head = R"({"table": {"length": 2, "width": 1}, "physics": "spin", "ball": {"at": [0.5, 0.5])";
  for (const char* rest : {R"(}, "shot": {"speed": 1, "angle": 30, "spin": {"top": 1e200, "side": 0}}})",
                           R"(, "mass": 1e300}, "shot": {"speed": 1, "angle": 30}})"}) {
    const auto run = run_program("simulate --json", head + rest);
    CHECK(run.exit == 2);
    CHECK_THAT(run.err, Contains("to compute with"));
  }
  const auto tiny = run_program("simulate --json",
                                head + R"(, "radius": 1e-200, "mass": 1e-300}, "shot": {"speed": 1, "angle": 30}})");
  CHECK(tiny.exit == 0);
  CHECK_THAT(tiny.out, !Contains("null"));
}
