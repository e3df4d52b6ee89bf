// SPDX-License-Identifier: MIT
//
// The laws of a scene with coefficients that vary: dual numbers through the same simulator. A locked path then tells
// how far a wrong coefficient moves its end. A fit tells which coefficient moves it to where the ball was observed.
#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot {
namespace planning {

/// A law whose impact is integrated. The impact runs quickly, with derivatives by the few numbers that it depends on.
/// The chain rule then gives the derivatives by the unknowns.
template <template <class> class Law, class C>
struct Chained : Law<C> {
  void bounce(const Body& body, State<C>& s, const Vec2d& away) const;
  void bounce(const Body& body, State<C>& s, const Vec2<C>& away) const { bounce(body, s, value(away)); }
};

/// The law of the registry with coefficients of type C. A custom cushion has no coefficients.
template <class C, class Law>
struct VariedAs {
  using type = Law;
};
template <class C, template <class> class Law>
struct VariedAs<C, Law<double>> {
  using type = std::conditional_t<CushionRow<Law<double>>::model.integrated, Chained<Law, C>, Law<C>>;
};
template <class C, class Variant>
struct VariedVariant;
template <class C, class... Law>
struct VariedVariant<C, std::variant<Law...>> {
  using type = std::variant<typename VariedAs<C, Law>::type...>;
};
template <class C>
using VariedLaw = typename VariedVariant<C, CushionVariant>::type;

template <class C>
struct VariedCushion {
  VariedLaw<C> law;

  /// N is double or C. All laws together are long to compile, so this is compiled once.
  template <class N>
  void bounce(const Body& body, State<C>& s, const Vec2<N>& away) const;
};
template <class C>
VariedCushion<C> of_rail(const RailCushion& rail, const VariedCushion<C>& cushion) {
  return {std::visit([&](const auto& law) -> VariedLaw<C> { return rail.of(law); }, cushion.law)};
}

/// N: how many coefficients may vary at once.
template <int N>
struct VariedPhysics {
  using C = Dual<N>;
  explicit VariedPhysics(const Physics& physics);

  /// A coefficient: its path in the puzzle's physics, such as "cushion.height", and the places where it stands here.
  struct Named {
    std::string name;
    std::vector<C*> at;
  };
  /// Returns the coefficients that a shot with these balls and cushions may depend on. They point into this object, so
  /// they are valid as long as it stays where it is.
  std::vector<Named> coefficients(bool meets_balls);

  /// Calls `f(motion)` with the simplest type that these coefficients allow. `leaning`: the table leans, or the tilt
  /// varies.
  template <class F>
  decltype(auto) with_motion(bool leaning, F&& f) const {
    if (leaning) return f(motion);
    if (motion.always_rolls) return f(RollingOf<C>{motion.rolling_friction.at_rest, motion.g});
    return f(static_cast<const SlideRollOf<C>&>(motion));
  }

  Physics origin;
  bool level;
  TiltedOf<C> motion;  ///< on a level table its level part, unless the tilt itself varies
  VariedCushion<C> cushion;
  BallBallOf<C> balls;
};

/// Numbers of derivatives: for the sensitivity of a shot, for the launch of a recorded shot, and for a launch with the
/// coefficients of its physics.
inline constexpr int one_varies = 1, launch_varies = 8, all_vary = 28;

}  // namespace planning

template <template <class> class Law, class C>
struct CushionRow<planning::Chained<Law, C>> : CushionRow<Law<C>> {};

}  // namespace bankshot
