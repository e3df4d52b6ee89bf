// SPDX-License-Identifier: MIT
#include "planners/merit/margin.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/line_search.hpp"
#include "planners/proof/replay.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

using namespace settings::margin;

/// The largest step, up to `limit`, such that `made` holds all the way; none when it never breaks.
/// A gap in between narrower than a quarter of the step so far can be stepped over.
template <class Made>
std::optional<double> how_far(double scale, double limit, Made&& made) {
  double good = 0, step = std::min(scale * first_step, limit);
  while (made(step)) {
    if (step >= limit) return {};
    good = step;
    step = std::min(growth * step, limit);
  }
  bisect(
      good, step, [](double in, double out) { return out - in > tolerance::margin * out && out > finest; }, made);
  return good;
}

std::optional<double> downwards(std::optional<double> distance) {
  return distance ? std::optional(-*distance) : distance;
}

}  // namespace

void find_margin(const Question& q, Ledger& ledger, Shot& shot) {
  const Goal goal = Goal::along(shot.cushions);
  const Launch& at = shot.launch;
  const auto made = [&](double speed, double angle) {
    return speed > 0 && replay(q, ledger, {speed, wrap_angle(angle)}, goal).made;
  };
  const double reach = q.nearest_mark(shot.arrival.at).reach;
  const double scale =
      std::clamp(reach / std::max(shot.condition, flat * q.boundary.diagonal), least_scale, most_scale);
  Margin m;
  m.angle[0] = downwards(how_far(scale, widest_angle, [&](double d) { return made(at.speed, at.angle - d); }));
  m.angle[1] = how_far(scale, widest_angle, [&](double d) { return made(at.speed, at.angle + d); });
  if (!is_ideal(q.puzzle.physics)) {
    const double push = scale * at.speed;
    m.speed[0] = downwards(how_far(push, at.speed, [&](double d) { return made(at.speed - d, at.angle); }));
    m.speed[1] = how_far(push, widest_speed, [&](double d) { return made(at.speed + d, at.angle); });
  }
  shot.margin = m;
}

}  // namespace bankshot::planning
