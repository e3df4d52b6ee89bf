// SPDX-License-Identifier: MIT
//
// A vector under dry friction on an incline: the slip of a ball that slides on a tilted table, or the velocity of one
// that rolls there.
//   ẇ = −M ŵ − B w + a e,   q = |w|
// M [m/s²] is the friction, B [1/s] its growth with the speed, a [m/s²] the pull, and e the unit vector downhill.
// In the clock σ [s²/m] with dt = q dσ, the pair (q, w) obeys polynomial equations, without root or quotient:
//   w' = −M w + a q e − B q w,   q' = −M q + a w·e − B q²,   t' = q,   r' = q w
// Without B they are even linear (they keep q² = w², as a Lorentz boost does). The motion left until w = 0 then has a
// closed form. With P = q + w·e, N = q − w·e and W = w·e⊥ it is
//   T   = P / 2(M−a) + N / 2(M+a)
//   r_e = P² / 8(M−a) − N² / 8(M+a),   r_⊥ = W (P / (2M−a) + N / (2M+a)) / 2
// Method: the power series in σ, over at most half of the time in which w would change by its own size. In double that
// takes about twelve terms. Error: a few units in the last place per series. Worked number: a ball rolls at 1 m/s
// across a slope of 2 mm per metre, with M = 0.0981 and a = 0.014014 m/s². It rests after 10.406 s, 5.123 m on and
// 0.372 m downhill.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bankshot/numbers/scalar.hpp"
#include "bankshot/numbers/vec.hpp"

namespace bankshot::detail {

/// K is the type of the coefficients: T, or T without derivatives.
template <class K>
struct Incline {
  K friction;    ///< M
  K drag;        ///< B
  K pull;        ///< a > 0
  Vec2<K> down;  ///< e
};

/// Motion left until w = 0, on an incline without drag. Either friction exceeds the pull, or w points straight uphill.
template <class T>
struct Stop {
  T time;
  Vec2<T> beyond;  ///< integral of w − w(0)
};

/// P, N and W. After σ, they have shrunk by the factors e^−(M−a)σ, e^−(M+a)σ and e^−Mσ. The smaller one of P and N is
/// computed without cancellation.
template <class T>
struct Fading {
  T p, n, across;
};

template <class T, class K>
Fading<T> fading(const Incline<K>& law, const Vec2<T>& w) {
  const T along = dot(law.down, w), across = cross(law.down, w), q = norm(w);
  const bool downhill = value(along) > Real<T>(0);
  const T large = q + (downhill ? along : T(-along)), small = across * across / large;
  return {downhill ? large : small, downhill ? small : large, across};
}

template <class T, class K>
Stop<T> stop_on(const Incline<K>& law, const Vec2<T>& w) {
  using N = Real<T>;
  const auto [p, n, across] = fading(law, w);
  // If friction is less than the pull, w stops only straight uphill, where p is 0.
  const bool stays = value(law.friction) > value(law.pull);
  const auto ahead = [&, p = p](const K& slow) { return stays ? T(p / slow) : T(0); };
  const K fast = law.friction + law.pull, twice = law.friction * N(2);
  const T first = ahead(K(law.friction - law.pull)), then = n / fast;
  const T time = (first + then) * N(0.5);
  const T on = (p * first - n * then) * N(0.125);
  const T aside = across * N(0.5) * (ahead(K(twice - law.pull)) + n / K(twice + law.pull));
  const Vec2<T> moved{law.down.x * on - law.down.y * aside, law.down.y * on + law.down.x * aside};
  return {time, moved - w * time};
}

/// Returns w when `left` seconds remain until it stops. Uses Newton's method for σ on the logarithm of the remaining
/// time, which is convex.
template <class T, class K>
Vec2<T> before_stop(const Incline<K>& law, const Vec2<T>& w, const T& left) {
  using std::abs, std::exp, std::log;
  using N = Real<T>;
  auto [p, n, across] = fading(law, w);
  if (!(value(law.friction) > value(law.pull))) p = T(0);
  const K slow = law.friction - law.pull, fast = law.friction + law.pull;
  const N first = value(p) == N(0) ? N(0) : N(value(p) / value(slow)), then = value(n) / value(fast);
  // The time left after σ, and how fast it falls.
  const auto at = [&](const N& sigma) {
    const N a = first * exp(-value(slow) * sigma) * N(0.5), b = then * exp(-value(fast) * sigma) * N(0.5);
    return std::pair<N, N>(a + b, value(slow) * a + value(fast) * b);
  };
  T sigma(0);
  constexpr int enough = 60;
  for (int i = 0; i < enough; ++i) {
    const auto [lasts, falls] = at(value(sigma));
    const N step = log(lasts / value(left)) * lasts / falls;
    sigma += step;
    if (!(abs(step) * value(fast) > 2 * std::numeric_limits<N>::epsilon())) break;
  }
  const auto after = [&](const T& amount, const K& rate) { return T(amount * exp(T(rate * -sigma))); };
  if constexpr (has_derivatives<T>) {
    const T lasts = (value(p) == N(0) ? T(0) : T(after(p, slow) / slow)) + after(n, fast) / fast;
    const T missing = lasts * N(0.5) - left;
    sigma += (missing - value(missing)) / at(value(sigma)).second;
  }
  const T left_p = value(p) == N(0) ? T(0) : after(p, slow), along = (left_p - after(n, fast)) * N(0.5);
  const T aside = after(across, law.friction);
  return {law.down.x * along - law.down.y * aside, law.down.y * along + law.down.x * aside};
}

/// Power series of the motion from w on, over a step h [s²/m] of σ. Its variable is x = σ/h, from 0 to about 1.
template <class T, class K>
class Glide {
 public:
  using Number = Real<T>;

