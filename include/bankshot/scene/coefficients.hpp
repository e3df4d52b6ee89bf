// SPDX-License-Identifier: MIT
//
// Coefficients of a physics by the names that fits and sensitivities give them, such as "cushion.friction", and physics
// drawn from how well a fit knows its own.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bankshot/scene/physics.hpp"

namespace bankshot {

/// Where it stands, in SI units; more than one place where laws share it, none where this physics has no such one.
std::vector<double*> coefficient(Physics& physics, std::string_view name);

/// What the errors of a physics say it may be instead.
class DrawnPhysics {
 public:
  /// Of a physics without errors: itself.
  explicit DrawnPhysics(const Physics& physics);

  /// How many standard normal numbers a draw takes.
  std::size_t count() const { return names_.size(); }

  /// Coefficients are kept where they mean something: frictions not below 0, restitutions in [0, 1], noses between R
  /// and 2 R.
  Physics draw(const double* normal, const Body& body) const;

 private:
  Physics middle_;
  std::vector<std::string> names_;
  std::vector<double> root_;  ///< lower triangle L, L Lᵀ the covariance (Cholesky), row by row
};

}  // namespace bankshot
