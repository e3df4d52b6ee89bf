// SPDX-License-Identifier: MIT
//
// A target seen along a given cushion sequence: the smooth system whose roots are shots.
// Unknowns: aim [rad] and ln speed, or the aim alone where the launch speed is fixed.
// Residuals: to stop at a point, where the ball rests, over the diagonal. Else [0] the signed lateral
// miss at the closest approach over the diagonal, [1] v² − s² there (at capture for a pocket) over
// max(1, s²); v² is continued below 0, by what rolling on would have cost, when the ball rests before.
// Derivatives are exact (dual numbers); no type of the library that makes them appears here.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "planners/search.hpp"

namespace bankshot::planning {

struct LockedAim {
  const Search& s;
  std::span<const Contact> contacts;
  Vec2d target;

  double capture() const { return s.capture(s.reach(target)); }
};

/// Residuals and their derivatives with respect to the aim and ln speed at one launch.
struct Linear {
  double r[2]{}, by_aim[2]{}, by_speed[2]{};
  double size() const { return std::hypot(r[0], r[1]); }
  /// Its sign changes across a fold of the map.
  double determinant(bool one_unknown) const {
    return one_unknown ? by_aim[0] : by_aim[0] * by_speed[1] - by_aim[1] * by_speed[0];
  }
};

/// The step in (aim, ln speed) to the root of the linear system; none where it is singular. With one
/// unknown the second is 0.
std::optional<Vec2d> newton_step(const Linear& l, bool one_unknown);

/// A root near a launch by damped Newton steps, none where it leaves the neighbourhood; where the
/// derivatives jump steps that do not come nearer are halved. About five simulations.
struct Neighbourhood {
  double step_aim, step_speed;  ///< the longest step: rad, and of ln speed
  double far = 3;               ///< of such steps: how far from the start
};
/// Asked before each step how long it is, in longest steps, and where it leads: true to give up.
using Known = std::function<bool(const Launch&, double size)>;
std::optional<Launch> newton(Search& s, const LockedAim& aim, const Launch& from, const Neighbourhood& near,
                             const Known& known = {});

/// A launch near a root, moved onto it by Levenberg–Marquardt; none where that does not converge.
/// About ten locked simulations.
std::optional<Launch> solve_locked(Search& s, const LockedAim& aim, const Launch& seed);

/// One locked simulation with dual numbers; none where the path never gets to its last leg.
std::optional<Linear> linearise(Search& s, const LockedAim& aim, const Launch& launch);

/// Certifies a root; one that something blocks is kept in `leads`.
bool certify_root(Search& s, const LockedAim& aim, const Launch& root, std::string_view planner);

/// The root nearest in aim to the seed over all aim points.
std::optional<Launch> refine(Search& s, const Launch& seed, const std::vector<Contact>& contacts);

/// The launch speed with which the locked path at this angle, some `length` metres long, arrives about as
/// fast as asked: secants in the square of the speed, bracketed, to some 2 %; falling short counts as too
/// slow. None where no speed gets there. About four locked simulations.
std::optional<double> speed_at(Search& s, const LockedAim& aim, double angle, double length);

/// The same exactly, by Newton's method from a speed near it.
std::optional<double> speed_near(Search& s, const LockedAim& aim, double angle, double guess);

/// The real path of a launch: the cushions it meets, and how each aim point is missed when the bounces
/// end after any number of them that the puzzle allows. One simulation with dual numbers.
struct Passage {
  std::size_t bounces, aim_point;
  Linear linear;
};
/// Where a bounce lies along its cushion [m], and how that changes with the aim [m/rad]; of a vertex nothing.
struct BouncePlace {
  double along = 0, by_aim = 0;
};
struct Forward {
  std::vector<Contact> contacts;
  std::vector<BouncePlace> places;  ///< of the real path's bounces
  std::vector<Passage> passages;
  bool rests = false;  ///< the path ends by itself before all the bounces asked
};
/// `locked`: a sequence that is given is followed on its locked path.
void forward(Search& s, const Launch& launch, bool locked, Forward& out);

}  // namespace bankshot::planning
