// SPDX-License-Identifier: MIT
#include "planners/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/planner.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

/// The aims that the puzzle allows, in words.
std::string aims(const Search& s) {
  const Range aim = s.puzzle.angle.value_or(Range{0, radians(360)});
  const double to = degrees(aim.high);
  return fmt::format("{:.4g}° to {:.4g}°", degrees(aim.low), to > 360 ? to - 360 : to);
}

/// What went wrong, as the end of a sentence that begins with "it".
std::string explain(const Search& s, const Failure& f) {
  const auto cushion = [&] { return contact_name(s.puzzle.table, f.contact); };
  const Range& v = s.puzzle.speed;
  switch (f.foul) {
    case Foul::none:
    case Foul::missed:
      return "passes by the target";
    case Foul::fell_short:
      return "stops before the target";
    case Foul::wrong_cushion:
      return fmt::format("meets cushion {} out of turn", cushion());
    case Foul::extra_cushion:
      return fmt::format("meets cushion {} before the target", cushion());
    case Foul::pocketed:
      return fmt::format("falls into pocket {} first", cushion());
    case Foul::too_fast:
      return fmt::format("needs {:.4g} m/s or more, and the bound is {:.4g} m/s", f.speed, v.high);
    case Foul::too_slow:
      if (s.stop && deceleration(s.puzzle.physics) == 0) return "never stops, for the rolling friction is 0";
      return fmt::format("needs {:.4g} m/s or less, and the bound is {:.4g} m/s", f.speed, v.low);
    case Foul::too_long:
      return fmt::format("needs a longer path than a launch at {:.4g} m/s can roll", v.high);
    case Foul::outside_aim:
      break;
  }
  return fmt::format("needs an aim outside the bounds of {}", aims(s));
}

/// The reasons that candidates failed for, the most frequent first.
std::string failures(const Search& s) {
  constexpr std::size_t most_named = 3;
  std::vector<Search::Counted> by_count = s.failures;
  std::stable_sort(by_count.begin(), by_count.end(), [](const auto& a, const auto& b) { return a.times > b.times; });
  std::string out;
  for (std::size_t i = 0; i < std::min(most_named, by_count.size()); ++i)
    out += fmt::format("{}it {} ({}×)", i ? "; " : "", explain(s, by_count[i].failure), by_count[i].times);
  if (by_count.size() > most_named)
    out += fmt::format("; and {} other reason{}", by_count.size() - most_named,
                       by_count.size() > most_named + 1 ? "s" : "");
  return out.empty() ? "no path has the bounces asked" : out;
}

std::string asked_cushions(const CushionRule& c) {
  if (c.sequence) return "the cushions asked, in that order";
  if (c.min == c.max) return fmt::format("exactly {} cushion{}", c.min, c.min == 1 ? "" : "s");
  return fmt::format("{} to {} cushions", c.min, c.max);
}

/// A warning where double precision is not enough for an exact answer: the replay's miss is then rounding, too.
std::string uncertain(const Search& s, const Shot& shot) {
  const double error = tolerance::simulation_error * 0x1p-53 * shot.condition, diagonal = s.boundary.diagonal;
  if (!(error > tolerance::exact_miss * diagonal)) return "";
  return fmt::format(
      "; its condition leaves about {:.0f} of 16 digits: in exact numbers the arrival may be {:.1g} m off",
      std::max(0.0, -std::log10(error / diagonal)), error);
}

/// The softest shot of a changed puzzle.
std::optional<Shot> opened(Puzzle p) {
  p.prefer = Prefer::soft;
  constexpr long most = 30000;  // simulations: a hint must not cost more than the search
  p.budget = std::min(p.budget, most);
  const Answer a = solve(p, {.robustness = false, .suggest = false});
  return a.shots.empty() ? std::nullopt : std::optional(a.shots.front());
}

}  // namespace

