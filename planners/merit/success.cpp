// SPDX-License-Identifier: MIT
//
// `success`: the probability that the target is made, by any allowed cushions, under the player's normal errors of aim
// and speed (more of them: all_errors.hpp). Method: counted in the player's deviations the errors of aim and speed are
// equally likely in every direction, so their plane may be turned: `across` is the direction that moves the arrival
// most, to first order, `along` the one at right angles. What is made is then a band, or a few, along `along`. On a
// line across it the edges are bisected, and the success on that line follows from them; noise_scanlines.hpp says what
// all lines together make of it. Lines begin evenly spaced; more are laid where the success changes other than its
// neighbours say. Edges are looked for where the neighbouring lines have them, between some points spread over the line
// and its ends, so that a band which nobody expects is met too; then the neighbours are looked at again. Where that
// agrees with first order (limits.hpp) and leaves little doubt, it ends.
// Cost: most_samples simulations at most, most_samples_of_balls once the cue ball is seen to fall. Guarantee: none;
// docs/evidence.md has what was measured.
#include "planners/merit/success.hpp"
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planners/merit/all_errors.hpp"
#include "planners/merit/noise_scanlines.hpp"
#include "planners/merit/room.hpp"
#include "planners/merit/settings.hpp"
#include "planners/proof/replay.hpp"

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
    if (is_ideal(request_.puzzle().physics)) {  // any speed will do that is one: one line is all
      add(0);
      const double noise = noise_.speed;
      return lines_.front().success * (noise > 0 ? normal_below(shot_.launch.speed / noise) : 1);
    }
    // A band that ends within reach is met by as many lines, and one on either side looks beyond it.
    const double scale = std::min(1.0, beyond_end * length_ / outermost);
    for (const double along : first_lines) add(scale * along);
    if (scale < 1)
      for (const double side : {1.0, -1.0}) add(side * (scale + 1) / 2 * outermost);
    while (used_ + cheapest_line <= most()) {
      std::size_t at = 0;
      double worst = least_doubt;
      for (std::size_t i = 0; i + 1 < lines_.size(); ++i)
        if (const double d = doubt(i); d > worst) worst = d, at = i + 1;
      if (at == 0 || (!scratches_ && worst < doubt_of_agreed &&
                      std::abs(success_of(lines_) - shot_.robustness.success_estimate) < agrees))
        break;
      add((lines_[at - 1].along + lines_[at].along) / 2);
    }
    return success_of(lines_);
  }

 private:
  /// Turns the plane of errors, and sees what the derivatives say of the band.
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

  /// Cue balls that fall cut what is made into parts of which first order knows nothing.
  std::size_t most() const { return scratches_ ? most_samples_of_balls : most_samples; }
  bool left() const { return used_ < most() && !budget_.spent(); }

  /// Simulates one pair of errors; where no simulation is left, as the line's edges say.
  bool made(NoiseScanline& line, double across) {
    const auto at = std::lower_bound(line.tries.begin(), line.tries.end(), across,
                                     [](const NoiseScanline::Try& t, double v) { return t.across < v; });
    if (at != line.tries.end() && at->across == across) return at->made;
    if (!left()) return line.made(across);
    ++used_;
    const double turned = across_.x * across - across_.y * line.along,
                 harder = across_.y * across + across_.x * line.along;
    const double speed = shot_.launch.speed + noise_.speed * harder, angle = shot_.launch.angle + noise_.angle * turned;
    const Replay r = speed > 0 ? replay(request_, budget_, {speed, wrap_angle(angle)}, goal_) : Replay{};
    scratches_ = scratches_ || r.failure.reason == FailureReason::scratched;
    line.tries.insert(at, {across, r.made});
    return r.made;
  }

  struct Expected {
    NoiseScanline line;
    bool sure = true;  ///< the neighbours agree how many edges there are
  };

  /// Edges in line with those of the two nearest lines.
  Expected expect(double along) const {
    Expected e{{along}};
    e.line.edges = expected_;
    if (lines_.empty()) return e;
    const auto after = std::lower_bound(lines_.begin(), lines_.end(), along,
                                        [](const NoiseScanline& l, double v) { return l.along < v; });
    const bool between = after != lines_.begin() && after != lines_.end(), two = lines_.size() > 1;
    const NoiseScanline& near = after == lines_.begin() ? *after : *(after - 1);
    const NoiseScanline& far = between ? *after : !two ? near : after == lines_.begin() ? *(after + 1) : *(after - 2);
    e.sure = near.edges.size() == far.edges.size() && near.open == far.open;
    const NoiseScanline& like = !e.sure && between && far.edges.size() > near.edges.size() ? far : near;
    e.line.edges = like.edges;
    e.line.open = like.open;
    if (!e.sure || &near == &far) return e;
    const double share = (along - near.along) / (far.along - near.along);
    for (std::size_t i = 0; i < near.edges.size(); ++i) e.line.edges[i] += share * (far.edges[i] - near.edges[i]);
    std::sort(e.line.edges.begin(), e.line.edges.end());
    return e;
  }

  void add(double along) {
    NoiseScanline line{along};
    const Expected e = expect(along);
    for (std::size_t k = 0; k <= e.line.edges.size(); ++k) {
      const double low = k > 0 ? std::max(e.line.edges[k - 1], -widest) : -widest;
      const double high = k < e.line.edges.size() ? std::min(e.line.edges[k], widest) : widest;
      const bool in = e.line.open != (k % 2 == 1);
      if (in && low < high && (e.sure || made(line, (low + high) / 2))) follow(line, low, high);
    }
    spread(line, e.line.edges.empty());
    settle(line, e.line.edges);
    const auto after = std::lower_bound(lines_.begin(), lines_.end(), along,
                                        [](const NoiseScanline& l, double v) { return l.along < v; });
    const auto at = lines_.insert(after, std::move(line)) - lines_.begin();
    tell(at, -1);
    tell(at, 1);
  }

  /// Brackets both ends of what is expected to be made, by steps that double.
  void follow(NoiseScanline& line, double low, double high) {
    for (const bool upper : {false, true}) {
      const double edge = upper ? high : low;
      if (std::abs(edge) >= widest) continue;
      const bool in = made(line, edge);
      double by = in == upper ? step : -step, at = edge;
      for (int i = 0; i < most_doublings; ++i, by *= 2) {
        at += by;
        const bool outside = std::abs(at) > widest || (!in && (at < low || at > high));
        if (outside || made(line, at) != in) break;
      }
    }
  }

  /// Points at even steps of probability, shifted from line to line; both ways of a line are alike.
  void spread(NoiseScanline& line, bool no_edges) {
    const bool later = lines_.size() >= first_lines.size();
    const std::size_t count = is_ideal(request_.puzzle().physics) ? points_on_only
                              : lines_.empty()                    ? points_on_first
                              : scratches_                        ? points_of_balls
                              : later && no_edges                 ? points_without_edges
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
        look(tail + p * (1 - 2 * tail));
    if (count % 2 == 1) look(0.5);
    // Beyond the last of them an edge may hide.
    if (line.tries.empty()) return;
    if (line.tries.front().made) made(line, -widest);
    if (line.tries.back().made) made(line, widest);
  }

  /// How wide a bracket is, in what it may hide: far out there is little.
  static double width(const NoiseScanline::Try& a, const NoiseScanline::Try& b) {
    const double z = std::max({a.across, -b.across, 0.0});
    return (b.across - a.across) * std::min(1.0, thin_out * std::exp(-z * z / 2));
  }

  /// Bisects every change between two tries, the widest first, and reads off the edges. Where the cue ball may fall, a
  /// line with more than one band is left as it is: its parts are too many to follow, and more lines say more.
  void settle(NoiseScanline& line, const std::vector<double>& expected) {
    const double enough = (is_ideal(request_.puzzle().physics) ? finest : lines_.empty() ? finer : narrow) * (1 + 1e-9);
    while (left() && !(scratches_ && line.changes() > 2)) {
      double most = enough, at = 0;
      for (std::size_t i = 0; i + 1 < line.tries.size(); ++i) {
        const NoiseScanline::Try &a = line.tries[i], &b = line.tries[i + 1];
        if (a.made != b.made && width(a, b) > most) most = width(a, b), at = (a.across + b.across) / 2;
      }
      if (most == enough) break;
      made(line, at);
    }
    line.read_off(expected);
  }

  /// Neighbours that lack an edge which this line has are tried beside it, and so on outwards.
  void tell(std::ptrdiff_t from, std::ptrdiff_t way) {
    for (std::ptrdiff_t i = from + way; i >= 0 && i < std::ssize(lines_); i += way) {
      const NoiseScanline& source = lines_[static_cast<std::size_t>(i - way)];
      NoiseScanline& line = lines_[static_cast<std::size_t>(i)];
      const std::size_t before = line.edges.size();
      if (before >= source.edges.size() || !left()) return;
      for (std::size_t k = 0; k < source.edges.size(); ++k) {
        const double edge = source.edges[k];
        const auto known = [&](double e) { return std::abs(e - edge) < same_edge; };
        if (std::abs(edge) > widest || std::any_of(line.edges.begin(), line.edges.end(), known)) continue;
        const double low = k > 0 ? source.edges[k - 1] : -widest,
                     high = k + 1 < source.edges.size() ? source.edges[k + 1] : widest;
        for (const double at :
             {std::max(edge - beside_edge, (edge + low) / 2), std::min(edge + beside_edge, (edge + high) / 2)})
          if (line.made(at) != source.made(at)) made(line, at);
      }
      settle(line, source.edges);
      if (line.edges.size() <= before) return;
    }
  }

  /// What success may be wrong between two lines: how far each is from where its neighbours point.
  double doubt(std::size_t i) const {
    const NoiseScanline &a = lines_[i], &b = lines_[i + 1];
    const auto off = [](const NoiseScanline& far, const NoiseScanline& near, const NoiseScanline& line) {
      const double slope = (near.success - far.success) / (near.along - far.along);
      return std::abs(line.success - std::clamp(near.success + slope * (line.along - near.along), 0.0, 1.0));
    };
    const double before = i > 0 ? off(lines_[i - 1], a, b) : 0,
                 after = i + 2 < lines_.size() ? off(lines_[i + 2], b, a) : 0;
    return (normal_below(b.along) - normal_below(a.along)) *
           (std::max(before, after) + doubt_of_change * std::abs(b.success - a.success) + doubt_always);
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
  bool scratches_ = false;  ///< in some simulation
  std::vector<NoiseScanline> lines_{};
};

}  // namespace

void find_success(const SearchRequest& request, EvaluationBudget& budget, Shot& shot) {
  shot.robustness.success = request.puzzle().errs_in_more() ? success_under_all_errors(request, budget, shot)
                                                            : Chance(request, budget, shot).run();
  shot.robustness.value = *shot.robustness.success - cost_of(shot);
}

}  // namespace bankshot::planning
