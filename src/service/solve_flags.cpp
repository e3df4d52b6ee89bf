// SPDX-License-Identifier: MIT
#include "service/solve_flags.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bankshot/scene/json.hpp"
#include "io/answer/launch_words.hpp"
#include "io/answer/words.hpp"
#include "io/json/reader.hpp"

namespace bankshot::service {

SolveOptions SolveFlags::solve_options() const {
  SolveOptions o = options;
  o.robustness = !no_robustness;
  o.depth = static_cast<int>(std::min(depth, 1000L));
  o.plies = static_cast<int>(plies);
  return o;
}

Puzzle SolveFlags::read(std::string_view text) const {
  Puzzle puzzle = read_puzzle(text);
  if (budget >= 0) puzzle.budget = budget;
  set_player(puzzle, noise);
  return puzzle;
}

std::string SolveFlags::words() const {
  std::string out = "--planner " + options.planner;
  if (options.all) out += " --all";
  if (options.first) out += " --first";
  if (budget >= 0) out += fmt::format(" --budget {}", budget);
  if (depth != SolveOptions{}.depth) out += fmt::format(" --depth {}", depth);
  if (plies != SolveOptions{}.plies) out += fmt::format(" --plies {}", plies);
  if (!noise.empty()) out += " --noise " + noise;
  if (no_timing) out += " --no-timing";
  if (no_robustness) out += " --no-robustness";
  if (path) out += " --path";
  if (options.sensitivity) out += " --sensitivity";
  return out;
}

std::vector<Option> options_of(SolveFlags& flags) {
  return {
      {"planner", &flags.options.planner, "The planner; 'list' names them"},
      {"all", &flags.options.all, "Every distinct shot, best first"},
      {.name = "first",
       .target = &flags.options.first,
       .help = "The first shot found, not the best",
       .excludes = "all"},
      {"budget", &flags.budget, "The most simulations to spend"},
      {"noise", &flags.noise, "A player by name, instead of the puzzle's noise; 'list' describes them"},
      {"depth", &flags.depth, "Number of balls that the plan of a game looks at; 0 makes no plan, which is faster"},
      {"plies", &flags.plies, "Number of pots after it that a shot of a game is chosen for: 1, or 2, which is slower"},
      {"no-timing", &flags.no_timing, "Leave out time_us, so that equal input gives equal bytes"},
      {"no-robustness", &flags.no_robustness, "Leave out margin and success"},
      {"sensitivity", &flags.options.sensitivity, "Add how far a wrong coefficient of the table moves the arrival"},
      {"path", &flags.path, "Add the points of its path to each shot in JSON"},
  };
}

namespace {

/// Throws unless `wanted` is one of `names`; `what` says in the message what it is not, such as "planner".
void check_name(const std::string& flag, std::string_view what, const std::string& wanted,
                const std::vector<std::string_view>& names) {
  if (std::find(names.begin(), names.end(), wanted) == names.end())
    throw BadOption(fmt::format("{}: {} is no {}{}", flag, quote(wanted), what, known_words(wanted, names)));
}

std::string list_of_planners() {
  std::string out;
  for (const PlannerInfo& p : planners()) out += fmt::format("{:<14}{}\n", p.name, p.summary);
  return out;
}

std::string list_of_players() {
  std::string out;
  for (const Player& p : players())
    out += fmt::format("{:<10}{}: errs by {}\n{:<10}from: {}\n", p.name, p.about, noise_words(p.noise), "", p.source);
  return out;
}

}  // namespace

void check(const SolveFlags& flags) {
  std::vector<std::string_view> names;
  for (const PlannerInfo& p : planners()) names.push_back(p.name);
  check_name("--planner", "planner", flags.options.planner, names);
  check_player(flags.noise);
  if (flags.plies < 1 || flags.plies > 2) throw BadOption(fmt::format("--plies: {} is neither 1 nor 2", flags.plies));
}

void check_player(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Player& p : players()) names.push_back(p.name);
  if (!name.empty()) check_name("--noise", "player", name, names);
}

void set_player(Puzzle& puzzle, const std::string& name) {
  if (name.empty()) return;
  puzzle.noise = std::ranges::find(players(), name, &Player::name)->noise;
  if (!carries_spin(puzzle.physics)) puzzle.noise.tip = 0;
}

std::string list_asked(const SolveFlags& flags) {
  constexpr std::string_view list = "list";
  if (flags.options.planner == list) return list_of_planners();
  return flags.noise == list ? list_of_players() : "";
}

namespace {

/// Returns a line for the reader if aiming off the exact line would raise success considerably; else an empty text.
std::string safer(const Puzzle& puzzle, const Answer& answer, const SolveOptions& options) {
  constexpr double much = 0.05;  // of success probability
  if (aim_of(puzzle) == Aim::safest || answer.shots.size() != 1) return "";
  const Shot& shot = answer.shots.front();
  if (!is_pocket(puzzle.target) || !shot.robustness.success || *shot.robustness.success > 1 - much) return "";
  Puzzle other = puzzle;
  other.aim = Aim::safest;
  const Answer best = bankshot::solve(other, options);
  if (best.shots.empty() || !(best.shots.front().robustness.success.value_or(0) > *shot.robustness.success + much))
    return "";
  const Shot& s = best.shots.front();
  return fmt::format(
      "  safer     {:.2f} degrees at {:.2f} m/s, off the exact line, has success {}: \"aim\": "
      "\"safest\"\n",
      degrees(s.launch.angle), s.launch.speed, success_words(s));
}

}  // namespace

std::string text_of(const Puzzle& puzzle, const Answer& answer, const SolveFlags& flags) {
  return to_text(puzzle, answer) + safer(puzzle, answer, flags.solve_options());
}

}  // namespace bankshot::service