std::string message(const Search& s, const Answer& a, std::size_t found) {
  std::string text;
  if (a.status == Status::solved) {
    text = s.first      ? "the first shot found, there may be better ones"
           : found == 1 ? "one shot found"
                        : fmt::format("{} distinct shots found", found);
    if (s.stopped && !s.first) text += "; the search stopped there, so others were not compared";
    if (!s.centred(a.shots.front().miss))
      text += "; nothing found reaches the target's centre, this reaches part of it";
    text += uncertain(s, a.shots.front());
    if (s.cut) text += "; the budget ended the search, so there may be better ones";
    if (s.all && !s.complete && !s.cut) text += "; there may be more: shots in a narrow range of aims can be missed";
  } else if (a.status == Status::budget) {
    text = fmt::format("no shot found within the budget of {} simulations", s.puzzle.budget);
  } else if (s.proved) {
    text = fmt::format("proved: every path with {} was tried, and {}", asked_cushions(s.puzzle.cushions), failures(s));
  } else {
    const Range& v = s.puzzle.speed;
    text = fmt::format("searched {} and aims {} with {}: {}",
                       v.fixed() ? fmt::format("the launch speed {:.4g} m/s", v.low)
                                 : fmt::format("launch speeds {:.4g} to {:.4g} m/s", v.low, v.high),
                       aims(s), asked_cushions(s.puzzle.cushions), failures(s));
  }
  if (a.status != Status::solved && !s.puzzle.cushions.sequence && s.puzzle.cushions.max > 0 && s.frozen())
    text += "; aims straight into a cushion that the ball touches were left out";
  const PointTarget* point = s.point();
  if (a.status != Status::solved && point && norm(point->at - s.puzzle.ball.at) <= point->within &&
      s.puzzle.cushions.min == 0)
    text += "; the ball starts at its target";
  if (!s.note.empty()) text += "; " + s.note;
  return text;
}

void add_nearest(Search& s, Answer& a) {
  if (a.status == Status::solved || !(s.near.launch.speed > 0)) return;
  Shot shot{.launch = s.near.launch};
  shot.launch.speed = std::clamp(shot.launch.speed, s.puzzle.speed.low, s.puzzle.speed.high);
  const auto r = replay(s, shot.launch, Goal::exactly(s, s.near.bounces), &shot.cushions);
  shot.miss = r.miss;
  shot.arrival = r.arrival;
  shot.planner = "none";
  a.nearest = Answer::Nearest{shot, explain(s, s.near.failure)};
}

std::string what_would_open(const Puzzle& puzzle) {
  constexpr double hardest = 15;  // m/s: a strong break shot
  Puzzle p = puzzle;
  if (p.speed.high < hardest && !is_ideal(p.physics)) {
    p.speed.high = hardest;
    if (const auto shot = opened(p)) return fmt::format("a launch at {:.4g} m/s would do it", shot->launch.speed);
  }
  p = puzzle;
  if (p.angle) {
    p.angle.reset();
    if (const auto shot = opened(p)) return fmt::format("an aim of {:.4g}° would do it", degrees(shot->launch.angle));
  }
  p = puzzle;
  p.cushions = {.min = 0, .max = std::min(max_cushions, std::min(puzzle.cushions.max, 4) + 1)};
  if (const auto shot = opened(p)) {
    const std::size_t n = shot->cushions.size();
    std::string names;
    for (const Contact c : shot->cushions) names += (names.empty() ? " (" : ", ") + contact_name(p.table, c);
    return fmt::format("there is a shot with {} cushion{}{}", n, n == 1 ? "" : "s", names.empty() ? "" : names + ")");
  }
  if (is_straight(puzzle.physics) || puzzle.spin_range) return "";
  p = puzzle;
  for (const double side : {0.5, -0.5}) {
    p.spin.side = side;
    if (opened(p)) return fmt::format("side spin {} would do it", side);
  }
  return "";
}

}  // namespace bankshot::planning
