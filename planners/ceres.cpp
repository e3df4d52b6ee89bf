// SPDX-License-Identifier: MIT
//
// Planner `ceres`: Levenberg–Marquardt (ceres::TinySolver) on dual-number derivatives of the
// locked-sequence residual, in (aim, ln speed) or in the aim alone.
// Seeds: the images of unfold.hpp with the sequence their trace meets; on tables with reflex
// vertices also a fan of aims. Cost: about ten locked simulations a seed. Guarantee: none beyond the
// certificate; it finds the root its seed leads to.
// Source: Ceres 2.1 tiny_solver.h. Its function_tolerance is compared with the absolute change of
// the cost, so it is set to 0 here.
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <algorithm>
#include <cmath>

#include "bankshot/simulate/locked.hpp"
#include "planners/planners.hpp"
#include "planners/robustness.hpp"
#include "planners/unfold.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

constexpr int fan = 720;  // aims tried as seeds where no image exists: every half degree

/// What a seed's locked path must hit.
struct Aim {
  const Search& s;
  std::span<const int> contacts;
  Vec2d target;
  double fixed_speed;
};

template <class T>
State<T> start_of(const Aim& a, const T& angle, const T& speed) {
  using std::cos, std::sin;
  return {to<T>(a.s.puzzle.ball.at), Vec2<T>{cos(angle), sin(angle)} * speed};
}

/// [0]: signed lateral miss over the diagonal. [1]: v² − s² where the ball is abreast of the target
/// (at capture for a pocket), over max(1, s²); v² is continued below 0 when the ball falls short.
/// A target to stop at needs no second law: there v = 0 is asked abreast of the point.
template <class T, class Motion>
void residuals_of(const Aim& a, const Motion& motion, const State<T>& start, T* r, bool two) {
  using std::sqrt;
  const auto path = follow_locked(a.s.boundary, motion, a.s.puzzle.physics.cushion, a.contacts, start);
  const T speed = norm(path.state.velocity);
  if (path.end != LockedEnd::complete || !(speed > T(0))) {
    std::fill(r, r + (two ? 2 : 1), T(1e3));  // flat and high: the solver turns back or gives up
    return;
  }
  const Vec2<T> u = path.state.velocity / speed, d = to<T>(a.target) - path.state.at;
  const T lateral = cross(u, d);
  r[0] = lateral / T(a.s.boundary.diagonal);
  if (!two) return;
  T ahead = dot(u, d);
  const double capture = a.s.capture(a.s.reach(a.target));
  const T half_chord2 = T(capture * capture) - lateral * lateral;
  if (capture > 0 && half_chord2 > T(0)) ahead -= sqrt(half_chord2);
  const double asked = std::clamp(a.s.puzzle.prefer == Prefer::soft ? a.s.arrival->low : a.s.arrival->high, 0.0, 1e3);
  r[1] = (speed * speed - T(2 * motion.deceleration()) * ahead - T(asked * asked)) / T(std::max(1.0, asked * asked));
}

template <int Unknowns>
struct Residual {
  const Aim& aim;
  template <class T>
  bool operator()(const T* x, T* r) const {
    using std::exp;
    const T speed = Unknowns == 2 ? T(exp(x[Unknowns - 1])) : T(aim.fixed_speed);
    const State<T> start = start_of(aim, x[0], speed);
    std::visit([&](const auto& m) { residuals_of(aim, m, start, r, Unknowns == 2); },
               aim.s.puzzle.physics.motion);
    return true;
  }
};

template <int Unknowns>
std::optional<Launch> minimise(Search& s, const Aim& aim, const Launch& seed) {
  const Residual<Unknowns> residual{aim};
  using Function = ::ceres::TinySolverAutoDiffFunction<Residual<Unknowns>, Unknowns, Unknowns>;
  const Function function(residual);
  ::ceres::TinySolver<Function> solver;
  solver.options.max_num_iterations = 30;
  solver.options.function_tolerance = 0;
  solver.options.gradient_tolerance = 1e-18;
  solver.options.parameter_tolerance = 1e-16;
  solver.options.cost_threshold = 1e-28;
  typename ::ceres::TinySolver<Function>::Parameters x;
  x(0) = seed.angle;
  if constexpr (Unknowns == 2) x(1) = std::log(seed.speed);
  solver.Solve(function, &x);
  s.simulations += 1 + 2 * solver.summary.iterations;
  if (!x.allFinite() || !(solver.summary.final_cost < 1e-12)) return {};
  double speed = aim.fixed_speed;
  if constexpr (Unknowns == 2) speed = std::exp(x(1));
  return Launch{speed, wrap_angle(x(0))};
}

