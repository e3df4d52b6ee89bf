// SPDX-License-Identifier: MIT
//
// Compares answers about the cue ball's place with brute force by the plain simulator, on random layouts.
//   position --ask nearest|hand|snooker|value [--count 100] [--seed 1] [--others 0] [-j N] [--csv FILE]
// nearest: places that no pot leaves the cue ball at. Does a grid of launches on the exact lines stop it more than 1 cm
//   nearer?
// hand: the ball in hand, one ball to pot. Is the answer from a place of a grid of 2 cm better by more than 0.01? The
//   grid is looked at where one of 4 cm is within 0.03 of its best.
// snooker: layouts in which a grid of launches touches ball 1 and hides it. Does the answer hide it in one of twenty
//   plays with errors?
// value: the first shot of a game. The probability that it pots and leaves the next pot, against 10,000 plays.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <vector>

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/game.hpp"
#include "bankshot/scene/in_hand.hpp"
#include "planners/play/next_pot.hpp"
#include "support/exact_pot.hpp"
#include "support/on_threads.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;
using planning::SearchRequest;

constexpr double exact = 1e-8;

/// An answer and brute force, compared.
struct Compared {
  bool counts = true;  ///< brute force found what is asked for
  double ours = 0, theirs = 0;
  double time_ms = 0;
};

/// Calls `f` with evenly spaced values, both ends among them.
template <class F>
void each_of(int count, double low, double high, F&& f) {
  for (int i = 0; i < count; ++i) f(low + (high - low) * i / (count - 1));
}

Compared nearest_place(Random& r, int others) {
  for (;;) {
    Puzzle p = random_pot(r, others);
    p.speed.high = 3;
    p.aim = Aim::centre;
    const Vec2d wanted = *free_place(r, p.table, p.others, p.ball.body);
    p.leave = LeavePlace{wanted};
    const Answer a = solve(p);
    if (a.shots.empty() || a.shots.front().leave->miss <= exact) continue;
    Compared out{.ours = a.shots.front().leave->miss, .theirs = 1e9, .time_ms = a.time_us / 1000};
    const SearchRequest request(p);
    for (const AimPoint& mouth : request.problem->aim_points)
      each_of(40, std::log(p.speed.low), std::log(p.speed.high), [&](double log_speed) {
        each_of(17, -1, 1, [&](double top) {
          each_of(9, -0.75, 0.75, [&](double side) {
            const auto struck = exact_pot(request, mouth, std::exp(log_speed), {top, side, 0});
            const auto rest = struck ? rest_after_pot(request, *struck) : std::nullopt;
            if (rest) out.theirs = std::min(out.theirs, norm(*rest - wanted));
          });
        });
      });
    return out;
  }
}

Compared ball_in_hand(Random& r, int others) {
  Puzzle p = random_pot(r, others);
  p.spin_range.reset();
  p.aim = Aim::safest;
  p.in_hand = InHand{};
  const Answer a = solve(p);
  Compared out{
      .ours = a.shots.empty() ? -1 : *a.shots.front().robustness.value, .theirs = -1, .time_ms = a.time_us / 1000};
  const auto value_from = [&](const Vec2d& at) {
    const Answer there = solve(placed(p, at), {.suggest = false});
    const double value = there.shots.empty() ? -1 : *there.shots.front().robustness.value;
    out.theirs = std::max(out.theirs, value);
    return value;
  };
  // The grid of 2 cm, only where its next place on one of 4 cm comes near the best of those.
  constexpr double fine = 0.02, coarse = 0.04, near = 0.03;
  std::vector<std::pair<Vec2d, double>> looked;
  for (const Vec2d& at : free_places(p, coarse)) looked.emplace_back(at, value_from(at));
  std::erase_if(looked, [best = out.theirs](const auto& place) { return place.second < best - near; });
  for (const Vec2d& at : free_places(p, fine))
    if (std::ranges::any_of(looked, [&](const auto& place) {
          const double off = norm(place.first - at);
          return off > fine / 2 && off < coarse;
        }))
      value_from(at);
  out.counts = out.theirs >= 0;
  return out;
}

Compared hidden_ball(Random& r, int others) {
  Puzzle p = random_layout(r, others + 1);
  p.spin_range.reset();
  p.target = BallTarget{{1}};
  p.cushions = CushionRule{0, 1};
  p.aim = Aim::safest;
  p.leave = LeaveSafe{{1}};
  const auto hides = [&](const Launch& launch) {
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, launch, {}, {}});
    int rails = 0;
    for (const Record& e : t.events) {
      if (e.kind == EventKind::cushion) ++rails;
      if (e.kind == EventKind::jaw || e.kind == EventKind::pocket || rails > 1) return false;
      if (e.kind != EventKind::ball) continue;
      if (e.ball != 1 && e.contact.index != 1) return false;
      break;
    }
    const auto places = played(p, launch, {});
    return places[0] && places[1] && !planning::play::can_be_hit(p, 1, places);
  };
  Compared out;
  each_of(720, 0, radians(359.5), [&](double angle) {
    each_of(12, 0.5, 5, [&](double speed) { out.theirs += hides({speed, angle}); });
  });
  out.counts = out.theirs > 0;
  if (!out.counts) return out;
  const Answer a = solve(p);
  out.time_ms = a.time_us / 1000;
  if (a.shots.empty()) return out;
  const Launch& launch = a.shots.front().launch;
  std::mt19937_64 luck(1);
  std::normal_distribution<double> normal;
  constexpr int plays = 500;
  for (int i = 0; i < plays; ++i) {
    const double speed = launch.speed + p.noise.speed_at(launch.speed) * normal(luck);
    out.ours += hides({speed, launch.angle + p.noise.angle * normal(luck)}) / static_cast<double>(plays);
  }
  return out;
}

