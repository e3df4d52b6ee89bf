// SPDX-License-Identifier: MIT
//
// Compares all shots that stop at a point with brute force that shares only the simulator with the planners. At each
// aim, steps of the speed find where the ball rests abreast of the point, and every change of cushions is bisected. A
// shot lies between two aims that leave the point on different sides of the ball; bisection finds it. Aims between
// which the cushions differ are bisected too. A longer run by hand: test_plan "[long]"
#include <algorithm>
#include <cmath>
#include <sstream>

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

constexpr std::size_t most_cushions = 3;

/// The rest of a launch; the point lies `ahead` and to the `left` of the line of travel there [m].
struct Rest {
  double speed;
  std::vector<Contact> contacts;
  bool rests = false;  ///< true when it met no more cushions than allowed
  double ahead = 0, left = 0;
};

/// One aim, and the speeds at which the ball rests abreast of the point.
struct Aimed {
  double angle;
  std::vector<Rest> abreast;

  std::vector<Rest> along(const std::vector<Contact>& contacts) const {
    std::vector<Rest> out;
    for (const Rest& r : abreast)
      if (r.contacts == contacts) out.push_back(r);
    return out;
  }
};

struct Found {
  std::vector<Contact> contacts;
  double angle, speed;
};

/// Steps of the search.
struct Fineness {
  int aims;           ///< number of aims around the circle
  double speed_step;  ///< step of ln speed
  double root;        ///< width at which the bisection of a root ends [rad]
};

class BruteForce {
 public:
  BruteForce(const Puzzle& p, const Fineness& fine)
      : p_(p), boundary_(p.table, p.ball.body), target_(std::get<PointTarget>(p.target).at), fine_(fine) {}

  std::vector<Found> run() {
    Aimed before = aim(0);
    for (int i = 1; i <= fine_.aims; ++i) {
      Aimed after = aim(radians(360.0) * i / fine_.aims);
      between(before, after);
      before = std::move(after);
    }
    return found_;
  }

 private:
  Rest launch(double angle, double speed) const {
    return with_physics(p_.physics, [&](const auto& motion, const auto& cushion) {
      Rest out{speed, {}};
      Simulator sim(boundary_, motion, cushion,
                    launched(p_.ball.at, p_.ball.body.radius, direction(wrap_angle(angle)) * speed, p_.spin));
      for (;;) {
        const Event e = sim.step();
        if (e.kind == EventKind::slide_to_roll) continue;
        if (e.kind == EventKind::cushion) out.contacts.push_back(e.contact);
        if (out.contacts.size() > most_cushions) return out;
        if (e.kind == EventKind::cushion) continue;
        out.rests = e.kind == EventKind::rest;
        const Vec2d off = target_ - sim.state().at, line = sim.arc().velocity / norm(sim.arc().velocity);
        out.ahead = dot(line, off);
        out.left = cross(line, off);
        return out;
      }
    });
  }

  Aimed aim(double angle) const {
    Aimed out{angle, {}};
    const int steps = static_cast<int>(std::ceil(std::log(p_.speed.high / p_.speed.low) / fine_.speed_step));
    Rest slow = launch(angle, p_.speed.low);
    for (int i = 1; i <= steps; ++i) {
      Rest fast = launch(angle, p_.speed.low * std::pow(p_.speed.high / p_.speed.low, static_cast<double>(i) / steps));
      speeds(angle, slow, fast, out);
      if (!slow.rests && !fast.rests) break;  // too many cushions at all higher speeds
      slow = std::move(fast);
    }
    return out;
  }

  /// Finds a speed between two others at which the ball rests abreast of the point.
  void speeds(double angle, const Rest& slow, const Rest& fast, Aimed& out) const {
    const double finest = fine_.root;  // fraction of the speed
    if (slow.contacts == fast.contacts) {
      if (!slow.rests || !fast.rests || (slow.ahead > 0) == (fast.ahead > 0)) return;
      Rest a = slow, b = fast;
      for (int i = 0; i < 60 && b.speed - a.speed > 1e-3 * fine_.root * b.speed; ++i) {
        Rest m = launch(angle, (a.speed + b.speed) / 2);
        if (m.contacts != a.contacts) return speeds(angle, m, b, out);  // other cushions in between
        ((m.ahead > 0) == (a.ahead > 0) ? a : b) = std::move(m);
      }
      out.abreast.push_back(a);
      return;
    }
    if ((!slow.rests && !fast.rests) || fast.speed - slow.speed < finest * fast.speed) return;
    const Rest middle = launch(angle, (slow.speed + fast.speed) / 2);
    speeds(angle, slow, middle, out);
    speeds(angle, middle, fast, out);
  }

  static bool alike(const Aimed& a, const Aimed& b) {
    return std::equal(a.abreast.begin(), a.abreast.end(), b.abreast.begin(), b.abreast.end(),
                      [](const Rest& x, const Rest& y) { return x.contacts == y.contacts; });
  }

