// SPDX-License-Identifier: MIT
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/picture.hpp"
#include "app/solve/solve_flags.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/scene/json.hpp"

namespace bankshot::app::solve {
namespace {

struct Arguments {
  std::string file = "-";
  SolveFlags flags;
  PictureFlags picture;
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
    print_after([&] { a.picture.write([&](Theme theme) { return draw(puzzle, answer, {.theme = theme}); }); },
                a.json ? to_json(puzzle, answer, !a.flags.no_timing) + "\n" : to_text(puzzle, answer));
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
  add_picture_flags(*command, a->picture);
  command->add_flag("--json", a->json, "One line of JSON instead of text");
  command->footer(
      "Where to aim is told in diamonds: where the line of aim crosses the line of diamonds, 94 mm (3 11/16 inches, as "
      "the\n"
      "WPA has it) behind the nose of the cushion. They count from 0 at the left or at the bottom, to 8 on long rails "
      "and 4\n"
      "on short ones. Speeds are named after Alciatore: soft below 2 mph, medium below 4, firm below 7, hard below 10; "
      "a lag\n"
      "goes from the head string to the foot cushion and back to the head cushion.\n"
      "Exit 1: no shot was found.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::solve
