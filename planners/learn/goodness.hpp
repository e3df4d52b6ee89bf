// SPDX-License-Identifier: MIT
//
// Measures of how well a shot's launch and the coefficients agree with the observations.
#pragma once

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// Returns the median, the upper one of two in the middle; 0 for no values.
double median(std::vector<double> values);

/// Standard deviation of normal errors over the median of their absolute values.
inline constexpr double of_median = 1.4826;

/// Returns the 70 % quantile of coordinate errors, divided by that of normal errors of sigma. It is the largest over
/// the quarters of each track, within the window.
double spread(const Seen& seen, const Common& common);

/// Distances of the samples from the computed path.
struct Distances {
  std::vector<double> each{};   ///< m, of every sample of each track in order
  std::vector<char> counted{};  ///< whether the sample counts: it is neither an outlier nor unexplained
  int samples = 0;              ///< number of samples that count
  int unexplained = 0;          ///< samples after a contact that fits do not follow
  int outliers = 0;
  double rms = 0;  ///< m, of those that count
};
Distances distances(const Seen& seen, const Common& common);

/// Returns the standard deviation of a coordinate of samples that count, in sigmas; 0 if there are no more coordinates
/// than unknowns.
double excess(const Seen& seen, const Common& common);

/// Returns whether the launch fits too badly to be the right one.
bool is_off(const Seen& seen, const Common& common);

}  // namespace bankshot::planning
