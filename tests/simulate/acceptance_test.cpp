// SPDX-License-Identifier: MIT
//
// Compares what pockets accept with published widths and with the openings that planners aim at.
#include "bankshot/simulate/acceptance.hpp"

#include <algorithm>

#include "bankshot/geometry/opening.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

namespace bankshot {
namespace {

using Catch::Detail::Approx;

constexpr int corner = 0, middle = 1;

Scene pool(const char* jaws) {
  return read_scene(std::string(R"({"preset": "pool-7ft", "jaws": )") + jaws + "}", R"("spin")");
}

double drops(const Scene& scene, int pocket, int degrees, double speed) {
  return 1e3 * acceptance(scene, pocket, speed).width(degrees, Entry::rattles);
}

}  // namespace

TEST_CASE("as many parallel lines drop as published", "[heavy]") {
  constexpr double grid = 0.6;  // one line of the grid [mm]
  const Scene jaws = pool("true");
  const struct {
    int pocket, degrees;
    double slow, fast;  // width at 1 and at 3 m/s [mm]
  } published[] = {{corner, 0, 78.5, 70.5},
                   {corner, 20, 92.5, 62.5},
                   {corner, 35, 95, 57.5},
                   {middle, 0, 93.5, 90.5},
                   {middle, 50, 45.5, 44.5}};
  for (const auto& [pocket, degrees, slow, fast] : published) {
    INFO(pocket << ", " << degrees << " degrees");
    CHECK(drops(jaws, pocket, degrees, 1) == Approx(slow).margin(grid));
    CHECK(drops(jaws, pocket, degrees, 3) == Approx(fast).margin(grid));
    CHECK(drops(jaws, pocket, -degrees, 1) == drops(jaws, pocket, degrees, 1));
  }
  const Acceptance in_corner = acceptance(pool("false"), corner, 1), in_middle = acceptance(pool("false"), middle, 1);
  CHECK(1e3 * in_corner.width(0, Entry::clean) == Approx(32.5).margin(grid));
  CHECK(1e3 * in_corner.width(20, Entry::clean) == Approx(30.5).margin(grid));
  CHECK(1e3 * in_corner.width(35, Entry::clean) == Approx(26.5).margin(grid));
  CHECK(1e3 * in_middle.width(0, Entry::clean) == Approx(124.5).margin(grid));
  CHECK(1e3 * in_middle.width(50, Entry::clean) == Approx(87).margin(grid));
}

TEST_CASE("the lines that drop cleanly are those of the opening, at every speed", "[heavy]") {
  for (const char* jaws : {"true", "false"})
    for (const char* preset : {"pool-9ft", "snooker-12ft"}) {
      const Scene scene =
          read_scene(std::string(R"({"preset": ")") + preset + R"(", "jaws": )" + jaws + "}", R"("spin")");
      const Boundary boundary(scene.table, scene.ball.body);
      for (const int pocket : {corner, middle}) {
        const Vec2d out = view(scene.table, scene.table.pockets[static_cast<std::size_t>(pocket)]).out;
        const auto arcs = openings(boundary, boundary.pockets[static_cast<std::size_t>(pocket)]);
        REQUIRE(arcs.size() == 1);
        const Acceptance slow = acceptance(scene, pocket, 0.5), fast = acceptance(scene, pocket, 5);
        int clean = 0;
        for (int degree = -slow.steepest; degree <= slow.steepest; ++degree) {
          const double a = radians(degree);
          const auto gap = arcs.front().gap(out * std::cos(a) + perpendicular(out) * std::sin(a), 0);
          for (int k = -slow.widest; k <= slow.widest; ++k) {
            const double offset = k * Acceptance::step, inside = std::min(offset - gap.low, gap.high - offset);
            constexpr double rounding = 1e-9;  // m
            if (std::abs(inside) < rounding) continue;
            INFO(preset << ", jaws " << jaws << ", pocket " << pocket << ", " << degree << " degrees, " << offset
                        << " m");
            // Almost parallel to a rail, a ball may touch the rail before the pocket, which the opening does not count.
            const bool along_rail = slow.steepest - std::abs(degree) < 10;
            if (inside < 0 || !along_rail) {
              CHECK((slow.at(degree, k) == Entry::clean) == (inside > 0));
              CHECK((fast.at(degree, k) == Entry::clean) == (inside > 0));
            }
            clean += slow.at(degree, k) == Entry::clean;
          }
        }
        CHECK(clean > 500);
      }
    }
}

TEST_CASE("a pocket in the open has no window") {
  const Scene scene = read_scene(
      R"({"length": 2, "width": 1, "pockets": [{"name": "hole", "at": [1, 0.5], "radius": 0.06}]})", R"("spin")");
  CHECK_THROWS_WITH(acceptance(scene, 0, 1), "stands in the open: balls come from all sides");
}

}  // namespace bankshot
