// SPDX-License-Identifier: MIT
//
// bankshot map: from where on the table can this shot be made?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/gzip.hpp"
#include "app/layout.hpp"
#include "app/option_checks.hpp"
#include "app/picture.hpp"
#include "bankshot/draw/map.hpp"
#include "bankshot/plan/place_value.hpp"
#include "bankshot/scene/json.hpp"
#include "io/answer/words.hpp"
#include "service/options.hpp"
#include "service/start_map.hpp"

namespace bankshot::app::map {
namespace {

struct Arguments {
  std::string file;
  std::array<int, 2> grid{};
  std::vector<std::string> out;
  long budget = -1;
  bool no_robustness = false, value = false;
  Theme theme = Theme::light;
};

std::string summary(const StartMap& map) {
  std::array<long, 5> of_start{};
  std::array<long, 4> of_status{};
  const Shot *slowest = nullptr, *safest = nullptr;
  std::size_t slowest_at = 0, safest_at = 0;
  for (std::size_t i = 0; i < map.starts.size(); ++i) {
    ++of_start[static_cast<std::size_t>(map.starts[i])];
    if (map.starts[i] != Start::legal) continue;
    ++of_status[static_cast<std::size_t>(map.answers[i].status)];
    if (map.answers[i].shots.empty()) continue;
    const Shot& s = map.answers[i].shots.front();
    if (!slowest || s.launch.speed < slowest->launch.speed) slowest = &s, slowest_at = i;
    if (s.robustness.success && (!safest || *s.robustness.success > *safest->robustness.success))
      safest = &s, safest_at = i;
  }
  const auto place = [&](std::size_t i) { return fmt::format("({:.3f}, {:.3f})", map.grid.at(i).x, map.grid.at(i).y); };
  std::string out = fmt::format(
      "{} starts: {} with a shot, {} without, {} ran out of budget; {} lie in a cushion, {} in a pocket, {}{} at the "
      "target\n",
      map.starts.size(), of_status[0], of_status[1], of_status[2], of_start[1], of_start[2],
      of_start[3] > 0 ? fmt::format("{} in another ball, ", of_start[3]) : "", of_start[4]);
  if (slowest) out += fmt::format("slowest: {:.4g} m/s from {}\n", slowest->launch.speed, place(slowest_at));
  if (safest) out += fmt::format("most robust: {} from {}\n", success_words(*safest), place(safest_at));
  return out;
}

/// Estimates the value of each start.
int run_value(const Arguments& a, const Puzzle& puzzle) {
  const ValueMap map = value_map(puzzle, a.grid[0], a.grid[1]);
  write_outputs(
      a.out, [&] { return to_csv(puzzle, map); }, [&] { return draw(puzzle, map, a.theme); });
  const auto best = std::ranges::max_element(map.values, {}, &PlaceValue::value);
  if (best->pocket < 0) {
    print("no ball can be potted straight from any of these starts\n");
    return nothing_solved;
  }
  const Vec2d at = map.grid.at(static_cast<std::size_t>(best - map.values.begin()));
  const auto legal = std::ranges::count(map.starts, Start::legal);
  print(
      fmt::format("{} starts, {} of them legal; the best straight pot is estimated for each\n"
                  "best: ({:.3f}, {:.3f}), ball \"{}\" into {}, {}\n",
                  map.starts.size(), legal, at.x, at.y, puzzle.others[static_cast<std::size_t>(best->ball) - 1].id,
                  contact_name(puzzle.table, Contact::pocket(best->pocket)), percent_words(best->value)));
  return done;
}

int run(const Arguments& a) {
  const std::string text = read_file(a.file);
  try {
    Puzzle puzzle = read_puzzle(a.value ? as_puzzle(text) : text);
    if (a.budget >= 0) puzzle.budget = a.budget;
    for (const std::string& path : a.out) write_file(path, "");
    if (a.value) return run_value(a, puzzle);
    const StartMap map = service::start_map(puzzle, a.grid[0], a.grid[1], {.robustness = !a.no_robustness});
    write_outputs(
        a.out, [&] { return to_csv(puzzle, map); }, [&] { return draw(puzzle, map, a.theme); });
    print(summary(map));
    return std::any_of(map.answers.begin(), map.answers.end(),
                       [](const Answer& found) { return found.status == Status::solved; })
               ? done
               : nothing_solved;
  } catch (const InvalidInput& e) {
    std::cerr << complaint(a.file, e) << '\n';
    return bad_input;
  }
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  constexpr int most = 10000;  // columns or rows
  CLI::App* command = app.add_subcommand("map", "Show from where on the table a shot can be made");
  command
      ->add_option("puzzle", a->file, "A puzzle in JSON, with its ball anywhere on the table; - reads standard input")
      ->required();
  command->add_option("--grid", a->grid, "Columns and rows of starts")->required()->check(CLI::Range(1, most));
  add_output_option(*command, a->out, "a heat map");
  command->add_option("--budget", a->budget, "The most simulations to spend on a start")->check(service::whole_number);
  add_theme_flag(*command, a->theme);
  command->add_flag("--no-robustness", a->no_robustness, "Leave out margin and success");
  command->add_flag(
      "--value", a->value,
      "Estimate how likely the best straight pot is from each start, without a search; a layout without target is "
      "played as rotation");
  explain(
      *command,
      "The grid covers all places of the ball's centre; each start is the middle of a cell. Starts in a cushion, in a\n"
      "pocket or already at the target are left out and counted.",
      {{"bankshot map puzzle.json --grid 40 20 -o map.svg", "a picture"},
       {"bankshot map puzzle.json --grid 8 4 -o map.csv -o map.svg", "a table and a picture"},
       {"bankshot map rack.json --value --grid 120 60 -o value.svg", "a layout: where the cue ball would stand well"}},
      "0 done; 1 no start has a shot; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::map
