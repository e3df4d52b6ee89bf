// SPDX-License-Identifier: MIT
//
// Contact forces between balls in persistent contact: they touch, do not approach, and friction drives them together.
// They push on each other as long as that lasts. Forces act along the lines of centres, and cushions push on balls that
// are pressed against them. All are the least that leave no acceleration into a contact, apart from the centripetal
// acceleration of one ball that goes round the other:
//   f_c >= 0, w_c >= 0, f_c w_c = 0 where w_c = n_c·(a_b − a_a) + v²/D, a_i = its own + Σ ± f_c n_c / M_i
// M is the mass of a ball that slides, and 7/5 of it for a ball that rolls or rests, since that has to be turned as
// well. v is the speed of one ball across the line of centres, as seen from the other. D is the distance of the
// centres.
//
// Method: projected Gauss–Seidel. Contact by contact, in the order given, the remaining acceleration is removed, until
// nothing changes. A single contact is exact at once. With two, the changes shrink by the same share from sweep to
// sweep and are taken to their limit (Aitken's Δ², with all contacts as one vector). With more contacts, that saves
// sweeps. Remaining speeds along the lines of centres, up to tolerance::held_contact, are removed in the same way,
// because one contact at a time would take hundreds of events. A ball that rolls goes on rolling, and one that rests
// goes on resting. Balls that press on each other move with constant acceleration for one piece: 2 ms, or up to 20 ms
// if hardly anything turns.
//
// No overlap: with v₁ in place of v above, the squared distance after t seconds is at least
//   D² + (v² − v₁²) t² + a v t³, where a is the acceleration across the line of centres.
// That is no less than D² up to t = h if v₁ <= v − h max(0, −a). Two balls in contact come v (v − v₁) h²/D apart.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::detail {

/// Returns the acceleration where the arc begins, including that of a drag.
template <class T>
Vec2<T> first_acceleration(const Arc<T>& arc) {
  if (arc.drag.none()) return arc.acceleration;
  const T speed = norm(arc.velocity);
  return arc.velocity * T(-(arc.drag.constant + arc.drag.linear * speed) / speed);
}

template <class T>
bool slides(const Arc<T>& arc) {
  return arc.pressed != Press::rolls &&
         (arc.end == PhaseEnd::roll || arc.end == PhaseEnd::none || arc.end == PhaseEnd::piece);
}

/// Returns the effective mass that a push has to move [kg].
template <class T>
double inertia(const Arc<T>& arc, const Body& body) {
  return slides(arc) ? body.mass : body.mass * 7 / 5;
}

/// Returns how fast friction turns [rad/s] if other balls give the centre the acceleration `push`. Friction turns with
/// the slip, or with the direction of travel of a rolling ball.
template <class T>
Real<T> friction_turns(const Arc<T>& arc, const Vec2<T>& push) {
  using N = Real<T>;
  using std::abs;
  Vec2<N> more = value(push), way = value(arc.velocity);
  if (more == Vec2<N>{} || arc.end == PhaseEnd::none) return N(0);
  if (!slides(arc))
    more += value(first_acceleration(arc));
  else if (arc.end == PhaseEnd::roll)
    way = value(arc.acceleration) * N(value(arc.duration) * N(3.5));
  else
    return N(forever);  // a cushion holds it as well
  const N size2 = dot(way, way);
  return size2 > N(0) ? N(abs(cross(more, way)) / size2) : N(forever);
}

/// Adds to an arc the acceleration `push` that other balls give the centre. The arc becomes a piece of at most
/// `longest` seconds.
template <class T>
void press(Arc<T>& arc, const Vec2<T>& push, const Real<T>& longest) {
  using N = Real<T>;
  const auto shorten = [&](const T& seconds) {
    if (value(seconds) < value(arc.duration)) arc.duration = seconds;
  };
  if (slides(arc)) {
    const Vec2<T> friction = arc.acceleration + arc.taken;
    const T size2 = dot(friction, friction);
    const bool turns = arc.end == PhaseEnd::roll;
    arc.taken -= push;
    arc.pressed = Press::slides;
    if (turns) {
      // The slip fades at 7/2 of the friction, and the push changes it too. No slip is left along its first direction
      // after:
      const T fades = size2 * N(3.5) + dot(push, friction);
      arc.duration = value(fades) > N(0) ? T(arc.duration * (size2 * N(3.5)) / fades) : T(forever);
    }
    if (!turns || value(arc.duration) > N(tolerance::last_piece)) {
      if (turns) arc.duration = arc.duration * N(0.5);
      shorten(T(longest));
      arc.end = PhaseEnd::piece;
    }
  } else {
    arc.acceleration = first_acceleration(arc);
    arc.drag = {};
    arc.pressed = Press::rolls;
    arc.duration = T(longest);
    arc.end = PhaseEnd::piece;
    const T slows = -dot(arc.velocity, Vec2<T>(arc.acceleration + push));
    if (value(slows) > N(0)) shorten(T(dot(arc.velocity, arc.velocity) / slows));
  }
  arc.acceleration += push;
  arc.bends = true;
  arc.chord = false;
}

