// SPDX-License-Identifier: MIT
//
// `map` as typed in a shell: its rows are the answers of `solve` from those places, and its picture has a cell for
// each.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
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

// Without jaws, because jaw shots drop from everywhere.
const char* const bank =
    R"({"table": {"preset": "pool-9ft", "jaws": false}, "physics": "rolling", "ball": {"at": [0.635, 0.4]},
  "target": {"pocket": "bottom-middle"}, "cushions": ["top", "right"]})";

std::vector<std::vector<std::string>> table(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) {
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("map: each row is the answer of solve from there") {
  const ScratchFile csv("map.csv"), svg("map.svg");
  const Run run = run_program("map --grid 6 3 -o \"" + csv.path + "\" -o \"" + svg.path + "\" -", bank);
  CHECK(run.exit == 0);
  CHECK(run.err.empty());
  const auto rows = table(csv.text());
  REQUIRE(rows.size() == 19);
  CHECK(rows[0][0] == "x_m");
  CHECK(rows[0][3] == "speed_m_per_s");
  int solved = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& row = rows[i];
    REQUIRE(row.size() == rows[0].size());
    CHECK(std::stod(row[0]) == Approx(0.028575 + (2.54 - 0.05715) * (static_cast<double>((i - 1) % 6) + 0.5) / 6));
    Json puzzle = Json::parse(bank);
    puzzle["ball"]["at"] = {std::stod(row[0]), std::stod(row[1])};
    const Json a = Json::parse(run_program("solve --json", puzzle.dump()).out);
    CHECK(row[2] == a["status"].get<std::string>());
    if (row[2] != "solved") continue;
    ++solved;
    const Json& s = a["shots"][0];
    CHECK(std::stod(row[3]) == s["speed"]);
    CHECK(std::stod(row[4]) == s["angle"]);
    CHECK(row[5] == "top right");
    CHECK(std::stod(row[8]) == s["success"]);
    CHECK(std::stod(row[9]) == Approx(s["margin"]["angle"][0].get<double>()));
  }
  CHECK((solved > 8 && solved < 18));
  CHECK_THAT(run.out, Contains(fmt::format("18 starts: {} with a shot, {} without", solved, 18 - solved)) &&
                          Contains("slowest: ") && Contains("most robust: "));
  // Two tables, a rectangle for each cell, and an arrowhead where a cell has an aim.
  CHECK(count(svg.text(), "<svg ") == 3);
  CHECK(count(svg.text(), "class=\"aim\"") == 2 * static_cast<std::size_t>(solved));
  CHECK_THAT(svg.text(), Contains("no shot") && Contains("100 %") && Contains(" m/s") && !Contains("no start"));
}

TEST_CASE("map --value: each place has an estimate, and the best is told") {
  const ScratchFile csv("map-value.csv"), svg("map-value.svg");
  const std::string options = "map - --value --grid 12 6 -o \"" + csv.path + "\" -o \"" + svg.path + "\"";
  const std::string layout = R"({"table": "pool-9ft", "ball": {"at": [0.6, 0.5]},
    "others": [{"id": "1", "at": [1.9, 0.9]}, {"id": "2", "at": [0.9, 0.4]}])";
  const Run run = run_program(options, layout + R"(, "target": {"game": "rotation"}})");
  CHECK(run.exit == 0);
  CHECK(run_program(options, layout + "}").out == run.out);
  CHECK(run.err.empty());
  const auto rows = table(csv.text());
  REQUIRE(rows.size() == 73);
  double best = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    REQUIRE(rows[i].size() == rows[0].size());
    if (rows[i][2] != "legal") continue;
    const double value = std::stod(rows[i][3]);
    CHECK((value >= 0 && value <= 1));
    CHECK((rows[i][4] == "1") == (value > 0));
    best = std::max(best, value);
  }
  CHECK(best > 0.9);
  CHECK_THAT(run.out, Contains("72 starts") && Contains("best: (") && Contains("ball \"1\" into "));
  CHECK(count(svg.text(), "<svg ") == 2);
  const Run other = run_program(options, bank);
  CHECK(other.exit == 2);
  CHECK_THAT(other.err, Contains("/target") && Contains("a ball is to be potted"));
}

TEST_CASE("map: starts in cushions, in pockets and at the target are marked") {
  const ScratchFile csv("map-marks.csv");
  const char* const corner =
      R"({"table": {"vertices": [[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]], "pockets": [{"name": "hole", "at": [0,0], "radius": 0.3}]},
    "physics": "ideal", "ball": {"at": [1.5, 0.5]}, "target": {"point": [0.5, 1.5], "within": 0.2}, "cushions": 1})";
  const Run run = run_program("map - --grid 8 8 -o \"" + csv.path + "\"", corner);
  CHECK(run.exit == 0);
  const std::string text = csv.text();
  CHECK(count(text, "in-cushion,") == 16);
  CHECK(count(text, "in-pocket,") == 1);
  CHECK(count(text, "at-target,") >= 1);
  CHECK_THAT(run.out, Contains("16 lie in a cushion, 1 in a pocket"));
}

TEST_CASE("map: a file that is no picture and no table is refused before the work") {
  const auto [arguments, reason] = GENERATE(Catch::Generators::table<std::string, std::string>({
      {"map - --grid 4 4 -o x.gif", "\"x.gif\" must end in .svg, .png or .csv"},
      {"map - --grid 4 4 -o -", "standard output"},
      {"map - --grid 4 4", "--output is required"},
      {"map - --grid 0 4 -o x.svg", "--grid"},
      {"map - --grid 4 -o x.svg", "--grid"},
      {"map - --grid 4 4 -o /no/such/folder/x.svg", "/no/such/folder/x.svg: cannot be written"},
  }));
  INFO(arguments);
  const Run run = run_program(arguments, bank);
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains(reason));
  CHECK(run.err.find('\n') == run.err.size() - 1);
}

TEST_CASE("map: a bad puzzle has its place, and no shot at all is exit code 1") {
  const ScratchFile csv("map-none.csv");
  const Run bad = run_program("map - --grid 2 2 -o \"" + csv.path + "\"", "{\"tabel\": 1}");
  CHECK(bad.exit == 2);
  CHECK_THAT(bad.err, Contains("standard input: /tabel: this key is unknown"));
  Json weak = Json::parse(bank);
  weak["speed"] = {0.1, 0.2};
  const Run none = run_program("map - --grid 2 2 -o \"" + csv.path + "\"", weak.dump());
  CHECK(none.exit == 1);
  CHECK_THAT(none.out, Contains("4 starts: 0 with a shot, 4 without"));
}
