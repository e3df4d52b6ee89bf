// SPDX-License-Identifier: MIT
#include "planners/steps/roots.hpp"

#include <algorithm>
#include <cmath>

#include "planners/certify.hpp"
#include "planners/line_search.hpp"
#include "planners/locked/speed.hpp"
#include "planners/merit/first_order.hpp"
#include "planners/merit/rank.hpp"
#include "planners/settings.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

using namespace settings::roots;

void Roots::visit(const Branch& aim, const Launch& node, const Linear& linear) {
  if (rest_wanted()) keep_nearest(aim, node, request_.one_unknown() ? std::abs(linear.r[0]) : linear.size());
  const auto step = newton_step(linear, request_.one_unknown());
  if (!step ||
      !(std::abs((*step)[0]) < seed_reach * cell_.step_aim && std::abs((*step)[1]) < seed_reach * cell_.step_speed))
    return;
  const double cells = std::max(std::abs((*step)[0]) / cell_.step_aim, std::abs((*step)[1]) / cell_.step_speed);
  if (!every_root_ && (hopeless(aim, node, cells, linear) || on_side_of_known(aim, linear))) return;
  const Launch predicted{node.speed * std::exp((*step)[1]), node.angle + (*step)[0]};
  const auto give_up = [&](const Launch& at, double size, const Linear& there) {
    if (size < near && known(aim, at, 2 * size)) return true;
    if (every_root_ || !hopeless(aim, at, size, there)) return false;
    // No other node need lead there.
    if (size < near) remember(aim, at, there.determinant(request_.one_unknown()));
    return true;
  };
  if (const auto root = newton(aim, budget_, predicted, cell_, give_up)) add(aim, root.launch);
}

/// Two roots of a route nearly always lie on the two sides of a fold: a node leads to the one on its own side.
bool Roots::on_side_of_known(const Branch& aim, const Linear& node) {
  const bool one_unknown = request_.one_unknown();
  for (Root& root : roots_) {
    if (!belongs(root, aim)) continue;
    if (!root.determinant) {
      const auto there = linearise(aim, budget_, root.launch, true);
      root.determinant = there ? there->determinant(one_unknown) : 0;
    }
    if (*root.determinant * node.determinant(one_unknown) > 0) return true;
  }
  return false;
}

/// Better shots are wanted than one that is known, and the root so many cells from here leads to none, as far as what
/// is seen from here can be trusted there.
bool Roots::hopeless(const Branch& aim, const Launch& at, double cells, const Linear& linear) const {
  if (at.speed > request_.speed.high * std::exp(2 * cells * cell_.step_speed)) return true;
  const double better_there = 1 + distrust * cells;
  if (linear.time > request_.latest * better_there) return true;
  return request_.likelier > 0 &&
         better_there * success_at_most(request_, aim.aim_point, success_on_aim_point(aim, at, linear)) <
             request_.likelier;
}

void Roots::keep_nearest(const Branch& aim, const Launch& node, double miss) {
  auto& kept = seen(aim).nearest;
  Nearest* to_replace = &kept.front();
  for (Nearest& n : kept) {
    if (n.miss < none && std::abs(n.launch.angle - node.angle) < cell_.step_aim / 2) {
      if (miss < n.miss) n = {node, miss};
      return;
    }
    if (n.miss > to_replace->miss) to_replace = &n;
  }
  if (miss < to_replace->miss) *to_replace = {node, miss};
}

/// Neighbouring nodes have mostly the same route.
Roots::Seen& Roots::seen(const Branch& aim) {
  if (last_seen_ < seen_.size() && belongs(seen_[last_seen_], aim)) return seen_[last_seen_];
  const auto it = std::find_if(seen_.begin(), seen_.end(), [&](const Seen& x) { return belongs(x, aim); });
  last_seen_ = static_cast<std::size_t>(it - seen_.begin());
  if (last_seen_ == seen_.size()) seen_.push_back({{aim.route.begin(), aim.route.end()}, aim.aim_point});
  return seen_[last_seen_];
}

void Roots::seek_rest() {
  for (const Seen& seen : seen_) {
    const Branch aim{request_, seen.route, seen.aim_point};
    if (std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) { return belongs(r, aim); })) continue;
    for (const Nearest& n : seen.nearest) {
      if (done() || !(n.miss < none)) break;
      auto root = newton(aim, budget_, n.launch, settings::wide);
      if (!root && request_.stop && beside_last(aim)) root = after_last(aim, n.launch);
      if (!root) continue;
      add(aim, root.launch);
      break;
    }
  }
}

/// The aim point lies near the last cushion.
bool Roots::beside_last(const Branch& aim) const {
  const Wall* const last = aim.route.empty() ? nullptr : request_.problem->boundary.line(aim.route.back().with);
  return last && dot(last->normal, aim.aim_point.at) - last->offset < beside * request_.problem->boundary.diagonal;
}

