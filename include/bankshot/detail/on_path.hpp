// SPDX-License-Identifier: MIT
//
// Moves an event that was found on a chord of a path onto the path itself. Newton's method finds the time at which the
// gap is 0.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot::detail {

/// Returns the time of a graze: the path may only come close to the thing that its chord meets. It is the time at which
/// the gap falls through 0 or, if only the chord meets the thing, the time at which the gap is least. Returns the
/// chord's time unless there is a gap that closes at the start of the piece and opens at its end.
template <class N, class On, class Gap>
N graze_on_path(const N& chord, const N& first, const N& last, On&& state, Gap&& gap) {
  constexpr int enough = std::numeric_limits<N>::digits;
  const auto [gap_first, closes_first] = gap(state(first));
  if (!(gap_first > N(0)) || !(closes_first > N(0)) || gap(state(last)).second > N(0)) return chord;
  N low = first, high = last;
  const auto halve = [&](auto&& is_before) {
    for (int i = 0; i < enough; ++i) {
      const N middle = (low + high) * N(0.5);
      (is_before(gap(state(middle))) ? low : high) = middle;
    }
  };
  halve([](const std::pair<N, N>& there) { return there.second > N(0); });
  if (!(gap(state(high)).first < N(0))) return high;
  low = first;
  halve([](const std::pair<N, N>& there) { return there.first > N(0); });
  return high;
}

/// Returns the time at which the gap on the path is 0. `state(t)` is the state on the path; `gap(state)` is the gap
/// there and the speed at which it closes. `chord` is the time found on the chord. The piece of the path begins at
/// `first` and ends at `last`.
template <class N, class On, class Gap>
N time_on_path(const N& chord, const N& first, const N& last, On&& state, Gap&& gap) {
  using std::abs;
  constexpr int enough = 8;
  N t = chord;
  for (int i = 0; i < enough; ++i) {
    const auto [left, closes] = gap(state(t));
    if (!(closes > N(0))) return graze_on_path(chord, first, last, state, gap);
    const N step = left / closes;
    t += step;
    if (!(t >= first && t <= last)) return graze_on_path(chord, first, last, state, gap);
    if (!(abs(step) > 2 * std::numeric_limits<N>::epsilon() * abs(t))) break;
  }
  return t;
}

/// Returns when the path meets a contact that its chord meets at t. `on`: the path begins exactly on the contact's
/// line. `before`: a path that follows a given route may have met the contact before it began.
template <class T, class Motion>
Real<T> time_on_path(const Motion& motion, const Boundary& boundary, const State<T>& start, const Arc<T>& arc,
                     Contact contact, bool on, bool before, const Real<T>& t) {
  using N = Real<T>;
  if (!arc.chord || t == N(0)) return t;
  const N first = before ? N(-value(arc.duration)) : N(0), last = value(arc.duration);
  const auto state = [&](const N& when) {
    if constexpr (Motion::plain)
      return advance(motion, boundary.body, value(start), value(arc), when);
    else
      return value(advance(motion, boundary.body, start, arc, T(when)));
  };
  if (const Wall* const w = boundary.line(contact)) {
    // A centre on the line, or within rounding beyond it, begins with a gap of 0.
    const N begins = dot(w->normal, value(start.at)) - N(w->offset);
    const N less = on || (begins < N(0) && begins > -N(boundary.touch)) ? begins : N(0);
    return time_on_path(t, first, last, state, [&](const State<N>& s) {
      return std::pair<N, N>(dot(w->normal, s.at) - N(w->offset) - less, -dot(w->normal, s.velocity));
    });
  }
  const Circle* const c = boundary.rim(contact);
  if (!c) return t;
  return time_on_path(t, first, last, state, [&](const State<N>& s) {
    const Vec2<N> d = s.at - to<N>(c->centre);
    const N size = norm(d);
    return std::pair<N, N>(size - N(c->radius), -dot(d, s.velocity) / size);
  });
}

/// Returns that time with the derivatives of the path.
template <class T, class Motion>
T lift_on_path(const Motion& motion, const Boundary& boundary, const State<T>& start, const Arc<T>& arc,
               Contact contact, bool on, bool before, const Real<T>& found) {
  using N = Real<T>;
  const N t = time_on_path(motion, boundary, start, arc, contact, on, before, found);
  if constexpr (!has_derivatives<T>) {
    return t;
  } else {
    const State<T> there = advance(motion, boundary.body, start, arc, T(t));
    if (const Wall* const w = boundary.line(contact)) {
      const T gap = dot(w->normal, there.at);
      const N closes = dot(w->normal, value(there.velocity));
      return closes == N(0) ? T(t) : T(T(t) - (gap - value(gap)) / closes);
    }
    const Circle* const c = boundary.rim(contact);
    if (!c) return T(t);
    const Vec2<T> d = there.at - to<T>(c->centre);
    const T half = dot(d, d) * 0.5;
    const N closes = dot(value(d), value(there.velocity));
    return closes == N(0) ? T(t) : T(T(t) - (half - value(half)) / closes);
  }
}

}  // namespace bankshot::detail
