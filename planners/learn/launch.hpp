// SPDX-License-Identifier: MIT
//
// How a recorded shot was launched, with the physics as it is taken to be.
#pragma once

#include <optional>

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// What the shot's launch does with these coefficients, to its end or so many seconds since the launch; none where that
/// is no shot.
std::optional<Trajectory> play(const Seen& seen, const Common& common, std::optional<double> seconds, Work& work);

/// Tells each track what its ball meets when this is played. False where that is no shot.
bool tell(Seen& seen, const Common& common, Work& work);

/// From the launch that it has, up to the window, again where that changes what the ball meets. Returns as `fit_anew`.
double fit_window(Seen& seen, const Common& common, Work& work);

/// From the launch that it has, from bounce to bounce up to `until` [s], which becomes the window. Returns as
/// `fit_anew`.
double fit_on(Seen& seen, const Common& common, double until, Work& work);

/// The launch that fits the samples up to `until` [s], which becomes the window, found from the track's first ones and
/// several spins. Returns the root mean square distance in sigmas; infinite where no launch makes a shot.
double fit_anew(Seen& seen, const Common& common, double until, Work& work);

/// From the launch that it has, up to the window. Where hardly any side is left it is gone before it meets a cushion,
/// and with it what would say that there was some: then also from some. Returns as `fit_anew`.
double fit_side(Seen& seen, const Common& common, Work& work);

/// Fits on, up to the window; a launch that does not fit well may have settled on what the coefficients were before,
/// and is looked for anew. Returns whether a better one was found.
bool look_again(Seen& seen, const Common& common, Work& work);

/// A bounce before the first sample is rare: a launch that makes one gives way to one that does not and fits too.
/// Returns whether it did.
bool look_for_usual(Seen& seen, const Common& common, Work& work);

/// The same of the samples up to 0.25 s after the first bounce, which becomes the window.
double fit_first_part(Seen& seen, const Common& common, Work& work);

/// From the launch that it has, with the window moved on to 0.25 s after the next bounce. False where it is all there
/// is.
bool fit_farther(Seen& seen, const Common& common, Work& work);

}  // namespace bankshot::planning
