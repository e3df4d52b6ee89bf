// SPDX-License-Identifier: MIT
//
// Requests and their answers without a command line: options, scenes by name, wishes, tables of paths, maps of starts,
// and the replies.
#include <array>
#include <atomic>
#include <functional>
#include <nlohmann/json.hpp>

#include "bankshot/plan/launch_map.hpp"
#include "bankshot/scene/json.hpp"
#include "service/answers.hpp"
#include "service/options.hpp"
#include "service/path_table.hpp"
#include "service/scene_words.hpp"
#include "service/solve_flags.hpp"
#include "service/start_map.hpp"
#include "service/wishes.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::service;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

constexpr std::string_view puzzle_text =
    R"({"id": 7, "table": "pool-9ft", "physics": "rolling", "ball": {"at": [0.6, 0.4]}, "target": {"pocket": "top-right"},
        "cushions": 0})";
constexpr std::string_view shot_text =
    R"({"table": "pool-9ft", "physics": "rolling", "ball": {"at": [0.6, 0.4]}, "shot": {"speed": 1, "angle": 30}})";

/// Returns what is wrong with an option; empty if nothing is.
std::string wrong(const std::function<void()>& read) {
  try {
    read();
  } catch (const BadOption& e) {
    return e.what();
  }
  return "";
}

/// A limit that nobody reaches.
struct Unlimited {
  std::atomic<bool> stop = false;
  std::atomic<const char*> why = "";
  operator Limit() const { return {stop, why}; }
};

}  // namespace

TEST_CASE("options are split into names and values") {
  CHECK(query_of("all&budget=500&x=a=b", '&') == Query{{"all", ""}, {"budget", "500"}, {"x", "a=b"}});
  CHECK(query_of("", '&').empty());
  CHECK(query_of("&&all&", '&') == Query{{"all", ""}});
}

TEST_CASE("each kind of option takes its values and refuses others by its name") {
  bool flag = false;
  std::string text;
  long whole = -1;
  double number = 0;
  std::vector<double> pair(2);
  std::vector<int> grid{1, 1};
  const std::array options{Option{"flag", &flag},
                           Option{"text", &text},
                           Option{"whole", &whole},
                           Option{"number", &number, "", {0, 10}},
                           Option{"pair", &pair, "", {-9, 9}},
                           Option{.name = "grid", .target = &grid, .range = {1, 400}, .excludes = "pair"}};
  const auto wrong_in = [&](std::string_view query) { return wrong([&] { read(query_of(query, '&'), options); }); };
  CHECK(wrong_in("flag&text=a b&whole=12&number=2.5&pair=-1,0.5").empty());
  CHECK((flag && text == "a b" && whole == 12 && number == 2.5 && pair == std::vector{-1.0, 0.5}));
  CHECK(wrong_in("flag=false").empty());
  CHECK(!flag);
  CHECK(wrong_in("flag=maybe") == R"(--flag: "maybe" must be true or false)");
  CHECK(wrong_in("text=") == "--text: needs a value");
  CHECK_THAT(wrong_in("whole=-1"), Catch::StartsWith("--whole: ") && Contains("whole number"));
  CHECK(wrong_in("number=11") == "--number: 11 must be from 0 to 10");
  CHECK(wrong_in("number=1x") == R"(--number: "1x" is no number)");
  CHECK_THAT(wrong_in("pair=1"), Contains("must be 2 numbers"));
  CHECK(wrong_in("grid=1.5,2") == R"(--grid: "1.5" must be a whole number)");
  CHECK(wrong_in("grid=3,2&pair=1,2") == "--grid: excludes --pair");
  CHECK_THAT(wrong_in("nmber=1"), Contains("--nmber is no option here") && Contains("did you mean \"number\""));
  CHECK(whole_number("123").empty());
  CHECK(!whole_number("").empty());
  CHECK(!whole_number("1234567890123456789").empty());
  const std::array needed{Option{.name = "must", .target = &text, .required = true}};
  CHECK(wrong([&] { read({}, needed); }) == "--must: is required");
}

