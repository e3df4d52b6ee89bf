// SPDX-License-Identifier: MIT
#include "app/report/steppers.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <optional>

#include "app/report/forces.hpp"
#include "app/report/inclines.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot::app::report {
namespace {

/// An event, which happens where its function of the state falls through 0.
struct Crossing {
  enum class Kind { none, wall, pocket, phase } kind = Kind::none;
  std::size_t index = 0;
};

template <class Motion, class Cushion>
class Run {
 public:
  Run(const Boundary& boundary, const Motion& motion, const Cushion& cushion, const State<double>& start, double until,
      const Scheme& scheme)
      : boundary_(boundary), motion_(motion), cushion_(cushion), scheme_(scheme), until_(until), spin_(start.spin.z) {
    y_ = {start.at.x, start.at.y, start.velocity.x, start.velocity.y, start.spin.x, start.spin.y};
    choose_phase();
  }

  Stepped go() {
    if (scheme_.method == Scheme::Method::dormand_prince)
      while (goes_on()) smooth_piece();
    else
      while (goes_on()) scheme_.locate ? located_step() : clamped_step();
    out_.state = {{y_[0], y_[1]}, velocity_of(y_), {y_[4], y_[5], spin_}};
    return out_;
  }

 private:
  static constexpr bool slides = !Motion::straight;

  bool goes_on() const { return out_.time < until_ && !out_.pocketed && !out_.rests; }

  Vec2d slip(const Coordinates& y) const {
    if constexpr (slides) return {y[2] - boundary_.body.radius * y[5], y[3] + boundary_.body.radius * y[4]};
    return {0, 0};
  }

  Forces forces() const {
    Forces f{phase_, along_, 0, 0, 0, 0};
    if constexpr (slides) {
      f.sliding = motion_.sliding_friction * motion_.g;
      f.turning = 2.5 * f.sliding / boundary_.body.radius;
      f.rolling = motion_.rolling_friction.at_rest * motion_.g;
      f.per_speed = motion_.rolling_friction.per_speed * motion_.g;
    } else {
      f.rolling = motion_.deceleration();
    }
    return f;
  }

  void choose_phase() {
    const Vec2d u = slip(y_), v = velocity_of(y_);
    const State<double> now{{y_[0], y_[1]}, v, {y_[4], y_[5], spin_}};
    if (dot(u, u) > tolerance::slip * tolerance::slip * squared_scale(now, boundary_.body.radius)) {
      phase_ = Phase::slide;
      along_ = u / norm(u);
    } else {
      roll();
    }
  }

  void roll() {
    const Vec2d v = velocity_of(y_);
    phase_ = Phase::roll;
    if (v == Vec2d{0, 0}) return rest();
    along_ = v / norm(v);
    if (slides) y_[4] = -v.y / boundary_.body.radius, y_[5] = v.x / boundary_.body.radius;
  }

  void rest() {
    phase_ = Phase::rest;
    y_[2] = y_[3] = 0;
    out_.rests = true;
  }

  void end_phase() { phase_ == Phase::slide ? roll() : rest(); }

  /// Ends a step: `h` seconds later the ball is in state y.
  void accept(const Coordinates& y, double h) {
    y_ = y;
    out_.time += h;
    ++out_.steps;
    if constexpr (slides) {
      if (phase_ == Phase::roll) y_[4] = -y_[3] / boundary_.body.radius, y_[5] = y_[2] / boundary_.body.radius;
      const double lost = h * 2.5 * motion_.spinning_friction * motion_.g / boundary_.body.radius;
      spin_ = std::copysign(std::max(0.0, std::abs(spin_) - lost), spin_);
    }
  }

  double gap(std::size_t wall, const Coordinates& y) const {
    const Wall& w = boundary_.walls[wall];
    return w.normal.x * y[0] + w.normal.y * y[1] - w.offset;
  }
  double beyond(std::size_t pocket, const Coordinates& y) const {
    const Circle& c = boundary_.pockets[pocket];
    const Vec2d d = Vec2d{y[0], y[1]} - c.centre;
    return dot(d, d) - c.radius * c.radius;
  }
  /// Returns a number that is positive until the phase is over.
  double left(const Coordinates& y) const { return dot(phase_ == Phase::slide ? slip(y) : velocity_of(y), along_); }

