// SPDX-License-Identifier: MIT
#include "planners/what_would_open.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

/// Solves changed puzzles, until a shot of one is a shot as asked.
class Search {
 public:
  Search(const Solve& solve, const IsAsked& is_asked) : solve_(solve), is_asked_(is_asked) {}

  /// Returns the softest shot of a changed puzzle.
  std::optional<Shot> opened(Puzzle p) {
    if (over_) return {};
    p.prefer = Prefer::soft;
    p.budget = std::min(budget_of(p), settings::hints::most_simulations);
    Answer a = solve_(p);
    if (a.shots.empty()) return {};
    over_ = is_asked_(a.shots.front());
    return over_ ? std::nullopt : std::optional(std::move(a.shots.front()));
  }
  bool over() const { return over_; }

 private:
  const Solve& solve_;
  const IsAsked& is_asked_;
  bool over_ = false;
};

/// Tries launches as fast as a strong break, or as slow as any.
std::string of_speed(const Puzzle& puzzle, Search& search) {
  const Range& v = puzzle.speed;
  const double fastest = std::max(v.high, settings::fastest_start), slowest = std::min(v.low, Puzzle{}.speed.low);
  if (is_ideal(puzzle.physics)) return "";
  for (const Range wider : {Range{v.low, fastest}, Range{slowest, v.high}}) {
    if (wider.low == v.low && wider.high == v.high) continue;
    Puzzle p = puzzle;
    p.speed = wider;
    if (v.fixed()) p.arrive = Range{0, fastest};  // the launch speed is no longer fixed, so the arrival may be anything
    const auto shot = search.opened(p);
    if (!shot || v.contains(shot->launch.speed)) continue;
    const double speed = shot->launch.speed;
    return fmt::format("a launch at {:.4g} m/s would do it, and the bound is {:.4g} m/s", speed,
                       speed > v.high ? v.high : v.low);
  }
  return "";
}

/// Returns the puzzle without one ball, or without all; balls that the target names stay.
Puzzle without(const Puzzle& puzzle, std::optional<std::size_t> taken) {
  Puzzle p = puzzle;
  const std::vector<int*> targets = balls_of(p.target);
  p.others.clear();
  std::vector<int> renumbered(puzzle.others.size() + 1);
  for (std::size_t i = 0; i < puzzle.others.size(); ++i) {
    const bool named = std::ranges::count(targets, static_cast<int>(i) + 1, [](const int* k) { return *k; }) > 0;
    if (!named && (!taken || *taken == i)) continue;
    p.others.push_back(puzzle.others[i]);
    renumbered[i + 1] = static_cast<int>(p.others.size());
  }
  for (int* const ball : targets) *ball = renumbered[static_cast<std::size_t>(*ball)];
  return p;
}

/// Tries without each of the other balls, if there is a shot without all of them.
std::string of_balls(const Puzzle& puzzle, Search& search) {
  const Puzzle none = without(puzzle, {});
  if (none.others.size() == puzzle.others.size() || !search.opened(none)) return "";
  for (std::size_t i = 0; i < puzzle.others.size(); ++i) {
    const Puzzle p = without(puzzle, i);
    if (p.others.size() < puzzle.others.size() && search.opened(p))
      return fmt::format("without {} there is a shot", contact_name(puzzle, Contact::ball(1 + static_cast<int>(i))));
  }
  return search.over() ? "" : "without the other balls there is a shot";
}

}  // namespace

std::string what_would_open(const Puzzle& puzzle, const Solve& solve, const IsAsked& is_asked) {
  Search search(solve, is_asked);
  if (std::string text = of_balls(puzzle, search); !text.empty()) return text;
  if (std::string text = of_speed(puzzle, search); !text.empty()) return text;
  Puzzle p = puzzle;
  if (p.angle) {
    p.angle.reset();
    if (const auto shot = search.opened(p))
      return fmt::format("an aim of {:.4g}° would do it", degrees(shot->launch.angle));
  }
  p = puzzle;
  p.cushions = {.min = 0,
                .max = std::min(max_cushions, std::min(puzzle.cushions.max, settings::hints::most_cushions) + 1)};
  if (const auto shot = search.opened(p)) {
    const std::size_t n = shot->path.cushions.size();
    std::string names;
    for (const Contact c : shot->path.cushions) names += (names.empty() ? " (" : ", ") + contact_name(p.table, c);
    return fmt::format("there is a shot with {} cushion{}{}", n, n == 1 ? "" : "s", names.empty() ? "" : names + ")");
  }
  if (!carries_spin(puzzle.physics) || puzzle.spin_range) return "";
  p = puzzle;
  for (const double side : settings::hints::side_spins) {
    p.spin.side = side;
    if (search.opened(p)) return fmt::format("side spin {} would do it", side);
  }
  return "";
}

}  // namespace bankshot::planning
