// SPDX-License-Identifier: MIT
#include "planners/merit/rank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/merit/robustness.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

/// Larger is better.
double merit(const Puzzle& p, const Shot& shot) {
  switch (p.prefer) {
    case Prefer::soft:
      return -shot.launch.speed;
    case Prefer::quick:
      return -shot.arrival.time;
    case Prefer::robust:
      break;
  }
  return shot.success.value_or(shot.first_order);
}

void order(const Puzzle& p, std::vector<Shot>& shots) {
  std::stable_sort(shots.begin(), shots.end(), [&](const Shot& a, const Shot& b) {
    const double x = merit(p, a), y = merit(p, b);
    if (x != y) return x > y;
    if (a.first_order != b.first_order) return a.first_order > b.first_order;
    return a.launch.angle < b.launch.angle;
  });
}

/// Where some line reaches the target's centre, shots beside it are no answer.
void keep_centred(const Search& s, std::vector<Shot>& shots) {
  const auto beside = [&](const Shot& shot) { return !s.centred(shot.miss); };
  if (!std::all_of(shots.begin(), shots.end(), beside)) std::erase_if(shots, beside);
}

/// Shots whose success decides their order: more than this are compared by first-order margin.
constexpr std::size_t most_compared = 64;

/// The same shot with another launch; none where it is not made.
std::optional<Shot> moved(Search& s, const Shot& from, const Launch& to) {
  if (!(to.speed > 0) || !s.puzzle.speed.contains(to.speed)) return {};
  const Replay r = replay(s, to, Goal::along(from.cushions));
  if (!r.made) return {};
  Shot shot = from;
  shot.launch = to;
  shot.arrival = r.arrival;
  shot.miss = r.miss;
  first_order(s, shot);
  find_success(s, shot);
  return shot;
}

}  // namespace

void rank(const Search& s, std::vector<Shot>& shots) {
  keep_centred(s, shots);
  order(s.puzzle, shots);
}

void add_robustness(Search& s, std::vector<Shot>& shots, bool all) {
  const std::size_t n = std::min(shots.size(), most_compared);
  const bool by_success = s.puzzle.prefer == Prefer::robust;
  if (shots.size() > n && by_success)
    s.add_note(fmt::format("only the {} with the largest first-order margin were compared by success", n));
  for (std::size_t i = 0; i < (by_success || all ? n : 1); ++i) find_success(s, shots[i]);
  if (by_success) {
    std::vector<Shot> head(std::make_move_iterator(shots.begin()),
                           std::make_move_iterator(shots.begin() + static_cast<long>(n)));
    order(s.puzzle, head);
    std::move(head.begin(), head.end(), shots.begin());
  }
  for (std::size_t i = 0; i < (all ? shots.size() : 1); ++i) {
    if (!shots[i].success) find_success(s, shots[i]);
    find_margin(s, shots[i]);
  }
}

void make_safest(Search& s, Shot& shot) {
  if (!shot.success) find_success(s, shot);
  const Noise& noise = s.puzzle.noise;
  // Neither number of the player may be 0: a step must lead somewhere.
  const double least = tolerance::same_aim;
  double turn = std::max(noise.angle, least), push = is_ideal(s.puzzle.physics) ? 0 : std::max(noise.speed, least);
  constexpr int halvings = 5, most_steps = 24;
  for (int halved = 0, steps = 0; halved < halvings && steps < most_steps; ++steps) {
    const Launch& at = shot.launch;
    const Launch around[] = {{at.speed, wrap_angle(at.angle + turn)},
                             {at.speed, wrap_angle(at.angle - turn)},
                             {at.speed + push, at.angle},
                             {at.speed - push, at.angle}};
    std::optional<Shot> best;
    for (const Launch& to : around) {
      auto next = moved(s, shot, to);
      if (next && *next->success > std::max(*shot.success, best ? *best->success : 0.0)) best = std::move(next);
    }
    if (best) {
      shot = std::move(*best);
    } else {
      turn /= 2, push /= 2;
      ++halved;
    }
  }
}

}  // namespace bankshot::planning
