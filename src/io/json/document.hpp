// SPDX-License-Identifier: MIT
//
// Parses JSON text to a tree without loss: duplicate keys and numbers beyond the range of a double are
// errors. Private to the readers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace bankshot {

using Json = nlohmann::ordered_json;

/// Parses a document. Throws InvalidInput. For text that is not JSON, its path is "" and its line is set; for a
/// duplicate key, its path is that of the key. The argument `id` receives the text of the top-level "id" as written, so
/// that 1.0 does not come back as 1. It stays empty if there is none.
Json parse_document(std::string_view text, std::string* id = nullptr);

/// Returns the value as JSON text, with the shortest decimals that read back to the same doubles.
std::string write_json(const Json& value);
/// Returns an object as JSON text whose first key is "id" with the given JSON text; no such key if `id` is empty.
std::string write_json(const std::string& id, const Json& object);

/// Returns a value for an error message: its JSON text, cut to a readable length.
std::string quote(const Json& value);

/// Returns a key for the path of an error message: without quotes, on one line, cut to a readable length.
std::string quote_key(const std::string& key);

/// Returns the top-level "id" of text that may be invalid after it; empty if it is missing or ambiguous.
std::string find_id(std::string_view text);

}  // namespace bankshot
