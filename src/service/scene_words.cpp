// SPDX-License-Identifier: MIT
#include "service/scene_words.hpp"

#include <fmt/format.h>

#include "bankshot/scene/json.hpp"
#include "io/json/document.hpp"
#include "service/options.hpp"

namespace bankshot::service {

std::string as_json(const std::string& text) { return text.starts_with('{') ? text : write_json(Json(text)); }

Scene read_scene_words(const std::string& table, const std::string& physics, std::string_view dashes) {
  try {
    return read_scene(as_json(table), as_json(physics));
  } catch (const InvalidInput& e) {
    throw BadOption(e.path.empty() ? fmt::format("{0}table or {0}physics: {1}", dashes, e.what())
                                   : fmt::format("{}{}: {}", dashes, e.path.substr(1), e.what()));
  }
}

}  // namespace bankshot::service
