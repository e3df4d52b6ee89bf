// SPDX-License-Identifier: MIT
#include "planners/solve/widest.hpp"

#include <algorithm>
#include <cmath>

#include "planners/solve/line_search.hpp"
#include "planners/solve/speed.hpp"
#include "planners/trace/clearance.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning {

using namespace settings::widest;

Widest::Widest(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Candidate& candidate)
    : request_(request),
      budget_(budget),
      found_(found),
      candidate_(candidate),
      aim_{request, candidate.route, candidate.aim_point} {
  if (!(candidate.half > 0)) candidate.half = half_window();
}

/// Returns how far the aim may turn from a root [rad] until the ball passes all of the target. The speed is adapted to
/// arrive as asked.
double Widest::half_window() const {
  const auto l = linearise(aim_, budget_, candidate_.launch);
  if (!l) return 0;
  double lateral = l->by_aim(0);  // of the diagonal, per radian
  if (!request_.one_unknown())
    lateral = l->determinant(false) / (request_.stop ? std::hypot(l->by_speed(0), l->by_speed(1)) : l->by_speed(1));
  const double half = candidate_.aim_point.reach / (std::abs(lateral) * request_.problem->boundary.diagonal);
  return half < widest_half ? half : widest_half;
}

/// Closes in on a peak of clearances by golden sections, until little can be gained. `Attempt`: (aim, guess of the
/// speed) -> Tried.
template <class Attempt>
Widest::Tried Widest::highest(const Row& row, std::size_t peak, const Attempt& attempt) {
  const auto settled = [](const Tried& low, const Tried& best, const Tried& high) {
    return best.value - std::min(low.value, high.value) < little_gain * std::abs(best.value);
  };
  return climb(
      before(row, peak), row[peak], after(row, peak), settings::rounding,
      [&](double aim, const Tried& best) { return attempt(aim, best.speed); }, settled);
}

void Widest::find() {
  if (!(candidate_.half > 0)) return;
  const Row row = along_lead();
  for (const std::size_t i : peaks_of(row)) {
    const Tried best = highest(row, i, [&](double aim, double guess) { return attempt(aim, guess); });
    candidate_.room = std::max(candidate_.room, best.value);
    if (shot(best)) return;
  }
}

/// Tries the aims from the candidate outwards, so that each speed is near its neighbour's.
Widest::Row Widest::along_lead() const {
  Row row;
  row[middle] = attempt(candidate_.launch.angle, candidate_.launch.speed);
  for (std::size_t i = middle + 1; i < aims_across; ++i) row[i] = attempt(aim_at(i), row[i - 1].speed);
  for (std::size_t i = middle; i-- > 0;) row[i] = attempt(aim_at(i), row[i + 1].speed);
  return row;
}

/// Returns the indices at which the clearance is larger than at the neighbours, largest first.
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
  const double least = -10 * request_.problem->boundary.touch;  // a path through a corner has no clearance at all
  if (!(t.value > least) || budget_.spent()) return false;
  const Launch launch{t.speed, wrap_angle(t.x)};
  const int bounces = bounces_of(aim_.route);
  return certify(request_, budget_, found_, launch, bounces, word::partition, Demand::off_centre);
}

}  // namespace bankshot::planning
