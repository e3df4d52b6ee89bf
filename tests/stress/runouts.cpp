// SPDX-License-Identifier: MIT
//
// Matches against the table: how often a player pots all balls of a random layout without a miss.
//   runouts [--balls 6] [--layouts 1000] [--seed 1] [--noise strong|weak] [--player play …] [-j N] [--csv FILE]
// A layout has so many balls and the cue ball at random places of pool-9ft, `spin` physics. The lowest ball must be
// touched first and fall; other balls that fall stay down. A miss, a scratch or no shot ends the attempt. Every player
// meets the same layouts and the same luck. The judge is the plain simulator.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/game.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "planners/play/next_pot.hpp"
#include "support/on_threads.hpp"
#include "support/played.hpp"
#include "support/random_layout.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

/// A player: answers a question of a game; the first shot of the answer is played.
using PlaysGame = std::function<Answer(Puzzle)>;

/// The shot of a game alone, without the plan for later balls.
Answer first_shot(Puzzle p, int plies = 1) {
  p.game.reset();
  p.aim = Aim::safest;
  if (p.leave && plies > 1) std::get<LeaveForNext>(*p.leave).plies = plies;
  return solve(p, {.robustness = false, .suggest = false});
}

/// The likeliest pot, thinking of no other ball.
Answer likeliest(Puzzle p) {
  p.leave.reset();
  return first_shot(std::move(p));
}

const std::map<std::string, PlaysGame> all_players{{"play", [](Puzzle p) { return first_shot(std::move(p)); }},
                                                   {"two-plies", [](Puzzle p) { return first_shot(std::move(p), 2); }},
                                                   {"spin", likeliest},
                                                   {"solve", [](Puzzle p) {
                                                      p.spin_range.reset();
                                                      return likeliest(std::move(p));
                                                    }}};

/// A named player of the issue: angle in degrees, speed in m/s, tip in metres.
Noise noise_of(const std::string& name, double tip) {
  Noise n;
  n.angle = radians(name == "weak" ? 0.3 : 0.125);
  n.speed = name == "weak" ? 0.15 : 0.075;
  n.tip = tip;
  return n;
}

Puzzle rotation(std::uint64_t seed, int balls, const Noise& noise) {
  Random r(seed);
  Puzzle p = random_layout(r, balls);
  p.noise = noise;
  ask(p, Game::rotation, order_of(Game::rotation, p.others));
  return p;
}

struct Outcome {
  bool run_out = false;
  int shots = 0, made = 0;
  std::string end = "";  ///< why the attempt ended
  std::vector<double> times{};
  std::vector<long> simulations{};
  /// Sums over the shots of players that say a leave: the success of the leave that they say, and what came of it; and
  /// over the shots after them, the estimate of the pot, and whether it was made.
  double said = 0, came = 0, estimated = 0, potted = 0;
  int leaves = 0, next = 0;
};

/// One play with the player's errors, by the plain simulator.
struct Played {
  bool legal = false;  ///< the right ball was touched first, and the cue ball stays up
  std::vector<std::optional<Vec2d>> places;
};
Played play_once(const Puzzle& s, const Shot& shot, std::mt19937_64& luck) {
  std::normal_distribution<double> normal;
  const double radius = s.ball.body.radius;
  const Launch struck{std::max(1e-3, shot.launch.speed + s.noise.speed_at(shot.launch.speed) * normal(luck)),
                      shot.launch.angle + s.noise.angle * normal(luck)};
  LaunchSpin spin = shot.spin;
  spin.side += s.noise.side_of(radius) * normal(luck);
  spin.top += s.noise.top_of(radius) * normal(luck);
  const Trajectory t = simulate({{}, s.table, s.physics, s.ball, s.others, struck, spin, {}});
  Played out{.places = places_of(s, t)};
  const auto touch = std::ranges::find_if(t.events, [](const Record& e) { return e.kind == EventKind::ball; });
  if (touch == t.events.end()) return out;
  const int first = touch->ball == 0 ? touch->contact.index : touch->ball;
  out.legal = out.places[0].has_value() && std::ranges::count(order_of(s).front(), first) > 0;
  return out;
}

