// SPDX-License-Identifier: MIT
#include "planners/propose/aim.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/verify/bounds.hpp"

namespace bankshot::planning {
namespace {

/// Returns whether rounding, not geometry, may have decided: the path meets a corner, or ends on a cushion line.
bool rounding_may_matter(const Replay& r) {
  const FailureReason f = r.failure.reason;
  return f == FailureReason::in_place || f == FailureReason::wrong_cushion || f == FailureReason::extra_cushion ||
         f == FailureReason::fell_short || f == FailureReason::missed;
}

/// One aim, and the aims beside it that rounding may take for it.
class AimTried {
 public:
  AimTried(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, int bounces,
           std::string_view step, Demand demand)
      : request_(request),
        budget_(budget),
        found_(found),
        bounces_(bounces),
        step_(step),
        demand_(demand),
        goal_(Goal::exactly(request, bounces)) {}

  bool run(double angle) {
    if (attempt(angle, 0)) return true;
    if (demand_ == Demand::off_centre || !(last_.made || rounding_may_matter(last_))) return false;
    // The trace runs at unit speed, so its time bounds the metres by which a radian of aim moves the arrival.
    const double path = std::max(last_.path.arrival.time, 1e-3 * request_.problem->boundary.diagonal);
    const double step = tolerance::nudge * request_.problem->boundary.diagonal / path;
    if (round_angle(angle, step) || beside(angle, step)) return true;
    found_.rounding_decided = found_.rounding_decided || !(alike_ || budget_.cut());
    return false;
  }

 private:
  /// Tries one aim. `shorter`: share by which the launch is slower than the trace says.
  bool attempt(double angle, double shorter) {
    const Trace t = trace(request_, budget_, angle, goal_);
    last_ = t.replay;
    if (!t.replay.made) {
      if (!first_) first_ = t.replay.failure;
      alike_ = alike_ && first_->like(last_.failure);
      found_.remember({{request_.speed.high, angle}, t.replay.miss, t.replay.failure});
      return false;
    }
    const auto speed = launch_speed(request_, found_, angle, t, demand_);
    return speed && certified({*speed * (1 - shorter), angle});
  }

  bool certified(const Launch& launch) {
    return !budget_.spent() && certify(request_, budget_, found_, launch, bounces_, step_, demand_);
  }

  /// Tries a rounded angle. A puzzle with a path through corners likely has one, and the image gives it only to
  /// rounding.
  bool round_angle(double angle, double step) {
    const double rounded = radians(std::round(degrees(angle) * 1e9) / 1e9);
    if (!(std::abs(rounded - angle) < step)) return false;
    if (!budget_.spent() && attempt(rounded, 0)) return true;
    // Two cushions that are met in one instant at the given speed need not be so at the trace's.
    return request_.one_unknown() && certified({request_.fixed_speed(), rounded});
  }

  bool beside(double angle, double step) {
    for (const double k : {0.0, 1.0, -1.0, 10.0, -10.0})
      for (const double shorter : {0.0, step}) {
        if (budget_.spent()) return false;
        const bool tried = k == 0 && shorter == 0;
        if (!tried && (shorter == 0 || request_.stop) && attempt(angle + k * step, shorter)) return true;
      }
    return false;
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  int bounces_;
  std::string_view step_;
  Demand demand_;
  Goal goal_;
  Replay last_{};
  std::optional<Failure> first_{};
  bool alike_ = true;  ///< all aims failed for one reason; at a corner the two sides of the aim fail for different ones
};

}  // namespace

std::optional<double> launch_speed(const SearchRequest& request, SearchResult& found, double angle, const Trace& t,
                                   Demand demand) {
  const Range& bounds = request.speed;
  const auto speed_for = [&](double v) { return std::sqrt((v * v + t.account.loss) / t.account.gain); };
  double low = bounds.low, high = bounds.high;
  if (is_ideal(request.puzzle().physics)) return request.fixed_speed();
  if (request.arrival) {
    low = speed_for(request.arrival->low);
    high = speed_for(request.arrival->high);
    const auto refuse = [&](FailureReason reason, double needed, double bound) {
      found.remember({{bound, angle}, t.replay.miss, {reason, {}, needed}});
      return std::nullopt;
    };
    // A ball that rests beside the target's centre may still rest within the target.
    if (demand == Demand::off_centre && request.stop) return std::clamp(low, bounds.low, bounds.high);
    if (!bring_inside(low, bounds) && low > bounds.high) return refuse(FailureReason::too_fast, low, bounds.high);
    if (!bring_inside(high, bounds) && high < bounds.low) return refuse(FailureReason::too_slow, high, bounds.low);
    low = std::max(low, bounds.low);
    high = std::min(high, bounds.high);
  }
  // On a path that does not depend on the speed, more speed only carries the ball farther, so it is the most robust and
  // the quickest.
  return request.puzzle().prefer == Prefer::soft ? low : high;
}

bool certify_aim(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, double angle, int bounces,
                 std::string_view step, Demand demand) {
  return AimTried(request, budget, found, bounces, step, demand).run(angle);
}

}  // namespace bankshot::planning
