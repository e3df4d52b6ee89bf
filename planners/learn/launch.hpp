// SPDX-License-Identifier: MIT
//
// The launch of a recorded shot, for given coefficients of the physics.
#pragma once

#include <optional>

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// Plays the shot's launch with these coefficients, to its end or for `seconds` since the launch; none if that is no
/// shot.
std::optional<Trajectory> play(const Seen& seen, const Common& common, std::optional<double> seconds, Spent& work);

/// Plays the shot and stores the contacts of each track's ball. Returns false if that is no shot.
bool tell(Seen& seen, const Common& common, Spent& work);

/// Fits from the present launch, up to the window, and again if that changes what the ball meets. Returns as
/// `fit_anew`.
double fit_window(Seen& seen, const Common& common, Spent& work);

/// Fits from the present launch, from bounce to bounce up to `until` [s], which becomes the window. Returns as
/// `fit_anew`.
double fit_on(Seen& seen, const Common& common, double until, Spent& work);

/// Finds the launch that fits the samples up to `until` [s], which becomes the window. It starts from the track's first
/// samples and several spins. Returns the root mean square distance in sigmas; infinite if no launch makes a shot.
double fit_anew(Seen& seen, const Common& common, double until, Spent& work);

/// Fits from the present launch, up to the window. A little side dies before a cushion, so that nothing shows whether
/// there was any; the fit then starts from several sides too. Returns as `fit_anew`.
double fit_side(Seen& seen, const Common& common, Spent& work);

/// Continues the fit up to the window. If the launch still fits badly, former coefficients may have led it astray, and
/// it is fitted anew. Returns whether a better one was found.
bool look_again(Seen& seen, const Common& common, Spent& work);

/// Replaces a launch that bounces before the first sample, which is rare, by one that does not and fits too. Returns
/// whether it did.
bool look_for_usual(Seen& seen, const Common& common, Spent& work);

/// Finds the launch that fits the samples up to 0.25 s after the first bounce, which becomes the window. Returns as
/// `fit_anew`.
double fit_first_part(Seen& seen, const Common& common, Spent& work);

/// Moves the window on to 0.25 s after the next bounce and fits from the present launch. Returns false if the window
/// already holds everything.
bool fit_farther(Seen& seen, const Common& common, Spent& work);

}  // namespace bankshot::planning