/// A launch speed to begin with where the trace gives none.
double middle_speed(const Search& s) {
  const Range& v = s.puzzle.speed;
  return v.low > 0 ? std::sqrt(v.low * v.high) : v.high / 2;
}

void from_seed(Search& s, double angle, int bounces) {
  std::vector<int> contacts;
  const Trace t = trace(s, angle, Goal::exactly(s, bounces), &contacts);
  if (s.puzzle.cushions.sequence) contacts = *s.puzzle.cushions.sequence;
  if (static_cast<int>(contacts.size()) != bounces) return;
  const double speed = launch_speed(s, angle, t).value_or(middle_speed(s));
  if (const auto launch = refine(s, {speed, angle}, contacts)) certify(s, *launch, bounces, "image+ceres");
}

}  // namespace

std::optional<Launch> refine(Search& s, const Launch& seed, const std::vector<int>& contacts) {
  std::optional<Launch> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2d& target : s.aim_points()) {
    const Aim aim{s, contacts, target, seed.speed};
    const auto x = s.one_unknown() ? minimise<1>(s, aim, seed) : minimise<2>(s, aim, seed);
    if (!x) continue;
    const double moved = std::abs(angle_difference(x->angle, seed.angle));
    if (moved < least) best = x, least = moved;
  }
  return best;
}

void ceres(Search& s) {
  const auto enough = [&] { return s.spent() || (!s.all && s.shots.size() >= 32); };
  Unfolding images(s, false);
  while (const auto c = images.next()) {
    if (enough()) return;
    from_seed(s, c->angle, c->bounces);
  }
  if (s.boundary.tips.empty()) return;
  const CushionRule& rule = s.puzzle.cushions;
  for (int i = 0; i < fan; ++i)
    for (int n = rule.min; n <= rule.max; ++n) {
      if (enough()) return;
      from_seed(s, radians(360.0 / fan) * i, n);
    }
}

void first_order(const Search& s, Shot& shot) {
  using Jet = ::ceres::Jet<double, 2>;
  const Aim aim{s, shot.cushions, {}, 0};
  const Vec2d u = direction(shot.launch.angle);
  // Derivatives with respect to the aim [rad] and to ln speed, at an exact direction.
  const Vec2d v = u * shot.launch.speed, turned = perpendicular(v);
  Vec2<Jet> velocity{Jet(v.x), Jet(v.y)};
  velocity.x.v = {turned.x, v.x};
  velocity.y.v = {turned.y, v.y};
  std::visit(
      [&](const auto& motion) {
        const auto path = follow_locked(s.boundary, motion, s.puzzle.physics.cushion, aim.contacts,
                                        State<Jet>{to<Jet>(s.puzzle.ball.at), velocity});
        Vec2<Jet> end = path.state.at;
        if (s.stop) {
          const Arc<Jet> last = motion.arc(path.state);
          end = last.position(last.duration);
        } else {
          // Along the line of travel nothing is missed: only the lateral part counts.
          const Vec2<Jet> w = path.state.velocity / norm(path.state.velocity);
          const Vec2d line{-w.y.a, w.x.a};
          const Jet lateral = cross(w, to<Jet>(shot.arrival.at) - path.state.at);
          end = {lateral * line.x, lateral * line.y};
        }
        const double by_aim = std::hypot(end.x.v(0), end.y.v(0)), by_speed = std::hypot(end.x.v(1), end.y.v(1));
        shot.condition = std::max(by_aim, by_speed);
        const Noise& noise = s.puzzle.noise;
        const double spread = std::hypot(by_aim * noise.angle, by_speed * noise.speed / shot.launch.speed);
        shot.first_order = s.nearest_reach(shot.arrival.at) / spread;
      },
      s.puzzle.physics.motion);
}

}  // namespace bankshot::planning
