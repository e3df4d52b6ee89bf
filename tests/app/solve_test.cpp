// SPDX-License-Identifier: MIT
//
// `solve` as typed in a shell: what it prints, which files it writes, exit codes.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/scratch_file.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::run_program;
using bankshot::test::ScratchFile;
using Catch::Contains;
using Json = nlohmann::json;

const char* const bank = R"({"id": "bank", "table": "pool-9ft", "physics": "rolling", "ball": {"at": [0.635, 0.4]},
  "target": {"pocket": "bottom-middle"}, "cushions": ["top", "right"], "arrive": {"speed": 0.5}})";
Json solve_json(const std::string& flags, const std::string& puzzle = bank) {
  return Json::parse(run_program("solve --json " + flags, puzzle).out);
}

}  // namespace

TEST_CASE("solve prints what a player needs") {
  const auto run = run_program("solve", bank);
  CHECK(run.exit == 0);
  CHECK(run.err.empty());
  for (const char* part : {"solved: ", "aim       diamond ", " of 8 on the top rail", "degrees",
                           "speed     medium: ", "m/s", "mph", "lag speed", "tip       11.4 mm above the centre",
                           "top, right", "falls into bottom-middle after", "of its middle as the ball rolls",
                           "for a player who errs by 0.125 degrees of aim and 0.075 m/s together with 3 % of speed",
                           "margin", "0.1 degrees of aim moves the arrival by"})
    CHECK_THAT(run.out, Contains(part));
}

TEST_CASE("solve --json prints one line with every field of the format") {
  const auto run = run_program("solve --json", bank);
  CHECK(run.exit == 0);
  CHECK(run.out.find('\n') == run.out.size() - 1);
  const Json a = Json::parse(run.out);
  CHECK(a.at("id") == "bank");
  CHECK(a.at("status") == "solved");
  CHECK(a.at("nearest").is_null());
  CHECK(a.at("simulations").is_number_integer());
  for (const char* key : {"modelled", "time_us", "message"}) CHECK(a.contains(key));
  REQUIRE(a.at("shots").size() == 1);
  const Json& s = a["shots"][0];
  CHECK(s.at("cushions") == Json{"top", "right"});
  CHECK(s.at("arrival").at("speed") == Approx(0.5));
  CHECK(s.at("margin").at("angle").size() == 2);
  CHECK(s.at("margin").at("speed").size() == 2);
  for (const char* key : {"speed", "angle", "spin", "tip", "miss", "condition", "success", "planner", "simulations"})
    CHECK(s.contains(key));
}

TEST_CASE("a shot into any pocket names the one that it reaches, a shot to a point none") {
  Json puzzle = Json::parse(bank);
  CHECK(solve_json("").at("shots").at(0).at("pocket") == "bottom-middle");
  puzzle["table"] = {{"preset", "pool-9ft"}, {"jaws", false}};
  puzzle["target"] = {{"pocket", "any"}};
  puzzle["cushions"] = 1;
  const Json shots = solve_json("--all", puzzle.dump()).at("shots");
  REQUIRE(shots.size() > 3);
  for (const Json& s : shots) {
    // The ball falls half a mouth away from the pocket's centre.
    const std::string name = s.at("pocket");
    const double x = name.ends_with("left") ? 0 : name.ends_with("right") ? 2.54 : 1.27;
    const double y = name.starts_with("top") ? 1.27 : 0, mouth = name.ends_with("middle") ? 0.129 : 0.116;
    const double dx = s.at("arrival").at("at")[0].get<double>() - x, dy = s.at("arrival").at("at")[1].get<double>() - y;
    CHECK(std::hypot(dx, dy) == Approx(mouth / 2));
  }
  CHECK_THAT(run_program("solve", puzzle.dump()).out, Contains(" shots found; --all prints each"));
  puzzle["target"] = {{"point", {1.9, 0.9}}};
  CHECK(!solve_json("", puzzle.dump()).at("shots").at(0).contains("pocket"));
}

TEST_CASE("a tip beside the ball is refused, one that may slip off is warned of") {
  Json puzzle = Json::parse(bank);
  puzzle.erase("physics");
  puzzle["ball"]["spin"] = {{"top", 2.4}, {"side", 0.8}};
  const auto run = run_program("solve", puzzle.dump());
  CHECK(run.exit == 2);
  CHECK_THAT(run.err, Contains("/ball/spin: ") && Contains("28.9 mm") && Contains("28.6 mm"));
  puzzle["ball"]["spin"] = {{"top", 1}, {"side", 0.8}};
  const Json a = solve_json("", puzzle.dump());
  REQUIRE(a.at("status") == "solved");
  CHECK_THAT(a.at("message").get<std::string>(), Contains("the tip may slip off the ball"));
  puzzle["ball"]["spin"] = {{"top", 0.9}, {"side", 0.8}};
  CHECK_THAT(solve_json("", puzzle.dump()).at("message").get<std::string>(), !Contains("slip"));
}

