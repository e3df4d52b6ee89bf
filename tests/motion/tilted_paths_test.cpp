// SPDX-License-Identifier: MIT
//
// Compares whole shots on tilted tables, off up to six cushions, with an independent computation in 50 digits. It uses
// closed forms with exponentials (support/incline_forms.hpp) where the simulator sums series in pieces. It finds
// cushions by sampling the path itself where the simulator solves its chords. Both share the laws of the cushions,
// which have tests of their own. The bound is that of simulate/simulator.hpp, property 6.
#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/catch.hpp"
#include "support/incline_forms.hpp"
#include "support/random_shot.hpp"
#include "support/seed.hpp"
#include "truth/condition.hpp"

using namespace bankshot;
using namespace bankshot::test;

namespace {

constexpr int most_cushions = 6;

/// A slide or a roll that starts from a state.
template <class T>
struct Phase {
  bool slides;
  T M, a, share, R;
  Vec2<T> e, w, weight;
  State<T> from;

  Phase(const Tilted& m, double radius, const State<T>& s, bool rolls) : slides(!rolls), R(radius), from(s) {
    const Vec2<T> rise{T(m.rise.x), T(m.rise.y)};
    const T slope = norm(rise), g(m.g);
    e = rise * T(T(-1) / slope);
    M = T(rolls ? m.rolling_friction.at_rest : m.sliding_friction) * g * (rolls ? T(1) : T(T(7) / 2));
    a = slope * g * (rolls ? T(T(5) / 7) : T(1));
    share = rolls ? T(1) : T(T(2) / 7);
    w = rolls ? s.velocity : Vec2<T>{T(s.velocity.x - R * s.spin.y), T(s.velocity.y + R * s.spin.x)};
    weight = rolls ? Vec2<T>{T(0), T(0)} : e * T(slope * g * 5 / 7);
  }

  State<T> at(const T& sigma, const Tilted& m, T& time) const {
    const Carried<T> c = carried<T>(M, a, e, w, sigma);
    const T t = time = c.time;
    State<T> s = from;
    s.at = from.at + from.velocity * t + (c.moved - w * t) * share + weight * T(t * t / 2);
    s.velocity = from.velocity + (c.w - w) * share + weight * t;
    const Vec2<T> u = slides ? c.w : Vec2<T>{T(0), T(0)};
    s.spin.x = (u.y - s.velocity.y) / R;
    s.spin.y = (s.velocity.x - u.x) / R;
    const T lost = t * T(5) / 2 * T(m.spinning_friction) * T(m.g) / R;
    s.spin.z = s.spin.z > lost ? T(s.spin.z - lost) : s.spin.z < -lost ? T(s.spin.z + lost) : T(0);
    return s;
  }
};

State<double> rounded(const State<Long>& s) {
  const auto d = [](const Long& x) { return static_cast<double>(x); };
  return {{d(s.at.x), d(s.at.y)}, {d(s.velocity.x), d(s.velocity.y)}, {d(s.spin.x), d(s.spin.y), d(s.spin.z)}};
}

/// The end of a phase: the first of some walls, between two samples, or without a wall its own end.
struct Meets {
  std::vector<const Wall*> walls{};
  double before = 0, after = 0;  ///< σ
  bool decided = true;
};

/// Finds the end of a phase by samples in double. Between two samples w changes by at most a hundredth, and the ball
/// moves by at most a hundredth of the table. `left` is the wall on which the path begins.
Meets first_met(const Phase<double>& p, const Tilted& m, const Boundary& b, const Wall* left) {
  constexpr double part = 0.01;
  const auto gap = [&](std::size_t i, const State<double>& s) {
    return dot(b.walls[i].normal, s.at) - b.walls[i].offset;
  };
  Meets met;
  std::vector<double> before(b.walls.size()), previous(b.walls.size());
  double time = 0, sigma = 0;
  State<double> s = p.from;
  for (std::size_t i = 0; i < b.walls.size(); ++i) before[i] = previous[i] = gap(i, p.from);
  constexpr int enough = 200000;
  for (int k = 1; k < enough; ++k) {
    const double q = norm(carried<double>(p.M, p.a, p.e, p.w, sigma).w), speed = norm(s.velocity);
    const double step = std::min(part / (p.M + p.a), part * b.extent / (q * std::max(q, speed)));
    s = p.at(sigma += step, m, time);
    for (std::size_t i = 0; i < b.walls.size(); ++i) {
      const double now = gap(i, s);
      // The least gap may be below 0 between the samples.
      const double falls = before[i] - previous[i], rises = now - previous[i];
      if (k > 2 && falls > 0 && rises > 0 && previous[i] < falls + rises) return {.decided = false};
      if (now < 0 && !(left == &b.walls[i] && k < 3)) met.walls.push_back(&b.walls[i]);
      before[i] = previous[i], previous[i] = now;
    }
    met.before = std::exchange(met.after, sigma);
    if (!met.walls.empty()) return met;
    if (p.M > p.a && std::exp(-(p.M - p.a) * sigma) < 1e-9) return {};
  }
  return {.decided = false};
}

/// Returns the σ at which the gap to that wall is 0, in 50 digits, by bisection and then by secants.
Long root(const Phase<Long>& p, const Tilted& m, const Meets& met, const Wall& w) {
  Long time;
  const Vec2<Long> n{Long(w.normal.x), Long(w.normal.y)};
  const auto gap = [&](const Long& sigma) { return Long(dot(n, p.at(sigma, m, time).at) - Long(w.offset)); };
  Long high(met.after), low(met.before), f_high = gap(high), f_low = gap(low);
  for (int i = 0; i < 12; ++i) {
    const Long middle = (low + high) / 2, f = gap(middle);
    (f > 0 ? low : high) = middle;
    (f > 0 ? f_low : f_high) = f;
  }
  for (int i = 0; i < 12 && high != low && f_high != f_low; ++i) {
    const Long next = high - f_high * (high - low) / (f_high - f_low);
    low = high, f_low = f_high;
    high = next, f_high = gap(high);
    if (abs(f_high) < Long("1e-45")) break;
  }
  return high;
}

struct Found {
  std::vector<std::pair<EventKind, Contact>> events{};
  State<Long> end{};
  int cushions = 0;
  bool decided = true;
};

Found follow(const ShotRequest& shot, const Boundary& b) {
  const Tilted m = tilted(shot.physics);
  const State<double> start = start_state(shot);
  State<Long> s{
      to<Long>(start.at), to<Long>(start.velocity), {Long(start.spin.x), Long(start.spin.y), Long(start.spin.z)}};
  Found out;
  const double radius = shot.ball.body.radius;
  const Vec2d slip = SlideRoll::slip(shot.ball.body, start);
  bool rolls = dot(slip, slip) <= tolerance::slip * tolerance::slip * squared_scale(start, radius);
  const Wall* left = nullptr;
  for (int phases = 0; phases < 3 * most_cushions; ++phases) {
    const Phase<Long> phase(m, radius, s, rolls);
    const Phase<double> rough(m, radius, rounded(s), rolls);
    const Meets met = first_met(rough, m, b, left);
    if (!met.decided) return {.decided = false};
    Long lasts;
    if (met.walls.empty()) {
      s = phase.at(Long(-1), m, lasts);
      out.events.push_back({rolls ? EventKind::rest : EventKind::slide_to_roll, {}});
      if (rolls) break;
      rolls = true;
      left = nullptr;
      continue;
    }
    std::vector<std::pair<Long, const Wall*>> roots;
    for (const Wall* wall : met.walls) roots.emplace_back(root(phase, m, met, *wall), wall);
    std::ranges::sort(roots);
    const Wall& w = *roots[0].second;
    s = phase.at(roots[0].first, m, lasts);
    out.events.push_back({EventKind::cushion, w.contact});
    std::visit([&](const auto& cushion) { cushion.bounce(shot.ball.body, s, Vec2<double>(w.normal)); },
               shot.physics.cushion);
    left = &w;
    rolls = false;
    const double leaves = static_cast<double>(dot(to<Long>(w.normal), s.velocity));
    // A slower ball is soon held by a cushion, which follows another law (detail/held.hpp).
    if (++out.cushions == most_cushions || leaves < 0.01) break;
  }
  out.end = s;
  return out;
}

}  // namespace

