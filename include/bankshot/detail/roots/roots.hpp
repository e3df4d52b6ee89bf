// SPDX-License-Identifier: MIT
//
// First times at which an arc meets a line or enters a circle. Every root is a *descent*: the gap falls through zero. A
// ball that leaves is therefore never caught, and one inside a circle must first come out. Branches are
// cancellation-free; a gap of exactly 0 gives exactly 0.
// Error: a few units in the last place of t, times the root's conditioning |∂t/∂gap|·|gap|/t.
// Limitation: a double root (the arc just touches) is found or missed by rounding.
#pragma once

#include <cmath>

#include "bankshot/detail/roots/polynomial.hpp"
#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::detail {

/// Returns the first t >= 0 at which gap + speed t + acceleration t²/2 falls through 0; `forever` if never. It is
/// inlined because every search for a cushion uses it, and calls would cost a tenth of a shot.
template <class T>
[[gnu::always_inline]] inline T first_descent(const T& gap, const T& speed, const T& acceleration) {
  using std::sqrt;
  if (acceleration == T(0)) return speed < T(0) && !(gap < T(0)) ? T(gap / -speed) : T(forever);
  const T discriminant = speed * speed - T(2) * acceleration * gap;
  if (speed < T(0)) {
    if (gap < T(0) || discriminant < T(0)) return T(forever);
    return T(2) * gap / (sqrt(discriminant) - speed);
  }
  if (acceleration < T(0) && discriminant > T(0)) return (speed + sqrt(discriminant)) / -acceleration;
  return gap == T(0) && speed == T(0) && acceleration < T(0) ? T(0) : T(forever);
}

/// Returns the time after which a ball on a *straight* arc has moved by `length` metres. The acceleration is taken
/// along the velocity, because its norm has no derivative where it is 0.
template <class T>
T time_at_length(const Arc<T>& arc, const T& length) {
  const T speed = norm(arc.velocity);
  return first_descent(length, T(-speed), T(-dot(arc.velocity, arc.acceleration) / speed));
}

/// Returns the first time at which a *straight* arc (acceleration along the velocity) enters the circle.
template <class T>
T first_entry_straight(const Arc<T>& arc, const Vec2d& centre, double radius) {
  using std::sqrt;
  const Vec2<T> d = to<T>(centre) - arc.at;
  const T closing = dot(d, arc.velocity);
  if (!(closing > T(0))) return T(forever);  // at or past the closest approach
  const T speed2 = dot(arc.velocity, arc.velocity);
  const T moment = cross(arc.velocity, d);
  const T chord2 = T(T(radius) * radius) * speed2 - moment * moment;
  if (!(chord2 > T(0))) return T(forever);
  const T outside = dot(d, d) - T(T(radius) * radius);
  if (!(outside >= T(0))) return T(forever);  // inside: must come out first
  // The nearer intersection, as a length: (|d|² − r²) / (d·û + √(r² − lateral²)).
  const T length = outside * sqrt(speed2) / (closing + sqrt(chord2));
  return time_at_length(arc, length);
}

/// Returns the time within `duration` at which a *straight* arc is closest to `point`.
template <class T>
T closest_time_straight(const Arc<T>& arc, const T& duration, const Vec2d& point) {
  const T speed = norm(arc.velocity);
  if (!(speed > T(0))) return T(0);
  const T ahead = dot(arc.velocity, to<T>(point) - arc.at) / speed;
  if (!(ahead > T(0))) return T(0);
  const T t = time_at_length(arc, ahead);
  return t < duration ? t : duration;
}

/// Returns the time `t` at which an arc meets the line of a wall, with the derivatives of the arc. They come from one
/// step of Newton's method, which does not move the value (implicit function theorem). `on`: the arc starts exactly on
/// the line. Without a crossing (a double root) there is no derivative, and none is given.
template <class T>
T lift_line(const Arc<T>& arc, const Vec2d& normal, double offset, bool on, const Real<T>& t) {
  if constexpr (!has_derivatives<T>) {
    return t;
  } else {
    const T speed = dot(normal, arc.velocity), a = dot(normal, arc.acceleration);
    const T moved = (speed + a * Real<T>(t * 0.5)) * t;
    const T f = on ? moved : T(dot(normal, arc.at) - Real<T>(offset) + moved);
    const Real<T> slope = value(speed) + value(a) * t;
    return slope == 0 ? T(t) : T(T(t) - (f - value(f)) / slope);
  }
}

/// Returns the time `t` at which an arc meets the rim of a circle, with derivatives likewise.
template <class T>
T lift_circle(const Arc<T>& arc, const Vec2d& centre, const Real<T>& t) {
  if constexpr (!has_derivatives<T>) {
    return t;
  } else {
    const Vec2<T> d = arc.position(t) - to<T>(centre);
    const T f = dot(d, d) * 0.5;
    const Real<T> slope = dot(value(d), value(arc).tangent(t));
    return slope == 0 ? T(t) : T(T(t) - (f - value(f)) / slope);
  }
}

/// Returns the time `t` of the closest approach to a point, with derivatives likewise. There the arc runs across the
/// line to the point.
template <class T>
T lift_closest(const Arc<T>& arc, const Vec2d& point, const Real<T>& t) {
  if constexpr (!has_derivatives<T>) {
    return t;
  } else {
    const Vec2<T> d = arc.position(t) - to<T>(point), v = arc.tangent(t);
    const T f = dot(d, v);
    const Real<T> slope = dot(value(v), value(v)) + dot(value(d), value(arc.acceleration));
    return slope == 0 ? T(t) : T(T(t) - (f - value(f)) / slope);
  }
}

