// SPDX-License-Identifier: MIT
//
// A tilted table: compares the path with an independent solution, the closed forms of friction on an incline with
// exponentials in 50 digits. The simulator sums power series in pieces instead. Also tests the energy with the height,
// the motion near standstill and along cushions, and that a slightly tilted table gives almost the path of a level one.
#include <cmath>
#include <vector>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/detail/drag.hpp"
#include "bankshot/detail/on_path.hpp"
#include "bankshot/motion/tilted.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/incline_forms.hpp"
#include "support/models.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr std::uint64_t seed = 23;
constexpr double g = 9.81;

/// A slide and a roll to rest without any contact: where the roll begins, and where and when the ball rests.
struct Whole {
  Long slid, rested;
  Vec2<Long> rolls_at, rests_at;
};
Whole whole(const Tilted& m, const State<double>& s) {
  const Vec2<Long> rise{Long(m.rise.x), Long(m.rise.y)};
  const Long slope = norm(rise), weight(m.g), R(body.radius);
  const Vec2<Long> e = rise * Long(-1 / slope), v{Long(s.velocity.x), Long(s.velocity.y)};
  const Vec2<Long> u{v.x - R * Long(s.spin.y), v.y + R * Long(s.spin.x)};
  const auto slide = carried<Long>(Long(7) / 2 * Long(m.sliding_friction) * weight, slope * weight, e, u, Long(-1));
  const Long t = slide.time, share = Long(2) / 7;
  const Vec2<Long> pull = e * Long(slope * weight * 5 / 7);
  const Vec2<Long> at = to<Long>(s.at) + v * t + (slide.moved - u * t) * share + pull * Long(t * t / 2);
  const Vec2<Long> rolling = v - u * share + pull * t;
  const auto roll =
      carried<Long>(Long(m.rolling_friction.at_rest) * weight, slope * weight * 5 / 7, e, rolling, Long(-1));
  return {t, t + roll.time, at, at + roll.moved};
}

Tilted leaning(Random& r, double steepest) {
  Tilted m;
  static_cast<SlideRoll&>(m) = draw<SlideRoll>(r);
  const double rise = r.log_uniform(1e-6, steepest * m.rolling_friction.at_rest), way = r.uniform(0, radians(360));
  m.rise = {rise * std::cos(way), rise * std::sin(way)};
  return m;
}

State<double> struck(Random& r) {
  const double v = r.log_uniform(0.01, 8), way = r.uniform(0, radians(360));
  return {{0, 0},
          {v * std::cos(way), v * std::sin(way)},
          {r.uniform(-1, 1) * v / body.radius, r.uniform(-1, 1) * v / body.radius, r.uniform(-1, 1) * v / body.radius}};
}

/// A table so large that no ball meets its cushions.
const Table plain = [] {
  Table t = rectangle_table(20000, 20000);
  for (Vec2d& v : t.vertices) v = v - Vec2d{10000, 10000};
  return t;
}();

struct Rest {
  double rolls = -1, rests = -1;
  Vec2d rolls_at{}, rests_at{};
};
Rest run(const Tilted& m, const State<double>& s) {
  static const Boundary boundary(plain, body);
  Simulator sim(boundary, m, AnyCushion{Mirror{}}, s);
  Rest out;
  for (int i = 0; i < 3; ++i) {
    const Event e = sim.step();
    if (e.kind == EventKind::slide_to_roll) out.rolls = sim.time(), out.rolls_at = sim.state().at;
    if (e.kind == EventKind::rest) {
      out.rests = sim.time(), out.rests_at = sim.state().at;
      break;
    }
  }
  return out;
}

double off(const Vec2d& at, const Vec2<Long>& truth) {
  return std::hypot(static_cast<double>(truth.x - at.x), static_cast<double>(truth.y - at.y));
}

}  // namespace

TEST_CASE("a ball on a slope slides, curves and rests where the closed forms say") {
  Random r(seed);
  for (int i = 0; i < 1000; ++i) {
    const Tilted m = leaning(r, 1.3);  // at 7/5 of the friction nothing would rest
    const State<double> s = struck(r);
    INFO("draw " << i << " of seed " << seed << ", rise " << m.rise.x << " " << m.rise.y);
    const Rest found = run(m, s);
    const Whole truth = whole(m, s);
    const double length = static_cast<double>(norm(truth.rests_at)) + 1e-3, lasts = static_cast<double>(truth.rested);
    CHECK(off(found.rolls_at, truth.rolls_at) < 1e-13 * length);
    CHECK(std::abs(static_cast<double>(truth.slid - found.rolls)) < 1e-13 * lasts);
    // If friction barely holds the ball, its final motion is a small difference.
    const double slow = m.rolling_friction.at_rest, steep = slow / (slow - norm(m.rise) * 5 / 7);
    CHECK(off(found.rests_at, truth.rests_at) < 1e-12 * steep * length);
    CHECK(std::abs(static_cast<double>(truth.rested - found.rests)) < 1e-12 * steep * lasts);
  }
}

