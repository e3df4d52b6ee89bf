// SPDX-License-Identifier: MIT
//
// Shots that count on the jaws of their pocket, for where none enters cleanly.
// Method: the forward map tells which aims lead from each cell across a mouth; rows of launches across it are replayed.
// Between two that drop, one too fast and one too slow, the aim is bisected; of others the speed is corrected by
// secants, which keep to launches that drop, until the ball falls as fast as asked. Where one launch speed is all there
// is, or shows the shape of all paths, all aims are tried instead, in steps of 0.02°.
// Cost: a simulation a cell, and some twenty for each mouth that a cell looks into; 20,000 for all aims.
// Guarantee: none; balls rattle in from bands of aims, of which narrow ones lie between the launches of a row, as do
// nearly all that meet a cushion after a jaw.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/certify.hpp"
#include "planners/line_search.hpp"
#include "planners/locked/forward.hpp"
#include "planners/settings.hpp"
#include "planners/steps/forward_map.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::rattles;

class Rattles {
 public:
  Rattles(const Question& q, Ledger& ledger, Findings& found)
      : q_(q), ledger_(ledger), found_(found), straight_(is_straight(q.puzzle.physics)) {}

  void run() {
    const Range aims = q_.angle.value_or(whole_turn);
    if (q_.one_unknown() || straight_) return all_aims(aims);
    const int columns = static_cast<int>(std::ceil((aims.high - aims.low) / cell.aim));
    const double width = columns > 0 ? (aims.high - aims.low) / columns : 0;
    for (const double speed : speeds_to_try(q_, cell.speed))
      for (int i = 0; i < std::max(columns, 1); ++i) {
        look_into_mouths(aims.low + width * (i + 0.5), width / 2, speed);
        if (done()) return;
      }
  }

 private:
  bool done() const { return ledger_.spent() || (!q_.all() && found_.shots.size() >= (q_.first() ? 1 : enough)); }

  /// A launch that drops.
  struct Dropped {
    Launch launch;
    double arrival;  ///< m/s
  };

  /// Where one launch speed is all there is, or shows the shape of all: those that come off other jaws first are found
  /// as well. Beside an aim that meets jaws the next are nearer.
  void all_aims(const Range& aims) {
    const int launches = 1 + static_cast<int>((aims.high - aims.low) / coarse_aim);
    const double step = (aims.high - aims.low) / launches;
    bool before = false;
    for (int i = 0; i <= launches && !done(); ++i) {
      const double aim = aims.low + step * i;
      const bool here = meets_jaws(aim);
      for (int k = 1; k < finer && i > 0 && (before || here) && !done(); ++k) meets_jaws(aim - step * k / finer);
      before = here;
    }
  }

  /// Kept, where it is made.
  bool meets_jaws(double aim) {
    const Launch launch{q_.one_unknown() ? q_.fixed_speed() : q_.speed.high, aim};
    const Replay r = replay(q_, ledger_, launch, Goal::of(q_, Demand::made));
    if (r.made) keep_near({launch, r.arrival.speed}, Goal::exactly(q_, r.bounces, Demand::made));
    return r.rattles;
  }

  /// From a cell: launches at one speed, in a row across each mouth that its aims lead into.
  void look_into_mouths(double aim, double half, double speed) {
    forward(q_, ledger_, {speed, wrap_angle(aim)}, true, forward_);
    for (const Passage& p : forward_.passages) {
      const double by_aim = p.linear.by_aim(0) * q_.boundary.diagonal, across = p.linear.r[0] * q_.boundary.diagonal;
      const double middle = aim - across / by_aim, wide = mouths_across * q_.marks[p.mark].reach / std::abs(by_aim);
      const double low = std::max(aim - half, middle - wide), high = std::min(aim + half, middle + wide);
      if (!(low <= high)) continue;
      const int launches = 1 + static_cast<int>(launches_across * (high - low) / (2 * wide));
      const Goal goal = Goal::exactly(q_, static_cast<int>(p.bounces), Demand::made);
      std::optional<Dropped> before;
      for (int i = 0; i < launches && !done(); ++i) {
        const auto here = drop({speed, low + (high - low) * (i + 0.5) / launches}, goal);
        if (here && !(before && keep_between(*before, *here, goal))) keep_near(*here, goal);
        before = here;
      }
    }
  }

  std::optional<Dropped> drop(const Launch& launch, const Goal& goal) {
    if (ledger_.spent() || launch.speed < q_.speed.low || launch.speed > q_.speed.high) return {};
    const Replay r = replay(q_, ledger_, launch, goal);
    if (!r.made) return {};
    return Dropped{launch, r.arrival.speed};
  }

  /// Too slow: below 0.
  double excess(const Dropped& d) const {
    if (q_.one_unknown() || (d.arrival >= q_.arrival->low && d.arrival <= q_.arrival->high)) return 0;
    const double fine = tolerance::exact_speed * std::max(1.0, q_.asked) / 4, by = d.arrival - q_.asked;
    return std::abs(by) < fine ? 0 : by;
  }

  bool keep(const Dropped& d, const Goal& goal) {
    return excess(d) == 0 && certify(q_, ledger_, found_, d.launch, goal.min, word::rattles, Demand::off_centre);
  }

  /// One of them is too fast, the other too slow: the aim between.
  bool keep_between(Dropped a, Dropped b, const Goal& goal) {
    while (excess(a) * excess(b) < 0) {
      const double aim = arithmetic_mean(a.launch.angle, b.launch.angle);
      if (aim == a.launch.angle || aim == b.launch.angle) return false;
      const auto middle = drop({a.launch.speed, aim}, goal);
      if (!middle) return false;
      (excess(*middle) * excess(a) > 0 ? a : b) = *middle;
    }
    return keep(a, goal) || keep(b, goal);
  }

  /// With the same aim, by secants of the squared speeds that are shortened where they lead out of what drops.
  bool keep_near(Dropped at, const Goal& goal) {
    const auto square = [](double x) { return x * x; };
    double slope = (straight_ ? 1 : usual_slope) * square(at.arrival / at.launch.speed);
    for (int i = 0; i < most_secants && excess(at) != 0; ++i) {
      double by = (square(q_.asked) - square(at.arrival)) / (slope * square(at.launch.speed));
      if (!straight_ && !(std::abs(by) < farthest)) return false;
      by = std::clamp(by, -most_braked, most_pushed);
      const auto changed = [&] { return drop({at.launch.speed * std::sqrt(1 + by), at.launch.angle}, goal); };
      auto next = changed();
      for (int k = 0; !next && k < most_shortened; ++k) by /= shorter, next = changed();
      if (!next) return false;
      slope = (square(next->arrival) - square(at.arrival)) / (square(next->launch.speed) - square(at.launch.speed));
      at = *next;
    }
    return keep(at, goal);
  }

  const Question& q_;
  Ledger& ledger_;
  Findings& found_;
  bool straight_;  ///< the speed does not change the shape of a path
  Forward forward_{};
};

}  // namespace

void rattles(const Question& q, Ledger& ledger, Findings& found) {
  if (q.drops() && !q.boundary.jaws.empty()) Rattles(q, ledger, found).run();
}

}  // namespace bankshot::planning::steps
