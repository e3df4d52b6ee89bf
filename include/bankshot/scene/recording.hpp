// SPDX-License-Identifier: MIT
//
// A recording of one real shot: the scene, observed positions of its balls over time, and where they came to rest.
// docs/recordings.md explains how to convert the output of trackers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// One observation of a ball's centre.
struct Sample {
  double time;  ///< s; by the recording's own clock
  Vec2d at;     ///< m
};

struct Track {
  int ball = 0;                   ///< 0 is the cue ball
  std::vector<Sample> samples{};  ///< in increasing time; gaps are allowed
  std::optional<Vec2d> rest{};    ///< where it came to rest [m]
};

struct Recording {
  ShotRequest scene{};        ///< its physics and launch are the start values of a fit
  bool launch_given = false;  ///< otherwise `scene.launch` and `scene.spin` have no meaning
  std::vector<Track> tracks{};
  std::optional<double> sigma{};                   ///< m; standard deviation of one coordinate of one sample
  std::optional<std::vector<Contact>> cushions{};  ///< observed contacts of the cue ball, in order
};

/// Reads a recording. Throws InvalidInput with the path of an impossible sample: time goes back, or a ball jumps,
/// leaves the table or is struck a second time.
Recording read_recording(std::string_view text);

/// Returns the recording as one line of JSON. It reads back to the same recording except for the coefficients of the
/// physics, which are not written.
std::string write_recording(const Recording& recording);

}  // namespace bankshot
