// SPDX-License-Identifier: MIT
//
// Recordings of shots whose truth is known: a camera sees random launches on a table with random coefficients.
#pragma once

#include <cstdint>
#include <vector>

#include "bankshot/simulate/camera.hpp"

namespace bankshot::test {

struct Filmed {
  Physics truth;
  std::vector<ShotRequest> shots;
  std::vector<Recording> recordings;
};

struct FilmWish {
  int shots = 30;
  double seconds = 5;
  Camera camera{.rate = 60, .noise = 2e-3, .outliers = 0.05};
  double slowest = 1.5, fastest = 5;  ///< m/s
  bool bounces = true;                ///< false: slow shots along the table that meet no cushion
};

/// Draws coefficients in the range of real tables, with han2005 cushions.
Physics random_table(Random& random, const Body& body);

/// Coefficients that shots without a cushion cannot identify: those of the cushions, and spinning friction, because
/// side spin moves nothing on the cloth alone.
inline constexpr const char* told_by_bounces[] = {"cushion.restitution", "cushion.friction", "cushion.height",
                                                  "spinning_friction"};

Filmed filmed(const Physics& truth, const FilmWish& wish, Random& random);

/// Returns a coefficient by its name in a fit.
double coefficient(Physics physics, const std::string& name);

}  // namespace bankshot::test