TEST_CASE("a table and a physics are names or objects, and what is wrong names its option") {
  CHECK(as_json("pool-9ft") == R"("pool-9ft")");
  CHECK(as_json(R"({"length": 2})") == R"({"length": 2})");
  CHECK(read_scene_words("snooker-12ft", "rolling").ball.body == preset_scene("snooker-12ft").ball.body);
  CHECK_THAT(wrong([] { read_scene_words("pool-99ft", "rolling", "--"); }), Catch::StartsWith("--table: "));
  CHECK_THAT(wrong([] { read_scene_words("seed", "glide", "--"); }), Catch::StartsWith("--physics: "));
}

TEST_CASE("a path has as many rows as its rate says, and one that is too long is refused") {
  const ShotRequest shot = read_shot(shot_text);
  const Trajectory t = bankshot::simulate(shot);
  const std::string table = path_table(shot, t, 10, 1e6);
  CHECK(table == to_csv(shot, t, 10));
  const double rows = t.events.back().time * 10;
  CHECK_NOTHROW(path_table(shot, t, 10, rows * 1.01));
  CHECK_THROWS_AS(path_table(shot, t, 10, rows * 0.99), TooLong);
}

TEST_CASE("the flags of solve set the puzzle's budget and player, and can be typed again") {
  SolveFlags flags;
  read(query_of("budget=123&noise=pro&all&no-timing", '&'), options_of(flags));
  CHECK_NOTHROW(check(flags));
  const Puzzle puzzle = flags.read(puzzle_text);
  CHECK(puzzle.budget == 123);
  CHECK(puzzle.noise.angle == std::ranges::find(players(), "pro", &Player::name)->noise.angle);
  CHECK(flags.words() == "--planner auto --all --budget 123 --noise pro --no-timing");
  CHECK(flags.solve_options().robustness);
  flags.no_robustness = true;
  CHECK(!flags.solve_options().robustness);
  CHECK_THAT(wrong([] { check_player("proo"); }), Contains("is no player") && Contains("did you mean \"pro\""));
  Puzzle unchanged = read_puzzle(puzzle_text);
  const Noise before = unchanged.noise;
  set_player(unchanged, "");
  CHECK(unchanged.noise == before);
  SolveFlags list;
  list.options.planner = std::string("list");
  for (const PlannerInfo& p : planners()) CHECK_THAT(list_asked(list), Contains(std::string(p.name)));
  CHECK(list_asked(flags).empty());
}

TEST_CASE("an answer as text names the shot") {
  SolveFlags flags;
  const Puzzle puzzle = flags.read(puzzle_text);
  const Answer answer = bankshot::solve(puzzle, flags.solve_options());
  REQUIRE(answer.status == Status::solved);
  CHECK_THAT(text_of(puzzle, answer, flags), Contains("top-right"));
}

TEST_CASE("wishes are read by name, and impossible ones are refused by their option") {
  const auto by = [](const std::string& cushions, const std::string& target) {
    return Wishes{.cushions = cushions, .difficulty = {}, .target = target};
  };
  const Wish wish = read_wish(by("1-2", "pocket"));
  CHECK((wish.cushions.min == 1 && wish.cushions.max == 2));
  CHECK(wish.kind == Wish::Kind::pocket);
  CHECK(read_wish(by("top,left", "pocket")).cushions.sequence == std::vector{Contact::rail(2), Contact::rail(3)});
  CHECK_THAT(wrong([&] { read_wish(by("tpo", "pocket")); }), Catch::StartsWith("--cushions: ") && Contains("\"top\""));
  const Wishes carom{.table = "carom-10ft", .difficulty = {}, .target = "pocket"};
  CHECK_THAT(wrong([&] { read_wish(carom); }), Contains("no pockets"));
  const Wishes endless{.physics = "ideal", .difficulty = {}, .target = "stop"};
  CHECK_THAT(wrong([&] { read_wish(endless); }), Contains("without friction"));
  const Wishes kick{.then = "1", .difficulty = {}, .target = "kick"};
  CHECK_THAT(wrong([&] { read_wish(kick); }), Catch::StartsWith("--then"));
}

TEST_CASE("a puzzle that is made has its number, and is the same again") {
  const Wishes wishes{.seed = 5, .physics = "rolling", .cushions = "0-1", .difficulty = {}, .target = "pass"};
  const Wish wish = read_wish(wishes);
  const service::Made made = make(wishes, wish, 2);
  REQUIRE(!made.line.empty());
  CHECK(read_puzzle(made.line).id == "\"5-2\"");
  CHECK(make(wishes, wish, 2).line == made.line);
  CHECK(make(wishes, wish, 3).line != made.line);
}

