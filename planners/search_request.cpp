// SPDX-License-Identifier: MIT
#include "planners/search_request.hpp"

#include <algorithm>

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

/// Returns the spin of a range that is nearest to none.
LaunchSpin least_of(const SpinRange& r) {
  const auto least = [](const Range& v) { return std::clamp(0.0, v.low, v.high); };
  return {least(r.top), least(r.side), least(r.masse)};
}

}  // namespace

SearchRequest::SearchRequest(const Puzzle& of, Wanted w)
    : problem(std::make_shared<const Problem>(of)),
      wanted(w),
      speed(puzzle().speed),
      angle(puzzle().angle),
      spin(puzzle().spin_range ? least_of(*puzzle().spin_range) : puzzle().spin),
      arrival(arrival_range(puzzle())),
      stop(!problem->captures() && arrival && arrival->high == 0),
      cue_cushions(puzzle().cushions) {
  if (arrival) asked = puzzle().prefer == Prefer::soft ? arrival->low : arrival->high;
  if (cue_cushions.sequence) route = route_by(*cue_cushions.sequence);
  if (const Then* const last = problem->then()) object_cushions = last->cushions_of(last->links.size());
}

SearchRequest SearchRequest::stage(int cue, int object) const {
  SearchRequest request = *this;
  if (!request.cue_cushions.sequence) request.cue_cushions = CushionRule::exactly(cue);
  if (!request.object_cushions.sequence) request.object_cushions = CushionRule::exactly(object);
  return request;
}

SearchRequest SearchRequest::asking(double arrival_speed) const {
  SearchRequest request = *this;
  request.asked = arrival_speed;
  return request;
}

SearchRequest SearchRequest::launched_at(double launch_speed) const {
  SearchRequest request = *this;
  request.pinned = launch_speed;
  return request;
}

SearchRequest SearchRequest::starts_at(double arrival_speed, const LaunchSpin& launch_spin) const {
  SearchRequest request = *this;
  request.asked = arrival_speed;
  request.spin = launch_spin;
  request.angle.reset();
  if (!speed.fixed()) request.speed.high = std::max(speed.high, settings::fastest_start);
  request.wanted = Wanted::starts;
  return request;
}

std::vector<SearchRequest> SearchRequest::samples() const {
  std::vector<double> arrivals{asked};
  if (arrival && !arrival->fixed()) {
    arrivals.push_back((arrival->low + arrival->high) / 2);
    arrivals.push_back(arrival->low + arrival->high - asked);
  }
  // Corners first: a ball without side spin has no derivative by it, since its spin is gone at once.
  std::vector<LaunchSpin> spins;
  const auto add = [&](const LaunchSpin& one) {
    if (std::ranges::find(spins, one) == spins.end()) spins.push_back(one);
  };
  if (const auto& r = puzzle().spin_range)
    for (const double top : {r->top.high, r->top.low})
      for (const double side : {r->side.low, r->side.high})
        for (const double masse : {r->masse.low, r->masse.high}) add({top, side, masse});
  add(spin);
  std::vector<SearchRequest> out;
  for (const double one_arrival : arrivals)
    for (const LaunchSpin& one : spins) out.push_back(starts_at(one_arrival, one));
  return out;
}

SearchRequest SearchRequest::spinning(const LaunchSpin& launch_spin) const {
  SearchRequest request = *this;
  request.spin = launch_spin;
  return request;
}

double SearchRequest::fixed_speed() const {
  if (pinned) return *pinned;
  return is_ideal(problem->puzzle.physics) ? ideal_speed(problem->puzzle) : speed.low;
}

SearchRequest SearchRequest::better_than(const Shot& shot) const {
  SearchRequest request = *this;
  if (puzzle().prefer == Prefer::soft)
    request.speed.high = std::max(speed.low, std::min(speed.high, shot.launch.speed));
  if (puzzle().prefer == Prefer::quick) request.latest = shot.path.arrival.time;
  if (puzzle().prefer == Prefer::robust) request.likelier = shot.robustness.success_estimate;
  return request;
}

}  // namespace bankshot::planning
