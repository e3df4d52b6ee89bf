// SPDX-License-Identifier: MIT
//
// Requirements on every motion: no energy gained, the same path in a mirror, turned and moved, phases that follow each
// other without a jump, derivatives. Also tests the closed forms of a ball that slides and rolls.
#include <limits>

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/dual.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr int draws = 2000;

/// True for the motion whose arcs do not end by themselves.
template <class Motion>
constexpr bool never_ends = std::is_same_v<Motion, Ideal>;

/// Returns true when two states on an arc agree to a multiple of the rounding of |v| + R|ω|. An arc with drag is a
/// function of the place. Near its rest, speed and time are square roots of the remaining length, so the square of the
/// speed is compared there.
bool alike(const State<double>& a, const State<double>& b, double roundings, double scale, const Arc<double>& arc) {
  if (arc.drag.linear == 0) return difference(a, b) <= roundings * scale;
  const double squares = std::abs(dot(a.velocity, a.velocity) - dot(b.velocity, b.velocity));
  return squares <= roundings * scale * scale && difference(a, b) <= std::sqrt(roundings) * scale;
}

/// Returns the motion whose forces at twice the speed are those of this one.
template <class Motion>
Motion at_twice_the_speed(Motion motion) {
  if constexpr (std::is_same_v<Motion, Dragging>) motion.rolling_friction.per_speed /= 2;
  return motion;
}
constexpr std::uint64_t seed = 17;

/// Draws a time within the arc, sometimes its end; an arc without end counts as one second.
double some_time(Random& r, const Arc<double>& arc) {
  return (arc.duration < forever ? arc.duration : 1) * (r.chance(0.2) ? 1 : r.uniform(0, 1));
}

/// Returns the state with the spin of natural roll if the motion does not carry spin.
template <class Motion>
State<double> whole(const Motion& motion, State<double> s) {
  s.spin = motion.spin(body, s);
  return s;
}

