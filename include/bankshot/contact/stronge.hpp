// SPDX-License-Identifier: MIT
//
// Cushion impact with spin and a rubber that gives across as well as along: W. J. Stronge, Impact Mechanics (2nd ed.,
// Cambridge 2018), chapter "Tangential compliance in planar impact of rough bodies". The contact is a massless point on
// two springs, behind a Coulomb slider. One spring acts along the line from nose to centre and loses energy through e.
// The other acts across that line and is elastic. The slip keeps its line, so the impact is planar. The motion across
// has a closed form, apart from one root: the moment in which the contact lets go.
//   tan θ = (h − R)/R, the ball's centre being R from the nose in plan;  c from centre to nose, d = sin θ n − cos θ ẑ
//   a = vn cos θ approach, S slip, ρ = S/a;  β = 7/2, η² = β/Ω², Ω the ratio of the springs' frequencies
//   clock x: compression to π/2, restitution to x_f = (1 + e) π/2;  ψ = x, then π/2 + (x − π/2)/e
//   limit of friction: μη² sin ψ, as an extension of the spring in units of a
//   sliding: V = ρ − μβ(1 − κ cos ψ), κ = 1, then e;  sticking: U'' = −Ω² U, V = U'
// The outcome is stationary in the moments of sticking and letting go, because the force is continuous there. These
// moments are therefore found as plain numbers, and the derivatives are exact.
//
// The vertical velocity after the impact is dropped, because the ball stays on the cloth. Cloth friction during the
// impact is left out. For e < 1/Ω, the theory's cases are continued as step integration of the same springs gives them
// (continuous, any e).
// Limitation: at e below about tan²θ the ball may be left moving into the cushion; then vn = 0.
#pragma once

#include <cmath>
#include <limits>

#include "bankshot/contact/cushion_frame.hpp"
#include "bankshot/contact/cushion_registry.hpp"
#include "bankshot/motion/arc.hpp"

namespace bankshot {

namespace stronge {

/// cos x and sin x with the derivatives of x.
template <class T>
struct Turn {
  T cosine, sine;
  explicit Turn(const T& x) {
    using std::cos;
    using std::sin;
    const Real<T> v = value(x), c = cos(v), s = sin(v);
    if constexpr (has_derivatives<T>) {
      const T change = x - T(v);
      cosine = T(c) - change * s;
      sine = T(s) + change * c;
    } else {
      cosine = c, sine = s;
    }
  }
};

/// Share of the slip that the impulse across takes, (1 − S'/ρ)/β, where S' is the slip that is left, over a.
template <class T>
class Across {
  using Number = Real<T>;

 public:
  /// Takes the friction μ, the restitution e and the ratio of frequencies Ω.
  Across(const T& mu, const T& e, const T& omega)
      : mu_(mu), e_(e), omega_(omega), eta2_(T(beta) / (omega * omega)), quarter_(half_pi()) {}

  T share(const T& rho) const {
    const Number r = value(rho), mu = value(mu_), e = value(e_), eta2 = value(eta2_), b(beta);
    const bool gives = e > Number(0) && (e + Number(1)) * b - eta2 / e > b;  // may slide first, stick later
    if (r >= mu * (gives ? Number((e + Number(1)) * b - eta2 / e) : b)) return mu_ * (e_ + T(Number(1))) / rho;
    Stick stick{T(Number(0)), T(Number(0)), rho};
    if (r >= mu * eta2) stick = r <= mu * b ? in_compression(rho) : in_restitution(rho);
    return (T(Number(1)) - left(stick) / rho) / T(b);
  }

  /// Returns the share for a vanishing slip. The contact then sticks all through.
  T share_at_rest() const {
    return (T(Number(1)) - Turn<T>(omega_ * (e_ + T(Number(1))) * T(quarter_)).cosine) / T(Number(beta));
  }

 private:
  static constexpr double beta = 3.5;
  static constexpr int most_steps = 200;  // Newton's method needs five; halving alone also ends, even in 50 digits
  static Number half_pi() {
    using std::acos;
    return acos(Number(0));
  }

  /// Start of sticking: clock, extension and slip. In restitution ψ is solved for, and x moves with e.
  struct Stick {
    T x, extension, slip;
  };

  /// Returns an inverse cosine. Rounding may put its argument beyond 1.
  static Number angle(const Number& cosine) {
    using std::acos;
    return acos(cosine < Number(-1) ? Number(-1) : cosine > Number(1) ? Number(1) : cosine);
  }

  Stick in_compression(const T& rho) const {
    const Number b(beta), x = angle((b - value(rho) / value(mu_)) / (b - value(eta2_)));
    const Turn<Number> at(x);
    return {T(x), mu_ * eta2_ * T(at.sine), rho - mu_ * T(b * (Number(1) - at.cosine))};
  }

