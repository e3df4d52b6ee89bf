// SPDX-License-Identifier: MIT
#include "bankshot/scene/target.hpp"

namespace bankshot {

std::vector<Mark> marks_of(const Target& target, const Boundary& boundary) {
  if (const auto* point = std::get_if<PointTarget>(&target)) return {{point->at, point->within}};
  const auto& wanted = std::get<PocketTarget>(target).pocket;
  std::vector<Mark> marks;
  for (const Circle& pocket : boundary.pockets)
    if (!wanted || pocket.contact.index == *wanted) marks.push_back({pocket.centre, pocket.radius, pocket.contact});
  return marks;
}

bool is_pocket(const Target& target) { return std::holds_alternative<PocketTarget>(target); }

std::string in_words(const Target& target, const Table& table, bool rests) {
  if (!is_pocket(target)) return rests ? "to rest in the ring" : "through the ring";
  const auto& wanted = std::get<PocketTarget>(target).pocket;
  return "into " + (wanted ? table.pockets[static_cast<std::size_t>(*wanted)].name : "any pocket");
}

}  // namespace bankshot
