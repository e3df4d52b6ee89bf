// SPDX-License-Identifier: MIT
//
// Access to the coefficients of a physics by the names that fits and sensitivities use, such as "cushion.friction", and
// random draws of a physics from the uncertainty of its fitted coefficients.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bankshot/scene/physics.hpp"

namespace bankshot {

/// Returns pointers to a coefficient, in SI units: several if laws share it, none if this physics does not have it.
std::vector<double*> coefficient(Physics& physics, std::string_view name);

/// Draws physics from the distribution that the coefficient errors of a physics describe.
class DrawnPhysics {
 public:
  /// A physics without errors always draws itself.
  explicit DrawnPhysics(const Physics& physics);

  /// Returns the number of standard normal numbers that a draw takes.
  std::size_t count() const { return names_.size(); }

  /// Returns one draw. Coefficients are clamped to physical values: frictions to at least 0, restitutions to [0, 1],
  /// nose heights to between R and 2 R.
  Physics draw(const double* normal, const Body& body) const;

 private:
  Physics middle_;
  std::vector<std::string> names_;
  std::vector<double> root_;  ///< lower triangle L with L Lᵀ = covariance (Cholesky), row by row
};

}  // namespace bankshot
