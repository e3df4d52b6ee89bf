// SPDX-License-Identifier: MIT
//
// Parts of a shot as puzzles of their own. A chain is searched piece by piece, and the pieces are put together.
#pragma once

#include <optional>
#include <vector>

#include "planners/search_request.hpp"

namespace bankshot::planning::propose {

/// A puzzle with some of the balls, and their numbers in the whole puzzle.
struct Part {
  Puzzle puzzle;
  std::vector<int> numbers;

  int whole(int ball) const { return numbers[static_cast<std::size_t>(ball)]; }
  Route whole(const Route& route) const;
};

/// Returns the part in which the cue ball goes to a place by these cushions. Other balls do not hinder this search; a
/// replay decides.
Part by_itself(const SearchRequest& whole, const CushionRule& cushions);
/// Returns the part in which all balls before the last go to a place. With one object ball in the chain, the cue ball
/// does so by itself.
Part before_last(const SearchRequest& whole, const Objects::Chain& chain);
/// Returns the part in which the last ball is launched where it stands, to what is asked of it. The balls before it are
/// gone.
Part last_alone(const SearchRequest& whole, const Objects::Chain& chain);

/// A part that goes to a place, which can be moved.
class ToPlace {
 public:
  /// `pinned`: the launch speed to keep [m/s].
  ToPlace(const SearchRequest& whole, Part part, std::optional<double> pinned);
  ToPlace(const ToPlace&) = delete;
  ToPlace& operator=(const ToPlace&) = delete;

  /// Returns the request with this place, at an arrival speed [m/s]; valid until the next call. A copy keeps both.
  const SearchRequest& at(const Vec2d& place, double speed);
  const Part& part() const { return part_; }

 private:
  Part part_;
  SearchRequest request_;
};

}  // namespace bankshot::planning::propose