  double value(const Crossing& c, const Coordinates& y) const {
    return c.kind == Crossing::Kind::wall     ? gap(c.index, y)
           : c.kind == Crossing::Kind::pocket ? beyond(c.index, y)
                                              : left(y);
  }

  void bounce(std::size_t wall) {
    const Wall& w = boundary_.walls[wall];
    const double g = gap(wall, y_);
    y_[0] -= g * w.normal.x;
    y_[1] -= g * w.normal.y;
    if (!(dot(w.normal, velocity_of(y_)) < 0)) return;
    State<double> s{{y_[0], y_[1]}, velocity_of(y_), {y_[4], y_[5], spin_}};
    cushion_.bounce(boundary_.body, s, w.normal);
    y_ = {y_[0], y_[1], s.velocity.x, s.velocity.y, s.spin.x, s.spin.y};
    spin_ = s.spin.z;
    ++out_.cushions;
    choose_phase();
  }

  void happen(const Crossing& c) {
    if (c.kind == Crossing::Kind::pocket) out_.pocketed = true;
    if (c.kind == Crossing::Kind::wall) bounce(c.index);
    if (c.kind == Crossing::Kind::phase) end_phase();
  }

  void clamped_step() {
    const double h = std::min(scheme_.step, until_ - out_.time);
    accept(advanced(scheme_.method, forces(), y_, h), h);
    for (std::size_t i = 0; i < boundary_.pockets.size(); ++i)
      if (beyond(i, y_) < 0) out_.pocketed = true;
    if (out_.pocketed) return;
    if (!(left(y_) > 0)) end_phase();
    for (std::size_t i = 0; i < boundary_.walls.size(); ++i)
      if (gap(i, y_) < 0) bounce(i);
  }

  /// Calls see(crossing) for each event that has happened by state y.
  template <class See>
  void crossed(const Coordinates& y, See&& see) const {
    for (std::size_t i = 0; i < boundary_.pockets.size(); ++i)
      if (beyond(i, y) < 0 && beyond(i, y_) >= 0) see(Crossing{Crossing::Kind::pocket, i});
    for (std::size_t i = 0; i < boundary_.walls.size(); ++i)
      if (gap(i, y) < 0) see(Crossing{Crossing::Kind::wall, i});
    if (!(left(y) > 0)) see(Crossing{Crossing::Kind::phase});
  }

  /// Returns the moment in (from, to] of a crossing that has happened by `to`. `at(h)` returns the state.
  template <class At>
  static double located(const Run& run, const Crossing& c, double from, double to, const At& at) {
    constexpr int most_halvings = 60;
    const auto f = [&](double h) { return run.value(c, at(h)); };
    // If the ball leaves the cushion and comes back within one step, the function is 0 at `from` too.
    double low = from, f_low = f(low);
    if (!(f_low > 0)) {
      double h = to;
      for (int i = 0; i < most_halvings && !(f_low > 0); ++i) {
        h = from + (h - from) / 2;
        f_low = f(h);
      }
      if (!(f_low > 0)) return std::min(to, from + least_step);
      low = h;
    }
    const double f_to = f(to);
    if (f_to == 0) return to;
    std::uintmax_t iterations = 100;
    const auto [a, b] = boost::math::tools::toms748_solve(f, low, to, f_low, f_to,
                                                          boost::math::tools::eps_tolerance<double>(), iterations);
    return std::abs(f(a)) < std::abs(f(b)) ? a : b;
  }

  struct First {
    double h;
    Crossing crossing{};
  };

  /// Returns the first event between two moments of the trajectory `at`.
  template <class At>
  First first_crossing(double from, double to, const At& at) const {
    First first{to};
    crossed(at(to), [&](const Crossing& c) {
      const double h = located(*this, c, from, to, at);
      if (h < first.h || first.crossing.kind == Crossing::Kind::none) first = {h, c};
    });
    return first;
  }

