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
  std::string file = "-", svg, csv;
  SolveFlags flags;
  bool json = false;
};

int invalid(const Arguments& a, const std::string& text, const InvalidInput& e) {
  std::cerr << complaint(a.file, e) << '\n';
  if (a.json) print(to_json(invalid_answer(read_id(text), e, read_about(text))) + "\n");
  return bad_input;
}

int run(const Arguments& a) {
  if (a.flags.options.planner == "list") return list_planners();
  check_planner(a.flags.options.planner);
  const std::string text = read_file(a.file);
  try {
    const Puzzle puzzle = a.flags.read(text);
    const Answer answer = bankshot::solve(puzzle, a.flags.solve_options());
    if (a.csv != "-")
      print(a.json ? to_json(puzzle, answer, !a.flags.no_timing, a.flags.path) + "\n" : to_text(puzzle, answer));
    if (!a.svg.empty()) write_file(a.svg, draw(puzzle, answer));
    if (!a.csv.empty()) write(a.csv, to_csv(puzzle, answer, a.flags.options.all));
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
  command
      ->add_option(
          "--csv", a->csv,
          "Write the path, t,ball,x,y,vx,vy,wx,wy,wz, to this file; - writes it in the text's place; with --all "
          "the last column is the shot's number")
      ->check(file_or_output);
  command->add_flag("--json", a->json, "One line of JSON instead of text");
  explain(*command,
          "docs/format.md says what a puzzle and an answer hold, `bankshot schema` prints it as a JSON Schema. A name\n"
          "that ends in .gz is packed.",
          {{"bankshot solve puzzle.json", "the best shot, as text"},
           {"bankshot solve puzzle.json --svg shot.svg", "and a picture of it"},
           {"bankshot solve puzzle.json --json --all --path", "every shot with its path, as JSON"},
           {"bankshot solve puzzle.json --csv -", "the path as a table"},
           {"bankshot solve --planner list", "the planners"}},
          "0 solved; 1 no shot, or the budget ran out; 2 bad input or usage.");
  return [a] {
    output_is_free(a->csv, a->json);
    return run(*a);
  };
}

}  // namespace bankshot::app::solve
