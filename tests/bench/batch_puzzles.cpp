// SPDX-License-Identifier: MIT
//
// Puzzles for measuring `batch`, one per line, each with a shot, written as a program would write them (presets by
// name, defaults left out).
//   batch_puzzles --count 1000000 --seed 1 --set rolling     the route of 1 to 3 cushions given
//   batch_puzzles --count 1000000 --seed 1 --set spin        exactly 3 cushions, any route, han2005
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"

namespace {

using namespace bankshot;

/// Draws a shot on a preset table that stops after `bounces` cushions without dropping.
ShotRequest shot_that_stops(test::Random& r, bool spin, int bounces, Vec2d& end, std::vector<Contact>& sequence) {
  const TablePreset& preset = *find_table_preset(spin ? "carom-10ft" : "seed");
  for (;;) {
    ShotRequest s;
    s.table = make_table(preset);
    s.ball.body = preset.body;
    const Vec2d size = s.table.highest();
    const double R = s.ball.body.radius;
    // Positions on a grid of a tenth of a millimetre, as people and programs write them.
    const auto place = [&](double to) { return std::round(1e4 * r.uniform(R, to - R)) / 1e4; };
    s.ball.at = {place(size.x), place(size.y)};
    s.physics = spin ? spin_physics(s.ball.body, preset.nose()) : rolling_physics();
    s.launch = {r.log_uniform(0.5, 6), radians(r.uniform(0, 360))};
    const Trajectory t = simulate(s);
    if (t.end != EventKind::rest || t.cushions != bounces) continue;
    end = t.events.back().state.at;
    sequence = t.sequence();
    return s;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Puzzles for measuring bankshot batch");
  long count = 1000;
  std::uint64_t seed = 1;
  std::string set = "rolling";
  app.add_option("--count", count)->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--set", set)->check(CLI::IsMember({"rolling", "spin"}))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  test::Random random(seed);
  const bool spin = set == "spin";
  for (long i = 0; i < count; ++i) {
    Vec2d end{};
    std::vector<Contact> sequence;
    const ShotRequest s = shot_that_stops(random, spin, spin ? 3 : random.integer(1, 3), end, sequence);
    std::string names;
    for (const Contact c : sequence)
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", contact_name(s.table, c));
    std::cout << fmt::format(
        "{{\"id\": {}, \"table\": \"{}\", \"physics\": \"{}\", \"ball\": {{\"at\": [{}, {}]}}, \"target\": "
        "{{\"point\": [{}, {}]}}, \"cushions\": {}}}\n",
        i + 1, spin ? "carom-10ft" : "seed", set, s.ball.at.x, s.ball.at.y, end.x, end.y,
        spin ? "3" : "[" + names + "]");
  }
  return std::cout.flush() ? 0 : 1;
}
