// SPDX-License-Identifier: MIT
#include "bankshot/scene/scene.hpp"

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {
namespace {

Physics physics_of(std::string_view name, const TablePreset& preset) {
  if (name == "ideal") return ideal_physics();
  if (name == "rolling") return rolling_physics();
  if (name == "spin") return spin_physics(preset.body, preset.nose());
  throw InvalidInput("/physics", "there is no physics \"" + std::string(name) + "\"");
}

}  // namespace

Scene preset_scene(std::string_view table, std::string_view physics) {
  const TablePreset* const preset = find_table_preset(table);
  if (!preset) throw InvalidInput("/table", "there is no table \"" + std::string(table) + "\"");
  return {make_table(*preset), physics_of(physics, *preset), {.body = preset->body}};
}

}  // namespace bankshot
