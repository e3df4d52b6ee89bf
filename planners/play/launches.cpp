// SPDX-License-Identifier: MIT
#include "planners/play/launches.hpp"

#include <cmath>
#include <utility>

#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/noise_scanlines.hpp"
#include "planners/play/settings.hpp"

namespace bankshot::planning::play {

using namespace settings::leave;
using branch::aim;
using branch::log_speed;

void Launches::look_across(Root& root) const {
  if (!safest() || two_equations() || !root.branch.aim_point.drops()) return;
  const auto at = branch::look(root.branch, budget_, root.x, branch::Vary::launch);
  if (!at) return;
  const double slope = at->off[0].by[aim] * request_.problem->boundary.diagonal;
  root.slope = std::abs(slope);
  constexpr int each_way = settings::aims_across / 2;
  const double step = root.branch.aim_point.reach / each_way;
  const auto is_made = [&](int i) {
    Vector x = root.x;
    x[aim] += i * step / slope;
    const Proof proof = prove_at(x);
    return proof.holds() && request_.problem->keeps_cushions(proof.shot);
  };
  for (int i = -each_way; i <= each_way; ++i) {
    if (!is_made(i)) continue;
    const int first = i;
    while (i < each_way && is_made(i + 1)) ++i;
    const Range run{(first - 0.5) * step, (i + 0.5) * step};
    if (!root.made || run.high - run.low > root.made->high - root.made->low) root.made = run;
  }
}

double Launches::likely(const Root& root, double shift, const Shot& shot) const {
  const double estimate = shot.robustness.success_estimate, by_aim = norm(shot.verification.by_angle);
  if (!root.made || !(by_aim > 0)) return estimate;
  const Noise& noise = request_.puzzle().noise;
  const double by_speed = dot(shot.verification.by_angle / by_aim, shot.verification.by_speed);
  const double deviation = std::hypot(by_aim * noise.angle, by_speed * noise.speed_at(shot.launch.speed));
  if (!(deviation > 0)) return estimate;
  return std::max(estimate, normal_below((root.made->high - shift) / deviation) -
                                normal_below((root.made->low - shift) / deviation));
}

Proof Launches::prove_at(const Vector& x, const Shot* like) const {
  const SearchRequest own = request_.spinning(branch::spin_of(x));
  const Demand demand = !safest() ? Demand::exact : request_.puzzle().arrive ? Demand::off_centre : Demand::made;
  Goal goal = like ? Goal::counted(own, *like) : Goal::of(own);
  goal.demand = demand;
  return prove(own, budget_, branch::launch_of(x), goal);
}

std::optional<Launched> Launches::play(const Root& root, const Vector& x, double shift, const Shot* like) const {
  Proof proof = prove_at(x, like);
  if (!proof.holds() || !request_.problem->keeps_cushions(proof.shot)) return {};
  const SearchRequest own = request_.spinning(branch::spin_of(x));
  Ending ending = play_out(own, budget_, proof.shot.launch);
  if (!ending.cue_rests()) return {};
  proof.shot.path.cue_rests = ending.cue_rests();
  add_first_order(own, proof.shot, budget_.work());
  proof.shot.provenance.planner = word::continuation;
  proof.shot.provenance.simulations = budget_.simulations();
  Launched out{&root, x, shift, std::move(proof.shot), std::move(ending)};
  out.promise = likely(root, shift, out.shot) * worth_(out.ending) - cost_of(out.shot);
  return out;
}

std::optional<Launched> Launches::play_near(const Root& root, const Vector& x, double shift, const Shot* like) const {
  const auto there = on_target(root.branch, budget_, box_, x, shift);
  return there ? play(root, *there, shift, like) : std::nullopt;
}

std::vector<Launches::Move> Launches::moves_of(const Launched& one) const {
  std::vector<Move> moves;
  if (safest() && !two_equations()) {
    const AimPoint& point = one.root->branch.aim_point;
    const double width = point.cuts ? point.cuts->high - point.cuts->low : 2 * point.reach;
    moves.push_back({-1, step_across * width});
  }
  if (!speed_given()) moves.push_back({log_speed, step_speed});
  for (const int c : {branch::top, branch::side, branch::masse})
    if (box_.free(c)) moves.push_back({c, step_spin});
  return moves;
}

void Launches::climb(Launched& best, double scale, const std::function<bool(Launched&)>& is_better) const {
  const std::vector<Move> moves = moves_of(best);
  for (bool better = true; better && !budget_.spent();) {
    better = false;
    for (const Move& move : moves)
      for (const double sign : {1.0, -1.0}) {
        Vector x = best.x;
        double shift = best.shift;
        if (move.coordinate < 0)
          shift += sign * scale * move.step;
        else
          x[move.coordinate] = std::clamp(x[move.coordinate] + sign * scale * move.step, box_.low[move.coordinate],
                                          box_.high[move.coordinate]);
        if (x == best.x && shift == best.shift) continue;
        auto one = play_near(*best.root, x, shift, &best.shot);
        if (!one || !is_better(*one)) continue;
        best = *std::move(one);
        better = true;
        break;
      }
  }
}

}  // namespace bankshot::planning::play
