// SPDX-License-Identifier: MIT
//
// The unit of a document's positions and lengths.
#include "bankshot/scene/json.hpp"
#include "bankshot/scene/recording.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

std::string refused(const std::string& text) {
  try {
    read_puzzle(text);
  } catch (const InvalidInput& e) {
    return e.path + ": " + e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a puzzle in centimetres, millimetres or inches is the one in metres") {
  struct Case {
    const char* unit;
    double size;
  };
  const auto [unit, size] = GENERATE(Case{"m", 1}, Case{"cm", 0.01}, Case{"mm", 0.001}, Case{"in", 0.0254});
  const auto in_unit = [size = size](double metres) { return std::to_string(metres / size); };
  const Puzzle p =
      read_puzzle(R"({"unit": ")" + std::string(unit) + R"(", "table": {"length": )" + in_unit(2.54) +
                  R"(, "width": )" + in_unit(1.27) + R"(}, "ball": {"at": [)" + in_unit(0.635) + ", " + in_unit(0.4) +
                  R"(], "radius": )" + in_unit(0.03) + R"(}, "target": {"point": [)" + in_unit(1.9) + ", " +
                  in_unit(0.6) + R"(], "within": )" + in_unit(0.05) + R"(}, "noise": {"tip": 0.001, "at": 0.002}})");
  CHECK(p.table.highest().x == Approx(2.54));
  CHECK(p.ball.at.x == Approx(0.635));
  CHECK(p.ball.body.radius == Approx(0.03));
  CHECK(point_of(p.target)->at.y == Approx(0.6));
  CHECK(point_of(p.target)->within == Approx(0.05));
  CHECK(p.noise.tip == 0.001);
  CHECK(p.noise.at == 0.002);
}

TEST_CASE("diamonds count along both sides of the table, for positions alone") {
  const Puzzle p = read_puzzle(R"({"unit": "diamond", "table": "pool-9ft", "ball": {"at": [2, 2], "radius": 0.028},
    "others": [{"id": "8", "at": [6, 1]}], "target": {"ball": "8", "then": {"point": [7, 3], "within": 0.05}}})");
  CHECK(p.ball.at.x == Approx(2.54 / 4));
  CHECK(p.ball.at.y == Approx(1.27 / 2));
  CHECK(p.ball.body.radius == 0.028);
  CHECK(p.others.front().at.y == Approx(1.27 / 4));
  CHECK(point_of(p.target)->at.x == Approx(2.54 * 7 / 8));
  CHECK(point_of(p.target)->within == 0.05);
}

TEST_CASE("shots and recordings have units, too") {
  const ShotRequest shot = read_shot(R"({"unit": "in", "table": "pool-9ft", "ball": {"at": [25, 16]},
    "shot": {"speed": 2, "angle": 30}, "until": {"length": 100}})");
  CHECK(shot.ball.at.x == Approx(0.635));
  CHECK(*shot.until.length == Approx(2.54));
  const Recording seen = read_recording(R"({"unit": "diamond", "table": "pool-9ft", "ball": {"at": [2, 1]},
    "track": {"cue": [[0, 2, 1], [0.1, 2.5, 1], [0.2, 3, 1]]}, "rest": {"cue": [5, 1]}})");
  REQUIRE(seen.tracks.size() == 1);
  CHECK(seen.tracks.front().samples[2].at.x == Approx(2.54 * 3 / 8));
  CHECK(seen.tracks.front().rest->y == Approx(1.27 / 4));
}

TEST_CASE("diamonds need a rectangle, and errors quote what was written") {
  CHECK(refused(R"({"unit": "diamond", "table": {"vertices": [[0, 0], [2, 0], [1, 1.5]]}, "ball": {"at": [1, 0.5]},
    "target": {"point": [1, 0.6]}})") == "/unit: \"diamond\" needs a rectangular table");
  CHECK(refused(R"({"unit": "inch", "table": "pool-9ft", "ball": {"at": [1, 0.5]}, "target": {"pocket": "any"}})")
            .find("/unit") == 0);
  CHECK(refused(R"({"unit": "in", "table": "pool-9ft", "ball": {"at": ["a", 16]}, "target": {"pocket": "any"}})") ==
        "/ball/at/0: \"a\" must be a number");
}
