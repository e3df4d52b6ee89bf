// SPDX-License-Identifier: MIT
//
// The result of a search: shots, launches that came near, failure reasons of others, and remarks for the answer.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/target.hpp"
#include "bankshot/simulate/route.hpp"

namespace bankshot::planning {

/// Words by which an answer says how a shot was found.
namespace word {
inline constexpr std::string_view unfold = "unfold", partition = "partition", continuation = "continuation",
                                  relaxed = "relaxed", global = "global";
}  // namespace word

/// The failure reason of a launch.
enum class FailureReason {
  none,
  missed,
  fell_short,
  wrong_cushion,
  extra_cushion,
  in_place,  ///< it bounces where it stands: out of a vertex, or more than twice in a corner between two cushions
  pocketed,
  hit_ball,
  other_cut,
  inexact,      ///< it is made, but not on the exact line or point, or not at the speed asked
  too_fast,     ///< it needs more speed than a bound allows
  too_slow,     ///< it needs less speed than a bound allows
  too_long,     ///< no launch rolls so far
  outside_aim,  ///< the aim is outside its bounds; refused without a replay
  other_bounces,
  scratched,  ///< the cue ball falls
  no_budget
};

struct Failure {
  FailureReason reason = FailureReason::none;
  Contact contact{};  ///< the obstacle
  double speed = 0;   ///< m/s; the speed needed, which a bound forbids (too_fast, too_slow)
  bool like(const Failure& o) const { return reason == o.reason && contact == o.contact; }
};

/// A launch that failed.
struct NearMiss {
  Launch launch{};
  double miss = std::numeric_limits<double>::infinity();  ///< m
  Failure failure{};
};

/// A candidate that leads near an aim point along a route but is no shot: an obstacle blocks it, or no aim reaches the
/// point. Parts of the target may be reachable beside it.
struct Candidate {
  Launch launch;
  Route route;
  AimPoint aim_point;
  LaunchSpin spin{};
  double half = 0;  ///< rad; how far beside the aim to look; 0: as far as the target is wide
  double room = -std::numeric_limits<double>::infinity();  ///< m; the largest clearance that was found there
};

struct SearchResult {
  std::vector<Shot> shots{};
  /// A shot moved to its safest launch, by the launch where it was found. No shot: it is worth less than the best one
  /// known.
  struct Moved {
    Launch from;
    LaunchSpin spin;
    std::optional<Shot> shot;
  };
  std::vector<Moved> moved{};
  std::vector<Candidate> candidates{};
  NearMiss nearest{};
  struct Counted {
    Failure failure;  ///< with the speed nearest to the bound, of several
    long times;
  };
  std::vector<Counted> failures{};  ///< failure reasons of candidates, with their numbers
  std::string note{};               ///< for the message: what was skipped or cut
  bool complete = false;            ///< every candidate there can be was tried
  bool proved = false;              ///< certified: also, nothing else can reach any part of the target
  bool rounding_decided = false;    ///< some path through a corner or along a line may have failed by rounding
  bool improvement_sought = false;  ///< an improvement pass used a map of wide cells
  int not_searched = -1;            ///< least number of cushions not fully searched when the budget ended; -1: none
  bool plenty = false;              ///< the search stopped because there were shots enough

  /// Counts a failed candidate, and keeps it if it came nearest.
  void remember(const NearMiss& miss);
  void add_note(const std::string& text) { note += (note.empty() ? "" : "; ") + text; }
};

}  // namespace bankshot::planning
