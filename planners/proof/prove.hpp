// SPDX-License-Identifier: MIT
//
// The only door out: a launch becomes a shot by a replay in the plain simulator.
// Cost: one simulation a replay. Guarantee: what is returned reaches its target after the bounces
// asked, with the miss and the arrival speed that the replay measured.
#pragma once

#include <string_view>

#include "bankshot/motion/arc.hpp"
#include "planners/search.hpp"

namespace bankshot::planning {

/// Bounces a replay must have at its target.
struct Goal {
  int min, max;
  const std::vector<Contact>* sequence = nullptr;
  static Goal of(const Search& s) {
    const CushionRule& c = s.puzzle.cushions;
    return {c.min, c.max, c.sequence ? &*c.sequence : nullptr};
  }
  static Goal exactly(const Search& s, int bounces) {
    Goal g = of(s);
    g.min = g.max = bounces;
    return g;
  }
  static Goal along(const std::vector<Contact>& contacts) {
    const int n = static_cast<int>(contacts.size());
    return {n, n, &contacts};
  }
};

struct Replay {
  bool made = false;  ///< in the contract's sense: within reach, after the bounces asked
  double miss = std::numeric_limits<double>::infinity();  ///< m, see Shot::miss
  Arrival arrival;
  Failure failure;             ///< when it is not made
  int bounces = 0;             ///< at arrival or at the foul
  bool cushion_stick = false;  ///< see Shot::cushion_stick
};

/// Simulates a launch against the goal; `contacts`, if given, receives the bounces.
Replay replay(Search& s, const Launch& launch, const Goal& goal, std::vector<Contact>* contacts = nullptr);

/// What a path costs in speed, where its shape does not depend on the speed: after the arcs added so
/// far, v² = gain·v0² − loss. The arcs are those of a launch at unit speed without friction.
class SpeedAccount {
 public:
  explicit SpeedAccount(double deceleration) : deceleration_(deceleration) {}
  void add(const Arc<double>& arc, double t);
  double gain = 1, loss = 0;  ///< –, m²/s²
  /// No launch at `speed` or slower gets here.
  bool beyond(double speed) const { return loss > gain * speed * speed; }

 private:
  double deceleration_;  ///< m/s²
  double before2_ = 1;   ///< speed² on the arc before
};

/// The shape of a path, simulated at unit speed without friction (`ideal`, `rolling`).
struct Trace {
  Replay replay;
  SpeedAccount account;
};
Trace trace(Search& s, double angle, const Goal& goal, std::vector<Contact>* contacts = nullptr);

/// The launch speed where only the aim is unknown: the fixed one, in `ideal` 1 m/s brought inside the bounds.
double fixed_speed(const Search& s);

/// The launch speed for this path: fixed, or chosen by `prefer` inside what the puzzle leaves
/// free. None when a bound forbids it; then the search remembers it. `off_centre`: to rest beside the
/// target's centre the bound itself may do.
std::optional<double> launch_speed(Search& s, double angle, const Trace& t, bool off_centre = false);

/// Replays, and keeps the launch as a shot when it is exact (or, `off_centre`, when it is made). Of
/// shots that differ only by bounces at the target itself, the one with fewer is kept.
bool certify(Search& s, const Launch& launch, int bounces, std::string_view planner, bool off_centre = false);

/// Traces an aim, finds its speed and certifies it: the last step of every planner here. Where
/// rounding decides at a corner or on a cushion line, tries aims `tolerance::nudge` away.
bool certify_aim(Search& s, double angle, int bounces, std::string_view planner, bool off_centre = false);

}  // namespace bankshot::planning
