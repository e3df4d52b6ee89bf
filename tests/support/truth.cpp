// SPDX-License-Identifier: MIT
#include "support/truth.hpp"

#include <ceres/jet.h>

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>

namespace bankshot::test {
namespace {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;
using Jet = ceres::Jet<double, 7>;

constexpr double unit_roundoff = 0x1p-53;

double rounded(double x) { return x; }
double rounded(const Digits50& x) { return x.convert_to<double>(); }

template <class T>
State<T> lift(const State<double>& s) {
  return {to<T>(s.at), to<T>(s.velocity), {T(s.spin.x), T(s.spin.y), T(s.spin.z)}};
}

template <class T>
TruthEvent note(const Event& e, const T& time, const State<T>& s) {
  const double t = rounded(time), x = rounded(s.at.x), y = rounded(s.at.y);
  const Vec2d v{rounded(s.velocity.x), rounded(s.velocity.y)};
  return {e.kind, e.index, t, rounded(T(time - t)), {{x, y}, v, {rounded(s.spin.x), rounded(s.spin.y), rounded(s.spin.z)}},
          {rounded(T(s.at.x - x)), rounded(T(s.at.y - y))}};
}

/// Runs in T and hands each event to `see(event, simulator)`; true when the shot came to its end.
template <class T, class See>
bool follow(const Run& run, const State<T>& start, See&& see) {
  return with_physics(run.physics, [&](const auto& motion, const auto& cushion) {
    Simulator sim(run.boundary, motion, cushion, start);
    int cushions = 0;
    for (long i = 0; i < run.events; ++i) {
      const Event e = sim.step();
      see(e, sim);
      if (e.kind == EventKind::cushion) ++cushions;
      if (e.final() || cushions >= run.cushions) return e.kind != EventKind::horizon;
    }
    return false;
  });
}

template <class T>
Path recorded(const Run& run, const State<T>& start) {
  Path path;
  Vec2d last = run.start.at;
  path.ended = follow<T>(run, start, [&](const Event& e, const auto& sim) {
    path.events.push_back(note(e, sim.time(), sim.state()));
    path.length += norm(path.events.back().state.at - last);
    last = path.events.back().state.at;
  });
  return path;
}

/// Whether a and b meet the same events, up to the order of two cushions at one instant.
std::size_t agree(const Path& a, const Path& b) {
  const std::size_t n = std::min(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < n; ++i)
    if (a.events[i].kind != b.events[i].kind || a.events[i].index != b.events[i].index) return i;
  return n;
}

bool same(const Path& a, const Path& b) { return a.events.size() == b.events.size() && agree(a, b) == a.events.size(); }

/// The events in double are those of an exact path from a start this close, relative to its own size.
bool nearby_start(const Run& run, const Path& rough) {
  constexpr double step = 1e-13;
  const double v = norm(run.start.velocity), w = run.boundary.radius > 0 ? v / run.boundary.radius : 0;
  for (const double sign : {1.0, -1.0})
    for (int k = 0; k < 7; ++k) {
      State<double> s = run.start;
      const double by = sign * step;
      if (k < 2) (k == 0 ? s.at.x : s.at.y) += by * run.boundary.extent;
      else if (k < 4) s.velocity += k == 2 ? s.velocity * by : perpendicular(s.velocity) * by;
      else (k == 4 ? s.spin.x : k == 5 ? s.spin.y : s.spin.z) += by * w;
      if (same(rough, recorded(run, lift<Digits50>(s)))) return true;
    }
  return false;
}

}  // namespace

Path run_double(const Run& run) { return recorded(run, run.start); }
Path run_truth(const Run& run) { return recorded(run, lift<Digits50>(run.start)); }

Condition condition(const Run& run) {
  State<Jet> s = lift<Jet>(run.start);
  Jet* const inputs[] = {&s.at.x, &s.at.y, &s.velocity.x, &s.velocity.y, &s.spin.x, &s.spin.y, &s.spin.z};
  for (int k = 0; k < 7; ++k) inputs[k]->v[k] = 1;
  Vec2<Jet> end = s.at;
  follow<Jet>(run, s, [&](const Event&, const auto& sim) { end = sim.state().at; });
  const double R = run.boundary.radius, V = norm(run.start.velocity) + R * std::hypot(run.start.spin.x, run.start.spin.y, run.start.spin.z);
  const double by_spin = R > 0 ? V / R : 0, extent = run.boundary.extent;
  const double scale[] = {extent, extent, V, V, by_spin, by_spin, by_spin};
  Condition c;
  double square = 0;
  for (int k = 0; k < 7; ++k) {
    c.jacobian[0][k] = end.x.v[k];
    c.jacobian[1][k] = end.y.v[k];
    square += std::pow(std::hypot(end.x.v[k], end.y.v[k]) * scale[k] / extent, 2);
  }
  c.kappa = std::max(1.0, std::sqrt(square));
  return c;
}

Compared compare_with_truth(const Run& run) {
  const Path rough = run_double(run), exact = run_truth(run);
  Compared c{.events = rough.events.size()};
  c.kappa = condition(run).kappa;
  c.unit = unit_roundoff * (run.boundary.extent + std::max(rough.length, exact.length)) * c.kappa;
  if (!same(rough, exact)) {
    // Where they part, the events that compete lie within the bound, as times at the speed of the ball.
    const std::size_t i = agree(rough, exact);
    c.order = Compared::Order::wrong;
    if (i < std::min(rough.events.size(), exact.events.size())) {
      const double speed = norm(exact.events[i].state.velocity), apart = std::abs(rough.events[i].time - exact.events[i].time);
      if (apart * speed <= tolerance::simulation_error * c.unit) c.order = Compared::Order::tie;
    }
    if (c.order == Compared::Order::wrong && nearby_start(run, rough)) c.order = Compared::Order::tie;
    return c;
  }
  const TruthEvent &a = rough.events.back(), &b = exact.events.back();
  c.error = norm((a.state.at - b.state.at) - b.at_rest);
  return c;
}

}  // namespace bankshot::test
