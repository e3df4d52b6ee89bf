// SPDX-License-Identifier: MIT
//
// Requirements on a contact of two balls. It keeps momentum, the spin about the line of centres, restitution and energy
// to rounding. It is the same seen from either ball, in a mirror and turned. Throw follows its formula.
#include <algorithm>
#include <cmath>

#include "bankshot/contact/ball_ball.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/testing/cushion_promises.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

constexpr std::uint64_t seed = 41;

struct Two {
  Body body1, body2;
  State<double> first, second;
};

State<double> draw_state(Random& r, double radius) {
  const double v = r.chance(0.2) ? 0 : r.log_uniform(1e-3, 10), w = r.chance(0.3) ? 0 : v / radius;
  const double way = r.uniform(0, 7);
  const auto spin = [&] { return w * r.uniform(-1.5, 1.5); };
  return {{0, 0}, {v * std::cos(way), v * std::sin(way)}, {spin(), spin(), spin()}};
}

/// Draws two balls in contact that approach each other faster than in a persistent contact.
Two draw(Random& r) {
  for (;;) {
    Two two{{r.uniform(0.02, 0.04), r.log_uniform(0.02, 1)}, {r.uniform(0.02, 0.04), r.log_uniform(0.02, 1)}, {}, {}};
    if (r.chance(0.3)) two.body2 = two.body1;
    two.first = draw_state(r, two.body1.radius);
    two.second = draw_state(r, two.body2.radius);
    const double way = r.uniform(0, 7), apart = touching_distance(two.body1, two.body2);
    const Vec2d n{std::cos(way), std::sin(way)};
    two.first.at = {r.uniform(0, 2), r.uniform(0, 1)};
    two.second.at = two.first.at + n * apart;
    if (BallBall::approach(two.first, two.second, n) > 2 * tolerance::slow_contact) return two;
  }
}

double energy(const Two& t) {
  return t.body1.mass * energy_of(t.first, t.body1.radius) + t.body2.mass * energy_of(t.second, t.body2.radius);
}

Vec2d normal_of(const Two& t) {
  const Vec2d d = t.second.at - t.first.at;
  return d / norm(d);
}

Two collided(const BallBall& law, Two t) {
  law.collide(t.body1, t.first, t.body2, t.second);
  return t;
}

double scale(const Two& t) { return scale_of(t.first, t.body1.radius) + scale_of(t.second, t.body2.radius); }

double difference(const Two& a, const Two& b) {
  return difference(a.first, b.first, a.body1.radius) + difference(a.second, b.second, a.body2.radius);
}

}  // namespace

TEST_CASE("a contact of two balls keeps momentum, restitution, spin about the line of centres, and energy", "[heavy]") {
  Random r(seed);
  double momentum = 0, part = 0, about = 0, gained = -1, kept = 0;
  constexpr int draws = 1000000;
  for (int i = 0; i < draws; ++i) {
    const Two t = draw(r);
    const BallBall law{r.chance(0.2)   ? 1.0
                       : r.chance(0.2) ? 0.0
                                       : r.uniform(0, 1),
                       r.chance(0.2) ? 0 : r.uniform(0, 0.5)};
    const Two u = collided(law, t);
    const Vec2d n = normal_of(t);
    const double m1 = t.body1.mass, m2 = t.body2.mass, most = scale(t) * (1 + std::max(m1 / m2, m2 / m1));
    const Vec2d before = t.first.velocity * m1 + t.second.velocity * m2,
                after = u.first.velocity * m1 + u.second.velocity * m2;
    momentum = std::max(momentum, norm(after - before) / ((m1 + m2) * scale(t)));
    const double came = BallBall::approach(t.first, t.second, n), went = -BallBall::approach(u.first, u.second, n);
    part = std::max(part, std::abs(went - law.restitution * came) / most);
    const auto turns = [&](const State<double>& s) { return s.spin.x * n.x + s.spin.y * n.y; };
    about = std::max(about, std::abs(turns(u.first) - turns(t.first)) * t.body1.radius / most);
    about = std::max(about, std::abs(turns(u.second) - turns(t.second)) * t.body2.radius / most);
    gained = std::max(gained, energy(u) / energy(t) - 1);
    if (law.restitution == 1 && law.friction == 0) kept = std::max(kept, std::abs(energy(u) / energy(t) - 1));
    REQUIRE((u.first.at == t.first.at && u.second.at == t.second.at));
  }
  INFO("seed " << seed);
  CHECK(momentum < 1e-15);
  CHECK(part < 1e-15);
  CHECK(about < 1e-15);
  CHECK(gained < 3e-15);
  CHECK(kept < 3e-15);
}

TEST_CASE("a contact is the same seen from the other ball, in a mirror, turned, and twice as fast") {
  Random r(seed);
  for (int i = 0; i < 20000; ++i) {
    const Two t = draw(r);
    const BallBall law{r.uniform(0, 1), r.uniform(0, 0.5)};
    const Two u = collided(law, t);
    const double angle = r.uniform(0, 6.28),
                 most = 1e-14 * scale(t) * (1 + t.body1.mass / t.body2.mass + t.body2.mass / t.body1.mass);
    const auto each = [&](auto f) { return Two{t.body1, t.body2, f(t.first), f(t.second)}; };
    const auto of = [&](auto f) { return Two{u.body1, u.body2, f(u.first), f(u.second)}; };
    const auto mirror = [](const State<double>& s) { return mirrored(s); };
    const auto turn = [&](const State<double>& s) { return turned(s, angle); };
    const auto twice = [](State<double> s) {
      s.velocity = s.velocity * 2.0;
      s.spin = {2 * s.spin.x, 2 * s.spin.y, 2 * s.spin.z};
      return s;
    };
    INFO("draw " << i << " of seed " << seed);
    const Two other = collided(law, {t.body2, t.body1, t.second, t.first});
    REQUIRE(difference({u.body2, u.body1, u.second, u.first}, other) <= most);
    REQUIRE(difference(of(mirror), collided(law, each(mirror))) <= most);
    REQUIRE(difference(of(turn), collided(law, each(turn))) <= 30 * most);  // turning rounds the centres
    REQUIRE(difference(of(twice), collided(law, each(twice))) == 0);
  }
}

