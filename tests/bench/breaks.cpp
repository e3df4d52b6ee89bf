// SPDX-License-Identifier: MIT
//
// Breaks of fifteen balls: counts their events, measures their time, and checks them. Prints one row for each gap
// between the balls of the rack.
//   breaks --count 2000
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <vector>

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/random_balls.hpp"

using namespace bankshot;

namespace {

struct Played {
  long events = 0, meetings = 0;
  double us = 0;
};

Played run(const ShotRequest& shot) {
  using Clock = std::chrono::steady_clock;
  const Starts starts(shot);
  return with_physics(shot.physics, [&](const auto& motion, const auto& cushion) {
    const auto begin = Clock::now();
    ManyBalls sim(starts.balls(), motion, cushion, collisions(shot.physics));
    Played out;
    for (;; ++out.events) {
      const BallEvent e = sim.step();
      if (e.event.kind == EventKind::horizon) break;
      out.meetings += e.event.kind == EventKind::ball;
    }
    out.us = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    return out;
  });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Breaks of fifteen balls");
  int count = 2000;
  std::uint64_t seed = 1;
  app.add_option("--count", count)->check(CLI::Range(1, 1000000))->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::cout << "gap_m,seed,breaks,events_mean,between_balls_mean,events_most,us_mean,us_median,us_p99,us_most\n";
  for (const double gap : {0.0, 1e-9, 1e-6, 1e-4}) {
    Random random(seed);
    std::vector<double> us;
    double sum = 0;
    long events = 0, meetings = 0, most = 0;
    for (int i = 0; i < count; ++i) {
      const Played b = run(test::break_shot(random, gap));
      us.push_back(b.us);
      sum += b.us;
      events += b.events, meetings += b.meetings, most = std::max(most, b.events);
    }
    std::ranges::sort(us);
    const auto n = static_cast<std::size_t>(count);
    std::cout << fmt::format("{:g},{},{},{:.1f},{:.1f},{},{:.1f},{:.1f},{:.1f},{:.1f}\n", gap, seed, count,
                             static_cast<double>(events) / count, static_cast<double>(meetings) / count, most,
                             sum / count, us[n / 2], us[n * 99 / 100], us.back());
  }
}
