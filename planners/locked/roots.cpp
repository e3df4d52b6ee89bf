// SPDX-License-Identifier: MIT
#include "planners/locked/roots.hpp"

#include <algorithm>
#include <cmath>

#include "planners/merit/robustness.hpp"

namespace bankshot::planning {
namespace {

constexpr double near = 0.05;   // cells; a Newton step this short tells which root it goes to
constexpr double astray = 0.7;  // of the way to a root; a first step that misses it by more leads to another, perhaps

}  // namespace

void Roots::visit(const LockedAim& aim, const Launch& node, const Linear& linear) {
  keep_nearest(aim, node, s_.one_unknown() ? std::abs(linear.r[0]) : linear.size());
  const auto step = newton_step(linear, s_.one_unknown());
  if (!step || !(std::abs(step->x) < seed_reach * cell_.aim && std::abs(step->y) < seed_reach * cell_.speed)) return;
  const Launch predicted{node.speed * std::exp(step->y), node.angle + step->x};
  const auto known_there = [&](const Launch& at, double size) { return size < near && known(aim, at, 2 * size); };
  if (const auto root = newton(s_, aim, predicted, {cell_.aim, cell_.speed}, known_there)) add(aim, *root);
}

void Roots::keep_nearest(const LockedAim& aim, const Launch& node, double miss) {
  Nearest* to_replace = nullptr;
  for (Nearest& n : seen(aim).nearest) {
    if (n.miss < none && std::abs(n.launch.angle - node.angle) < cell_.aim / 2) {
      if (miss < n.miss) n = {node, miss};
      return;
    }
    if (!to_replace || n.miss > to_replace->miss) to_replace = &n;
  }
  if (miss < to_replace->miss) *to_replace = {node, miss};
}

/// Neighbouring nodes have mostly the same sequence.
Roots::Seen& Roots::seen(const LockedAim& aim) {
  if (last_seen_ < seen_.size() && belongs(seen_[last_seen_], aim)) return seen_[last_seen_];
  last_seen_ = static_cast<std::size_t>(
      std::find_if(seen_.begin(), seen_.end(), [&](const Seen& x) { return belongs(x, aim); }) - seen_.begin());
  if (last_seen_ == seen_.size()) seen_.push_back({{aim.contacts.begin(), aim.contacts.end()}, aim.target});
  return seen_[last_seen_];
}

void Roots::seek_rest() {
  for (const Seen& seen : seen_) {
    const LockedAim aim{s_, seen.contacts, seen.target};
    if (std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) { return belongs(r, aim); })) continue;
    for (const Nearest& n : seen.nearest) {
      if (done() || !(n.miss < none)) break;
      constexpr Neighbourhood wide{0.3, 0.5};
      auto root = newton(s_, aim, n.launch, wide);
      if (!root && s_.stop && beside_last(aim)) root = after_last(aim, n.launch);
      if (!root) continue;
      add(aim, *root);
      break;
    }
  }
}

bool Roots::beside_last(const LockedAim& aim) const {
  constexpr double beside = 0.2;  // of the diagonal
  const Wall* const last = aim.contacts.empty() ? nullptr : s_.boundary.line(aim.contacts.back());
  return last && dot(last->normal, aim.target) - last->offset < beside * s_.boundary.diagonal;
}

/// A ball that rests soon after its last bounce was hardly fast enough to get there: from a little above the slowest
/// launch that does.
std::optional<Launch> Roots::after_last(const LockedAim& aim, const Launch& from) {
  double low = from.speed * std::exp(-2 * cell_.speed), high = from.speed;
  constexpr int halvings = 8;
  for (int k = 0; k < halvings; ++k) {
    const double half_way = std::sqrt(low * high);
    (linearise(s_, aim, {half_way, from.angle}) ? high : low) = half_way;
  }
  for (const double faster : {0.003, 0.01, 0.03})
    if (const auto root = newton(s_, aim, {high * (1 + faster), from.angle}, {cell_.aim, 0.03})) return root;
  return {};
}

void Roots::add(const LockedAim& aim, const Launch& root) {
  constexpr std::ptrdiff_t most = 64;  // of one sequence: more are one root, which rounding scatters beside a kink
  if (std::count_if(roots_.begin(), roots_.end(), [&](const Root& r) { return belongs(r, aim); }) >= most) return;
  roots_.push_back({{aim.contacts.begin(), aim.contacts.end()}, aim.target, root});
  const bool shot = certify_root(s_, aim, root, planner_);
  const bool blocked = !shot && s_.point() && s_.puzzle.speed.contains(root.speed);
  if (s_.all || blocked) across_fold(aim, root);
}

/// Roots come in pairs on the two sides of a fold or a kink, where the determinant often changes its sign; nodes are
/// too far apart to see both. So Newton's method also starts around a root wherever that sign is another, or where its
/// first step does not lead back there.
void Roots::across_fold(const LockedAim& aim, const Launch& root) {
  const bool one_unknown = s_.one_unknown();
  const auto at_root = linearise(s_, aim, root);
  if (!at_root) return;
  constexpr int ways = 8;
  for (const double cells : {0.02, 0.1, 0.3})
    for (int i = 0; i < ways; ++i) {
      const Vec2d turn = direction(radians(360) * i / ways) * cells;
      const Launch from{root.speed * std::exp(turn.y * cell_.speed), root.angle + turn.x * cell_.aim};
      const auto at = linearise(s_, aim, from);
      const auto step = at ? newton_step(*at, one_unknown) : std::nullopt;
      if (!step) continue;
      const double missed = std::hypot(step->x / cell_.aim + turn.x, one_unknown ? 0 : step->y / cell_.speed + turn.y);
      if (at->determinant(one_unknown) * at_root->determinant(one_unknown) > 0 && missed < astray * cells) continue;
      const auto other = newton(s_, aim, from, {cell_.aim, cell_.speed});
      if (other && !known(aim, *other, 0)) add(aim, *other);
    }
}

/// A root of the same sequence and target lies within so many cells.
bool Roots::known(const LockedAim& aim, const Launch& l, double cells) const {
  constexpr double least = 1e-6;  // rounding of a root where the map is steep
  return std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) {
    return std::abs(angle_difference(r.launch.angle, l.angle)) < std::max(least, cells) * cell_.aim &&
           std::abs(std::log(r.launch.speed / l.speed)) < std::max(least, cells) * cell_.speed && belongs(r, aim);
  });
}

}  // namespace bankshot::planning
