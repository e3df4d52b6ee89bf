// SPDX-License-Identifier: MIT
#include "planners/evaluate/margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/solve/line_search.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::margin;

constexpr double never = std::numeric_limits<double>::infinity();

/// Moves a launch one way, by steps in rad or m/s.
class Way {
 public:
  Way(const Branch& aim, EvaluationBudget& budget, const Shot& shot, const Vec2d& towards)
      : aim_(aim), budget_(budget), shot_(shot), goal_(Goal::counted_along(shot)), towards_(towards) {}

  /// Returns the largest step, up to `limit`, such that the shot is made all the way; none when nothing breaks it.
  std::optional<double> how_far(double scale, double limit) {
    do {
      bad_ = never;
      walk(scale, limit);
      if (!(bad_ < never)) return {};
      close_in();
      prove(limit);
    } while (bad_ < limit && passes_over());
    if (!(bad_ < never)) return {};
    look_inside();
    return good_;
  }

 private:
  Launch moved(double by) const { return {shot_.launch.speed + towards_.y * by, shot_.launch.angle + towards_.x * by}; }

  bool made(double by) {
    const Launch l = moved(by);
    return l.speed > 0 && replay(aim_.request, budget_, {l.speed, wrap_angle(l.angle)}, goal_).made;
  }

  /// The limits that the derivatives predict from one step.
  struct Look {
    double at;
    bool holds = false;
    double until = never, back = 0;  ///< to where the first limit breaks, and back to where all hold again
    double dip = never;              ///< back to where a limit would break that holds here
  };
  Look look(double by) {
    Look out{by};
    const Launch l = moved(by);
    if (!(l.speed > 0)) return out;
    budget_.charge(aim_.route.size());
    const auto limits = limits_of(aim_, l, unit, budget_.work());
    if (!limits) return out;
    out.holds = limits->hold();
    out.until = limits->until(towards_);
    out.back = limits->until_all_hold(-towards_);
    out.dip = limits->until(-towards_);
    return out;
  }

  /// Steps outwards, to where the next limit should break, but at most doubles the distance each time.
  void walk(double scale, double limit) {
    last_ = look(good_);
    while (good_ < limit) {
      const double step = last_.until;
      if (step <= settings::settled * good_) return void(bad_ = good_ * (1 + tolerance::margin));
      const double next = std::min({good_ + step, std::max(2 * good_, scale), limit});
      if (!(next > good_)) return void(bad_ = next);
      last_ = look(next);
      const double dip = next - last_.dip;  // beyond the last step: something may have broken in between
      if (last_.holds && dip > good_ && !made(dip)) return void(bad_ = dip);
      if (!last_.holds || !made(next)) return void(bad_ = next);
      good_ = next;
    }
  }

  /// Goes on beyond the end if only launches break it that no aim tells apart: rounding decides those. Returns whether
  /// it did.
  bool passes_over() {
    const double beyond = bad_ * (1 + 4 * tolerance::margin) + 2 * tolerance::same_aim;
    if (passed_ == most_passed || !made(beyond)) return false;
    ++passed_;
    good_ = beyond;
    return true;
  }

  /// Closes in on the end by Newton's method, between a step that is made and one that is not.
  void close_in() {
    for (int i = 0; i < settings::most_steps && bad_ - good_ > tolerance::margin * bad_; ++i) {
      double next = last_.holds ? last_.at + last_.until : last_.at - last_.back;
      if (!(next > good_ && next < bad_)) next = arithmetic_mean(good_, bad_);
      const bool near = std::abs(next - last_.at) <= settings::settled * next;
      if (near) {
        const double in = next * (1 - tolerance::margin / 2), out = next * (1 + tolerance::margin / 2);
        if (in > good_ && made(in)) good_ = in;
        if (out < bad_ && !made(out)) bad_ = out;
        return;
      }
      last_ = look(next);
      (last_.holds ? good_ : bad_) = next;
    }
  }

