// SPDX-License-Identifier: MIT
//
// Random single-ball shots, by family of difficulty. The draws are seeded; the same seed gives the same shots on every
// machine up to the library's trigonometry.
#pragma once

#include <string>

#include "bankshot/scene/puzzle.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

enum class ShotFamily {
  uniform,   ///< ordinary tables and speeds
  discrete,  ///< grid positions, multiples of 15 degrees, restitution 0, 1/2 or 1, exact zeros
  frozen,    ///< a gap of 0 or 1e-16 ... 1e-9 m to a cushion
  corners,   ///< aimed at a corner to within 0 ... 1e-3 rad
  grazing,   ///< 1e-12 ... 1e-2 rad to a cushion
  masse,     ///< curves back to the cushion where it starts or that it leaves
  speeds,    ///< 1e-6 ... 30 m/s
  dead,      ///< restitution 0 ... 0.4
  slick,     ///< some friction is 0 or nearly 0
  convex,    ///< convex polygons
  reflex,    ///< polygons with reflex vertices
  moved,     ///< a table of 1e-3 ... 1e3 m, up to 1e4 m from the origin
  drag,      ///< rolling friction grows with the speed
  mathavan,  ///< cushions are mathavan2010
  tilted     ///< a table tilted by 10 µm to 3 cm per metre; sometimes friction grows with the speed
};
inline constexpr ShotFamily shot_families[] = {
    ShotFamily::uniform, ShotFamily::discrete, ShotFamily::frozen, ShotFamily::corners,  ShotFamily::grazing,
    ShotFamily::masse,   ShotFamily::speeds,   ShotFamily::dead,   ShotFamily::slick,    ShotFamily::convex,
    ShotFamily::reflex,  ShotFamily::moved,    ShotFamily::drag,   ShotFamily::mathavan, ShotFamily::tilted};
std::string name(ShotFamily family);

/// Draws a valid shot that stops at 200 cushions at the latest.
ShotRequest random_shot(Random& random, ShotFamily family);

/// Returns the document that `bankshot simulate` replays to the same numbers.
std::string write_shot(const ShotRequest& shot);

}  // namespace bankshot::test