template <class Motion>
State<double> after(const Motion& motion, const State<double>& s, double t) {
  return whole(motion, advance(motion, body, s, motion.arc(body, s), t));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("energy never grows along an arc, nor where it ends", "", Motions) {
  Random r(seed);
  int ended = 0;
  for (int i = 0; i < draws; ++i) {
    const auto motion = draw<TestType>(r);
    const State<double> s = draw_state_of(motion, r);
    const Arc<double> arc = motion.arc(body, s);
    double before = energy_of(s);
    INFO("draw " << i << " of seed " << seed);
    for (const double part : {0.0, 0.3, 0.6, 1.0}) {
      const double now = energy_of(after(motion, s, part * (arc.duration < forever ? arc.duration : 1)));
      REQUIRE(now <= before * (1 + 1e-14));
      before = now;
    }
    if (!(arc.duration < forever)) continue;
    ++ended;
    State<double> end = advance(motion, body, s, arc, arc.duration);
    motion.finish(body, end, arc);
    REQUIRE(energy_of(whole(motion, end)) <= energy_of(s) * (1 + 1e-14));
    REQUIRE(alike(whole(motion, end), after(motion, s, arc.duration), 1e-14, scale_of(s), arc));  // no jump
  }
  CHECK(ended == (never_ends<TestType> ? 0 : draws));
}

TEMPLATE_LIST_TEST_CASE("a motion is the same in a mirror, turned and moved", "", Motions) {
  Random r(seed);
  for (int i = 0; i < draws; ++i) {
    const auto motion = draw<TestType>(r);
    const State<double> s = draw_state_of(motion, r);
    const double t = some_time(r, motion.arc(body, s)), angle = r.uniform(0, 6.28),
                 room = norm(s.at) + norm(s.velocity) * t;
    const State<double> end = after(motion, s, t), in_mirror = after(motion, mirrored(s), t),
                        in_turn = after(motion, turned(s, angle), t);
    State<double> moved = s;
    moved.at += {3, -5};
    const State<double> away = after(motion, moved, t);
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(in_mirror.at == mirrored(end).at);
    REQUIRE(difference(in_mirror, mirrored(end)) == 0);
    REQUIRE(norm(in_turn.at - turned(end.at, angle)) <= 1e-14 * room);
    REQUIRE(alike(in_turn, turned(end, angle), 3e-14, scale_of(s), motion.arc(body, s)));
    REQUIRE(norm(away.at - end.at - Vec2d{3, -5}) <= 1e-14 * (10 + room));
    REQUIRE(difference(away, end) == 0);
  }
}

TEMPLATE_LIST_TEST_CASE("speed scales time, and its square length", "", Motions) {
  Random r(seed);
  for (int i = 0; i < draws; ++i) {
    const auto motion = draw<TestType>(r);
    const State<double> s = draw_state_of(motion, r);
    const Arc<double> arc = motion.arc(body, s), fast = at_twice_the_speed(motion).arc(body, times(s, 2));
    INFO("draw " << i << " of seed " << seed);
    if (!(arc.duration < forever)) {
      REQUIRE(fast.velocity == arc.velocity * 2.0);
      continue;
    }
    REQUIRE(fast.seconds(fast.duration) == Approx(2 * arc.seconds(arc.duration)).epsilon(1e-14));
    if (arc.drag.linear == 0) REQUIRE(fast.duration == 2 * arc.duration);
    REQUIRE(norm((fast.position(fast.duration) - s.at) - (arc.position(arc.duration) - s.at) * 4.0) <=
            1e-14 * (norm(s.at) + norm(s.velocity) * fast.duration));
  }
}

TEMPLATE_LIST_TEST_CASE("derivatives of a motion agree with differences", "", Motions) {
  using Dual = bankshot::Dual<7>;
  Random r(seed);
  double worst = 0;
  int sharp = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    const auto motion = draw<TestType>(r);
    const State<double> s = draw_state_of(motion, r);
    const Arc<double> arc = motion.arc(body, s);
    const double t = (arc.duration < forever ? arc.duration : 1) * r.uniform(0.1, 0.8);
    State<Dual> dual{to<Dual>(s.at), to<Dual>(s.velocity), {Dual(s.spin.x), Dual(s.spin.y), Dual(s.spin.z)}};
    for (int k = 0; k < 7; ++k) number_of(dual, k).v[k] = 1;
    State<Dual> end = advance(motion, body, dual, motion.arc(body, dual), Dual(t));
    const double V = scale_of(s), unit[] = {1, 1, V, V, V / ball_radius, V / ball_radius, V / ball_radius};
    // A rolling ball that is moved rolls on, so its spin changes with its velocity.
    const bool rolls = !TestType::straight && arc.end == PhaseEnd::rest;
    for (int in = 0; in < (TestType::straight || rolls ? 4 : 6); ++in)
      for (int out = 0; out < 4; ++out) {
        const auto f = [&](double h) {
          State<double> moved = s;
          number_of(moved, in) += h * unit[in];
          if (rolls) moved.spin = natural_roll(moved.velocity, body.radius);
          State<double> e = advance(motion, body, moved, motion.arc(body, moved), t);
          return number_of(e, out) / unit[out];
        };
        const Slope slope = ridders(f, 1e-2);
        const double dual_slope = number_of(end, out).v[in] * unit[in] / unit[out];
        INFO("draw " << i << " of seed " << seed << ", d" << out << "/d" << in);
        REQUIRE(std::abs(slope.value - dual_slope) <= 1e-9 * (1 + std::abs(dual_slope)) + 10 * slope.error);
        ++all;
        if (!(slope.error < 1e-10)) continue;  // the differences have too few digits
        ++sharp;
        worst = std::max(worst, std::abs(slope.value - dual_slope));
      }
  }
  REQUIRE(worst < 1e-8);
  CHECK(sharp > all * 8 / 10);
}

