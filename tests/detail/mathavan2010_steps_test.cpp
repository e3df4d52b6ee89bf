// SPDX-License-Identifier: MIT
//
// The parts of the cushion impact of mathavan2010, each alone: forces, series, switches, straight steps, and the whole
// impact against a fine integration of the same forces.
#include <array>
#include <cmath>

#include "bankshot/detail/mathavan2010/impact.hpp"
#include "bankshot/detail/mathavan2010/law.hpp"
#include "bankshot/detail/mathavan2010/pair.hpp"
#include "bankshot/detail/mathavan2010/slide.hpp"
#include "bankshot/detail/mathavan2010/start.hpp"
#include "bankshot/detail/mathavan2010/straight.hpp"
#include "bankshot/detail/mathavan2010/switches.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/numbers/random.hpp"
#include "support/catch.hpp"

using namespace bankshot;
using namespace bankshot::detail;
using namespace bankshot::detail::mathavan;

namespace {

constexpr int order = 20;

Nose<double> random_nose(Random& r) {
  const double sine = r.uniform(0.05, 0.6);
  return {sine, std::sqrt(1 - sine * sine), r.uniform(0.02, 0.4), r.uniform(0.05, 0.4)};
}

Vec2d random_direction(Random& r) {
  const double angle = r.uniform(0, 7);
  return {std::cos(angle), std::sin(angle)};
}

/// An impact in which both contacts slide.
struct Slips {
  Vec2d cushion, cloth;
  double vy, work;
};

Slips random_slips(Random& r) {
  return {random_direction(r) * r.uniform(0.5, 2), random_direction(r) * r.uniform(0.5, 2), 1, 0};
}

/// Integrates the forces of two sliding contacts over the normal impulse `length` by Runge and Kutta's method.
Slips integrated(const Nose<double>& nose, Slips s, double length, int steps = 400) {
  const double h = length / steps;
  const auto rate = [&](const Slips& at) {
    const Forces<double> f =
        forces(nose, {true, true, false}, at.cushion / norm(at.cushion), at.cloth / norm(at.cloth));
    return Slips{f.cushion_rate, f.cloth_rate, f.vy_rate, nose.cosine * at.vy};
  };
  const auto moved = [](const Slips& at, const Slips& by, double dp) {
    return Slips{at.cushion + by.cushion * dp, at.cloth + by.cloth * dp, at.vy + by.vy * dp, at.work + by.work * dp};
  };
  for (int i = 0; i < steps; ++i) {
    const Slips a = rate(s), b = rate(moved(s, a, h / 2)), c = rate(moved(s, b, h / 2)), d = rate(moved(s, c, h));
    s = moved(moved(moved(moved(s, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  }
  return s;
}

/// Shows what the classes of the impact keep to themselves.
struct Open : Straight<double> {
  using Base = Straight<double>;
  Open(const Nose<double>& nose, double tolerance) : Base(nose, tolerance) {}
  using Base::constant_over, Base::course_, Base::e_, Base::load, Base::margin, Base::set_slip, Base::settle,
      Base::sign_, Base::slip, Base::straight, Base::target_, Base::vy_, Base::work_;
};

}  // namespace

TEST_CASE("pairs compute both numbers as they would be computed alone") {
  const auto check = [](auto one) {
    using T = decltype(one);
    const mathavan::Pair<T> a{T(3), T(-5)}, b{T(0.5), T(8)};
    const auto same = [](const mathavan::Pair<T>& p, double cushion, double cloth) {
      CHECK(as_double(p[0]) == cushion);
      CHECK(as_double(p[1]) == cloth);
    };
    same(a + b, 3.5, 3);
    same(a - b, 2.5, -13);
    same(a * b, 1.5, -40);
    same(T(2) * a, 6, -10);
  };
  check(1.0);
  check(Dual<1>(1));
}

TEST_CASE("what slides has the friction of its load, what sticks keeps its slip") {
  Random r(86);
  for (int i = 0; i < 1000; ++i) {
    const Nose<double> nose = random_nose(r);
    const Vec2d cushion = random_direction(r), cloth = random_direction(r);
    for (const bool cushion_slides : {false, true})
      for (const bool cloth_slides : {false, true}) {
        if (!cushion_slides && !cloth_slides) continue;  // the forces assume that one of the two slides
        const auto f = forces(nose, {cushion_slides, cloth_slides, false}, cushion_slides ? cushion : Vec2d{},
                              cloth_slides ? cloth : Vec2d{});
        REQUIRE(f.load == Approx(nose.sine + f.cushion.y * nose.cosine).margin(1e-14));
        // vy (1 + sin θ) is the difference of the two slips along y.
        REQUIRE(f.vy_rate * (1 + nose.sine) == Approx(f.cloth_rate.y - f.cushion_rate.y).margin(1e-13));
        if (cushion_slides)
          REQUIRE(norm(f.cushion - cushion * nose.mu_w) < 1e-15);
        else
          REQUIRE(norm(f.cushion_rate) < 1e-13);
        if (cloth_slides)
          REQUIRE(norm(f.cloth - cloth * (nose.mu_s * f.load)) < 1e-15);
        else
          REQUIRE(norm(f.cloth_rate) < 1e-13);
      }
    const auto lifted = forces(nose, {true, true, true}, cushion, cloth);
    REQUIRE(norm(lifted.cloth) == 0);
  }
}

TEST_CASE("the series of a slide agrees with an integration over the normal impulse") {
  Random r(87);
  for (int i = 0; i < 200; ++i) {
    const Nose<double> nose = random_nose(r);
    const Slips from = random_slips(r);
    Slide<double> s;
    const double sizes[] = {norm(from.cushion), norm(from.cloth)};
    s.r[0] = {sizes[0], sizes[1]};
    s.fx[0] = {from.cushion.x / sizes[0], from.cloth.x / sizes[1]};
    s.fy[0] = {from.cushion.y / sizes[0], from.cloth.y / sizes[1]};
    s.x[0] = {from.cushion.x, from.cloth.x};
    s.y[0] = {from.cushion.y, from.cloth.y};
    s.vy[0] = from.vy;
    s.work[0] = 0;
    constexpr double unit = 0.05;
    const auto clock = static_cast<std::size_t>(i % 2);
    s.expand(nose, {true, true, false}, order, clock, unit, 1);
    // dP = unit (r / r0) dσ gives the impulse that σ = 1 stands for.
    double impulse = 0;
    for (int n = order; n-- > 0;) impulse += s.r[static_cast<std::size_t>(n)][clock] / (n + 1);
    const Slips to = integrated(nose, from, unit / sizes[clock] * impulse);
    INFO("number " << i << " of seed 87");
    REQUIRE(norm(s.slip(0, order, 1) - to.cushion) < 1e-10);
    REQUIRE(norm(s.slip(1, order, 1) - to.cloth) < 1e-10);
    REQUIRE(evaluate(s.vy, order, 1.0) == Approx(to.vy).margin(1e-10));
    REQUIRE(evaluate(s.work, order, 1.0) == Approx(to.work).margin(1e-10));
    REQUIRE(norm(s.friction(0, order, 1) - to.cushion * (nose.mu_w / norm(to.cushion))) < 1e-9);
    REQUIRE(s.term(order) < 1e-12);
  }
}

TEST_CASE("the series of a start agrees with that of a slide if both contacts slide") {
  Random r(88);
  for (int i = 0; i < 200; ++i) {
    const Slips from = random_slips(r);
    Start<double> s(random_nose(r));
    s.cushion.size = norm(from.cushion);
    s.cushion.direction = from.cushion / s.cushion.size;
    s.cloth.size = norm(from.cloth);
    s.cloth.direction = from.cloth / s.cloth.size;
    s.vy[0] = from.vy;
    s.work[0] = 0;
    s.unit = 0.03;
    s.begin();
    const auto f = forces(s.nose, s.sliding(), s.cushion.direction, s.cloth.direction);
    REQUIRE(s.cushion.along[0] == Approx(dot(f.cushion_rate, s.cushion.direction)).margin(1e-14));
    REQUIRE(s.cloth.across[0] == Approx(cross(s.cloth.direction, f.cloth_rate)).margin(1e-14));
    s.expand(order, 1, 1e-13);
    // Directions stay unit vectors, coefficient by coefficient.
    for (int n = 1; n < order; ++n) {
      const auto& k = s.cushion;
      REQUIRE(std::abs(product(k.fx, k.fx, n) + product(k.fy, k.fy, n)) < 1e-12);
    }
    const Slips to = integrated(s.nose, from, s.unit);
    REQUIRE(norm(s.slip(0, order, 1) - to.cushion) < 1e-10);
    REQUIRE(norm(s.slip(1, order, 1) - to.cloth) < 1e-10);
    REQUIRE(evaluate(s.vy, order, 1.0) == Approx(to.vy).margin(1e-10));
  }
}

TEST_CASE("a slip counts as 0 up to a limit, and a contact holds within its cone") {
  const double sine = 0.28, cosine = 0.96;
  Open o(Nose<double>(sine, cosine, 0.2, 0.3), 1e-13);
  Open::set_slip(o.e_.cushion, {3e-9, 4e-9}, 5.1e-9);
  CHECK(o.e_.cushion.slip == Slip::sticks);
  CHECK(norm(Open::slip(o.e_.cushion)) == 0);
  Open::set_slip(o.e_.cushion, {3, -4}, 1e-9);
  CHECK(o.e_.cushion.slip == Slip::slides);
  CHECK(o.e_.cushion.size == 5);
  CHECK(Open::slip(o.e_.cushion) == Vec2d{3, -4});
  CHECK(o.margin(o.e_.cushion, 0.12, 0.16, 1) == Approx(0).margin(1e-17));  // on the cone of 0.2
  CHECK(o.margin(o.e_.cloth, 0.3, 0.4, 0.5) == Approx(0.25 - 0.0225));      // the cloth's limit is 0.3 times its load
  CHECK(o.margin(o.e_.cloth, 0.3, 0.4, -0.5) == Approx(0.25));              // without load it has no friction
}

TEST_CASE("a steep friction at the cushion lifts the ball off the cloth") {
  Open o(Nose<double>(0.1, std::sqrt(0.99), 0.2, 0.3), 1e-13);
  const auto lifts = [&](const Vec2d& slip) {
    Open::set_slip(o.e_.cushion, slip, 0);
    o.load();
    return o.e_.lifted;
  };
  CHECK(lifts({0, -1}));  // sin θ < μw cos θ
  CHECK(!lifts({0, 1}));
  CHECK(!lifts({1, 0}));
  CHECK(lifts({0.8, -0.6}));  // 0.1 < 0.2 · 0.995 · 0.6
  CHECK(!lifts({0.9, -0.435}));
}

TEST_CASE("without friction, one straight step is a whole phase") {
  const double sine = 0.28, cosine = 0.96;
  Open o(Nose<double>(sine, cosine, 0, 0), 1e-13);
  Open::set_slip(o.e_.cushion, {0.5, 1}, 0);
  Open::set_slip(o.e_.cloth, {0.5, 2}, 0);
  o.vy_ = 1;
  o.settle();
  o.e_.begin();
  CHECK(o.constant_over(1));
  bool done = false;
  REQUIRE(o.straight(done));
  CHECK(done);
  CHECK(o.vy_ == Approx(0).margin(1e-15));
  CHECK(o.work_ == Approx(0.5).epsilon(1e-15));  // all of the kinetic energy
  // P is 1 / cos θ. It moves the slip at the cushion by sin θ cos θ P, and that at the cloth by −cos θ P.
  CHECK(norm(Open::slip(o.e_.cushion) - Vec2d{0.5, 1 + sine}) < 1e-15);
  CHECK(norm(Open::slip(o.e_.cloth) - Vec2d{0.5, 1}) < 1e-15);
}

TEST_CASE("a whole impact without friction returns the restitution") {
  for (const double e : {0.0, 0.5, 0.9, 1.0}) {
    const double sine = 0.28, cosine = 0.96;
    Impact<double> impact(Nose<double>(sine, cosine, 0, 0), {0.5, 1}, {0.5, 3}, 1, 1e-13, 1e-14);
    impact.run(e);
    CHECK(!impact.course().jams);
    CHECK(impact.vy() == Approx(-e).margin(1e-13));
    CHECK(norm(impact.cushion_slip() - Vec2d{0.5, 1 + sine * (1 + e)}) < 1e-13);
    CHECK(norm(impact.cloth_slip() - Vec2d{0.5, 3 - (1 + e)}) < 1e-13);
  }
}

TEST_CASE("a whole impact with friction agrees with an integration up to the turn") {
  Random r(89);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    const Nose<double> nose = random_nose(r);
    const Slips from{random_direction(r) * r.uniform(12, 14), random_direction(r) * r.uniform(12, 14), 1, 0};
    Impact<double> impact(nose, from.cushion, from.cloth, from.vy, 1e-13, 1e-14);
    impact.run(0);  // ends where the ball stops approaching
    if (impact.course().jams || impact.course().mode[0] != 3 || impact.course().modes != 1) continue;
    ++compared;
    double low = 0, high = 4;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (integrated(nose, from, middle, 100).vy > 0 ? low : high) = middle;
    }
    const Slips to = integrated(nose, from, high, 100);
    INFO("number " << i << " of seed 89");
    REQUIRE(norm(impact.cushion_slip() - to.cushion) < 1e-8);
    REQUIRE(norm(impact.cloth_slip() - to.cloth) < 1e-8);
  }
  CHECK(compared > 100);
}
