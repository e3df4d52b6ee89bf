// SPDX-License-Identifier: MIT
//
// Parts of a shot as puzzles of their own: a chain is searched for piece by piece, and the pieces put together.
#pragma once

#include <optional>
#include <vector>

#include "planners/search_request.hpp"

namespace bankshot::planning::propose {

/// A puzzle of some of the balls, and which of the whole its numbers stand for.
struct Part {
  Puzzle puzzle;
  std::vector<int> numbers;

  int whole(int ball) const { return numbers[static_cast<std::size_t>(ball)]; }
  Route whole(const Route& route) const;
};

/// The cue ball, to a place, by these cushions. Other balls hinder no such search; a replay decides.
Part by_itself(const SearchRequest& whole, const CushionRule& cushions);
/// All balls before the last, to a place: with one ball in the chain the struck one by itself.
Part before_last(const SearchRequest& whole, const Objects::Chain& chain);
/// The last ball as if it were launched where it stands, to what is asked of it; those before it are gone.
Part last_alone(const SearchRequest& whole, const Objects::Chain& chain);

/// How a part reaches a place, which can be moved.
class ToPlace {
 public:
  /// `pinned`: at this launch speed.
  ToPlace(const SearchRequest& whole, Part part, std::optional<double> pinned);
  ToPlace(const ToPlace&) = delete;
  ToPlace& operator=(const ToPlace&) = delete;

  /// Returns the request with this place; valid until the next call. A copy keeps the place.
  const SearchRequest& at(const Vec2d& place);
  /// The same at a speed.
  const SearchRequest& at(const Vec2d& place, double speed);
  const Part& part() const { return part_; }

 private:
  Part part_;
  SearchRequest request_;
  double usual_;  ///< m/s
};

}  // namespace bankshot::planning::propose
