// SPDX-License-Identifier: MIT
//
// A motion that is handed over in pieces runs the same path as whole arcs: the same events at the same times and
// places, but for the rounding of each piece. This is hard because each piece starts at a rounded place, a cushion may
// be met where a piece ends, and a horizon may fall between pieces.
#include <cstdio>

#include "bankshot/motion/launched.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "support/against_truth.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"
#include "support/random_shot.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

/// SlideRoll with rolling arcs cut into pieces of `longest` seconds.
struct InPieces {
  SlideRoll whole{};
  double longest = 0.1;

  static constexpr bool straight = false;
  template <class T>
  Arc<T> arc(const Body& body, const State<T>& s) const {
    Arc<T> a = whole.arc(body, s);
    if (a.end != PhaseEnd::rest || !(a.duration > T(longest))) return a;
    a.duration = T(longest);
    a.end = PhaseEnd::piece;
    return a;
  }
  template <class T>
  void turn(const Body& body, State<T>& s, const Arc<T>& a, const T& t) const {
    whole.turn(body, s, a, t);
  }
  template <class T>
  void finish(const Body& body, State<T>& s, const Arc<T>& a) const {
    whole.finish(body, s, a);
  }
};

/// Returns how far apart two runs may end, because each piece rounds the state anew [m].
double allowed(const ShotRequest& shot, const Boundary& boundary, int pieces) {
  const Condition c = condition({boundary, shot.physics, start_state(shot), 6, 100});
  return tolerance::simulation_error * 0x1p-53 * boundary.extent * c.kappa * (1 + pieces);
}

}  // namespace

TEST_CASE("a motion in pieces meets the same events at the same places") {
  constexpr std::uint64_t seed = 43;
  Random random(seed);
  double worst = 0;
  int events = 0, pieces_in_all = 0;
  for (int i = 0; i < 300; ++i) {
    const ShotRequest shot = random_shot(random, i % 2 ? ShotFamily::uniform : ShotFamily::reflex);
    if (!std::holds_alternative<SlideRoll>(shot.physics.motion)) continue;
    const Boundary boundary(shot.table, shot.ball.body);
    const SlideRoll motion = std::get<SlideRoll>(shot.physics.motion);
    INFO("number " << i << " of seed " << seed << ": " << write_shot(shot));
    std::visit(
        [&](const auto& cushion) {
          Simulator plain(boundary, motion, cushion, start_state(shot));
          Simulator cut(boundary, InPieces{motion}, cushion, start_state(shot));
          int pieces = 0;
          double shown = 0;
          for (int cushions = 0, n = 0; cushions < 6 && n < 100; ++n) {
            const double begin = cut.time();
            shown = 0;
            const Event a = plain.step(), b = cut.step(forever, [&](const Arc<double>&arc, double t) {
              ++pieces;
              shown += arc.seconds(t);
            });
            REQUIRE(a.kind == b.kind);
            REQUIRE(a.contact == b.contact);
            REQUIRE(begin + shown + cut.arc().seconds(cut.travelled()) == Approx(cut.time()).epsilon(1e-13));
            ++events;
            cushions += a.kind == EventKind::cushion;
            if (a.final()) break;
          }
          const double off = norm(plain.state().at - cut.state().at), most = allowed(shot, boundary, pieces);
          CHECK(off <= most);
          worst = std::max(worst, off / most);
          pieces_in_all += pieces;
        },
        shot.physics.cushion);
  }
  std::printf("pieces: %d events, %d pieces, worst difference %.2g of what is allowed\n", events, pieces_in_all, worst);
  CHECK(events > 500);
  CHECK(pieces_in_all > 2000);
}

TEST_CASE("a horizon between two pieces or inside one is kept, and no event stands where a piece ends") {
  const Boundary boundary(rectangle_table(2.54, 1.27), {});
  const State<double> rolls{{0.5, 0.6}, {0.8, 0}, {0, 0.8 / boundary.body.radius, 0}};
  const SlideRoll motion;
  for (const double horizon : {0.05, 0.1, 0.25, 0.7}) {
    Simulator plain(boundary, motion, Mirror{}, rolls);
    Simulator cut(boundary, InPieces{motion}, Mirror{}, rolls);
    CHECK(plain.step(horizon).kind == EventKind::horizon);
    CHECK(cut.step(horizon).kind == EventKind::horizon);
    CHECK(cut.time() == Approx(horizon).epsilon(1e-15));
    CHECK(norm(plain.state().at - cut.state().at) < 1e-15);
  }
}

TEST_CASE("a locked path goes through pieces as through phases") {
  const Boundary boundary(rectangle_table(2.54, 1.27), {});
  const State<double> start = launched({0.6, 0.4}, boundary.body.radius, Vec2d{3.1, 2.2}, {0.3, -0.5, 0.1});
  std::vector<Contact> met;
  Simulator sim(boundary, SlideRoll{}, Han2005{}, start);
  for (Event e = sim.step(); met.size() < 3; e = sim.step())
    if (e.kind == EventKind::cushion) met.push_back(e.contact);
  const auto whole = follow_locked(boundary, SlideRoll{}, Han2005{}, route_by(met), start);
  const auto cut = follow_locked(boundary, InPieces{}, Han2005{}, route_by(met), start);
  REQUIRE(whole.end == LockedEnd::complete);
  REQUIRE(cut.end == LockedEnd::complete);
  CHECK(norm(whole.state.at - cut.state.at) < 1e-13);
  CHECK(cut.time == Approx(whole.time).epsilon(1e-13));
  const auto a = arrive_locked(SlideRoll{}, boundary.body, whole.state, {1.2, 0.6}, 0, true);
  const auto b = arrive_locked(InPieces{}, boundary.body, cut.state, {1.2, 0.6}, 0, true);
  CHECK((a.at_rest && b.at_rest));
  CHECK(norm(a.state.at - b.state.at) < 1e-12);
}
