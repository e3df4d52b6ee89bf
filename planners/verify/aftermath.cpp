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

/// Returns all balls, the cue ball in this state.
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

/// Balls that are left on the table, the cue ball first.
struct Left {
  Balls balls{};
  std::vector<std::size_t> numbers{};

  void add(std::size_t number, const BallStart<double>& ball) {
    numbers.push_back(number);
    balls.push_back(ball);
  }
};

/// Returns the places of all balls when those that are left rest, or the cue ball falls.
std::vector<std::optional<Vec2d>> places_after(const SearchRequest& request, EvaluationBudget& budget,
                                               const Left& left) {
  std::vector<std::optional<Vec2d>> places(request.puzzle().others.size() + 1);
  follow_all(request, budget, left.balls, max_events, [&](const BallEvent& e, const auto& sim) {
    if (e.event.kind == EventKind::pocket && e.ball == 0) return true;
    if (e.event.kind != EventKind::horizon) return false;
    for (std::size_t i = 0; i < left.numbers.size(); ++i)
      if (const int ball = static_cast<int>(i); sim.in_play(ball)) places[left.numbers[i]] = sim.state(ball).at;
    return true;
  });
  return places;
}

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
    case EventKind::pocket:
      out.places[static_cast<std::size_t>(e.ball)].reset();
      break;
    default:
      break;
  }
}

}  // namespace

Aftermath aftermath(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch) {
  const bool rests = !is_ideal(request.puzzle().physics);
  if (!request.problem->whole || (request.puzzle().table.pockets.empty() && !rests)) return {};
  Aftermath out;
  const Balls balls = balls_of(request, start_of(request, launch));
  follow_all(request, budget, balls, rests ? max_events : ideal_cushions, [&](const BallEvent& e, const auto& sim) {
    const bool scratch = e.event.kind == EventKind::pocket && e.ball == 0;
    const bool over = scratch || e.event.kind == EventKind::horizon;
    if (scratch) out.scratch_pocket = e.event.contact.index;
    if (over && !scratch && rests) out.cue_rests = sim.state(0).at;
    return over;
  });
  return out;
}

void add_aftermath(const SearchRequest& request, EvaluationBudget& budget, Shot& shot) {
  if (shot.path.hits.empty()) return;
  const Aftermath after = aftermath(request, budget, shot.launch);
  shot.path.scratch_pocket = after.scratch_pocket;
  shot.path.scratch = after.scratch_pocket.has_value();
  shot.path.cue_rests = after.cue_rests;
}

Ending play_out(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch) {
  Ending out;
  const std::size_t count = request.puzzle().others.size() + 1;
  std::vector<bool> moved(count, false);
  out.places.assign(count, Vec2d{});
  const Balls balls = balls_of(request, start_of(request, launch));
  follow_all(request, budget, balls, max_events, [&](const BallEvent& e, const auto& sim) {
    note(e, moved, out);
    const bool scratch = !out.places.front();
    if (scratch) return true;
    if (e.event.kind != EventKind::horizon) return false;
    for (std::size_t k = 0; k < count; ++k)
      if (out.places[k]) out.places[k] = sim.state(static_cast<int>(k)).at;
    return true;
  });
  return out;
}

Ending ending_of(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, const Replay& made) {
  if (!made.cue) return play_out(request, budget, launch);
  Left left;
  const auto balls = request.problem->whole->balls();
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const auto fell = [&](const ObjectBallPath& sent) { return static_cast<std::size_t>(sent.ball) == k; };
    if (std::ranges::none_of(made.then, fell)) left.add(k, balls[k]);
  }
  left.balls.front().state = *made.cue;
  return {.places = places_after(request, budget, left), .rail_after_contact = true};
}

std::vector<std::optional<Vec2d>> play_on(const SearchRequest& request, EvaluationBudget& budget,
                                          std::span<const std::optional<Vec2d>> places, const Launch& launch,
                                          const LaunchSpin& spin) {
  Left left;
  const auto balls = request.problem->whole->balls();
  for (std::size_t k = 0; k < balls.size(); ++k) {
    if (!places[k]) continue;
    left.add(k, balls[k]);
    left.balls.back().state = {.at = *places[k]};
  }
  left.balls.front().state =
      launched(*places.front(), request.puzzle().ball.body.radius, direction(launch.angle) * launch.speed, spin);
  return places_after(request, budget, left);
}

}  // namespace bankshot::planning
