// SPDX-License-Identifier: MIT
//
// Reads JSON text into a Puzzle and writes it back: every field, the defaults, and the rules behind them.
#include <nlohmann/json.hpp>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;
using Json = nlohmann::json;

namespace {

/// Returns the smallest valid puzzle, with changes merged in.
std::string minimal(const Json& change = Json::object()) {
  Json p{
      {"table", "pool-9ft"}, {"physics", "rolling"}, {"ball", {{"at", {0.6, 0.4}}}}, {"target", {{"point", {1, 0.6}}}}};
  p.merge_patch(change);
  return p.dump();
}

const char* const full = R"({"id": "all of it",
  "table": {"vertices": [[0, 0], [2, 0], [2, 1], [0, 1]], "names": ["s", "e", "n", "w"],
            "pockets": [{"name": "hole", "at": [2, 1], "radius": 0.06}]},
  "physics": {"model": "rolling", "friction": 0.02, "restitution": 0.9, "g": 9.8},
  "ball": {"at": [0.5, 0.25], "radius": 0.03, "mass": 0.2}, "others": [],
  "target": {"pocket": "hole"}, "cushions": ["s", "e", "v3"], "arrive": {"speed": [0.25, 0.75]},
  "speed": [0.5, 4], "angle": [10, 80], "prefer": "soft", "aim": "centre",
  "noise": {"angle": 0.5, "speed": 0.1}, "budget": {"simulations": 1e3}})";

}  // namespace

TEST_CASE("every key of a puzzle arrives in its field") {
  const Puzzle p = read_puzzle(full);
  CHECK(p.id == "\"all of it\"");
  CHECK(p.table.vertices.size() == 4);
  CHECK(p.table.cushions == std::vector<std::string>{"s", "e", "n", "w"});
  REQUIRE(p.table.pockets.size() == 1);
  CHECK(p.table.pockets[0].at == Vec2d{2, 1});
  CHECK(p.table.pockets[0].radius == 0.06);
  const auto& motion = std::get<Rolling>(p.physics.motion);
  CHECK(motion.friction == 0.02);
  CHECK(motion.g == 9.8);
  CHECK(restitution(p.physics).at_rest == 0.9);
  CHECK(p.ball.at == Vec2d{0.5, 0.25});
  CHECK(p.ball.body.radius == 0.03);
  CHECK(p.ball.body.mass == 0.2);
  CHECK(std::get<PocketTarget>(p.target).pocket == 0);
  CHECK(p.cushions.sequence == std::vector<Contact>{Contact::rail(0), Contact::rail(1), Contact::vertex(3)});
  CHECK(p.cushions.min == 3);
  CHECK(p.cushions.max == 3);
  CHECK(p.arrive->low == 0.25);
  CHECK(p.arrive->high == 0.75);
  CHECK(p.speed.low == 0.5);
  CHECK(p.speed.high == 4);
  CHECK(p.angle->low == Approx(radians(10)));
  CHECK(p.angle->high == Approx(radians(80)));
  CHECK(p.prefer == Prefer::soft);
  CHECK(p.noise.angle == Approx(radians(0.5)));
  CHECK(p.noise.speed == 0.1);
  CHECK(p.budget == 1000);
}

