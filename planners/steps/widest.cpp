// SPDX-License-Identifier: MIT
#include "planners/steps/widest.hpp"

#include <algorithm>
#include <cmath>

#include "planners/certify.hpp"
#include "planners/line_search.hpp"
#include "planners/locked/clearance.hpp"
#include "planners/locked/levenberg_marquardt.hpp"
#include "planners/locked/speed.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

using namespace settings::widest;

Widest::Widest(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Candidate& candidate)
    : request_(request),
      budget_(budget),
      found_(found),
      candidate_(candidate),
      aim_{request, candidate.route, candidate.aim_point} {
  if (!(candidate.half > 0)) candidate.half = half_window();
}

/// rad: how far the aim may turn from a root until the ball passes all of the target, its speed
/// adapted to arrive as asked.
double Widest::half_window() const {
  const auto l = linearise(aim_, budget_, candidate_.launch);
  if (!l) return 0;
  double lateral = l->by_aim(0);  // of the diagonal, per radian
  if (!request_.one_unknown())
    lateral = l->determinant(false) / (request_.stop ? std::hypot(l->by_speed(0), l->by_speed(1)) : l->by_speed(1));
  const double half = candidate_.aim_point.reach / (std::abs(lateral) * request_.problem->boundary.diagonal);
  return half < widest_half ? half : widest_half;
}

/// Golden sections around a peak of a row, until little can be gained. `Attempt`: (aim, guess of the speed) -> Tried.
template <class Attempt>
Widest::Tried Widest::highest(const Row& row, std::size_t peak, const Attempt& attempt) {
  const auto settled = [](const Tried& low, const Tried& best, const Tried& high) {
    return best.value - std::min(low.value, high.value) < little_gain * std::abs(best.value);
  };
  return climb(
      before(row, peak), row[peak], after(row, peak), settings::rounding,
      [&](double aim, const Tried& best) { return attempt(aim, best.speed); }, settled);
}

bool Widest::find() {
  if (!(candidate_.half > 0)) return false;
  const Row row = along_lead();
  for (const std::size_t i : peaks_of(row)) {
    const Tried best = highest(row, i, [&](double aim, double guess) { return attempt(aim, guess); });
    candidate_.room = std::max(candidate_.room, best.value);
    if (shot(best)) return true;
  }
  return false;
}

bool Widest::across_jumps() {
  if (request_.one_unknown() || !candidate_.aim_point.captures()) return false;
  const Row row = along_lead();
  const auto peaks = peaks_of(row);
  return std::any_of(peaks.begin(), peaks.end(),
                     [&](std::size_t i) { return across_jump(before(row, i), row[i], after(row, i)); });
}

/// From the candidate outwards, so that each speed is near its neighbour's.
Widest::Row Widest::along_lead() const {
  Row row;
  row[middle] = attempt(candidate_.launch.angle, candidate_.launch.speed);
  for (std::size_t i = middle + 1; i < aims_across; ++i) row[i] = attempt(aim_at(i), row[i - 1].speed);
  for (std::size_t i = middle; i-- > 0;) row[i] = attempt(aim_at(i), row[i + 1].speed);
  return row;
}

/// Where the clearance is larger than at the neighbours, largest first.
std::vector<std::size_t> Widest::peaks_of(const Row& row) {
  std::vector<std::size_t> peaks;
  for (std::size_t i = 0; i < aims_across; ++i)
    if (row[i].value > blocked && (i == 0 || row[i].value >= row[i - 1].value) &&
        (i + 1 == aims_across || row[i].value > row[i + 1].value))
      peaks.push_back(i);
  std::sort(peaks.begin(), peaks.end(), [&](auto a, auto b) { return row[a].value > row[b].value; });
  return peaks;
}

Widest::Tried Widest::attempt(double aim, double guess) const {
  const auto speed = budget_.spent() ? std::nullopt : speed_near(aim_, budget_, aim, guess);
  return speed ? at_speed(aim, *speed) : Tried{aim, guess};
}

