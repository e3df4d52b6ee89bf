// SPDX-License-Identifier: MIT
//
// Recordings of shots whose truth is known: random launches on a table of random coefficients, as a camera sees them.
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
  bool bounces = true;                ///< else slow shots along the table that meet no cushion
};

/// Coefficients as tables have them, cushions after han2005.
Physics random_table(Random& random, const Body& body);

/// What shots that meet no cushion cannot tell: what cushions do, and side, which on the cloth alone moves nothing.
inline constexpr const char* told_by_bounces[] = {"cushion.restitution", "cushion.friction", "cushion.height",
                                                  "spinning_friction"};

Filmed filmed(const Physics& truth, const FilmWish& wish, Random& random);

/// Of a coefficient, by its name in a fit.
double coefficient(Physics physics, const std::string& name);

}  // namespace bankshot::test