  /// Verifies the end by replays on both sides. If they disagree with the derivatives, it uses steps that grow, and
  /// bisection.
  void prove(double limit) {
    if (!made(good_)) {
      bad_ = good_;
      good_ = 0;
    }
    // Launches that jaws turn in and out lie in narrow intervals.
    double longest = aim_.request.problem->boundary.jaws.empty()
                         ? never
                         : std::max(bad_ * rattling_step, limit * least_rattling_step);
    double by = tolerance::margin * bad_ + settings::rounding;
    while (made(bad_)) {
      if (bad_ >= limit) return void(bad_ = never);
      good_ = bad_;
      bad_ = std::min(bad_ + by, limit);
      by = std::min(2 * by, longest);
      longest *= 1 + rattling_step;
    }
    narrow();
  }

  void narrow() {
    bisect(
        good_, bad_,
        [](double in, double out) { return out - in > tolerance::margin * out && out > settings::rounding; },
        [&](double by) { return made(by); });
  }

  /// Tries steps between 0 and the end, and the dips between them. If one is not made, the end is before it.
  void look_inside() {
    const double end = good_;
    Look before = look(0);
    // If the first look saw the end, the limits are nearly straight.
    const int parts = aim_.request.problem->whole                   ? parts_of_chains
                      : std::abs(before.until - end) < nearly * end ? few_parts
                                                                    : many_parts;
    for (int k = 1; k <= parts; ++k) {
      const Look now = look(end * k / parts);
      const auto broken = k < parts && !made(now.at) ? std::optional(now.at) : look_between(before, now);
      if (broken) {
        good_ = before.at;
        bad_ = *broken;
        narrow();
        return look_inside();  // at other places, inside the nearer end
      }
      before = now;
    }
  }

  /// Returns a step at which a limit breaks, between two at which it holds; none if there is none. Newton's method
  /// comes from both sides, as long as a tangent crosses 0 between them and the two do not meet above 0.
  std::optional<double> look_between(Look a, Look b) {
    for (int i = 0; i < settings::most_steps && a.holds && b.holds; ++i) {
      const double gap = b.at - a.at, up = a.at + a.until, down = b.at - b.dip;
      const bool rises = up<b.at - nearly * gap, falls = down> a.at + nearly * gap;
      if (gap < tolerance::margin * b.at || !(rises || falls) || (rises && falls && up >= down)) break;
      // The step lies a little beyond, for the method stops before a root that it nears from inside.
      if (rises && !made(up + nearly * nearly * gap)) return up + nearly * nearly * gap;
      if (falls && !made(down)) return down;
      if (rises) a = look(up);
      if (falls) b = look(down);
    }
    return {};
  }

  const Branch& aim_;
  EvaluationBudget& budget_;
  const Shot& shot_;
  Goal goal_;
  Vec2d towards_;
  double good_ = 0, bad_ = never;
  int passed_ = 0;
  Look last_{0};
  static constexpr Noise unit{1, 1};
};

std::optional<double> downwards(std::optional<double> distance) {
  return distance ? std::optional(-*distance) : distance;
}

}  // namespace

void find_margin(const SearchRequest& request, EvaluationBudget& budget, Shot& shot) {
  if (shot.path.scratch && !is_ideal(request.puzzle().physics))
    return void(shot.robustness.margin = Margin{{0, 0}, {0, 0}});
  const AimPoint& aim_point = request.problem->aim_point_of(shot);
  const Route route = route_with_jaws_of(shot);
  const Branch aim{request, route, aim_point};
  const auto how_far = [&](const Vec2d& towards, double scale, double limit) {
    return Way(aim, budget, shot, towards).how_far(scale, limit);
  };
  const double scale = std::min(aim_point.reach / shot.verification.condition, longest_first);
  Margin m;
  m.angle[0] = downwards(how_far({-1, 0}, scale, whole_turn.high / 2));
  m.angle[1] = how_far({1, 0}, scale, whole_turn.high / 2);
  if (!is_ideal(request.puzzle().physics)) {
    const double push = scale * shot.launch.speed;
    m.speed[0] = downwards(how_far({0, -1}, push, shot.launch.speed));
    m.speed[1] = how_far({0, 1}, push, widest_speed);
  }
  shot.robustness.margin = m;
}

}  // namespace bankshot::planning
