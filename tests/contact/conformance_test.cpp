// SPDX-License-Identifier: MIT
//
// Requirements on every cushion: no energy gained, no ball driven further into it, the same result in a mirror and
// turned, twice as much from twice as much, the place unchanged, derivatives, and the limits of restitution.
#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/contact/custom.hpp"
#include "bankshot/numbers/dual.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr int draws = 5000;
constexpr std::uint64_t seed = 23;

/// Draws a state that moves into the cushion whose normal is (0, 1), sometimes nearly along it or straight into it.
State<double> approaching(Random& r) {
  State<double> s = draw_state(r);
  const double v = norm(s.velocity);
  if (r.chance(0.1)) s.velocity = {v, -v * r.log_uniform(1e-12, 1e-2)};
  if (r.chance(0.1)) s.velocity = {0, -v};
  if (r.chance(0.1)) s.spin = natural_roll(s.velocity, ball_radius);
  s.velocity.y = -std::abs(s.velocity.y);
  return s;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a bounce gains no energy, does not go on into the cushion and moves no centre", "", Cushions) {
  Random r(seed);
  double most = 0;
  for (int i = 0; i < draws; ++i) {
    const auto cushion = draw<TestType>(r);
    const State<double> s = approaching(r), e = bounced(cushion, body, s);
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(energy_of(e) <= energy_of(s) * (1 + 1e-14 + integration_error<TestType>));
    REQUIRE(e.velocity.y >= 0);
    REQUIRE(e.velocity.y <= -s.velocity.y * 10 + scale_of(s));
    REQUIRE(e.at == s.at);
    most = std::max(most, energy_of(e) / energy_of(s));
  }
  CHECK(most > 0.9);  // the draws reach the lossless limit
}

TEMPLATE_LIST_TEST_CASE("a bounce is the same in a mirror, turned, and twice as fast", "", Cushions) {
  Random r(seed);
  constexpr double off = integration_error<TestType>;
  for (int i = 0; i < draws; ++i) {
    const auto cushion = draw<TestType>(r);
    const State<double> s = approaching(r), e = bounced(cushion, body, s);
    const double angle = r.uniform(0, 6.28), scale = scale_of(s);
    INFO("draw " << i << " of seed " << seed);
    REQUIRE(difference(bounced(cushion, body, mirrored(s)), mirrored(e)) <= (1e-14 + off) * scale);
    REQUIRE(difference(bounced(cushion, body, turned(s, angle), turned(Vec2d{0, 1}, angle)), turned(e, angle)) <=
            (2e-14 + off) * scale);
    REQUIRE(difference(bounced(cushion, body, times(s, 2)), times(e, 2)) <= off * scale);
  }
}

TEMPLATE_LIST_TEST_CASE("derivatives of a bounce agree with differences", "", Cushions) {
  using Dual = bankshot::Dual<7>;
  // Differences of an integrated impact have fewer digits.
  constexpr double digits = integration_error < TestType >> 0 ? 1e-6 : 1e-8;
  Random r(seed);
  int sharp = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    const auto cushion = draw<TestType>(r);
    State<double> s = draw_state(r);
    s.velocity.y = -norm(s.velocity) * r.uniform(0.1, 0.9);
    State<Dual> dual{to<Dual>(s.at), to<Dual>(s.velocity), {Dual(s.spin.x), Dual(s.spin.y), Dual(s.spin.z)}};
    for (int k = 0; k < 7; ++k) number_of(dual, k).v[k] = 1;
    cushion.bounce(body, dual, Vec2d{0, 1});
    const double V = scale_of(s), unit[] = {1, 1, V, V, V / ball_radius, V / ball_radius, V / ball_radius};
    for (int in = 2; in < 7; ++in)
      for (int out = 2; out < 7; ++out) {
        const auto f = [&](double h) {
          State<double> moved = s;
          number_of(moved, in) += h * unit[in];
          cushion.bounce(body, moved, Vec2d{0, 1});
          return number_of(moved, out) / unit[out];
        };
        const Slope slope = ridders(f, 1e-4);
        ++all;
        if (slope.error > digits / 10) continue;  // a step across the switch from sticking to sliding
        ++sharp;
        INFO("draw " << i << " of seed " << seed << ", d" << out << "/d" << in);
        REQUIRE(slope.value ==
                Approx(number_of(dual, out).v[in] * unit[in] / unit[out]).epsilon(digits).margin(digits));
      }
  }
  CHECK(sharp > all * 9 / 10);
}

