// SPDX-License-Identifier: MIT
//
// A table and a physics as options: each is a name or a JSON object.
#pragma once

#include <string>
#include <string_view>

#include "bankshot/scene/scene.hpp"

namespace bankshot::service {

/// Returns `text` as JSON: an object as it is, a name as a string.
std::string as_json(const std::string& text);

/// Reads the scene. Throws BadOption, which names the option (`table` or `physics`) with `dashes` before it.
Scene read_scene_words(const std::string& table, const std::string& physics, std::string_view dashes = "");

}  // namespace bankshot::service
