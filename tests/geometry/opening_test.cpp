// SPDX-License-Identifier: MIT
//
// Compares the opening of a pocket with its definition: a line leads straight in when it enters the capture circle
// where a ball's centre can be.
#include "bankshot/geometry/opening.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/table.hpp"
#include "support/catch.hpp"
#include "truth/line_in.hpp"

using namespace bankshot;

namespace {

Table preset(const char* name) { return make_table(*find_table_preset(name), false); }

Vec2d entry(const Circle& pocket, const Vec2d& u, double offset) {
  const double ahead = std::sqrt(std::max(pocket.radius * pocket.radius - offset * offset, 0.0));
  return pocket.centre + perpendicular(u) * offset - u * ahead;
}

/// Counts the random lines, those inside the gap, and those on which gap and definition differ.
struct Counted {
  long lines = 0, inside = 0, wrong = 0;
};
Counted compare(const Boundary& boundary, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Counted out;
  for (const Circle& pocket : boundary.pockets) {
    const auto arcs = openings(boundary, pocket);
    for (int i = 0; i < 4000; ++i) {
      const Vec2d u = direction(radians(180) * uniform(random));
      const double offset = pocket.radius * uniform(random);
      const double clearance = boundary.clearance(entry(pocket, u, offset));
      if (std::abs(clearance) < 1e-9) continue;  // within rounding of an end
      const auto leads_in = [&](const Opening& o) {
        const Gap<double> gap = o.gap(u, offset);
        return gap.low < offset && offset < gap.high;
      };
      const auto in = std::ranges::count_if(arcs, leads_in);
      ++out.lines;
      out.inside += in == 1;
      out.wrong += in != (clearance > 0 ? 1 : 0);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("the gap of an opening holds the lines that enter where a ball's centre can be") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  Counted all;
  for (int i = 0; i < 60; ++i) {
    // Rectangles, and a table with a reflex vertex; pockets at vertices, on edges and in the open.
    Table table = i % 3 == 0 ? preset("pool-9ft") : rectangle_table(2 + uniform(random), 1 + uniform(random));
    if (i % 3 == 2) table = polygon_table({{0, 0}, {2, 0}, {2, 1}, {1.2, 1}, {1, 0.6}, {0.8, 1}, {0, 1}});
    if (i % 3 != 0) {
      table.pockets = {{"a", {uniform(random) * 0.1, uniform(random) * 0.1}, 0.05 + uniform(random) * 0.1},
                       {"b", {1, 0.55 + 0.07 * uniform(random)}, 0.06 + 0.05 * uniform(random)},
                       {"c", {1.5, uniform(random) * 0.06}, 0.05 + uniform(random) * 0.1},
                       {"d", {0.5, 0.5}, 0.06}};
    }
    const Counted c = compare(Boundary(table, {}), random);
    CHECK(c.wrong == 0);
    all.lines += c.lines;
    all.inside += c.inside;
  }
  CHECK(all.lines > 500'000);
  CHECK(all.inside > 100'000);
}

TEST_CASE("with jaws the gap holds the lines that touch none of them", "[heavy]") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  long lines = 0, inside = 0;
  for (const TablePreset& preset : table_presets()) {
    if (!preset.jaws) continue;
    const Boundary boundary(make_table(preset, true), preset.body);
    for (const Circle& pocket : boundary.pockets) {
      const auto arcs = openings(boundary, pocket);
      REQUIRE(arcs.size() == 1);
      const Opening& arc = arcs.front();
      const Vec2d in =
          pocket.centre - make_table(preset, false).pockets[static_cast<std::size_t>(pocket.contact.index)].at;
      for (int i = 0; i < 1500; ++i) {
        // Directions out of the table; no other direction leads in.
        const bool corner = std::abs(in.x) > 1e-6;
        const Vec2d u = direction(std::atan2(in.y, in.x) + radians(corner ? 44.9 : 89) * uniform(random));
        const double offset = pocket.radius * uniform(random);
        const Gap<double> gap = arc.gap(u, offset);
        const auto clear = truth::room_of_line(boundary, pocket, u, offset);
        if (clear && std::abs(*clear) < 1e-7) continue;  // within the error of the sampled clearance
        const bool leads_in = clear && *clear > 0, says = gap.low < offset && offset < gap.high;
        CAPTURE(preset.name, pocket.contact.index, u.x, u.y, offset, gap.low, gap.high, clear.value_or(-1));
        CHECK(says == leads_in);
        ++lines;
        inside += says;
      }
    }
  }
  CHECK(lines > 30'000);
  CHECK(inside > 5'000);
}

TEST_CASE("the exact line of a corner keeps an eighth of the gap from its ends") {
  const Boundary boundary(preset("pool-9ft"), {});
  const auto arcs = openings(boundary, boundary.pockets.front());
  REQUIRE(arcs.size() == 1);
  const Opening& corner = arcs.front();
  CHECK(norm(corner.last - corner.first) == Approx(0.0310).epsilon(1e-2));
  const Vec2d u = direction(radians(225));
  CHECK(corner.gap(u, 0).exact() == 0);
  // Lines through the centre go in within 15.5° of the bisector; the clamp begins slightly before that.
  for (const double beside : {-40.0, -20.0, -16.0, 16.0, 20.0, 40.0}) {
    const Vec2d v = direction(radians(225 + beside));
    const Gap<double> gap = corner.gap(v, 0);
    const double width = gap.high - gap.low, exact = gap.exact();
    CHECK(std::min(exact - gap.low, gap.high - exact) == Approx(width / 8));
    CHECK((exact > 0) == (gap.low > 0));
  }
}

TEST_CASE("the offset of the exact line has the derivative that differences show") {
  const Boundary boundary(preset("pool-7ft"), {});
  int checked = 0;
  for (const Circle& pocket : boundary.pockets)
    for (int i = 0; i < 360; ++i) {
      const Opening arc = openings(boundary, pocket).front();
      const double angle = radians(i + 0.3), h = 1e-6;
      const auto exact = [&](double a) { return arc.gap(direction(a), 0).exact(); };
      Vec2<Dual<1>> u{Dual<1>(std::cos(angle)), Dual<1>(std::sin(angle))};
      u.x.v[0] = -std::sin(angle), u.y.v[0] = std::cos(angle);
      const double below = (exact(angle) - exact(angle - h)) / h, above = (exact(angle + h) - exact(angle)) / h;
      if (std::abs(above - below) > 1e-4) continue;  // a kink
      CHECK(arc.gap(u, 0).exact().v[0] == Approx(above).margin(1e-5));
      ++checked;
    }
  CHECK(checked > 2000);
}

TEST_CASE("a pocket in the open, and one without a size, have all of their circle") {
  Table table = rectangle_table(2, 1);
  table.pockets = {{"open", {1, 0.5}, 0.06}, {"point", {0, 0}, 0}};
  const Boundary boundary(table, Body{.radius = 0});
  for (const Circle& pocket : boundary.pockets) {
    const auto arcs = openings(boundary, pocket);
    REQUIRE(arcs.size() == 1);
    CHECK(arcs.front().whole());
    CHECK(arcs.front().gap(direction(radians(30)), 0).exact() == 0);
  }
}
