// SPDX-License-Identifier: MIT
#include "planners/play/leave_success.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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

}  // namespace

double leave_success(const SearchRequest& request, EvaluationBudget& budget, const Worth& worth, const Shot& shot,
                     const Measurement& measurement, std::vector<Vec2d>* rests) {
  double sum = 0, lost = 0;
  const auto count = [&](double won) {
    sum += won, lost += 1 - won;
    return lost <= (1 - measurement.least) * measurement.plays;
  };
  const auto play = [&](const SearchRequest& own, const Launch& struck) {
    const Replay r = replay_to_target(own, budget, struck, Goal::counted(own, shot));
    if (!r.made) return count(0);
    const Ending ending = ending_of(own, budget, struck, r);
    if (rests && ending.cue_rests()) rests->push_back(*ending.cue_rests());
    return count(worth(ending));
  };
  each_play(request.spinning(shot.spin), shot.launch, measurement.plays, play, measurement.skipped);
  return sum / measurement.plays;
}

void rate_leaves(const SearchRequest& request, EvaluationBudget& budget, bool robustness, std::vector<Shot>& shots) {
  const LeaveWorth worth(request.puzzle());
  for (Shot& shot : shots) {
    if (robustness)
      as_struck(request, shot, [&](const SearchRequest& own) {
        find_success(own, budget, shot);
        find_margin(own, budget, shot);
      });
    // Other plays than those by which the shot was chosen: these would flatter it.
    std::vector<Vec2d> rests;
    const double success = leave_success(request, budget, worth, shot, {last_plays, judged_plays}, &rests);
    shot.leave->spread = spread_of(rests);
    shot.leave->success = std::min(success, shot.robustness.success.value_or(1));
    shot.robustness.value = shot.leave->success - cost_of(shot);
  }
  if (request.all() && request.puzzle().prefer == Prefer::robust) order_by_value(shots);
}

}  // namespace bankshot::planning::play
