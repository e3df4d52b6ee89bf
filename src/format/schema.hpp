// SPDX-License-Identifier: MIT
//
// The format of a file as a JSON Schema (draft 2020-12) and as tables for people, both made from the table of keys that
// the readers ask. What a schema refuses, a reader refuses too; a reader also knows geometry, which no schema can say.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bankshot::format {

/// "puzzle", "shot", "answer", "recording".
std::span<const std::string_view> documents();

/// `document` is one of documents().
std::string schema(std::string_view document);

/// A table in Markdown for each of its objects; those that a puzzle has too stand with the puzzle alone.
std::string markdown(std::string_view document);

}  // namespace bankshot::format