/// A ball that rests soon after its last bounce was hardly fast enough to get there: from a little above the slowest
/// launch that does.
NewtonResult Roots::after_last(const Branch& aim, const Launch& from) {
  double high = from.speed, low = from.speed * std::exp(-2 * cell_.step_speed);
  int left = halvings;
  bisect(
      high, low, [&](double, double) { return left-- > 0; },
      [&](double speed) {
        return linearise(aim, budget_, {speed, from.angle}).has_value();
      },
      geometric_mean);
  for (const double by : faster)
    if (const auto root = newton(aim, budget_, {high * (1 + by), from.angle}, {cell_.step_aim, step_after_last}))
      return root;
  return {};
}

void Roots::add(const Branch& aim, const Launch& root) {
  if (std::count_if(roots_.begin(), roots_.end(), [&](const Root& r) { return belongs(r, aim); }) >= most_of_a_route)
    return;
  remember(aim, root);
  const bool shot = certify_root(aim, budget_, found_, root, word::map);
  const bool blocked = !shot && !aim.aim_point.captures() && request_.speed.contains(root.speed);
  if (!request_.all() && !(blocked && every_root_)) return;
  across_fold(aim, root);
  for (const Wall& rail : request_.problem->boundary.walls) {
    if (!(dot(rail.normal, aim.aim_point.at) - rail.offset < hugging * request_.problem->boundary.diagonal)) continue;
    beside_rail(aim, root);
    const bool just_left = !aim.route.empty() && aim.route.back().with == rail.contact;
    if (request_.route || just_left || static_cast<int>(aim.route.size()) >= request_.cushions().max) continue;
    Route on(aim.route.begin(), aim.route.end());
    on.push_back({0, rail.contact});
    beside_rail({request_, on, aim.aim_point}, root);
  }
}

std::optional<Roots::Side> Roots::side_at(const Branch& aim, double angle, double guess) {
  const auto speed = speed_near(aim, budget_, angle, guess);
  const auto l = speed ? linearise(aim, budget_, {*speed, angle}) : std::nullopt;
  if (!l) return {};
  return Side{angle, *speed, request_.stop ? l->r[0] * l->by_speed(1) - l->r[1] * l->by_speed(0) : l->r[0]};
}

/// Near a rail the map bends within a hundredth of a cell, so that a route has roots closer than rings see, and one
/// that meets the rail just before the aim point has a root beside that of the route that does not. Aims at both sides
/// of a root, ever farther: where the ball changes its side of the aim point there is another.
void Roots::beside_rail(const Branch& aim, const Launch& root) {
  for (const double way : {1.0, -1.0}) {
    std::optional<Side> last = side_at(aim, root.angle, root.speed);
    for (double cells = nearest_beside; cells < farthest_beside && !budget_.spent(); cells *= beside_grows) {
      const auto now = side_at(aim, root.angle + way * cells * cell_.step_aim, last ? last->speed : root.speed);
      if (now && last && (now->side > 0) != (last->side > 0)) {
        double low = last->angle, high = now->angle, speed = last->speed;
        int left = halvings;
        bisect(
            low, high, [&](double, double) { return left-- > 0; },
            [&](double angle) {
              const auto middle = side_at(aim, angle, speed);
              if (middle) speed = middle->speed;
              return middle && (middle->side > 0) == (last->side > 0);
            });
        const auto other = newton(aim, budget_, {speed, low}, {std::abs(now->angle - last->angle), cell_.step_speed});
        if (other && !known(aim, other.launch, 0)) add(aim, other.launch);
      }
      last = now;
    }
  }
}

/// Roots come in pairs on the two sides of a fold or a kink, where the determinant often changes its sign; nodes are
/// too far apart to see both. So Newton's method also starts around a root wherever that sign is another, or where its
/// first step does not lead back there.
void Roots::across_fold(const Branch& aim, const Launch& root) {
  const auto at_root = linearise(aim, budget_, root, true);
  if (!at_root) return;
  for (const double cells : rings)
    for (int i = 0; i < ways; ++i) from_beside(aim, root, *at_root, direction(radians(360) * i / ways) * cells, cells);
}

void Roots::from_beside(const Branch& aim, const Launch& root, const Linear& at_root, const Vec2d& turn, double cells) {
  const bool one_unknown = request_.one_unknown();
  const Launch from{root.speed * std::exp(turn.y * cell_.step_speed), root.angle + turn.x * cell_.step_aim};
  const auto at = linearise(aim, budget_, from, true);
  const auto step = at ? newton_step(*at, one_unknown) : std::nullopt;
  if (!step) return;
  const double missed =
      std::hypot((*step)[0] / cell_.step_aim + turn.x, one_unknown ? 0 : (*step)[1] / cell_.step_speed + turn.y);
  if (at->determinant(one_unknown) * at_root.determinant(one_unknown) > 0 && missed < astray * cells) return;
  const auto other = newton(aim, budget_, from, cell_);
  if (other && !known(aim, other.launch, 0)) add(aim, other.launch);
}

/// A root of the same route and aim point lies within so many cells.
bool Roots::known(const Branch& aim, const Launch& l, double cells) const {
  return std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) {
    return std::abs(angle_difference(r.launch.angle, l.angle)) < std::max(settings::alike, cells) * cell_.step_aim &&
           std::abs(std::log(r.launch.speed / l.speed)) < std::max(settings::alike, cells) * cell_.step_speed &&
           belongs(r, aim);
  });
}

}  // namespace bankshot::planning::steps
