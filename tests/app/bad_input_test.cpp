// SPDX-License-Identifier: MIT
//
// Bad input as a user meets it: exit code 2, one line that names the place and the rule, and an `invalid` answer for a
// program that asked for JSON.
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using bankshot::test::Run;
using bankshot::test::run_program;
using Json = nlohmann::json;

struct Case {
  const char* name;
  std::string document;
  std::string path;    ///< JSON path of the error; empty for text that is not JSON
  std::string reason;  ///< words that the reason must contain
  Json id = 7;         ///< the id that the answer repeats; null where the document has none
};

/// Returns a valid puzzle with one member of the document replaced, added or (null) left out.
std::string puzzle(const Json& change) {
  Json p = Json::parse(R"({"id": 7, "table": "pool-9ft", "physics": "rolling", "ball": {"at": [0.6, 0.4]},
                           "target": {"pocket": "top-right"}})");
  p.merge_patch(change);
  return p.dump();
}
std::string puzzle(const char* change) { return puzzle(Json::parse(change)); }

std::string polygon(const char* vertices, const Json& more = Json::object()) {
  Json table{{"vertices", Json::parse(vertices)}};
  table.update(more);
  return puzzle({{"table", table}, {"target", {{"pocket", nullptr}, {"point", {0.5, 0.5}}}}});
}

std::string repeat(const std::string& text, int n) {
  std::string out;
  for (int i = 0; i < n; ++i) out += text;
  return out;
}

