// SPDX-License-Identifier: MIT
//
// `success`: the probability that the target is made, by any allowed cushions, under the player's normal errors of aim
// and speed (more of them: success_under_all_errors).
// Method: counted in the player's deviations the errors of aim and speed are equally likely in every direction, so
// their plane may be turned. `across` is the direction that moves the arrival most, to first order; `along` is at right
// angles to it. The made launches are then one strip, or a few, along `along`. Noise scanlines cross it. The edges on a
// scanline are bisected, and its success follows from them; noise_scanlines.hpp combines all of them. Scanlines begin
// evenly spaced. More are laid where much probability lies between two of them, or their success differs. Edges are
// looked for where the neighbouring scanlines have them. Points spread over the scanline, and its ends, meet a strip
// that nobody expects. Where the result agrees with first order (limits.hpp), the method ends.
// Cost: no further scanline begins after most_samples simulations, or most_samples_of_balls once the cue ball is seen
// to fall. Guarantee: none; docs/evidence.md has what was measured.
#include "planners/evaluate/success.hpp"
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/evaluate/noise_scanlines.hpp"
#include "planners/evaluate/plays.hpp"
#include "planners/evaluate/room.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::success;

/// The logistic distribution, near enough to the normal one to spread points by, and its inverse.
constexpr double logistic = 1.702;
double about_below(double z) { return 1 / (1 + std::exp(-logistic * z)); }
double about_at(double p) { return std::log(p / (1 - p)) / logistic; }

class Chance {
 public:
  Chance(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot)
      : request_(request),
        budget_(budget),
        shot_(shot),
        goal_(Goal::counted(request, shot)),
        noise_{request.puzzle().noise.angle, request.puzzle().noise.speed_at(shot.launch.speed)} {
    turn();
  }

  double run() {
    if (one_line()) {
      add(0);
      const double noise = noise_.speed;
      return lines_.front().success * (noise > 0 ? normal_below(shot_.launch.speed / noise) : 1);
    }
    const double reach = std::min(outermost, length_);
    for (int k = 0; k <= lines_to_a_side; ++k)
      for (const double side : {1.0, -1.0})
        if (k > 0 || side > 0) add(side * reach * k / lines_to_a_side);
    if (reach < outermost)
      for (const double side : {1.0, -1.0}) add(side * outermost);
    while (used_ < most() && left() && (scratches_ || !agrees_with_first_order())) {
      std::size_t at = 1;
      for (std::size_t i = 1; i < lines_.size(); ++i)
        if (tells(i) > tells(at)) at = i;
      add((lines_[at - 1].along + lines_[at].along) / 2);
    }
    return success_of(lines_);
  }

 private:
  /// Turns the plane of errors, and finds what the derivatives say of the made strip.
  void turn() {
    const Vec2d by_angle = shot_.verification.by_angle * noise_.angle,
                by_speed = shot_.verification.by_speed * noise_.speed;
    across_ = direction(std::atan2(2 * dot(by_angle, by_speed), dot(by_angle, by_angle) - dot(by_speed, by_speed)) / 2);
    if (is_ideal(request_.puzzle().physics)) across_ = {1, 0};
    const Vec2d most = by_angle * across_.x + by_speed * across_.y, least = by_speed * across_.x - by_angle * across_.y;
    const AimPoint& aim_point = request_.problem->aim_point_of(shot_);
    const double moved = norm(most);
    if (request_.stop && norm(least) > 0) length_ = aim_point.reach / norm(least);
    if (!(moved > 0)) return;
    const Gap<double> room = room_beside(request_, shot_, most / moved);
    expected_ = {room.low / moved, room.high / moved};
  }

  /// Returns whether one scanline is enough: in `ideal` any speed above 0 will do.
  bool one_line() const { return is_ideal(request_.puzzle().physics); }

  /// Returns the most simulations. Where cue balls fall, the made launches lie in regions of which first order knows
  /// nothing.
  std::size_t most() const { return scratches_ ? most_samples_of_balls : most_samples; }
  bool left() const { return !budget_.spent(); }

  /// Simulates one pair of errors. If no simulation is left, it counts as not made.
  bool made(NoiseScanline& line, double across) {
    const auto at = std::ranges::lower_bound(line.tries, across, {}, &NoiseScanline::Try::across);
    if (at != line.tries.end() && at->across == across) return at->made;
    if (!left()) return false;
    ++used_;
    const double turned = across_.x * across - across_.y * line.along,
                 harder = across_.y * across + across_.x * line.along;
    const double speed = shot_.launch.speed + noise_.speed * harder, angle = shot_.launch.angle + noise_.angle * turned;
    const Replay r = speed > 0 ? replay(request_, budget_, {speed, wrap_angle(angle)}, goal_) : Replay{};
    scratches_ = scratches_ || r.failure.reason == FailureReason::scratched;
    line.tries.insert(at, {across, r.made});
    return r.made;
  }

  /// Returns a scanline with edges in line with those of the two nearest ones.
  NoiseScanline expect(double along) const {
    NoiseScanline e{along};
    e.edges = expected_;
    if (lines_.empty()) return e;
    const auto after = std::ranges::lower_bound(lines_, along, {}, &NoiseScanline::along);
    const bool between = after != lines_.begin() && after != lines_.end(), two = lines_.size() > 1;
    const NoiseScanline& near = after == lines_.begin() ? *after : *(after - 1);
    const NoiseScanline& far = between ? *after : !two ? near : after == lines_.begin() ? *(after + 1) : *(after - 2);
    const bool alike = near.edges.size() == far.edges.size() && near.open == far.open;
    const NoiseScanline& like = !alike && between && far.edges.size() > near.edges.size() ? far : near;
    e.edges = like.edges;
    e.open = like.open;
    if (!alike || &near == &far) return e;
    const double share = (along - near.along) / (far.along - near.along);
    for (std::size_t i = 0; i < near.edges.size(); ++i) e.edges[i] += share * (far.edges[i] - near.edges[i]);
    std::ranges::sort(e.edges);
    return e;
  }