TEST_CASE("the worked number of detail/incline.hpp") {
  Tilted m;
  m.rise = {0, 0.002};
  const Rest found = run(m, {{0, 0}, {1, 0}, natural_roll(Vec2d{1, 0}, body.radius)});
  CHECK(found.rests == Approx(10.406048).epsilon(1e-7));
  CHECK(found.rests_at.x == Approx(5.122978).epsilon(1e-6));
  CHECK(found.rests_at.y == Approx(-0.3716446).epsilon(1e-6));
}

TEST_CASE("a table that hardly leans is a level one") {
  Random r(seed);
  static const Boundary boundary(plain, body);
  for (int i = 0; i < 300; ++i) {
    Tilted m = leaning(r, 1);
    if (i % 2 == 0) m.rolling_friction.per_speed = r.log_uniform(1e-4, 0.1);
    m.rise = m.rise * (1e-12 / norm(m.rise));
    const State<double> s = struck(r);
    INFO("draw " << i << " of seed " << seed);
    const Rest leans = run(m, s);
    Simulator level(boundary, static_cast<const SlideRoll&>(m), Mirror{}, s);
    while (!level.step().final()) {
    }
    const double length = norm(level.state().at) + 1e-3;
    CHECK(norm(leans.rests_at - level.state().at) < 1e-9 * length);
    CHECK(std::abs(leans.rests - level.time()) < 1e-9 * level.time());
  }
}

TEST_CASE("rolling straight up or down a slope is a level roll with another friction") {
  Random r(seed);
  for (int i = 0; i < 300; ++i) {
    Tilted m = leaning(r, 1);
    m.rolling_friction.per_speed = r.log_uniform(1e-12, 0.1);
    const double rise = norm(m.rise), way = i % 2 == 0 ? 1 : -1, v = r.log_uniform(0.01, 5);
    m.rise = {rise, 0};
    const State<double> s{{0, 0}, {way * v, 0}, natural_roll(Vec2d{way * v, 0}, body.radius)};
    const Rest found = run(m, s);
    const detail::Drag<double> drag{(m.rolling_friction.at_rest + way * rise * 5 / 7) * g,
                                    m.rolling_friction.per_speed * g};
    INFO("draw " << i << " of seed " << seed);
    CHECK(found.rests_at.x == Approx(way * drag.length(v, 0.0)).epsilon(1e-11));
    CHECK(found.rests == Approx(drag.seconds(v, 0.0)).epsilon(1e-11));
    CHECK(found.rests_at.y == 0);
  }
}

