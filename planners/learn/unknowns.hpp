// SPDX-License-Identifier: MIT
//
// The unknowns of a fit: the launch of each shot, and the coefficients of physics and camera that all shots share.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bankshot/learn/fit.hpp"
#include "planners/trace/varied.hpp"

namespace bankshot::planning {

/// start [s], x, y [m], speed [m/s], angle [rad], top, side, masse.
inline constexpr int launch_size = launch_varies;
using LaunchUnknowns = std::array<double, launch_size>;
enum LaunchIndex : std::size_t { start_time, x, y, speed, angle, top, side, masse };

LaunchUnknowns unknowns_of(const ShotRequest& shot, double start);
/// Returns the scene with this launch.
ShotRequest with_launch(ShotRequest scene, const LaunchUnknowns& launch);

/// One coefficient, or part of the camera, that may be fitted.
struct Fittable {
  std::string name;
  double low, high;  ///< bounds
  double guess;      ///< prior standard deviation: a standard error above this says nothing
  double start;
};

/// Returns names, bounds and starts of all coefficients of this physics, with tilt and camera at the end.
std::vector<Fittable> coefficients_of(const Physics& physics, const Body& body, bool meets_balls);

/// The part that all shots share: coefficients by name, in the physics they belong to.
struct Common {
  Physics base;
  std::vector<Fittable> known{};  ///< all that may be fitted
  std::vector<std::string> names{};
  std::vector<double> values{};

  const Fittable& fittable(const std::string& name) const;
  void add(const std::string& name);
  /// Returns the physics with these values.
  Physics physics() const;
};

/// Counts the cost of a fit.
struct Spent {
  long simulations = 0, restarts = 0;
};

/// Physics and camera with varying coefficients. Camera: seen = offset + scale · true.
template <int N>
struct Varying {
  explicit Varying(const Physics& physics, bool meets_balls);

  /// Sets the coefficients of these names. The k-th varies as the number `first + k`; none does if `first` is negative.
  void set(const std::vector<std::string>& names, const double* values, int first);

  VariedPhysics<N> physics;
  Dual<N> scale{1.0};
  Vec2<Dual<N>> offset{};
  bool leans = false;  ///< the tilt is one of the names

 private:
  std::vector<Dual<N>*> places(const std::string& name);
  std::vector<typename VariedPhysics<N>::Named> named_;
  std::vector<std::string> names_;  ///< names of the last `set`
  std::vector<std::vector<Dual<N>*>> at_;
};

}  // namespace bankshot::planning
