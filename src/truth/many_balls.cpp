// SPDX-License-Identifier: MIT
#include "truth/many_balls.hpp"

#include <boost/multiprecision/cpp_dec_float.hpp>

#include "truth/follow.hpp"

namespace bankshot::truth {
namespace {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

template <class T>
std::vector<BallTruth> run(const ShotRequest& request, std::size_t most, double turned) {
  const Starts starts(request);
  std::vector<BallStart<T>> balls;
  for (const BallStart<double>& b : starts.balls()) balls.push_back({b.boundary, lift<T>(b.state)});
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
      const BallEvent e = sim.step();
      if (e.event.kind == EventKind::horizon) break;
      const State<T>& s = sim.state(e.ball);
      out.push_back(
          {e, rounded(sim.time()), {rounded(s.at.x), rounded(s.at.y)}, {rounded(s.velocity.x), rounded(s.velocity.y)}});
    }
    return out;
  });
}

}  // namespace

std::vector<BallTruth> run_many_truth(const ShotRequest& request, std::size_t most, double turned) {
  return run<Digits50>(request, most, turned);
}

std::vector<BallTruth> run_many_double(const ShotRequest& request, std::size_t most) {
  return run<double>(request, most, 0);
}

}  // namespace bankshot::truth
