// SPDX-License-Identifier: MIT
//
// The search beside a curve on which no launch is made, since the exact line is blocked all along. It looks first where
// the locked path has clearance, then where the ball falls by the jaws.
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

/// Returns the turn of the aim [rad] that moves the arrival across by the aim point's reach.
double across(const Branch& a, const Point& p) {
  return a.aim_point.reach / (p.off[0].by[aim] * a.request.problem->boundary.diagonal);
}

}  // namespace

Launch BranchSearch::beside(const Launch& line, double turn) { return {line.speed, wrap_angle(line.angle + turn)}; }

/// Looks beside the points of the continuation, then beside points between them where the clearance is little below 0.
/// Returns whether a launch is made.
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

/// Looks to one side, as long as the clearance grows with the distance and the one at the aim point is positive. The
/// clearance is the least of several, so it grows ever less steeply. Steps that cannot make it positive are skipped.
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

/// Keeps a shot; returns whether it leads as the curve does. Of launches that lead to an aim point otherwise one is
/// enough.
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

/// Searches for shots that fall by the jaws, or by rails beside them. For each order of these contacts it verifies the
/// middles of the windows of aims, the widest first, until one is made.
void BranchSearch::look_for_jaw_shots(const Curve& curve) {
  std::map<std::vector<Contact>, std::vector<Strip>> ways;
  for (const Tried& t : curve)
    if (!t.between && t.room && !budget_.spent()) add_strips(t.at, ways);
  for (auto& [by, strips] : ways) {
    Route whole(aim_.route.begin(), aim_.route.end());
    for (const Contact c : by) whole.push_back({start_.aim_point.ball, c});
    if (is_listed(start_.aim_point, whole, found_.shots)) continue;
    std::ranges::stable_sort(strips, std::ranges::greater{}, [](const Strip& b) { return b.last - b.first; });
    for (const Strip& b : strips) {
      request_.spin = b.spin;
      if (certify(request_, budget_, found_, b.middle(), bounces_of(aim_.route), word::continuation,
                  Demand::off_centre))
        break;
    }
  }
}

/// Adds the windows of aims beside one point of the curve, by the cushions through which the ball falls.
void BranchSearch::add_strips(const Point& p, std::map<std::vector<Contact>, std::vector<Strip>>& ways) {
  request_.spin = spin_of(p.x);
  const Launch line = launch_of(p.x);
  const double step = apart_jaw_shots * across(aim_, p);
  std::optional<std::vector<Contact>> before;
  constexpr int most = static_cast<int>(1 / apart_jaw_shots);
  for (int i = -most; i <= most; ++i) {
    auto by = falls_by(aim_, budget_, beside(line, i * step));
    if (by) {
      std::vector<Strip>& known = ways[*by];
      if (by != before) known.push_back({line, request_.spin, step, i, i});
      known.back().last = i;
    }
    before = std::move(by);
  }
}

}  // namespace bankshot::planning::branch
