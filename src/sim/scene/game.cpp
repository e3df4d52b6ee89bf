// SPDX-License-Identifier: MIT
#include "bankshot/scene/game.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace bankshot {
namespace {

constexpr int eight_ball = 8, last_ball = 15;

/// Returns the balls by the numbers on them.
std::multimap<int, int> by_number(std::span<const Ball> others) {
  std::multimap<int, int> balls;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::string& id = others[k].id;
    int number = 0;
    const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
    if (error != std::errc() || end != id.data() + id.size())
      throw InvalidInput(fmt::format("/others/{}/id", k),
                         fmt::format("\"{}\" is no number, by which this game orders its balls", id));
    balls.emplace(number, static_cast<int>(k) + 1);
  }
  return balls;
}

}  // namespace

PottingOrder order_of(Game game, std::span<const Ball> others) {
  PottingOrder order;
  if (game == Game::rotation) {
    for (const auto& [number, ball] : by_number(others)) order.push_back({ball});
    return order;
  }
  std::vector<int> all;
  for (std::size_t k = 0; k < others.size(); ++k) all.push_back(static_cast<int>(k) + 1);
  if (!all.empty()) order.push_back(std::move(all));
  return order;
}

PottingOrder order_of_eight(Group own, std::span<const Ball> others) {
  const std::multimap<int, int> balls = by_number(others);
  const auto eight = balls.find(eight_ball);
  if (eight == balls.end()) throw InvalidInput("/others", "has no ball \"8\", which this game needs");
  std::vector<int> group;
  for (const auto& [number, ball] : balls)
    if (own == Group::solids ? number < eight_ball : number > eight_ball && number <= last_ball) group.push_back(ball);
  PottingOrder order;
  if (!group.empty()) order.push_back(std::move(group));
  order.push_back({eight->second});
  return order;
}

Group own_group(const Puzzle& puzzle) {
  const int first = order_of(puzzle).front().front();
  bool solids_left = false;
  for (const auto& [number, ball] : by_number(puzzle.others)) {
    if (ball == first && number != eight_ball) return number > eight_ball ? Group::stripes : Group::solids;
    solids_left = solids_left || number < eight_ball;
  }
  // The player is on the 8, so what is left belongs to the opponent.
  return solids_left ? Group::stripes : Group::solids;
}

void ask(Puzzle& puzzle, Game game, const PottingOrder& order) {
  puzzle.game = game;
  puzzle.target = ObjectBallTarget{order.empty() ? std::vector<int>{} : order.front(), {.target = PocketTarget{}}};
  puzzle.leave = LeaveForNext{order};
}

const PottingOrder& order_of(const Puzzle& puzzle) { return std::get<LeaveForNext>(*puzzle.leave).order; }

PottingOrder opponents_order(const Puzzle& puzzle) {
  if (puzzle.game != Game::eight) return order_of(puzzle);
  return order_of_eight(own_group(puzzle) == Group::solids ? Group::stripes : Group::solids, puzzle.others);
}

Puzzle as_safety(Puzzle puzzle) {
  const PottingOrder order = order_of(puzzle);
  puzzle.leave = LeaveAgainst{opponents_order(puzzle)};
  puzzle.target = BallTarget{.balls = order.front()};
  puzzle.game.reset();
  return puzzle;
}

PottingOrder left_of(const PottingOrder& order, std::span<const std::optional<Vec2d>> places) {
  PottingOrder left;
  for (std::vector<int> group : order) {
    std::erase_if(group, [&](int ball) { return !places[static_cast<std::size_t>(ball)]; });
    if (!group.empty()) left.push_back(std::move(group));
  }
  return left;
}

std::optional<Puzzle> next_question(const Puzzle& puzzle, std::span<const std::optional<Vec2d>> places) {
  PottingOrder order = left_of(order_of(puzzle), places);
  if (order.empty() || !places[0]) return {};
  Puzzle next = puzzle;
  next.ball.at = *places[0];
  next.in_hand.reset();
  next.settled.clear();
  next.others.clear();
  std::vector<int> new_number(places.size());
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (!places[k]) continue;
    next.others.push_back(puzzle.others[k - 1]);
    next.others.back().at = *places[k];
    new_number[k] = static_cast<int>(next.others.size());
  }
  for (std::vector<int>& group : order)
    for (int& ball : group) ball = new_number[static_cast<std::size_t>(ball)];
  ask(next, *puzzle.game, order);
  return next;
}

}  // namespace bankshot
