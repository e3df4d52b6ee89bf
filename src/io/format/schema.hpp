// SPDX-License-Identifier: MIT
//
// Prints the format of a file as a JSON Schema (draft 2020-12) and as Markdown tables. Both are made from the table of
// keys that the readers use. A reader refuses everything that the schema refuses; it also checks geometry, which a
// schema cannot express.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bankshot::format {

/// Returns the names of the documents: "puzzle", "shot", "answer", "recording", "play".
std::span<const std::string_view> documents();

/// Returns the schema of `document`, which is one of documents().
std::string schema(std::string_view document);

/// Returns a Markdown table for each object of a document. Objects shared with the puzzle are listed with the puzzle
/// only.
std::string markdown(std::string_view document);

}  // namespace bankshot::format
