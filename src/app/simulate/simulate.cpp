// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/option_checks.hpp"
#include "app/picture.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/camera.hpp"
#include "service/options.hpp"
#include "service/path_table.hpp"

namespace bankshot::app::simulate {
namespace {

struct Arguments {
  std::string file = "-", csv;
  PictureFlags picture;
  double rate = usual_rate;
  double record = 0, noise = 0, drop = 0;  // Hz, mm, share
  std::uint64_t seed = 1;
  bool json = false;
};

std::string what_of(const ShotRequest& r, const Record& e) {
  const std::string what = words(e.kind).plain;
  if (e.kind == EventKind::ball) return fmt::format("{} {}", what, ball_of(r, e.contact.index).id);
  return e.contact ? what + ' ' + contact_name(r.table, e.contact) : what;
}

/// Formats one event. If there are other balls, the line begins with the ball's name, padded to `names` characters.
std::string event_text(const ShotRequest& r, const Record& e, std::size_t names) {
  const std::string name = names > 0 ? fmt::format("{:<{}}  ", ball_of(r, e.ball).id, names) : "";
  return fmt::format("{:10.4f} s  {}{:<22} at ({:.4f}, {:.4f}) m, {:.4f} m/s\n", e.time, name, what_of(r, e),
                     e.state.at.x, e.state.at.y, norm(e.state.velocity));
}

std::size_t width_of_names(const ShotRequest& r) {
  std::size_t width = r.others.empty() ? 0 : r.ball.id.size();
  for (const Ball& other : r.others) width = std::max(width, other.id.size());
  return width;
}

/// Says which other balls fell, and how many moved.
std::string others_text(const ShotRequest& r, const Trajectory& t) {
  std::string out;
  std::vector<bool> moved(r.others.size() + 1);
  for (const Record& e : t.events) {
    if (e.kind == EventKind::ball)
      moved[static_cast<std::size_t>(e.ball)] = moved[static_cast<std::size_t>(e.contact.index)] = true;
    if (e.kind == EventKind::pocket && e.ball != 0)
      out += fmt::format("{} falls into {}.\n", ball_of(r, e.ball).id, contact_name(r.table, e.contact));
  }
  const auto count = std::count(moved.begin() + 1, moved.end(), true);
  return out + fmt::format("{} of {} other ball{} moved.\n", count, r.others.size(), r.others.size() == 1 ? "" : "s");
}

/// Says how the cue ball's motion ended.
std::string_view ending(EventKind end) {
  switch (end) {
    case EventKind::rest:
      return "comes to rest";
    case EventKind::pocket:
      return "is pocketed";
    case EventKind::horizon:
      return "stopped where asked";
    default:
      return "stopped after a million events";
  }
}

std::string text_of(const ShotRequest& r, const Trajectory& t) {
  constexpr std::size_t most_lines = 60;  // a longer list is for --json
  std::string out;
  const std::size_t names = width_of_names(r);
  const std::size_t skipped = t.events.size() > most_lines ? t.events.size() - most_lines : 0;
  for (std::size_t i = 0; i < t.events.size(); ++i) {
    if (skipped && i == most_lines / 2) {
      out += fmt::format("  ... {} events not shown; --json has them all\n", skipped);
      i += skipped;
    }
    // other balls do not move at the start
    if (r.others.empty() || t.events[i].kind != EventKind::start || t.events[i].ball == 0)
      out += event_text(r, t.events[i], names);
  }
  return out +
         fmt::format("The ball {} after {} cushion{} and {:.4f} m.\n", ending(t.end), t.cushions,
                     t.cushions == 1 ? "" : "s", t.length) +
         (r.others.empty() ? "" : others_text(r, t));
}

std::string recording_of(const Arguments& a, const ShotRequest& request, const Trajectory& t) {
  constexpr double mm = 1e-3;
  Random random(a.seed);
  return write_recording(film(request, t, {.rate = a.record, .noise = a.noise * mm, .drop = a.drop}, random)) + "\n";
}

/// Returns the path as CSV. Throws WriteError if it would be longer than about a gigabyte.
std::string csv_of(const Arguments& a, const ShotRequest& request, const Trajectory& t) {
  constexpr double most_rows = 1e7;
  try {
    return service::path_table(request, t, a.rate, most_rows);
  } catch (const service::TooLong& e) {
    throw WriteError(e.what());
  }
}

int run(const Arguments& a) {
  const std::string text = read_file(a.file);
  try {
    const ShotRequest request = read_shot(text);
    const Trajectory t = bankshot::simulate(request);
    const auto write = [&] {
      a.picture.write([&](const PictureStyle& style) { return draw(request, t, style); });
      if (!a.csv.empty() && a.csv != "-") write_file(a.csv, csv_of(a, request, t));
    };
    print_after(write, a.csv == "-"   ? csv_of(a, request, t)
                       : a.record > 0 ? recording_of(a, request, t)
                       : a.json       ? to_json(request, t) + "\n"
                                      : text_of(request, t));
    return done;
  } catch (const InvalidInput& e) {
    std::cerr << complaint(a.file, e) << '\n';
    if (a.json) print(to_json(invalid_answer(read_id(text), e)) + "\n");
    return bad_input;
  }
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("simulate", "Simulate one shot and list its events");
  command->add_option("shot", a->file, "A shot in JSON; - reads standard input")->capture_default_str();
  add_picture_flags(*command, a->picture);
  command
      ->add_option("--csv", a->csv,
                   "Write the path as t,ball,x,y,vx,vy,wx,wy,wz to this file; - prints it instead of the text")
      ->check(file_or_output);
  command->add_option("--rate", a->rate, "Rows per second of the CSV")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e6));
  command->add_flag("--json", a->json, "One line of JSON instead of text");
  CLI::Option* const record =
      command
          ->add_option("--record", a->record, "Print what a camera with this frame rate would see: a recording for fit")
          ->check(CLI::Range(1.0, 1e4));
  command->add_option("--noise", a->noise, "Standard deviation of each coordinate of a recording, in mm")
      ->check(CLI::Range(0.0, 100.0))
      ->needs(record);
  command->add_option("--drop", a->drop, "Share of a recording's samples that are missing")
      ->check(CLI::Range(0.0, 0.99))
      ->needs(record);
  command->add_option("--seed", a->seed, "Seed of the errors of a recording")
      ->needs(record)
      ->check(service::whole_number);
  explain(
      *command,
      "A shot is a scene and a launch. A puzzle with a shot of its answer is one too; its other keys are not read.\n"
      "The shot ends at rest, in a pocket, or as \"until\" says. A file whose name ends in .gz is packed.",
      {{"bankshot simulate shot.json", "its events, one per line"},
       {"bankshot simulate shot.json --csv - --rate 100", "its path, 100 points per second"},
       {"bankshot simulate shot.json --record 60 --noise 2 --drop 0.1", "what a camera would see of it"},
       {"bankshot simulate shot.json --json --svg shot.svg", "its events as JSON, and a picture"}},
      "0 done; 2 bad input or usage.");
  return [a] {
    output_is_free(a->csv, a->json);
    return run(*a);
  };
}

}  // namespace bankshot::app::simulate
