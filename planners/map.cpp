// SPDX-License-Identifier: MIT
//
// Planner `sweep` where a path's shape depends on its speed: a forward map of aim × ln speed.
// Method: each node simulates the real path with dual numbers; the free leg after any number of
// bounces that is allowed has a residual and its derivatives, so the node predicts where the root of
// its sequence lies. A prediction within reach of the node seeds Levenberg–Marquardt on the locked
// path. Between two neighbours that meet different cushions the aim is bisected, so that narrow
// sequences get nodes of their own. A sequence that is given is mapped on its locked path.
// Cost: some thousands of simulations with dual numbers, a third of a microsecond a bounce each.
// Guarantee: none; a root is missed where the map bends within a cell more than the reach allows, or
// where a sequence is narrower than the spacing and lies between equal neighbours.
#include <algorithm>
#include <cmath>

#include "planners/locked.hpp"
#include "planners/planners.hpp"
#include "planners/robustness.hpp"
#include "planners/unfold.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

constexpr double reach = 1.5;       // cells from a node to a root that it may seed
constexpr double near = 0.05;       // cells; a Newton step this short tells which root it goes to
constexpr double narrowest = 1e-4;  // rad; where the bisection between two sequences ends
constexpr double narrowest_given = 1e-7;  // and between two ways to leave the one that is given

class Map {
 public:
  Map(Search& s, const Spacing& spacing, std::string_view planner) : s_(s), cell_(spacing), planner_(planner) {}

  void run() {
    const Range around = s_.puzzle.angle.value_or(Range{0, radians(360)});
    const int aims = std::max(1, static_cast<int>(std::ceil((around.high - around.low) / cell_.aim)));
    for (const double speed : speeds()) {
      Node before = node(around.low, speed);
      for (int i = 1; i <= aims && !done(); ++i) {
        Node after = node(around.low + (around.high - around.low) * i / aims, speed);
        between(before, after);
        before = std::move(after);
      }
    }
    if (s_.shots.empty()) s_.leads.insert(s_.leads.end(), leads_.begin(), leads_.end());
  }

  void fan_out() {
    const int most = static_cast<int>(std::ceil(radians(180) / cell_.aim));
    Unfolding images(s_, true, restitution(s_.puzzle.physics).at_rest, true);
    while (const auto image = images.next()) {
      const std::vector<int> contacts = images.contacts(*image);
      for (int i = 1; i <= 2 * most && !done(); ++i) {
        const double angle = image->angle + cell_.aim * (i / 2) * (i % 2 == 0 ? 1 : -1);
        if (const auto speed = speed_at(s_, {s_, contacts, image->target}, angle, image->distance)) node(angle, *speed);
      }
    }
  }

 private:
  struct Node {
    double angle, speed;
    std::vector<int> contacts;
  };
  struct Root {
    std::vector<int> contacts;
    std::size_t aim_point;
    Launch launch;
  };

  /// One sequence hardly ever has two roots.
  bool done() { return s_.spent() || s_.satisfied() || (s_.puzzle.cushions.sequence && !s_.all && !s_.shots.empty()); }

  std::vector<double> speeds() const {
    const Range& v = s_.puzzle.speed;
    if (s_.pinned || v.fixed()) return {s_.pinned.value_or(v.low)};
    const double low = std::max(v.low, slowest_arrival());
    if (!(low < v.high)) return {v.high};
    const int rows = 1 + static_cast<int>(std::ceil(std::log(v.high / low) / cell_.speed));
    std::vector<double> out;
    for (int i = 0; i < rows; ++i) out.push_back(low * std::pow(v.high / low, static_cast<double>(i) / (rows - 1)));
    return out;
  }