/// A contact of two balls, given by number, or of the first ball with a cushion.
template <class T>
struct Pressed {
  int first, second;   ///< `second` is `none` for a cushion
  Vec2<T> normal;      ///< unit, from the first to the second or to the cushion
  T turns{0};          ///< m/s², centripetal acceleration of one ball that goes round the other in contact
  T force{0};          ///< N, or an impulse [N s]
  T change{0};         ///< change of the force in the last sweep
  bool keeps = false;  ///< the force may also pull
  Real<T> first_lightness{0}, second_lightness{0};  ///< 1/kg; 0 for a cushion
  static constexpr int none = -1;
};

/// Returns the rate of the second as seen from the first.
template <class T>
Vec2<T> relative(const Pressed<T>& c, std::span<const Vec2<T>> rates) {
  const Vec2<T>& first = rates[static_cast<std::size_t>(c.first)];
  return c.second == Pressed<T>::none ? -first : rates[static_cast<std::size_t>(c.second)] - first;
}

/// Returns how fast the two part [m/s], or the acceleration that drives them apart [m/s²].
template <class T>
T parting_rate(const Pressed<T>& c, std::span<const Vec2<T>> rates) {
  return dot(c.normal, relative<T>(c, rates)) + c.turns;
}

/// Largest number of sweeps over all contacts, in case their forces do not settle earlier.
inline constexpr int most_sweeps = 100000;

/// Result of a search for forces.
template <class N>
struct Settled {
  bool settled = false;
  N rounding{0};  ///< N, rounding error of the force on a ball
};

/// Finds the forces at contacts, or the impulses if rates are velocities.
template <class T>
class Forces {
 public:
  using N = Real<T>;

  /// `rates` are the accelerations of the balls under the current forces of `contacts`, and change with these forces.
  /// `inertias` are in kg; a ball with an infinite one keeps its rate.
  Forces(std::span<Pressed<T>> contacts, std::span<Vec2<T>> rates, std::span<const double> inertias)
      : contacts_(contacts), rates_(rates) {
    const auto inverse = [&](int ball) {
      return ball == Pressed<T>::none ? N(0) : N(1) / N(inertias[static_cast<std::size_t>(ball)]);
    };
    using std::abs, std::sqrt;
    N largest(0);
    for (Pressed<T>& c : contacts) {
      c.first_lightness = inverse(c.first), c.second_lightness = inverse(c.second);
      c.change = T(0);
      largest = std::max<N>(largest, abs(value(c.force)));
      if (moves(c)) largest = std::max<N>(largest, abs(value(c.turns)) / lightness(c));
    }
    for (std::size_t i = 0; i < rates.size(); ++i)
      if (inertias[i] < forever)
        largest = std::max<N>(largest, N(inertias[i]) * N(sqrt(dot(value(rates[i]), value(rates[i])))));
    rounding_ = largest * (8 * std::numeric_limits<N>::epsilon());
  }

  /// Sweeps over the contacts until their forces settle, at most `sweeps` times. If they do not settle, the next piece
  /// finds forces anew.
  Settled<N> settle(int sweeps) {
    bool settled = false;
    for (int sweep = 1, leap_after = 3; sweep <= sweeps && !settled; ++sweep) {
      N shrinks(0), before(0);  // over all forces: Σ last change × change, and Σ last change²
      settled = true;
      for (Pressed<T>& c : contacts_) {
        if (!moves(c)) continue;
        const T wanted = c.force - parting_rate<T>(c, rates_) / T(lightness(c)), last = c.change;
        set(c, wanted);
        using std::abs;
        settled = settled && !(abs(value(c.change)) > rounding_);
        shrinks += value(c.change) * value(last), before += value(last) * value(last);
      }
      if (settled || sweep != leap_after) continue;
      leap_after *= 2;  // leaps become rarer, since sweeps alone settle in the end
      const N share = shrinks / before;
      if (share > N(0) && share < N(most_left) && before > square(N(clear * rounding_)))
        leap(N(share / (N(1) - share)));
    }
    return {settled, rounding_ * 8};  // covers a ball with six others around it
  }

 private:
  /// Limits of a leap. The next sweep may leave at most the share `most_left` of a change, since a longer leap would
  /// cost digits. Changes below `clear` roundings tell nothing about the rest.
  static constexpr double most_left = 0.99, clear = 1e3;

  static N square(const N& x) { return x * x; }
  static N lightness(const Pressed<T>& c) { return c.first_lightness + c.second_lightness; }
  static bool moves(const Pressed<T>& c) { return lightness(c) > N(0); }

  void set(Pressed<T>& c, const T& wanted) {
    const T force = c.keeps || value(wanted) > N(0) ? wanted : T(0);
    c.change = force - c.force;
    c.force = force;
    if (value(c.change) == N(0)) return;
    push(c.first, -(c.normal * T(c.change * c.first_lightness)));
    push(c.second, c.normal * T(c.change * c.second_lightness));
  }

  void push(int ball, const Vec2<T>& more) {
    if (ball != Pressed<T>::none) rates_[static_cast<std::size_t>(ball)] += more;
  }

  /// Changes every force by `times` its last change.
  void leap(const N& times) {
    for (Pressed<T>& c : contacts_)
      if (moves(c)) set(c, c.force + c.change * T(times));
  }

  std::span<Pressed<T>> contacts_;
  std::span<Vec2<T>> rates_;
  N rounding_{0};  ///< N, rounding error of the largest force
};

}  // namespace bankshot::detail
