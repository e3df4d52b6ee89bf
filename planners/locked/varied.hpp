// SPDX-License-Identifier: MIT
//
// The laws of a scene with one coefficient that varies: dual numbers through the same simulator, so that a locked path
// tells how far a wrong coefficient moves its arrival.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/scene/physics.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

using Varied = Dual<1>;

/// mathavan2010, whose impact is integrated in plain coefficients: its derivatives by them are central differences.
struct VariedMathavan {
  Mathavan2010 plain;
  RestitutionOf<Varied> restitution;
  Varied height, friction, sliding_friction;

  void bounce(const Body& body, State<Varied>& s, const Vec2d& away) const;
  void bounce(const Body& body, State<Varied>& s, const Vec2<Varied>& away) const { bounce(body, s, value(away)); }
};

using VariedLaw = std::variant<MirrorOf<Varied>, Han2005Of<Varied>, VariedMathavan, StrongeOf<Varied>, CustomCushion>;

struct VariedCushion {
  VariedLaw law;

  template <class N>
  void bounce(const Body& body, State<Varied>& s, const Vec2<N>& away) const {
    std::visit([&](const auto& cushion) { cushion.bounce(body, s, away); }, law);
  }
};
inline VariedCushion of_rail(const RailCushion& rail, const VariedCushion& cushion) {
  return {std::visit([&](const auto& law) -> VariedLaw { return rail.of(law); }, cushion.law)};
}

struct VariedPhysics {
  explicit VariedPhysics(const Physics& physics);

  /// Path in the puzzle's physics, such as "cushion.height"; with where it stands here.
  struct Named {
    std::string name;
    std::vector<Varied*> at;
  };
  /// Those that a shot with these balls and cushions may depend on. Valid as long as this stays where it is.
  std::vector<Named> coefficients(bool meets_balls);

  bool ideal, level;
  TiltedOf<Varied> motion;  ///< on a level table its level part, unless the tilt itself varies
  VariedCushion cushion;
  BallBallOf<Varied> balls;
};

}  // namespace bankshot::planning
