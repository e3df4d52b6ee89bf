// SPDX-License-Identifier: MIT
//
// How a recorded shot was launched, with the physics as it is taken to be.
#pragma once

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// What all shots have in common: coefficients by name, in the physics they belong to.
struct Common {
  Physics base;
  std::vector<std::string> names;
  std::vector<double> values;

  /// The laws with these values.
  Physics physics() const;
};

struct Work {
  long simulations = 0, restarts = 0;
};

/// Simulates what the shot's launch says and tells each track what it meets. False where that is no shot.
bool tell(Seen& seen, const Common& common, Work& work);

/// How far seven samples of ten are off at most, over what normal errors of sigma would be; of those in the window, in
/// that quarter of each track where this is largest.
double spread(const Seen& seen, const Common& common);

/// Root mean square distance of what counts, in sigmas.
double excess(const Seen& seen, const Common& common);

/// Whether this launch cannot be the one.
bool is_off(const Seen& seen, const Common& common);

/// The launch that fits the samples up to `until` [s], which becomes the window, found from the track's first ones and
/// several spins. Returns the root mean square distance in sigmas; infinite where no launch makes a shot.
double fit_anew(Seen& seen, const Common& common, double until, Work& work);

/// Fits on, up to the window; a launch that does not fit well may have settled on what the coefficients were before,
/// and is looked for anew. Returns whether a better one was found.
bool look_again(Seen& seen, const Common& common, Work& work);

/// The same of the samples up to 0.25 s after the first bounce, which becomes the window.
double fit_first_part(Seen& seen, const Common& common, Work& work);

/// From the launch that it has, with the window moved on to 0.25 s after the next bounce. False where it is all there
/// is.
bool fit_farther(Seen& seen, const Common& common, Work& work);

}  // namespace bankshot::planning
