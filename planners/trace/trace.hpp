// SPDX-License-Identifier: MIT
//
// `trace` follows a path that is told its branch: the locked path along the branch's meetings, and then the last leg.
// It stays smooth where the real path jumps from one branch to another. An observer may look at each arc: clearances do
// so, and the residuals need nothing.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/locked.hpp"
#include "planners/evaluation_budget.hpp"

namespace bankshot::planning {

/// The end of the last leg: the ball comes to rest, enters the circle around the point, or passes it.
struct Destination {
  const Body& body;  ///< the ball that gets there
  Vec2d at;
  double capture;  ///< m, the radius of the circle; 0: there is none
  bool stop;       ///< the ball must come to rest
};

/// An observer of a traced path that looks at nothing. Legs are counted from 0; the last one ends at the destination.
struct Unobserved {
  /// Sees an arc of a leg, and the parameter up to which it was followed.
  template <class T>
  void arc(std::size_t, const Arc<T>&, const T&) const {}
  /// Sees the state right after the meeting that ends a leg.
  template <class T>
  void met(std::size_t, const State<T>&) const {}
};

/// Fate of a leg that does not lead to its meeting. Rounding may make a leg of a real path look like one.
enum class LostLeg { ends_trace, is_passed_over };

template <class T>
struct TracedArrival : LockedArrival<T> {
  bool complete = true;  ///< no leg was passed over
};

/// Follows these meetings from `start`, and on to the destination. Returns the arrival, with the time since the launch;
/// none if a lost leg ends the trace, or the last leg has no direction.
template <class T, class C, class Motion, class Cushion, class Observer = Unobserved>
std::optional<TracedArrival<T>> trace(const RouteBallsOf<C>& balls, const Motion& motion, const Cushion& cushion,
                                      std::span<const Meeting> meetings, const State<T>& start, const Destination& to,
                                      Work& work, Observer&& observer = {}, LostLeg lost = LostLeg::ends_trace) {
  struct Legs {
    Observer& observer;
    std::size_t leg = 0;
    void operator()(const Arc<T>& arc, const T& t) { observer.arc(leg, arc, t); }
    void met(const State<T>& after) { observer.met(leg++, after); }
  } legs{observer};
  State<T> state = start;
  T time(0);
  bool complete = true;
  do {
    const auto path = follow_locked(balls, motion, cushion, meetings.subspan(legs.leg), state, legs);
    work += path.work;
    state = path.state;
    time += path.time;
    if (path.end == LockedEnd::complete) break;
    if (lost == LostLeg::ends_trace) return {};
    complete = false;
    legs.met(state);
  } while (legs.leg < meetings.size());
  if (lost == LostLeg::ends_trace && !(dot(state.velocity, state.velocity) > T(0))) return {};
  const auto watch = [&](const Arc<T>& arc, const T& t) { observer.arc(meetings.size(), arc, t); };
  TracedArrival<T> arrival{arrive_locked(motion, to.body, state, to.at, to.capture, to.stop, watch), complete};
  work += arrival.work;
  if (!(dot(arrival.heading, arrival.heading) > T(0))) return {};
  arrival.time = time + arrival.time;
  return arrival;
}

}  // namespace bankshot::planning
