// SPDX-License-Identifier: MIT
#include "planners/evaluate/first_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/evaluate/limits.hpp"
#include "planners/evaluate/real_arrival.hpp"
#include "planners/evaluate/room.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/start.hpp"
#include "planners/trace/in_the_way.hpp"
#include "planners/trace/trace.hpp"

namespace bankshot::planning {
namespace {

using Number = bankshot::Dual<2>;

/// Returns the offsets between which a ball in direction u passes a point, or enters a pocket; `near` is one of them
/// [m]. A point is passed where part of its disc is inside the table.
Gap<Number> sides(const Boundary& boundary, const AimPoint& aim_point, const Vec2<Number>& u, double near) {
  if (aim_point.captures()) return aim_point.gap(u, near);
  Range out{-aim_point.reach, aim_point.reach};
  const Vec2d left = perpendicular(value(u));
  for (const Wall& w : boundary.walls) {
    const double above = dot(w.normal, aim_point.at) - w.offset,
                 half2 = aim_point.reach * aim_point.reach - above * above;
    if (!(half2 > 0) || boundary.break_at(w, dot(w.along, aim_point.at)) >= 0) continue;
    const Vec2d foot = w.normal * -above, half = w.along * std::sqrt(half2);
    const double a = dot(left, foot + half), b = dot(left, foot - half), tilt = aim_point.reach * dot(w.normal, left);
    if (above + tilt < 0) out.high = std::min(out.high, std::max(a, b));
    if (above - tilt < 0) out.low = std::max(out.low, std::min(a, b));
  }
  return {Number(out.low), Number(out.high)};
}

/// One locked path with derivatives, and the limits that it sets.
class Path {
 public:
  Path(const Branch& aim, const Launch& launch, const Noise& unit)
      : aim_(aim), request_(aim.request), launch_(launch), unit_(unit), limits_(launch, unit) {}

  const Limits& limits() const { return limits_; }

  /// Follows the branch up to where the ball is abreast of `at`, or enters the circle around it. Returns false where a
  /// leg does not lead to its meeting.
  template <class Motion, class Cushion>
  bool run(const Motion& motion, const Cushion& cushion, const Vec2d& at, double capture, Work& work) {
    const auto arrival = trace(
        request_.problem->balls(), motion, cushion, aim_.route, dual_start<Number, 2>(request_, launch_, request_.spin),
        {boundary_of_arrival().body, at, capture, request_.stop}, work, *this, LostLeg::is_passed_over);
    if (!arrival) return false;
    request_.stop ? rests(*arrival, at) : passes(*arrival, at, rolling_square(motion, arrival->state));
    arrives_ = true;
    return arrival->complete;
  }

  void arc(std::size_t leg, const Arc<Number>& arc, const Number& t) {
    keeps_clear(leg, arc, t);
    if (aim_.next(leg).kind == ContactKind::ball) touches(arc, t, aim_.route[leg]);
  }
  void met(std::size_t leg, const State<Number>& after) { bounce(aim_.route[leg], after.at); }

  /// Returns how far the path passes from where it was to arrive [m].
  double beside() const { return arrives_ ? beside_ : std::numeric_limits<double>::infinity(); }

  /// Returns the results, with the margin and the success estimate. `moved`: derivatives to use instead of the locked
  /// path's.
  FirstOrder first_order(const std::optional<Moved>& moved = {}) const {
    FirstOrder out = out_;
    if (!arrives_) return out;
    if (moved) out.by_angle = moved->by_angle, out.by_log_speed = moved->by_log_speed;
    const double by_push = norm(out.by_log_speed) * unit_.speed_at(launch_.speed) / launch_.speed;
    out.margin = aim_.aim_point.reach / std::hypot(norm(out.by_angle) * unit_.angle, by_push);
    const double steep = norm(slope_);
    out.success_estimate = request_.stop ? limits_.success()
                           : steep > 0   ? limits_.success(slope_ / steep, half_ / steep)
                                         : limits_.success({1, 0}, 1);
    return out;
  }

 private:
  const Boundary& boundary_of_arrival() const { return request_.problem->boundary_of(aim_.aim_point.ball); }

  /// Limits the launch by all obstacles from which the ball must keep on an arc of a leg.
  void keeps_clear(std::size_t leg, const Arc<Number>& arc, const Number& t) {
    if (!(t > 0)) return;
    const Boundary& boundary = request_.problem->boundary_of(aim_.ball(leg));
    const auto keeps_from = [&](const Circle& c) {
      const Vec2d start = value(arc.at) - c.centre;
      if (norm(start) < c.radius) return;  // a ball that starts inside must first come out
      const double nearest = detail::closest_time(value(arc), t.a, c.centre);
      const Vec2<Number> there = arc.position(nearest < t.a ? Number(nearest) : t);
      limits_.keep(norm(there - to<Number>(c.centre)) - c.radius);
    };
    each_in_the_way(boundary, aim_.before(leg), aim_.next(leg), aim_.aim_point.taken_by, keeps_from);
  }

