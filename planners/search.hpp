// SPDX-License-Identifier: MIT
//
// One search: the puzzle, what it has cost, what it has found. The planners propose launches to
// it; `certify` (verify.hpp) is the only way a launch becomes a shot.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

/// Why a launch does not do what was asked.
enum class Foul {
  none,
  missed,
  fell_short,
  wrong_cushion,
  extra_cushion,
  pocketed,
  too_fast,
  too_slow,
  too_long,
  outside_aim
};

struct Failure {
  Foul foul = Foul::none;
  Contact contact{};  ///< the cushion, vertex or pocket that stood in the way
  double speed = 0;   ///< m/s, what a bound on the speed forbids (too_fast, too_slow)
  bool like(const Failure& o) const { return foul == o.foul && contact == o.contact; }
};

struct NearMiss {
  Launch launch{};
  int bounces = 0;
  double miss = std::numeric_limits<double>::infinity();
  Failure failure{};
};

struct Search {
  explicit Search(const Puzzle& p, bool find_all, bool find_first = false);

  const Puzzle& puzzle;
  Boundary boundary;
  Physics rough;                   ///< the puzzle's, integrated no more finely than a seed needs
  bool all;                        ///< every shot
  bool first;                      ///< the first shot found will do
  std::optional<Range> arrival;    ///< speed asked at the target; none: any
  bool stop;                       ///< the ball must come to rest at the target
  double asked = 0;                ///< m/s, of a range of arrival speeds the one to aim for; `prefer` chooses
  std::optional<double> pinned{};  ///< m/s, a launch speed to keep to: then any arrival in the range will do

  long simulations = 0;
  bool measure = false;  ///< clock the certification
  double certify_us = 0;
  std::vector<Shot> shots;
  /// Launches that lead near a target along a cushion sequence but are no shots: its centre is blocked,
  /// or no aim reaches it. Parts of the target may be reached beside them.
  struct Lead {
    Launch launch;
    std::vector<Contact> contacts;
    Vec2d target;
    double half = 0;  ///< rad beside the aim to look at; 0: as far as the target is wide
    double room = -std::numeric_limits<double>::infinity();  ///< m, the largest clearance that was found there
  };
  std::vector<Lead> leads;
  NearMiss near;
  struct Counted {
    Failure failure;  ///< of several speeds, the one nearest to the bound
    long times;
  };
  std::vector<Counted> failures;  ///< why candidates failed, with how often
  std::string note;               ///< what was skipped or cut, for the message
  void add_note(const std::string& text) { note += (note.empty() ? "" : "; ") + text; }
  bool complete = false;          ///< every candidate there can be was tried
  bool proved = false;            ///< and nothing else can reach any part of the target
  bool rounding_decided = false;  ///< some path through a corner or along a line failed by rounding, perhaps
  bool cut = false;               ///< the budget ended the search

  /// Counts a failed candidate, and keeps it if it came nearest.
  void remember(const NearMiss& miss);
  /// Counts a simulation with so many bounces; long ones count as several.
  void spend(std::size_t bounces) { simulations += 1 + static_cast<long>(bounces / bounces_a_simulation); }
  static constexpr std::size_t bounces_a_simulation = 32;
  /// Whether the budget is used up; remembers that it ended the search.
  bool spent() {
    cut = cut || simulations >= puzzle.budget;
    return cut;
  }
  /// Shots to choose from; more would hardly be better.
  static constexpr std::size_t enough_to_compare = 32;
  /// Whether a planner that proposes seed after seed may stop.
  bool enough() {
    const bool plenty = !all && shots.size() >= (first ? 1 : enough_to_compare);
    stopped = stopped || plenty;
    return plenty || spent();
  }
  bool stopped = false;  ///< with so many shots that no more were looked for
  /// Some shot was found, and no other is asked for.
  bool satisfied() const { return first && !shots.empty(); }
  bool one_unknown() const { return !arrival || pinned; }
  /// Where shots are aimed: the point, or the pocket's centre.
  const std::vector<Vec2d>& aim_points() const { return aim_points_; }
  /// How far from an aim point still counts: `within`, or the pocket's capture radius.
  double reach(const Vec2d& aim_point) const;
  const Vec2d& nearest_aim_point(const Vec2d& arrived) const;
  /// The reach of the aim point nearest to where a ball arrived.
  double nearest_reach(const Vec2d& arrived) const;
  /// How far before its aim point a ball arrives: `reach` of a pocket, 0 of a point.
  double capture(double reach) const { return point() ? 0 : reach; }
  const PointTarget* point() const { return std::get_if<PointTarget>(&puzzle.target); }
  bool wanted(int pocket) const {
    const auto& p = std::get_if<PocketTarget>(&puzzle.target)->pocket;
    return !p || *p == pocket;
  }
  /// A miss this small is one of the target's centre.
  bool centred(double miss) const;
  /// The ball touches this contact at the start; any at all.
  bool touches(Contact contact) const;
  bool frozen() const;
  /// The launch would drive the ball into a cushion that it touches: a bounce before it moves.
  bool into_touched_wall(const Vec2d& direction) const;

 private:
  std::vector<Vec2d> aim_points_;
};

}  // namespace bankshot::planning
