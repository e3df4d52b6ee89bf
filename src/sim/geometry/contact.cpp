// SPDX-License-Identifier: MIT
#include "bankshot/geometry/contact.hpp"

#include <algorithm>

#include "bankshot/scene/table.hpp"

namespace bankshot {

std::string contact_name(const Table& table, Contact contact) {
  const auto i = static_cast<std::size_t>(contact.index);
  switch (contact.kind) {
    case ContactKind::rail:
      return table.cushions[i];
    case ContactKind::vertex:
      return "v" + std::to_string(i);
    case ContactKind::pocket:
      return table.pockets[i].name;
    case ContactKind::jaw:
      return table.pockets[static_cast<std::size_t>(contact.jaw_pocket())].name;
    case ContactKind::ball:
      return "ball " + std::to_string(i);
    case ContactKind::none:
      break;
  }
  return "none";
}

std::optional<Contact> find_cushion(const Table& table, std::string_view name) {
  const auto& names = table.cushions;
  const auto it = std::find(names.begin(), names.end(), name);
  if (it != names.end()) return Contact::rail(static_cast<int>(it - names.begin()));
  if (!name.starts_with('v')) return {};
  for (int i = 0; i < static_cast<int>(table.vertices.size()); ++i)
    if (contact_name(table, Contact::vertex(i)) == name) return Contact::vertex(i);
  return {};
}

}  // namespace bankshot
