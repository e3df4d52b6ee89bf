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
// (projected Gauss–Seidel); one contact alone is exact at once, of two what shrinks by the same share from sweep to
// sweep is taken to its limit (Aitken's Δ², of all contacts as one vector), and more are hastened by that. What is left
// of speeds along the lines of centres, up to tolerance::held_contact, is taken away in the same manner, since contact
// by contact it would take hundreds of events: a ball that rolls goes on rolling, one that rests goes on resting. Balls
// that press on each other move with constant acceleration for a piece: 2 ms, or 20 where nothing turns to speak of.
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

/// Radians a second by which the friction turns where others give the centre this acceleration: with the slip, or with
/// the way of a ball that rolls.
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
    return N(forever);  // a cushion holds it, too
  const N size2 = dot(way, way);
  return size2 > N(0) ? N(abs(cross(more, way)) / size2) : N(forever);
}

/// Others give the centre this acceleration all along the arc, which becomes a piece of no more than so many seconds.
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
      // The slip fades at 7/2 of the friction, and the push moves it too: so long until none is left in its direction.
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

/// A contact of two balls, by number; or of the first with a cushion.
template <class T>
struct Pressed {
  int first, second;   ///< second: none is the cushion
  Vec2<T> normal;      ///< unit, from the first to the second or to the cushion
  T turns{0};          ///< m/s², of balls that stay in touch while one goes round the other
  T force{0};          ///< N, or an impulse [N s]
  T change{0};         ///< of the force, by the last sweep
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

/// Finds the forces at contacts, or the impulses where rates are velocities.
template <class T>
class Forces {
 public:
  using N = Real<T>;

  /// `rates`: accelerations of the balls with the forces that `contacts` have, changed as these change. `inertias`
  /// [kg]; infinite: it stays as it is.
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

  /// Where it does not settle in so many sweeps what is left is for the next look, which comes with the next piece.
  Settled<N> settle(int sweeps) {
    bool settled = false;
    for (int sweep = 1, leap_after = 3; sweep <= sweeps && !settled; ++sweep) {
      N shrinks(0), before(0);  // of the changes of all forces: the product with those before, and their square
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
      leap_after *= 2;  // less and less often: sweeps alone do settle
      const N share = shrinks / before;
      if (share > N(0) && share < N(most_left) && before > square(N(clear * rounding_)))
        leap(N(share / (N(1) - share)));
    }
    return {settled, rounding_ * 8};  // of a ball with six others around it
  }

 private:
  /// Of a change, what the next sweep leaves of it where that tells the rest: a longer leap would cost digits; and
  /// roundings, below which it tells nothing.
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

  /// Every force changes by so many times its last change.
  void leap(const N& times) {
    for (Pressed<T>& c : contacts_)
      if (moves(c)) set(c, c.force + c.change * T(times));
  }

  std::span<Pressed<T>> contacts_;
  std::span<Vec2<T>> rates_;
  N rounding_{0};  ///< N, of a force: that of the largest
};

}  // namespace bankshot