TEST_CASE("energy with height: what rolling friction takes is seven fifths of its force times the way") {
  Random r(seed);
  static const Boundary boundary(plain, body);
  for (int i = 0; i < 200; ++i) {
    Physics p = spin_physics();
    const Tilted m = leaning(r, 1.3);
    p.motion = static_cast<const SlideRoll&>(m);
    p.tilt = m.rise;
    const double v = r.log_uniform(0.05, 4), way = r.uniform(0, radians(360));
    State<double> s{{0, 0}, {v * std::cos(way), v * std::sin(way)}, {}};
    s.spin = natural_roll(s.velocity, body.radius);
    Simulator sim(boundary, m, AnyCushion{Mirror{}}, s);
    // Sums the length of the path by Gauss's rule on each piece.
    double length = 0, before = energy(p, body, s), worst = 0;
    const auto add = [&](const Arc<double>& arc, double t) {
      constexpr double node[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
      constexpr double weight[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
      State<double> from{arc.at, arc.velocity, natural_roll(arc.velocity, body.radius)};
      for (int k = 0; k < 4; ++k) {
        const double at = t * (1 + node[k]) / 2;
        length += weight[k] * t / 2 * norm(advance(m, body, from, arc, at).velocity);
      }
      const State<double> end = advance(m, body, from, arc, t);
      const double taken = 1.4 * body.mass * m.rolling_friction.at_rest * g * length;
      worst = std::max(worst, std::abs(energy(p, body, end) + taken - before));
    };
    Event e = sim.step(forever, add);
    CHECK(e.kind == EventKind::rest);
    INFO("draw " << i << " of seed " << seed);
    CHECK(worst < 1e-10 * before);
  }
}

TEST_CASE("what cannot rest rolls down to the lower cushion, along it, and rests in the corner") {
  Physics p = spin_physics();
  p.tilt = {0.03, 0.02};
  ShotRequest shot{.table = rectangle_table(2.54, 1.27), .physics = p, .ball = {.at = {1.2, 0.6}}, .launch = {0.3, 1}};
  const Trajectory t = simulate(shot);
  CHECK(t.end == EventKind::rest);
  const Vec2d end = t.events.back().state.at;
  CHECK(end.x == Approx(body.radius).margin(1e-9));
  CHECK(end.y == Approx(body.radius).margin(1e-9));
  CHECK(!rests(p));
  p.tilt = {0.005, 0.005};
  CHECK(rests(p));
}

TEST_CASE("a ball uphill turns and comes back, where friction does not hold it") {
  Tilted m;
  m.rise = {0.05, 0};
  static const Boundary boundary(plain, body);
  const double v = 1;
  Simulator sim(boundary, m, AnyCushion{Mirror{}},
                State<double>{{0, 0}, {v, 0}, natural_roll(Vec2d{v, 0}, body.radius)});
  const double up = (0.05 * 5 / 7 + 0.01) * g, down = (0.05 * 5 / 7 - 0.01) * g, top = v / up;
  sim.step(top + 2.0);
  CHECK(sim.state().at.x == Approx(v * v / (2 * up) - down * 2).epsilon(1e-12));
  CHECK(sim.state().velocity.x == Approx(-2 * down).epsilon(1e-12));
}

TEST_CASE("derivatives along a leaning path, by the launch and by the slope, are those of differences") {
  Random r(seed);
  const Boundary boundary(rectangle_table(2.54, 1.27), body);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    Tilted m = leaning(r, 1.3);
    if (i % 3 == 0) m.rolling_friction.per_speed = 0.002;
    const double v = r.uniform(1, 4), way = r.uniform(0, radians(360));
    const Vec2d at{r.uniform(0.2, 2.3), r.uniform(0.2, 1)};
    const auto end_of = [&]<class T, class C>(const T& angle, const C& rise) {
      using std::cos, std::sin;
      TiltedOf<C> motion;
      motion.sliding_friction = C(m.sliding_friction);
      motion.rolling_friction = {C(m.rolling_friction.at_rest), C(m.rolling_friction.per_speed)};
      motion.spinning_friction = C(m.spinning_friction);
      motion.rise = {rise, C(m.rise.y)};
      const State<T> s{to<T>(at), Vec2<T>{cos(angle), sin(angle)} * T(v), {T(1), T(2), T(3)}};
      Simulator<T, TiltedOf<C>, MirrorOf<double>> sim(boundary, motion, Mirror{0.9}, s);
      std::vector<EventKind> kinds;
      for (int k = 0; k < 4; ++k) kinds.push_back(sim.step().kind);
      return std::pair(sim.state().at, kinds);
    };
    const auto exact = end_of(Dual<2>(way, 0), Dual<2>(m.rise.x, 1));
    const double h = 1e-6, hs = 1e-7;
    const auto a0 = end_of(way - h, m.rise.x), a1 = end_of(way + h, m.rise.x);
    const auto s0 = end_of(way, m.rise.x - hs), s1 = end_of(way, m.rise.x + hs);
    if (a0.second != a1.second || s0.second != s1.second) continue;
    ++compared;
    INFO("draw " << i << " of seed " << seed);
    const double by_aim = (a1.first.x - a0.first.x) / (2 * h), by_rise = (s1.first.y - s0.first.y) / (2 * hs);
    CHECK(exact.first.x.v[0] == Approx(by_aim).epsilon(1e-5).margin(1e-6));
    CHECK(exact.first.y.v[1] == Approx(by_rise).epsilon(1e-4).margin(1e-5));
  }
  CHECK(compared > 80);
}

TEST_CASE("a path that grazes is met where it falls through 0, or else where it is nearest") {
  // A gap of (t − 1)² − depth that closes at 2 (1 − t), met by its chord where the path opens it again.
  const auto met = [](double depth, double chord) {
    const auto gap = [&](double t) { return std::pair((t - 1) * (t - 1) - depth, 2 * (1 - t)); };
    return detail::time_on_path(
        chord, 0.0, 2.0, [](double t) { return t; }, gap);
  };
  CHECK(met(1e-10, 1 + 1e-6) == Approx(1 - 1e-5).epsilon(1e-12));
  CHECK(met(1e-10, 1 - 2e-5) == Approx(1 - 1e-5).epsilon(1e-12));
  CHECK(met(-1e-10, 1 + 1e-6) == Approx(1).epsilon(1e-12));
  CHECK(met(-1e-10, 1 - 1e-6) == Approx(1).epsilon(1e-12));
}

TEST_CASE("a ball that a leaning table presses to a rail leaves it where the rail ends") {
  const Scene scene = preset_scene("pool-9ft");
  ShotRequest shot{.table = scene.table, .physics = scene.physics, .ball = scene.ball, .launch = {1.2, 0}};
  shot.ball.at = {1.8, scene.ball.body.radius};
  shot.spin = {1, 0, 0};
  for (const double rise : {1e-5, 1e-3, 1e-2}) {
    shot.physics.tilt = {0, rise};
    const Trajectory t = simulate(shot);
    INFO("rise " << rise);
    CHECK(t.end == EventKind::pocket);
    CHECK(t.cushions == 0);
  }
}