  /// Limits the launch to touch the ball that is met: on an arc that ends there, the path passes between its two sides.
  void touches(const Arc<Number>& arc, const Number& t, const Meeting& meeting) {
    const Boundary& boundary = request_.problem->boundary_of(meeting.ball);
    const Circle& rim = *boundary.rim(meeting.with);
    const Vec2<Number> at = arc.position(t), v = arc.tangent(t);
    if (!(norm(value(at) - rim.centre) <= rim.radius + boundary.touch)) return;
    const Number offset = cross(v, at - to<Number>(rim.centre)) / norm(v);
    limits_.keep(Number(rim.radius) - offset);
    limits_.keep(Number(rim.radius) + offset);
  }

  /// Limits a bounce to its cushion, beyond whose end the ball meets another. At a right angle it then meets this one
  /// too, so on a rectangle without a given route there is no limit.
  void bounce(const Meeting& meeting, const Vec2<Number>& at) {
    const Wall* const line = request_.problem->boundary_of(meeting.ball).line(meeting.with);
    if (!line || (meeting.ball == 0 && !request_.route && request_.puzzle().table.is_rectangle())) return;
    const Number along = dot(to<Number>(line->along), at);
    limits_.keep(along - dot(line->along, line->from));
    limits_.keep(dot(line->along, line->to) - along);
  }

  void rests(const LockedArrival<Number>& a, const Vec2d& at) {
    fast_enough(Number(0));
    beside_ = norm(value(a.state.at) - at);
    limits_.rest(a.state.at - to<Number>(aim_.aim_point.at), aim_.aim_point.reach);
    moves(a.state.at);
  }

  /// Returns the squared speed of a ball that rolls as far as this one goes from here [m²/s²]. A sliding ball loses
  /// speed at a rate that ends where it rolls.
  template <class Motion>
  Number rolling_square(const Motion& motion, const State<Number>& state) const {
    const Number square = dot(state.velocity, state.velocity);
    if constexpr (has_chords<Motion>) {
      return square;
    } else {
      const Body& body = boundary_of_arrival().body;
      const Arc<Number> arc = motion.arc(body, state);
      if (!arc.goes_on() || !(square > Number(0))) return square;
      const State<Number> rolls = advance(motion, body, state, arc, arc.duration);
      const Vec2<Number> u = state.velocity / sqrt(square);
      const Number on = dot(u, rolls.velocity);
      if (!(on > Number(0))) return square;  // the ball is drawn back
      return on * on + Number(2 * deceleration(request_.puzzle().physics)) * dot(u, rolls.at - state.at);
    }
  }

  /// Adds the limits of a ball that passes its aim point. `square`: rolling_square of the arrival.
  void passes(const LockedArrival<Number>& a, const Vec2d& at, const Number& square) {
    // Along the line of travel nothing is missed: only the lateral part counts.
    const Vec2<Number> u = a.heading / norm(a.heading);
    const Vec2d line{-u.y.a, u.x.a};  // across it, to the left
    const Number to_left = cross(u, a.state.at - to<Number>(at));
    beside_ = std::abs(to_left.a);
    moves({to_left * line.x, to_left * line.y});
    const Number offset = cross(u, a.state.at - to<Number>(aim_.aim_point.at));
    const Gap<Number> room = sides(boundary_of_arrival(), aim_.aim_point, u, offset.a);
    limits_.keep(offset - room.low);
    limits_.keep(room.high - offset);
    const double rolls_on =
        aim_.aim_point.captures() ? 0 : 2 * deceleration(request_.puzzle().physics) * aim_.aim_point.reach;
    fast_enough(square + rolls_on);
    slope_ = limits_.in_deviations(offset);
    half_ = (room.high - room.low).a / 2;
  }

  /// Limits the launch to speeds that get there. The squared speed of arrival grows with that of the launch, and is 0
  /// at the least such speed.
  void fast_enough(const Number& speed2) {
    const double gain = speed2.v[1] / 2, least = gain > 0 ? std::max(1 - speed2.a / gain, 0.0) : 0;
    const double room = launch_.speed * (1 - std::sqrt(least));
    const double by_aim = speed2.a > 0 ? speed2.v[0] / speed2.a * room : 0;
    limits_.add(room, {by_aim * unit_.angle, unit_.speed});
  }

  void moves(const Vec2<Number>& end) {
    out_.by_angle = {end.x.v[0], end.y.v[0]};
    out_.by_log_speed = {end.x.v[1], end.y.v[1]};
  }

