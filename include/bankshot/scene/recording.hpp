// SPDX-License-Identifier: MIT
//
// What was seen of one real shot: a scene, where its balls were at which times, where they came to rest.
// docs/recordings.md says how to get one from what trackers write.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// Where a ball was seen, its centre.
struct Sample {
  double time;  ///< s, by the recording's own clock
  Vec2d at;     ///< m
};

struct Track {
  int ball = 0;                   ///< 0 is the one that is struck
  std::vector<Sample> samples{};  ///< later and later; gaps may lie between them
  std::optional<Vec2d> rest{};    ///< where it came to rest [m]
};

struct Recording {
  ShotRequest scene{};        ///< physics and launch: what a fit starts from
  bool launch_given = false;  ///< else `scene.launch` and `scene.spin` say nothing
  std::vector<Track> tracks{};
  std::optional<double> sigma{};                   ///< m, standard deviation of one coordinate of one sample
  std::optional<std::vector<Contact>> cushions{};  ///< that the struck ball was seen to meet, in order
};

/// Throws InvalidInput, with the path of the sample that cannot be: a time that goes back, a ball that jumps, that
/// leaves the table, or that was struck a second time.
Recording read_recording(std::string_view text);

/// The recording as one line of JSON that reads back to it, but for the coefficients of its physics, which are not
/// told.
std::string write_recording(const Recording& recording);

}  // namespace bankshot
