// SPDX-License-Identifier: MIT
//
// Continuation along a branch that is a curve. It steps both ways, until the free quantity ends or the curve leaves the
// bounds for good. Then the points are replayed, and the best of each connected part that is made is kept.
#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/solve/branch_search.hpp"
#include "planners/solve/settings.hpp"

namespace bankshot::planning::branch {

using namespace settings::branch;

BranchSearch::Curve BranchSearch::curve_through(const Point& from) {
  Curve curve;
  extend(from, -1, curve);
  std::reverse(curve.begin(), curve.end());
  curve.push_back({from});
  extend(from, 1, curve);
  return curve;
}

void BranchSearch::extend(const Point& from, double way, Curve& out) {
  Point at = from;
  Vector t = tangents(at).col(0) * way;
  double h = 1;
  for (int i = 0; i < most_walked && !budget_.spent();) {
    if (leaves_for_good(at, t)) return;
    const Vector guess = at.x + h * scales().cwiseProduct(t);
    const auto next = corrected(guess, wide_, -1, drops() ? loosely : settings::settled);
    const double gone = next ? (next->x - at.x).cwiseQuotient(scales()).dot(t) : 0,
                 pulled = next ? (next->x - guess).cwiseQuotient(scales()).norm() : infinite;
    const bool ends = next && at_end(*next);
    if (ends && gone > finest * h) out.push_back({*next});
    if (ends || (next && std::abs(gone) < settings::settled))
      return;  // no progress: to rounding it was at the end before
    if (!(pulled < h / 2)) {
      h /= 2;
      if (h < finest) return;
      continue;
    }
    out.push_back({*next});
    ++i;
    const Vector on = tangents(*next).col(0);
    t = on.dot(t) < 0 ? Vector(-on) : on;
    at = *next;
    if (pulled < h / 8) h = std::min(2 * h, longest_step);
  }
}

/// Returns whether a curve is outside the bounds on the launch speed for good. Faster launches arrive faster, with
/// hardly an exception along a branch.
bool BranchSearch::leaves_for_good(const Point& at, const Vector& way) const {
  const double speed = at.x[log_speed], on = way[log_speed];
  return (speed > box_.high[log_speed] && on > 0) || (speed < box_.low[log_speed] && on < 0);
}

/// Returns whether the arrival speed or a spin is at the end of its range.
bool BranchSearch::at_end(const Point& p) const {
  bool at_bound = false;
  equations(p, at_bound);
  if (at_bound && !request_.arrival->fixed()) return true;
  for (int i = top; i < coordinates; ++i)
    if (wide_.free(i) && (p.x[i] <= wide_.low[i] || p.x[i] >= wide_.high[i])) return true;
  return false;
}

/// Adds the points where the curve enters and leaves the bounds of aim and speed.
void BranchSearch::add_crossings(Curve& curve) {
  for (const int c : {aim, log_speed})
    for (const double bound : {box_.low[c], box_.high[c]})
      for (std::size_t i = 1; i < curve.size() && std::isfinite(bound) && !budget_.spent(); ++i) {
        const Vector &a = curve[i - 1].at.x, &b = curve[i].at.x;
        if (!((a[c] - bound) * (b[c] - bound) < 0)) continue;
        Vector x = a + (b - a) * ((bound - a[c]) / (b[c] - a[c]));
        x[c] = bound;
        if (const auto on = corrected(x, wide_, c))
          curve.insert(curve.begin() + static_cast<std::ptrdiff_t>(i++), {*on});
      }
}

/// Replays a point only if its locked path has clearance: a replay costs three times as much.
BranchSearch::Tried BranchSearch::attempt_where_clear(const Point& p) {
  const std::optional<Room> spare = inside(p) ? room(aim_, budget_, launch_of(p.x)) : std::nullopt;
  const bool clear = spare && spare->hidden == 0 && spare->least() > 0;
  const auto exact = clear ? corrected(p.x, wide_) : std::nullopt;
  Tried t = exact ? attempt(*exact) : Tried{p, merit(p), {}};
  t.room = spare;
  return t;
}

/// Adds points between two points of the continuation of which one is hopeful.
void BranchSearch::divide(Curve& curve, const std::function<bool(const Tried&)>& is_hopeful) {
  const auto parts = [&](const Tried& a, const Tried& b) {
    const bool looked = a.between || b.between || !(inside(a.at) || inside(b.at)) || budget_.spent();
    return looked || !(is_hopeful(a) || is_hopeful(b)) ? 1 : parts_between;
  };
  Curve finer;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const int n = i > 0 ? parts(curve[i - 1], curve[i]) : 1;
    for (int k = 1; k < n; ++k) {
      const Vector &a = curve[i - 1].at.x, &b = curve[i].at.x;
      if (const auto p = corrected(a + (b - a) * (static_cast<double>(k) / n), wide_, -1, loosely))
        finer.push_back(attempt_where_clear(*p)), finer.back().between = true;
    }
    finer.push_back(curve[i]);
  }
  curve = std::move(finer);
}

