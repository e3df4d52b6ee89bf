// SPDX-License-Identifier: MIT
//
// Compares the seed article's shot with a table of events derived by hand. At 45 degrees without loss the path is a
// straight line in the unfolded table. The ball meets a cushion after (gap + k·span)·√2 metres, where span is the side
// of the table less 2 R. It has travelled s metres after t = (v0 − √(v0² − 2 a s)) / a seconds, with a = 0.05 · 9.81.
#include <algorithm>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

constexpr double R = 0.0285, length = 2.5, width = 1.25, v0 = 5, a = 0.05 * 9.81;

ShotRequest article() {
  return {.table = make_table(*find_table_preset("seed")),
          .physics = {Rolling{.friction = 0.05}, Mirror{1}},
          .ball = {{0.2, 0.2}, R, 0.17},
          .launch = {v0, radians(45)}};
}

struct Expected {
  double path;
  std::string cushion;
};

std::vector<Expected> by_hand() {
  const double stop = v0 * v0 / (2 * a), root2 = std::sqrt(2.0);
  std::vector<Expected> events;
  for (int k = 0;; ++k) {
    const double s = (length - R - 0.2 + k * (length - 2 * R)) * root2;
    if (s > stop) break;
    events.push_back({s, k % 2 == 0 ? "right" : "left"});
  }
  for (int k = 0;; ++k) {
    const double s = (width - R - 0.2 + k * (width - 2 * R)) * root2;
    if (s > stop) break;
    events.push_back({s, k % 2 == 0 ? "top" : "bottom"});
  }
  std::sort(events.begin(), events.end(), [](const auto& x, const auto& y) { return x.path < y.path; });
  return events;
}

}  // namespace

TEST_CASE("the seed article's example agrees with the events derived by hand") {
  const ShotRequest shot = article();
  const Trajectory t = simulate(shot);
  const std::vector<Expected> expected = by_hand();
  REQUIRE(t.cushions == static_cast<int>(expected.size()));
  REQUIRE(expected.size() == 22);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Record& e = t.events[i + 1];
    CHECK(contact_name(shot.table, e.contact) == expected[i].cushion);
    CHECK(e.time == Approx((v0 - std::sqrt(v0 * v0 - 2 * a * expected[i].path)) / a).epsilon(1e-12));
  }
  CHECK(t.end == EventKind::rest);
  CHECK(t.length == Approx(v0 * v0 / (2 * a)).epsilon(1e-13));
  CHECK(t.events.back().time == Approx(v0 / a).epsilon(1e-13));
}

TEST_CASE("its first events, as numbers") {
  const Trajectory t = simulate(article());
  // Meets the top cushion after 1.0215·√2 = 1.44462 m, at x = 0.2 + 1.0215.
  CHECK(t.events[1].time == Approx(0.293139).margin(1e-6));
  CHECK(t.events[1].state.at.x == Approx(1.2215).epsilon(1e-13));
  CHECK(t.events[1].state.at.y == 1.25 - R);
  CHECK(t.events[1].state.velocity.y < 0);
  CHECK(norm(t.events[1].state.velocity) == Approx(5 - a * 0.293139).margin(1e-6));
}

TEST_CASE("a shot can be stopped by time, by cushions or by length") {
  ShotRequest shot = article();
  shot.until.time = 1.0;
  CHECK(simulate(shot).events.back().time == 1.0);
  shot.until = {.cushions = 3};
  CHECK(simulate(shot).cushions == 3);
  shot.until = {.length = 10.0};
  const Trajectory t = simulate(shot);
  CHECK(t.length == Approx(10).epsilon(1e-14));
  CHECK(t.end == EventKind::horizon);
}
