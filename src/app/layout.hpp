// SPDX-License-Identifier: MIT
//
// Layouts: puzzles without target.
#pragma once

#include <optional>
#include <string>

#include "io/json/reader.hpp"

namespace bankshot::app {

/// Returns a layout in JSON as a puzzle with this target; if none is given, with its own, or else with the game
/// `rotation`.
inline std::string as_puzzle(const std::string& text, const std::optional<Json>& target = std::nullopt) {
  Json layout = parse_document(text);
  if (!layout.is_object() || (layout.contains("target") && !target)) return text;
  layout["target"] = target.value_or(Json{{"game", "rotation"}});
  return layout.dump();
}

}  // namespace bankshot::app
