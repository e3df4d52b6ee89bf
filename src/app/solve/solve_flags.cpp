// SPDX-License-Identifier: MIT
#include "app/solve/solve_flags.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/option_checks.hpp"
#include "bankshot/scene/json.hpp"
#include "json/reader.hpp"

namespace bankshot::app::solve {

SolveOptions SolveFlags::solve_options() const {
  SolveOptions o = options;
  o.robustness = !no_robustness;
  return o;
}

Puzzle SolveFlags::read(std::string_view text) const {
  Puzzle puzzle = read_puzzle(text);
  if (budget >= 0) puzzle.budget = budget;
  return puzzle;
}

std::string SolveFlags::words() const {
  std::string out = "--planner " + options.planner;
  if (options.all) out += " --all";
  if (options.first) out += " --first";
  if (budget >= 0) out += fmt::format(" --budget {}", budget);
  if (no_timing) out += " --no-timing";
  if (no_robustness) out += " --no-robustness";
  if (path) out += " --path";
  if (options.sensitivity) out += " --sensitivity";
  return out;
}

void add_solve_flags(CLI::App& command, SolveFlags& flags) {
  command.add_option("--planner", flags.options.planner, "Which planner; 'list' names them")->capture_default_str();
  CLI::Option* all = command.add_flag("--all", flags.options.all, "Every distinct shot, best first");
  command.add_flag("--first", flags.options.first, "The first shot found, not the best")->excludes(all);
  command.add_option("--budget", flags.budget, "Simulations to spend at most")->check(whole_number);
  command.add_flag("--no-timing", flags.no_timing, "Leave out time_us: same input, same bytes");
  command.add_flag("--no-robustness", flags.no_robustness, "Leave out margin and success");
  command.add_flag("--sensitivity", flags.options.sensitivity,
                   "Each shot with how far a wrong coefficient of the table moves its arrival");
  command.add_flag("--path", flags.path, "Each shot in JSON with the points of its path");
}

void check_planner(const std::string& wanted) {
  std::vector<std::string_view> names;
  for (const PlannerInfo& p : planners()) names.push_back(p.name);
  if (std::find(names.begin(), names.end(), wanted) == names.end())
    throw CLI::ValidationError("--planner", quote(wanted) + " is no planner" + known_words(wanted, names));
}

std::string list_of_planners() {
  std::string out;
  for (const PlannerInfo& p : planners()) out += fmt::format("{:<14}{}\n", p.name, p.summary);
  return out;
}

}  // namespace bankshot::app::solve
