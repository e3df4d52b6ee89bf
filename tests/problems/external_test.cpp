// SPDX-License-Identifier: MIT
//
// Published puzzles with known answers, through the command line. Each line of external.jsonl is a case: a puzzle or a
// simulation, the expected result, and the publication.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/catch.hpp"
#include "support/program.hpp"

using nlohmann::json;
using namespace bankshot;

namespace {

long count(const std::vector<std::string>& cushions, const std::string& a, const std::string& b) {
  return std::count_if(cushions.begin(), cushions.end(), [&](const auto& c) { return c == a || c == b; });
}

json run(const std::string& command, const json& document) {
  const test::Run r = test::run_program(command + " --json", document.dump());
  INFO(r.err);
  REQUIRE(r.exit == 0);
  return json::parse(r.out);
}

void best_angle(const json& c) {
  const json shot = run("solve", c["puzzle"])["shots"][0], &e = c["expect"];
  CHECK(std::abs(shot["angle"].get<double>() - e["angle"].get<double>()) <= e["tolerance"].get<double>());
  CHECK(shot["cushions"].size() == c["puzzle"]["cushions"].get<std::size_t>());
  // The path ends where the pocket captures, within 1e-9 of the diagonal before its centre.
  CHECK(shot["arrival"]["time"].get<double>() == Approx(e["path_length"].get<double>()).margin(1e-8));
}

void among_all(const json& c) {
  const json &e = c["expect"]["among_all"], shots = run("solve --all", c["puzzle"])["shots"];
  const auto fits = [&](const json& s) {
    const auto cushions = s["cushions"].get<std::vector<std::string>>();
    return std::abs(s["angle"].get<double>() - e["angle"].get<double>()) <= e["tolerance"].get<double>() &&
           count(cushions, "left", "right") == e["left+right"].get<long>() &&
           count(cushions, "top", "bottom") == e["top+bottom"].get<long>() &&
           std::abs(s["arrival"]["time"].get<double>() - e["time"].get<double>()) <= e["time_tolerance"].get<double>();
  };
  CHECK(std::count_if(shots.begin(), shots.end(), fits) == 1);
}

void every_one(const json& c) {
  json puzzle = c["puzzle"];
  puzzle["aim"] = "centre";  // as the published answers do
  const json &all = c["expect"]["all"], shots = run("solve --all", puzzle)["shots"];
  // The published pockets are points; here circles stand for them, which other shots may enter beside the middle.
  const auto centred = [](const json& s) { return !s.contains("offset"); };
  CHECK(std::count_if(shots.begin(), shots.end(), centred) == static_cast<long>(all.size()));
  for (const json& e : all) {
    const auto same = [&](const json& s) {
      return s["cushions"] == e["cushions"] &&
             std::abs(s["angle"].get<double>() - e["angle"].get<double>()) <= c["expect"]["tolerance"].get<double>();
    };
    CHECK(std::count_if(shots.begin(), shots.end(), same) == 1);
  }
}

void bounce_counts(const json& c) {
  std::vector<std::string> cushions;
  const json answer = run("simulate", c["simulate"]);
  for (const json& e : answer["events"])
    if (e["type"] == "cushion") cushions.push_back(e["cushion"]);
  CHECK(count(cushions, "left", "right") == c["expect"]["left+right"].get<long>());
  CHECK(count(cushions, "top", "bottom") == c["expect"]["top+bottom"].get<long>());
}

}  // namespace

TEST_CASE("published puzzles come out as published") {
  std::istringstream lines(test::read_repository_file("tests/problems/external.jsonl"));
  int cases = 0;
  for (std::string line; std::getline(lines, line); ++cases) {
    const json c = json::parse(line);
    INFO(c["source"]);
    if (c.contains("simulate"))
      bounce_counts(c);
    else if (c["expect"].contains("among_all"))
      among_all(c);
    else if (c["expect"].contains("all"))
      every_one(c);
    else
      best_angle(c);
  }
  CHECK(cases == 6);
}

TEST_CASE("thousands of cushions are answered, exactly") {
  for (const int n : {2056, 10005}) {
    const json puzzle{{"table", {{"length", 2.54}, {"width", 1.27}}},
                      {"physics", "ideal"},
                      {"ball", {{"at", {0.6, 0.4}}}},
                      {"target", {{"point", {1.9, 0.7}}}},
                      {"cushions", n},
                      {"prefer", "quick"}};
    const json answer = run("solve --no-robustness", puzzle), &shot = answer["shots"][0];
    CHECK(shot["cushions"].size() == static_cast<std::size_t>(n));
    CHECK(shot["miss"].get<double>() <= 1e-9 * std::hypot(2.54, 1.27));
  }
}
