// SPDX-License-Identifier: MIT
//
// Tables as a document describes them: presets, pocket layouts and their sizes.
#include <nlohmann/json.hpp>

#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using Json = nlohmann::json;

namespace {

Puzzle with_table(const Json& table, std::optional<double> radius = {}) {
  Json p{{"table", table}, {"physics", "ideal"}, {"ball", {{"at", {0.5, 0.4}}}}, {"target", {{"point", {0.5, 0.5}}}}};
  if (radius) p["ball"]["radius"] = *radius;
  return read_puzzle(p.dump());
}

}  // namespace

TEST_CASE("presets have the published sizes, balls and mouths") {
  struct Preset {
    const char* name;
    double length, width, radius, mass, corner, middle;
  };
  const Preset p = GENERATE(values<Preset>({{"pool-7ft", 1.9812, 0.9906, 0.028575, 0.170097, 0.118, 0.137},
                                            {"pool-8ft", 2.2352, 1.1176, 0.028575, 0.170097, 0.118, 0.137},
                                            {"pool-9ft", 2.54, 1.27, 0.028575, 0.170097, 0.116, 0.129},
                                            {"snooker-12ft", 3.569, 1.778, 0.02625, 0.1406, 0.083, 0.087},
                                            {"carom-10ft", 2.84, 1.42, 0.03075, 0.21, 0, 0},
                                            {"seed", 2.5, 1.25, 0.0285, 0.17, 0, 0}}));
  INFO(p.name);
  const Puzzle z = with_table({{"preset", p.name}, {"jaws", false}});
  CHECK(z.table.is_rectangle());
  CHECK(z.table.lowest() == Vec2d{0, 0});
  CHECK(z.table.highest() == Vec2d{p.length, p.width});
  CHECK(z.ball.body.radius == p.radius);
  CHECK(z.ball.body.mass == p.mass);
  if (p.corner == 0) {
    CHECK(z.table.pockets.empty());
    CHECK(with_table(p.name).table == z.table);
    return;
  }
  const Table jaws = with_table(p.name).table;
  CHECK(with_table({{"preset", p.name}}).table == jaws);
  REQUIRE(jaws.pockets[1].jaws);
  CHECK(jaws.pockets[0].jaws->mouth == p.corner);
  CHECK(jaws.pockets[1].jaws->mouth == p.middle);
  REQUIRE(z.table.pockets.size() == 6);
  CHECK(z.table.pockets[0].radius == p.corner / 2);
  CHECK(z.table.pockets[1].radius == p.middle / 2);
}

TEST_CASE("six pockets of one's own table have jaws where asked, as large as the ball") {
  const Table t =
      with_table({{"length", 3}, {"width", 1.5}, {"pockets", "six"}, {"jaws", true}, {"mouth", {{"corner", 0.12}}}})
          .table;
  REQUIRE(t.pockets[0].jaws);
  CHECK(t.pockets[0].jaws->mouth == 0.12);
  CHECK(t.pockets[1].jaws->mouth == 0.137);
  CHECK(t.pockets[1].radius == Approx(0.0645));
  CHECK(t.pockets[1].at.y == Approx(-0.0685));
}

TEST_CASE("six pockets stand in the corners and in the middle of the long cushions") {
  const Table t = with_table({{"length", 2}, {"width", 1}, {"pockets", "six"}}).table;
  const std::vector<std::pair<std::string, Vec2d>> places{{"bottom-left", {0, 0}},  {"bottom-middle", {1, 0}},
                                                          {"bottom-right", {2, 0}}, {"top-left", {0, 1}},
                                                          {"top-middle", {1, 1}},   {"top-right", {2, 1}}};
  REQUIRE(t.pockets.size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(t.pockets[i].name == places[i].first);
    CHECK(t.pockets[i].at == places[i].second);
    CHECK(t.pockets[i].radius == Approx((i % 3 == 1 ? 0.137 : 0.118) / 2));
  }
}

TEST_CASE("pockets of a custom table grow with the ball unless the mouth is given") {
  const Json table{{"length", 2}, {"width", 1}, {"pockets", "six"}};
  for (const double radius : {0.02, 0.028575, 0.05}) {
    const Table t = with_table(table, radius).table;
    CHECK(t.pockets[0].radius == Approx(0.118 / 2 * radius / 0.028575));
    CHECK(t.pockets[1].radius == Approx(0.137 / 2 * radius / 0.028575));
  }
  Json wide = table;
  wide["mouth"] = {{"corner", 0.2}, {"middle", 0.3}};
  CHECK(with_table(wide, 0.05).table.pockets[0].radius == 0.1);
  CHECK(with_table(wide, 0.05).table.pockets[1].radius == 0.15);
  wide["mouth"] = {{"corner", 0.2}};
  CHECK(with_table(wide).table.pockets[1].radius == Approx(0.137 / 2));
}

TEST_CASE("a point ball makes the six pockets points") {
  const Table t = with_table({{"length", 2}, {"width", 1}, {"pockets", "six"}}, 0).table;
  for (const Pocket& p : t.pockets) CHECK(p.radius == 0);
}

TEST_CASE("tables have no pockets unless asked, and no jaws means no jaws") {
  CHECK(with_table({{"length", 2}, {"width", 1}}).table.pockets.empty());
  CHECK(with_table({{"length", 2}, {"width", 1}, {"pockets", "none"}, {"jaws", false}}).table.pockets.empty());
  CHECK(with_table({{"length", 2}, {"width", 1}}).table.cushions ==
        std::vector<std::string>{"bottom", "right", "top", "left"});
}

TEST_CASE("a polygon names its edges c0, c1, ... unless told otherwise") {
  const Json vertices{{0, 0}, {2, 0}, {0, 2}};
  CHECK(with_table({{"vertices", vertices}}).table.cushions == std::vector<std::string>{"c0", "c1", "c2"});
  CHECK(with_table({{"vertices", vertices}, {"names", {"a", "b", "c"}}}).table.cushions ==
        std::vector<std::string>{"a", "b", "c"});
}

TEST_CASE("a mouth belongs to six pockets") {
  const Json mouth{{"corner", 0.1}};
  const auto refuses = [](const Json& table) { CHECK_THROWS_WITH(with_table(table), Catch::Contains("\"six\"")); };
  refuses({{"length", 2}, {"width", 1}, {"mouth", mouth}});
  refuses({{"length", 2}, {"width", 1}, {"pockets", "none"}, {"mouth", mouth}});
  refuses({{"length", 2}, {"width", 1}, {"pockets", Json::array()}, {"mouth", mouth}});
  refuses({{"vertices", {{0, 0}, {2, 0}, {0, 2}}}, {"mouth", mouth}});
  const Json bad{{"corner", -1}};
  CHECK_THROWS_AS(with_table({{"length", 2}, {"width", 1}, {"pockets", "six"}, {"mouth", bad}}), InvalidInput);
}

TEST_CASE("a level table may say so") {
  CHECK_NOTHROW(with_table({{"length", 2}, {"width", 1}, {"tilt", {0, 0.0}}}));
  for (const Json& tilt :
       {Json{0, 0.001}, Json{0, 1.5}, Json{0}, Json("level"), Json{0, "a"}})  // `ideal` has no gravity
    CHECK_THROWS_AS(with_table({{"length", 2}, {"width", 1}, {"tilt", tilt}}), InvalidInput);
}
