// SPDX-License-Identifier: MIT
//
// A table and a physics as words of the command line: a name each, or the JSON of an object.
#pragma once

#include <string>
#include <string_view>

#include "bankshot/scene/scene.hpp"

namespace bankshot::app {

/// As JSON.
std::string as_json(const std::string& text);

/// Throws FileError, which names the word: `table` and `physics`, with `dashes` before it.
Scene read_scene_flags(const std::string& table, const std::string& physics, std::string_view dashes = "");

}  // namespace bankshot::app