  Glide(const Incline<K>& law, const Vec2<T>& w, const Number& h) : down_{T(law.down.x), T(law.down.y)} {
    along_[0] = T(dot(law.down, w));
    across_[0] = T(cross(law.down, w));
    speed_[0] = norm(w);
    time_[0] = on_[0] = aside_[0] = T(0);
    const Number scale = value(speed_[0]) * std::numeric_limits<Number>::epsilon();
    const bool drags = value(law.drag) != Number(0);
    using std::abs;
    for (terms_ = 0; terms_ + 1 < most;) {
      const std::size_t k = terms_;
      const Number by = h / static_cast<double>(k + 1);
      // Coefficient k of q (w − w(0)), along and across, and of q².
      T later_on(0), later_aside(0), square(0);
      for (std::size_t j = 0; j < k; ++j) {
        later_on += speed_[j] * along_[k - j];
        later_aside += speed_[j] * across_[k - j];
      }
      T along = along_[k] * -law.friction + speed_[k] * law.pull, across = across_[k] * -law.friction;
      T speed = speed_[k] * -law.friction + along_[k] * law.pull;
      if (drags) {
        for (std::size_t j = 0; j <= k; ++j) square += speed_[j] * speed_[k - j];
        along -= (later_on + speed_[k] * along_[0]) * law.drag;
        across -= (later_aside + speed_[k] * across_[0]) * law.drag;
        speed -= square * law.drag;
      }
      time_[k + 1] = speed_[k] * by;
      on_[k + 1] = later_on * by;
      aside_[k + 1] = later_aside * by;
      along_[k + 1] = along * by;
      across_[k + 1] = across * by;
      speed_[k + 1] = speed * by;
      ++terms_;
      const bool small = !(abs(value(along_[k + 1])) > scale) && !(abs(value(across_[k + 1])) > scale) &&
                         !(abs(value(speed_[k + 1])) > scale);
      if (small && k > 1) break;
    }
  }

  T time(const T& x) const { return sum(time_, x); }
  Vec2<T> velocity(const T& x) const { return on_table(sum(along_, x), sum(across_, x)); }
  /// Returns the integral of w − w(0).
  Vec2<T> beyond(const T& x) const { return on_table(sum(on_, x), sum(aside_, x)); }

  /// Returns x at a time. Uses Newton's method, and one last step for the derivatives.
  T at(const T& t) const {
    using std::abs;
    const Number asked = value(t);
    Number x = asked / value(time_[1]);
    constexpr int enough = 20;
    for (int i = 0; i < enough; ++i) {
      const auto [reached, slope] = reached_at(x);
      const Number step = (reached - asked) / slope;
      x -= step;
      if (!(abs(step) > 2 * std::numeric_limits<Number>::epsilon() * abs(x))) break;
    }
    if constexpr (has_derivatives<T>) {
      const T missing = time(T(x)) - t;
      return T(x) - (missing - value(missing)) / reached_at(x).second;
    } else {
      return x;
    }
  }

 private:
  static constexpr std::size_t most =
      std::numeric_limits<Number>::digits10 > 20 ? std::numeric_limits<Number>::digits10 + 10 : 30;
  using Series = std::array<T, most>;

  T sum(const Series& c, const T& x) const {
    T out = c[terms_];
    for (std::size_t k = terms_; k-- > 0;) out = out * x + c[k];
    return out;
  }

  /// Returns the time at x and its slope.
  std::pair<Number, Number> reached_at(const Number& x) const {
    Number out = value(time_[terms_]), slope(0);
    for (std::size_t k = terms_; k-- > 0;) {
      slope = slope * x + out;
      out = out * x + value(time_[k]);
    }
    return {out, slope};
  }

  Vec2<T> on_table(const T& along, const T& across) const {
    return {down_.x * along - down_.y * across, down_.y * along + down_.x * across};
  }

  Vec2<T> down_;
  Series along_, across_, speed_, time_, on_, aside_;
  std::size_t terms_ = 0;  ///< index of the last coefficient
};

}  // namespace bankshot::detail
