// SPDX-License-Identifier: MIT
//
// The laws of a scene with coefficients that vary: dual numbers through the same simulator, so that a locked path tells
// how far a wrong coefficient moves where it leads, and a fit which one moves it to where the ball was seen.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/physics.hpp"

namespace bankshot::planning {

/// mathavan2010, whose impact is integrated: quick in the few numbers that one impact depends on, whose derivatives are
/// then chained with theirs.
template <class C>
struct VariedMathavan : Mathavan2010Of<C> {
  void bounce(const Body& body, State<C>& s, const Vec2d& away) const;
  void bounce(const Body& body, State<C>& s, const Vec2<C>& away) const { bounce(body, s, value(away)); }
};

template <class C>
using VariedLaw = std::variant<MirrorOf<C>, Han2005Of<C>, VariedMathavan<C>, StrongeOf<C>, CustomCushion>;

template <class C>
struct VariedCushion {
  VariedLaw<C> law;

  template <class N>
  void bounce(const Body& body, State<C>& s, const Vec2<N>& away) const {
    std::visit([&](const auto& cushion) { cushion.bounce(body, s, away); }, law);
  }
};
template <class C>
VariedCushion<C> of_rail(const RailCushion& rail, const VariedCushion<C>& cushion) {
  return {std::visit([&](const auto& law) -> VariedLaw<C> { return rail.of(law); }, cushion.law)};
}

/// N: how many may vary at once.
template <int N>
struct VariedPhysics {
  using C = Dual<N>;
  explicit VariedPhysics(const Physics& physics);

  /// Path in the puzzle's physics, such as "cushion.height"; with where it stands here.
  struct Named {
    std::string name;
    std::vector<C*> at;
  };
  /// Those that a shot with these balls and cushions may depend on. Valid as long as this stays where it is.
  std::vector<Named> coefficients(bool meets_balls);

  /// `f(motion)` with the simplest type that these coefficients allow; `leaning`: also where the tilt itself varies.
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

/// For the sensitivity of a shot; for the launch of a recorded one; for a launch and the coefficients of its physics.
inline constexpr int one_varies = 1, launch_varies = 8, all_vary = 28;

}  // namespace bankshot::planning
