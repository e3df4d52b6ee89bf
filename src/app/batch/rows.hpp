// SPDX-License-Identifier: MIT
//
// The answers of a batch as a table: one row for each, with its best shot. docs/csv.md says what its columns mean.
#pragma once

#include <string>

namespace bankshot::app::batch {

/// The names of the columns, as the first line of the table.
std::string rows_header();

/// Returns the row of an answer in JSON; `line` is its number in its file, from 1.
std::string row_of(long line, const std::string& answer);

/// Writes the table of a file of answers.
void write_rows(const std::string& answers, const std::string& csv);

}  // namespace bankshot::app::batch
