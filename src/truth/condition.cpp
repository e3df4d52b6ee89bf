// SPDX-License-Identifier: MIT
#include "truth/condition.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "bankshot/numbers/dual.hpp"
#include "truth/follow.hpp"

namespace bankshot::truth {
namespace {

using Dual = bankshot::Dual<7>;

/// Returns the relative error of one step of the simulator, by rounding or integration.
double error_of_a_step(const Physics& p) {
  const double* const integrated = impact_tolerance(p.cushion);
  return integrated ? *integrated : 0x1p-53 * (is_level(p) ? 1 : tolerance::pieces_rounding);
}

using Step = Eigen::Matrix<double, 7, 7>;

/// Makes the seven numbers of a state the variables of differentiation.
State<Dual> seeded(State<Dual> s) {
  Dual* const inputs[] = {&s.at.x, &s.at.y, &s.velocity.x, &s.velocity.y, &s.spin.x, &s.spin.y, &s.spin.z};
  for (int k = 0; k < 7; ++k) *inputs[k] = Dual(inputs[k]->a, k);
  return s;
}

Step jacobian_of(const State<Dual>& s) {
  const Dual* const outputs[] = {&s.at.x, &s.at.y, &s.velocity.x, &s.velocity.y, &s.spin.x, &s.spin.y, &s.spin.z};
  Step j;
  for (int k = 0; k < 7; ++k) j.row(k) = Eigen::Map<const Eigen::Matrix<double, 1, 7>>(outputs[k]->v.data());
  return j;
}

double speed_scale(const State<Dual>& s, double radius) {
  return std::hypot(s.velocity.x.a, s.velocity.y.a) + radius * std::hypot(s.spin.x.a, s.spin.y.a, s.spin.z.a);
}

/// Returns the number of leading events that a and b have in common.
std::size_t agree(const Path& a, const Path& b) {
  const std::size_t n = std::min(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < n; ++i)
    if (a.events[i].kind != b.events[i].kind || a.events[i].contact != b.events[i].contact) return i;
  return n;
}

bool same(const Path& a, const Path& b) { return a.events.size() == b.events.size() && agree(a, b) == a.events.size(); }

/// Removes slides that last less than the ball needs to cross the bound. Whether such a slide exists depends on
/// the rounding of a slip near 0.
Path without_tiny_slides(Path path, double bound) {
  double before = 0;
  std::erase_if(path.events, [&](const TruthEvent& e) {
    const double lasted = e.time - std::exchange(before, e.time);
    return e.kind == EventKind::slide_to_roll && lasted * norm(e.state.velocity) <= bound;
  });
  return path;
}

/// Returns true if the events in double are those of an exact path whose start differs by 1e-13 in one number.
bool nearby_start(const Run& run, const Path& rough) {
  constexpr double step = 1e-13;
  const double v = norm(run.start.velocity), w = run.boundary.body.radius > 0 ? v / run.boundary.body.radius : 0;
  for (const double sign : {1.0, -1.0})
    for (int k = 0; k < 7; ++k) {
      State<double> s = run.start;
      const double by = sign * step;
      if (k < 2)
        (k == 0 ? s.at.x : s.at.y) += by * run.boundary.extent;
      else if (k < 4)
        s.velocity += k == 2 ? s.velocity * by : perpendicular(s.velocity) * by;
      else
        (k == 4 ? s.spin.x : k == 5 ? s.spin.y : s.spin.z) += by * w;
      Run near = run;
      near.start = s;
      if (same(rough, run_truth(near))) return true;
    }
  return false;
}

}  // namespace

Condition condition(const Run& run) {
  const double R = run.boundary.body.radius, extent = run.boundary.extent;
  Condition c;
  std::vector<Step> steps;
  std::vector<double> scales{speed_scale(to<Dual>(run.start), R)};
  follow<Dual>(run, seeded(to<Dual>(run.start)), [&](const Event& e, auto& sim) {
    c.events.push_back({e.kind, e.contact});
    steps.push_back(jacobian_of(sim.state()));
    scales.push_back(speed_scale(sim.before(), R));
    sim.resume(seeded(sim.state()));
  });
  Eigen::Matrix<double, 2, 7> j = Eigen::Matrix<double, 2, 7>::Identity();
  double sum = 0;
  for (std::size_t k = steps.size(); k-- > 0;) {
    j = (j * steps[k]).eval();
    const double V = scales[k], by_spin = R > 0 ? V / R : 0;
    const Eigen::Matrix<double, 7, 1> scale{extent, extent, V, V, by_spin, by_spin, by_spin};
    c.of_start = (j * scale.asDiagonal()).norm() / extent;
    sum += c.of_start;
  }
  c.kappa = std::max(1.0, sum);
  for (int k = 0; k < 7; ++k)
    for (int i = 0; i < 2; ++i) c.jacobian[i][k] = j(i, k);
  return c;
}

Compared compare_with_truth(const Run& run) {
  const Physics physics = refined(run.physics);
  const Run fine{run.boundary, physics,    run.start,  run.cushions, run.events,
                 run.target,   run.turned, run.pushed, run.until};
  Path rough = run_double(run), exact = run_truth(fine);
  Compared c{.events = rough.events.size()};
  const std::vector<TruthEvent> plain = rough.events;
  const Condition condition_of_run = condition(run);
  c.kappa = condition_of_run.kappa;
  c.of_start = condition_of_run.of_start;
  c.unit = error_of_a_step(run.physics) * run.boundary.extent * c.kappa;
  if (!same(rough, exact)) {
    rough = without_tiny_slides(std::move(rough), tolerance::simulation_error * c.unit);
    exact = without_tiny_slides(std::move(exact), tolerance::simulation_error * c.unit);
  }
  if (!same(rough, exact)) {
    // It is a tie if the first two different events lie within the bound: their times differ by no more than the ball
    // needs to cross it.
    const std::size_t i = agree(rough, exact);
    c.order = Compared::Order::wrong;
    if (i < std::min(rough.events.size(), exact.events.size())) {
      const double speed = norm(exact.events[i].state.velocity),
                   apart = std::abs(rough.events[i].time - exact.events[i].time);
      if (apart * speed <= tolerance::simulation_error * c.unit) c.order = Compared::Order::tie;
    }
    if (c.order == Compared::Order::wrong && nearby_start(fine, rough)) c.order = Compared::Order::tie;
    return c;
  }
  std::vector<std::pair<EventKind, Contact>> events;
  for (const TruthEvent& e : plain) events.push_back({e.kind, e.contact});
  if (events != condition_of_run.events) {
    c.order = Compared::Order::tie;
    return c;
  }
  const TruthEvent &a = rough.events.back(), &b = exact.events.back();
  c.error = norm((a.state.at - b.state.at) - b.at_rest);
  return c;
}

}  // namespace bankshot::truth
