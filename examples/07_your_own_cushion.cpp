// SPDX-License-Identifier: MIT
//
// 07: define your own cushion in a few lines, test the properties that every cushion needs, and plan the same
// three-cushion shot with it and with Han's model. One new idea: CustomCushion.
#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "bankshot/contact/custom.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/testing/cushion_promises.hpp"

namespace {

using namespace bankshot;

/// A soft rail that meets the ball at the height of its centre. Its restitution falls with the speed of the hit. It
/// grips the ball along the rail until the contact point stops sliding or friction reaches its limit.
struct SoftRail final : CushionLaw {
  void impact(const Body& ball, InCushionFrame<double>& f) const override {
    constexpr double friction = 0.14, stick = 2.0 / 7, turns = 5.0 / 2;  // for a solid ball
    const double restitution = 0.9 / (1 + 0.05 * f.vn), impulse = (1 + restitution) * f.vn;
    const double slip = f.vt + ball.radius * f.wz;  // slip of the contact point along the rail
    const double grip = -std::copysign(std::min(stick * std::abs(slip), friction * impulse), slip);
    f.vn -= impulse;
    f.vt += grip;
    f.wz += turns * grip / ball.radius;
  }
};

}  // namespace

int main(int argc, char** argv) {
  const Scene scene = preset_scene("carom-10ft");
  const SoftRail law;
  const CustomCushion rail{.law = &law, .restitution = 0.85};
  for (const Promise& p : try_promises(rail, scene.ball.body))
    fmt::print("{}: {}\n", p.kept() ? "kept" : "BROKEN", p.what);
  Puzzle puzzle{.table = scene.table,
                .ball = {.at = {0.7, 0.4}, .body = scene.ball.body},
                .spin = {.side = 0.5},
                .target = PointTarget{.at = {2.2, 0.5}, .within = 0.06},
                .cushions = CushionRule::exactly(3),
                .arrive = Range{0.5, 0.5},
                .prefer = Prefer::soft};
  std::vector<LabelledPath> paths;
  for (const bool own : {false, true}) {
    puzzle.physics = scene.physics;
    if (own) puzzle.physics.cushion = rail;
    const Answer answer = solve(puzzle);
    const Shot& shot = answer.shots.at(0);
    const char* name = own ? "soft rail" : "han2005";
    fmt::print("{}: {:.2f} degrees, {:.2f} m/s, success {:.2f}\n", name, degrees(shot.launch.angle), shot.launch.speed,
               *shot.robustness.success);
    paths.push_back({name, simulate(as_request(puzzle, shot))});
  }
  if (argc > 1) std::ofstream(argv[1]) << draw(puzzle.table, puzzle.ball, paths);
}