TEST_CASE("a slow contact takes all the approach and turns nothing, but not where balls are elastic") {
  const Body body{0.028575, 0.17};
  Two t{body, body, {{0, 0}, {0.9e-4, 0.3}, {1, 2, 3}}, {{2 * body.radius, 0}, {0, 0}, {0, 0, 0}}};
  const Two slow = collided({}, t), elastic = collided({1, 0, false}, t);
  CHECK(slow.first.velocity.x == Approx(0.45e-4));
  CHECK(slow.second.velocity.x == Approx(0.45e-4));
  CHECK(slow.first.velocity.y == 0.3);
  CHECK(slow.first.spin == t.first.spin);
  CHECK(slow.second.spin == t.second.spin);
  CHECK(elastic.second.velocity.x == Approx(0.9e-4));
  CHECK(elastic.first.velocity.x == 0);
}

TEST_CASE("throw is that of Alciatore's TP A.14 with constant friction") {
  Random r(seed);
  const Body body{0.028575, 0.17};
  const double R = body.radius;
  for (int i = 0; i < 2000; ++i) {
    // The cue ball moves along x; the object ball's centre lies at the cut angle φ.
    const double v = r.uniform(0.5, 5), phi = r.uniform(-1.4, 1.4), mu = r.uniform(0.01, 0.2);
    const double roll = r.uniform(-1, 1) * v / R, side = r.uniform(-1, 1) * v / R;
    Two t{body, body, {{0, 0}, {v, 0}, {0, roll, side}}, {{2 * R * std::cos(phi), 2 * R * std::sin(phi)}, {}, {}}};
    const Two u = collided({1, mu}, t);
    const double along = v * std::sin(phi) - R * side, up = R * roll * std::cos(phi);
    const double share = std::min(mu * v * std::cos(phi) / std::hypot(along, up), 1.0 / 7);
    const double thrown = std::atan(share * along / (v * std::cos(phi)));
    const Vec2d out = u.second.velocity;
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(std::atan2(out.y, out.x) - phi == Approx(-thrown).margin(1e-14));
  }
}

TEST_CASE("the largest throw of a stun shot with Alciatore's friction by slip speed") {
  // TP A.14 with μ = 9.951e-3 + 0.108 exp(−1.088 s), equal balls and e = 1, evaluated on a fine grid.
  const Body body{0.028575, 0.17};
  const double R = body.radius;
  const BallBall law{1, {9.951e-3, 0.108, 1.088}};
  for (const auto& [speed, most, at] : {std::tuple{0.447, 5.302, 33.0}, {1.341, 3.875, 25.4}, {3.129, 2.698, 18.3}}) {
    double largest = 0, cut = 0;
    for (int i = 1; i < 8900; ++i) {
      const double phi = radians(i / 100.0);
      const Two t{body, body, {{0, 0}, {speed, 0}, {}}, {{2 * R * std::cos(phi), 2 * R * std::sin(phi)}, {}, {}}};
      const Vec2d out = collided(law, t).second.velocity;
      const double thrown = degrees(phi - std::atan2(out.y, out.x));
      if (thrown > largest) largest = thrown, cut = i / 100.0;
    }
    CHECK(largest == Approx(most).margin(6e-4));
    CHECK(cut == Approx(at).margin(0.06));
  }
}

TEST_CASE("derivatives of a contact are those of differences, also where nothing slips") {
  using D = Dual<2>;
  const Body body{0.028575, 0.17};
  const BallBall by_slip{0.95, {0.01, 0.1, 1.1}};
  for (const auto& [slips, law] :
       {std::pair{true, BallBall{}}, {false, BallBall{}}, {true, by_slip}, {false, by_slip}}) {
    const auto run = [&, slips = slips, law = law](const D& speed, const D& side) {
      State<D> a{{D(0), D(0)}, {speed, D(0.2)}, {D(0), D(0), slips ? side * 40.0 : D(0)}};
      State<D> b{{D(0.05), D(std::sqrt(0.05715 * 0.05715 - 0.0025))}, {D(0), D(0)}, {D(0), D(0), D(0)}};
      if (!slips) a.velocity = Vec2<D>{b.at.x * speed, b.at.y * speed};
      law.collide(body, a, body, b);
      return b;
    };
    const State<D> at = run(D(1.3, 0), D(0.7, 1));
    constexpr double h = 1e-6;
    for (int k = 0; k < 2; ++k) {
      const State<D> more = run(D(1.3 + (k == 0 ? h : 0)), D(0.7 + (k == 1 ? h : 0))),
                     less = run(D(1.3 - (k == 0 ? h : 0)), D(0.7 - (k == 1 ? h : 0)));
      CHECK(at.velocity.x.v[k] == Approx((more.velocity.x.a - less.velocity.x.a) / (2 * h)).margin(1e-8));
      CHECK(at.velocity.y.v[k] == Approx((more.velocity.y.a - less.velocity.y.a) / (2 * h)).margin(1e-8));
      CHECK(at.spin.z.v[k] == Approx((more.spin.z.a - less.spin.z.a) / (2 * h)).margin(1e-6));
    }
  }
}
