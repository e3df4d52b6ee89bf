// SPDX-License-Identifier: MIT
//
// Straight steps of the cushion impact of mathavan2010, taken if the forces are constant to the tolerance until the
// phase ends or a slip reaches 0. A slip that runs into 0 does so along a straight line at the end. It gets there in
// one step if what the line neglects is below the tolerance.
#pragma once

#include "bankshot/detail/mathavan2010/switches.hpp"

namespace bankshot::detail::mathavan {

template <class T>
class Straight : protected Switches<T> {
 protected:
  using Base = Switches<T>;
  using Base::Base;
  using Base::e_, Base::margin, Base::set_slip, Base::settle, Base::sign_, Base::target_, Base::tolerance_, Base::vy_,
      Base::work_;
  using Contact = typename Base::Contact;

  /// Returns true if the forces are constant over dp. A slip that shrinks to 0 swings by T dp, another by T dp / r. The
  /// swing turns an acceleration of about 7/2 μ.
  bool constant_over(double dp) const {
    for (const Contact* k : {&e_.cushion, &e_.cloth}) {
      if (!k->moves()) continue;
      if (k->slip == Slip::starts) return false;
      const double swing = magnitude(k->across[0]), r = as_double(k->size) + std::min(0.0, as_double(k->along[0])) * dp;
      const double pull = std::min(1.0, 3.5 * as_double(k == &e_.cushion ? e_.nose.mu_w : e_.nose.mu_s));
      const double off = pull * (r > dp * swing ? dp * dp * swing / r : dp * swing);
      if (off > tolerance_ * share) return false;
    }
    return true;
  }

  /// Returns the impulse that ends the phase if the forces stay as they are.
  T left() const {
    using std::sqrt;
    const T rate = -e_.vy_rate[0];
    if (sign_ > 0) return vy_ / rate;
    const T rest = (target_ - work_) / e_.nose.cosine;
    return T(2) * rest / (sqrt(vy_ * vy_ + T(2) * rate * rest) - vy_);
  }

  /// Takes the rest of the phase, or of a slide that ends before it, in one straight step. Returns false if that is not
  /// exact to the tolerance. Sets `done` at the end of the phase.
  bool straight(bool& done) {
    T dp = left();
    Contact* ends = nullptr;
    for (Contact* k : {&e_.cushion, &e_.cloth}) {
      if (k->slip == Slip::starts) return false;
      if (k->slip != Slip::slides || !(as_double(k->along[0]) < 0)) continue;
      const T zero = k->size / -k->along[0];
      if (!(as_double(zero) < as_double(dp) - tolerance_ * share)) continue;
      dp = zero;
      ends = k;
    }
    if (ends) {
      if (!mean_directions(*ends, dp)) return false;
      e_.forces(0);
      dp = ends->size / -(ends->ax[0] * ends->direction.x + ends->ay[0] * ends->direction.y);
    } else if (!constant_over(as_double(dp))) {
      return false;
    }
    advance_straight(dp, ends);
    done = !ends;
    if (!done) settle();
    return true;
  }

  void advance_straight(const T& dp, const Contact* ends) {
    for (Contact* k : {&e_.cushion, &e_.cloth}) {
      if (k->slip != Slip::slides) continue;
      if (k == ends)
        k->slip = Slip::sticks;
      else
        set_slip(*k, k->direction * k->size + Vec2<T>{k->ax[0], k->ay[0]} * dp, tolerance_ * share);
    }
    const T before = vy_;
    vy_ += e_.vy_rate[0] * dp;
    work_ += T(sign_) * e_.nose.cosine * (before + vy_) * dp / T(2);
  }

  /// Sets directions whose forces, taken as constant, bring the slip of `ends` to 0 within dp. The other slip gets its
  /// direction at the middle of the step. This one is turned by T / (κ − N), its mean turn, since T reaches 0 together
  /// with the slip. Returns false if the squares that this neglects exceed the tolerance.
  bool mean_directions(Contact& ends, const T& dp) {
    Contact& other = &ends == &e_.cushion ? e_.cloth : e_.cushion;
    const T kappa = e_.stiffness(ends), firm = kappa - ends.along[0];
    if (!(as_double(firm) > 0)) return false;
    const T turn = ends.across[0] / firm, swing = other.moves() ? T(other.across[0] * dp / other.size) : T(0);
    // A derivative may grow without bound towards r = 0. In a step far below the tolerance it no longer matters.
    constexpr double far_below = 1e-3;
    const bool small = magnitude(T(dp * (turn * turn + swing * swing))) <= tolerance_ * share;
    if (!small && !(as_double(dp) <= tolerance_ * far_below)) return false;
    const auto rotate = [](Contact& k, const T& by) {
      const Vec2<T> d = k.direction + perpendicular(k.direction) * by;
      const T size = norm(d);
      k.fx[0] = d.x / size;
      k.fy[0] = d.y / size;
    };
    if (other.moves()) rotate(other, swing / T(2));
    e_.forces(0);
    rotate(ends, (ends.ay[0] * ends.direction.x - ends.ax[0] * ends.direction.y) / firm);
    return true;
  }

  static constexpr double share = 0.1;  ///< share of the tolerance that one straight step may use
};

}  // namespace bankshot::detail::mathavan
