// SPDX-License-Identifier: MIT
#include "planners/play/game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/scene/game.hpp"
#include "planners/evaluate/plays.hpp"
#include "planners/play/leave_success.hpp"
#include "planners/play/settings.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning::play {
namespace {

/// The puzzle of one shot of a game.
Puzzle of_one_shot(Puzzle puzzle, const SolveOptions& options) {
  puzzle.game.reset();
  if (auto* next = puzzle.leave ? std::get_if<LeaveForNext>(&*puzzle.leave) : nullptr) next->plies = options.plies;
  return puzzle;
}

bool is_last_ball(const Puzzle& puzzle) { return order_of(puzzle).size() == 1 && order_of(puzzle).front().size() == 1; }

std::vector<std::optional<Vec2d>> places_after(const Puzzle& puzzle, const Shot& shot) {
  const SearchRequest request(puzzle);
  EvaluationBudget aside(std::numeric_limits<long>::max());
  return play_out(request.spinning(shot.spin), aside, shot.launch).places;
}

/// Returns what the misses of a shot leave the opponent: the mean over all plays of the best pot then, 0 for a play
/// that makes it. Where the cue ball falls the opponent has it in hand, which counts as 1.
double left_by_misses(const Puzzle& puzzle, const PottingOrder& opponents, const Shot& shot) {
  const SearchRequest request(puzzle);
  EvaluationBudget aside(std::numeric_limits<long>::max());
  const NextPot next(puzzle);
  const int plays = settings::leave::judged_plays;
  double sum = 0;
  each_play(request.spinning(shot.spin), shot.launch, plays, [&](const SearchRequest& own, const Launch& struck) {
    if (replay_to_target(own, aside, struck, Goal::counted(own, shot)).made) return true;
    const Ending ending = play_out(own, aside, struck);
    sum += ending.cue_rests() ? next.best(opponents, ending.places).chance : 1;
    return true;
  });
  return sum / plays;
}

/// The safety that leaves the opponent least; none if no legal contact is found.
std::optional<Shot> safety_of(const Puzzle& puzzle, const SolveOptions& options, Answer& a) {
  const Puzzle asked = as_safety(puzzle);
  SolveOptions own = options;
  own.all = own.suggest = false;
  Answer safe = solve(asked, own);
  a.add_cost(safe);
  if (safe.shots.empty()) return {};
  safe.shots.front().safety = true;
  return std::move(safe.shots.front());
}

/// Returns a share in words: "41 %", "over 99 %".
std::string percent(double share) {
  constexpr double hardly_any = 0.005;
  if (share < hardly_any) return "under 1 %";
  return share >= 1 - hardly_any ? "over 99 %" : fmt::format("{:.0f} %", 100 * share);
}

/// Says why a shot is played and not the likeliest pot that the tip in the centre makes.
std::string why(const Puzzle& puzzle, const Shot& shot, const SolveOptions& options) {
  if (is_last_ball(puzzle)) return "";
  const Puzzle asked = of_one_shot(puzzle, options);
  Puzzle pot = asked;
  pot.leave.reset();
  pot.spin_range.reset();
  const Answer likeliest = solve(pot, options);
  if (likeliest.shots.empty()) return "";
  const Shot& other = likeliest.shots.front();
  const double made = *shot.robustness.success, others_made = *other.robustness.success;
  // A difference that a player would not notice.
  constexpr double alike = 0.01;
  if (others_made <= made + alike) return "no pot is likelier";
  const SearchRequest request(asked);
  EvaluationBudget aside(std::numeric_limits<long>::max());
  const double others_both = leave_success(request, aside, LeaveWorth(asked), other);
  if (others_both + alike > shot.leave->success) return "";
  return fmt::format("the likeliest pot goes in {} of plays and the next ball too in {}; with this shot both go in {}",
                     percent(others_made), percent(others_both), percent(shot.leave->success));
}

Plan plan_of(const Puzzle& puzzle, const Shot& first, const SolveOptions& options, Answer& a) {
  Plan plan;
  std::size_t left = 0;
  for (const std::vector<int>& group : order_of(puzzle)) left += group.size();
  plan.clears = {first.robustness.success.value_or(first.leave->success)};
  if (left > 1) plan.clears.push_back(first.leave->success);
  std::optional<Puzzle> now = puzzle;
  const Shot* shot = &first;
  plan.next.reserve(left);
  for (int ball = 1; ball < options.depth; ++ball) {
    now = next_question(*now, places_after(of_one_shot(*now, options), *shot));
    if (!now || !shot->leave->next) break;
    const double estimate = shot->leave->next->success;
    const Puzzle asked = of_one_shot(*now, options);
    const Answer answer = solve(asked, options);
    a.add_cost(answer);
    if (answer.shots.empty()) break;
    plan.next.push_back({asked, answer.shots.front()});
    shot = &plan.next.back().shot;
    // The planned shot takes the place of the estimate for this ball.
    const bool last = is_last_ball(*now);
    const double made = last ? shot->robustness.success.value_or(estimate) : shot->leave->success;
    const double cleared = plan.clears.back() * std::min(1.0, made / estimate);
    if (last) {
      plan.clears.back() = cleared;
      break;
    }
    plan.clears.push_back(cleared);
  }
  plan.whole = plan.clears.size() >= left;
  return plan;
}

}  // namespace

Answer solve_game(const Puzzle& puzzle, const SolveOptions& options) {
  Answer a = solve(of_one_shot(puzzle, options), options);
  const PottingOrder opponents = opponents_order(puzzle);
  // A pot that wins more than its misses leave the opponent needs no safety.
  double worth = -1;
  if (!a.shots.empty())
    worth = a.shots.front().leave->success - left_by_misses(of_one_shot(puzzle, options), opponents, a.shots.front());
  if (worth < 0 && !options.first)
    if (std::optional<Shot> safety = safety_of(puzzle, options, a); safety && safety->leave->success - 1 > worth) {
      a.message = a.shots.empty() ? "no pot was found: a safety"
                                  : "a safety: the best pot would leave the opponent more than it wins";
      if (!options.all) a.shots.clear();
      a.shots.insert(a.shots.begin(), *std::move(safety));
      a.status = Status::solved;
      a.nearest.reset();
    }
  if (a.shots.empty() || a.shots.front().safety || options.depth == 0) return a;
  // The best shot of each further question is enough.
  SolveOptions best = options;
  best.all = best.suggest = best.sensitivity = false;
  a.plan = plan_of(puzzle, a.shots.front(), best, a);
  if (options.robustness) a.plan->why = why(puzzle, a.shots.front(), best);
  return a;
}

}  // namespace bankshot::planning::play
