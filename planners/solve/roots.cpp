// SPDX-License-Identifier: MIT
#include "planners/solve/roots.hpp"

#include <algorithm>
#include <cmath>

#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/settings.hpp"
#include "planners/solve/newton.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning {

using namespace settings::roots;

void Roots::visit(const Branch& aim, const Launch& node, const Linear& linear) {
  if (rest_wanted()) see(aim, node, request_.one_unknown() ? std::abs(linear.r[0]) : linear.size());
  const auto step = newton_step(linear, request_.one_unknown());
  if (!step ||
      !(std::abs((*step)[0]) < seed_reach * cell_.step_aim && std::abs((*step)[1]) < seed_reach * cell_.step_speed))
    return;
  const double cells = size_of(*step, cell_);
  if (!every_root_ && (hopeless(aim, node, cells, linear) || on_side_of_known(aim, linear))) return;
  const Launch predicted{node.speed * std::exp((*step)[1]), node.angle + (*step)[0]};
  const auto give_up = [&](const Launch& at, double size, const Linear& there) {
    if (size < near && known(aim, at, 2 * size)) return true;
    if (every_root_ || !hopeless(aim, at, size, there)) return false;
    // No other node needs to lead there.
    if (size < near) remember(aim, at, there.determinant(request_.one_unknown()));
    return true;
  };
  if (const auto root = newton(aim, budget_, predicted, cell_, give_up)) add(aim, *root);
}

/// Returns whether a known root lies on this node's side of a fold. Two roots of a route nearly always lie on the two
/// sides of a fold, and a node leads to the one on its own side.
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

/// Returns whether only better shots than a known one are wanted, and the root so many cells from here gives none. The
/// derivatives here tell that, as far as they can be trusted there.
bool Roots::hopeless(const Branch& aim, const Launch& at, double cells, const Linear& linear) const {
  if (at.speed > request_.speed.high * std::exp(2 * cells * cell_.step_speed)) return true;
  const double better_there = 1 + distrust * cells;
  if (linear.time > request_.latest * better_there) return true;
  return request_.likelier > 0 &&
         better_there * success_at_most(request_, aim.aim_point, success_on_aim_point(aim, at, linear)) <
             request_.likelier;
}

void Roots::see(const Branch& aim, const Launch& node, double miss) {
  const auto known = std::ranges::find_if(seen_, [&](const Seen& x) { return belongs(x, aim); });
  if (known == seen_.end())
    seen_.push_back({{aim.route.begin(), aim.route.end()}, aim.aim_point, node, miss});
  else if (miss < known->miss)
    known->nearest = node, known->miss = miss;
}

void Roots::seek_rest() {
  if (!rest_wanted()) return;
  for (const Seen& seen : seen_) {
    const Branch aim{request_, seen.route, seen.aim_point};
    if (done() || std::ranges::any_of(roots_, [&](const Root& r) { return belongs(r, aim); })) continue;
    if (const auto root = newton(aim, budget_, seen.nearest, settings::wide)) add(aim, *root);
  }
}

void Roots::add(const Branch& aim, const Launch& root) {
  if (std::count_if(roots_.begin(), roots_.end(), [&](const Root& r) { return belongs(r, aim); }) >=
      static_cast<std::ptrdiff_t>(settings::enough_to_compare))
    return;
  remember(aim, root);
  certify_root(aim, budget_, found_, root, word::partition);
}

std::ptrdiff_t Roots::known_between(const Branch& aim, const Range& aims) const {
  return std::ranges::count_if(roots_, [&](const Root& r) {
    const double beyond = angle_difference(aims.low, r.launch.angle);
    return beyond >= 0 && beyond <= aims.high - aims.low && belongs(r, aim);
  });
}

/// Returns whether a root of the same route and aim point lies within so many cells.
bool Roots::known(const Branch& aim, const Launch& l, double cells) const {
  return std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) {
    return std::abs(angle_difference(r.launch.angle, l.angle)) < std::max(settings::alike, cells) * cell_.step_aim &&
           std::abs(std::log(r.launch.speed / l.speed)) < std::max(settings::alike, cells) * cell_.step_speed &&
           belongs(r, aim);
  });
}

}  // namespace bankshot::planning