  void add(double along) {
    NoiseScanline line{along};
    const NoiseScanline e = expect(along);
    for (std::size_t k = 0; k <= e.edges.size(); ++k) {
      const double low = k > 0 ? std::max(e.edges[k - 1], -widest) : -widest;
      const double high = k < e.edges.size() ? std::min(e.edges[k], widest) : widest;
      if (e.open != (k % 2 == 1) && low < high) follow(line, low, high);
    }
    spread(line);
    settle(line, e.edges);
    lines_.insert(std::ranges::lower_bound(lines_, along, {}, &NoiseScanline::along), std::move(line));
  }

  /// Brackets both ends of what is expected to be made, by steps that double.
  void follow(NoiseScanline& line, double low, double high) {
    for (const bool upper : {false, true}) {
      const double edge = upper ? high : low;
      if (std::abs(edge) >= widest) continue;
      const bool in = made(line, edge);
      double by = in == upper ? step : -step, at = edge;
      for (;; by *= 2) {
        at += by;
        const bool outside = std::abs(at) > widest || (!in && (at < low || at > high));
        if (outside || made(line, at) != in) break;
      }
    }
  }

  /// Tries points at even steps of probability, shifted from scanline to scanline. Both directions of a scanline are
  /// alike.
  void spread(NoiseScanline& line) {
    const std::size_t count = one_line()       ? points_on_only
                              : lines_.empty() ? points_on_first
                              : scratches_     ? points_of_balls
                                               : points_on_others;
    constexpr double golden = 0.6180339887;  // shifts that never repeat
    const double share = 1 / static_cast<double>(count),
                 shift = std::fmod(0.5 + static_cast<double>(lines_.size()) * golden, 1);
    const auto look = [&](double p) {
      const auto close = [&](const NoiseScanline::Try& t) { return std::abs(about_below(t.across) - p) < share / 4; };
      if (std::none_of(line.tries.begin(), line.tries.end(), close)) made(line, about_at(p));
    };
    for (std::size_t k = 0; k < count / 2; ++k)
      for (const double p : {(static_cast<double>(k) + shift) * share, 1 - (static_cast<double>(k) + shift) * share})
        look(p);
    if (count % 2 == 1) look(0.5);
    // An edge may hide beyond the last of them.
    if (line.tries.empty()) return;
    if (line.tries.front().made) made(line, -widest);
    if (line.tries.back().made) made(line, widest);
  }

  /// Bisects every change between two tries, the likeliest first, and reads off the edges. Where the cue ball may fall,
  /// a scanline with more than one interval is left as it is: there are too many to follow, and more scanlines say
  /// more.
  void settle(NoiseScanline& line, const std::vector<double>& expected) {
    const auto width = [&](std::size_t i) {
      const NoiseScanline::Try &a = line.tries[i - 1], &b = line.tries[i];
      return a.made == b.made ? 0 : normal_below(b.across) - normal_below(a.across);
    };
    while (left() && !(scratches_ && line.changes() > 2)) {
      std::size_t at = 1;
      for (std::size_t i = 1; i < line.tries.size(); ++i)
        if (width(i) > width(at)) at = i;
      if (at >= line.tries.size() || !(width(at) > (one_line() ? finest : narrow))) break;
      made(line, (line.tries[at - 1].across + line.tries[at].across) / 2);
    }
    line.read_off(expected);
  }

  bool agrees_with_first_order() const {
    return std::abs(success_of(lines_) - shot_.robustness.success_estimate) < agrees;
  }

  /// Returns how much a scanline before scanline i may tell: the probability between the two, which counts more where
  /// their success differs.
  double tells(std::size_t i) const {
    const NoiseScanline &a = lines_[i - 1], &b = lines_[i];
    return (normal_below(b.along) - normal_below(a.along)) * (1 + of_change * std::abs(b.success - a.success));
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  const Shot& shot_;
  Goal goal_;
  struct {
    double angle, speed;  ///< rad and m/s, of this launch
  } noise_;
  Vec2d across_{};
  double length_ = std::numeric_limits<double>::infinity();
  std::vector<double> expected_{};
  std::size_t used_ = 0;
  bool scratches_ = false;  ///< the cue ball fell in some simulation
  std::vector<NoiseScanline> lines_{};
};

}  // namespace

double success_under_all_errors(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot) {
  long made = 0;
  each_play(request.spinning(shot.spin), shot.launch, settings::all_errors::draws,
            [&](const SearchRequest& own, const Launch& struck) {
              made += replay(own, budget, struck, Goal::counted(own, shot)).made;
              return true;
            });
  return static_cast<double>(made) / settings::all_errors::draws;
}

void find_success(const SearchRequest& request, EvaluationBudget& budget, Shot& shot) {
  shot.robustness.success = request.puzzle().errs_in_more() ? success_under_all_errors(request, budget, shot)
                                                            : Chance(request, budget, shot).run();
  shot.robustness.value = *shot.robustness.success - cost_of(shot);
}

}  // namespace bankshot::planning
