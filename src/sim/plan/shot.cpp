// SPDX-License-Identifier: MIT
#include "bankshot/plan/shot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/scene/game.hpp"
#include "bankshot/scene/in_hand.hpp"
#include "bankshot/scene/tip.hpp"

namespace bankshot {

int ShotPath::contacts() const {
  std::size_t cushions_met = cushions.size();
  for (const ObjectBallPath& ball : then) cushions_met += ball.cushions.size();
  return static_cast<int>(cushions_met) + jaws;
}

double cost_of(const Launch& launch, const LaunchSpin& spin) {
  constexpr double per_speed = 0.004, per_radius_of_tip = 0.02;
  return per_speed * launch.speed + per_radius_of_tip * tip_of(spin, 1).from_centre();
}

double cost_of_contacts(int contacts) { return 0.005 * contacts; }

double cost_of(const Shot& shot) { return cost_of_contacts(shot.path.contacts()) + cost_of(shot.launch, shot.spin); }

double fullness(const Puzzle& p, const Hit& hit, int by) {
  const auto other = [&](int ball) -> const Ball& { return p.others[static_cast<std::size_t>(ball) - 1]; };
  const double a = (by == 0 ? p.ball : other(by)).body.radius, b = other(hit.ball).body.radius;
  return (a + b - norm(other(hit.ball).at - hit.at) * std::abs(std::sin(hit.cut))) / (2 * b);
}

bool may_double_hit(const Puzzle& p, const Shot& shot) {
  // The rules of pool warn of a double hit within the width of a cube of chalk (B. Jewett, "A Modest Proposal",
  // Billiards Digest, January 2006); most cubes measure 22 mm. The limit of the fullness is an assumption.
  constexpr double chalk = 0.022, frozen = 1e-6;  // m
  constexpr double fairly_full = 0.5;
  if (shot.path.hits.empty() || shot.path.hits.front().after > 0) return false;
  const Ball& other = p.others[static_cast<std::size_t>(shot.path.hits.front().ball) - 1];
  const double gap = norm(other.at - p.ball.at) - 2 * std::sqrt(p.ball.body.radius * other.body.radius);
  return gap > frozen && gap <= chalk && fullness(p, shot.path.hits.front()) >= fairly_full;
}

bool is_hopeless(const Puzzle& p, const Shot& shot) {
  constexpr double hopeless = 0.01;
  return !is_ideal(p.physics) && !p.noise.none() && shot.robustness.success && *shot.robustness.success < hopeless;
}

std::vector<std::string> warnings(const Puzzle& p, const Shot& shot) {
  std::vector<std::string> out;
  if (carries_spin(p.physics) && may_miscue(shot.spin))
    out.push_back(fmt::format(
        "likely miscue: the tip may slip off the ball, {:.2g} R from its centre, where {:.2g} R is the limit",
        tip_of(shot.spin, 1).from_centre(), miscue_limit));
  if (may_double_hit(p, shot))
    out.push_back("likely double hit: the cue ball nearly touches " +
                  contact_name(p, Contact::ball(shot.path.hits.front().ball)) + ", so lift the cue or cut it thinner");
  return out;
}

Puzzle as_played(const Puzzle& puzzle, const Shot& shot) {
  Puzzle out = shot.placed ? placed(puzzle, *shot.placed) : puzzle;
  if (shot.safety && puzzle.game) return as_safety(std::move(out));
  if (is_in_any_order(puzzle.target) && !shot.path.hits.empty())
    out.target = in_order(puzzle.target, shot.path.hits.front().ball);
  return out;
}

ShotRequest as_request(const Puzzle& p, const Shot& shot) {
  ShotRequest r{p.id, p.table, p.physics, p.ball, p.others, shot.launch, shot.spin, {}};
  if (shot.placed) r.ball.at = *shot.placed;
  r.until.time = shot.path.arrival.time;
  r.settled = p.settled;
  return r;
}

Trajectory path_of(const Puzzle& p, const Shot& shot) { return path_of(simulate(as_request(p, shot)), 0); }

const Pocket* pocket_reached(const Puzzle& p, const Shot& shot) {
  const PocketTarget* const target = pocket_of(p.target);
  if (!target || p.table.pockets.empty()) return nullptr;
  if (target->pocket) return &p.table.pockets[static_cast<std::size_t>(*target->pocket)];
  const auto off_rim = [&](const Pocket& k) { return std::abs(norm(shot.path.arrival.at - k.at) - k.radius); };
  return &*std::ranges::min_element(p.table.pockets, {}, off_rim);
}

}  // namespace bankshot
