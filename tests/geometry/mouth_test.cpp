// SPDX-License-Identifier: MIT
#include "sim/geometry/mouth.hpp"

#include <cmath>

#include "bankshot/scene/scene.hpp"
#include "support/catch.hpp"

using namespace bankshot;

TEST_CASE("the mouth of a pocket is mirrored across the table, and begins and ends on its rails") {
  for (const char* name : {"pool-9ft", "snooker-12ft"}) {
    const Table table = preset_scene(name).table;
    const Vec2d size = table.highest();
    const auto jaws = obstacles(table).jaws;
    REQUIRE(jaws.size() == 6);
    for (std::size_t i = 0; i < jaws.size(); ++i) {
      const auto points = mouth(table, jaws[i]);
      const auto on_rail = [&](const Vec2d& p) {
        return std::abs(p.x) < 1e-12 || std::abs(p.y) < 1e-12 || std::abs(p.x - size.x) < 1e-12 ||
               std::abs(p.y - size.y) < 1e-12;
      };
      INFO(name << ", pocket " << table.pockets[i].name);
      CHECK(on_rail(points.front()));
      CHECK(on_rail(points.back()));
      // Facings lie behind the nose lines, except for their ends at the tips.
      const Vec2d back = (points[2] + points[3]) * 0.5;
      CHECK((back.x < 0 || back.x > size.x || back.y < 0 || back.y > size.y));
      // The pocket's own line of symmetry: reversed points lie as far from its centre.
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(norm(points[k] - table.pockets[i].at) ==
              Approx(norm(points[5 - k] - table.pockets[i].at)).epsilon(1e-12));
    }
  }
}
