// SPDX-License-Identifier: MIT
//
// Random single-ball shots, by family of difficulty. Seeded; the same seed gives the same shots on
// every machine up to the library's trigonometry.
#pragma once

#include <string>

#include "bankshot/scene/puzzle.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// uniform: ordinary tables and speeds. discrete: grid positions, multiples of 15 degrees, restitution
/// 0, 1/2 or 1, exact zeros. frozen: a gap of 0 or 1e-16 ... 1e-9 m to a cushion. corners: aimed at one
/// to within 0 ... 1e-3 rad. grazing: 1e-12 ... 1e-2 rad to a cushion. masse: curves back to the cushion
/// it lies at or leaves. speeds: 1e-6 ... 30 m/s. dead: restitution 0 ... 0.4. slick: some friction is
/// 0 or nearly. convex, reflex: polygons. moved: a table of 1e-3 ... 1e3 m, up to 1e4 m from the origin. drag: rolling
/// friction grows with the speed. mathavan: cushions are mathavan2010. tilted: the table leans, by 10 µm to 3 cm a
/// metre, and now and then friction grows with the speed there, too.
enum class ShotFamily {
  uniform,
  discrete,
  frozen,
  corners,
  grazing,
  masse,
  speeds,
  dead,
  slick,
  convex,
  reflex,
  moved,
  drag,
  mathavan,
  tilted
};
inline constexpr ShotFamily shot_families[] = {
    ShotFamily::uniform, ShotFamily::discrete, ShotFamily::frozen, ShotFamily::corners,  ShotFamily::grazing,
    ShotFamily::masse,   ShotFamily::speeds,   ShotFamily::dead,   ShotFamily::slick,    ShotFamily::convex,
    ShotFamily::reflex,  ShotFamily::moved,    ShotFamily::drag,   ShotFamily::mathavan, ShotFamily::tilted};
std::string name(ShotFamily family);

/// Always valid. Stops at 200 cushions at the latest.
ShotRequest random_shot(Random& random, ShotFamily family);

/// The document that `bankshot simulate` replays to the same numbers.
std::string write_shot(const ShotRequest& shot);

}  // namespace bankshot::test
