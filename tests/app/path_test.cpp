// SPDX-License-Identifier: MIT
//
// Input and output beside a puzzle and its shots: points of the path, `about`, packed files.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using namespace bankshot::test;
using Catch::Contains;
using Json = nlohmann::json;

const char* const bank = R"({"id": "bank", "table": "pool-9ft", "ball": {"at": [0.635, 0.4]},
  "target": {"pocket": "bottom-middle"}, "cushions": 2, "about": {"title": "Two rails", "by": ["A", 1.5, null]}})";
Json one_line(const std::string& text) { return Json::parse(text); }
std::string compact(const char* puzzle) { return nlohmann::ordered_json::parse(puzzle).dump() + "\n"; }

std::vector<std::vector<std::string>> rows(const std::string& csv) {
  std::vector<std::vector<std::string>> out;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    out.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) out.back().push_back(field);
  }
  return out;
}

}  // namespace

TEST_CASE("option --path: each shot has its path, from the ball to the target, 60 points a second and every bounce") {
  const Json plain = one_line(run_program("solve --json --all", bank).out);
  const Json answer = one_line(run_program("solve --json --all --path", bank).out);
  REQUIRE(answer.at("shots").size() > 1);
  for (const Json& shot : answer["shots"]) {
    const Json& path = shot.at("path");
    CHECK(path.front() == Json{0, 0.635, 0.4});
    CHECK(path.back()[0].get<double>() == Approx(shot["arrival"]["time"].get<double>()));
    CHECK(path.back()[1].get<double>() == Approx(shot["arrival"]["at"][0].get<double>()));
    CHECK(path.back()[2].get<double>() == Approx(shot["arrival"]["at"][1].get<double>()));
    for (std::size_t i = 1; i < path.size(); ++i) {
      CHECK(path[i] != path[i - 1]);
      CHECK(path[i][0] >= path[i - 1][0]);
      CHECK(path[i][0].get<double>() - path[i - 1][0].get<double>() < 1 / 60. + 1e-9);
    }
  }
  CHECK(!plain["shots"][0].contains("path"));
  CHECK(!one_line(run_program("solve --json --path --budget 0", bank).out).contains("path"));
  const std::string line = run_program("batch - --path --quiet --no-timing", compact(bank)).out;
  CHECK(line == run_program("solve --json --path --no-timing", bank).out);
}

TEST_CASE("option --path: other balls that move have their paths, too") {
  const std::string pot = R"({"table": "pool-9ft", "ball": {"at": [0.635, 0.4]}, "others": [{"id": "8 \"ball\"",
    "at": [1.6, 0.7]}, {"id": "9", "at": [2.0, 0.3]}], "target": {"ball": "8 \"ball\"", "then": {"pocket": "any"}},
    "cushions": 0})";
  const Json shot = one_line(run_program("solve --json --path", pot).out).at("shots").at(0);
  const Json& sent = shot.at("paths").at("8 \"ball\"");
  CHECK(shot["paths"].size() == 1);
  CHECK(sent.front() == Json{0, 1.6, 0.7});
  CHECK(sent.back()[0].get<double>() == Approx(shot["arrival"]["time"].get<double>()));
  CHECK(sent.back()[1].get<double>() == Approx(shot["arrival"]["at"][0].get<double>()));
  CHECK(!one_line(run_program("solve --json --path", bank).out)["shots"][0].contains("paths"));
}

TEST_CASE("solve --csv: the path as a table, in a file or in the text's place") {
  const ScratchFile file("solve-path.csv");
  CHECK_THAT(run_program("solve --csv \"" + file.path + "\"", bank).out, Catch::StartsWith("solved: "));
  CHECK(run_program("solve --csv -", bank).out == file.text());
  const auto table = rows(file.text());
  CHECK(table[0] == std::vector<std::string>{"t", "ball", "x", "y", "vx", "vy", "wx", "wy", "wz"});
  const Json path = one_line(run_program("solve --json --path", bank).out)["shots"][0]["path"];
  CHECK(table.size() >= path.size());
  CHECK(std::stod(table.back()[2]) == path.back()[1].get<double>());

  const auto all = rows(run_program("solve --all --csv -", bank).out);
  CHECK(all[0].back() == "shot");
  CHECK(all[1].back() == "1");
  CHECK(std::stoul(all.back().back()) == one_line(run_program("solve --all --json", bank).out)["shots"].size());
  const Run both = run_program("solve --json --csv -", bank);
  CHECK(both.exit == 2);
  CHECK_THAT(both.err, Contains("both go to standard output"));
}

TEST_CASE("simulate plays a puzzle with a shot of its answer, and reads nothing else of it") {
  for (const char* physics : {"spin", "rolling", "ideal"}) {
    INFO(physics);
    Json puzzle = Json::parse(bank);
    puzzle["physics"] = physics;
    if (physics == std::string("spin")) puzzle["ball"]["spin"] = {{"side", {-0.5, 0.5}}};
    const Json answer = one_line(run_program("solve --json --path", puzzle.dump()).out);
    REQUIRE(answer["status"] == "solved");
    const Json& shot = answer["shots"][0];
    puzzle["shot"] = shot;
    puzzle["arrive"] = "whenever";  // not read
    const Run run = run_program("simulate --json", puzzle.dump());
    REQUIRE(run.exit == 0);
    const Json played = one_line(run.out);
    std::vector<std::string> met;
    for (const Json& e : played["events"])
      if (e["type"] == "cushion" && met.size() < shot["cushions"].size()) met.push_back(e["cushion"]);
    CHECK(Json(met) == shot["cushions"]);
    CHECK(played["end"]["reason"] == "pocketed");
    CHECK(played["end"]["time"].get<double>() == Approx(shot["arrival"]["time"].get<double>()));
    puzzle["shot"]["colour"] = 1;
    CHECK_THAT(run_program("simulate", puzzle.dump()).err, Contains("/shot/colour: this key is unknown"));
  }
}