Outcome attempt(Puzzle question, const PlaysGame& player, std::uint64_t seed) {
  Outcome out;
  std::mt19937_64 luck(seed);
  std::optional<double> estimate;
  for (;;) {
    const auto begin = std::chrono::steady_clock::now();
    const Answer answer = player(question);
    out.times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    if (answer.shots.empty()) return out.end = "no shot", out;
    out.simulations.push_back(answer.simulations);
    ++out.shots;
    const Played played = play_once(question, answer.shots.front(), luck);
    const bool fell = std::ranges::any_of(order_of(question).front(), [&](int ball) {
      return !played.places[static_cast<std::size_t>(ball)].has_value();
    });
    const bool made = played.legal && fell;
    if (estimate) ++out.next, out.estimated += *estimate, out.potted += made;
    if (const auto& leave = answer.shots.front().leave) {
      const double worth = planning::play::NextPot(question).best(order_of(question), played.places).chance;
      ++out.leaves, out.said += leave->success, out.came += made ? worth : 0;
      estimate = worth;
    }
    if (!played.legal) return out.end = played.places[0] ? "wrong ball" : "scratch", out;
    if (!fell) return out.end = "miss", out;
    ++out.made;
    const std::optional<Puzzle> next = next_question(question, played.places);
    if (!next) return out.run_out = true, out;
    question = *next;
  }
}

double quantile(std::vector<double> v, double q) {
  if (v.empty()) return 0;
  std::ranges::sort(v);
  return v[std::min(v.size() - 1, static_cast<std::size_t>(q * static_cast<double>(v.size())))];
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plays layouts until a miss.");
  int balls = 6, layouts = 1000, threads = 1;
  std::uint64_t seed = 1;
  double tip = 0;
  std::string noise = "strong", csv;
  std::vector<std::string> players{"play"};
  app.add_option("--balls", balls, "Balls besides the cue ball");
  app.add_option("--layouts", layouts, "Layouts");
  app.add_option("--seed", seed, "Seed of the layouts and of the luck");
  app.add_option("--noise", noise, "Who plays: strong or weak");
  app.add_option("--tip", tip, "Error of the tip [m]");
  app.add_option("--player", players, "Players: solve, spin, play, two-plies");
  app.add_option("-j", threads, "Threads");
  app.add_option("--csv", csv, "A file for the table");
  CLI11_PARSE(app, argc, argv);
  std::ofstream file(csv);
  file << "balls,noise,tip,player,layouts,run_outs,error,made_per_shot,median_ms,99_percent_ms,simulations,"
          "leave_said,leave_came,next_estimated,next_made\n";
  for (const std::string& name : players) {
    const PlaysGame& player = all_players.at(name);
    std::vector<Outcome> all(static_cast<std::size_t>(layouts));
    on_threads(threads, all.size(), [&](std::size_t i) {
      all[i] = attempt(rotation(seed * 1000003 + i, balls, noise_of(noise, tip)), player, seed * 7919 + i);
    });
    int run_outs = 0, shots = 0, made = 0;
    std::map<std::string, int> ends;
    std::vector<double> times, simulations;
    Outcome sum;
    for (const Outcome& o : all) {
      sum.said += o.said, sum.came += o.came, sum.estimated += o.estimated, sum.potted += o.potted;
      sum.leaves += o.leaves, sum.next += o.next;
      run_outs += o.run_out, shots += o.shots, made += o.made;
      if (!o.run_out) ++ends[o.end];
      times.insert(times.end(), o.times.begin(), o.times.end());
      simulations.insert(simulations.end(), o.simulations.begin(), o.simulations.end());
    }
    const double rate = static_cast<double>(run_outs) / layouts, error = std::sqrt(rate * (1 - rate) / layouts);
    std::cout << fmt::format(
        "{}, {} balls, {} player: {:.3f} ± {:.3f} run out; {:.3f} made a shot; a decision {:.1f} ms "
        "in the median, 99 % in {:.1f} ms; {:.0f} simulations;",
        name, balls, noise, rate, error, static_cast<double>(made) / std::max(1, shots), quantile(times, 0.5),
        quantile(times, 0.99), quantile(simulations, 0.5));
    for (const auto& [why, count] : ends) std::cout << fmt::format(" {} {}", why, count);
    const auto mean = [](double total, int count) { return count > 0 ? total / count : 0; };
    if (sum.leaves > 0)
      std::cout << fmt::format("; leaves said {:.3f}, came {:.3f}; next pots estimated {:.3f}, made {:.3f}",
                               mean(sum.said, sum.leaves), mean(sum.came, sum.leaves), mean(sum.estimated, sum.next),
                               mean(sum.potted, sum.next));
    std::cout << std::endl;
    file << fmt::format("{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.2f},{:.2f},{:.0f}", balls, noise, tip, name, layouts,
                        rate, error, static_cast<double>(made) / std::max(1, shots), quantile(times, 0.5),
                        quantile(times, 0.99), quantile(simulations, 0.5));
    file << fmt::format(",{:.4f},{:.4f},{:.4f},{:.4f}\n", mean(sum.said, sum.leaves), mean(sum.came, sum.leaves),
                        mean(sum.estimated, sum.next), mean(sum.potted, sum.next));
  }
}
