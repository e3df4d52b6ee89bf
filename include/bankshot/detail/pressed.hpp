// SPDX-License-Identifier: MIT
//
// Balls that touch, do not approach, and that friction drives into each other push on each other as long as that lasts.
// The forces along the lines of centres, and from cushions that balls are pressed to, are the least that leave no
// acceleration into a contact, but what takes one round the other:
//   f_c >= 0, w_c >= 0, f_c w_c = 0 where w_c = n_c·(a_b − a_a) + v²/D, a_i = its own + Σ ± f_c n_c / M_i
// with M the mass of a ball that slides, and 7/5 of it where it rolls or rests: it has to be turned as well; v the
// speed of one across the line of centres, as seen from the other, and D the distance of centres.
//
// Method: contact by contact in the order given, what is left of its acceleration taken away, until nothing changes
// (projected Gauss–Seidel); one contact alone is exact at once. What is left of speeds along the lines of centres, up
// to tolerance::held_contact, is taken away in the same manner, since contact by contact it would take hundreds of
// events: a ball that rolls goes on rolling, one that rests goes on resting. A ball that is pressed on moves with
// constant acceleration for a piece of 2 ms at most.
//
// No overlap: with v₁ in the place of v above, the square of the distance is after t seconds at least
//   D² + (v² − v₁²) t² + a v t³, a the acceleration across
// which is no less than D² up to t = h where v₁ <= v − h max(0, −a). Two that are held come v (v − v₁) h²/D apart.
#pragma once

#include <cmath>
#include <limits>
#include <span>

#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {

/// Acceleration where the arc begins, also of one with a drag.
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

/// What a push has to move [kg].
template <class T>
double inertia(const Arc<T>& arc, const Body& body) {
  return slides(arc) ? body.mass : body.mass * 7 / 5;
}

/// Others give the centre this acceleration all along the arc, which becomes a piece.
template <class T>
void press(Arc<T>& arc, const Vec2<T>& push) {
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
      // The slip fades at 7/2 of the friction, and the push moves it too: so long until none is left in its direction.
      const T fades = size2 * N(3.5) + dot(push, friction);
      arc.duration = value(fades) > N(0) ? T(arc.duration * (size2 * N(3.5)) / fades) : T(forever);
    }
    if (!turns || value(arc.duration) > N(tolerance::last_piece)) {
      if (turns) arc.duration = arc.duration * N(0.5);
      shorten(T(N(tolerance::longest_piece)));
      arc.end = PhaseEnd::piece;
    }
  } else {
    arc.acceleration = first_acceleration(arc);
    arc.drag = {};
    arc.pressed = Press::rolls;
    arc.duration = T(N(tolerance::longest_piece));
    arc.end = PhaseEnd::piece;
    const T slows = -dot(arc.velocity, Vec2<T>(arc.acceleration + push));
    if (value(slows) > N(0)) shorten(T(dot(arc.velocity, arc.velocity) / slows));
  }
  arc.acceleration += push;
  arc.bends = true;
  arc.chord = false;
}

/// A contact of two balls, by number; or of the first with a cushion.
template <class T>
struct Pressed {
  int first, second;   ///< second: none is the cushion
  Vec2<T> normal;      ///< unit, from the first to the second or to the cushion
  T turns{0};          ///< m/s², of balls that stay in touch while one goes round the other
  T force{0};          ///< N, or an impulse [N s]
  bool keeps = false;  ///< it pulls as well
  Real<T> first_lightness{0}, second_lightness{0};  ///< 1/kg; 0 of a cushion
  static constexpr int none = -1;
};

/// Of the second as seen from the first.
template <class T>
Vec2<T> relative(const Pressed<T>& c, std::span<const Vec2<T>> rates) {
  const Vec2<T>& first = rates[static_cast<std::size_t>(c.first)];
  return c.second == Pressed<T>::none ? -first : rates[static_cast<std::size_t>(c.second)] - first;
}

/// How fast the two part, or what drives them apart.
template <class T>
T parting_rate(const Pressed<T>& c, std::span<const Vec2<T>> rates) {
  return dot(c.normal, relative<T>(c, rates)) + c.turns;
}

/// Of all contacts, where their forces do not settle earlier.
inline constexpr int most_sweeps = 100000;

/// What became of forces.
template <class N>
struct Settled {
  bool settled = false;
  N rounding{0};  ///< N, of the force on a ball
};

/// Finds the forces. `rates`: accelerations of the balls alone, changed to what they are with the forces; or
/// velocities, and the forces are impulses. `inertias` [kg]; infinite: it stays as it is. Where it does not settle in
/// so many sweeps what is left is for the next look, which comes within 2 ms.
template <class T>
Settled<Real<T>> press_apart(std::span<Pressed<T>> contacts, std::span<Vec2<T>> rates, std::span<const double> inertias,
                             int sweeps = most_sweeps) {
  using N = Real<T>;
  const N unit = std::numeric_limits<N>::epsilon();
  const auto inverse = [&](int ball) {
    return ball == Pressed<T>::none ? N(0) : N(1) / N(inertias[static_cast<std::size_t>(ball)]);
  };
  const auto push = [&](int ball, const N& lightness, const Vec2<T>& impulse) {
    if (ball != Pressed<T>::none) rates[static_cast<std::size_t>(ball)] += impulse * T(lightness);
  };
  for (Pressed<T>& c : contacts) c.first_lightness = inverse(c.first), c.second_lightness = inverse(c.second);
  N rounding(0);  // of a force: that of the rates, on the heaviest
  for (std::size_t i = 0; i < rates.size(); ++i) {
    using std::sqrt;
    const N size = N(inertias[i]) * N(sqrt(dot(value(rates[i]), value(rates[i]))));
    if (inertias[i] < forever && size > rounding) rounding = size;
  }
  rounding = rounding * (8 * unit);
  bool settled = false;
  for (int sweep = 0; sweep < sweeps && !settled; ++sweep) {
    settled = true;
    for (Pressed<T>& c : contacts) {
      if (c.first_lightness + c.second_lightness == N(0)) continue;
      const T parting = parting_rate<T>(c, rates);
      const T wanted = c.force - parting / T(c.first_lightness + c.second_lightness);
      const T force = c.keeps || value(wanted) > N(0) ? wanted : T(0), more = force - c.force;
      if (value(more) == N(0)) continue;
      using std::abs;
      settled = settled && !(abs(value(more)) > rounding);
      c.force = force;
      push(c.first, c.first_lightness, -(c.normal * more));
      push(c.second, c.second_lightness, c.normal * more);
    }
  }
  return {settled, rounding * 8};  // of a ball with six others around it
}

}  // namespace bankshot