  void between(const Aimed& a, const Aimed& b) {
    const double finest = 100 * fine_.root;
    if (!alike(a, b) && b.angle - a.angle > finest) {
      const Aimed middle = aim((a.angle + b.angle) / 2);
      between(a, middle);
      between(middle, b);
      return;
    }
    for (std::size_t i = 0; i < a.abreast.size(); ++i) {
      const auto& contacts = a.abreast[i].contacts;
      if (i > 0 && a.abreast[i - 1].contacts == contacts) continue;
      const auto from = a.along(contacts), to = b.along(contacts);
      for (std::size_t k = 0; k < from.size() && from.size() == to.size(); ++k)
        if ((from[k].left > 0) != (to[k].left > 0)) root(a, b, contacts, k);
    }
  }

  void root(const Aimed& a, const Aimed& b, const std::vector<Contact>& contacts, std::size_t k) {
    constexpr double jump = 1e3;  // m/rad; the place of rest never moves faster with the aim
    double low = a.angle, high = b.angle;
    const bool left = a.along(contacts)[k].left > 0;
    Rest last = a.along(contacts)[k];
    while (high - low > fine_.root) {
      const Aimed m = aim((low + high) / 2);
      const auto now = m.along(contacts);
      if (k >= now.size()) return;
      last = now[k];
      ((last.left > 0) == left ? low : high) = m.angle;
    }
    if (std::abs(last.left) < jump * fine_.root) found_.push_back({contacts, low, last.speed});  // else a jump
  }

  const Puzzle& p_;
  Boundary boundary_;
  Vec2d target_;
  Fineness fine_;
  std::vector<Found> found_;
};

/// Draws a rectangle, a spin, and a point where the ball is to stop.
Puzzle anywhere(test::Random& random) {
  const double length = random.log_uniform(1, 4), width = length * random.uniform(0.4, 1);
  const auto place = [&] { return Vec2d{random.uniform(0.05, length - 0.05), random.uniform(0.05, width - 0.05)}; };
  Puzzle p{.table = rectangle_table(length, width), .physics = spin_physics()};
  p.ball.at = place();
  p.target = PointTarget{place()};
  p.spin = {random.uniform(-1, 1.2), random.uniform(-1, 1), 0};
  p.speed = {0.15, 4 * std::sqrt(length)};
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

/// Draws such a puzzle on a convex polygon of three to eight cushions.
Puzzle on_polygon(test::Random& random) {
  for (;;) {
    Puzzle p{.table = test::random_polygon(random, true), .physics = spin_physics()};
    const Boundary boundary(p.table, p.ball.body);
    const auto place = [&] {
      const Vec2d low = p.table.lowest(), high = p.table.highest();
      return Vec2d{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    };
    const Vec2d at = place(), target = place();
    p.spin = {random.uniform(-1, 1.2), random.uniform(-1, 1), 0};
    p.speed = {0.15, 4 * std::sqrt(boundary.diagonal)};
    p.ball.at = at;
    p.target = PointTarget{target};
    if (boundary.clearance(at) > 0.01 && boundary.clearance(target) > 0.01) return p;
  }
}

void compare(int puzzles, const Fineness& fine, std::uint64_t seed, Puzzle (*draw)(test::Random&)) {
  test::Random random(seed);
  std::size_t by_force = 0, missed = 0, all_shots = 0;
  std::ostringstream which;
  for (int i = 0; i < puzzles; ++i) {
    Puzzle p = draw(random);
    p.cushions = {.min = 0, .max = static_cast<int>(most_cushions)};
    p.budget = 10000000;
    const std::vector<Shot> all = solve(p, {.all = true, .robustness = false}).shots;
    all_shots += all.size();
    for (const Found& f : BruteForce(p, fine).run()) {
      const auto same = [&](const Shot& x) {
        const double turned = wrap_angle(x.launch.angle - f.angle + radians(180)) - radians(180);
        return x.path.cushions == f.contacts && std::abs(turned) < 10 * fine.root &&
               std::abs(x.launch.speed - f.speed) < 1000 * fine.root * f.speed;
      };
      ++by_force;
      if (std::any_of(all.begin(), all.end(), same)) continue;
      ++missed;
      which << "\npuzzle " << i << " of seed " << seed << ": " << f.contacts.size() << " cushions at "
            << degrees(f.angle) << " degrees, " << f.speed << " m/s: " << write_puzzle(p);
    }
  }
  INFO(missed << " of " << by_force << " shots missed, planner found " << all_shots << which.str());
  CHECK(by_force > 10 * static_cast<std::size_t>(puzzles));
  CHECK(missed == 0);
  if (puzzles > 20) WARN(missed << " of " << by_force << " shots missed; the planner found " << all_shots);
}

}  // namespace

TEST_CASE("all shots that stop at a point are those of brute force", "[heavy]") {
  compare(20, {.aims = 360, .speed_step = 0.1, .root = 1e-6}, 29, anywhere);
}

TEST_CASE("all shots that stop at a point are those of brute force, at length", "[.][long]") {
  compare(200, {.aims = 18000, .speed_step = 0.03, .root = 1e-8}, test::seed_or_fresh(29), anywhere);
}

TEST_CASE("all shots that stop beside a rail are those of brute force, at length", "[.][long]") {
  compare(200, {.aims = 3600, .speed_step = 0.05, .root = 1e-8}, test::seed_or_fresh(37), hugging);
}

TEST_CASE("all shots that stop at a point of a convex polygon are those of brute force, at length", "[.][long]") {
  compare(200, {.aims = 3600, .speed_step = 0.05, .root = 1e-8}, test::seed_or_fresh(41), on_polygon);
}