  /// m/s. No slower launch rolls as far as the nearest aim point, nor arrives as fast as asked.
  double slowest_arrival() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2d& p : s_.aim_points()) nearest = std::min(nearest, norm(p - s_.puzzle.ball.at) - s_.capture(s_.reach(p)));
    const double asked = s_.arrival ? s_.arrival->low : 0;
    const double energy = asked * asked + 2 * deceleration(s_.puzzle.physics) * std::max(0.0, nearest);
    return std::max(std::sqrt(energy), 1e-3 * s_.puzzle.speed.high);
  }

  Node node(double angle, double speed) {
    forward(s_, {speed, wrap_angle(angle)}, cell_.locked, forward_);
    for (const Passage& p : forward_.passages) seed(angle, speed, p);
    return {angle, speed, forward_.contacts};
  }

  void seed(double angle, double speed, const Passage& p) {
    lead(angle, speed, p);
    const auto step = newton_step(p.linear, s_.one_unknown());
    if (!step || !(std::abs(step->x) < reach * cell_.aim && std::abs(step->y) < reach * cell_.speed)) return;
    const Launch predicted{speed * std::exp(step->y), angle + step->x};
    const std::span<const int> contacts(forward_.contacts.data(), p.bounces);
    const LockedAim aim{s_, contacts, s_.aim_points()[p.aim_point]};
    if (const auto root = new_root(aim, predicted, p.aim_point)) add(aim, *root, p.aim_point);
  }

  void add(const LockedAim& aim, const Launch& root, std::size_t aim_point) {
    roots_.push_back({{aim.contacts.begin(), aim.contacts.end()}, aim_point, root});
    certify_root(s_, aim, root, planner_);
    if (s_.all) across_fold(aim, root, aim_point);
  }

  /// Roots come in pairs on the two sides of a fold or a kink, where the determinant changes its sign; nodes
  /// are too far apart to see both. So Newton's method also starts around a root wherever that sign is another.
  void across_fold(const LockedAim& aim, const Launch& root, std::size_t aim_point) {
    const auto determinant = [&](const Launch& l) {
      const auto at = linearise(s_, aim, l);
      return at ? at->determinant(s_.one_unknown()) : 0;
    };
    const double here = determinant(root);
    constexpr int ways = 8;
    for (const double cells : {0.02, 0.1, 0.3})
      for (int i = 0; i < ways; ++i) {
        const Vec2d turn = direction(radians(360) * i / ways) * cells;
        const Launch from{root.speed * std::exp(turn.y * cell_.speed), root.angle + turn.x * cell_.aim};
        if (!(determinant(from) * here < 0)) continue;
        const auto other = newton(s_, aim, from, {cell_.aim, cell_.speed});
        if (other && !known(*other, aim.contacts, aim_point, 0)) add(aim, *other, aim_point);
      }
  }

  /// The root that a prediction leads to; none when it is known.
  std::optional<Launch> new_root(const LockedAim& aim, const Launch& predicted, std::size_t aim_point) {
    return newton(s_, aim, predicted, {cell_.aim, cell_.speed}, [&](const Launch& at, double size) {
      return size < near && known(at, aim.contacts, aim_point, 2 * size);
    });
  }

  /// A root of the same sequence and target lies within so many cells.
  bool known(const Launch& l, std::span<const int> contacts, std::size_t aim_point, double cells) const {
    const double least = 1e-6;  // rounding of a root where the map is steep
    return std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) {
      return r.aim_point == aim_point && std::abs(angle_difference(r.launch.angle, l.angle)) < std::max(least, cells) * cell_.aim &&
             std::abs(std::log(r.launch.speed / l.speed)) < std::max(least, cells) * cell_.speed && std::ranges::equal(contacts, r.contacts);
    });
  }

  /// Keeps a node from which a turn within its cell may reach some part of the target, though perhaps
  /// not its centre, at the speed that arrives as asked.
  void lead(double angle, double speed, const Passage& p) {
    const Linear& l = p.linear;
    double lateral = l.r[0], by_aim = l.by_aim[0], step = 0;
    if (!s_.one_unknown()) {
      const std::size_t along = !s_.stop || std::abs(l.by_speed[1]) > std::abs(l.by_speed[0]) ? 1 : 0;
      step = -l.r[along] / l.by_speed[along];
      lateral = l.r[1 - along] + l.by_speed[1 - along] * step;
      by_aim = l.by_aim[1 - along] - l.by_speed[1 - along] * l.by_aim[along] / l.by_speed[along];
    }
    const Vec2d& target = s_.aim_points()[p.aim_point];
    const double wide = s_.reach(target) / s_.boundary.diagonal + std::abs(by_aim) * cell_.aim;
    if (!(std::abs(lateral) < wide && std::abs(step) < reach * cell_.speed)) return;
    const std::span<const int> contacts(forward_.contacts.data(), p.bounces);
    for (const Search::Lead& known : leads_)
      if (known.target == target && std::abs(angle_difference(known.launch.angle, angle)) < cell_.aim / 2 && std::ranges::equal(known.contacts, contacts)) return;
    leads_.push_back({{speed * std::exp(step), wrap_angle(angle)}, {contacts.begin(), contacts.end()}, target, cell_.aim});
  }

  void between(const Node& a, const Node& b) {
    if ((s_.puzzle.cushions.sequence && cell_.locked) || a.contacts == b.contacts || b.angle - a.angle < (s_.puzzle.cushions.sequence ? narrowest_given : narrowest) || s_.spent()) return;
    const Node middle = node(a.angle + (b.angle - a.angle) / 2, a.speed);
    between(a, middle);
    between(middle, b);
  }

  Search& s_;
  Spacing cell_;
  std::string_view planner_;
  Forward forward_{};
  std::vector<Root> roots_{};
  std::vector<Search::Lead> leads_{};
};

}  // namespace

void map(Search& s, const Spacing& spacing) { Map(s, spacing, "sweep").run(); }
void fan_out(Search& s, const Spacing& spacing) { Map(s, spacing, "fan").fan_out(); }

}  // namespace bankshot::planning
