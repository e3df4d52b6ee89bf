// SPDX-License-Identifier: MIT
//
// The request of one search: which shots of a problem are wanted, and within which bounds. It is small and copied
// freely. A step that wants another arrival speed, a fixed launch speed or another spin makes a request of its own.
#pragma once

#include <memory>
#include <optional>

#include "planners/problem.hpp"

namespace bankshot::planning {

/// The shots that are wanted: the best one, the first that is verified, or every distinct one. `starts`: no shot, but
/// roots of locked paths, kept as candidates.
enum class Wanted { best, first, all, starts };

struct SearchRequest {
  /// Prepares the problem; `puzzle` must outlive this and its copies.
  explicit SearchRequest(const Puzzle& puzzle, Wanted wanted = Wanted::best);

  std::shared_ptr<const Problem> problem;  ///< never null
  Wanted wanted;
  bool valued = true;          ///< success is computed and ranks shots; otherwise its first-order estimate does
  Range speed;                 ///< m/s, of the launch
  std::optional<Range> angle;  ///< rad, of the aim; none: any
  LaunchSpin spin;
  std::optional<Range> arrival;    ///< m/s at the aim point; none: any
  bool stop;                       ///< the ball must come to rest at its aim point
  double asked = 0;                ///< m/s; the arrival speed to aim for in its range, chosen by `prefer`
  double latest = forever;         ///< s; paths that take longer need not be followed
  double likelier = 0;             ///< roots of shots with less success than this need not be found
  std::optional<double> pinned{};  ///< m/s; a launch speed to keep; then any arrival speed in the range will do
  std::optional<Route> route{};    ///< the cushions, if the puzzle gives them in order
  CushionRule cue_cushions;        ///< of the cue ball: the puzzle's rule, or a stage of it
  CushionRule object_cushions;     ///< of the last object ball, likewise

  /// Returns the request with another arrival speed of its range to aim for.
  SearchRequest asking(double arrival_speed) const;
  /// Returns the request at one launch speed.
  SearchRequest launched_at(double launch_speed) const;
  /// Returns the request for roots to start from, at this arrival speed and with this spin. They may lie outside the
  /// bounds, which hold for the branches that start there.
  SearchRequest starts_at(double arrival_speed, const LaunchSpin& launch_spin) const;
  /// Returns the requests for roots from which branches are searched, at a few arrival speeds and spins: the ends that
  /// are preferred first.
  std::vector<SearchRequest> samples() const;
  /// Returns the request with another spin of the puzzle's ranges.
  SearchRequest spinning(const LaunchSpin& launch_spin) const;
  /// Returns a stage of the search, by so many cushions of the cue ball and of the last object ball.
  SearchRequest stage(int cue, int object) const;
  /// Returns the request for shots better than this one, as far as `prefer` bounds them.
  SearchRequest better_than(const Shot& shot) const;

  const Puzzle& puzzle() const { return problem->puzzle; }
  bool all() const { return wanted == Wanted::all; }
  bool first() const { return wanted == Wanted::first; }
  bool starts() const { return wanted == Wanted::starts; }
  const CushionRule& cushions() const { return cue_cushions; }
  /// Returns the rule of cushions for the n-th object ball of a shot, counted from 0.
  const CushionRule& cushions_of(std::size_t n) const {
    const Then& then = *problem->then();
    return n == then.links.size() ? object_cushions : then.links[n].cushions;
  }
  /// Returns whether only the aim is unknown.
  bool one_unknown() const { return !arrival || pinned; }
  /// Returns the launch speed if only the aim is unknown: the fixed one, or `ideal_speed`.
  double fixed_speed() const;
};

/// Calls `f` with the request that has the shot's spin, which differs if the puzzle leaves the spin free.
template <class F>
decltype(auto) as_struck(const SearchRequest& request, const Shot& shot, F&& f) {
  return shot.spin == request.spin ? f(request) : f(request.spinning(shot.spin));
}

}  // namespace bankshot::planning