  Stick in_restitution(const T& rho) const {
    const Number b(beta), e = value(e_), psi = angle((b - value(rho) / value(mu_)) / (e * b - value(eta2_) / e));
    const Turn<Number> at(psi);
    return {T(quarter_) + e_ * T(psi - quarter_), mu_ * eta2_ * T(at.sine),
            rho - mu_ * T(b) * (T(Number(1)) - e_ * T(at.cosine))};
  }

  /// Returns the slip that is left. The moment of letting go is counted back from the end: ψ = π − δ, x = x_f − e δ.
  T left(const Stick& s) const {
    using std::atan2;
    using std::sqrt;
    const Number e = value(e_), omega = value(omega_), pi = quarter_ * Number(2), end = (e + Number(1)) * quarter_,
                 x = value(s.x), u = value(s.extension), v = value(s.slip), phase = atan2(omega * u, v);
    const bool back = x + (pi - phase) / omega < end;  // spring relaxes early: the last slip is backward
    if (!(e > Number(0))) return slip_after(s, T(Number(0)));
    const Number size = sqrt(u * u + v * v / (omega * omega)), hold = value(mu_) * value(eta2_),
                 from = back ? x + (pi - phase) / omega : x;
    // Zero when the contact lets go: the limit of friction less the pull of the spring.
    const auto spare = [&](const Number& delta) {
      const Turn<Number> held(delta), pulled(omega * (end - e * delta - x) + phase);
      const Number pull = size * pulled.sine;
      struct {
        Number value, slope;
      } out{hold * held.sine + (back ? pull : -pull),
            hold * held.cosine - (back ? e : -e) * omega * size * pulled.cosine};
      return out;
    };
    Number low(0), high = from > quarter_ ? (end - from) / e : quarter_;
    Number delta(0);  // from here, Newton's method overshoots little
    for (int i = 0; i < most_steps; ++i) {
      const auto at = spare(delta);
      (at.value < Number(0) ? low : high) = delta;
      Number next = delta - at.value / at.slope;
      if (!(next > low && next < high)) next = (low + high) / Number(2);
      const Number step = next > delta ? next - delta : delta - next;
      delta = next;
      if (step <= rounding() * delta) break;
    }
    const Number half_sine = Turn<Number>(delta / Number(2)).sine;
    const T pushed = mu_ * T(Number(beta)) * e_ * T(Number(2) * half_sine * half_sine);
    return slip_after(s, e_ * T(delta)) + (back ? pushed : -pushed);
  }

  /// Returns the slip of a contact that sticks until `early` before the end.
  T slip_after(const Stick& s, const T& early) const {
    const Turn<T> y(omega_ * ((e_ + T(Number(1))) * T(quarter_) - early - s.x));
    return s.slip * y.cosine - s.extension * omega_ * y.sine;
  }

  /// Returns the relative size of a Newton step after which the next one is below rounding.
  static Number rounding() {
    using std::sqrt;
    return sqrt(std::numeric_limits<Number>::epsilon());
  }

  T mu_, e_, omega_, eta2_;
  Number quarter_;
};

}  // namespace stronge

template <class C>
template <class T, class N>
inline void StrongeOf<C>::bounce(const Body& body, State<T>& s, const Vec2<N>& away) const {
  using std::sqrt;
  using Number = Real<T>;
  using K = Coefficient<T, C>;
  InCushionFrame<T> f = into_frame(s, away);
  if (!(value(f.vn) > Number(0))) return;
  const Number R(body.radius), turn = Number(5.0 / 2);
  const K rise = K(K(height) - K(R)) / K(R), length = square_root(K(rise * rise + K(Number(1))));
  const K cosine = K(Number(1)) / length, sine = rise / length;
  const T a = f.vn * cosine, e = restitution(f.vn);
  const T sd = f.vn * sine + f.wt * R, st = f.vt + (f.wz * cosine - f.wn * sine) * R;
  const T slip2 = sd * sd + st * st;
  const stronge::Across<T> across(T(K(friction)), e, T(K(frequency_ratio)));
  const T share = value(slip2) > Number(0) ? across.share(sqrt(slip2) / a) : across.share_at_rest();
  const T jd = sd * share, jt = st * share;
  f.vn -= (e + T(Number(1))) * a * cosine + jd * sine;
  f.vt -= jt;
  f.wt -= jd * (turn / R);
  f.wn += jt * sine * (turn / R);
  f.wz -= jt * cosine * (turn / R);
  if (value(f.vn) > Number(0)) f.vn = T(Number(0));
  out_of_frame(f, away, s);
}

}  // namespace bankshot
