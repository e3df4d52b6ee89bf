// SPDX-License-Identifier: MIT
//
// The value of a place: how likely the next ball is potted when the cue ball stands there. The value is an estimate by
// geometry, for maps and for choosing among many places. `solve` with the ball at the place gives the exact one.
#pragma once

#include <string>
#include <vector>

#include "bankshot/plan/start_map.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// The best straight pot from a place.
struct PlaceValue {
  double value = 0;  ///< probability that it is made
  int ball = 0;      ///< its ball: the k-th of `others`, from 1; 0 if no ball can be potted straight
  int pocket = -1;   ///< its pocket on the table; -1 if no ball can be potted straight
};

/// Returns the estimate for the cue ball at this place [m]. It knows the aim error of the puzzle's noise, balls in the
/// way and thin cuts; it knows no cushions, no scratches and no errors of speed. Of 60 places on pool-9ft it errs by
/// 0.05 (rms), and is 0.04 below the success of the best direct pot in the mean (tests/play/place_value_test.cpp).
/// Throws InvalidInput with the path `/target` unless the puzzle asks to pot one of some balls without combinations; a
/// game does.
PlaceValue estimate_value(const Puzzle& puzzle, const Vec2d& at);

struct ValueMap {
  StartGrid grid;
  std::vector<Start> starts;
  std::vector<PlaceValue> values;  ///< 0 if the start is not legal
};

/// Returns the estimates for a grid of places. Throws as `estimate_value` does.
ValueMap value_map(const Puzzle& puzzle, int columns, int rows);

/// Returns one CSV row per cell (x_m,y_m,status,value,ball,pocket), with a header.
std::string to_csv(const Puzzle& puzzle, const ValueMap& map);

}  // namespace bankshot
