// SPDX-License-Identifier: MIT
//
// Checks many balls on a tilted table: no balls overlap, the energy with the height never rises, every shot ends, and
// the same shot gives the same bytes.
#include <cmath>
#include <cstdio>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/catch.hpp"
#include "support/random_balls.hpp"
#include "support/random_shot.hpp"
#include "support/seed.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr long endless = 40000;  // steps

struct Watched {
  double overlap = -1;  ///< the worst [m]
  double gained = 0;    ///< the worst rise between two events, as a fraction of the largest possible energy
  long events = 0, meetings = 0;
  bool ended = false;
};

Watched watched(const ShotRequest& shot) {
  const Starts starts(shot);
  const BallBall law = collisions(shot.physics);
  const Tilted motion = tilted(shot.physics);
  ManyBalls sim(starts.balls(), motion, AnyCushion{shot.physics.cushion}, law);
  Watched w;
  const auto look = [&] {
    double sum = 0;
    for (int i = 0; i < sim.count(); ++i) {
      if (!sim.in_play(i)) continue;
      State<double> s = sim.state_now(i);
      s.spin = motion.spin(sim.body(i), s);
      sum += energy(shot.physics, sim.body(i), s);
      for (int j = 0; j < i; ++j)
        if (sim.in_play(j))
          w.overlap =
              std::max(w.overlap, touching_distance(sim.body(i), sim.body(j)) - norm(s.at - sim.state_now(j).at));
    }
    return sum;
  };
  double all = 0.5 * shot.ball.body.mass * shot.launch.speed * shot.launch.speed;
  for (int i = 0; i < sim.count(); ++i)
    all += sim.body(i).mass * gravity(shot.physics) * norm(shot.physics.tilt) * shot.table.diagonal();
  double before = look();
  for (; w.events < endless && !w.ended; ++w.events) {
    const BallEvent e = sim.step(0.05);  // also between events
    const double now = look();
    // A ball that falls takes its potential energy with it, which may be below 0.
    if (e.event.kind != EventKind::pocket) w.gained = std::max(w.gained, (now - before) / all);
    before = now;
    w.meetings += e.event.kind == EventKind::ball;
    w.ended = true;
    for (int i = 0; i < sim.count(); ++i) w.ended = w.ended && !sim.moves(i);
  }
  return w;
}

void try_leaning(int each, double steepest, std::uint64_t seed) {
  for (const BallFamily family : ball_families) {
    if (family == BallFamily::ideal) continue;  // ideal physics have no gravity
    Random r(seed);
    long events = 0, meetings = 0, most = 0;
    double overlap = -1, gained = 0;
    for (int i = 0; i < each; ++i) {
      ShotRequest shot = random_balls(r, family);
      const double rise = r.log_uniform(1e-5, steepest), way = r.uniform(0, radians(360));
      shot.physics.tilt = {rise * std::cos(way), rise * std::sin(way)};
      INFO(name(family) << " number " << i << " of seed " << seed << ": " << write_shot(shot));
      const Watched w = watched(shot);
      CHECK(w.ended);
      // Meetings are found on chords, each within tolerance::chord of its path.
      CHECK(w.overlap <= (w.meetings == 0 ? tolerance::overlap : 2 * tolerance::chord * 0.036));
      CHECK(w.gained <= 1e-12);
      if (i % 4 == 0) CHECK(to_json(shot, simulate(shot)) == to_json(shot, simulate(shot)));
      events += w.events, meetings += w.meetings, most = std::max(most, w.events);
      overlap = std::max(overlap, w.overlap), gained = std::max(gained, w.gained);
    }
    std::printf("leaning, %s: %ld steps, %ld between balls, at most %ld in a shot; overlap %.2g m, gained %.2g\n",
                name(family).c_str(), events, meetings, most, overlap, gained);
    CHECK(meetings > each / 2);
  }
}

}  // namespace

TEST_CASE("many balls on a leaning table never overlap, gain no energy, and every shot ends") {
  try_leaning(8, 5e-3, 61);
}
TEST_CASE("hundreds of shots with many balls on leaning tables", "[.][long]") {
  try_leaning(150, 5e-3, seed_or_fresh(62));
}