TEST_CASE("whole shots on a leaning table are where exponentials in 50 digits lead them") {
  const std::uint64_t seed = 31;
  Random r(seed);
  int compared = 0, undecided = 0, bounces = 0, rests = 0;
  double worst = 0;
  while (compared < 1000) {
    ShotRequest shot = random_shot(r, ShotFamily::tilted);
    const auto* motion = std::get_if<SlideRoll>(&shot.physics.motion);
    const Boundary boundary(shot.table, shot.ball.body);
    if (!motion || motion->rolling_friction.per_speed != 0 || !boundary.strictly_convex) continue;
    const Found truth = follow(shot, boundary);
    if (!truth.decided || truth.events.empty()) {
      ++undecided;
      continue;
    }
    truth::Run run{boundary, shot.physics, start_state(shot)};
    run.events = static_cast<long>(truth.events.size());
    const truth::Path path = truth::run_double(run);
    INFO("shot " << compared << " of seed " << seed << ": " << write_shot(shot));
    REQUIRE(path.events.size() == truth.events.size());
    for (std::size_t i = 0; i < path.events.size(); ++i) {
      INFO("event " << i);
      REQUIRE(path.events[i].kind == truth.events[i].first);
      REQUIRE(path.events[i].contact == truth.events[i].second);
    }
    const truth::TruthEvent& end = path.events.back();
    const double off = static_cast<double>(norm(truth.end.at - to<Long>(end.state.at)));
    const double unit = 0x1p-53 * tolerance::pieces_rounding * boundary.extent * truth::condition(run).kappa;
    CHECK(off <= tolerance::simulation_error * unit);
    worst = std::max(worst, off / unit);
    ++compared, bounces += truth.cushions, rests += truth.events.back().first == EventKind::rest;
  }
  std::printf("leaning paths: %d shots, %d bounces, %d to rest; worst %.2g units (C = %g), %d undecided\n", compared,
              bounces, rests, worst, tolerance::simulation_error, undecided);
  CHECK(undecided < 50);
  CHECK(bounces > 2000);
  CHECK(rests > 100);
}