  void located_step() {
    const double h = std::min(scheme_.step, until_ - out_.time);
    const Forces f = forces();
    const auto at = [&](double t) { return advanced(scheme_.method, f, y_, t); };
    const First first = first_crossing(0, h, at);
    accept(at(first.h), first.h);
    happen(first.crossing);
  }

  /// Follows Dormand–Prince up to the next event.
  void smooth_piece() {
    namespace odeint = boost::numeric::odeint;
    const Forces f = forces();
    auto stepper = odeint::make_dense_output(scheme_.step, scheme_.step, scheme_.longest,
                                             odeint::runge_kutta_dopri5<Coordinates>());
    const double remains = until_ - out_.time;
    stepper.initialize(y_, 0.0, first_step_ > 0 ? first_step_ : scheme_.longest > 0 ? scheme_.longest : default_step);
    const auto at = [&](double t) {
      Coordinates y;
      stepper.calc_state(t, y);
      return y;
    };
    for (double from = 0; from < remains; from = stepper.current_time()) {
      stepper.do_step(f);
      ++out_.steps;
      const double to = std::min(stepper.current_time(), remains);
      const First first = first_crossing(from, to, at);
      if (first.crossing.kind == Crossing::Kind::none && to < remains) continue;
      first_step_ = stepper.current_time_step();
      --out_.steps;  // accept() counts this one
      accept(at(first.h), first.h);
      happen(first.crossing);
      return;
    }
  }

  /// Least advance [s], as a ball pressed to a cushion bounces there again and again.
  static constexpr double least_step = 1e-12;
  static constexpr double default_step = 1e-2;  ///< s; first step that Dormand–Prince tries

  const Boundary& boundary_;
  const Motion motion_;
  const Cushion cushion_;
  const Scheme scheme_;
  const double until_;
  Coordinates y_{};
  double spin_;  ///< about the vertical
  Phase phase_ = Phase::rest;
  Vec2d along_{};
  double first_step_ = 0;
  Stepped out_;
};

/// State of a ball with dry friction on an incline: the integral of w, and w. Time is the variable.
using Sliding = std::array<double, 4>;
using DormandPrince = boost::numeric::odeint::runge_kutta_dopri5<Sliding>;

auto rate_on(const detail::Incline<double>& law) {
  return [law](const Sliding& y, Sliding& rate, double) {
    const double by = -(law.friction / std::hypot(y[2], y[3]) + law.drag);
    rate = {y[2], y[3], by * y[2] + law.pull * law.down.x, by * y[3] + law.pull * law.down.y};
  };
}

}  // namespace

Slipped dormand_prince(const detail::Incline<double>& law, const Vec2d& w, double until, int steps) {
  DormandPrince stepper;
  Sliding y{0, 0, w.x, w.y};
  const double h = until / steps;
  for (int i = 0; i < steps; ++i) stepper.do_step(rate_on(law), y, i * h, h);
  return {until, {y[0], y[1]}, {y[2], y[3]}};
}

Slipped dormand_prince_to_stop(const detail::Incline<double>& law, const Vec2d& w, double tolerance) {
  auto stepper = boost::numeric::odeint::make_controlled(tolerance, tolerance, DormandPrince());
  Sliding y{0, 0, w.x, w.y};
  // Below this speed the remaining way is, as a share of the whole way, as small as the tolerance.
  const double slow = std::sqrt(tolerance) * norm(w);
  double t = 0, h = norm(w) / law.friction / 10;
  while (std::hypot(y[2], y[3]) > slow) stepper.try_step(rate_on(law), y, t, h);
  const Vec2d left{y[2], y[3]};
  const double q = norm(left), lasts = q / (law.friction - law.pull * dot(law.down, left) / q);
  return {t + lasts, Vec2d{y[0], y[1]} + left * (lasts / 2), {0, 0}};
}

Stepped step_through(const Boundary& boundary, const Physics& physics, const State<double>& start, double until,
                     const Scheme& scheme) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) -> Stepped {
    if constexpr (std::is_same_v<std::decay_t<decltype(motion)>, Ideal>)
      return {start};  // a stepper has nothing to integrate there
    else
      return Run(boundary, motion, cushion, start, until, scheme).go();
  });
}

}  // namespace bankshot::app::report
