// SPDX-License-Identifier: MIT
//
// "What should I play?" on random layouts of a pool table. Brute force tries all aims of the cue ball at ten speeds,
// and each shot it finds must be in the list with its ball, pocket and cushions. Also measures how long the list and
// the best shot take.
//   play --layouts 20 --seed 1 [--balls 7] [--step 0.02] [--csv]
// Prints each missing shot with the launch that brute force found, and the medians. Exit 1 if any is missing.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <tuple>

#include "bankshot/bankshot.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace {

using namespace bankshot;

constexpr int most_cushions = 2, speeds = 10;
constexpr double slowest = 0.5, fastest = 9;  // m/s

/// The ball that falls, its pocket and its cushions.
using Key = std::tuple<int, int, std::vector<Contact>>;

Puzzle layout(Random& r, int balls) {
  const Scene scene = preset_scene("pool-9ft");
  Puzzle p{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  const Boundary boundary(p.table, p.ball.body);
  const Vec2d low = p.table.lowest(), high = p.table.highest();
  std::vector<Vec2d> places;
  while (static_cast<int>(places.size()) <= balls) {
    const Vec2d at{r.uniform(low.x, high.x), r.uniform(low.y, high.y)};
    const auto apart = [&](const Vec2d& other) { return norm(at - other) > 2.2 * p.ball.body.radius; };
    if (boundary.clearance(at) > p.ball.body.radius / 2 && std::ranges::all_of(places, apart)) places.push_back(at);
  }
  p.ball.at = places.front();
  ObjectBallTarget target;
  for (int k = 1; k <= balls; ++k) {
    p.others.push_back({places[static_cast<std::size_t>(k)], p.ball.body, std::to_string(k)});
    target.balls.push_back(k);
  }
  target.then = {PocketTarget{}, CushionRule{0, most_cushions, {}}, {}};
  p.target = target;
  p.cushions = CushionRule::exactly(0);
  return p;
}

/// Returns what a launch makes by a simulation of all balls; jaw shots do not count.
std::optional<Key> made(const Puzzle& p, const Launch& launch) {
  const Range arrives = arrival_range(p).value();
  const Starts starts({{}, p.table, p.physics, p.ball, p.others, launch, p.spin, {}});
  return with_physics(p.physics, [&](const auto& motion, const auto& cushion) -> std::optional<Key> {
    ManyBalls sim(starts.balls(), motion, cushion, collisions(p.physics));
    int sent = 0;
    double hit = 0;
    std::vector<Contact> by;
    for (;;) {
      const BallEvent e = sim.step();
      const bool its = sent != 0 && e.ball == sent;
      if (sent == 0 && e.event.kind != EventKind::slide_to_roll && e.event.kind != EventKind::ball) return {};
      switch (e.event.kind) {
        case EventKind::ball:
          if (sent != 0) return {};
          sent = e.event.contact.index, hit = sim.time();
          break;
        case EventKind::cushion:
          if (its && sim.time() > hit) by.push_back(e.event.contact);
          if (by.size() > most_cushions) return {};
          break;
        case EventKind::jaw:
        case EventKind::rest:
          if (its) return {};
          break;
        case EventKind::pocket:
          if (its && arrives.contains(norm(sim.state(sent).velocity))) return Key{sent, e.event.contact.index, by};
          if (its) return {};
          break;
        case EventKind::horizon:
          return {};
        default:
          break;
      }
    }
  });
}

std::map<Key, Launch> by_force(const Puzzle& p, double step) {
  std::map<Key, Launch> out;
  for (int k = 0; k < speeds; ++k)
    for (double aim = 0; aim < 360; aim += step) {
      const Launch launch{slowest * std::pow(fastest / slowest, k / (speeds - 1.0)), radians(aim)};
      if (const auto key = made(p, launch)) out.emplace(*key, launch);
    }
  return out;
}

std::set<Key> listed(const Puzzle& p, const Answer& a) {
  std::set<Key> out;
  for (const Shot& s : a.shots)
    out.insert(
        {s.arriving(), static_cast<int>(pocket_reached(p, s) - p.table.pockets.data()), s.path.then.back().cushions});
  return out;
}

std::vector<std::string> names_of(const Table& table, const std::vector<Contact>& contacts) {
  std::vector<std::string> out;
  for (const Contact c : contacts) out.push_back(contact_name(table, c));
  return out;
}

double median(std::vector<double> v) {
  std::ranges::sort(v);
  return v.empty() ? 0 : v[v.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What should I play?, against brute force");
  int layouts = 20, balls = 7;
  std::uint64_t seed = 1;
  double step = 0.02;
  app.add_option("--layouts", layouts, "Random layouts")->capture_default_str();
  app.add_option("--balls", balls, "Other balls on each")->capture_default_str();
  app.add_option("--seed", seed, "Other seeds, other layouts")->capture_default_str();
  app.add_option("--step", step, "Degrees between two aims of brute force; 0: none")->capture_default_str();
  bool csv = false;
  app.add_flag("--csv", csv, "The medians as a table");
  CLI11_PARSE(app, argc, argv);
  Random random(seed);
  std::vector<double> best_us, all_us, shots;
  int missing = 0, forced = 0;
  for (int i = 0; i < layouts; ++i) {
    const Puzzle p = layout(random, balls);
    best_us.push_back(solve(p, {.robustness = false, .suggest = false}).time_us);
    const Answer a = solve(p, {.all = true, .robustness = false, .suggest = false});
    all_us.push_back(a.time_us);
    const std::set<Key> list = listed(p, a);
    shots.push_back(static_cast<double>(list.size()));
    const auto force = step > 0 ? by_force(p, step) : std::map<Key, Launch>{};
    for (const auto& [key, launch] : force) {
      if (list.contains(key)) continue;
      ++missing;
      const auto& [ball, pocket, by] = key;
      std::cerr << fmt::format("MISSING ball {} into {} by [{}], made from {} m/s at {} degrees\n{}\n", ball,
                               p.table.pockets[static_cast<std::size_t>(pocket)].name,
                               fmt::join(names_of(p.table, by), ", "), launch.speed, degrees(launch.angle),
                               write_puzzle(p));
    }
    forced += static_cast<int>(force.size());
  }
  std::cout << fmt::format(
      fmt::runtime(
          csv ? "seed,layouts,balls,listed,best_ms,all_ms,by_force,missing\n{},{},{},{:.0f},{:.1f},{:.1f},{},{}\n"
              : "seed {}, {} layouts of {} balls: median {:.0f} listed, best in {:.1f} ms, all in {:.1f} ms; "
                "of {} by brute force {} missing\n"),
      seed, layouts, balls, median(shots), median(best_us) / 1e3, median(all_us) / 1e3, forced, missing);
  return missing > 0 ? 1 : 0;
}