  const Branch& aim_;
  const SearchRequest& request_;
  const Launch& launch_;
  const Noise& unit_;
  Limits limits_;
  FirstOrder out_{};
  bool arrives_ = false;
  Vec2d slope_{};    ///< slope of the lateral miss, in deviations
  double half_ = 0;  ///< m; half of the target's width
  double beside_ = 0;
};

Path path_to(const Branch& aim, const Launch& launch, const Vec2d& at, Work& work) {
  Path path(aim, launch, aim.request.puzzle().noise);
  // Rounding may let the locked path miss what the replay met; its derivatives are still the best there are.
  with_physics(aim.request.puzzle().physics,
               [&](const auto& motion, const auto& cushion) { return path.run(motion, cushion, at, 0, work); });
  return path;
}

/// Returns how far residual k moves by one deviation of aim, and by one of speed [m].
Vec2d by_deviation(const SearchRequest& request, const Launch& launch, const Linear& l, std::size_t k) {
  const double per_rad = request.puzzle().noise.angle * request.problem->boundary.diagonal;
  const double per_log = request.one_unknown() ? 0
                                               : request.puzzle().noise.speed_at(launch.speed) / launch.speed *
                                                     request.problem->boundary.diagonal;
  return {l.by_aim(k) * per_rad, l.by_speed(k) * per_log};
}

}  // namespace

double success_on_aim_point(const Branch& aim, const Launch& launch, const Linear& l) {
  const SearchRequest& request = aim.request;
  const auto within = [&](double deviation) { return std::erf(aim.aim_point.reach / (std::sqrt(2.0) * deviation)); };
  const Vec2d across = by_deviation(request, launch, l, 0);
  if (!request.stop || request.one_unknown()) return within(norm(across));
  // A disc lies inside the square along the axes of the ellipse of errors.
  const Vec2d along = by_deviation(request, launch, l, 1);
  const double sum = dot(across, across) + dot(along, along), product = std::abs(cross(across, along));
  const double longer = std::sqrt((sum + std::sqrt(std::max(sum * sum - 4 * product * product, 0.0))) / 2);
  return within(longer) * within(product / longer);
}

double estimate_of_passing(const SearchRequest& request, const AimPoint& aim_point, const Launch& launch,
                           const Linear& l) {
  const double lateral = l.r[0] * request.problem->boundary.diagonal,
               deviation = norm(by_deviation(request, launch, l, 0));
  const auto half_below = [&](double end) { return std::erf(end / (std::sqrt(2.0) * deviation)) / 2; };
  return half_below(aim_point.reach - lateral) + half_below(aim_point.reach + lateral);
}

std::optional<Limits> limits_of(const Branch& aim, const Launch& launch, const Noise& unit, Work& work) {
  Path path(aim, launch, unit);
  const bool arrives = with_physics(aim.request.puzzle().physics, [&](const auto& motion, const auto& cushion) {
    return path.run(motion, cushion, aim.aim_point.at, aim.aim_point.capture(), work);
  });
  return arrives ? std::optional(path.limits()) : std::nullopt;
}

double estimate_in_middle(const SearchRequest& request, const Shot& shot, Work& work) {
  const double by_aim = norm(shot.verification.by_angle);
  if (!(by_aim > 0)) return shot.robustness.success_estimate;
  const Gap<double> room = room_beside(request, shot, shot.verification.by_angle / by_aim);
  Launch middle = shot.launch;
  middle.angle += (room.low + room.high) / 2 / by_aim;
  const Route route = route_with_jaws_of(shot);
  return path_to({request, route, request.problem->aim_point_of(shot)}, middle, shot.path.arrival.at, work)
      .first_order()
      .success_estimate;
}

void add_first_order(const SearchRequest& request, Shot& shot, Work& work) {
  const Route route = route_with_jaws_of(shot);
  const Branch aim{request, route, request.problem->aim_point_of(shot)};
  const Path path = path_to(aim, shot.launch, shot.path.arrival.at, work);
  // A ball that a cushion holds may arrive before the locked path, which goes through that cushion, has left the line.
  const auto held = [&] {
    return !request.problem->centred(path.beside()) ||
           (!aim.aim_point.captures() && request.problem->on_a_line(aim.aim_point.ball, shot.path.arrival.at));
  };
  const FirstOrder f =
      path.first_order(request.problem->objects && held() ? real_arrival(request, shot, work) : std::nullopt);
  shot.verification.by_angle = f.by_angle;
  shot.verification.by_speed = f.by_log_speed / shot.launch.speed;
  shot.verification.condition = std::max(norm(f.by_angle), norm(f.by_log_speed));
  shot.robustness.first_order = f.margin;
  shot.robustness.success_estimate = f.success_estimate;
}

}  // namespace bankshot::planning
