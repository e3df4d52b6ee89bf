// SPDX-License-Identifier: MIT
//
// The impact of mathavan2010 from first touch to the end of restitution: Taylor steps of the series in
// mathavan2010_series.hpp, and the switches between sticking and sliding, each located.
//   compression   until vy = 0: a root of its polynomial
//   restitution   until the work given back is e² times the work taken: a root of that polynomial
//   slide → stick a slip that runs into 0 does so along a straight line at the end; it is taken there
//                 when what the line neglects is below the tolerance
//   stick → slide where the force that keeps a slip at 0 leaves its cone
//   load          where q, the load on the cloth, changes sign
// Lengths of impulse are relative to the normal approach speed, which is 1 here.
#pragma once

#include <algorithm>
#include <cmath>

#include "bankshot/contact/mathavan2010_series.hpp"

namespace bankshot::mathavan {

/// Which contacts slide (bits 0 cushion, 1 cloth), whether the cloth carries nothing (bit 2) and
/// whether the ball is on its way back (bit 3).
using Mode = unsigned char;

struct Course {
  bool jams = false;  ///< vy' >= 0 before the ball had stopped, or too many steps
  int steps = 0;
  int modes = 0;
  std::array<Mode, 16> mode{};  ///< the first sixteen, in order
};

inline constexpr int most_steps = 2000;

template <class T>
class Impact {
 public:
  /// Slips at the cushion and at the cloth over the approach speed; `zero` is the slip that counts as 0.
  Impact(const Nose<T>& nose, const Vec2<T>& cushion, const Vec2<T>& cloth, const T& vy, double tolerance, double zero)
      : tolerance_(tolerance), order_(order(tolerance)), vy_(vy), e_(nose) {
    set_slip(e_.cushion, cushion, zero);
    set_slip(e_.cloth, cloth, zero);
  }

  void run(const T& restitution) {
    phase(1, T(0), value(restitution));
    if (course_.jams) return;
    const T target = restitution * restitution * work_;
    vy_ = work_ = T(0);
    if (value(target) > 0) phase(-1, target, value(restitution));
  }

  const Course& course() const { return course_; }
  const T& vy() const { return vy_; }
  Vec2<T> cushion_slip() const { return slip(e_.cushion); }
  Vec2<T> cloth_slip() const { return slip(e_.cloth); }

 private:
  using Contact = mathavan::Contact<T>;

  static int order(double tolerance) {
    return std::clamp(static_cast<int>(6 - 0.55 * std::log(tolerance)), 8, max_order - 1);
  }

  static Vec2<T> slip(const Contact& k) { return k.slip == Slip::slides ? k.direction * k.size : Vec2<T>{T(0), T(0)}; }

  static void set_slip(Contact& k, const Vec2<T>& slip, double zero) {
    using std::sqrt;
    k.slip = Slip::sticks;
    const T square = dot(slip, slip);
    if (!(value(square) > zero * zero)) return;
    k.slip = Slip::slides;
    k.size = sqrt(square);
    k.direction = slip / k.size;
  }

  T margin(const Contact& k, const T& ix, const T& iy, const T& q) const {
    T limit = e_.nose.mu_w;
    if (&k == &e_.cloth) limit = q > T(0) ? T(e_.nose.mu_s * q) : T(0);
    return ix * ix + iy * iy - limit * limit;
  }
  T margin(const Contact& k) const { return margin(k, k.ix[0], k.iy[0], e_.q[0]); }

  /// Compression (sign 1) or restitution (sign −1).
  void phase(int sign, const T& target, double e) {
    sign_ = sign;
    target_ = target;
    for (Contact* k : {&e_.cushion, &e_.cloth})
      if (k->slip == Slip::slides && value(k->size) <= tolerance_) k->slip = Slip::sticks;
    settle();
    for (;;) {
      if (course_.steps++ > most_steps) course_.jams = true;
      e_.begin();
      if (!(value(e_.vy_rate[0]) < 0)) course_.jams = true;
      // A cushion that sticks can leave the cloth no load only where no friction force is consistent.
      if (!e_.cushion.moves() && value(e_.q[0]) < 0) course_.jams = true;
      if (course_.jams) return;
      const double rate = -value(e_.vy_rate[0]);
      left_ = sign > 0 ? value(vy_) / rate : std::max(e + value(vy_), 0.0) / rate;
      bool done = false;
      if (!straight(done)) done = curved();
      if (done) return;
    }
  }