Compared printed_value(Random& r, int others) {
  Puzzle p = random_layout(r, others + 1);
  p.noise.angle = radians(0.125), p.noise.speed = 0.075;
  ask(p, Game::rotation, order_of(Game::rotation, p.others));
  Puzzle shot_alone = p;
  shot_alone.game.reset();
  shot_alone.aim = Aim::safest;
  const Answer a = solve(shot_alone);
  Compared out{.counts = !a.shots.empty(), .time_ms = a.time_us / 1000};
  if (!out.counts) return out;
  const Shot& shot = a.shots.front();
  const planning::play::NextPot next(p);
  std::mt19937_64 luck(static_cast<std::uint64_t>(r.uniform(0, 1e15)));
  std::normal_distribution<double> normal;
  constexpr int plays = 10000;
  for (int i = 0; i < plays; ++i) {
    const Launch struck{std::max(1e-3, shot.launch.speed + p.noise.speed * normal(luck)),
                        shot.launch.angle + p.noise.angle * normal(luck)};
    const Trajectory t = simulate({{}, p.table, p.physics, p.ball, p.others, struck, shot.spin, {}});
    const auto places = places_of(p, t);
    const auto touch = std::ranges::find(t.events, EventKind::ball, &Record::kind);
    if (places[0] && !places[1] && touch != t.events.end() && (touch->ball == 1 || touch->contact.index == 1))
      out.theirs += next.best(order_of(p), places).chance / plays;
  }
  out.ours = shot.leave->success;
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares answers about the cue ball's place with brute force.");
  const std::map<std::string, std::function<Compared(Random&, int)>> questions{
      {"nearest", nearest_place}, {"hand", ball_in_hand}, {"snooker", hidden_ball}, {"value", printed_value}};
  std::string ask, csv;
  int count = 100, others = 0, threads = 1;
  std::uint64_t seed = 1;
  app.add_option("--ask", ask, "What is asked")
      ->required()
      ->check(CLI::IsMember({"nearest", "hand", "snooker", "value"}));
  app.add_option("--count", count, "Layouts that brute force can solve");
  app.add_option("--seed", seed, "Seed of the layouts");
  app.add_option("--others", others, "Balls besides the one that is potted or touched");
  app.add_option("-j", threads, "Threads");
  app.add_option("--csv", csv, "A file for the table");
  CLI11_PARSE(app, argc, argv);
  std::vector<Compared> all(static_cast<std::size_t>(count));
  on_threads(threads, all.size(), [&](std::size_t i) {
    Random random(seed * 1000003 + i);
    do all[i] = questions.at(ask)(random, others);
    while (!all[i].counts);
  });
  // So much does not count as a difference: m, of value, of one shot, of probability.
  const std::map<std::string, double> slack{{"nearest", 0.01}, {"hand", 0.01}, {"snooker", 0}, {"value", 0.05}};
  // A share of plays that hide the ball: less is luck.
  constexpr double fewest = 0.05;
  int worse = 0;
  double sum = 0, square = 0, largest = 0;
  std::vector<double> times;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Compared& c = all[i];
    double off = ask == "nearest" ? c.ours - c.theirs : c.theirs - c.ours;
    if (ask == "snooker") off = c.ours >= fewest ? 0 : 1;
    if (off > slack.at(ask)) {
      ++worse;
      std::cout << fmt::format("layout {}: ours {:.4f}, brute force {:.4f}\n", i, c.ours, c.theirs);
    }
    sum += off, square += off * off, largest = std::max(largest, off);
    times.push_back(c.time_ms);
  }
  std::ranges::sort(times);
  const double mean = sum / count, rms = std::sqrt(square / count), median = times[times.size() / 2];
  std::cout << fmt::format(
      "seed {}, {}, {} others: {} layouts, {} worse; mean difference {:.4f}, rms {:.4f}, largest {:.4f}; "
      "{:.1f} ms in the median\n",
      seed, ask, others, count, worse, mean, rms, largest, median);
  std::ofstream(csv) << fmt::format(
      "asked,others,layouts,worse,mean_difference,rms,largest,median_ms\n{},{},{},{},{:.4f},{:.4f},{:.4f},{:.2f}\n",
      ask, others, count, worse, mean, rms, largest, median);
}
