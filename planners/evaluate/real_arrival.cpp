// SPDX-License-Identifier: MIT
#include "planners/evaluate/real_arrival.hpp"

#include <algorithm>
#include <vector>

#include "bankshot/numbers/dual.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"

namespace bankshot::planning {
namespace {

using Number = bankshot::Dual<2>;

/// The state of a ball on arrival, and its heading, also if it rests there.
struct Arrived {
  State<Number> state;
  Vec2d heading;
};

/// Returns the last ball at that time, or where it falls or rests before. None where a ball meets one that is to stand,
/// or where the last has bounced more often. A bounce at that time is taken where it is counted. A ball that is to
/// stop, and stops as it touches the cushion (as nearly as touching is told), rests as if none were there: that bounce
/// has no derivative.
template <class Motion, class Cushion>
std::optional<Arrived> follow(const SearchRequest& request, const Objects::Chain& chain, const Motion& motion,
                              ManyBalls<Number, Motion, Cushion>& sim, double seconds, std::size_t bounces) {
  const int last = static_cast<int>(chain.balls.size());
  const double same_instant = tolerance::exact_miss * (1 + seconds);
  std::size_t bounced = 0;
  bool arrived = false;
  Vec2d heading;
  const auto at = [&](const State<Number>& state) {
    const Vec2d v = value(state.velocity);
    return Arrived{state, dot(v, v) > 0 ? v : heading};
  };
  for (;;) {
    const State<Number> before = sim.state(last);
    heading = at(before).heading;
    const BallEvent e = sim.step(Number(arrived ? same_instant : seconds - sim.time().a));
    if (e.event.kind == EventKind::horizon) {
      if (arrived || bounced == bounces) return at(sim.state_now(last));
      arrived = true;
      continue;
    }
    const bool rebounds = e.event.kind == EventKind::cushion && e.ball == last;
    if (rebounds && ++bounced > bounces) return {};
    if (rebounds && arrived && bounced == bounces) return at(sim.state(last));
    if (rebounds && request.stop && bounced == bounces) {
      const Boundary& boundary = chain.moving.back();
      const State<Number> rest = arrive_locked(motion, boundary.body, before, {}, 0, true).state;
      if (!(norm(value(rest.at - sim.state(last).at)) > boundary.touch)) return at(rest);
    }
    const auto is_met = [&](const Objects::Object* ball) { return e.event.contact == Contact::ball(ball->ball); };
    if (e.event.kind == EventKind::ball && std::ranges::none_of(chain.balls, is_met)) return {};
    const bool ends = e.event.kind == EventKind::pocket || (request.stop && e.event.kind == EventKind::rest);
    if (ends && e.ball == last && sim.time().a > 0) return at(sim.state(last));
  }
}

}  // namespace

std::optional<Moved> real_arrival(const SearchRequest& request, const Shot& shot, Work& work) {
  const Objects::Chain* const chain =
      shot.path.then.empty() ? nullptr : request.problem->objects->chain_by(shot.path.then.front().ball);
  if (!chain) return {};
  return with_physics(request.puzzle().physics, [&](const auto& motion, const auto& cushion) -> std::optional<Moved> {
    std::vector<BallStart<Number>> balls{
        {&chain->moving.front(), dual_start<Number, 2>(request, shot.launch, request.spin), 0}};
    for (std::size_t i = 0; i < chain->balls.size(); ++i)
      balls.push_back({&chain->moving[i + 1], {.at = to<Number>(chain->balls[i]->at_rest.at)}, chain->balls[i]->ball});
    ManyBalls sim(std::span<const BallStart<Number>>(balls), motion, cushion, collisions(request.puzzle().physics));
    const auto arrived =
        follow(request, *chain, motion, sim, shot.path.arrival.time, shot.path.then.back().cushions.size());
    work += sim.work();
    if (!arrived) return {};
    const State<Number>& there = arrived->state;
    if (request.stop) return Moved{{there.at.x.v[0], there.at.y.v[0]}, {there.at.x.v[1], there.at.y.v[1]}};
    const double speed = norm(arrived->heading);
    if (!(speed > 0)) return {};
    const Vec2d left = perpendicular(arrived->heading) / speed;
    const Number across = dot(to<Number>(left), there.at);
    return Moved{left * across.v[0], left * across.v[1]};
  });
}

}  // namespace bankshot::planning