TEST_CASE("solve reads standard input with and without a dash, and files") {
  const ScratchFile file("puzzle.json");
  std::ofstream(file.path) << bank;
  const std::string without = run_program("solve --json --no-timing", bank).out;
  CHECK(run_program("solve - --json --no-timing", bank).out == without);
  CHECK(run_program("solve --json --no-timing \"" + file.path + "\"").out == without);
}

TEST_CASE("the id comes back with its type") {
  const std::string id =
      GENERATE("\"a \\\"quoted\\\" name\"", "\"\"", "17", "1.0", "1e3", "-2.5", "0", "18446744073709551615");
  const std::string puzzle = R"({"id": )" + id + std::string(bank).substr(std::string(R"({"id": "bank")").size());
  CHECK_THAT(run_program("solve --json", puzzle).out, Catch::StartsWith("{\"id\":" + id + ","));
}

TEST_CASE("an answer without an id has no id") {
  Json puzzle = Json::parse(bank);
  puzzle.erase("id");
  CHECK(!solve_json("", puzzle.dump()).contains("id"));
}

TEST_CASE("option --no-timing gives the same bytes each time and --no-robustness leaves out margin and success") {
  const std::string flags = "solve --json --all --no-timing";
  CHECK(run_program(flags, bank).out == run_program(flags, bank).out);
  CHECK(!solve_json("--no-timing").contains("time_us"));
  const Json s = solve_json("--no-robustness").at("shots").at(0);
  CHECK(!s.contains("margin"));
  CHECK(!s.contains("success"));
}

TEST_CASE("option --all prints every distinct shot, the best first") {
  Json puzzle = Json::parse(bank);
  puzzle["cushions"] = {{"min", 0}, {"max", 3}};
  const Json all = solve_json("--all", puzzle.dump()).at("shots"), one = solve_json("", puzzle.dump()).at("shots");
  REQUIRE(all.size() > 1);
  REQUIRE(one.size() == 1);
  CHECK(all[0].at("angle") == one[0].at("angle"));
  for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i - 1].at("value") >= all[i].at("value"));
}

TEST_CASE("option --first prints the first shot found, and not with --all") {
  const auto first = run_program("solve --first", bank), both = run_program("solve --first --all", bank);
  CHECK(first.exit == 0);
  CHECK(first.out.find("the first shot found") != std::string::npos);
  CHECK(both.exit == 2);
  CHECK(both.err == "bankshot: --all excludes --first; see bankshot --help\n");
}

TEST_CASE("no budget and no shot are exit code 1") {
  const auto none = run_program("solve --json --budget 0", bank);
  CHECK(none.exit == 1);
  CHECK(Json::parse(none.out).at("status") == "budget");
  CHECK_THAT(run_program("solve --budget 0", bank).out, Catch::StartsWith("budget: "));

  Json weak = Json::parse(bank);
  weak["speed"] = {0.1, 0.2};
  const auto run = run_program("solve --json", weak.dump());
  CHECK(run.exit == 1);
  CHECK(run.err.empty());
  const Json a = Json::parse(run.out);
  CHECK(a.at("status") == "no-shot");
  CHECK(a.at("shots").empty());
  CHECK_THAT(a.at("message").get<std::string>(), Contains("0.2 m/s"));
  CHECK(!a.at("nearest").at("why").get<std::string>().empty());
}

TEST_CASE("numbers print as the shortest decimals that read back") {
  const Json puzzle = Json::parse(R"({"table": {"length": 2, "width": 1}, "physics": "ideal", "speed": 0.1,
    "ball": {"at": [0.3, 0.1], "radius": 0}, "target": {"point": [0.3, 0.7]}, "cushions": 0})");
  CHECK_THAT(run_program("solve --json", puzzle.dump()).out, Contains("\"speed\":0.1,\"angle\":90,"));
}

TEST_CASE("solve --svg draws the shot") {
  const ScratchFile svg("solve.svg");
  const auto run = run_program("solve --svg \"" + svg.path + "\"", bank);
  CHECK(run.exit == 0);
  CHECK_THAT(run.out, Catch::StartsWith("solved: "));
  CHECK_THAT(svg.text(), Contains("<svg ") && Catch::EndsWith("</svg>\n"));
}

