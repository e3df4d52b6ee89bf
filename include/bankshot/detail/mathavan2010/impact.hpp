// SPDX-License-Identifier: MIT
//
// The impact of mathavan2010 from first touch to the end of restitution. It consists of Taylor steps, each cut at the
// first switch in it, which is a root of their polynomials.
//   compression   until vy = 0
//   restitution   until the work given back is e² times the work taken
// Lengths of impulse are relative to the normal approach speed, which is 1 here.
#pragma once

#include "bankshot/detail/mathavan2010/slide.hpp"
#include "bankshot/detail/mathavan2010/straight.hpp"

namespace bankshot::detail::mathavan {

inline constexpr int most_steps = 2000;

template <class T>
class Impact : private Straight<T> {
 public:
  /// `cushion` and `cloth` are the slips over the approach speed. A slip up to `zero` counts as 0.
  Impact(const Nose<T>& nose, const Vec2<T>& cushion, const Vec2<T>& cloth, const T& vy, double tolerance, double zero)
      : Base(nose, tolerance), order_(order(tolerance)) {
    vy_ = vy;
    set_slip(e_.cushion, cushion, zero);
    set_slip(e_.cloth, cloth, zero);
  }

  void run(const T& restitution) {
    phase(1, T(0));
    if (course_.jams) return;
    const T target = restitution * restitution * work_;
    vy_ = work_ = T(0);
    if (as_double(target) > 0) phase(-1, target);
  }

  const ImpactCourse& course() const { return course_; }
  const T& vy() const { return vy_; }
  Vec2<T> cushion_slip() const { return Base::slip(e_.cushion); }
  Vec2<T> cloth_slip() const { return Base::slip(e_.cloth); }

 private:
  using Base = Straight<T>;
  using Base::course_, Base::e_, Base::load, Base::margin, Base::note, Base::rounding, Base::set_slip, Base::settle,
      Base::sign_, Base::start, Base::straight, Base::target_, Base::tolerance_, Base::vy_, Base::work_;
  using Contact = typename Base::Contact;

  /// Returns the order at which a tolerance costs least.
  static int order(double tolerance) {
    return std::clamp(static_cast<int>(5 - 0.55 * std::log(tolerance)), 8, max_order<T> - 1);
  }

  /// Runs compression (sign 1) or restitution (sign −1).
  void phase(int sign, const T& target) {
    sign_ = sign;
    target_ = target;
    for (Contact* k : {&e_.cushion, &e_.cloth})
      if (k->slip == Slip::slides && as_double(k->size) <= tolerance_) k->slip = Slip::sticks;
    settle();
    for (;;) {
      if (course_.steps++ > most_steps) course_.jams = true;
      e_.begin();
      if (!(as_double(e_.vy_rate[0]) < 0)) course_.jams = true;  // the approach would not slow down
      // A cushion that sticks leaves the cloth no load only if no friction force is consistent.
      if (!e_.cushion.moves() && as_double(e_.q[0]) < 0) course_.jams = true;
      if (course_.jams) return;
      left_ = std::max(as_double(Base::left()), 0.0);
      bool done = false;
      if (!straight(done)) done = curved();
      if (done) return;
    }
  }

  /// Takes one Taylor step. Returns true at the end of the phase.
  bool curved() {
    const bool starts = e_.cushion.slip == Slip::starts || e_.cloth.slip == Slip::starts;
    if (starts) expand_start();
    if (starts || settles(e_.cushion) || settles(e_.cloth)) return cut(e_, reach(e_, -1));
    const int clock = nearest();
    e_.unit = T(scale());
    const auto now = [](const Contact& k) { return k.moves() ? k.direction : Vec2<T>{T(0), T(0)}; };
    const Vec2<T> fw = now(e_.cushion), fc = now(e_.cloth);
    slide_.r[0] = {e_.cushion.moves() ? e_.cushion.size : T(0), e_.cloth.moves() ? e_.cloth.size : T(0)};
    slide_.fx[0] = {fw.x, fc.x};
    slide_.fy[0] = {fw.y, fc.y};
    slide_.x[0] = slide_.r[0] * slide_.fx[0];
    slide_.y[0] = slide_.r[0] * slide_.fy[0];
    slide_.vy[0] = vy_;
    slide_.work[0] = work_;
    slide_.expand(e_.nose, e_.sliding(), order_, static_cast<std::size_t>(clock), e_.unit, sign_);
    return cut(slide_, reach(slide_, clock));
  }

  /// Returns how far the last pass moved a slip.
  double expand_start() {
    e_.unit = T(scale());
    e_.vy[0] = vy_;
    e_.work[0] = work_;
    return e_.expand(order_, sign_, tolerance_);
  }

