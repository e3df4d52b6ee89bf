// SPDX-License-Identifier: MIT
//
// Describes shots in words for a player: the rows of the program's text and the captions of its pictures.
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

/// Returns a distance as text: "exact", "0.2 mm", "20 mm", "1.4 m". Up to a millionth of the table's diagonal is exact.
std::string distance_words(double metres, const Table& table);

/// Returns the success of a shot, such as "87 %". Near the ends it returns "over 99 %" if the shot can fail, and
/// "under 1 %" if it can be made.
std::string success_words(const Shot& shot);
/// Returns a probability below 1 in words: "over 99 %", "41 %".
std::string percent_words(double probability);

/// Returns the position of a ball's centre, measured from the nearer rails: "0.31 m from the left rail, 0.22 m from the
/// bottom rail". On a polygon it returns the coordinates.
std::string place_words(const Table& table, const Vec2d& at);

/// Describes the nearest miss: its launch, its distance from the target, and the failure reason.
std::string nearest_words(const Answer::Nearest& nearest, const Table& table);

/// Returns the title of a shot, such as "By top, right into bottom-middle".
std::string title_words(const Puzzle& puzzle, const Shot& shot);

/// The label of the scratch row, which is written without column alignment.
inline constexpr std::string_view scratch_row = "SCRATCH";

/// Returns all rows about a shot, the most important first.
std::vector<Row> rows_of(const Puzzle& puzzle, const Shot& shot);

/// Returns these rows and, after them, those about what is planned after the shot. The planned next pot takes the place
/// of the estimate for it. `plan`: null if there is none.
std::vector<Row> rows_of(const Puzzle& puzzle, const Shot& shot, const Plan* plan);

}  // namespace bankshot
