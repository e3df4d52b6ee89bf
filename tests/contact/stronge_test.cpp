// SPDX-License-Identifier: MIT
//
// Compares stronge with the theory of single impacts, with its two springs followed in small steps, and with itself in
// 50 digits.
#include "bankshot/contact/stronge.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>

#include "bankshot/numbers/dual.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

using namespace bankshot;
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

namespace {

constexpr double beta = 3.5;

/// Returns the final slip over the approach speed.
double slip_left(double mu, double e, double omega, double rho) {
  return rho * (1 - beta * stronge::Across<double>(mu, e, omega).share(rho));
}

/// Computes the same ratio by following spring and slider in `steps` steps, without distinguishing cases.
double slip_by_steps(double mu, double e, double omega, double rho, int steps) {
  const double quarter = std::acos(0.0), end = (1 + e) * quarter, dx = end / steps, eta2 = beta / (omega * omega);
  double extension = 0, slip = rho;
  for (int i = 1; i <= steps; ++i) {
    const double x = i * dx, psi = x <= quarter ? x : quarter + (x - quarter) / e;
    const double held = mu * eta2 * std::sin(std::min(psi, 2 * quarter)), before = extension;
    extension = std::clamp(extension + (slip - omega * omega * extension * dx / 2) * dx, -held, held);
    slip -= omega * omega * (before + extension) / 2 * dx;
  }
  return slip;
}

}  // namespace

TEST_CASE("stronge: slip that is left at e 0.85, friction 0.2, frequency ratio 1.8") {
  // Stronge's closed forms, evaluated by hand.
  for (const auto& [before, after] :
       {std::pair{0.1, 0.0320240}, {0.2, 0.0239063}, {0.5, -0.2313953}, {1.0, -0.2897244}, {2.0, 0.705}})
    CHECK(slip_left(0.2, 0.85, 1.8, before) == Approx(after).margin(5e-8));
}

TEST_CASE("stronge: head-on at 1 m/s, without spin and rolling") {
  State<double> s{};
  s.velocity = {0, 1};
  Stronge{}.bounce(Body{}, s, Vec2d{0, -1});
  CHECK(s.velocity.y == Approx(-0.7387665).margin(5e-8));
  CHECK(s.spin.x == Approx(7.5480397).margin(5e-8));
  s = {};
  s.velocity = {0, 1};
  s.spin = {-1 / Body{}.radius, 0, 0};
  Stronge{}.bounce(Body{}, s, Vec2d{0, -1});
  CHECK(s.velocity.y == Approx(-0.8115727).margin(5e-8));
  CHECK(s.spin.x * Body{}.radius == Approx(-0.1092583).margin(5e-8));
}

TEST_CASE("stronge: any restitution, against the springs in small steps") {
  constexpr std::uint64_t seed = 5;
  test::Random r(seed);
  for (int i = 0; i < 400; ++i) {
    const double mu = r.uniform(0.01, 1), e = r.chance(0.1) ? 1 : r.uniform(0.02, 1), omega = r.uniform(1.02, 1.98),
                 rho = r.log_uniform(1e-3, 10);
    INFO("draw " << i << " of seed " << seed << ": " << mu << " " << e << " " << omega << " " << rho);
    REQUIRE(slip_left(mu, e, omega, rho) == Approx(slip_by_steps(mu, e, omega, rho, 20000)).margin(1e-5));
  }
}

TEST_CASE("stronge: does not jump where one case follows another") {
  constexpr std::uint64_t seed = 6;
  test::Random r(seed);
  for (int i = 0; i < 2000; ++i) {
    const double mu = r.uniform(0.01, 1), e = r.uniform(0.02, 1), omega = r.uniform(1.02, 1.98),
                 eta2 = beta / (omega * omega);
    INFO("draw " << i << " of seed " << seed);
    for (const double at : {mu * eta2, mu * beta, mu * std::max(beta, (1 + e) * beta - eta2 / e)}) {
      const double below = slip_left(mu, e, omega, at * (1 - 1e-9)), above = slip_left(mu, e, omega, at * (1 + 1e-9));
      REQUIRE(std::abs(above - below) < 1e-7 * (1 + at));
    }
  }
}