/// Adds points where the locked path has clearance, or one little below 0. Balls that move may block it there, but
/// perhaps not at all speeds.
void BranchSearch::look_between(Curve& curve) {
  divide(curve, [&](const Tried& t) {
    return t.room && t.room->hidden == 0 && t.room->least() > -little_lack * start_.aim_point.reach;
  });
}

void BranchSearch::keep_parts(Curve& curve) {
  for (Tried& t : curve) {
    t = drops() ? attempt_where_clear(t.at) : attempt(t.at);
    if (request_.first() && t.made()) return keep(t);
  }
  if (drops() && request_.all() && std::ranges::none_of(curve, &Tried::made)) look_between(curve);
  for (std::size_t begin = 0, end = 0; begin < curve.size(); begin = end + 1) {
    end = begin;
    while (end < curve.size() && curve[end].made()) ++end;
    if (end == begin) continue;
    std::size_t best = begin;
    for (std::size_t i = begin; i < end; ++i)
      if (curve[i].merit > curve[best].merit) best = i;
    const bool first = best == 0, last = best + 1 == curve.size();
    if (!first && !last && curve[best - 1].made() && curve[best + 1].made())
      keep(peak(curve[best - 1], curve[best], curve[best + 1]));
    else if (!first && best == begin && curve[best - 1].merit > curve[best].merit)
      keep(edge(curve[best], curve[best - 1]));
    else if (!last && best + 1 == end && curve[best + 1].merit > curve[best].merit)
      keep(edge(curve[best], curve[best + 1]));
    else
      keep(curve[best]);
  }
}

/// Returns the last shot on the way to a point that is no shot.
BranchSearch::Tried BranchSearch::edge(const Tried& inside_, const Tried& outside_) {
  Tried in = inside_, out = outside_;
  if (request_.puzzle().prefer == Prefer::robust) return in;  // little is made beside the edge: no better place
  while (std::abs(out.merit - in.merit) > fine_merit * std::max(1.0, std::abs(in.merit)) && !budget_.spent()) {
    const auto middle = corrected((in.at.x + out.at.x) / 2, wide_);
    if (!middle) break;
    Tried t = attempt(*middle);
    const bool made = t.made();
    if ((made ? t.merit - in.merit : out.merit - t.merit) <= 0) break;  // the merit turned round
    (made ? in : out) = std::move(t);
  }
  return in;
}

/// Returns the point at the top of the parabola through three points of a curve, if that is higher.
BranchSearch::Tried BranchSearch::peak(const Tried& low, const Tried& best, const Tried& high) {
  const double a = -(best.at.x - low.at.x).cwiseQuotient(scales()).norm(),
               b = (high.at.x - best.at.x).cwiseQuotient(scales()).norm();
  const double fa = low.merit - best.merit, fb = high.merit - best.merit;
  const double denominator = fa * b - fb * a;
  if (!(denominator != 0) || !(a < 0 && b > 0) || budget_.spent()) return best;
  const double to = (fa * b * b - fb * a * a) / (2 * denominator);
  if (!(to > a && to < b)) return best;
  const Tried& end = to < 0 ? low : high;
  const auto p = corrected(best.at.x + (end.at.x - best.at.x) * (to / (to < 0 ? a : b)), wide_);
  if (!p) return best;
  Tried t = attempt(*p);
  return t.made() && t.merit > best.merit ? t : best;
}

}  // namespace bankshot::planning::branch
