// SPDX-License-Identifier: MIT
//
// Requirements on every motion that leads a ball to a facing or a tip. The ball meets the rubber at its own radius, on
// a part that exists, and no faster than it started. The result is the same in a mirror, and the place has derivatives.
#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/catch.hpp"
#include "support/jaw_pieces.hpp"
#include "support/models.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr int draws = 1000;
constexpr std::uint64_t seed = 43;

/// The first thing that a path meets, the state there, and the velocity before the bounce.
template <class T>
struct Met {
  Event event{};
  State<T> state{};
  Vec2<T> came{};
};
template <class T, class Motion>
Met<T> first_met(const Boundary& boundary, const Motion& motion, const State<T>& start) {
  Simulator sim(boundary, motion, Mirror{}, start);
  Event e = sim.step();
  while (e.kind == EventKind::slide_to_roll) e = sim.step();
  return {e, sim.state(), sim.on_arc(sim.travelled()).velocity};
}

/// A ball that meets a jaw first.
template <class Motion>
struct Approach {
  JawTable on;
  Motion motion;
  State<double> start;
  Met<double> met;

  static Approach draw(Random& r) {
    for (;;) {
      const JawTable on = JawTable::draw(r);
      const Vec2d at = on.touching(on.draw_jaw(r), r);
      Approach out{on, test::draw<Motion>(r), draw_state_of(Motion{}, r), {}};
      const double R = on.preset.body.radius, speed = norm(out.start.velocity) + 1;
      out.start.at = {r.uniform(R, on.preset.length - R), r.uniform(R, on.preset.width - R)};
      const Vec2d way = at - out.start.at;
      const double turn = std::atan2(way.y, way.x) - std::atan2(out.start.velocity.y, out.start.velocity.x);
      out.start = {out.start.at, direction(std::atan2(way.y, way.x)) * speed, turned(out.start, turn).spin};
      out.start.spin = out.motion.spin(on.preset.body, out.start);
      out.met = first_met(on.boundary, out.motion, out.start);
      if (out.met.event.kind == EventKind::jaw) return out;
    }
  }
  /// Returns true when the ball comes steeply enough for accurate differences.
  bool squarely() const {
    return -dot(on.boundary.normal(met.event.contact, met.state.at), met.came) > 0.2 * norm(met.came);
  }
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("a ball meets facings and tips at its own radius, where they are, and no faster", "", Motions) {
  Random r(seed);
  int tips = 0;
  for (int i = 0; i < draws; ++i) {
    const auto a = Approach<TestType>::draw(r);
    const Boundary& boundary = a.on.boundary;
    const Contact jaw = a.met.event.contact;
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(std::abs(boundary.clearance(a.met.state.at)) <= 1e-12 * boundary.diagonal);
    REQUIRE(dot(boundary.normal(jaw, a.met.state.at), a.met.came) <= 0);
    if (const Circle* const tip = boundary.rim(jaw); tip && !boundary.line(jaw)) {
      ++tips;
      REQUIRE(std::abs(norm(a.met.state.at - tip->centre) - tip->radius) <= 1e-12 * boundary.diagonal);
      REQUIRE(dot(tip->middle, a.met.state.at - tip->centre) >= tip->extent * tip->radius - 1e-9);
    }
    const double R = a.on.preset.body.radius;
    REQUIRE(bankshot::energy_of(a.met.state, R) <= bankshot::energy_of(a.start, R) * (1 + 1e-12));
  }
  CHECK(tips > draws / 10);
  CHECK(tips < draws * 9 / 10);
}

TEMPLATE_LIST_TEST_CASE("a ball meets the jaws across the table as in a mirror", "", Motions) {
  Random r(seed);
  int squarely = 0;
  for (int i = 0; i < draws; ++i) {
    const auto a = Approach<TestType>::draw(r);
    if (!a.squarely()) continue;
    ++squarely;
    State<double> other = mirrored(a.start);
    other.at = a.on.mirrored(a.start.at);
    const auto there = first_met(a.on.boundary, a.motion, other);
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(there.event.kind == EventKind::jaw);
    REQUIRE(norm(there.state.at - a.on.mirrored(a.met.state.at)) <= 1e-11 * a.on.boundary.diagonal);
    REQUIRE(norm(there.came - mirrored(State<double>{{}, a.met.came, {}}).velocity) <= 1e-10 * norm(a.start.velocity));
  }
  CHECK(squarely > draws / 2);
}

TEMPLATE_LIST_TEST_CASE("where a ball meets a jaw has derivatives, which agree with differences", "", Motions) {
  using Dual = bankshot::Dual<4>;
  Random r(seed);
  int sharp = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    const auto a = Approach<TestType>::draw(r);
    if (!a.squarely()) continue;
    const State<double>& s = a.start;
    State<Dual> dual{to<Dual>(s.at), to<Dual>(s.velocity), {Dual(s.spin.x), Dual(s.spin.y), Dual(s.spin.z)}};
    for (int k = 0; k < 4; ++k) number_of(dual, k).v[k] = 1;
    State<Dual> met = first_met(a.on.boundary, a.motion, dual).state;
    const double V = norm(s.velocity), unit[] = {1, 1, V, V};
    for (int by = 0; by < 4; ++by)
      for (int of = 0; of < 2; ++of) {
        bool same = true;
        const auto f = [&](double h) {
          State<double> moved = s;
          number_of(moved, by) += h * unit[by];
          auto there = first_met(a.on.boundary, a.motion, moved);
          same = same && there.event.contact == a.met.event.contact;
          return number_of(there.state, of);
        };
        const Slope slope = ridders(f, 1e-5);
        ++all;
        if (!same || slope.error > 1e-8) continue;
        ++sharp;
        INFO("draw " << i << " of seed " << seed << ", d" << of << "/d" << by);
        REQUIRE(slope.value == Approx(number_of(met, of).v[by] * unit[by]).epsilon(1e-6).margin(1e-7));
      }
  }
  CHECK(sharp > all * 8 / 10);
}
