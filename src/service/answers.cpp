// SPDX-License-Identifier: MIT
#include "service/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bankshot/draw/map.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/launch_map.hpp"
#include "bankshot/plan/place_value.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/format/schema.hpp"
#include "io/json/reader.hpp"
#include "io/json/writer.hpp"
#include "service/path_table.hpp"
#include "service/solve_flags.hpp"
#include "service/start_map.hpp"
#include "service/wishes.hpp"
#include "sim/geometry/mouth.hpp"

namespace bankshot::service {
namespace {

/// Returns the reply of `f`; an exception that `f` throws for bad input becomes a refusal with status 400.
template <class F>
Reply answer(const F& f) {
  try {
    return f();
  } catch (const InvalidInput& e) {
    return refusal(400, e.path, e.what());
  } catch (const TooLong& e) {
    return refusal(400, "", e.what());
  } catch (const BadOption& e) {
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

/// Limits on the size of an answer.
constexpr double most_points = 1e6;
constexpr std::size_t most_events = 100000;

void check_length(const Puzzle& p, const Answer& found) {
  double points = 0;
  for (const Shot& shot : found.shots)
    points += shot.path.arrival.time * usual_rate * static_cast<double>(1 + p.others.size());
  if (points > most_points)
    throw TooLong(fmt::format("the paths would have {:.2g} points, and {:.0g} is the most", points, most_points));
}

}  // namespace

Reply refusal(int status, const std::string& path, const std::string& reason) {
  JsonWriter w;
  w.open('{'), w.string("path", path), w.string("reason", reason), w.close('}');
  return {status, w.take() + "\n"};
}

Reply solve(const Query& query, const std::string& body, const Limit& limit) {
  return answer([&] {
    SolveFlags flags;
    read(query, options_of(flags));
    check(flags);
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
    double rate = usual_rate;
    bool csv = false;
    read(query, std::array{Option{"csv", &csv}, Option{"rate", &rate, "", rates}});
    const ShotRequest shot = read_shot(body);
    const Trajectory t = bankshot::simulate(shot);
    if (csv) return Reply{200, path_table(shot, t, rate, most_points), "text/csv"};
    if (t.events.size() > most_events)
      throw TooLong(fmt::format("the shot has {} events, and {} is the most", t.events.size(), most_events));
    return Reply{200, to_json(shot, t) + "\n"};
  });
}

Reply map(const Query& query, const std::string& body, const Limit& limit) {
  return answer([&] {
    std::vector<int> grid{40, 20};
    bool svg = false, no_robustness = false, value = false;
    long budget = -1;
    read(query, std::array{Option{"grid", &grid, "", {1, 200}}, Option{"svg", &svg}, Option{"budget", &budget},
                           Option{"no-robustness", &no_robustness}, Option{"value", &value}});
    Puzzle puzzle = read_puzzle(body);
    if (budget >= 0) puzzle.budget = budget;
    const auto reply = [&](const auto& map) {
      return svg ? Reply{200, draw(puzzle, map, Theme::light), "image/svg+xml"}
                 : Reply{200, to_csv(puzzle, map), "text/csv"};
    };
    if (value) return reply(value_map(puzzle, grid[0], grid[1]));
    const StartMap map = start_map(puzzle, grid[0], grid[1], {.robustness = !no_robustness, .cancelled = &limit.stop});
    if (limit.stop) return refusal(503, "", limit.why.load());
    return reply(map);
  });
}

Reply launches(const Query& query, const std::string& body, const Limit& limit) {
  return answer([&] {
    std::vector<double> angle(2), speed(2);
    std::vector<int> grid{100, 50};
    read(query, std::array{Option{.name = "angle", .target = &angle, .range = {-360, 720}, .required = true},
                           Option{.name = "speed", .target = &speed, .range = {0, 30}, .required = true},
                           Option{.name = "grid", .target = &grid, .range = {1, 400}}});
    if (!(angle[0] < angle[1])) return refusal(400, "", "--angle: the first must be less than the second");
    if (!(speed[0] < speed[1])) return refusal(400, "", "--speed: the first must be less than the second");
    const LaunchGrid asked{{radians(angle[0]), radians(angle[1])}, {speed[0], speed[1]}, grid[0], grid[1]};
    const LaunchMap map = launch_map(read_puzzle(body), asked, &limit.stop);
    if (limit.stop) return refusal(503, "", limit.why.load());
    return Reply{200, to_json(map) + "\n"};
  });
}

Reply generate(const Query& query) {
  return answer([&] {
    Wishes wishes;
    long seed = 0, number = 1;
    std::vector<int> balls{0};
    std::vector<double> speed(2);  // m/s; without a highest one, any
    read(query, std::array{Option{.name = "seed", .target = &seed, .required = true}, Option{"number", &number},
                           Option{"table", &wishes.table}, Option{"physics", &wishes.physics},
                           Option{"cushions", &wishes.cushions}, Option{"target", &wishes.target},
                           Option{"balls", &balls, "", {0, most_balls}}, Option{"then", &wishes.then},
                           Option{"difficulty", &wishes.difficulty}, Option{"unique", &wishes.unique},
                           Option{"speed", &speed, "", {0, 30}}, Option{"no-spin", &wishes.no_spin}});
    wishes.seed = static_cast<std::uint64_t>(seed);
    wishes.balls = balls.front();
    if (speed[1] > 0) wishes.speed = speed;
    const Made made = make(wishes, read_wish(wishes), number);
    if (made.line.empty()) return refusal(404, "", "no puzzle was found: " + made.tries.text());
    return Reply{200, made.line};
  });
}

Reply tables(const Query& query) {
  return answer([&] {
    read(query, {});
    JsonWriter w;
    w.open('[');
    for (const TablePreset& preset : table_presets()) write_preset(w, preset);
    w.close(']');
    return Reply{200, w.take() + "\n"};
  });
}

Reply schema(const Query& query) {
  return answer([&] {
    std::string document = "puzzle";
    read(query, std::array{Option{"document", &document}});
    const auto known = format::documents();
    if (std::ranges::find(known, document) == known.end())
      return refusal(400, "", quote(document) + " is no document" + known_words(document, known));
    return Reply{200, format::schema(document), "application/schema+json"};
  });
}

}  // namespace bankshot::service