TEMPLATE_TEST_CASE("restitution 0 leaves the least, 1 the most", "", Mirror, Han2005, Mathavan2010) {
  Random r(seed);
  int clamped_at_0 = 0;
  for (int i = 0; i < draws; ++i) {
    auto cushion = draw<TestType>(r);
    const State<double> s = approaching(r);
    double before = -1;
    INFO("draw " << i << " of seed " << seed);
    for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      cushion.restitution = Restitution{e};
      const double leaves = bounced(cushion, body, s).velocity.y;
      REQUIRE(leaves >= before - integration_error<TestType> * scale_of(s));
      before = leaves;
    }
    cushion.restitution = Restitution{0.5, -1e6};  // clamped at 0
    const State<double> clamped = bounced(cushion, body, s);
    cushion.restitution = Restitution{0};
    if (-s.velocity.y <= 1e-5) continue;  // too slow to be clamped
    ++clamped_at_0;
    REQUIRE(difference(clamped, bounced(cushion, body, s)) <= 1e-15 * scale_of(s));
  }
  CHECK(clamped_at_0 > draws * 8 / 10);
}

TEST_CASE("han2005 without friction is a mirror of its own: e cos^2 - sin^2 of the speed comes back") {
  // From eqs 17-23 with f = 0: vn' = vn (1 − (1 + e) cos²θ), with tangential speed and spin unchanged.
  Random r(seed);
  for (int i = 0; i < draws; ++i) {
    Han2005 h = draw<Han2005>(r);
    h.friction = 0;
    const State<double> s = approaching(r), e = bounced(h, body, s);
    const double sine = h.height / ball_radius - 1, cosine2 = 1 - sine * sine;
    const double out = -s.velocity.y * ((1 + h.restitution.at_rest) * cosine2 - 1);
    CHECK(e.velocity.y == Approx(std::max(0.0, out)).margin(1e-14 * scale_of(s)));
    CHECK(e.velocity.x == Approx(s.velocity.x).epsilon(1e-14));
    CHECK(e.spin.z == Approx(s.spin.z).epsilon(1e-14));
  }
}

TEST_CASE("han2005 with a sticking contact and a nose at the centre: 2/7 of the slip is taken") {
  // For θ → 0 with full friction, the contact point comes to rest along the cushion: s = vt + R ωz → vt' = vt − 2/7 s.
  const Han2005 h{.height = ball_radius * (1 + 1e-12), .restitution = Restitution{1}, .friction = 1e6};
  Random r(seed);
  for (int i = 0; i < draws; ++i) {
    const State<double> s = draw_state(r);
    State<double> in = s;
    in.velocity.y = -std::abs(s.velocity.y) - 1e-3 * scale_of(s);
    const State<double> e = bounced(h, body, in);
    // The cushion lies below the ball, so the contact point at −R ŷ moves along +x with vx + R ωz.
    const double slip = in.velocity.x + ball_radius * in.spin.z;
    CHECK(e.velocity.x == Approx(in.velocity.x - 2.0 / 7 * slip).margin(1e-9 * scale_of(in)));
    CHECK(e.velocity.x + ball_radius * e.spin.z == Approx(0).margin(1e-9 * scale_of(in)));
    CHECK(e.velocity.y == Approx(-in.velocity.y).margin(1e-9 * scale_of(in)));
  }
}

TEST_CASE("a cushion's promises are kept by ours, and a broken one is told") {
  Random r(seed);
  const auto broken = [](const auto& cushion) {
    std::vector<std::string> out;
    for (const Promise& p : try_promises(cushion, body))
      if (!p.kept()) out.push_back(p.what);
    return out;
  };
  CHECK(broken(draw<Mirror>(r)).empty());
  CHECK(broken(draw<Han2005>(r)).empty());
  CHECK(broken(draw<Mathavan2010>(r)).empty());
  CHECK(broken(draw<CustomCushion>(r)).empty());
  using Frame = InCushionFrame<double>;
  const std::vector<std::string> energy{"energy after over energy before"},
      mirror{"difference in a mirror, of the whole"};
  const CushionLawOf gains([](const Body&, Frame& f) { f.vn *= -1.1; });
  const CushionLawOf drifts([](const Body&, Frame& f) { f.vn *= -0.5, f.vt *= f.vt > 0 ? 0.9 : 0.8; });
  CHECK(broken(CustomCushion{&gains}) == energy);
  CHECK(broken(CustomCushion{&drifts}) == mirror);
}

TEST_CASE("a custom cushion keeps the ball on the table, and its law finite") {
  using Frame = InCushionFrame<double>;
  State<double> s{{0, 0}, {1, -2}, {}};
  const CushionLawOf goes_on([](const Body&, Frame& f) { f.vn *= 0.5; });
  const CushionLawOf nonsense([](const Body&, Frame& f) { f.vt = std::nan(""); });
  CustomCushion{&goes_on}.bounce(body, s, Vec2d{0, 1});
  CHECK(s.velocity == Vec2d{1, 0});
  s.velocity = {1, 2};
  CustomCushion{&nonsense}.bounce(body, s, Vec2d{0, 1});  // it moves away, so there is no impact
  CHECK(s.velocity == Vec2d{1, 2});
  s.velocity = {1, -2};
  CHECK_THROWS_AS(CustomCushion{&nonsense}.bounce(body, s, Vec2d{0, 1}), std::domain_error);
}
