// SPDX-License-Identifier: MIT
//
// Turns a simulated shot into a puzzle, for families.hpp.
#pragma once

#include <functional>
#include <optional>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// A result of a shot that a puzzle can ask for.
struct Deed {
  Target target{};
  double arrival = 0;  ///< m/s
  int bounces = 0;
  bool stops = false;
};

/// Returns the drop into a pocket, if there is one; otherwise the place of rest or a place that was passed, each half
/// of the time. Returns none when the number of bounces is outside `least` to `most`.
std::optional<Deed> some_deed(Random& random, const ShotRequest& shot, const Trajectory& t, int least, int most);
/// Returns the place where the ball came to rest.
std::optional<Deed> its_rest(const Trajectory& t);
/// Returns the place that was passed at parameter `p` of a leg.
std::optional<Deed> passed(const ShotRequest& shot, const Trajectory& t, const Leg& leg, double p);

/// Returns the puzzle that asks for a deed. It asks for the arrival speed of the shot with a launch speed between half
/// and twice the shot's, or for exactly the shot's launch speed with any arrival. It asks for the number of the shot's
/// bounces, or for their route.
Made asked(Random& random, const ShotRequest& shot, const Trajectory& t, const Deed& deed);

/// Turns the shot until it drops on the pocket's exact line; returns it unchanged when that changes its cushions or
/// fails.
ShotRequest on_exact_line(const ShotRequest& shot);

/// Draws shots until one does something within the allowed bounces, and asks for that. The function `shot` may return
/// none; a scene that breaks a rule of the format is drawn again. The exact number of bounces is `bounces`, or -1 for
/// up to `most`.
using DrawShot = std::function<std::optional<ShotRequest>()>;
Made ask_for_some(Random& random, int bounces, int most, const DrawShot& shot);
inline Made ask_for_some(Random& random, int bounces, const DrawShot& shot) {
  return ask_for_some(random, bounces, most_bounces, shot);
}

/// Calls `draw` until it returns a puzzle that keeps the rules of the format.
Made first_valid(const std::function<std::optional<Made>()>& draw);

/// Draws a place on the table that is clear of the cushions, evenly; returns none after a thousand failed draws.
std::optional<Vec2d> random_place(Random& random, const Boundary& boundary, const Table& table);

/// Returns coefficients like those of the presets; `mathavan`, `stronge` and `tilted` add that cushion or tilt.
Physics usual_physics(Model model, const Body& body);
bool has_spin(Model model);

/// Draws a shot on a common table: 2.54 m x 1.27 m without pockets, a 9-foot pool table, or a rectangle of any size.
ShotRequest usual_shot(Random& random, Model model);

}  // namespace bankshot::test
