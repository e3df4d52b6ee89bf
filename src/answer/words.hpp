// SPDX-License-Identifier: MIT
//
// What a player is told of a shot, in words: the rows of the program's text and the captions of its pictures.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/plan/answer.hpp"

namespace bankshot {

struct Row {
  std::string_view what;
  std::string text;
};

/// "exact", "0.2 mm", "20 mm", "1.4 m": `metres` on a table of this size; exact is below its millionth part.
std::string distance_words(double metres, const Table& table);

/// Of a shot with success: "87 %"; "over 99 %" where something breaks it, "under 1 %" where it can be made.
std::string success_words(const Shot& shot);

/// Of a ball's centre: "0.31 m from the left rail, 0.22 m from the bottom rail", by the nearer rails; on a polygon its
/// coordinates.
std::string place_words(const Table& table, const Vec2d& at);

/// The nearest miss: its launch, how far off, and why.
std::string nearest_words(const Answer::Nearest& nearest, const Table& table);

/// Whether the line of aim runs into this pocket.
bool aims_into(const ShotRequest& shot, const Pocket& pocket);

/// The diamond that the line of aim crosses (sights.hpp), or how it passes the pocket that it runs into.
std::string aim_words(const ShotRequest& shot, const Pocket* straight_into = nullptr);

/// Its name, m/s, miles an hour, and how many lags that is: a lag is the speed that brings a ball from the head string
/// to the foot cushion and back to the head cushion.
std::string speed_words(const ShotRequest& shot);

/// Where the tip meets the ball, and how the cue is raised; warns beyond the miscue limit.
std::string tip_words(const ShotRequest& shot);

/// "by top, right into bottom-middle"
std::string title_words(const Puzzle& puzzle, const Shot& shot);

/// "0.125 degrees of aim and 0.075 m/s of speed"
std::string noise_words(const Noise& noise);
/// "a good league player whose standard errors are 0.2 degrees of aim and 5 % of speed"
std::string player_words(const Noise& noise);

/// The row that stands on a line of its own.
inline constexpr std::string_view scratch_row = "SCRATCH";

/// Everything, most wanted first.
std::vector<Row> rows_of(const Puzzle& puzzle, const Shot& shot);

}  // namespace bankshot