TEST_CASE("what is left out takes its default") {
  const Puzzle p = read_puzzle(minimal());
  CHECK(p.id.empty());
  CHECK(p.ball.body.radius == 0.028575);
  CHECK(p.ball.body.mass == 0.170097);
  CHECK(std::get<PointTarget>(p.target).within == 0.01);
  CHECK(p.cushions.min == 0);
  CHECK(p.cushions.max == 3);
  CHECK(!p.cushions.sequence);
  CHECK(!p.arrive);
  CHECK(arrival_range(p)->high == 0);  // at a point the ball comes to rest
  CHECK(p.speed.low == 0.1);
  CHECK(p.speed.high == 10);
  CHECK(!p.angle);
  CHECK(p.prefer == Prefer::robust);
  CHECK(p.noise.angle == radians(0.125));
  CHECK(p.noise.speed == 0.075);
  CHECK(budget_of(p) == 100000);
  const auto& motion = std::get<Rolling>(p.physics.motion);
  CHECK(motion.friction == 0.01);
  CHECK(motion.g == 9.81);
  CHECK(restitution(p.physics).at_rest == 0.85);
  const Puzzle pocket = read_puzzle(minimal({{"target", {{"point", nullptr}, {"pocket", "any"}}}}));
  CHECK(!std::get<PocketTarget>(pocket.target).pocket);
  CHECK(arrival_range(pocket)->low == 0.2);
  CHECK(arrival_range(pocket)->high == 3);
}

TEST_CASE("an angle range may wrap through 0 and be written with negative degrees") {
  const auto [from, to, low, high] = GENERATE(table<double, double, double, double>({{350, 10, 350, 370},
                                                                                     {-10, 10, 350, 370},
                                                                                     {0, 360, 0, 360},
                                                                                     {90, 90, 90, 90},
                                                                                     {360, 10, 0, 10},
                                                                                     {200, 100, 200, 460},
                                                                                     {-360, 0, 0, 360},
                                                                                     {-1e-20, 10, 0, 10},
                                                                                     {-10.1, 349.9, 349.9, 709.9}}));
  const Puzzle p = read_puzzle(minimal({{"angle", {from, to}}}));
  CHECK(p.angle->low == Approx(radians(low)).margin(1e-15));
  CHECK(p.angle->high == Approx(radians(high)));
}

TEST_CASE("a pair of equal speeds is one speed, which leaves the arrival free") {
  const Puzzle pair = read_puzzle(minimal({{"speed", {2, 2}}})), one = read_puzzle(minimal({{"speed", 2}}));
  CHECK(pair.speed.fixed());
  CHECK(write_puzzle(pair) == write_puzzle(one));
  CHECK(!arrival_range(pair));
}

TEST_CASE("a count of cushions is exact and a lower bound alone raises the upper one") {
  CHECK(read_puzzle(minimal({{"cushions", 20000}})).cushions.min == 20000);
  CHECK(read_puzzle(minimal({{"cushions", {{"min", 5}}}})).cushions.max == 5);
  CHECK(read_puzzle(minimal({{"cushions", {{"max", 1}}}})).cushions.min == 0);
  CHECK(read_puzzle(minimal({{"cushions", Json::array()}})).cushions.max == 0);
}

TEST_CASE("the cushion mathavan2010 takes the sliding friction of the cloth and is written back") {
  const Json cushion{{"model", "mathavan2010"}, {"restitution", 0.98}, {"friction", 0.14}, {"height", 0.036}};
  const Json physics{{"model", "spin"}, {"sliding_friction", 0.212}, {"cushion", cushion}};
  Puzzle p = read_puzzle(minimal({{"physics", physics}}));
  auto& c = std::get<Mathavan2010>(p.physics.cushion);
  CHECK(c.restitution.at_rest == 0.98);
  CHECK(c.friction == 0.14);
  CHECK(c.height == 0.036);
  CHECK(c.sliding_friction == 0.212);
  const std::string written = write_puzzle(p);
  CHECK(Json::parse(written)["physics"]["cushion"] == cushion);
  CHECK(write_puzzle(read_puzzle(written)) == written);
  c.sliding_friction = 0.2;
  CHECK_THROWS_AS(validate(p), InvalidInput);
}