TEST_CASE("stronge: in double against 50 digits") {
  constexpr std::uint64_t seed = 7;
  test::Random r(seed);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto cushion = test::draw<Stronge>(r);
    State<double> s = test::draw_state(r);
    s.velocity.y = std::abs(s.velocity.y);
    State<Digits> truth{};
    truth.velocity = {Digits(s.velocity.x), Digits(s.velocity.y)};
    truth.spin = {Digits(s.spin.x), Digits(s.spin.y), Digits(s.spin.z)};
    const double scale = scale_of(s, test::ball_radius);
    cushion.bounce(test::body, s, Vec2d{0, -1});
    cushion.bounce(test::body, truth, Vec2d{0, -1});
    const auto off = [](double a, const Digits& b) { return std::abs(static_cast<double>(Digits(b - a))); };
    const double error =
        off(s.velocity.x, truth.velocity.x) + off(s.velocity.y, truth.velocity.y) +
        test::ball_radius * (off(s.spin.x, truth.spin.x) + off(s.spin.y, truth.spin.y) + off(s.spin.z, truth.spin.z));
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(error < 2e-14 * scale);
    worst = std::max(worst, error / scale);
  }
  WARN("stronge: worst error " << worst << " of |v| + R|w|");
}

TEST_CASE("stronge: derivatives by its coefficients agree with differences") {
  using All = Dual<5>;
  constexpr std::uint64_t seed = 8;
  test::Random r(seed);
  int sharp = 0;
  for (int i = 0; i < 300; ++i) {
    const double usual[] = {test::ball_radius * r.uniform(1.1, 1.5), r.uniform(0.3, 0.9), r.uniform(-0.02, 0.02),
                            r.uniform(0.05, 0.5), r.uniform(1.1, 1.9)};
    State<double> s = test::draw_state(r);
    s.velocity.y = -norm(s.velocity) * r.uniform(0.1, 0.9);
    const auto after = [&]<class C>(const C(&c)[5]) {
      State<C> moved{to<C>(s.at), to<C>(s.velocity), {C(s.spin.x), C(s.spin.y), C(s.spin.z)}};
      StrongeOf<C>{.height = c[0], .restitution = {c[1], c[2]}, .friction = c[3], .frequency_ratio = c[4]}.bounce(
          test::body, moved, Vec2d{0, 1});
      return moved;
    };
    All dual[5];
    for (int k = 0; k < 5; ++k) dual[k] = All(usual[k], k);
    const State<All> exact = after(dual);
    const double scale = scale_of(s, test::ball_radius);
    for (int k = 0; k < 5; ++k)
      for (const bool spins : {false, true}) {
        const auto f = [&](double h) {
          double c[5];
          std::copy(usual, usual + 5, c);
          c[k] += h * usual[k];
          const State<double> moved = after(c);
          return (spins ? moved.spin.x * test::ball_radius : moved.velocity.y) / scale;
        };
        const test::Slope slope = test::ridders(f, 1e-3);
        if (slope.error > 1e-9) continue;  // a step across two cases
        ++sharp;
        const double by = (spins ? exact.spin.x.v[k] * test::ball_radius : exact.velocity.y.v[k]) * usual[k] / scale;
        INFO("draw " << i << " of seed " << seed << ", coefficient " << k);
        REQUIRE(by == Approx(slope.value).epsilon(1e-7).margin(1e-8));
      }
  }
  CHECK(sharp > 2400);
}

TEST_CASE("stronge: what does not approach is left alone") {
  State<double> s{};
  s.velocity = {1, -0.5};
  s.spin = {3, 4, 5};
  const State<double> before = s;
  Stronge{}.bounce(Body{}, s, Vec2d{0, -1});
  CHECK(s.velocity == before.velocity);
  CHECK(s.spin == before.spin);
}