TEST_CASE("simulate --csv - prints the path in the text's place") {
  const char* shot =
      R"({"table": "seed", "physics": "rolling", "ball": {"at": [0.5, 0.5]}, "shot": {"speed": 1, "angle": 20}})";
  const ScratchFile file("simulate-path.csv");
  CHECK(run_program("simulate --csv \"" + file.path + "\"", shot).exit == 0);
  const Run run = run_program("simulate --csv -", shot);
  CHECK(run.exit == 0);
  CHECK(run.out == file.text());
  CHECK(rows(run.out).size() > 60);
  CHECK(run_program("simulate --csv - --json", shot).exit == 2);
}

TEST_CASE("about comes back as it went in, whatever the answer is") {
  const Json about = Json::parse(bank)["about"];
  CHECK(one_line(run_program("solve --json", bank).out).at("about") == about);
  CHECK(one_line(run_program("solve --json --budget 0", bank).out).at("about") == about);
  Json bad = Json::parse(bank);
  bad["cushions"] = "many";
  CHECK(one_line(run_program("solve --json", bad.dump()).out).at("about") == about);
  CHECK(one_line(run_program("batch - --quiet", bad.dump()).out).at("about") == about);
  for (const char* value : {"null", "1e3", "\"a \\\"quoted\\\" title\"", "[]", "{\"status\":\"invalid\"}"}) {
    Json puzzle = Json::parse(bank);
    puzzle["about"] = Json::parse(value);
    CHECK(one_line(run_program("solve --json", puzzle.dump()).out).at("about") == puzzle["about"]);
  }
}

TEST_CASE("generate says how hard a puzzle is") {
  const auto run = run_program("generate --count 3 --seed 3 --physics rolling --difficulty hard");
  std::istringstream lines(run.out);
  int n = 0;
  for (std::string line; std::getline(lines, line); ++n)
    CHECK(one_line(line).at("about") == Json{{"difficulty", "hard"}});
  CHECK(n == 3);
}

TEST_CASE("files are packed and unpacked by their suffix in every command") {
  const ScratchFile puzzle("p.json.gz"), puzzles("p.jsonl.gz"), shots("s.jsonl.gz"), csv("c.csv.gz"), svg("p.svg.gz"),
      map("m.csv.gz"), html("b.html.gz"), made("g.jsonl.gz");
  const auto run = [&](std::string commands) {
    const std::pair<std::string, const ScratchFile&> names[] = {
        {"P.jsonl", puzzles}, {"P.json", puzzle}, {"S.jsonl", shots}, {"C.csv", csv},
        {"P.svg", svg},       {"M.csv", map},     {"B.html", html},   {"G.jsonl", made}};
    for (const auto& [name, file] : names)
      for (std::size_t at = 0; (at = commands.find(name, at)) != std::string::npos; at += file.path.size())
        commands.replace(at, name.size(), file.path);
    return run_shell(commands, compact(bank));
  };
  CHECK(run("gzip -c >P.json; PROGRAM solve P.json --csv C.csv --svg P.svg").exit == 0);
  CHECK_THAT(run("gunzip -c C.csv").out, Catch::StartsWith("t,ball,x"));
  CHECK_THAT(run("gunzip -c P.svg").out, Contains("<svg"));
  CHECK(run("gunzip -c P.json P.json | gzip -c >P.jsonl; PROGRAM batch P.jsonl -o S.jsonl --quiet").exit == 0);
  const Run verified = run("PROGRAM verify P.jsonl S.jsonl");
  CHECK(verified.exit == 0);
  CHECK_THAT(verified.out, Contains("2 answers: 2 solved"));
  CHECK(run("PROGRAM map P.json --grid 2 2 -o M.csv --no-robustness").exit == 0);
  CHECK_THAT(run("gunzip -c M.csv").out, Catch::StartsWith("x_m,y_m"));
  CHECK(run("PROGRAM book P.jsonl -o B.html").exit == 0);
  CHECK_THAT(run("gunzip -c B.html").out, Catch::StartsWith("<!DOCTYPE html>"));
  CHECK(run("PROGRAM generate --count 70 --seed 5 --physics rolling -o G.jsonl").exit == 0);
  CHECK(run("gunzip -c G.jsonl").out == run_program("generate --count 70 --seed 5 --physics rolling").out);
  const Run cut = run("head -c 60 P.jsonl >S.jsonl; PROGRAM verify P.jsonl S.jsonl");
  CHECK(cut.exit == 2);
  CHECK_THAT(cut.err, Contains("cannot be read"));
}

TEST_CASE("batch --strict ends with 1 when a line was invalid, also where it is resumed") {
  const ScratchFile out("strict.jsonl");
  const std::string good = compact(bank), bad = "{}\n";
  CHECK(run_program("batch - --quiet", good + bad).exit == 0);
  CHECK(run_program("batch - --quiet --strict", good + good).exit == 0);
  const Run strict = run_program("batch - --quiet --strict", good + bad);
  CHECK(strict.exit == 1);
  CHECK(std::count(strict.out.begin(), strict.out.end(), '\n') == 2);
  const std::string whole = "batch - --quiet --strict --resume -o \"" + out.path + "\"";
  CHECK(run_program(whole, bad + good).exit == 1);
  CHECK(run_program(whole, bad + good).exit == 1);  // is whole already
}
