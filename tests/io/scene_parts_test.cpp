// SPDX-License-Identifier: MIT
//
// The parts of a scene: physics, balls, launches and tables, read from JSON and written to it.
#include <functional>

#include "bankshot/scene/scene.hpp"
#include "io/scene/read_physics.hpp"
#include "io/scene/read_shot.hpp"
#include "io/scene/read_table.hpp"
#include "io/scene/write_scene.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

Physics physics_of(const Json& scene) { return read_physics(Reader(scene), Ball{}); }

Table table_of(const Json& table, double radius = Body{}.radius) { return read_table(Reader(table), radius); }

/// Returns the path of what is wrong; "valid" if nothing is.
std::string wrong(const std::function<void()>& read) {
  try {
    read();
  } catch (const InvalidInput& e) {
    return e.path;
  }
  return "valid";
}

}  // namespace

TEST_CASE("restitution is a number, or falls with the speed") {
  const Json one = 0.8, of_speed{{"at_rest", 0.9}, {"per_speed", -0.02}, {"per_speed2", 0.001}}, high = 1.2;
  CHECK(read_restitution(Reader(one)).at_rest == 0.8);
  CHECK(read_restitution(Reader(one)).constant());
  const Restitution e = read_restitution(Reader(of_speed));
  CHECK(e.at_rest == 0.9);
  CHECK(e.per_speed == -0.02);
  CHECK(e.per_speed2 == 0.001);
  CHECK(wrong([&] { read_restitution(Reader(high, "/e")); }) == "/e");
}

TEST_CASE("each physics is what its name says, and spin is the default") {
  CHECK(is_ideal(physics_of({{"table", "seed"}, {"physics", "ideal"}})));
  CHECK(std::holds_alternative<Rolling>(physics_of({{"table", "seed"}, {"physics", "rolling"}}).motion));
  CHECK(carries_spin(physics_of({{"table", "seed"}})));
  const Physics tilted = physics_of({{"table", {{"preset", "seed"}, {"tilt", {0.001, -0.002}}}}});
  CHECK(tilted.tilt == Vec2d{0.001, -0.002});
  CHECK(wrong([] { physics_of({{"table", "seed"}, {"physics", "sticky"}}); }) == "/physics");
  CHECK(wrong([] { physics_of({{"table", "seed"}, {"physics", 3}}); }) == "/physics");
}

TEST_CASE("what is written of a physics reads back to the same numbers") {
  Physics p = spin_physics();
  auto& motion = std::get<SlideRoll>(p.motion);
  motion.sliding_friction = 0.17;
  motion.rolling_friction = {0.009, 0.001};
  p.ball_ball.restitution = 0.93;
  p.ball_ball.friction = {0.01, 0.1, 1};
  p.errors = CoefficientErrors{{"sliding_friction"}, {1e-4}};
  for (const CushionVariant& cushion :
       {CushionVariant(Han2005{.height = 0.037, .friction = 0.3}), CushionVariant(Mirror{0.7}),
        CushionVariant(Mathavan2010{.friction = 0.15, .sliding_friction = 0.17}),
        CushionVariant(Stronge{.height = 0.037, .restitution = 0.8, .friction = 0.2, .frequency_ratio = 1.7})}) {
    p.cushion = cushion;
    const Json written = physics_json(p);
    const Physics again = physics_of({{"table", "seed"}, {"physics", written}});
    CHECK(again.cushion.index() == cushion.index());
    CHECK(physics_json(again) == written);
    CHECK(std::get<SlideRoll>(again.motion).rolling_friction.per_speed == 0.001);
    CHECK(again.ball_ball == p.ball_ball);
    REQUIRE(again.errors);
    CHECK(again.errors->covariance == std::vector<double>{1e-4});
  }
  p.cushion = CustomCushion{};
  CHECK(wrong([&] { physics_json(p); }) == "/physics/cushion");
  CHECK(physics_json(ideal_physics()) == "ideal");
}

TEST_CASE("what is written of a table reads back to the same table") {
  std::vector<Table> tables;
  for (const TablePreset& preset : table_presets()) tables.push_back(make_table(preset));
  tables.push_back(rectangle_table(2.5, 1.25));
  tables.push_back(polygon_table({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}));
  tables.back().pockets = {{"well", {0.5, 0.5}, 0.06}};
  tables.push_back(rectangle_table(3, 2));
  tables.back().own.resize(4);
  tables.back().own[2].restitution = Restitution{0.6};
  tables.back().own[3].friction = 0.3;
  for (const Table& table : tables) {
    const Json written = table_json(table, {});
    INFO(write_json(written));
    CHECK(table_of(written) == table);
  }
  CHECK(table_json(tables.front(), {}) == std::string(table_presets().front().name));
  const Json tilted = table_json(tables.front(), {0, 0.001});
  CHECK(tilted["tilt"] == Json{0, 0.001});
}

