// SPDX-License-Identifier: MIT
//
// bankshot fit: fits the coefficients of a table to recorded shots.
#include "bankshot/learn/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/option_checks.hpp"
#include "app/picture.hpp"
#include "app/read_each.hpp"
#include "app/report/progress.hpp"
#include "bankshot/draw/fit.hpp"

namespace bankshot::app::fit {
namespace {

constexpr const char* by_speed[] = {"as-given", "constant", "linear", "square"};

FitWish::BySpeed read_by_speed(const std::string& word) {
  return static_cast<FitWish::BySpeed>(std::ranges::find(by_speed, word) - std::begin(by_speed));
}

/// Returns the keys of the models that a fit may try, or of all that files can describe.
std::vector<std::string> models(bool tried) {
  std::vector<std::string> out;
  for (const CushionModel& model : cushion_registry)
    if (tried ? model.tried_by_fit : model.in_files) out.emplace_back(model.key);
  return out;
}

struct Arguments {
  std::string file = "-", out, model, restitution = by_speed[0], rolling = by_speed[0];
  std::vector<std::string> free;
  std::string picture;
  PictureStyle style;
  int holdout = 0, jobs = 0;
  bool predict = false, quiet = false;
};

int run(const Arguments& a) {
  long bad = 0;
  const auto recordings = read_each(
      a.file, [](const std::string& line) { return read_recording(line); }, bad);
  if (recordings.empty())
    throw FileError(fmt::format("{}: no recording in it{}", a.file, bad > 0 ? " that can be read" : ""));
  FitWish wish{.free = a.free, .model = a.model, .holdout = a.holdout, .predict = a.predict};
  wish.restitution = read_by_speed(a.restitution), wish.rolling = read_by_speed(a.rolling);
  wish.threads = threads_for(a.jobs);
  Fit result;
  {
    constexpr std::size_t percent = 100;
    report::Progress bar(1);
    bar.begin("fit", percent);
    std::size_t shown = 0;
    if (!a.quiet)
      wish.progress = [&](double share) {
        for (; shown < static_cast<std::size_t>(share * percent); ++shown) bar.step();
      };
    result = bankshot::fit(recordings, wish);
  }
  print_after(
      [&] {
        if (!a.out.empty()) write_file(a.out, physics_of(result) + "\n");
        if (!a.picture.empty()) write_picture(a.picture, draw(recordings, result, a.style));
      },
      to_json(result) + "\n");
  if (!a.quiet) std::cerr << message_of(result) << '\n';
  tell_left_out(bad, recordings.size());
  return done;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("fit", "Learn a table's physics from recorded shots");
  command->add_option("recordings", a->file, "Recordings, one per line; - reads standard input")->capture_default_str();
  command->add_option("-o,--output", a->out, "Write the physics alone to this file, for use in puzzles and shots")
      ->check(file_or_output);
  command
      ->add_option("--free", a->free,
                   "What to fit, such as cushion.friction, tilt or camera.scale; without it all of the physics")
      ->delimiter(',')
      ->allow_extra_args(false);
  std::vector<std::string> known = models(false);
  const std::string about = fmt::format("The cushion law: {}; any takes the better of {}", fmt::join(known, ", "),
                                        fmt::join(models(true), " and "));
  known.emplace_back("any");
  command->add_option("--model", a->model, about)->check(CLI::IsMember(known));
  const std::vector<std::string> words(std::begin(by_speed), std::end(by_speed));
  command->add_option("--restitution", a->restitution, "How the restitution of cushions depends on the speed")
      ->capture_default_str()
      ->check(CLI::IsMember(words));
  command->add_option("--rolling", a->rolling, "How rolling friction depends on the speed")
      ->capture_default_str()
      ->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end() - 1)));
  command->add_option("--holdout", a->holdout, "Leave this many shots out at a time, and predict them")
      ->check(CLI::Range(0, 1000000));
  command->add_flag("--predict", a->predict, "Predict each shot from its first part, to 0.25 s after its first bounce");
  command->add_option("-j,--jobs", a->jobs, "Threads; 0: one per core")->capture_default_str();
  command
      ->add_option("--svg", a->picture,
                   "Draw each shot, where its balls were seen, and how far those places are from its path")
      ->check(picture_name);
  add_theme_flag(*command, a->style.theme);
  command->add_flag("--quiet", a->quiet, "Write no progress bar and no summary to standard error");
  explain(
      *command,
      "A recording is a scene and where its balls were seen: {\"table\":, \"ball\":, \"track\": {\"cue\": [[t, x, y], "
      "...]}}\n"
      "(docs/recordings.md). Standard output gets one line of JSON: the physics, each coefficient with its standard\n"
      "error, the launch of each shot, and in words what the recordings could not tell. Such a coefficient keeps its\n"
      "value. Lines that are no recording are reported and left out.",
      {{"bankshot fit recordings.jsonl -o physics.json", "all coefficients"},
       {"bankshot fit recordings.jsonl --model any --holdout 5", "the cushion law that best predicts shots left out"},
       {"bankshot fit recordings.jsonl --free cushion.friction,tilt", "these coefficients alone"}},
      "0 done; 2 bad input or usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::fit
