// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "json/reader.hpp"

namespace bankshot::app {
namespace {

struct Arguments {
  std::string file = "-", svg;
  SolveOptions options;
  long budget = -1;
  bool json = false, no_timing = false, no_robustness = false;
};

/// A mistyped planner is a usage error, told before any input is read.
void check_planner(const std::string& wanted) {
  std::vector<std::string_view> names;
  for (const PlannerInfo& p : planners()) names.push_back(p.name);
  if (std::find(names.begin(), names.end(), wanted) == names.end())
    throw CLI::ValidationError("--planner", quote(wanted) + " is no planner" + known_words(wanted, names));
}

int list_planners() {
  for (const PlannerInfo& p : planners()) print(fmt::format("{:<14}{}\n", p.name, p.summary));
  return done;
}

int invalid(const Arguments& a, const std::string& text, const InvalidInput& e) {
  std::cerr << complaint(a.file, e) << '\n';
  if (a.json) print(to_json(invalid_answer(read_id(text), e)) + "\n");
  return bad_input;
}

int run(Arguments a) {
  if (a.options.planner == "list") return list_planners();
  check_planner(a.options.planner);
  const std::string text = read_file(a.file);
  try {
    Puzzle puzzle = read_puzzle(text);
    if (a.budget >= 0) puzzle.budget = a.budget;
    a.options.robustness = !a.no_robustness;
    const Answer answer = solve(puzzle, a.options);
    print(a.json ? to_json(puzzle, answer, !a.no_timing) + "\n" : to_text(puzzle, answer));
    if (!a.svg.empty()) write_file(a.svg, draw(puzzle, answer));
    return answer.status == Status::solved ? done : nothing_solved;
  } catch (const InvalidInput& e) {
    return invalid(a, text, e);
  }
}

}  // namespace

Run add_solve(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("solve", "Find the aim and the speed for a puzzle");
  command->add_option("puzzle", a->file, "A puzzle in JSON; - reads standard input")->capture_default_str();
  command->add_option("--planner", a->options.planner, "Which planner; 'list' names them")->capture_default_str();
  command->add_flag("--all", a->options.all, "Every distinct shot, best first");
  command->add_option("--budget", a->budget, "Simulations to spend at most")->check(whole_number);
  command->add_option("--svg", a->svg, "Write a picture to this file")->check(file_name);
  command->add_flag("--json", a->json, "One line of JSON instead of text");
  command->add_flag("--no-timing", a->no_timing, "Leave out time_us: same input, same bytes");
  command->add_flag("--no-robustness", a->no_robustness, "Leave out margin and success");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app
