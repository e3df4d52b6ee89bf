// SPDX-License-Identifier: MIT
//
// Puzzles that have a shot, each made by simulating a random shot with 0 to 5 cushions (plan/generate.hpp). The puzzle
// asks for the place where that shot stops, passes or drops, without rounding. The draws are seeded; the same seed
// gives the same puzzles on every machine.
#pragma once

#include <string>

#include "bankshot/plan/generate.hpp"

namespace bankshot::test {

using bankshot::Random;

/// uniform: rectangles of many sizes, six pockets or none. discrete: grid positions, angles that are multiples of 15
/// degrees, exact corners, starts on a cushion. convex, reflex: random polygons.
enum class Family { uniform, discrete, convex, reflex };
/// tilted: `spin` physics on a table tilted by 0.1 to 5 mm per metre.
enum class Model { ideal, rolling, spin, mathavan, stronge, tilted };
inline constexpr Family families[] = {Family::uniform, Family::discrete, Family::convex, Family::reflex};
std::string name(Family family);

using bankshot::Made;

inline constexpr int most_bounces = 5;

/// Draws until a shot qualifies. `bounces` is the exact number of bounces, or -1 for up to most_bounces.
Made random_puzzle(Random& random, Family family, Model model, int bounces = -1);

/// Draws a simple polygon around the origin: convex, or with some vertices pulled in.
Table random_polygon(Random& random, bool convex);

}  // namespace bankshot::test