TEST_CASE("the picture says in words how to play the shot, and names table, bounces and diamonds") {
  const ScratchFile svg("solve-words.svg"), dark("solve-dark.svg");
  CHECK(run_program("solve --svg \"" + svg.path + "\"", bank).exit == 0);
  for (const char* part :
       {">By top, right into bottom-middle<", ">aim<", "counted from the left", ">speed<", "medium: ", ">tip<",
        ">success<", ">one every 0.5 s<", ">1<", ">2<", ">top-left<", ">right<"})
    CHECK_THAT(svg.text(), Contains(part));
  CHECK(run_program("solve --theme dark --svg \"" + dark.path + "\"", bank).exit == 0);
  CHECK(dark.text() != svg.text());
  CHECK(run_program("solve --theme grey", bank).exit == 2);
}

TEST_CASE("the picture of all shots numbers and lists them, that of none shows the nearest miss") {
  const ScratchFile all("solve-all.svg"), none("solve-none.svg");
  Json puzzle = Json::parse(bank);
  puzzle["cushions"] = 2;
  const std::size_t found = solve_json("--all", puzzle.dump()).at("shots").size();
  REQUIRE((found > 2 && found <= 16));
  CHECK(run_program("solve --all --svg \"" + all.path + "\"", puzzle.dump()).exit == 0);
  CHECK_THAT(all.text(), Contains(std::to_string(found) + " shots, the best first") && Contains("top, right: 34.7°"));
  puzzle["cushions"] = {"top", "right"};
  puzzle["speed"] = {0.1, 0.5};
  REQUIRE(!solve_json("", puzzle.dump()).at("nearest").is_null());
  CHECK(run_program("solve --svg \"" + none.path + "\"", puzzle.dump()).exit == 1);
  CHECK_THAT(none.text(), Contains("stroke-dasharray=\"9 6\"") && Contains("No shot; dashed is the nearest miss") &&
                              Contains(">why<"));
}

TEST_CASE("a closed pipe behind the text loses no picture") {
  const ScratchFile svg("solve-closed.svg");
  const auto run = bankshot::test::run_shell("PROGRAM solve --svg \"" + svg.path + "\" >&-", bank);
  CHECK(run.exit == 2);
  CHECK_THAT(svg.text(), Catch::EndsWith("</svg>\n"));
}

TEST_CASE("option --png writes a PNG, or says which library it lacks") {
  const ScratchFile png("solve.png");
  const auto run = run_program("solve --png \"" + png.path + "\"", bank);
  if (run.exit == 2) {
    CHECK_THAT(run.err, Contains("built without librsvg"));
  } else {
    CHECK(run.exit == 0);
    CHECK_THAT(png.text(), Catch::StartsWith("\x89PNG\r\n"));
    CHECK(png.text().size() > 20000);
  }
  CHECK_THAT(run_program("solve --png x.svg", bank).err, Contains("must end in .png"));
}

TEST_CASE("option --noise sets the player, and lists who they are") {
  const auto list = run_program("solve --noise list", "no puzzle");
  CHECK(list.exit == 0);
  for (const char* part : {"pro ", "league ", "beginner ", "degrees of aim", "from: "})
    CHECK_THAT(list.out, Contains(part));
  const auto unknown = run_program("solve --noise leage", bank);
  CHECK(unknown.exit == 2);
  CHECK_THAT(unknown.err, Contains("leage") && Contains("is no player") && Contains("league"));
  const auto success = [](const std::string& flags) {
    return solve_json(flags).at("shots").at(0).at("success").get<double>();
  };
  CHECK(success("--noise pro") > success("--noise league"));
  CHECK(success("--noise league") > success("--noise beginner"));
  // The puzzle itself may name the player.
  Json puzzle = Json::parse(bank);
  puzzle["noise"] = "league";
  CHECK(run_program("solve --json --no-timing", puzzle.dump()).out ==
        run_program("solve --json --no-timing --noise league", bank).out);
  CHECK_THAT(run_program("solve --noise league", bank).out, Contains("for a good league player who errs by"));
}

TEST_CASE("a shot that is hardly ever made is possible, not playable") {
  Json puzzle = Json::parse(bank);
  puzzle["noise"] = {{"angle", 60}, {"speed", 3}};
  const auto run = run_program("solve", puzzle.dump());
  CHECK(run.exit == 0);
  CHECK_THAT(run.out, Catch::StartsWith("solved: possible, not playable: "));
  CHECK_THAT(run_program("solve", bank).out, !Contains("not playable"));
  puzzle["noise"] = {{"angle", 0}, {"speed", 0}};
  CHECK_THAT(run_program("solve", puzzle.dump()).out, !Contains("not playable"));
}

TEST_CASE("solve --planner list names the planners without reading a puzzle") {
  const auto run = run_program("solve --planner list", "no puzzle");
  CHECK(run.exit == 0);
  for (const char* name : {"auto ", "image ", "sweep "}) CHECK_THAT(run.out, Contains(name));
  CHECK(solve_json("--planner sweep").at("status") == "solved");
}
