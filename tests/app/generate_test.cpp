// SPDX-License-Identifier: MIT
//
// Tests `generate` as typed in a shell.
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

std::vector<Json> lines(const std::string& text) {
  std::vector<Json> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(Json::parse(line));
  return out;
}

}  // namespace

TEST_CASE("generate: the same seed gives the same bytes, a smaller count their beginning") {
  const auto run = run_program("generate --count 70 --seed 5 --physics rolling");
  CHECK(run.exit == 0);
  CHECK(run.err.empty());
  CHECK(run_program("generate --count 70 --seed 5 --physics rolling").out == run.out);
  CHECK(run.out.starts_with(run_program("generate --count 3 --seed 5 --physics rolling").out));
  CHECK(run_program("generate --count 70 --seed 6 --physics rolling").out != run.out);
  const ScratchFile file("generated.jsonl");
  CHECK(run_program("generate --count 70 --seed 5 --physics rolling -o \"" + file.path + "\"").out.empty());
  CHECK(file.text() == run.out);
  const auto all = lines(run.out);
  REQUIRE(all.size() == 70);
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i]["id"] == "5-" + std::to_string(i + 1));
  CHECK(run_program("solve --json", all[69].dump()).exit == 0);
}

TEST_CASE("generate: --speed and --no-spin give puzzles that a player recognises") {
  const std::string options = "generate --count 12 --seed 4 --cushions 1-2 ";
  const auto any = lines(run_program(options).out), plain = lines(run_program(options + "--no-spin --speed 1,4").out);
  const auto spins = [](const Json& p) { return p["ball"].contains("spin"); };
  CHECK(std::ranges::any_of(any, spins));
  CHECK(std::ranges::none_of(plain, spins));
  REQUIRE(plain.size() == 12);
  for (const Json& p : plain) {
    REQUIRE(p.contains("speed"));
    CHECK((p["speed"] == Json{1, 4} || (p["speed"].is_number() && p["speed"] >= 1 && p["speed"] <= 4)));
  }
  const auto one = lines(run_program("generate --count 2 --seed 4 --target pot --cushions 0 --speed 2").out);
  CHECK((one.size() == 2 && one[0]["speed"] == 2));
  for (const char* const wrong : {"4,1", "0", "1,2,3"}) {
    const auto run = run_program(options + "--speed " + wrong);
    CHECK(run.exit == 2);
    CHECK_THAT(run.err, Contains("--speed"));
  }
}

TEST_CASE("generate: wishes are in the puzzles") {
  const auto of = [](const std::string& wishes) {
    return lines(run_program("generate --count 4 --seed 2 " + wishes).out).at(3);
  };
  const Json named = of("--cushions top,left --table carom-10ft");
  CHECK(named["cushions"] == Json{"top", "left"});
  CHECK(named["table"] == "carom-10ft");
  CHECK(named["physics"] == "spin");
  CHECK(of("--cushions 2 --target pocket")["target"].contains("pocket"));
  CHECK(of("--cushions 2 --target pocket")["cushions"] == 2);
  CHECK(of("--target pass --physics rolling")["target"].contains("point"));
  CHECK(of(R"(--table '{"length": 3, "width": 1.5}' --physics '{"model": "rolling", "friction": 0.02}')")["table"]
                                                                                                         ["length"] ==
        3);
  const auto drops = lines(run_program("generate --count 6 --seed 2 --target pocket --physics rolling").out);
  CHECK(std::ranges::any_of(drops, [](const Json& p) { return p.value("arrive", Json()) == Json{{"speed", 0.5}}; }));
  CHECK(!of("--target pocket --physics ideal").contains("arrive"));
}

TEST_CASE("generate: puzzles with other balls, to play past, onto, to send on and to go off") {
  const auto one = [](const std::string& wishes) {
    const auto run = run_program("generate --count 3 --seed 8 " + wishes);
    INFO(run.err);
    REQUIRE(run.exit == 0);
    CHECK(run_program("solve --json", run.out.substr(0, run.out.find('\n'))).exit == 0);
    return lines(run.out);
  };
  for (const Json& p : one("--balls 5 --target pocket --cushions 1")) {
    CHECK(p["others"].size() == 5);
    CHECK(p["target"].contains("pocket"));
  }
  for (const Json& p : one("--target kick --cushions 1")) {
    CHECK(p["others"].size() == 3);
    CHECK(p["target"] == Json{{"ball", "1"}});
  }
  for (const Json& p : one("--target pot --cushions 0 --then 1 --balls 1")) {
    CHECK(p["others"].size() == 1);
    CHECK(p["target"]["then"]["cushions"] == 1);
  }
  for (const Json& p : one("--table carom-10ft --target carom --cushions 3-6 --balls 2")) {
    CHECK(p["target"] == Json{{"carom", {"red", "yellow"}}});
    CHECK(p["cushions"] == Json{{"min", 3}, {"max", 6}});
  }
  CHECK_THAT(run_program("generate --count 1 --seed 1 --target kick --then 1").err, Contains("--target pot"));
  CHECK_THAT(run_program("generate --count 1 --seed 1 --target pot --table carom-10ft").err, Contains("no pockets"));
}

TEST_CASE("generate: what cannot be is refused or given up") {
  const auto [arguments, code, reason] = GENERATE(table<std::string, int, std::string>({
      {"--count 1", 2, "--seed is required"},
      {"--count x --seed 1", 2, "\"x\" must be a whole number"},
      {"--count 1 --seed 1 --table pool-9fot", 2, "--table: \"pool-9fot\" is no table"},
      {"--count 1 --seed 1 --table '{\"length\": 1}'", 2, "--table/width: this key is required"},
      {"--count 1 --seed 1 --physics spinn", 2, "did you mean \"spin\"?"},
      {"--count 1 --seed 1 --cushions top,botom", 2,
       "--cushions: \"botom\" is neither a number, LOW-HIGH nor a cushion; known are bottom, right, top, left; did you "
       "mean \"bottom\"?"},
      {"--count 1 --seed 1 --cushions 3-1", 2, "neither a number"},
      {"--count 1 --seed 1 --difficulty impossible", 2, "--difficulty"},
      {"--count 1 --seed 1 --table seed --target pocket", 2, "this table has no pockets"},
      {"--count 1 --seed 1 -o /no/such/folder/x", 2, "/no/such/folder/x: cannot be written"},
      {"--count 1 --seed 1 --physics ideal --target stop", 2, "--target stop: without friction no ball comes to rest"},
      {"--count 9 --seed 1 --table '{\"length\": 0.06, \"width\": 0.06}' --physics ideal", 1,
       "puzzle 1 of 9 was not found: the table has no free place for the ball"},
  }));
  INFO(arguments);
  const auto run = run_program("generate " + arguments);
  CHECK(run.exit == code);
  CHECK(run.out.empty());
  CHECK_THAT(run.err, Contains(reason) && Catch::StartsWith("bankshot: "));
  CHECK(run.err.find('\n') == run.err.size() - 1);
}

TEST_CASE("generate: its help says what the difficulties are") {
  CHECK_THAT(run_program("generate --help").out,
             Contains("at least 90 % of tries, and still made with 0.25 degrees") && Contains("less than 40 %"));
}
