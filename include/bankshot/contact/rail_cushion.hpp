// SPDX-License-Identifier: MIT
//
// What the cushion of one rail has of its own: new rubber, a worn corner. Where it has nothing, the physics' cushion
// says it. Derivatives by the physics' coefficients are those of a change that all rails share.
#pragma once

#include <optional>

#include "bankshot/contact/restitution.hpp"

namespace bankshot {

struct RailCushion {
  std::optional<Restitution> restitution{};
  std::optional<double> friction{};  ///< between ball and cushion

  bool operator==(const RailCushion&) const = default;
  bool any() const { return restitution || friction; }

  /// The law of this rail.
  template <class Cushion>
  Cushion of(Cushion law) const {
    const auto own = [](auto& coefficient, double its) { coefficient += its - value(coefficient); };
    if (restitution) {
      own(law.restitution.at_rest, restitution->at_rest);
      own(law.restitution.per_speed, restitution->per_speed);
      own(law.restitution.per_speed2, restitution->per_speed2);
    }
    if constexpr (requires { law.friction; })
      if (friction) own(law.friction, *friction);
    return law;
  }
};

}  // namespace bankshot