/// Improves an entry by a step of Newton's method on the distance itself. The quartic's coefficients are squares of the
/// whole distance to the circle, so the error of its roots grows by that over the radius. If the arc hardly enters, a
/// step may lead astray and is not taken.
template <class T>
T polished_entry(const Arc<T>& arc, const Vec2d& centre, double radius, const T& t, const T& limit) {
  const Vec2<T> d = arc.position(t) - to<T>(centre), v = arc.tangent(t);
  const T slope = dot(d, v);
  if (!(slope < T(0))) return t;
  const T off = dot(d, d) - T(T(radius) * radius), better = t - off / (T(2) * slope);
  if (!(better > T(0) && better <= limit)) return t;
  using std::abs;
  const T step = better - t, left = step * step * (dot(v, v) + dot(d, arc.acceleration));
  return abs(left) <= abs(off) ? better : t;
}

/// Returns true if a speed to or from a place is only the rounding of the velocity. `product` is the scalar product of
/// v and the vector to the place.
template <class T>
bool is_rounding(const T& product, const T& distance2, const Vec2<T>& v) {
  const T noise(tolerance::along * tolerance::along);
  return product * product <= noise * distance2 * dot(v, v);
}

/// Returns the first time within `limit` at which an arc enters the circle. `left`: the arc starts on the circle and
/// has just left it. Then the gap there is exactly 0, and a speed that is rounding does not lead back in.
template <class T>
T first_entry(const Arc<T>& arc, const Vec2d& centre, double radius, const T& limit, bool left = false) {
  if (!arc.bends) return left ? T(forever) : first_entry_straight(arc, centre, radius);
  const Vec2<T> d = arc.at - to<T>(centre), v = arc.velocity, a = arc.acceleration;
  const T until = limit < arc.duration ? limit : arc.duration;
  // A circle farther away than the ball can get by then needs no quartic.
  const T reach = T(radius) + (norm(v) + norm(a) * (until / T(2))) * until;
  const T distance2 = dot(d, d);
  if (distance2 > reach * reach) return T(forever);
  const T gap = left ? T(0) : T(distance2 - T(T(radius) * radius));
  T leaving = dot(d, v);
  if (left && is_rounding(leaving, distance2, v)) leaving = T(0);
  const Polynomial<T, 4> outside{gap, T(2) * leaving, dot(v, v) + dot(d, a), dot(v, a), dot(a, a) / T(4)};
  const T t = first_descent_of(outside, until);
  return t < T(forever) ? polished_entry(arc, centre, radius, t, until) : t;
}

/// Returns the first time within `limit` at which an arc meets a standing ball, which it may touch from the start. A
/// ball that touches and comes nearer meets it now; otherwise they must part first. `touch` is the gap that counts as
/// touching [m].
template <class T>
T first_touch(const Arc<T>& arc, const Vec2d& centre, double radius, double touch, const T& limit) {
  const Vec2<T> d = to<T>(centre) - arc.at;
  const T near(radius + touch), distance2 = dot(d, d);
  if (distance2 > near * near) return first_entry(arc, centre, radius, limit);
  const T closing = dot(d, arc.velocity);
  if (closing > T(0) && !is_rounding(closing, distance2, arc.velocity)) return T(0);
  return first_entry(arc, centre, radius, limit, true);
}

/// Region that holds an arc up to `limit`: the triangle of its control points, and the box around that.
template <class T>
struct Reach {
  Vec2<T> start, bend, end, low, high;
  T slack;
  bool bounded;  ///< false if the arc has no end; then it misses nothing

  /// `close`: what comes this close is not missed [m].
  Reach(const Arc<T>& arc, const T& limit, const T& close)
      : start(arc.at),
        bend(arc.at + arc.velocity * T(limit * 0.5)),
        end(arc.position(limit)),
        slack(close),
        bounded(limit < T(forever)) {
    using std::max, std::min;
    low = {min(start.x, T(min(bend.x, end.x))), min(start.y, T(min(bend.y, end.y)))};
    high = {max(start.x, T(max(bend.x, end.x))), max(start.y, T(max(bend.y, end.y)))};
  }

  /// Returns true if no point of the region is inside the circle.
  bool misses(const Vec2d& centre, double radius) const {
    if (!bounded) return false;
    const T near = slack + radius;
    const bool beside = low.x > centre.x + near || high.x < centre.x - near;
    if (beside || low.y > centre.y + near || high.y < centre.y - near) return true;
    // The triangle lies between the chord's line and its parallel through `bend`; the centre is outside, farther than
    // `near`.
    const Vec2<T> chord = end - start, to_start = start - to<T>(centre), to_bend = bend - to<T>(centre);
    const T a = cross(chord, to_start), b = cross(chord, to_bend), least2 = dot(chord, chord) * T(near * near);
    return a * b > T(0) && a * a > least2 && b * b > least2;
  }
};

/// Returns the time within `duration` at which an arc is closest to `point`.
template <class T>
T closest_time(const Arc<T>& arc, const T& duration, const Vec2d& point) {
  if (!arc.bends) return closest_time_straight(arc, duration, point);
  const Vec2<T> d = arc.at - to<T>(point), v = arc.velocity, a = arc.acceleration;
  // Half the derivative of the squared distance.
  const Polynomial<T, 3> slope{dot(d, v), dot(v, v) + dot(d, a), T(1.5) * dot(v, a), dot(a, a) / T(2)};
  T best = T(0), least = dot(d, d);
  const auto consider = [&](const T& t) {
    const Vec2<T> off = arc.position(t) - to<T>(point);
    const T square = dot(off, off);
    if (square < least) least = square, best = t;
  };
  consider(duration);
  for (const T& t : roots_between(slope, T(0), duration)) consider(t);
  return best;
}

}  // namespace bankshot::detail
