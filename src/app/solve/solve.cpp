// SPDX-License-Identifier: MIT
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/solve/solve_flags.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/scene/json.hpp"

namespace bankshot::app::solve {
namespace {

struct Arguments {
  std::string file = "-", svg;
  SolveFlags flags;
  bool json = false;
};

int invalid(const Arguments& a, const std::string& text, const InvalidInput& e) {
  std::cerr << complaint(a.file, e) << '\n';
  if (a.json) print(to_json(invalid_answer(read_id(text), e)) + "\n");
  return bad_input;
}

int run(const Arguments& a) {
  if (a.flags.options.planner == "list") return list_planners();
  check_planner(a.flags.options.planner);
  const std::string text = read_file(a.file);
  try {
    const Puzzle puzzle = a.flags.read(text);
    const Answer answer = bankshot::solve(puzzle, a.flags.solve_options());
    print(a.json ? to_json(puzzle, answer, !a.flags.no_timing) + "\n" : to_text(puzzle, answer));
    if (!a.svg.empty()) write_file(a.svg, draw(puzzle, answer));
    return answer.status == Status::solved ? done : nothing_solved;
  } catch (const InvalidInput& e) {
    return invalid(a, text, e);
  }
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("solve", "Find the aim and the speed for a puzzle");
  command->add_option("puzzle", a->file, "A puzzle in JSON; - reads standard input")->capture_default_str();
  add_solve_flags(*command, a->flags);
  command->add_option("--svg", a->svg, "Write a picture to this file")->check(file_name);
  command->add_flag("--json", a->json, "One line of JSON instead of text");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::solve