  void note() {
    const auto bits =
        (e_.cushion.moves() ? 1u : 0u) | (e_.cloth.moves() ? 2u : 0u) | (e_.lifted ? 4u : 0u) | (sign_ < 0 ? 8u : 0u);
    if (course_.modes < static_cast<int>(course_.mode.size()))
      course_.mode[static_cast<std::size_t>(course_.modes)] = static_cast<Mode>(bits);
    ++course_.modes;
  }

  /// Decides for every contact at 0 whether it sticks or starts, and where to.
  void settle() {
    for (Contact* k : {&e_.cushion, &e_.cloth})
      if (k->slip == Slip::starts) k->slip = Slip::sticks;
    load();
    if (!e_.cushion.moves() && !e_.cloth.moves())
      settle_both();
    else
      for (Contact* k : {&e_.cushion, &e_.cloth})
        if (!k->moves()) {
          e_.begin();
          // The force is recomputed after a switch that was located on it: rounding must not decide.
          constexpr double rounding = 1e-14;
          if (value(margin(*k)) > rounding * value(e_.nose.mu_w * e_.nose.mu_w)) start(*k);
        }
    load();
    note();
  }

  void load() {
    e_.lifted = false;
    if (!e_.cushion.moves()) return;
    e_.lifted = value(e_.nose.sine + e_.nose.mu_w * e_.nose.cosine * e_.cushion.direction.y) < 0;
  }

  /// From no slip at all (only where vy = 0, in the plane of a head-on shot): the motion stays in that
  /// plane, so the directions are ±y and the first consistent pair is taken.
  void settle_both() {
    Contact &w = e_.cushion, &c = e_.cloth;
    for (const int cloth : {-1, 1, 0})
      for (const int cushion : {0, 1, -1}) {
        if (cloth == 0 && cushion == 0) continue;
        w.slip = cushion == 0 ? Slip::sticks : Slip::starts;
        c.slip = cloth == 0 ? Slip::sticks : Slip::starts;
        w.direction = {T(0), T(cushion)};
        c.direction = {T(0), T(cloth)};
        load();
        e_.begin();
        const bool fits_w = w.moves() ? value(e_.cushion.along[0]) > 0 : value(margin(w)) <= 0;
        const bool fits_c = c.moves() ? value(e_.cloth.along[0]) > 0 : value(margin(c)) <= 0;
        if (fits_w && fits_c) return;
      }
    course_.jams = true;
  }

  /// Direction in which contact k leaves 0: T = 0. The force that would keep it there is the first
  /// guess, exact where the contact's inverse mass is isotropic; then Newton.
  void start(Contact& k) {
    using std::sqrt;
    const T size = sqrt(k.ix[0] * k.ix[0] + k.iy[0] * k.iy[0]);
    k.direction = {k.ix[0] / size, k.iy[0] / size};
    k.slip = Slip::starts;
    bool last = false;
    constexpr int most = 50;
    for (int i = 0; i < most; ++i) {
      load();
      e_.begin();
      const T kappa = e_.stiffness(k);
      if (!(std::abs(value(kappa)) > 0)) return;
      T turn = k.across[0] / kappa;
      constexpr double far = 0.5;
      if (std::abs(value(turn)) > far) turn = T(value(turn) > 0 ? far : -far);
      const Vec2<T> d = k.direction + perpendicular(k.direction) * turn;
      k.direction = d / norm(d);
      if (last) return;
      last = value(turn) * value(turn) <= tolerance_;
    }
  }

