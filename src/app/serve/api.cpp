// SPDX-License-Identifier: MIT
#include "app/serve/api.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/files.hpp"
#include "app/map/map_of.hpp"
#include "app/option_checks.hpp"
#include "app/simulate/csv_of.hpp"
#include "app/solve/solve_flags.hpp"
#include "bankshot/draw/map.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/launch_map.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/format/schema.hpp"
#include "io/json/reader.hpp"
#include "io/json/writer.hpp"
#include "sim/geometry/mouth.hpp"

namespace bankshot::app::serve {
namespace {

/// Parses the query as if it were typed, so that the command line's own definitions check it and say what is wrong.
void parse(CLI::App& command, const Query& query) {
  std::vector<std::string> words;
  for (const auto& [name, value] : query) words.push_back("--" + name + (value.empty() ? "" : "=" + value));
  std::ranges::reverse(words);
  command.set_help_flag();
  command.parse(words);
}

/// Returns the reply of `f`; an exception that `f` throws for bad input becomes a refusal with status 400.
template <class F>
Reply answer(const F& f) {
  try {
    return f();
  } catch (const InvalidInput& e) {
    return refusal(400, e.path, e.what());
  } catch (const WriteError& e) {  // the answer would be too long
    return refusal(400, "", e.what());
  } catch (const CLI::ParseError& e) {
    return refusal(400, "", e.what());
  }
}

void write_point(JsonWriter& w, const Vec2d& p) { w.open('['), w.number(p.x), w.number(p.y), w.close(']'); }

void write_pocket(JsonWriter& w, const Table& table, const Pocket& pocket, const JawPieces* jaws) {
  w.open('{');
  w.string("name", pocket.name);
  w.key("at"), write_point(w, pocket.place());
  w.number("half", pocket.half());
  w.key("out"), write_point(w, view(table, pocket).out);
  w.key("hole"), write_point(w, pocket.at);
  w.number("radius", pocket.radius);
  if (jaws) {
    w.key("mouth"), w.open('[');
    for (const Vec2d& p : mouth(table, *jaws)) write_point(w, p);
    w.close(']');
    w.number("tip", jaws->tips[0].radius);
  }
  w.close('}');
}

void write_preset(JsonWriter& w, const TablePreset& preset) {
  const Table table = make_table(preset);
  w.open('{');
  w.string("name", preset.name);
  w.number("length", preset.length), w.number("width", preset.width);
  w.key("cushions"), w.open('[');
  for (const std::string& name : table.cushions) w.string(name);
  w.close(']');
  w.key("pockets"), w.open('[');
  const std::vector<JawPieces> jaws = obstacles(table).jaws;  // of every pocket, or none
  for (std::size_t i = 0; i < table.pockets.size(); ++i)
    write_pocket(w, table, table.pockets[i], jaws.empty() ? nullptr : &jaws[i]);
  w.close(']');
  w.number("radius", preset.body.radius);
  w.number("diamond", preset.length / 8);
  w.close('}');
}

/// Limits on the size of an answer: a small request may ask for gigabytes, since a slow ball rolls for days.
constexpr double most_rows = 1e6;
constexpr std::size_t most_events = 100000;

void check_length(const Puzzle& p, const Answer& found) {
  double points = 0;
  for (const Shot& shot : found.shots)
    points += shot.path.arrival.time * usual_rate * static_cast<double>(1 + p.others.size());
  if (points > most_rows)
    throw WriteError(fmt::format("the paths would have {:.2g} points, and {:.0g} is the most", points, most_rows));
}

}  // namespace

Query query_of(std::string_view flags, char between) {
  Query query;
  while (!flags.empty()) {
    const std::string_view one = flags.substr(0, flags.find(between));
    const std::size_t end = std::min(one.find('='), one.size());
    if (!one.empty()) query.emplace_back(one.substr(0, end), one.substr(std::min(end + 1, one.size())));
    flags.remove_prefix(std::min(one.size() + 1, flags.size()));
  }
  return query;
}

Reply refusal(int status, const std::string& path, const std::string& reason) {
  JsonWriter w;
  w.open('{'), w.string("path", path), w.string("reason", reason), w.close('}');
  return {status, w.take() + "\n"};
}

Reply solve(const Query& query, const std::string& body, const Limit& limit) {
  return answer([&] {
    app::solve::SolveFlags flags;
    CLI::App command;
    app::solve::add_solve_flags(command, flags);
    parse(command, query);
    app::solve::check(flags);
    const Puzzle puzzle = flags.read(body);
    SolveOptions options = flags.solve_options();
    options.cancelled = &limit.stop;
    Answer found = bankshot::solve(puzzle, options);
    if (limit.stop) found.message += fmt::format("; {}", limit.why.load());
    if (flags.path) check_length(puzzle, found);
    return Reply{200, to_json(puzzle, found, !flags.no_timing, flags.path) + "\n"};
  });
}

Reply simulate(const Query& query, const std::string& body) {
  return answer([&] {
    CLI::App command;
    double rate = usual_rate;
    bool csv = false;
    command.add_flag("--csv", csv);
    command.add_option("--rate", rate)->check(CLI::Range(1e-3, 1e3));
    parse(command, query);
    const ShotRequest shot = read_shot(body);
    const Trajectory t = bankshot::simulate(shot);
    if (csv) return Reply{200, app::simulate::csv_of(shot, t, rate, most_rows), "text/csv"};
    if (t.events.size() > most_events)
      throw WriteError(fmt::format("the shot has {} events, and {} is the most", t.events.size(), most_events));
    return Reply{200, to_json(shot, t) + "\n"};
  });
}

Reply map(const Query& query, const std::string& body, const Limit& limit) {
  return answer([&] {
    CLI::App command;
    std::vector<int> grid{40, 20};
    bool svg = false, no_robustness = false;
    long budget = -1;
    constexpr int most = 200;
    command.add_option("--grid", grid)->delimiter(',')->expected(2)->check(CLI::Range(1, most));
    command.add_flag("--svg", svg);
    command.add_option("--budget", budget)->check(whole_number);
    command.add_flag("--no-robustness", no_robustness);
    parse(command, query);
    Puzzle puzzle = read_puzzle(body);
    if (budget >= 0) puzzle.budget = budget;
    const StartMap map =
        app::map::map_of(puzzle, grid[0], grid[1], {.robustness = !no_robustness, .cancelled = &limit.stop});
    if (limit.stop) return refusal(503, "", limit.why.load());
    if (svg) return Reply{200, draw(puzzle, map, Theme::light), "image/svg+xml"};
    return Reply{200, to_csv(puzzle, map), "text/csv"};
  });
}

Reply launches(const Query& query, const std::string& body, const Limit& limit) {
  return answer([&] {
    CLI::App command;
    std::vector<double> angle, speed;
    std::vector<int> grid{100, 50};
    constexpr int most = 400;
    command.add_option("--angle", angle)->delimiter(',')->expected(2)->required()->check(CLI::Range(-360.0, 720.0));
    command.add_option("--speed", speed)->delimiter(',')->expected(2)->required()->check(CLI::Range(0.0, 30.0));
    command.add_option("--grid", grid)->delimiter(',')->expected(2)->check(CLI::Range(1, most));
    parse(command, query);
    if (!(angle[0] < angle[1])) return refusal(400, "", "--angle: the first must be less than the second");
    if (!(speed[0] < speed[1])) return refusal(400, "", "--speed: the first must be less than the second");
    const LaunchGrid asked{{radians(angle[0]), radians(angle[1])}, {speed[0], speed[1]}, grid[0], grid[1]};
    const LaunchMap map = launch_map(read_puzzle(body), asked, &limit.stop);
    if (limit.stop) return refusal(503, "", limit.why.load());
    return Reply{200, to_json(map) + "\n"};
  });
}

Reply tables(const Query& query) {
  return answer([&] {
    CLI::App command;
    parse(command, query);
    JsonWriter w;
    w.open('[');
    for (const TablePreset& preset : table_presets()) write_preset(w, preset);
    w.close(']');
    return Reply{200, w.take() + "\n"};
  });
}

Reply schema(const Query& query) {
  return answer([&] {
    CLI::App command;
    std::string document = "puzzle";
    command.add_option("--document", document);
    parse(command, query);
    const auto known = format::documents();
    if (std::ranges::find(known, document) == known.end())
      return refusal(400, "", quote(document) + " is no document" + known_words(document, known));
    return Reply{200, format::schema(document), "application/schema+json"};
  });
}

}  // namespace bankshot::app::serve
