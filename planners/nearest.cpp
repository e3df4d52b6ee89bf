// SPDX-License-Identifier: MIT
#include "planners/nearest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planners/settings.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::nearest;

/// A launch and its miss.
struct Miss {
  Launch launch{};
  bool bounces = false;  ///< it makes the bounces asked
  double miss = std::numeric_limits<double>::infinity();

  bool nearer(const Miss& o) const { return bounces != o.bounces ? bounces : miss < o.miss; }
};

class Scan {
 public:
  Scan(const SearchRequest& request, EvaluationBudget& budget)
      : request_(request),
        goal_(Goal::of(request)),
        aims_(request.puzzle().angle.value_or(whole_turn)),
        speeds_(request.puzzle().speed),
        aside_(std::numeric_limits<long>::max(), budget) {
    speeds_.low = std::max(speeds_.low, settings::slowest_of_fastest * speeds_.high);
    if (request.one_unknown() || is_ideal(request.puzzle().physics)) speeds_.low = speeds_.high = request.fixed_speed();
  }

  /// Brings a launch inside the bounds, follows it, and keeps it if it is among the nearest.
  void look(Launch l) {
    l.speed = std::clamp(l.speed, speeds_.low, speeds_.high);
    if (request_.puzzle().angle) l.angle = nearest_aim(l.angle);
    const Miss m = follow(l);
    if (!m.nearer(best_.back())) return;
    best_.back() = m;
    for (std::size_t i = best_.size() - 1; i > 0 && best_[i].nearer(best_[i - 1]); --i)
      std::swap(best_[i], best_[i - 1]);
  }

  void grid() {
    const int speeds = speeds_.fixed() ? 1 : speeds_across, aims = launches / speeds;
    for (int k = 0; k < speeds; ++k) {
      const double share = speeds > 1 ? static_cast<double>(k) / (speeds - 1) : 0;
      const double speed = speeds_.low * std::pow(speeds_.high / speeds_.low, share);
      for (int i = 0; i < aims; ++i)
        look({speed, aims_.low + (aims_.high - aims_.low) * (i + 0.5 * (k % 2)) / (aims - 1)});
    }
  }

  /// Runs a compass search with steps that halve, from each of the best.
  void climb() {
    const auto from = best_;
    for (const Miss& start : from) {
      if (!(start.launch.speed > 0)) continue;
      Miss at = start;
      double turn = (aims_.high - aims_.low) / launches * speeds_across / 2;
      double push = std::log(speeds_.high / speeds_.low) / speeds_across;
      for (int steps = 0; steps < settings::most_steps; ++steps) {
        const Miss before = at;
        for (const double side : {1.0, -1.0}) {
          at = nearer_of(at, {before.launch.speed, before.launch.angle + side * turn});
          if (push > 0) at = nearer_of(at, {before.launch.speed * std::exp(side * push), before.launch.angle});
        }
        if (at.nearer(before)) continue;
        turn /= 2, push /= 2;
      }
      if (at.nearer(best_.front())) best_.front() = at;
    }
  }

  std::optional<Launch> best() const {
    return best_.front().launch.speed > 0 ? std::optional(best_.front().launch) : std::nullopt;
  }

 private:
  Miss follow(const Launch& l) {
    if (!(l.speed > 0)) return {};
    const Replay r = replay(request_, aside_, {l.speed, wrap_angle(l.angle)}, goal_);
    const FailureReason reason = r.failure.reason;
    const bool bounces = r.made || ((reason == FailureReason::missed || reason == FailureReason::fell_short) &&
                                    r.bounces() >= goal_.min);
    return {l, bounces, r.miss};
  }

  Miss nearer_of(const Miss& m, const Launch& l) {
    if (l.speed < speeds_.low || l.speed > speeds_.high) return m;
    if (request_.puzzle().angle && (l.angle < aims_.low || l.angle > aims_.high)) return m;
    const Miss other = follow(l);
    return other.nearer(m) ? other : m;
  }

  /// Returns the nearest aim that is allowed.
  double nearest_aim(double angle) const {
    const double middle = (aims_.low + aims_.high) / 2;
    return std::clamp(middle + angle_difference(middle, angle), aims_.low, aims_.high);
  }

  const SearchRequest& request_;
  Goal goal_;
  Range aims_, speeds_;
  EvaluationBudget aside_;
  std::array<Miss, starts> best_{};
};

}  // namespace

std::optional<Launch> nearest_launch(const SearchRequest& request, EvaluationBudget& budget, const SearchResult& found,
                                     bool scan) {
  Scan tries(request, budget);
  if (found.nearest.launch.speed > 0) tries.look(found.nearest.launch);
  for (const Candidate& candidate : found.candidates) tries.look(candidate.launch);
  if (scan) {
    tries.grid();
    tries.climb();
  }
  return tries.best();
}

}  // namespace bankshot::planning
