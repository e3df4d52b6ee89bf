// SPDX-License-Identifier: MIT
#include "planners/play/in_hand.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bankshot/scene/in_hand.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/play/next_pot.hpp"
#include "planners/play/settings.hpp"

namespace bankshot::planning::play {
namespace {

using namespace settings::in_hand;

class Search {
 public:
  Search(const Puzzle& puzzle, const SolveOptions& options)
      : puzzle_(puzzle), boundary_(puzzle.table, puzzle.ball.body), diagonal_(puzzle.table.diagonal()) {
    options_.planner = options.planner;
    options_.suggest = false;
    options_.cancelled = options.cancelled;
  }

  /// Returns the best place; that of the puzzle if no place has a shot.
  Vec2d best_place() {
    for (const Vec2d& at : starts()) look(at);
    if (!best_) return puzzle_.ball.at;
    for (double step = first_step * diagonal_; step > last_step * diagonal_;) {
      const Vec2d from = at_;
      for (const Vec2d& way : {Vec2d{1, 0}, Vec2d{-1, 0}, Vec2d{0, 1}, Vec2d{0, -1}})
        if (look(from + way * step)) break;
      if (at_ == from) step /= 2;
    }
    return at_;
  }
  const Answer& spent() const { return spent_; }

 private:
  /// Returns places far from each other, those of the surest pots first.
  std::vector<Vec2d> starts() const {
    std::vector<std::pair<double, Vec2d>> rated;
    const ObjectBallTarget* const sends = std::get_if<ObjectBallTarget>(&puzzle_.target);
    const NextPot pot(puzzle_);
    std::vector<std::optional<Vec2d>> balls(puzzle_.others.size() + 1);
    for (std::size_t k = 0; k < puzzle_.others.size(); ++k) balls[k + 1] = puzzle_.others[k].at;
    for (const Vec2d& at : free_places(puzzle_, grid * diagonal_)) {
      balls[0] = at;
      rated.emplace_back(sends ? pot.best({sends->balls}, balls).forgives : 0, at);
    }
    std::ranges::stable_sort(rated, std::greater{}, [](const auto& place) { return place.first; });
    std::vector<Vec2d> chosen;
    for (double apart = farthest_apart * diagonal_; chosen.size() < starts_at_most && apart > grid * diagonal_;
         apart /= 2)
      for (const auto& place : rated) {
        if (chosen.size() == starts_at_most) break;
        const Vec2d at = place.second;
        if (std::ranges::all_of(chosen, [&](const Vec2d& other) { return norm(other - at) >= apart; }))
          chosen.push_back(at);
      }
    return chosen;
  }

  /// Solves the puzzle from a place; returns whether it is better than from any before.
  bool look(const Vec2d& at) {
    if (!may_place(puzzle_, boundary_, at)) return false;
    Puzzle from_here = placed(puzzle_, at);
    from_here.game.reset();
    Answer a = solve(from_here, options_);
    spent_.add_cost(a);
    if (a.shots.empty()) return false;
    Shot& shot = a.shots.front();
    if (shot.robustness.value && may_double_hit(from_here, shot)) *shot.robustness.value -= double_hit;
    if (best_ && !comes_before(puzzle_, shot, *best_)) return false;
    best_ = std::move(shot);
    at_ = at;
    return true;
  }

  const Puzzle& puzzle_;
  SolveOptions options_;
  Boundary boundary_;
  double diagonal_;
  std::optional<Shot> best_{};
  Vec2d at_{};
  Answer spent_{};
};

}  // namespace

Answer solve_in_hand(const Puzzle& puzzle, const SolveOptions& options) {
  Search search(puzzle, options);
  const Vec2d at = search.best_place();
  Answer a = solve(placed(puzzle, at), options);
  for (Shot& shot : a.shots) shot.placed = at;
  a.add_cost(search.spent());
  return a;
}

}  // namespace bankshot::planning::play
