// SPDX-License-Identifier: MIT
//
// A preset is the same in C++ and in a file: every coefficient of every table and physics, to the last bit.
#include "bankshot/scene/scene.hpp"

#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

void same(const Ideal&, const Ideal&) {}
void same(const Rolling& a, const Rolling& b) {
  CHECK(a.friction == b.friction);
  CHECK(a.g == b.g);
}
void same(const SlideRoll& a, const SlideRoll& b) {
  CHECK(a.sliding_friction == b.sliding_friction);
  CHECK(a.rolling_friction.at_rest == b.rolling_friction.at_rest);
  CHECK(a.rolling_friction.per_speed == b.rolling_friction.per_speed);
  CHECK(a.spinning_friction == b.spinning_friction);
  CHECK(a.g == b.g);
}
void same(const Restitution& a, const Restitution& b) {
  CHECK(a.at_rest == b.at_rest);
  CHECK(a.per_speed == b.per_speed);
  CHECK(a.per_speed2 == b.per_speed2);
}
template <template <class> class Law>
void same(const Law<double>& a, const Law<double>& b) {
  same(a.restitution, b.restitution);
  std::vector<double> ours, theirs;
  for_each_number(a, [&](double number) { ours.push_back(number); });
  for_each_number(b, [&](double number) { theirs.push_back(number); });
  CHECK(ours == theirs);
}
void same(const CustomCushion&, const CustomCushion&) { FAIL("no preset has a cushion of one's own"); }

template <class... Of>
void same(const std::variant<Of...>& a, const std::variant<Of...>& b) {
  REQUIRE(a.index() == b.index());
  std::visit([&](const auto& x) { same(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
}

void same(const Scene& a, const Scene& b) {
  CHECK(a.table.vertices == b.table.vertices);
  CHECK(a.table.cushions == b.table.cushions);
  REQUIRE(a.table.pockets.size() == b.table.pockets.size());
  for (std::size_t i = 0; i < a.table.pockets.size(); ++i) {
    CHECK(a.table.pockets[i].name == b.table.pockets[i].name);
    CHECK(a.table.pockets[i].at == b.table.pockets[i].at);
    CHECK(a.table.pockets[i].radius == b.table.pockets[i].radius);
  }
  CHECK(a.ball.at == b.ball.at);
  CHECK(a.ball.body == b.ball.body);
  same(a.physics.motion, b.physics.motion);
  same(a.physics.cushion, b.physics.cushion);
}

}  // namespace

TEST_CASE("a preset is the same in C++ and in JSON") {
  int compared = 0;
  for (const TablePreset& preset : table_presets())
    for (const std::string physics : {"ideal", "rolling", "spin"}) {
      INFO(preset.name << ", " << physics);
      same(preset_scene(preset.name, physics), read_scene('"' + std::string(preset.name) + '"', '"' + physics + '"'));
      ++compared;
    }
  CHECK(compared >= 18);
}

TEST_CASE("the cushions of snooker and carom have heights of their own, others go with the ball") {
  const auto height = [](std::string_view name) {
    return std::get<Han2005>(preset_scene(name).physics.cushion).height;
  };
  CHECK(height("snooker-12ft") == 0.03675);
  CHECK(height("carom-10ft") == 0.037);
  CHECK(height("seed") == 1.28 * 0.0285);
}

TEST_CASE("names that no preset has are named") {
  CHECK_THROWS_WITH(preset_scene("pool-10ft"), Catch::Contains("pool-10ft"));
  CHECK_THROWS_WITH(preset_scene("seed", "glide"), Catch::Contains("glide"));
}
