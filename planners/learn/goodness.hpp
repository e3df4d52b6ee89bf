// SPDX-License-Identifier: MIT
//
// How well a shot's launch and the coefficients agree with what was seen of it.
#pragma once

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// The upper one of two in the middle; 0 of none.
double median(std::vector<double> values);

/// The standard deviation of normal errors is so many times the median of their sizes.
inline constexpr double of_median = 1.4826;

/// How far seven samples of ten are off at most, over what normal errors of sigma would be; of those in the window, in
/// that quarter of each track where this is largest.
double spread(const Seen& seen, const Common& common);

/// How far the samples lie from where the ball is said to be.
struct Distances {
  std::vector<double> each{};   ///< m, of every sample of each track in order
  std::vector<char> counted{};  ///< whether it does: neither an outlier nor unexplained
  int samples = 0;              ///< that count
  int unexplained = 0;          ///< after a contact that fits do not follow
  int outliers = 0;
  double rms = 0;  ///< m, of those that count
};
Distances distances(const Seen& seen, const Common& common);

/// Standard deviation of a coordinate of what counts, in sigmas; 0 where there are no more coordinates than unknowns.
double excess(const Seen& seen, const Common& common);

/// Whether this launch cannot be the one.
bool is_off(const Seen& seen, const Common& common);

}  // namespace bankshot::planning