const std::vector<Case>& cases() {
  const char* square = "[[0,0],[1,0],[1,1],[0,1]]";
  static const std::vector<Case> all{
      {"missing key", puzzle(R"({"table": null})"), "/table", "required"},
      {"wrong type", puzzle(R"({"speed": "fast"})"), "/speed", "\"fast\" must be a number or a pair"},
      {"wrong inner type", puzzle(R"({"ball": {"at": ["a", 1]}})"), "/ball/at/0", "\"a\" must be a number"},
      {"NaN", R"({"id": 7, "speed": NaN})", "", "line 1: not JSON at 'NaN'"},
      {"number too large", "{\"id\": 7,\n\"speed\": 1e999}", "", "line 2: the number 1e999 is too large"},
      {"ball outside", puzzle(R"({"ball": {"at": [5, 0.4]}})"), "/ball/at", "inside the table"},
      {"ball in the cushion", puzzle(R"({"ball": {"at": [0.6, 0.02]}})"), "/ball/at", "radius 0.028575"},
      {"self-crossing", polygon("[[0,0],[2,0],[0,1],[2,1]]"), "/table/vertices/3", "edge 3 crosses or touches edge 1"},
      {"clockwise", polygon("[[0,1],[1,1],[1,0],[0,0]]"), "/table/vertices", "anticlockwise"},
      {"zero-length edge", polygon("[[0,0],[1,0],[1,0],[1,1]]"), "/table/vertices/1", "length zero"},
      {"same name twice", polygon(square, {{"names", {"a", "b", "c", "a"}}}), "/table/names/3",
       "\"a\" names two cushions"},
      {"name of a vertex", polygon(square, {{"names", {"a", "v0", "c", "d"}}}), "/table/names", "vertex 0"},
      {"line break in a name", polygon(square, {{"names", {"a\n", "a\n", "c", "d"}}}), "/table/names/1", "names two"},
      {"unknown preset", puzzle(R"({"table": "pool-9fot"})"), "/table", "did you mean \"pool-9ft\"?"},
      {"a billion cushions", puzzle(R"({"cushions": 1e9})"), "/cushions", "between 0 and 20000"},
      {"half a cushion", puzzle(R"({"cushions": 1.5})"), "/cushions", "1.5 must be a whole number"},
      {"unknown cushion", puzzle(R"({"cushions": ["top", "botom"]})"), "/cushions/1", "did you mean \"bottom\"?"},
      {"unknown pocket", puzzle(R"({"target": {"pocket": "topright"}})"), "/target/pocket",
       "did you mean \"top-right\"?"},
      {"100,000 brackets", repeat("[", 100000), "", "line 1: nested deeper than 64 levels", nullptr},
      {"brackets on a later line", "{\"id\": 7, \"]\": \"[\",\n\"a\":" + repeat("[", 70), "", "line 2: nested deeper"},
      {"10 MB of garbage", repeat("\x01\xff x", 2'500'000), "", "line 1: not JSON", nullptr},
      {"10 MB of string", "{\"id\": \"" + repeat("x", 10'000'000), "", "missing closing quote", nullptr},
      {"empty document", "", "", "line 1: the document is empty", nullptr},
      {"cut short", "{\"id\": 7,\n\"speed\": 1", "", "line 2: not JSON: unexpected end of input"},
      {"text after the document", puzzle("{}") + "\nx", "", "line 2: not JSON at 'x'"},
      {"no object", "[1, 2]", "", "must be an object with these keys: id, about, table", nullptr},
      {"duplicate key", R"({"id": 7, "others": [{}, {"a": 1, "a": 2}]})", "/others/1/a", "twice in one object"},
      {"duplicate id", R"({"id": 7, "id": 8})", "/id", "twice in one object", nullptr},
      {"unknown key", puzzle(R"({"tabel": 1})"), "/tabel", "unknown; did you mean \"table\"?"},
      {"unknown inner key", puzzle(R"({"ball": {"colour": 1}})"), "/ball/colour", "known are at, radius, mass, spin"},
      {"line break in a key", puzzle(R"({"a\nb": 1})"), "/a\\nb", "unknown"},
      {"unknown cushion model", puzzle(R"({"physics": {"model": "spin", "cushion": {"model": "mathavan2011"}}})"),
       "/physics/cushion/model", "did you mean \"mathavan2010\"?"},
      {"nose too low", puzzle(R"({"physics": {"model": "spin", "cushion": {"height": 0.02}}})"),
       "/physics/cushion/height", "must lie between the ball's radius"},
      {"a point with spin", puzzle(R"({"physics": "spin", "ball": {"radius": 0}})"), "/ball/radius", "is a point"},
      {"a range of spin upside down", puzzle(R"({"physics": "spin", "ball": {"spin": {"top": [1, 0]}}})"),
       "/ball/spin/top", "lower end first"},
      {"friction that never stops a ball",
       puzzle(R"({"physics": {"model": "spin", "rolling_friction": {"at_rest": 0, "per_speed": 0.01}}})"),
       "/physics/rolling_friction/at_rest", "greater than 0"},
      {"spin of the ball", puzzle(R"({"ball": {"spin": {"top": 1}}})"), "/ball/spin", "needs the physics \"spin\""},
      {"overlapping balls", puzzle(R"({"others": [{"id": "8", "at": [0.61, 0.4]}]})"), "/others/0/at", "overlaps"},
      {"unknown target", puzzle(R"({"target": {"pocket": null, "pot": "8"}})"), "/target",
       "must have one of the keys \"point\", \"pocket\", \"ball\", \"carom\", \"game\""},
      {"ball target", puzzle(R"({"target": {"pocket": null, "ball": "8"}})"), "/target/ball", "there are no"},
      {"jaws", puzzle(R"({"table": {"length": 2, "width": 1, "jaws": true}})"), "/table/jaws",
       "needs the pockets \"six\", or a preset"},
      {"jaws of nothing", puzzle(R"({"table": {"preset": "carom-10ft", "jaws": true}})"), "/table/jaws",
       "this table has none"},
      {"narrow jaws", puzzle(R"({"table": {"preset": "pool-9ft", "mouth": {"corner": 0.02}}})"), "/table/mouth",
       "no ball passes between the jaws"},
      {"many jaws",
       puzzle(R"({"table": {"length": 2, "width": 1, "pockets": "six", "jaws": true, "mouth": {"corner": 1.2}}})"),
       "/table/jaws", "leave nothing of cushion"},
      {"a steep tilt", puzzle(R"({"table": {"preset": "pool-9ft", "tilt": [0, 1.01]}})"), "/table/tilt/1",
       "must be between -1 and 1"},
      {"tilt without weight", puzzle(R"({"physics": "ideal", "table": {"preset": "pool-9ft", "tilt": [0, 0.01]}})"),
       "/table/tilt", "a ball has no weight"},
      {"balls on a slope", puzzle(R"({"table": {"preset": "pool-9ft", "tilt": [0, 0.1]},
                                      "others": [{"id": "8", "at": [1.8, 0.2]}]})"),
       "/table/tilt", "no ball stands on so steep a table"},
      {"a cushion of another table", puzzle(R"({"table": {"preset": "pool-9ft", "cushions": {"topp": {}}}})"),
       "/table/cushions/topp", "did you mean \"top\"?"},
      {"own friction of a mirror",
       puzzle(R"({"physics": "rolling", "table": {"preset": "pool-9ft", "cushions": {"top": {"friction": 0.1}}}})"),
       "/table/cushions/top/friction", "a mirror has no friction"},
      {"own cushion of ideal", puzzle(R"({"physics": "ideal",
                                          "table": {"preset": "pool-9ft", "cushions": {"top": {"restitution": 0.9}}}})"),
       "/table/cushions/top", "perfect mirrors"},
      {"noise of spin that there is not", puzzle(R"({"noise": {"side": 0.1}})"), "/noise/side", "needs the physics"},
      {"arrive with a fixed speed", puzzle(R"({"speed": 2, "arrive": {"speed": 1}})"), "/arrive",
       "launch speed is fixed"},
      {"negative speed", puzzle(R"({"speed": -1})"), "/speed", "-1 must be at least 0"},
      {"pocket out of reach", puzzle(R"({"table": {"length": 2, "width": 1, "pockets":
           [{"name": "top-right", "at": [2, 1], "radius": 0.01}]}})"),
       "/table/pockets/0", "no ball can fall into pocket"},
  };
  return all;
}

