// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/option_checks.hpp"
#include "app/options.hpp"
#include "app/solve/solve.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/scene/json.hpp"

namespace bankshot::app::solve {
namespace {

int invalid(const Arguments& a, const std::string& text, const InvalidInput& e) {
  std::cerr << complaint(a.file, e) << '\n';
  if (a.json) print(to_json(invalid_answer(read_id(text), e, read_about(text))) + "\n");
  return bad_input;
}

}  // namespace

int run(const Arguments& a, const Asked& asked) {
  if (const std::string list = service::list_asked(a.flags); !list.empty()) return print(list), done;
  service::check(a.flags);
  const std::string text = read_file(a.file);
  try {
    const Puzzle puzzle = a.flags.read(asked ? asked(text) : text);
    const Answer answer = bankshot::solve(puzzle, a.flags.solve_options());
    const auto write = [&] {
      a.picture.write([&](const PictureStyle& style) { return draw(puzzle, answer, style); });
      if (!a.csv.empty() && a.csv != "-") write_file(a.csv, to_csv(puzzle, answer, a.flags.options.all));
    };
    print_after(write, a.csv == "-" ? to_csv(puzzle, answer, a.flags.options.all)
                       : a.json     ? to_json(puzzle, answer, !a.flags.no_timing, a.flags.path) + "\n"
                                    : service::text_of(puzzle, answer, a.flags));
    return answer.status == Status::solved ? done : nothing_solved;
  } catch (const InvalidInput& e) {
    return invalid(a, text, e);
  }
}

void add_arguments(CLI::App& command, Arguments& a) {
  add_options(command, service::options_of(a.flags));
  add_picture_flags(command, a.picture);
  command
      .add_option(
          "--csv", a.csv,
          "Write the path as t,ball,x,y,vx,vy,wx,wy,wz to this file; - prints it instead of the text; with --all "
          "a last column numbers the shots")
      ->check(file_or_output);
  command.add_flag("--json", a.json, "One line of JSON instead of text");
}

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("solve", "Find the aim and the speed for a puzzle");
  command->add_option("puzzle", a->file, "A puzzle in JSON; - reads standard input")->capture_default_str();
  add_arguments(*command, *a);
  explain(
      *command,
      "The aim is given in diamonds: the point where the line of aim crosses the line of diamonds, 94 mm (3 11/16\n"
      "inches, by the rules of the WPA) behind the nose of the cushion. Diamonds count from 0 at the left or at the\n"
      "bottom, to 8 on long rails and to 4 on short ones. Names of speeds are those of Alciatore: soft touch below\n"
      "1 mph, slow below 2, medium below 4, fast below 7, power shot below 10, powerful break from 25. The lag speed\n"
      "just takes a ball from the head string to the foot cushion and back to the head cushion.\n"
      "docs/format.md has the format of puzzles and answers; `bankshot schema` prints it as a JSON Schema. A file\n"
      "whose name ends in .gz is packed.",
      {{"bankshot solve puzzle.json", "the best shot, as text"},
       {"bankshot solve puzzle.json --svg shot.svg", "the best shot and a picture of it"},
       {"bankshot solve puzzle.json --json --all --path", "every shot with its path, as JSON"},
       {"bankshot solve puzzle.json --csv -", "the path as a table"},
       {"bankshot solve puzzle.json --noise league", "the best shot of a league player"},
       {"bankshot solve --noise list", "the players, and where their errors come from"},
       {"bankshot solve --planner list", "the planners"}},
      "0 solved; 1 no shot, or the budget ran out; 2 bad input or usage.");
  return [a] {
    output_is_free(a->csv, a->json);
    return run(*a);
  };
}

}  // namespace bankshot::app::solve
