// SPDX-License-Identifier: MIT
//
// From a forward shot to a puzzle, for families.hpp: what did the ball do, and how is it asked for?
#pragma once

#include <functional>
#include <optional>

#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// Something that a shot did and that a puzzle can ask for.
struct Deed {
  Target target{};
  double arrival = 0;  ///< m/s
  int bounces = 0;
  bool stops = false;
};

/// The drop into a pocket; or else a rest or a place that was passed, half of the time each. None when the bounces are
/// outside `least` to `most`.
std::optional<Deed> some_deed(Random& random, const ShotRequest& shot, const Trajectory& t, int least, int most);
/// Where it came to rest.
std::optional<Deed> its_rest(const Trajectory& t);
/// The place that was passed at parameter `p` of a leg.
std::optional<Deed> passed(const ShotRequest& shot, const Trajectory& t, const Leg& leg, double p);

/// The puzzle that asks for a deed: the arrival speed that was seen, a launch speed between half and twice that of the
/// shot, or exactly that one and any arrival; the number of its bounces, or their sequence.
Made asked(Random& random, const ShotRequest& shot, const Trajectory& t, const Deed& deed);

/// The shot turned until it drops on the pocket's exact line; itself where that changes its cushions or fails.
ShotRequest on_exact_line(const ShotRequest& shot);

/// Draws shots until one does something within so many bounces, and asks for that. `shot` may give none; a scene that
/// breaks a rule of the format is drawn again. `bounces`: exactly so many, -1 for up to `most`.
using DrawShot = std::function<std::optional<ShotRequest>()>;
Made ask_for_some(Random& random, int bounces, int most, const DrawShot& shot);
inline Made ask_for_some(Random& random, int bounces, const DrawShot& shot) {
  return ask_for_some(random, bounces, most_bounces, shot);
}

/// Calls `draw` until it gives a puzzle that keeps the rules of the format.
Made first_valid(const std::function<std::optional<Made>()>& draw);

/// A place on the table that is clear of the cushions, drawn evenly; none in a thousand draws.
std::optional<Vec2d> random_place(Random& random, const Boundary& boundary, const Table& table);

/// Coefficients as the presets have them; `mathavan` has that cushion.
Physics usual_physics(Model model, const Body& body);
bool has_spin(Model model);

/// A ball struck at random on a common table: 2.54 m x 1.27 m without pockets, a 9-foot table with them, or a rectangle
/// of any size.
ShotRequest usual_shot(Random& random, Model model);

}  // namespace bankshot::test
