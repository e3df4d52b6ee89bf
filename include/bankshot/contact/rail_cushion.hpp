// SPDX-License-Identifier: MIT
//
// Coefficients that one rail has of its own, for new rubber or a worn corner. The others come from the physics'
// cushion. Derivatives by the physics' coefficients are those of a change that all rails share.
#pragma once

#include <optional>

#include "bankshot/contact/restitution.hpp"

namespace bankshot {

struct RailCushion {
  std::optional<Restitution> restitution{};
  std::optional<double> friction{};  ///< between ball and cushion

  bool operator==(const RailCushion&) const = default;
  bool any() const { return restitution || friction; }

  /// Returns the law of this rail.
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
