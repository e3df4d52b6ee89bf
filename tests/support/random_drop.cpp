// SPDX-License-Identifier: MIT
#include "support/random_drop.hpp"

#include <algorithm>
#include <iterator>

#include "bankshot/geometry/boundary.hpp"

namespace bankshot::test {
namespace {

bool at_jaw(const Record& e) { return e.kind == EventKind::jaw; }

}  // namespace

bool Drop::touches_jaws() const { return std::ranges::any_of(path.events, at_jaw); }

bool Drop::only_at_the_end() const {
  const auto first = std::ranges::find_if(path.events, at_jaw);
  const int pocket = *std::get<PocketTarget>(puzzle.target).pocket;
  return std::all_of(first, path.events.end(), [&](const Record& e) {
    return e.kind != EventKind::cushion && (!at_jaw(e) || e.contact.jaw_pocket() == pocket);
  });
}

Drop random_drop(Random& r, bool jaws, bool spin, int most_cushions) {
  constexpr const char* names[] = {"pool-7ft", "pool-8ft", "pool-9ft", "snooker-12ft"};
  for (;;) {
    const TablePreset& preset = *find_table_preset(names[r.integer(0, 3)]);
    ShotRequest s{.table = make_table(preset, jaws), .physics = rolling_physics()};
    s.ball.body = preset.body;
    if (spin) s.physics = spin_physics(preset.body, preset.nose());
    const double R = preset.body.radius;
    s.ball.at = {r.uniform(R, preset.length - R), r.uniform(R, preset.width - R)};
    if (Boundary(s.table, s.ball.body).pocket_around(s.ball.at)) continue;
    s.launch = {r.log_uniform(0.3, 8), radians(r.uniform(0, 360))};
    if (spin && r.chance(0.5)) s.spin = {r.uniform(-0.5, 1), r.uniform(-0.5, 0.5), 0};
    s.until.cushions = most_cushions + 1;
    const Trajectory t = simulate(s);
    if (t.end != EventKind::pocket) continue;
    const Record& drop = *std::prev(t.events.end(), 2);
    const double speed = norm(drop.state.velocity);
    if (!(speed > 0)) continue;
    Puzzle p{.table = s.table, .physics = s.physics, .ball = s.ball, .spin = s.spin};
    p.target = PocketTarget{drop.contact.index};
    p.arrive = Range{speed, speed};
    p.cushions = r.chance(0.5) ? CushionRule::in_order(t.sequence()) : CushionRule::exactly(t.cushions);
    return {p, t};
  }
}

}  // namespace bankshot::test
