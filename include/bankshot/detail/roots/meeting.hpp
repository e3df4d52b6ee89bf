// SPDX-License-Identifier: MIT
//
// The meeting of two balls that are both moving: the first time at which the distance of their centres falls through
// their touching distance (scene/body.hpp). Their arcs share a clock, but began at different times.
// Method: the distance bends down no faster than the two accelerations differ. A gap and a speed of approach therefore
// give a time before which the balls cannot meet. Such steps rule out most pairs at once, and close in on the root from
// before, as Newton's method does. If a few steps do not decide (a graze), the time is a root of a quartic. It is
// isolated between the roots of the derivatives, and polished on the distance itself. A clock that is no polynomial
// (drag) uses steps alone.
// Error: a few roundings of the gap, over the speed of approach. Limitation: a graze is found or missed by rounding.
#pragma once

#include <optional>

#include "bankshot/detail/roots/roots.hpp"

namespace bankshot::detail {

/// Returns a bound on how fast the velocity on an arc changes [m/s²].
template <class N>
N most_bend(const Arc<N>& arc) {
  const N bend = norm(arc.acceleration);
  return arc.drag.none() ? bend : N(bend + arc.drag.constant + arc.drag.linear * norm(arc.velocity));
}

/// Motion of the second ball as seen from the first: its place and velocity at times from now on.
template <class N>
struct Apart {
  Vec2<N> at, velocity, acceleration;
  N bend;  ///< m/s²: the second derivative of the distance is no less than −bend

  /// `a_began` and `b_began` are the ages of the arcs [s].
  Apart(const Arc<N>& a, const N& a_began, const Arc<N>& b, const N& b_began) {
    if (!a.drag.none() || !b.drag.none()) {
      clocks_.emplace(Clocks{a, b, a_began, b_began});
      bend = most_bend(a) + most_bend(b);
      at = place(N(0)), velocity = speed(N(0));
    } else {
      at = b.position(b_began) - a.position(a_began);
      velocity = b.tangent(b_began) - a.tangent(a_began);
      acceleration = b.acceleration - a.acceleration;
      bend = norm(acceleration);
    }
  }

  /// Returns true if a clock is no polynomial.
  bool clocked() const { return clocks_.has_value(); }
  Vec2<N> place(const N& t) const {
    if (!clocked()) return at + (velocity + acceleration * N(t * 0.5)) * t;
    return on(clocks_->second, N(clocks_->second_began + t)) - on(clocks_->first, N(clocks_->first_began + t));
  }
  Vec2<N> speed(const N& t) const {
    if (!clocked()) return velocity + acceleration * t;
    const auto of = [&](const Arc<N>& arc, const N& began) { return arc.velocity_at(arc.parameter(N(began + t))); };
    return of(clocks_->second, clocks_->second_began) - of(clocks_->first, clocks_->first_began);
  }

 private:
  struct Clocks {
    Arc<N> first, second;
    N first_began, second_began;
  };
  std::optional<Clocks> clocks_{};

  static Vec2<N> on(const Arc<N>& arc, const N& t) { return arc.position(arc.parameter(t)); }
};

/// Largest gap that counts as touching [m], and largest speed that counts as not approaching [m/s].
template <class N>
struct Rounding {
  N touch, still;
};

/// Returns true if two balls cannot meet within `limit`, for one of two reasons. Either they do not come near enough,
///   distance > reach + closing · limit + bend · limit² / 2,
/// tested after multiplication by the distance and squaring, without root or division. The first step of first_meeting
/// would find the same. Or their straight lines pass each other too far apart for what bends them. `at` and `velocity`
/// are those of the second as seen from the first.
template <class N>
bool cannot_meet(const Vec2<N>& at, const Vec2<N>& velocity, const N& bend, const N& reach, const N& limit,
                 const Rounding<N>& rounding) {
  constexpr double sure = 1 + 1e-9;  // far above the rounding of this and of first_meeting, so that they never disagree
  const N near = (reach + 2 * rounding.touch + bend * limit * limit / 2) * N(sure);
  const N near2 = near * near, off = cross(at, velocity);
  if (off * off > near2 * dot(velocity, velocity)) return true;
  const N square = dot(at, at), nearing = -dot(at, velocity);
  const N rest = nearing > N(0) ? N(square - nearing * limit) : square;
  return rest > N(0) && rest * rest > near2 * square;
}

/// Returns the seconds until the distance falls through `reach`, or `forever` if not within `limit`. Two that touch and
/// approach meet now. Two that touch and do not approach must part first.
template <class N>
N first_meeting(const Apart<N>& pair, N reach, const N& limit, const Rounding<N>& rounding) {
  using std::sqrt;
  constexpr int most_steps = 8;
  N t(0);
  Vec2<N> d = pair.at, v = pair.velocity;
  N far = norm(d), closing = -dot(d, v) / far, gap = far - reach;
  bool touching = gap < rounding.touch;
  if (touching) {
    if (closing > rounding.still) return N(0);
    if (!(gap > N(0))) reach = far, gap = N(0);
    if (closing > -rounding.still) closing = N(0);
  }
  const auto look = [&] {
    d = pair.place(t), v = pair.speed(t);
    far = norm(d), closing = -dot(d, v) / far, gap = far - reach;
    touching = false;
  };
  for (int i = 0; pair.clocked() || i < most_steps; ++i) {
    // The first root of gap − closing h − bend h²/2.
    const N root = sqrt(N(closing * closing + 2 * pair.bend * gap));
    N step = closing > N(0)     ? N(2 * gap / (closing + root))
             : pair.bend > N(0) ? N((root - closing) / pair.bend)
                                : N(forever);
    if (!(t + step < limit)) return N(forever);
    if (!(t + step > t)) {
      if (!touching) return closing > N(0) ? t : N(forever);
      if (!pair.clocked()) break;
      step = limit / N(1024);  // they stay still beside each other
    }
    t += step;
    look();
    if (!(gap > N(0))) {
      if (closing > rounding.still) return t;
      reach = far, gap = N(0), touching = true;
      if (closing > N(0)) closing = N(0);
    }
  }
  // Times count from t now, where the gap is nearly exact.
  const N rest = limit - t;
  const N f0 = gap * (far + reach), f1 = -2 * closing * far;
  const Vec2<N>& a = pair.acceleration;
  const N f2 = dot(v, v) + dot(d, a);
  if (touching && closing == N(0) && f2 < N(0))
    return t;  // they have parted by no more than rounding, and are driven back
  const N found = first_descent_of(Polynomial<N, 4>{f0, f1, f2, dot(v, a), N(dot(a, a) / 4)}, rest);
  if (!(found < rest)) return N(forever);
  t += found;
  look();
  // One Newton step on the distance itself, whose rounding is that of the gap and not of the whole distance.
  using std::abs;
  const N rough = t, off = abs(gap);
  if (!(closing > N(0)) || off > rounding.touch) return t;
  t += gap / closing;
  look();
  return t > rough - found && t < limit && abs(gap) < off ? t : rough;
}

}  // namespace bankshot::detail
