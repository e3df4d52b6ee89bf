// SPDX-License-Identifier: MIT
//
// Beside a curve on which no launch is made, since something blocks the exact line all along: first where the locked
// path has room, then where the ball rattles in.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "planners/family/family.hpp"
#include "planners/family/settings.hpp"
#include "planners/locked/clearance.hpp"
#include "planners/locked/falls_by.hpp"

namespace bankshot::planning::family {

using namespace settings::family;

namespace {

/// rad that move the arrival across by the mark's reach.
double across(const LockedAim& a, const Point& p) { return a.mark.reach / (p.off[0].by[aim] * a.q.boundary.diagonal); }

}  // namespace

Launch Family::beside(const Launch& line, double turn) { return {line.speed, wrap_angle(line.angle + turn)}; }

/// True where a launch is made.
bool Family::look_beside(const Curve& curve) {
  for (const Tried& t : curve) {
    if (!t.room || t.room->hidden > little_turn || !(t.room->least() > -start_.mark.reach) || ledger_.spent()) continue;
    q_.spin = spin_of(t.at.x);
    for (const double way : {across(aim_, t.at), -across(aim_, t.at)})
      if (look_to_one_side(launch_of(t.at.x), way, t.room->least())) return true;
  }
  return false;
}

/// As long as there is more room the farther it goes, and none is lacking at the mouth. Room grows ever less steeply,
/// being the least of several: so much as lacks is skipped.
bool Family::look_to_one_side(const Launch& line, double way, double before) {
  for (int i = 1, steps = 1; i <= most_beside; i += steps) {
    const Launch to = beside(line, i * apart_beside * way);
    const auto spare = room(aim_, ledger_, to);
    if (!spare || !(spare->at_mark > 0) || !(spare->least() > std::min(before, 0.0))) return false;
    const double gained = (spare->least() - before) / steps;
    before = spare->least();
    steps = before < 0 ? 1 + static_cast<int>(std::min(-before / gained, 1.0 * most_beside)) : 1;
    if (before > 0 && certify(q_, ledger_, found_, to, bounces_of(aim_.route), step_, Demand::off_centre)) return true;
  }
  return false;
}

/// Off its jaws, or rails beside them: for each way to fall the middles of the bands of aims, the widest first, until
/// one is made.
void Family::look_for_rattles(const Curve& curve) {
  std::map<std::vector<Contact>, std::vector<Band>> ways;
  std::size_t i = 0;
  for (const Tried& t : curve)
    if (!t.between && i++ % rattle_points == rattle_points - 1 && t.room && !ledger_.spent()) add_bands(t.at, ways);
  for (auto& [by, bands] : ways) {
    Route whole(aim_.route.begin(), aim_.route.end());
    for (const Contact c : by) whole.push_back({start_.mark.ball, c});
    const auto known = [&](const Shot& s) { return q_.mark_of(s) == start_.mark && route_of(s) == whole; };
    if (std::ranges::any_of(found_.shots, known)) continue;
    std::ranges::stable_sort(bands, std::ranges::greater{}, [](const Band& b) { return b.last - b.first; });
    for (const Band& b : bands) {
      q_.spin = b.spin;
      if (certify(q_, ledger_, found_, b.middle(), bounces_of(aim_.route), step_, Demand::off_centre)) break;
    }
  }
}

/// Of one point of the curve.
void Family::add_bands(const Point& p, std::map<std::vector<Contact>, std::vector<Band>>& ways) {
  q_.spin = spin_of(p.x);
  Band band{launch_of(p.x), q_.spin, apart_rattles * across(aim_, p)};
  std::optional<std::vector<Contact>> before;
  for (int i = -most_rattles; i <= most_rattles; ++i) {
    auto by = falls_by(aim_, ledger_, beside(band.line, i * band.step));
    if (by) {
      band.last = i;
      if (by != before) band.first = i;
      std::vector<Band>& known = ways[*by];
      if (by == before)
        known.back() = band;
      else
        known.push_back(band);
    }
    before = std::move(by);
  }
}

}  // namespace bankshot::planning::family
