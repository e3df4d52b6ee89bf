// SPDX-License-Identifier: MIT
//
// Compares all shots at a fixed speed with brute force that shares only the simulator with the planners. The aim goes
// in steps of 0.02 degrees, every change of cushions is bisected, and every change of the target's side is a shot. A
// longer run by hand: test_plan "[long]"
#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"
#include "support/seed.hpp"

using namespace bankshot;

namespace {

constexpr int most_cushions = 3;

/// The legs of one aim, and for each leg on which side the target lies, if the leg passes it.
struct Aimed {
  double angle;
  std::vector<Contact> contacts;
  std::array<std::optional<double>, most_cushions + 1> side;
};

struct Found {
  std::vector<Contact> contacts;
  double angle;
};

class BruteForce {
 public:
  BruteForce(const Puzzle& p) : p_(p), boundary_(p.table, p.ball.body), target_(std::get<PointTarget>(p.target).at) {}

  std::vector<Found> run() {
    constexpr int steps = 18000;
    Aimed before = aim(0);
    for (int i = 1; i <= steps; ++i) {
      Aimed after = aim(radians(360.0 / steps) * i);
      between(before, after);
      before = after;
    }
    return found_;
  }

 private:
  Aimed aim(double angle) {
    return with_physics(p_.physics, [&](const auto& motion, const auto& cushion) {
      Aimed out{angle, {}, {}};
      Simulator sim(boundary_, motion, cushion,
                    launched(p_.ball.at, p_.ball.body.radius, direction(wrap_angle(angle)) * p_.speed.low, p_.spin));
      double nearest = 1e300;
      bool in_place = true;
      for (;;) {
        const Event e = sim.step();
        const double t = detail::closest_time(sim.arc(), sim.travelled(), target_);
        const Vec2d off = target_ - sim.arc().position(t), v = sim.arc().tangent(t);
        if (t > 0 && t < sim.travelled() && norm(off) < nearest) {
          nearest = norm(off);
          out.side[out.contacts.size()] = cross(v, off);
        }
        if (e.kind == EventKind::slide_to_roll) continue;
        if (e.final() || out.contacts.size() == most_cushions) return out;
        in_place = in_place && norm(sim.state().at - p_.ball.at) <= boundary_.touch;
        if (in_place && (in_vertex_ || out.contacts.size() == 2)) return out;  // a leg of length zero does not count
        out.contacts.push_back(e.contact);
        nearest = 1e300;
      }
    });
  }

  static std::size_t agree(const Aimed& a, const Aimed& b) {
    return static_cast<std::size_t>(
        std::mismatch(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end()).first -
        a.contacts.begin());
  }

  void between(const Aimed& a, const Aimed& b) {
    constexpr double finest = 1e-9;  // rad
    const std::size_t same = agree(a, b);
    for (std::size_t k = 0; k <= same && k <= std::min(a.contacts.size(), b.contacts.size()); ++k)
      if (a.side[k] && b.side[k] && (*a.side[k] > 0) != (*b.side[k] > 0)) root(a, b, k);
    if (a.contacts == b.contacts || b.angle - a.angle < finest) return;
    const Aimed middle = aim((a.angle + b.angle) / 2);
    // The roots of the legs that agree were already found between the ends.
    if (a.contacts != middle.contacts) later(a, middle, same);
    if (middle.contacts != b.contacts) later(middle, b, same);
  }

  /// Searches only the legs after the first `same`.
  void later(const Aimed& a, const Aimed& b, std::size_t same) {
    constexpr double finest = 1e-9;
    const std::size_t now = agree(a, b);
    for (std::size_t k = same + 1; k <= now && k <= std::min(a.contacts.size(), b.contacts.size()); ++k)
      if (a.side[k] && b.side[k] && (*a.side[k] > 0) != (*b.side[k] > 0)) root(a, b, k);
    if (a.contacts == b.contacts || b.angle - a.angle < finest) return;
    const Aimed middle = aim((a.angle + b.angle) / 2);
    later(a, middle, std::max(same, now));
    later(middle, b, std::max(same, now));
  }

  void root(Aimed a, Aimed b, std::size_t k) {
    const std::vector<Contact> contacts(a.contacts.begin(), a.contacts.begin() + static_cast<long>(k));
    for (int i = 0; i < 40; ++i) {
      const Aimed m = aim((a.angle + b.angle) / 2);
      if (m.contacts.size() < k || !std::equal(contacts.begin(), contacts.end(), m.contacts.begin()) || !m.side[k])
        return;
      ((*m.side[k] > 0) == (*a.side[k] > 0) ? a : b) = m;
    }
    found_.push_back({contacts, a.angle});
  }

