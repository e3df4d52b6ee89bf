// SPDX-License-Identifier: MIT
#include "truth/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "truth/follow.hpp"

namespace bankshot::truth {
namespace {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

template <class T>
std::vector<BallTruth> run(const ShotRequest& request, std::size_t most, double turned) {
  const Starts starts(request);
  std::vector<BallStart<T>> balls;
  for (const BallStart<double>& b : starts.balls()) balls.push_back({b.boundary, to<T>(b.state)});
  const T turn(turned);
  const auto rotate = [&](T& x, T& y) {
    const T before = x;
    x = before - turn * y;
    y = y + turn * before;
  };
  rotate(balls.front().state.velocity.x, balls.front().state.velocity.y);
  rotate(balls.front().state.spin.x, balls.front().state.spin.y);
  return with_physics(request.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(std::span<const BallStart<T>>(balls), motion, cushion, collisions(request.physics));
    std::vector<BallTruth> out;
    while (out.size() < most) {
      BallEvent e = sim.step();
      if (e.event.kind == EventKind::horizon) break;
      const State<T>& s = sim.state(e.ball);
      out.push_back(
          {e, rounded(sim.time()), {rounded(s.at.x), rounded(s.at.y)}, {rounded(s.velocity.x), rounded(s.velocity.y)}});
    }
    return out;
  });
}

/// A completed arc.
template <class T>
struct Flown {
  T began;
  Arc<T> arc;
  T travelled;
};

template <class T>
Passing passing_of(const Run& run, const BallEvent& e, const Starts& starts, const Flown<T>& last, const Vec2d& met) {
  if (e.event.kind == EventKind::ball) {
    const Vec2d from = run.sends == 0 ? run.target.value_or(met) : met;
    return passing<T>(last.arc, last.began, last.travelled, from);
  }
  if (e.event.kind != EventKind::pocket && e.event.kind != EventKind::jaw) return {};
  const Boundary& boundary = *starts.balls()[static_cast<std::size_t>(e.ball)].boundary;
  Passing p =
      passing<T>(last.arc, last.began, last.travelled, run.target.value_or(boundary.rim(towards(e.event))->centre));
  p.miss = std::abs(p.lateral);
  return p;
}

template <class T>
Path run_all(const Run& run) {
  const Starts starts(*run.all);
  std::vector<BallStart<T>> balls;
  for (const BallStart<double>& b : starts.balls()) balls.push_back({b.boundary, to<T>(b.state)});
  balls.front().state = start_of<T>(run);
  return with_physics(run.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(std::span<const BallStart<T>>(balls), motion, cushion, collisions(run.physics));
    Path path;
    std::vector<Flown<T>> last(balls.size());
    // In `ideal` physics, the cue ball may bounce very often before a slow ball arrives.
    constexpr long patience = 20;
    int on_its_way = 0, contacts = 0;
    for (long i = 0; i < patience * run.events; ++i) {
      const auto look = [&](int ball, const T& began, const State<T>& start, const Arc<T>& arc, const T& travelled) {
        last[static_cast<std::size_t>(ball)] = {began, arc, travelled};
        if (ball == 0) return;
        const Passing p = run.target
                              ? passing<T>(arc, began, detail::closest_time(arc, travelled, *run.target), *run.target)
                              : Passing{};
        path.events.push_back(note<T>({EventKind::slide_to_roll}, T(began + arc.seconds(travelled)), start, p, ball));
      };
      BallEvent e = sim.step(T(forever), look);
      if (e.event.kind == EventKind::horizon) {
        path.ended = true;
        break;
      }
      Vec2d met{};
      const bool meets = e.event.kind == EventKind::ball;
      // The ball on its way to the target counts as the hitting ball.
      if (meets && e.event.contact.index == on_its_way) e = {on_its_way, {EventKind::ball, Contact::ball(e.ball)}};
      if (meets) {
        const State<T>& other = sim.state(e.event.contact.index);
        met = {rounded(other.at.x), rounded(other.at.y)};
      }
      // Two other balls meet: the moving ball's arc up to this time counts, and nothing after it.
      const bool others_meet = meets && on_its_way != 0 && e.ball != on_its_way;
      if (others_meet) sim.stop(look);
      const Passing p = passing_of<T>(run, e, starts, last[static_cast<std::size_t>(e.ball)], met);
      path.events.push_back(note<T>(e.event, sim.time(), sim.state(e.ball), p, e.ball));
      // The path ends when the ball on its way to the target rests, falls or has one contact too many.
      const bool ended = e.event.kind == EventKind::pocket || e.event.kind == EventKind::rest;
      path.ended = path.ended || others_meet;
      if (others_meet) break;
      if (e.ball != on_its_way) continue;
      contacts += meets;
      if (ended || contacts > std::max(run.sends, 1)) {
        path.ended = true;
        break;
      }
      if (meets && run.sends > 0) on_its_way = e.event.contact.index;
    }
    return path;
  });
}

}  // namespace

Path run_all_truth(const Run& run) { return run_all<Digits50>(run); }
Path run_all_double(const Run& run) { return run_all<double>(run); }

std::vector<BallTruth> run_many_truth(const ShotRequest& request, std::size_t most, double turned) {
  return run<Digits50>(request, most, turned);
}

std::vector<BallTruth> run_many_double(const ShotRequest& request, std::size_t most) {
  return run<double>(request, most, 0);
}

}  // namespace bankshot::truth