TEST_CASE("a preset brings its ball, and a table of one's own the usual one") {
  const Json preset = "snooker-12ft", changed{{"preset", "snooker-12ft"}, {"jaws", false}}, own{{"length", 2}};
  CHECK(preset_of(Reader(preset)) == find_table_preset("snooker-12ft"));
  CHECK(preset_of(Reader(changed)) == find_table_preset("snooker-12ft"));
  CHECK(preset_of(Reader(own)) == nullptr);
  CHECK(default_ball(Reader(preset)).body == find_table_preset("snooker-12ft")->body);
  CHECK(default_ball(Reader(own)).body == Body{});
  CHECK(wrong([] { table_of({{"length", 2}, {"width", 1}, {"mouth", {{"corner", 0.1}}}}); }) == "/mouth");
  CHECK(wrong([] { table_of({{"length", 2}, {"width", -1}}); }) == "/width");
  CHECK(wrong([] { table_of(Json::array()); }).empty());  // the table itself
}

TEST_CASE("a setting takes its defaults from the table and the cue ball") {
  const Json doc{{"table", "snooker-12ft"},
                 {"ball", {{"at", {1, 0.5}}, {"mass", 0.15}}},
                 {"others", {{{"id", "red"}, {"at", {2, 0.5}}}, {{"id", "big"}, {"at", {2, 1}}, {"radius", 0.03}}}}};
  ShotRequest shot;
  read_setting(Reader(doc), shot);
  const Body preset = find_table_preset("snooker-12ft")->body;
  CHECK(shot.ball.body.radius == preset.radius);
  CHECK(shot.ball.body.mass == 0.15);
  REQUIRE(shot.others.size() == 2);
  CHECK(shot.others[0].body == shot.ball.body);
  CHECK(shot.others[1].body.radius == 0.03);
  CHECK(shot.others[1].id == "big");
  // Written, others keep only what differs from the cue ball.
  const Json written = others_json(shot.others, shot.ball.body);
  CHECK(!written[0].contains("radius"));
  CHECK(written[1]["radius"] == 0.03);
  CHECK(!written[1].contains("mass"));
}

TEST_CASE("a launch is read in degrees, and its spin goes before the ball's") {
  const Json doc{{"table", "seed"},
                 {"ball", {{"at", {1, 0.5}}, {"spin", {{"top", 0.5}}}}},
                 {"shot", {{"speed", 2}, {"angle", -90}, {"planner", "images"}}}};
  ShotRequest shot;
  read_setting(Reader(doc), shot);
  CHECK(read_launch(Reader(doc), shot));
  CHECK(shot.launch.speed == 2);
  CHECK(shot.launch.angle == radians(270));
  CHECK(shot.spin.top == 0.5);
  Json own = doc;
  own["shot"]["spin"] = {{"side", -0.3}};
  CHECK(read_launch(Reader(own), shot));
  CHECK(shot.spin == LaunchSpin{.side = -0.3});
  own.erase("shot");
  CHECK(!read_launch(Reader(own), shot));
  const Json launch = launch_json({2, radians(30)}, {.side = 0.25});
  CHECK(launch["speed"] == 2.0);
  CHECK(radians(launch["angle"].get<double>()) == radians(30));
  CHECK(launch["spin"] == Json{{"top", 0.0}, {"side", 0.25}, {"masse", 0.0}});
}

TEST_CASE("only the physics spin knows spins, but natural roll may stand where answers print it") {
  const Json rolls{{"top", 1}}, side{{"side", 0.1}};
  const Physics rolling = rolling_physics();
  CHECK(read_spin(Reader(rolls), rolling, true) == LaunchSpin{});
  CHECK(wrong([&] { read_spin(Reader(rolls, "/spin"), rolling, false); }) == "/spin");
  CHECK(wrong([&] { read_spin(Reader(side, "/spin"), rolling, true); }) == "/spin");
  CHECK(read_spin(Reader(side), spin_physics(), false).side == 0.1);
}

TEST_CASE("identifiers and sequences are refused where they make no sense") {
  const Json good{{"id", 7}}, bad{{"id", {1}}}, none = Json::object();
  CHECK(read_id(Reader(good), "7") == "7");
  CHECK(read_id(Reader(none), "") == "");
  CHECK(wrong([&] { read_id(Reader(bad), "[1]"); }) == "/id");
  CHECK(id_json("") == Json());
  CHECK(id_json("1.50") == 1.5);
  const Table l = polygon_table({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Json sequence{"c0", "v3", "c5"}, unknown{"c0", "c9"};
  CHECK(read_sequence(Reader(sequence), l) ==
        std::vector<Contact>{Contact::rail(0), Contact::vertex(3), Contact::rail(5)});
  CHECK(wrong([&] { read_sequence(Reader(unknown), l); }) == "/1");
  CHECK(pair_json({1, -2}) == Json{1.0, -2.0});
  CHECK(ball_json({{1, 2}, {.radius = 0.03, .mass = 0.2}})["radius"] == 0.03);
}