TEST_CASE("the cushion stronge, restitution by the square of speed and friction by slip are read and written back") {
  const Json cushion{{"model", "stronge"},
                     {"restitution", {{"at_rest", 0.6}, {"per_speed", 0.3}, {"per_speed2", -0.05}}},
                     {"friction", 0.21},
                     {"height", 0.0365},
                     {"frequency_ratio", 1.7}};
  const Json balls{{"restitution", 0.93}, {"friction", {{"a", 0.01}, {"b", 0.1}, {"c", 1.1}}}};
  const Json physics{{"model", "spin"}, {"cushion", cushion}, {"ball_ball", balls}};
  Puzzle p = read_puzzle(minimal({{"physics", physics}}));
  auto& c = std::get<Stronge>(p.physics.cushion);
  CHECK(c.restitution(2.0) == Approx(0.6 + 0.6 - 0.2));
  CHECK(c.frequency_ratio == 1.7);
  CHECK(p.physics.ball_ball.friction(0.5) == Approx(0.01 + 0.1 * std::exp(-0.55)));
  const std::string written = write_puzzle(p);
  CHECK(Json::parse(written)["physics"]["cushion"] == cushion);
  CHECK(Json::parse(written)["physics"]["ball_ball"] == balls);
  CHECK(write_puzzle(read_puzzle(written)) == written);
  c.frequency_ratio = 2;
  CHECK_THROWS_AS(validate(p), InvalidInput);
  CHECK_THROWS_AS(read_puzzle(minimal({{"physics", {{"model", "spin"}, {"cushion", {{"frequency_ratio", 1.7}}}}}})),
                  InvalidInput);
}

TEST_CASE("writing and reading a puzzle gives the same text") {
  const Json wrap{{"angle", {350.1, 10.3}}, {"noise", {{"angle", 0.1}}}, {"id", 5}, {"cushions", {{"min", 1}}}};
  for (const std::string& text : {std::string(full), minimal(), minimal(wrap), minimal({{"physics", "ideal"}})}) {
    const std::string written = write_puzzle(read_puzzle(text));
    CHECK(write_puzzle(read_puzzle(written)) == written);
  }
  test::Random random(7);
  for (const test::Family family : test::families)
    for (int i = 0; i < 100; ++i) {
      const test::Model model = i % 3 == 0 ? test::Model::ideal : i % 3 == 1 ? test::Model::rolling : test::Model::spin;
      const std::string written = write_puzzle(test::random_puzzle(random, family, model).puzzle);
      CHECK(write_puzzle(read_puzzle(written)) == written);
    }
  for (int i = 0; i < 1000; ++i) {
    const std::string written =
        write_puzzle(read_puzzle(minimal({{"angle", {random.uniform(-360, 360), random.uniform(0, 0.1)}},
                                          {"noise", {{"angle", random.uniform(0, 9)}}}})));
    CHECK(write_puzzle(read_puzzle(written)) == written);
  }
}

TEST_CASE("without a preset of their own cushions are as high as suits the largest ball") {
  const auto height = [](const std::string& table, double cue, double other) {
    const std::string balls = R"(, "ball": {"at": [0.3, 0.3], "radius": )" + std::to_string(cue) +
                              R"(}, "others": [{"id": "1", "at": [0.7, 0.3], "radius": )" + std::to_string(other) +
                              R"(}], "target": {"ball": "1"}})";
    return std::get<Han2005>(read_puzzle(R"({"table": )" + table + balls).physics.cushion).height;
  };
  const std::string own = R"({"length": 2, "width": 1})";
  CHECK(height(own, 0.028, 0.031) == 1.28 * 0.031);
  CHECK(height(own, 0.031, 0.028) == 1.28 * 0.031);
  CHECK(height(own, 0.028, 0.028) == 1.28 * 0.028);
  CHECK(height(R"("pool-9ft")", 0.028575, 0.031) == 1.28 * 0.028575);
  CHECK(height(R"("snooker-12ft")", 0.02625, 0.03) == 0.03675);
  // The height must suit the smallest ball too.
  try {
    height(own, 0.031, 0.018);
    FAIL("that nose is over the smaller ball");
  } catch (const InvalidInput& e) {
    CHECK(e.path == "/physics/cushion/height");
  }
}