TEST_CASE("a map of starts solves the legal ones alone") {
  Puzzle puzzle = read_puzzle(puzzle_text);
  const Ball other{{1, 0.6}, puzzle.ball.body, "8"};
  puzzle.others = {other};
  const StartMap map = start_map(puzzle, 5, 3, {.robustness = false});
  REQUIRE(map.starts.size() == 15);
  REQUIRE(map.answers.size() == 15);
  for (std::size_t i = 0; i < map.starts.size(); ++i)
    CHECK((map.starts[i] == Start::legal) == (map.answers[i].status != Status::invalid));
  CHECK(std::ranges::count(map.answers, Status::solved, &Answer::status) > 3);
}

TEST_CASE("replies are JSON, and refusals say where and why") {
  const Unlimited none;
  const Json refused = Json::parse(refusal(404, "/ball/at", "say \"why\"").body);
  CHECK(refused["path"] == "/ball/at");
  CHECK(refused["reason"] == "say \"why\"");
  const Reply solved = service::solve({{"no-timing", ""}}, std::string(puzzle_text), none);
  REQUIRE(solved.status == 200);
  const Json answer = Json::parse(solved.body);
  CHECK(answer["id"] == 7);
  CHECK(answer["status"] == "solved");
  CHECK(!answer.contains("time_us"));
  CHECK(service::solve({{"no-timing", ""}}, std::string(puzzle_text), none).body == solved.body);
  const Reply bad = service::solve({}, R"({"table": "pool-9ft", "ball": {"at": ["a", 0]}, "target": {}})", none);
  CHECK(bad.status == 400);
  CHECK(Json::parse(bad.body)["path"] == "/ball/at/0");
  CHECK(service::solve({{"planner", "atuo"}}, std::string(puzzle_text), none).status == 400);
}

TEST_CASE("a shot is simulated as JSON or as CSV") {
  const Reply json = service::simulate({}, std::string(shot_text));
  REQUIRE(json.status == 200);
  CHECK(Json::parse(json.body)["events"].front()["type"] == "start");
  const Reply csv = service::simulate({{"csv", ""}, {"rate", "10"}}, std::string(shot_text));
  CHECK(csv.type == "text/csv");
  const ShotRequest shot = read_shot(shot_text);
  CHECK(csv.body == to_csv(shot, bankshot::simulate(shot), 10));
  CHECK(service::simulate({{"rate", "0"}}, std::string(shot_text)).status == 400);
}

TEST_CASE("tables and schemas come as the program has them") {
  const Json tables = Json::parse(service::tables({}).body);
  REQUIRE(tables.size() == table_presets().size());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    CHECK(tables[i]["name"] == std::string(table_presets()[i].name));
    CHECK(tables[i]["pockets"].size() == make_table(table_presets()[i]).pockets.size());
  }
  CHECK(service::tables({{"all", ""}}).status == 400);
  CHECK(service::schema({{"document", "shot"}}).status == 200);
  CHECK(service::schema({{"document", "shto"}}).status == 400);
}

TEST_CASE("maps are refused once they are stopped, and grids must make sense") {
  Unlimited none, stopped;
  stopped.stop = true;
  stopped.why = "enough";
  const std::string puzzle(puzzle_text);
  const Query few{{"grid", "3,2"}, {"no-robustness", ""}};
  const Reply map = service::map(few, puzzle, none);
  REQUIRE(map.status == 200);
  CHECK(std::ranges::count(map.body, '\n') == 1 + 3 * 2);
  const Reply ended = service::map(few, puzzle, stopped);
  CHECK(ended.status == 503);
  CHECK(Json::parse(ended.body)["reason"] == "enough");
  CHECK(service::map({{"grid", "0,2"}}, puzzle, none).status == 400);
  CHECK(service::launches({{"angle", "40,30"}, {"speed", "1,3"}}, puzzle, none).status == 400);
  CHECK(service::launches({{"angle", "30,40"}}, puzzle, none).status == 400);
  const Reply launches = service::launches({{"angle", "20,30"}, {"speed", "1,3"}, {"grid", "4,3"}}, puzzle, none);
  CHECK(launches.status == 200);
}
