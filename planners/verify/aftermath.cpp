// SPDX-License-Identifier: MIT
#include "planners/verify/aftermath.hpp"

#include <algorithm>
#include <vector>

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"

namespace bankshot::planning {
namespace {

using Balls = std::vector<BallStart<double>>;

/// Returns all balls with their numbers, the cue ball in this state.
Balls balls_of(const SearchRequest& request, const State<double>& cue) {
  Balls balls(request.problem->whole->balls().begin(), request.problem->whole->balls().end());
  balls.front().state = cue;
  return balls;
}

/// Plays balls on. `look(event, simulator)` sees each event, and says when it has seen enough.
template <class Look>
void follow_all(const SearchRequest& request, EvaluationBudget& budget, const Balls& balls, long most, Look&& look) {
  budget.charge(0);
  with_physics(request.puzzle().physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(std::span<const BallStart<double>>(balls), motion, cushion, collisions(request.puzzle().physics));
    for (long i = 0; i < most && !look(sim.step(), sim); ++i) {
    }
    budget.work() += sim.work();
  });
}

/// Returns the places of all balls when those that are left rest, or the cue ball falls. It is the first of them.
/// `see(event)` sees each event.
template <class See>
std::vector<std::optional<Vec2d>> places_after(const SearchRequest& request, EvaluationBudget& budget,
                                               const Balls& left, See&& see) {
  std::vector<std::optional<Vec2d>> places(request.problem->whole->balls().size());
  follow_all(request, budget, left, max_events, [&](const BallEvent& e, const auto& sim) {
    see(e);
    if (e.event.kind == EventKind::pocket && e.ball == 0) return true;
    if (e.event.kind != EventKind::horizon) return false;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (const int ball = static_cast<int>(i); sim.in_play(ball))
        places[static_cast<std::size_t>(left[i].number)] = sim.state(ball).at;
    return true;
  });
  return places;
}

constexpr auto unwatched = [](const BallEvent&) {};

/// Notes what the cue ball meets in an event.
void note(const BallEvent& e, std::vector<bool>& moved, Ending& out) {
  const Contact with = e.event.contact;
  const bool rail = e.event.kind == EventKind::cushion || e.event.kind == EventKind::jaw;
  if (out.after_balls > 0 && (rail || e.event.kind == EventKind::pocket)) out.rail_after_contact = true;
  switch (e.event.kind) {
    case EventKind::ball: {
      const auto other = static_cast<std::size_t>(with.index);
      if (e.ball == 0) {
        out.traceable = out.traceable && !moved[other];
        out.cue.push_back({0, with});
        out.after_balls = out.cue.size();
      }
      moved[other] = moved[static_cast<std::size_t>(e.ball)] = true;
      break;
    }
    case EventKind::cushion:
      if (e.ball == 0) out.cue.push_back({0, with});
      break;
    case EventKind::jaw:
      if (e.ball == 0) out.traceable = false;
      break;
    default:
      break;
  }
}

}  // namespace

void add_aftermath(const SearchRequest& request, EvaluationBudget& budget, Shot& shot) {
  const bool rests = !is_ideal(request.puzzle().physics);
  const bool ends = rests || !request.puzzle().table.pockets.empty();
  if (shot.path.hits.empty() || !request.problem->whole || !ends) return;
  const Balls balls = balls_of(request, start_of(request, shot.launch));
  follow_all(request, budget, balls, rests ? max_events : ideal_cushions, [&](const BallEvent& e, const auto& sim) {
    shot.path.scratch = e.event.kind == EventKind::pocket && e.ball == 0;
    if (shot.path.scratch) shot.path.scratch_pocket = e.event.contact.index;
    const bool at_rest = e.event.kind == EventKind::horizon;
    if (at_rest && rests) shot.path.cue_rests = sim.state(0).at;
    return shot.path.scratch || at_rest;
  });
}

Ending play_out(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch) {
  Ending out;
  const Balls balls = balls_of(request, start_of(request, launch));
  std::vector<bool> moved(balls.size(), false);
  out.places = places_after(request, budget, balls, [&](const BallEvent& e) { note(e, moved, out); });
  return out;
}

Ending ending_of(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Replay& made) {
  if (!made.cue) return play_out(request, budget, launch);
  Balls left = balls_of(request, *made.cue);
  std::erase_if(left, [&](const auto& ball) { return ball.number == made.path.then.front().ball; });
  return {.places = places_after(request, budget, left, unwatched), .rail_after_contact = true};
}

std::vector<std::optional<Vec2d>> play_on(const SearchRequest& request, EvaluationBudget& budget,
                                          std::span<const std::optional<Vec2d>> places, const Launch& launch,
                                          const LaunchSpin& spin) {
  Balls left = balls_of(request, launched(*places.front(), request.puzzle().ball.body.radius,
                                          direction(launch.angle) * launch.speed, spin));
  std::erase_if(left, [&](const auto& ball) { return !places[static_cast<std::size_t>(ball.number)]; });
  for (auto& ball : std::span(left).subspan(1)) ball.state = {.at = *places[static_cast<std::size_t>(ball.number)]};
  return places_after(request, budget, left, unwatched);
}

}  // namespace bankshot::planning