  /// Whether the forces are constant over dp: a slip that shrinks to 0 swings by T dp, another by T dp / r.
  bool constant_over(double dp) const {
    for (const Contact* k : {&e_.cushion, &e_.cloth}) {
      if (!k->moves()) continue;
      if (k->slip == Slip::starts) return false;
      const double swing = magnitude(k->across[0]), r = value(k->size) + std::min(0.0, value(k->along[0])) * dp;
      const double off = r > dp * swing ? dp * dp * swing / r : dp * swing;
      if (off > tolerance_ * share) return false;
    }
    return true;
  }

  /// The rest of the phase, or of a slide that ends before it, in one straight step if that is exact
  /// to the tolerance.
  bool straight(bool& done) {
    using std::sqrt;
    const T rate = -e_.vy_rate[0];
    T dp(0);
    if (sign_ > 0) {
      dp = vy_ / rate;
    } else {
      const T rest = (target_ - work_) / e_.nose.cosine;
      dp = T(2) * rest / (sqrt(vy_ * vy_ + T(2) * rate * rest) - vy_);
    }
    Contact* ends = nullptr;
    for (Contact* k : {&e_.cushion, &e_.cloth}) {
      if (k->slip == Slip::starts) return false;
      if (k->slip != Slip::slides || !(value(k->along[0]) < 0)) continue;
      const T zero = k->size / -k->along[0];
      if (!(value(zero) < value(dp) - tolerance_ * share)) continue;
      dp = zero;
      ends = k;
    }
    if (ends) {
      if (!mean_directions(*ends, dp)) return false;
      e_.forces(0);
      dp = ends->size / -(ends->ax[0] * ends->direction.x + ends->ay[0] * ends->direction.y);
    } else if (!constant_over(value(dp))) {
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

  /// Directions whose forces, taken as constant, bring the slip of `ends` to 0 within dp: the other slip
  /// at its middle, this one turned by T / (κ − N), which is its mean turn, for z reaches 0 with it.
  /// False when the squares that this neglects exceed the tolerance.
  bool mean_directions(Contact& ends, const T& dp) {
    Contact& other = &ends == &e_.cushion ? e_.cloth : e_.cushion;
    const T kappa = e_.stiffness(ends), firm = kappa - ends.along[0];
    if (!(value(firm) > 0)) return false;
    const T turn = ends.across[0] / firm, swing = other.moves() ? T(other.across[0] * dp / other.size) : T(0);
    // A derivative may grow without bound towards r = 0; far below the tolerance it no longer decides.
    constexpr double far_below = 1e-3;
    const bool small = magnitude(T(dp * (turn * turn + swing * swing))) <= tolerance_ * share;
    if (!small && !(value(dp) <= tolerance_ * far_below)) return false;
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

  /// Where to look at the slip of an approaching contact on its own clock.
  int choose_clock() const {
    int clock = -1;
    double soonest = left_;
    for (int i = 0; i < 2; ++i) {
      const Contact& k = i == 0 ? e_.cushion : e_.cloth;
      if (k.slip == Slip::starts) return -1;
      if (k.slip != Slip::slides || !(value(k.along[0]) < 0)) continue;
      const double zero = -value(k.size) / value(k.along[0]);
      if (!(zero < soonest)) continue;
      soonest = zero;
      clock = i;
    }
    return clock;
  }

  /// An impulse over which the slips change noticeably.
  double scale() const {
    double unit = left_ + tolerance_;
    for (const Contact* k : {&e_.cushion, &e_.cloth})
      if (k->slip == Slip::slides)
        unit = std::min(unit, value(k->size) / (std::abs(value(k->along[0])) + std::abs(value(k->across[0]))));
    return unit;
  }

  /// Length of a step whose first neglected terms stay below the tolerance.
  double step_length() const {
    double length = clock_limit();
    for (const int n : {order_ - 1, order_}) {
      const auto i = static_cast<std::size_t>(n);
      double term = std::max(std::abs(value(e_.vy[i])), std::abs(value(e_.work[i])));
      for (const Contact* k : {&e_.cushion, &e_.cloth}) {
        if (!k->moves()) continue;
        const double r = value(k->slip == Slip::slides ? k->size : T(0));
        term = std::max(term, std::abs(value(k->r[i])));
        term = std::max(term, r * std::max(std::abs(value(k->fx[i])), std::abs(value(k->fy[i]))));
        if (k->slip == Slip::starts)
          term = std::max(
              term, std::max(std::abs(value(k->fx[i - 1])), std::abs(value(k->fy[i - 1]))) * std::abs(value(k->r[1])));
      }
      if (term > 0) length = std::min(length, std::exp(std::log(tolerance_ * share / term) / n));
    }
    return length;
  }

  double clock_limit() const {
    double longest = (2 * left_ + tolerance_) / value(e_.unit);
    for (int i = 0; i < 2; ++i) {
      const Contact& k = i == 0 ? e_.cushion : e_.cloth;
      if (k.slip != Slip::slides || !(value(k.along[0]) < 0)) continue;
      const double zero = -value(k.size) / (value(k.along[0]) * value(e_.unit));
      constexpr double e_folds = 8, nearly = 0.9;
      if (i == e_.clock) return e_folds * zero;
      longest = std::min(longest, nearly * zero);
    }
    return longest;
  }

  T margin_at(const Contact& k, double x) const {
    return margin(k, evaluate(k.ix, order_ - 1, T(x)), evaluate(k.iy, order_ - 1, T(x)),
                  evaluate(e_.q, order_ - 1, T(x)));
  }

  void move(const T& x) {
    for (Contact* k : {&e_.cushion, &e_.cloth}) {
      if (!k->moves()) continue;
      k->slip = Slip::slides;
      k->size = evaluate(k->r, order_, x);
      const Vec2<T> d{evaluate(k->fx, order_, x), evaluate(k->fy, order_, x)};
      k->direction = d / norm(d);
    }
    vy_ = evaluate(e_.vy, order_, x);
    work_ = evaluate(e_.work, order_, x);
  }

  /// One Taylor step, cut at the first switch in it. True at the end of the phase.
  bool curved() {
    e_.clock = choose_clock();
    e_.unit = T(scale());
    e_.vy[0] = vy_;
    e_.work[0] = work_;
    e_.expand(order_, sign_);
    double length = step_length();
    Contact* leaves = nullptr;
    bool loads = false;
    for (Contact* k : {&e_.cushion, &e_.cloth}) {
      if (k->moves()) continue;
      constexpr double rounding = 1e-14;
      const double limit = rounding * value(e_.nose.mu_w * e_.nose.mu_w);
      const auto outside = [&](double x) { return value(margin_at(*k, x)) > limit; };
      if (outside(length)) {
        length = first_outside(length, outside);
        leaves = k;
      }
    }
    const auto turned = [&](double x) { return (value(evaluate(e_.q, order_ - 1, T(x))) < 0) != e_.lifted; };
    if (e_.cushion.moves() && turned(length)) {
      length = first_outside(length, turned);
      loads = true;
      leaves = nullptr;
    }
    const Series<T>& a = sign_ > 0 ? e_.vy : e_.work;
    const T goal = sign_ > 0 ? T(0) : target_;
    const double off = value(T(evaluate(a, order_, T(length)) - goal));
    if (sign_ > 0 ? off <= 0 : off >= 0) {
      constexpr double safe = 1e-6;
      move(root(a, order_, goal, length, tolerance_ * share * safe));
      return true;
    }
    move(T(length));
    if (leaves) {
      e_.begin();
      start(*leaves);
      note();
    } else if (loads) {
      e_.lifted = !e_.lifted;
      note();
    }
    return false;
  }

  static constexpr double share = 0.1;  ///< of the tolerance, for one step

  double tolerance_;
  int order_;
  T vy_, work_{0}, target_{0};
  int sign_ = 1;
  double left_ = 0;  ///< impulse left in this phase, roughly
  Expansion<T> e_;
  Course course_;
};

}  // namespace bankshot::mathavan
