// SPDX-License-Identifier: MIT
#include "planners/steps/to_ball.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "planners/locked/newton.hpp"
#include "planners/settings.hpp"
#include "planners/steps/part.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::chains;

/// Straight there all aims that touch it; else as far beside its middle as first order says that it goes.
std::optional<Range> aims_across(const Question& q, Ledger& ledger, ToPlace& to_ball, const Objects::Object& object,
                                 const Lead& lead) {
  const double reach = q.boundary.rim(Contact::ball(object.ball))->radius;
  if (lead.route.empty() && q.spin.masse == 0) {
    const Vec2d way = object.at_rest.at - q.puzzle.ball.at;
    const double half = std::asin(std::min(1.0, reach / norm(way))), to = std::atan2(way.y, way.x);
    return Range{to - half, to + half};
  }
  const Question& own = to_ball.at(object.at_rest.at);
  const LockedAim aim{own, lead.route, own.marks.front()};
  const auto root = newton(aim, ledger, {*own.pinned, lead.launch.angle}, settings::wide);
  const auto l = root ? linearise(aim, ledger, root.launch) : std::nullopt;
  if (!l || l->by_aim(0) == 0) return {};
  const double half = std::min(widest_aims, sweep_beyond * reach / std::abs(l->by_aim(0) * q.boundary.diagonal));
  return Range{root.launch.angle - half, root.launch.angle + half};
}

}  // namespace

double middle_speed(const Question& q) {
  return q.one_unknown() ? q.fixed_speed()
                         : std::sqrt(std::max(q.speed.low, q.speed.high * slowest_swept) * q.speed.high);
}

double slowest_tried(const Question& q) { return std::max(q.speed.low, q.speed.high * settings::slowest_of_fastest); }

std::vector<Approach> approaches(const Question& q, Ledger& ledger, const Objects::Object& object,
                                 const CushionRule& cushions, Step step) {
  ToPlace to_ball(q, by_itself(q, cushions), middle_speed(q));
  Findings starts;
  step(to_ball.at(object.at_rest.at), ledger, starts);
  std::vector<Approach> out;
  std::set<Route> looked;
  for (const Lead& lead : starts.leads) {
    if (looked.contains(lead.route)) continue;
    const auto across = aims_across(q, ledger, to_ball, object, lead);
    if (!across) continue;
    looked.insert(lead.route);
    out.push_back({lead.route, *across});
  }
  return out;
}

void each_launch(const Question& q, const Range& across, const Grid& grid,
                 const std::function<bool(const Launch&, int)>& look) {
  const double half = (across.high - across.low) / 2, middle = across.low + half;
  const double slowest = slowest_tried(q);
  const int rows = q.one_unknown() ? 1 : grid.speeds;
  for (int i = -grid.aims; i <= grid.aims; ++i)
    for (int k = 0; k < rows; ++k) {
      const double speed =
          rows > 1 ? slowest * std::pow(q.speed.high / slowest, static_cast<double>(k) / (rows - 1)) : q.fixed_speed();
      if (look({speed, middle + half * std::sin(widest_cut * i / grid.aims)}, k)) return;
    }
}

void starts_by_map(const Question& q, Ledger& ledger, Findings& found) {
  images(q, ledger, found);
  if (q.route) fan(q, ledger, found);
  if (!is_straight(q.puzzle.physics)) map(q, ledger, found, usual_spacing(q));
}

}  // namespace bankshot::planning::steps