Widest::Tried Widest::at_speed(double aim, double speed) const {
  if (budget_.spent()) return {aim, speed};
  return {aim, speed, clearance(aim_, budget_, {speed, aim}).value_or(blocked)};
}

bool Widest::shot(const Tried& t) const {
  const double least = -10 * request_.problem->boundary.touch;  // a path through a corner has no room at all
  if (!(t.value > least) || budget_.spent()) return false;
  const Launch launch{t.speed, wrap_angle(t.x)};
  const int bounces = bounces_of(aim_.route);
  if (!aim_.aim_point.captures()) {  // from some part of a point it is not far to the point itself
    const auto root = solve_locked(aim_, budget_, launch);
    if (root && certify(request_, budget_, found_, *root, bounces, word::parts)) return true;
  }
  return certify(request_, budget_, found_, launch, bounces, word::parts, Demand::off_centre);
}

bool Widest::across_jump(const Tried& low, const Tried& best, const Tried& high) const {
  const auto [slow, fast] = std::minmax({low.speed, best.speed, high.speed});
  if (!(fast > jump * slow)) return false;
  const Range aims{low.x - (high.x - low.x) / 2, high.x + (high.x - low.x) / 2};
  std::optional<Roomy> last;
  for (int i = 0; i <= rows && !budget_.spent(); ++i) {
    const double speed =
        slow / settings::widest::beyond *
        std::pow(fast / slow * settings::widest::beyond * settings::widest::beyond, static_cast<double>(i) / rows);
    const auto now = roomy(aims, speed);
    if (now && along(*now)) return true;
    if (now && last && (now->excess > 0) != (last->excess > 0) && between(aims, *last, *now)) return true;
    last = now;
  }
  return false;
}

std::optional<Widest::Roomy> Widest::roomy(const Range& aims, double speed) const {
  Row row;
  for (std::size_t i = 0; i < aims_across; ++i)
    row[i] = at_speed(aims.low + (aims.high - aims.low) * static_cast<double>(i) / (aims_across - 1), speed);
  for (const std::size_t i : peaks_of(row)) {
    const Tried best = highest(row, i, [&](double aim, double) { return at_speed(aim, speed); });
    if (best.value > 0) return Roomy{best, excess(best.x, speed), edge(best, aims.low), edge(best, aims.high)};
  }
  return {};
}

double Widest::excess(double aim, double speed) const {
  const auto l = linearise(aim_, budget_, {speed, aim});
  return l ? l->r[1] : 0;
}

/// The end of the room towards `limit`.
double Widest::edge(const Tried& inside, double limit) const {
  double in = inside.x, out = limit;
  bisect(
      in, out, [&](double a, double b) { return std::abs(b - a) > settings::narrowest && !budget_.spent(); },
      [&](double aim) { return at_speed(aim, inside.speed).value > 0; });
  return in;
}

/// A shot at this speed, where on the way to an edge the ball gets as slow or as fast as asked.
bool Widest::along(const Roomy& r) const {
  const auto like = [&](double aim) { return (excess(aim, r.at.speed) > 0) == (r.excess > 0); };
  for (const double end : {r.low, r.high}) {
    if (like(end)) continue;
    double a = r.at.x, b = end;
    bisect(
        a, b, [&](double, double) { return !budget_.spent(); }, like);
    if (shot({a, r.at.speed, 0})) return true;
  }
  return false;
}

bool Widest::between(const Range& aims, const Roomy& a, const Roomy& b) const {
  double like_a = a.at.speed, like_b = b.at.speed;
  bool made = false, lost = false;
  const auto wide = [&](double, double) {
    const auto [slow, fast] = std::minmax(like_a, like_b);
    return !made && !lost && fast / slow - 1 > settings::narrowest && !budget_.spent();
  };
  const auto holds = [&](double speed) {
    const auto now = roomy(aims, speed);
    lost = !now;
    made = now && along(*now);
    return now && (now->excess > 0) == (a.excess > 0);
  };
  bisect(like_a, like_b, wide, holds, geometric_mean);
  return made;
}

}  // namespace bankshot::planning::steps