  const Puzzle& p_;
  Boundary boundary_;
  Vec2d target_;
  bool in_vertex_ = p_.ball.body.radius == 0 && std::ranges::any_of(p_.table.vertices, [&](const Vec2d& vertex) {
                      return norm(vertex - p_.ball.at) <= boundary_.touch;
                    });
  std::vector<Found> found_;
};

/// Draws a rectangle and a launch with spin.
Puzzle anywhere(test::Random& random) {
  const double length = random.log_uniform(1, 4), width = length * random.uniform(0.4, 1),
               speed = random.uniform(1, 3) * std::sqrt(length);
  const auto place = [&] { return Vec2d{random.uniform(0.05, length - 0.05), random.uniform(0.05, width - 0.05)}; };
  Puzzle p{.table = rectangle_table(length, width), .physics = spin_physics()};
  p.ball.at = place();
  p.target = PointTarget{place()};
  p.spin = {random.uniform(-1, 1.2), random.uniform(-1, 1), 0};
  p.speed = {speed, speed};
  return p;
}

/// Draws such a puzzle with a point very close to a rail.
Puzzle hugging(test::Random& random) {
  Puzzle p = anywhere(random);
  const Boundary boundary(p.table, p.ball.body);
  const Wall& wall = boundary.walls[static_cast<std::size_t>(random.integer(0, 3))];
  p.target = PointTarget{wall.from + (wall.to - wall.from) * random.uniform(0.05, 0.95) +
                         wall.normal * random.log_uniform(1e-5, 1e-3)};
  return p;
}

/// Draws a ball without spin frozen to a cushion or in a corner, on a rectangle or a convex polygon.
Puzzle frozen(test::Random& random) {
  Puzzle p{.table = rectangle_table(random.uniform(1, 3), random.uniform(1, 3)), .physics = ideal_physics()};
  if (random.chance(0.5)) p.table = test::random_polygon(random, true);
  if (random.chance(0.7)) p.physics = {Rolling{}, Mirror{random.uniform(0.4, 1)}};
  const double radius = random.chance(0.3) ? 0 : 0.01;
  p.ball.body.radius = radius;
  const Boundary boundary(p.table, p.ball.body);
  const Wall& wall =
      boundary.walls[static_cast<std::size_t>(random.integer(0, static_cast<int>(boundary.walls.size()) - 1))];
  p.ball.at = random.chance(0.2) ? wall.from : wall.from + (wall.to - wall.from) * random.uniform(0.02, 0.98);
  const auto inside = [&] {
    for (;;) {
      const Vec2d low = p.table.lowest(), high = p.table.highest(),
                  at{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
      if (boundary.clearance(at) > 1e-3) return at;
    }
  };
  p.target = PointTarget{inside()};
  p.speed = {8, 8};  // fast enough for three cushions
  return p;
}

/// Draws a convex polygon of three to eight cushions and a launch with spin.
Puzzle on_polygon(test::Random& random) {
  for (;;) {
    Puzzle p{.table = test::random_polygon(random, true), .physics = spin_physics()};
    const Boundary boundary(p.table, p.ball.body);
    const double speed = random.uniform(1, 3) * std::sqrt(boundary.diagonal);
    const auto place = [&] {
      const Vec2d low = p.table.lowest(), high = p.table.highest();
      return Vec2d{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    };
    const Vec2d at = place(), target = place();
    p.spin = {random.uniform(-1, 1.2), random.uniform(-1, 1), 0};
    p.speed = {speed, speed};
    p.ball.at = at;
    p.target = PointTarget{target};
    if (boundary.clearance(at) > 0.01 && boundary.clearance(target) > 0.01) return p;
  }
}

void compare(int puzzles, std::uint64_t seed, Puzzle (*draw)(test::Random&)) {
  test::Random random(seed);
  std::size_t by_force = 0, missed = 0;
  for (int i = 0; i < puzzles; ++i) {
    Puzzle p = draw(random);
    p.cushions = {.min = 0, .max = most_cushions};
    p.budget = 10000000;
    const std::vector<Shot> all = solve(p, {.all = true, .robustness = false}).shots;
    for (const Found& f : BruteForce(p).run()) {
      const auto same = [&](const Shot& x) {
        return x.path.cushions == f.contacts &&
               std::abs(wrap_angle(x.launch.angle - f.angle + radians(180)) - radians(180)) < 1e-7;
      };
      ++by_force;
      if (std::any_of(all.begin(), all.end(), same)) continue;
      ++missed;
      UNSCOPED_INFO("puzzle " << i << " of seed " << seed << ": " << f.contacts.size() << " cushions at "
                              << degrees(f.angle) << " degrees: " << write_puzzle(p));
    }
  }
  INFO(missed << " of " << by_force << " shots missed");
  CHECK(missed == 0);  // comes first, because the next assertion discards the notes on each shot
  CHECK(by_force > 5 * static_cast<std::size_t>(puzzles));
  if (puzzles >= 200) WARN(missed << " of " << by_force << " shots missed");
}

}  // namespace

TEST_CASE("all shots at a fixed speed are those of brute force") { compare(20, 23, anywhere); }

TEST_CASE("all shots of a ball frozen to a cushion are those of brute force, into it too") { compare(40, 31, frozen); }

TEST_CASE("all shots past a point beside a rail are those of brute force") { compare(130, 37, hugging); }

TEST_CASE("all shots at a fixed speed are those of brute force, at length", "[.][long]") {
  compare(200, test::seed_or_fresh(23), anywhere);
}

TEST_CASE("all shots of a ball frozen to a cushion are those of brute force, at length", "[.][long]") {
  compare(1000, test::seed_or_fresh(31), frozen);
}

TEST_CASE("all shots past a point beside a rail are those of brute force, at length", "[.][long]") {
  compare(1000, test::seed_or_fresh(37), hugging);
}

TEST_CASE("all shots on a convex polygon are those of brute force, at length", "[.][long]") {
  compare(1000, test::seed_or_fresh(41), on_polygon);
}
