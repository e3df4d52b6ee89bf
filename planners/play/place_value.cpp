// SPDX-License-Identifier: MIT
#include "bankshot/plan/place_value.hpp"

#include <optional>
#include <vector>

#include "bankshot/scene/game.hpp"
#include "planners/play/next_pot.hpp"

namespace bankshot {
namespace {

/// The estimates of one puzzle.
class Values {
 public:
  explicit Values(const Puzzle& puzzle) : next_(puzzle, pockets_of(puzzle)) {
    order_ = puzzle.game ? order_of(puzzle) : PottingOrder{touched_first(puzzle.target)};
    places_ = {std::nullopt};
    for (const Ball& ball : puzzle.others) places_.emplace_back(ball.at);
  }

  PlaceValue at(const Vec2d& place) {
    places_.front() = place;
    const planning::play::NextPot::Best best = next_.best(order_, places_);
    return {best.chance, best.ball, best.pocket};
  }

 private:
  static PocketTarget pockets_of(const Puzzle& puzzle) {
    const Then* const then = then_of(puzzle.target);
    if (!then || !then->links.empty() || !pocket_of(puzzle.target))
      throw InvalidInput("/target", "a place has a value where a ball is to be potted, or in a game");
    return *pocket_of(puzzle.target);
  }

  planning::play::NextPot next_;
  PottingOrder order_{};
  std::vector<std::optional<Vec2d>> places_{};
};

}  // namespace

PlaceValue estimate_value(const Puzzle& puzzle, const Vec2d& at) { return Values(puzzle).at(at); }

ValueMap value_map(const Puzzle& puzzle, int columns, int rows) {
  Values values(puzzle);
  const StartGrid grid(puzzle, columns, rows);
  ValueMap map{grid, starts_on(puzzle, grid), {}};
  for (std::size_t i = 0; i < grid.size(); ++i)
    map.values.push_back(map.starts[i] == Start::legal ? values.at(grid.at(i)) : PlaceValue{});
  return map;
}

}  // namespace bankshot
