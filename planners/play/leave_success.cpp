// SPDX-License-Identifier: MIT
#include "planners/play/leave_success.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "planners/evaluate/draws.hpp"
#include "planners/evaluate/margin.hpp"
#include "planners/evaluate/plays.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/play/settings.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning::play {
namespace {

using namespace settings::leave;

/// The mean and the principal axes of some points.
std::optional<Spread> spread_of(const std::vector<Vec2d>& points) {
  constexpr std::size_t fewest = 3;
  if (points.size() < fewest) return {};
  const auto count = static_cast<double>(points.size());
  Spread out;
  for (const Vec2d& p : points) out.at += p / count;
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2d& p : points) {
    const Vec2d off = p - out.at;
    xx += off.x * off.x / count, xy += off.x * off.y / count, yy += off.y * off.y / count;
  }
  const double middle = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
  out.sigma = {std::sqrt(middle + apart), std::sqrt(std::max(0.0, middle - apart))};
  constexpr double half_turn = radians(180.0);
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  out.angle = angle < 0 ? angle + half_turn : angle;
  return out;
}

/// A shot without errors, and with more and less aim and speed. None stands for a play that misses the target.
struct Beside {
  const Ending& exact;
  std::array<std::optional<Ending>, 2> by_aim, by_speed;
};

double mean_worth(const LeaveWorth& worth, const Beside& plays) {
  double sum = worth(plays.exact), count = 1;
  for (const auto& pair : {plays.by_aim, plays.by_speed})
    for (const auto& ending : pair)
      if (ending) sum += worth(*ending), ++count;
  return sum / count;
}

/// Returns how often the cue ball stops in the region asked for, if its rest moves evenly with both errors.
double share_inside(const LeaveWorth& worth, const Beside& plays) {
  const Vec2d at = *plays.exact.cue_rests();
  const auto moved = [&](const std::array<std::optional<Ending>, 2>& pair, double error) -> Vec2d {
    const auto rest = [](const std::optional<Ending>& e) { return e ? e->cue_rests() : std::nullopt; };
    const auto more = rest(pair[0]), less = rest(pair[1]);
    if (more && less) return (*more - *less) / (2 * error);
    return more ? (*more - at) / error : less ? (at - *less) / error : Vec2d{};
  };
  const Vec2d by_aim = moved(plays.by_aim, aim_error), by_speed = moved(plays.by_speed, speed_error);
  Draws draws(2);
  int inside = 0;
  for (int i = 0; i < rests_drawn; ++i) {
    const std::vector<double>& normal = draws.next();
    inside += *worth.is_inside(at + by_aim * normal[0] + by_speed * normal[1]);
  }
  return static_cast<double>(inside) / rests_drawn;
}

}  // namespace

double estimated_worth(const SearchRequest& request, EvaluationBudget& budget, const LeaveWorth& worth,
                       const Shot& shot, const Ending& exact) {
  const SearchRequest own = request.spinning(shot.spin);
  const auto play = [&](double by_aim, double by_speed) -> std::optional<Ending> {
    const Launch struck{shot.launch.speed + by_speed, wrap_angle(shot.launch.angle + by_aim)};
    if (!(struck.speed > 0)) return {};
    const Replay r = replay_to_target(own, budget, struck, Goal::counted(own, shot));
    return r.made ? std::optional(ending_of(own, budget, struck, r)) : std::nullopt;
  };
  const double turn = aim_error * own.puzzle().noise.angle,
               push = speed_error * own.puzzle().noise.speed_at(shot.launch.speed);
  const Beside plays{exact, {play(turn, 0), play(-turn, 0)}, {play(0, push), play(0, -push)}};
  return worth.is_inside(*exact.cue_rests()) ? share_inside(worth, plays) : mean_worth(worth, plays);
}

void play_leave(const SearchRequest& request, EvaluationBudget& budget, const Worth& worth, const Shot& shot, int plays,
                int skipped, const std::function<bool(double)>& count, std::vector<Vec2d>* rests) {
  const auto play = [&](const SearchRequest& own, const Launch& struck) {
    const Replay r = replay_to_target(own, budget, struck, Goal::counted(own, shot));
    if (!r.made) return count(0);
    const Ending ending = ending_of(own, budget, struck, r);
    if (rests && ending.cue_rests()) rests->push_back(*ending.cue_rests());
    return count(worth(ending));
  };
  each_play(request.spinning(shot.spin), shot.launch, plays - skipped, play, skipped);
}

double leave_success(const SearchRequest& request, EvaluationBudget& budget, const Worth& worth, const Shot& shot,
                     std::vector<Vec2d>* rests) {
  double sum = 0;
  const auto count = [&](double won) {
    sum += won;
    return true;
  };
  play_leave(request, budget, worth, shot, judged_plays + last_plays, judged_plays, count, rests);
  return sum / last_plays;
}

void rate_leaves(const SearchRequest& request, EvaluationBudget& budget, bool robustness, std::vector<Shot>& shots) {
  const LeaveWorth worth(request.puzzle());
  for (Shot& shot : shots) {
    if (robustness)
      as_struck(request, shot, [&](const SearchRequest& own) {
        find_success(own, budget, shot);
        find_margin(own, budget, shot);
      });
    std::vector<Vec2d> rests;
    const double success = leave_success(request, budget, worth, shot, &rests);
    shot.leave->spread = spread_of(rests);
    shot.leave->success = std::min(success, shot.robustness.success.value_or(1));
    shot.robustness.value = shot.leave->success - cost_of(shot);
  }
  if (request.all() && request.puzzle().prefer == Prefer::robust) order_by_value(shots);
}

}  // namespace bankshot::planning::play
