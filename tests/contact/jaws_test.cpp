// SPDX-License-Identifier: MIT
//
// Requirements on every cushion at the facings and tips of jaws. The rebound equals that of a rail with the direction
// of the rubber there, also in a mirror; no energy is gained; derivatives agree. At a tip these include derivatives by
// the place, which turns the rubber.
#include "bankshot/detail/bounce.hpp"
#include "bankshot/numbers/dual.hpp"
#include "support/catch.hpp"
#include "support/jaw_pieces.hpp"
#include "support/models.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr int draws = 3000;
constexpr std::uint64_t seed = 41;

/// A ball that meets a jaw.
struct Impact {
  JawTable on;
  Contact jaw;
  State<double> state;

  explicit Impact(Random& r) : on(JawTable::draw(r)), jaw(on.draw_jaw(r)), state(draw_state(r)) {
    state.at = on.touching(jaw, r);
    const Vec2d away = normal();
    if (const double speed = dot(away, state.velocity); speed > 0) state.velocity -= away * (2 * speed);
  }
  Vec2d normal() const { return on.boundary.normal(jaw, state.at); }
  bool at_tip() const { return !on.boundary.line(jaw); }
  double radius() const { return on.preset.body.radius; }
};

template <class T, class Cushion>
State<T> bounced_at(const Boundary& boundary, const Cushion& cushion, Contact jaw, State<T> s) {
  detail::bounce_at(boundary, cushion, jaw, s);
  return s;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a facing or a tip bounces a ball as a rail does that lies as it does there", "", Cushions) {
  Random r(seed);
  constexpr double off = integration_error<TestType>;
  int tips = 0;
  for (int i = 0; i < draws; ++i) {
    const auto cushion = draw<TestType>(r);
    const Impact in(r);
    const State<double> out = bounced_at(in.on.boundary, cushion, in.jaw, in.state);
    const double R = in.radius(), scale = bankshot::scale_of(in.state, R);
    const Vec2d away = in.normal();
    const double turn = std::atan2(away.y, away.x) - radians(90);
    const State<double> at_rail = bounced(cushion, in.on.preset.body, turned(in.state, -turn));
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(bankshot::difference(out, turned(at_rail, turn), R) <= (2e-14 + off) * scale);
    REQUIRE(bankshot::energy_of(out, R) <= bankshot::energy_of(in.state, R) * (1 + 1e-14 + off));
    REQUIRE(dot(away, out.velocity) >= -1e-15 * scale);
    REQUIRE(out.at == in.state.at);
    tips += in.at_tip();
  }
  CHECK(tips > draws / 4);
  CHECK(tips < draws * 3 / 4);
}

TEMPLATE_LIST_TEST_CASE("jaws bounce a ball as those across the table do in a mirror", "", Cushions) {
  Random r(seed);
  for (int i = 0; i < draws; ++i) {
    const auto cushion = draw<TestType>(r);
    const Impact in(r);
    const double R = in.radius();
    State<double> other = mirrored(in.state);
    other.at = in.on.mirrored(in.state.at);
    const State<double> out = bounced_at(in.on.boundary, cushion, in.jaw, in.state),
                        there = bounced_at(in.on.boundary, cushion, in.on.mirrored(in.jaw), other);
    INFO("draw " << i << " of seed " << seed);
    // The places of the table round the positions of the two tips, and the small radius of a tip magnifies that error.
    REQUIRE(bankshot::difference(there, mirrored(out), R) <=
            (1e-12 + integration_error<TestType>)*bankshot::scale_of(in.state, R));
  }
}

TEMPLATE_LIST_TEST_CASE("derivatives of a bounce off jaws agree with differences", "", Cushions) {
  using Dual = bankshot::Dual<7>;
  constexpr double digits = integration_error < TestType >> 0 ? 1e-6 : 1e-8;
  Random r(seed);
  int sharp = 0, all = 0, turned_rubber = 0;
  for (int i = 0; i < 300; ++i) {
    const auto cushion = draw<TestType>(r);
    Impact in(r);
    if (-dot(in.normal(), in.state.velocity) < 0.1 * norm(in.state.velocity)) continue;
    const State<double>& s = in.state;
    State<Dual> dual{to<Dual>(s.at), to<Dual>(s.velocity), {Dual(s.spin.x), Dual(s.spin.y), Dual(s.spin.z)}};
    for (int k = 0; k < 7; ++k) number_of(dual, k).v[k] = 1;
    dual = bounced_at(in.on.boundary, cushion, in.jaw, dual);
    const double R = in.radius(), V = bankshot::scale_of(s, R), unit[] = {R, R, V, V, V / R, V / R, V / R};
    for (int by = 0; by < 7; ++by)
      for (int of = 2; of < 7; ++of) {
        const auto f = [&](double h) {
          State<double> moved = s;
          number_of(moved, by) += h * unit[by];
          moved = bounced_at(in.on.boundary, cushion, in.jaw, moved);
          return number_of(moved, of) / unit[of];
        };
        const Slope slope = ridders(f, 1e-4);
        ++all;
        if (slope.error > digits / 10) continue;  // a step across the switch from sticking to sliding
        ++sharp;
        turned_rubber += by < 2 && std::abs(slope.value) > 0.01;
        INFO("draw " << i << " of seed " << seed << ", d" << of << "/d" << by);
        REQUIRE(slope.value == Approx(number_of(dual, of).v[by] * unit[by] / unit[of]).epsilon(digits).margin(digits));
      }
  }
  CHECK(sharp > all * 9 / 10);
  CHECK(turned_rubber > all / 20);
}
