// SPDX-License-Identifier: MIT
//
// Coefficients as dual numbers: derivatives of the place of rest by the coefficients of cloth and cushions, compared
// with central differences of the plain simulator.
#include <cstdio>
#include <optional>
#include <vector>

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

using namespace bankshot;

namespace {

enum { sliding, rolling, per_speed, spinning, restitution, with_speed, friction, height, coefficients };
using All = Dual<coefficients>;
constexpr double usual[] = {0.2, 0.01, 0.002, 0.0127, 0.85, -0.02, 0.2, 0.0366};

template <class C>
SlideRollOf<C> motion_of(const C (&c)[coefficients]) {
  return {
      .sliding_friction = c[sliding], .rolling_friction = {c[rolling], c[per_speed]}, .spinning_friction = c[spinning]};
}
template <class C>
Han2005Of<C> cushion_of(const C (&c)[coefficients]) {
  return {.height = c[height], .restitution = {c[restitution], c[with_speed]}, .friction = c[friction]};
}

struct Start {
  Vec2d at, velocity;
  LaunchSpin spin;
};

template <class C>
State<C> start_of(const Start& s, const Body& body) {
  return launched(s.at, body.radius, to<C>(s.velocity), s.spin);
}

/// Returns where the ball rests after three cushions or more; none when its cushions differ from a non-empty `met`.
template <class C>
std::optional<Vec2<C>> rest_of(const Boundary& boundary, const Start& s, const C (&c)[coefficients],
                               std::vector<Contact>& met) {
  Simulator sim(boundary, motion_of(c), cushion_of(c), start_of<C>(s, boundary.body));
  std::vector<Contact> contacts;
  for (Event e = sim.step();; e = sim.step()) {
    if (e.kind == EventKind::cushion) contacts.push_back(e.contact);
    if (e.final()) break;
  }
  if (contacts.size() < 3 || (!met.empty() && contacts != met)) return {};
  met = contacts;
  return sim.state().at;
}

}  // namespace

TEST_CASE("derivatives by the coefficients of cloth and cushions agree with differences") {
  const Boundary boundary(rectangle_table(2.54, 1.27), {});
  test::Random r(41);
  double worst = 0;
  int compared = 0;
  for (int i = 0; i < 400 && compared < 100; ++i) {
    const Start s{{r.uniform(0.1, 2.4), r.uniform(0.1, 1.1)},
                  direction(r.uniform(0, 6.28)) * r.uniform(2.5, 5),
                  {r.uniform(-1, 1), r.uniform(-1, 1), 0}};
    All dual[coefficients];
    for (int k = 0; k < coefficients; ++k) dual[k] = All(usual[k], k);
    std::vector<Contact> met;
    const auto end = rest_of(boundary, s, dual, met);
    if (!end) continue;
    double off = 0;
    bool smooth = true;
    for (int k = 0; k < coefficients && smooth; ++k) {
      const auto coordinate = [&](int which) {
        return test::ridders(
            [&](double h) {
              double c[coefficients];
              std::copy(std::begin(usual), std::end(usual), c);
              c[k] += h;
              const auto moved = rest_of(boundary, s, c, met);
              smooth = smooth && moved;
              return !moved ? 0.0 : which == 0 ? moved->x : moved->y;
            },
            1e-3 * std::abs(usual[k]));
      };
      for (int which = 0; which < 2; ++which) {
        const test::Slope slope = coordinate(which);
        const double by = which == 0 ? end->x.v[k] : end->y.v[k], unit = std::abs(usual[k]);
        if (smooth) off = std::max(off, std::max(0.0, std::abs(slope.value - by) - 10 * slope.error) * unit);
      }
    }
    if (!smooth) continue;  // the cushions change within the differences
    INFO("shot " << i << " of seed 41");
    CHECK(off <= 1e-7);  // error of the derivative times the coefficient [m]
    worst = std::max(worst, off);
    ++compared;
  }
  std::printf("coefficients: %d shots, worst difference %.2g m\n", compared, worst);
  CHECK(compared >= 50);
}

TEST_CASE("dual coefficients change no value, in the simulator nor along a locked path") {
  const Boundary boundary(rectangle_table(2.54, 1.27), {});
  const Start s{{0.6, 0.4}, {3.1, 2.2}, {0.3, -0.5, 0.1}};
  All dual[coefficients];
  for (int k = 0; k < coefficients; ++k) dual[k] = All(usual[k], k);
  std::vector<Contact> met;
  const auto with = rest_of(boundary, s, dual, met);
  const auto without = rest_of(boundary, s, usual, met);
  REQUIRE((with && without));
  CHECK(with->x.a == Approx(without->x).epsilon(1e-13));
  CHECK(with->y.a == Approx(without->y).epsilon(1e-13));
  const auto path = follow_locked(boundary, motion_of(dual), cushion_of(dual), route_by(met), start_of<All>(s, {}));
  CHECK(path.end == LockedEnd::complete);
  CHECK(path.state.at.x.v[friction] != 0);
}

TEST_CASE("without spin too: rolling friction and restitution of a mirror") {
  const Boundary boundary(rectangle_table(2.54, 1.27), {});
  const auto rest = [&]<class C>(const C& mu, const C& e) {
    Simulator sim(boundary, RollingOf<C>{.friction = mu}, MirrorOf<C>{e}, State<C>{{C(0.6), C(0.4)}, {C(2.1), C(1.7)}});
    while (!sim.step().final()) {
    }
    return sim.state().at;
  };
  using Two = Dual<2>;
  const Vec2<Two> end = rest(Two(0.01, 0), Two(0.85, 1));
  const auto by_friction = test::ridders([&](double h) { return rest(0.01 + h, 0.85).x; }, 1e-5);
  const auto by_restitution = test::ridders([&](double h) { return rest(0.01, 0.85 + h).x; }, 1e-4);
  CHECK(end.x.v[0] == Approx(by_friction.value).epsilon(1e-7));
  CHECK(end.x.v[1] == Approx(by_restitution.value).epsilon(1e-7));
}
