// SPDX-License-Identifier: MIT
//
// Rolling friction that grows with speed: compares the closed forms with a fine Runge-Kutta run, with 50 digits and
// with their limit of constant friction.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "bankshot/motion/slide_roll.hpp"
#include "bankshot/numbers/dual.hpp"
#include "support/catch.hpp"
#include "support/random_puzzle.hpp"

using namespace bankshot;

namespace {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

struct Rolled {
  double speed, length;
};

/// Integrates v' = -(A + B v), s' = v by the classical Runge-Kutta method.
Rolled integrate(const detail::Drag<double>& d, double v, double seconds, int steps) {
  double s = 0;
  const double h = seconds / steps;
  const auto f = [&](double w) { return -(d.constant + d.linear * w); };
  for (int i = 0; i < steps; ++i) {
    const double a = f(v), b = f(v + h / 2 * a), c = f(v + h / 2 * b), e = f(v + h * c);
    s += h * v + h * h / 6 * (a + b + c);
    v += h / 6 * (a + 2 * b + 2 * c + e);
  }
  return {v, s};
}

}  // namespace

TEST_CASE("speed, length and time of a rolling ball agree with an integration") {
  test::Random random(5);
  for (int i = 0; i < 300; ++i) {
    const detail::Drag<double> d{random.log_uniform(0.01, 1), random.log_uniform(1e-6, 10)};
    const double v0 = random.log_uniform(0.01, 10), rest = d.seconds(v0, 0.0), t = rest * random.uniform(0.01, 0.95);
    const Rolled exact = integrate(d, v0, t, 2000);
    INFO("A " << d.constant << " B " << d.linear << " v0 " << v0 << " t " << t);
    CHECK(d.length_in(v0, t) == Approx(exact.length).epsilon(1e-11));
    CHECK(d.speed_after(v0, exact.length) == Approx(exact.speed).epsilon(1e-10));
    CHECK(d.seconds(v0, exact.speed) == Approx(t).epsilon(1e-10));
    CHECK(d.length(v0, exact.speed) == Approx(exact.length).epsilon(1e-11));
  }
}

TEST_CASE("no digit is lost where the growth of friction vanishes") {
  test::Random random(6);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double a = random.log_uniform(0.01, 1), b = random.log_uniform(1e-18, 10), v0 = random.log_uniform(1e-3, 10);
    const detail::Drag<double> d{a, b};
    const detail::Drag<Digits50> exact{a, b};
    const double s = d.length(v0, 0.0) * random.uniform(0, 1);
    const Digits50 v = exact.speed_after(Digits50(v0), Digits50(s));
    const double of_speed =
        std::abs(static_cast<double>(d.speed_after(v0, s) * Digits50(d.speed_after(v0, s)) - v * v)) / (v0 * v0);
    const double of_rest =
        std::abs(static_cast<double>(d.length(v0, 0.0) / exact.length(Digits50(v0), Digits50(0)) - 1));
    worst = std::max({worst, of_speed, of_rest});
    CHECK(of_speed < 2e-15);
    CHECK(of_rest < 2e-15);
  }
  INFO("worst " << worst);
  const detail::Drag<double> none{0.1, 1e-15};
  CHECK(none.length(2.0, 0.0) == Approx(2.0 * 2.0 / 0.2).epsilon(1e-13));
  CHECK(none.seconds(2.0, 0.0) == Approx(20.0).epsilon(1e-13));
}

TEST_CASE("derivatives of a slowed speed, also where rounding keeps Newton's method from settling") {
  using Dual = bankshot::Dual<2>;
  test::Random random(7);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const double a = random.log_uniform(0.01, 1), b = random.log_uniform(1e-6, 10), v0 = random.log_uniform(1e-3, 10);
    const detail::Drag<double> d{a, b};
    const double s = d.length(v0, 0.0) * random.uniform(0.05, 0.95);
    const Dual dual = d.speed_after(Dual(v0, 0), Dual(s, 1));
    // s = L(v0) − L(v) with L' = v/(A + B v), so dv/dv0 = v0 (A + B v)/(v (A + B v0)), dv/ds = −(A + B v)/v.
    const double v = dual.a, by_speed = v0 * (a + b * v) / (v * (a + b * v0)), by_length = -(a + b * v) / v;
    worst = std::max({worst, std::abs(dual.v[0] / by_speed - 1), std::abs(dual.v[1] / by_length - 1)});
  }
  CHECK(worst < 1e-10);
}

TEST_CASE("an arc with drag ends at rest, and its derivatives are those of its numbers") {
  const SlideRoll motion{.rolling_friction = {0.008, 0.01}};
  const auto rolling = [&](double speed) {
    State<double> s{{1, 2}, {0.6 * speed, 0.8 * speed}, {}};
    motion.finish(Body{}, s, motion.arc(Body{}, s));  // natural roll
    return s;
  };
  const Arc<double> arc = motion.arc(Body{}, rolling(2));
  REQUIRE(arc.end == PhaseEnd::rest);
  CHECK(norm(arc.velocity_at(arc.duration)) == 0);
  CHECK(arc.seconds(arc.duration) == Approx(std::log(1 + 0.01 / 0.008 * 2) / (0.01 * 9.81)).epsilon(1e-14));
  CHECK(arc.parameter(arc.seconds(0.3 * arc.duration)) == Approx(0.3 * arc.duration).epsilon(1e-13));

  using Dual = bankshot::Dual<1>;
  const detail::Drag<Dual::Scalar> drag = arc.drag;
  const Dual v0(2.0, 0);
  const double s = 3, h = 1e-5;
  CHECK(drag.speed_after(v0, Dual(s)).v[0] ==
        Approx((drag.speed_after(2 + h, s) - drag.speed_after(2 - h, s)) / (2 * h)).epsilon(1e-8));
  CHECK(drag.length(v0, Dual(0.0)).v[0] ==
        Approx((drag.length(2 + h, 0.0) - drag.length(2 - h, 0.0)) / (2 * h)).epsilon(1e-8));
}
