// SPDX-License-Identifier: MIT
#include "sim/geometry/mouth.hpp"

namespace bankshot {

std::array<Vec2d, 6> mouth(const Table& table, const JawPieces& jaws) {
  const auto on_rail = [&](int rail, double s) {
    const auto i = static_cast<std::size_t>(rail);
    const Vec2d from = table.vertices[i], way = table.vertices[(i + 1) % table.vertices.size()] - from;
    return from + way * (s / norm(way));
  };
  const auto& [before, after] = jaws.facings;
  return {on_rail(jaws.breaks.front().rail, jaws.breaks.front().begin), before.from, before.to, after.from, after.to,
          on_rail(jaws.breaks.back().rail, jaws.breaks.back().end)};
}

}  // namespace bankshot
