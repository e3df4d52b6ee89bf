// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::service {

/// An answer would be too long: a small request may ask for gigabytes, since a slow ball rolls for days.
class TooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr Range rates{1e-3, 1e3};  ///< rows per second that may be asked for

/// Returns the path of the shot as CSV with `rate` rows per second. Throws TooLong if it would have more than
/// `most_rows`.
std::string path_table(const ShotRequest& request, const Trajectory& t, double rate, double most_rows);

}  // namespace bankshot::service