  /// Expands a small slip as one that starts, if its direction settles far sooner than it grows or shrinks: other steps
  /// would be as short as that. Returns false, and changes nothing, where the direction has not settled yet.
  bool settles(Contact& k) {
    const double size = as_double(k.size), squared = size * size;
    if (k.slip != Slip::slides || squared * squared > tolerance_) return false;
    // A settled direction turns about as fast as the other contact's, so T is about r.
    if (magnitude(k.across[0]) > size + tolerance_ / size) return false;
    if (!(order_ * std::abs(as_double(k.along[0])) < as_double(e_.stiffness(k)))) return false;
    const Vec2<T> before = k.direction;
    start(k);
    const double moved = expand_start();
    const Vec2<T> off = k.direction - before;
    const double turned = size * std::hypot(magnitude(off.x), magnitude(off.y));
    if (std::max(moved, turned) <= tolerance_ * share) return true;
    k.direction = before;
    k.slip = Slip::slides;
    load();
    e_.begin();
    return false;
  }

  /// Returns the slip whose direction turns soonest.
  int nearest() const {
    int clock = 0;
    double soonest = 1e300;
    for (int i = 0; i < 2; ++i) {
      const Contact& k = i == 0 ? e_.cushion : e_.cloth;
      if (!k.moves()) continue;
      const double rate = std::abs(as_double(k.along[0])) + std::abs(as_double(k.across[0]));
      if (!(as_double(k.size) < soonest * rate)) continue;
      soonest = as_double(k.size) / rate;
      clock = i;
    }
    return e_.cushion.moves() ? clock : 1;
  }

  /// Returns an impulse over which the slips change noticeably.
  double scale() const {
    double unit = left_ + tolerance_;
    for (const Contact* k : {&e_.cushion, &e_.cloth})
      if (k->slip == Slip::slides)
        unit =
            std::min(unit, as_double(k->size) / (std::abs(as_double(k->along[0])) + std::abs(as_double(k->across[0]))));
    return unit;
  }

  /// Returns the length of a step whose neglected terms, smaller than the last two kept, stay below the tolerance. A
  /// slip close to 0 has to keep its direction too.
  template <class Series>
  double reach(const Series& s, int clock) const {
    constexpr double close = 1e-3;
    const double size = clock < 0 ? 1 : as_double(e_.contact(static_cast<std::size_t>(clock)).size);
    const double allowed = tolerance_ * share * std::min(1.0, size / close);
    double length = clock_limit(clock);
    for (const int n : {order_ - 1, order_}) {
      const double term = s.term(static_cast<std::size_t>(n));
      if (term > 0) length = std::min(length, std::exp(std::log(allowed / term) / n));
    }
    return length;
  }

  double clock_limit(int clock) const {
    double longest = (2 * left_ + tolerance_) / as_double(e_.unit);
    for (int i = 0; i < 2; ++i) {
      const Contact& k = i == 0 ? e_.cushion : e_.cloth;
      if (!k.moves() || !(as_double(k.along[0]) < 0)) continue;
      const double zero = -as_double(k.size) / (as_double(k.along[0]) * as_double(e_.unit));
      constexpr double e_folds = 8, nearly = 0.9;
      if (i == clock) return e_folds * zero;
      longest = std::min(longest, nearly * zero);
    }
    return longest;
  }

  template <class Series>
  void move(const Series& s, const T& x) {
    for (std::size_t i = 0; i < 2; ++i)
      if (e_.contact(i).moves()) set_slip(e_.contact(i), s.slip(i, order_, x), 0);
    vy_ = evaluate(s.vy, order_, x);
    work_ = evaluate(s.work, order_, x);
  }

  /// Follows the series to the first switch, at most to `length`. Returns true at the end of the phase.
  template <class Series>
  bool cut(const Series& s, double length) {
    Contact* leaves = nullptr;
    bool loads = false;
    for (const std::size_t i : {0, 1}) {
      Contact& k = e_.contact(i);
      if (k.moves()) continue;
      const auto outside = [&](double x) {
        const Vec2<T> f = s.friction(i, order_, T(x));
        return as_double(margin(k, f.x, f.y, evaluate(s.q, order_ - 1, T(x)))) > rounding();
      };
      if (outside(length)) {
        length = first_outside(length, outside);
        leaves = &k;
      }
    }
    const auto turned = [&](double x) { return (as_double(evaluate(s.q, order_ - 1, T(x))) < 0) != e_.lifted; };
    if (e_.cushion.moves() && turned(length)) {
      length = first_outside(length, turned);
      loads = true;
      leaves = nullptr;
    }
    const auto& a = sign_ > 0 ? s.vy : s.work;
    const T goal = sign_ > 0 ? T(0) : target_;
    const double off = as_double(T(evaluate(a, order_, T(length)) - goal));
    if (sign_ > 0 ? off <= 0 : off >= 0) {
      constexpr double safe = 1e-7;
      move(s, root(a, order_, goal, length, tolerance_ * safe));
      return true;
    }
    move(s, T(length));
    if (leaves) {
      e_.begin();
      start(*leaves);
    } else if (loads) {
      e_.lifted = !e_.lifted;
    }
    if (leaves || loads) note();
    return false;
  }

  static constexpr double share = 0.5;  ///< share of the tolerance that one Taylor step may use

  int order_;
  double left_ = 0;  ///< impulse left in this phase, if the forces stay as they are
  Slide<T> slide_;
};

}  // namespace bankshot::detail::mathavan