void check_complaint(const Run& run, const std::string& place, const std::string& reason) {
  CHECK(run.exit == 2);
  REQUIRE(!run.err.empty());
  CHECK(run.err.find('\n') == run.err.size() - 1);
  CHECK_THAT(run.err, Catch::Contains(place) && Catch::Contains(reason));
}

}  // namespace

TEST_CASE("bad puzzles are refused with their place and the rule") {
  for (const Case& c : cases()) {
    INFO(c.name);
    // Text that is not JSON has a line instead of a path.
    const bool has_line = c.reason.starts_with("line ");
    const auto words = c.reason.substr(has_line ? c.reason.find(": ") + 2 : 0);
    const auto line = has_line ? c.reason.substr(5, c.reason.find(':') - 5) : "";
    const std::string place = has_line ? "standard input:" + line + ": " : "standard input";

    const Run text = run_program("solve", c.document);
    check_complaint(text, place, words);
    CHECK_THAT(text.err, Catch::Contains(c.path));
    CHECK(text.out.empty());

    const Run json = run_program("solve --json", c.document);
    check_complaint(json, place, words);
    CHECK(json.out.find('\n') == json.out.size() - 1);
    const Json answer = Json::parse(json.out);
    CHECK(answer.at("status") == "invalid");
    CHECK(answer.at("error").at("path") == c.path);
    CHECK_THAT(answer.at("error").at("reason").get<std::string>(), Catch::Contains(c.reason));
    CHECK(answer.value("id", Json()) == c.id);
  }
}

TEST_CASE("bad usage is refused with what was meant") {
  const auto [arguments, reason] = GENERATE(table<std::string, std::string>({
      {"solve /no/such/file.json", "/no/such/file.json: cannot be read: No such file"},
      {"solve /", "/: cannot be read: Is a directory"},
      {"solve --frob", "--frob"},
      {"slove", "\"slove\" is no command; known are advise, "},
      {"slove", "did you mean \"solve\"?"},
      {"", "subcommand is required"},
      {"solve --planner imge", "--planner: \"imge\" is no planner"},
      {"solve --planner imge", "did you mean \"image\"?"},
      {"solve --budget -1", "--budget: \"-1\" must be a whole number"},
      {"solve --svg -", "standard output"},
      {"simulate --rate 0", "--rate"},
  }));
  INFO(arguments);
  const Run text = run_program(arguments, puzzle("{}"));
  check_complaint(text, "bankshot: ", reason);
  CHECK(text.out.empty());
  const Run json = run_program(arguments + " --json", puzzle("{}"));
  check_complaint(json, "bankshot: ", reason);
  CHECK(Json::parse(json.out).at("status") == "invalid");
}

TEST_CASE("an answer whose picture cannot be written is printed all the same") {
  const Run run = run_program("solve --json --svg /no/such/folder/x.svg", puzzle("{}"));
  check_complaint(run, "bankshot: ", "/no/such/folder/x.svg: cannot be written");
  CHECK(Json::parse(run.out).at("status") == "solved");
}
