// SPDX-License-Identifier: MIT
//
// JSON text to a tree that lost nothing: duplicate keys and numbers no double can hold are errors,
// with the line they are on. Private to the readers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace bankshot {

using Json = nlohmann::ordered_json;

/// Throws InvalidInput (path "", line set). `id` receives the text of the top-level "id" as it is
/// written, so that 1.0 does not come back as 1; it stays empty without.
Json parse_document(std::string_view text, std::string* id = nullptr);

/// The value as JSON text with the shortest decimals that read back to the same doubles.
std::string write_json(const Json& value);
/// An object whose first key is "id", with that JSON text as it stands; none when `id` is empty.
std::string write_json(const std::string& id, const Json& object);

/// A value for an error message: its JSON text, cut to a readable length.
std::string quote(const Json& value);

/// A key for the path of an error message: without quotes, on one line, cut to a readable length.
std::string quote_key(const std::string& key);

/// The top-level "id" of text that may be no JSON further on; empty when it cannot be told.
std::string find_id(std::string_view text);

}  // namespace bankshot
