// SPDX-License-Identifier: MIT
#include "bankshot/scene/target.hpp"

namespace bankshot {

std::vector<Mark> marks_of(const Target& target, const Boundary& boundary) {
  if (const auto* point = std::get_if<PointTarget>(&target)) return {{point->at, point->within}};
  const auto& wanted = std::get<PocketTarget>(target).pocket;
  std::vector<Mark> marks;
  for (const Circle& pocket : boundary.pockets) {
    if (wanted && pocket.contact.index != *wanted) continue;
    for (const Opening& opening : openings(boundary, pocket))
      marks.push_back({pocket.centre, pocket.radius, pocket.contact, opening});
  }
  return marks;
}

double Mark::apart(const Vec2d& arrived) const {
  return captures() ? opening.distance(arrived - at) : norm(arrived - at);
}

bool is_pocket(const Target& target) { return std::holds_alternative<PocketTarget>(target); }

std::string in_words(const Target& target, const Table& table, bool rests) {
  if (!is_pocket(target)) return rests ? "to rest in the ring" : "through the ring";
  const auto& wanted = std::get<PocketTarget>(target).pocket;
  return "into " + (wanted ? table.pockets[static_cast<std::size_t>(*wanted)].name : "any pocket");
}

}  // namespace bankshot
