// SPDX-License-Identifier: MIT
//
// Beside a curve on which no launch is made, since something blocks the exact line all along: first where the locked
// path has room, then where the ball falls by the jaws.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "planners/solve/branch_search.hpp"
#include "planners/solve/settings.hpp"
#include "planners/trace/clearance.hpp"
#include "planners/trace/falls_by.hpp"

namespace bankshot::planning::branch {

using namespace settings::branch;

namespace {

/// rad that move the arrival across by the aim point's reach.
double across(const Branch& a, const Point& p) {
  return a.aim_point.reach / (p.off[0].by[aim] * a.request.problem->boundary.diagonal);
}

}  // namespace

Launch BranchSearch::beside(const Launch& line, double turn) { return {line.speed, wrap_angle(line.angle + turn)}; }

/// True where a launch is made: beside points of the walk, then beside points between them where room lacks little.
bool BranchSearch::look_beside(Curve& curve) {
  const auto look = [&] { return std::ranges::any_of(curve, [&](Tried& t) { return look_beside(t); }); };
  if (look()) return true;
  divide(curve, [&](const Tried& t) { return t.spare > -little_beside * start_.aim_point.reach; });
  return look();
}

bool BranchSearch::look_beside(Tried& t) {
  if (t.looked || budget_.spent()) return false;
  t.looked = true;
  if (t.made()) {
    keep(t);
    return is_listed(start_.aim_point, aim_.route, found_.shots);
  }
  if (!t.room || t.room->hidden > 0 || !(t.room->least() > -start_.aim_point.reach)) return false;
  request_.spin = spin_of(t.at.x);
  const double way = across(aim_, t.at);
  return look_to_one_side(t, way) || look_to_one_side(t, -way);
}

/// As long as there is more room the farther it goes, and none is lacking at the mouth. Room grows ever less steeply,
/// being the least of several: so much as lacks is skipped.
bool BranchSearch::look_to_one_side(Tried& t, double way) {
  const Launch line = launch_of(t.at.x);
  double before = t.room->least();
  constexpr int most = static_cast<int>(1 / apart_beside);
  for (int i = 1, steps = 1; i <= most; i += steps) {
    const Launch to = beside(line, i * apart_beside * way);
    const auto spare = room(aim_, budget_, to);
    if (!spare || !(spare->at_aim_point > 0) || !(spare->least() > std::min(before, 0.0))) return false;
    const double gained = (spare->least() - before) / steps;
    before = spare->least();
    const double left = spare->at_aim_point / (apart_beside * start_.aim_point.reach);
    t.spare = std::max(t.spare, before < 0 ? before + gained * left : before);
    steps = before < 0 ? 1 + static_cast<int>(std::min(-before / gained, 1.0 * most)) : 1;
    if (before > 0 && keep_beside(to)) return true;
  }
  return false;
}

/// True where it leads as the curve does. Of launches that lead to an aim point otherwise one is enough.
bool BranchSearch::keep_beside(const Launch& launch) {
  std::vector<Shot>& shots = found_.shots;
  const std::size_t known = shots.size();
  if (!certify(request_, budget_, found_, launch, bounces_of(aim_.route), word::continuation, Demand::off_centre))
    return false;
  if (is_listed(start_.aim_point, aim_.route, shots)) return true;
  const Shot& last = shots.back();
  if (shots.size() > known &&
      is_listed(request_.problem->aim_point_of(last), route_of(last), std::span(shots).first(known)))
    shots.pop_back();
  return false;
}

/// Off its jaws, or rails beside them: for each way to fall the middles of the bands of aims, the widest first, until
/// one is made.
void BranchSearch::look_for_jaw_shots(const Curve& curve) {
  std::map<std::vector<Contact>, std::vector<Strip>> ways;
  for (const Tried& t : curve)
    if (!t.between && t.room && !budget_.spent()) add_strips(t.at, ways);
  for (auto& [by, bands] : ways) {
    Route whole(aim_.route.begin(), aim_.route.end());
    for (const Contact c : by) whole.push_back({start_.aim_point.ball, c});
    const auto known = [&](const Shot& s) {
      return request_.problem->aim_point_of(s) == start_.aim_point && route_of(s) == whole;
    };
    if (std::ranges::any_of(found_.shots, known)) continue;
    std::ranges::stable_sort(bands, std::ranges::greater{}, [](const Strip& b) { return b.last - b.first; });
    for (const Strip& b : bands) {
      request_.spin = b.spin;
      if (certify(request_, budget_, found_, b.middle(), bounces_of(aim_.route), word::continuation,
                  Demand::off_centre))
        break;
    }
  }
}

/// Of one point of the curve.
void BranchSearch::add_strips(const Point& p, std::map<std::vector<Contact>, std::vector<Strip>>& ways) {
  request_.spin = spin_of(p.x);
  Strip band{launch_of(p.x), request_.spin, apart_jaw_shots * across(aim_, p)};
  std::optional<std::vector<Contact>> before;
  constexpr int most = static_cast<int>(1 / apart_jaw_shots);
  for (int i = -most; i <= most; ++i) {
    auto by = falls_by(aim_, budget_, beside(band.line, i * band.step));
    if (by) {
      band.last = i;
      if (by != before) band.first = i;
      std::vector<Strip>& known = ways[*by];
      if (by == before)
        known.back() = band;
      else
        known.push_back(band);
    }
    before = std::move(by);
  }
}

}  // namespace bankshot::planning::branch
