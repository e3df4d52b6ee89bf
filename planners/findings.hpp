// SPDX-License-Identifier: MIT
//
// What a search has found: shots, launches that came near, why others failed, and what is to be said about it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/target.hpp"
#include "bankshot/simulate/route.hpp"

namespace bankshot::planning {

/// Why a launch does not do what was asked.
enum class Foul {
  none,
  missed,
  fell_short,
  wrong_cushion,
  extra_cushion,
  in_place,  ///< it bounces where it stands: out of a vertex, or more often than between the two cushions of a corner
  pocketed,
  hit_ball,
  other_cut,
  covered,      ///< a ball stands at the point that is asked
  inexact,      ///< it is made, but not on the exact line or point, or not at the speed asked
  too_fast,     ///< it needs more speed than a bound allows
  too_slow,     ///< it needs less
  too_long,     ///< no launch rolls so far
  outside_aim,  ///< these are refused without a replay
  other_bounces,
  scratched,  ///< the cue ball falls
  no_budget
};

struct Failure {
  Foul foul = Foul::none;
  Contact contact{};  ///< what stood in the way
  double speed = 0;   ///< m/s, what a bound on the speed forbids (too_fast, too_slow)
  bool like(const Failure& o) const { return foul == o.foul && contact == o.contact; }
};

/// A launch that failed.
struct NearMiss {
  Launch launch{};
  int bounces = 0;
  double miss = std::numeric_limits<double>::infinity();  ///< m
  Failure failure{};
};

/// A launch that leads near a mark along a route but is no shot: what it aims at is blocked, or no aim reaches it.
/// Parts of the target may be reached beside it.
struct Lead {
  Launch launch;
  Route route;
  Mark mark;
  LaunchSpin spin{};
  double half = 0;  ///< rad beside the aim to look at; 0: as far as the target is wide
  double room = -std::numeric_limits<double>::infinity();  ///< m, the largest clearance that was found there
};

struct Findings {
  std::vector<Shot> shots{};
  /// Shots at their safest launches, by where they were found; none: worth less than the shot then in hand.
  struct Moved {
    Launch from;
    LaunchSpin spin;
    std::optional<Shot> shot;
  };
  std::vector<Moved> moved{};
  std::vector<Lead> leads{};
  NearMiss nearest{};
  struct Counted {
    Failure failure;  ///< of several speeds, the one nearest to the bound
    long times;
  };
  std::vector<Counted> failures{};  ///< why candidates failed, with how often
  std::string note{};               ///< what was skipped or cut, for the message
  bool complete = false;            ///< every candidate there can be was tried
  bool proved = false;              ///< and nothing else can reach any part of the target
  bool rounding_decided = false;    ///< some path through a corner or along a line failed by rounding, perhaps
  bool rivals_sought = false;       ///< on a map of wide cells
  int not_searched = -1;            ///< so many cushions, or more, were not all searched when the budget ended
  bool plenty = false;              ///< with so many shots that no more were looked for

  /// Counts a failed candidate, and keeps it if it came nearest.
  void remember(const NearMiss& miss);
  void add_note(const std::string& text) { note += (note.empty() ? "" : "; ") + text; }
};

}  // namespace bankshot::planning