TEST_CASE("a ball struck in the centre rolls after 2v/(7 mu g), 12v^2/(49 mu g), at 5/7 of its speed") {
  for (const double v : {1e-6, 0.3, 2.0, 30.0})
    for (const double mu : {0.05, 0.2}) {
      const SlideRoll motion{.sliding_friction = mu};
      const State<double> s{{0, 0}, {0.6 * v, -0.8 * v}};
      const Arc<double> arc = motion.arc(body, s);
      const double a = mu * motion.g;
      CHECK(arc.end == PhaseEnd::roll);
      CHECK(arc.duration == Approx(2 * v / (7 * a)).epsilon(1e-15));
      CHECK(norm(arc.position(arc.duration)) == Approx(12 * v * v / (49 * a)).epsilon(1e-15));
      CHECK(norm(arc.velocity_at(arc.duration)) == Approx(5 * v / 7).epsilon(1e-15));
    }
}

TEST_CASE("a ball launched with spin s rolls at (5 + 2s)/7 of its speed") {
  const double v = 1.7;
  for (const double s : {-3.0, -1.0, -0.5, 0.5, 0.999, 1.25, 4.0}) {
    const SlideRoll motion;
    const Vec2d forward{0.8, 0.6};
    State<double> state = launched(Vec2d{0, 0}, body.radius, forward * v, LaunchSpin{.top = s});
    const Arc<double> arc = motion.arc(body, state);
    state = advance(motion, body, state, arc, arc.duration);
    motion.finish(body, state, arc);
    CHECK(dot(state.velocity, forward) == Approx((5 + 2 * s) / 7 * v).epsilon(1e-14).margin(1e-15));
    CHECK(motion.slip(body, state) == Vec2d{0, 0});
  }
}

TEST_CASE("without masse the path of a slide is straight, with it the slip keeps its direction") {
  Random r(seed);
  for (int i = 0; i < draws; ++i) {
    const SlideRoll motion = draw<SlideRoll>(r);
    const State<double> s = draw_state(r);
    const Arc<double> arc = motion.arc(body, s);
    const Vec2d u = motion.slip(body, s), half = motion.slip(body, advance(motion, body, s, arc, arc.duration / 2));
    REQUIRE(norm(half - u * 0.5) <= 1e-14 * scale_of(s));
    REQUIRE(std::abs(cross(u, arc.acceleration)) <= 1e-15 * norm(u) * norm(arc.acceleration));
  }
}

TEST_CASE("vertical spin stops after 2R w/(5 mu g) and never changes its sign") {
  const SlideRoll motion;
  const double w = 40, stop = w * 2 * body.radius / (5 * motion.spinning_friction * motion.g);
  State<double> s{{0, 0}, {3, 0}, {0, 3 / body.radius, w}};
  const Arc<double> arc = motion.arc(body, s);
  REQUIRE(arc.duration > stop);
  CHECK(advance(motion, body, s, arc, stop / 2).spin.z == Approx(w / 2).epsilon(1e-14));
  CHECK(std::abs(advance(motion, body, s, arc, stop).spin.z) < 1e-13);
  CHECK(advance(motion, body, s, arc, stop * 1.5).spin.z == 0);
  s.spin.z = -w;
  CHECK(advance(motion, body, s, arc, stop / 2).spin.z == Approx(-w / 2).epsilon(1e-14));
}

TEST_CASE("as friction goes to 0 a slide becomes a straight line of constant speed") {
  const State<double> s{{0, 0}, {1, 0.5}, {3, -2, 1}};
  Vec2d last{};
  for (const double mu : {1e-2, 1e-5, 1e-8, 0.0}) {
    const Arc<double> arc = SlideRoll{.sliding_friction = mu}.arc(body, s);
    CHECK((mu == 0 ? arc.duration == forever : arc.duration > 0.01 / (mu * 9.81)));
    last = arc.position(0.5);
    CHECK(norm(last - s.velocity * 0.5) <= mu * 9.81 * 0.125 * (1 + 1e-12) + 1e-15);
  }
  CHECK(last == s.velocity * 0.5);
}
