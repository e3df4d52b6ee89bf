// SPDX-License-Identifier: MIT
//
// Planner `sweep` where a path's shape depends on its speed: a forward map of aim × ln speed.
// Method: each node simulates the real path with dual numbers; the free leg after any number of bounces that is
// allowed has a residual and its derivatives, which lead to roots (roots.hpp). Of each aim only the speeds are tried
// that may arrive as asked. Between two neighbours that meet different cushions the aim is divided near where that
// changes, so that narrow sequences get nodes of their own. A sequence that is given is mapped on its locked path.
// Cost: some thousands of simulations with dual numbers, a third of a microsecond a bounce each.
// Guarantee: none; a root is missed where the map bends within a cell more than the reach allows, or
// where a sequence is narrower than the spacing and lies between equal neighbours.
#include <algorithm>
#include <cmath>

#include "planners/images/unfold.hpp"
#include "planners/locked/roots.hpp"
#include "planners/merit/robustness.hpp"

namespace bankshot::planning {
namespace {

constexpr double band =
    1.5;  // cells of speed from a node to launches that arrive as asked, beyond which it is left alone
constexpr double narrowest = 1e-4;        // rad; where the division between two sequences ends
constexpr double narrowest_given = 1e-7;  // and between two ways to leave the one that is given

class Map {
 public:
  Map(Search& s, const Spacing& spacing, std::string_view planner)
      : s_(s), cell_(spacing), roots_(s, spacing, planner) {}

  void run() {
    const Range around = s_.puzzle.angle.value_or(Range{0, radians(360)});
    const int aims = std::max(1, static_cast<int>(std::ceil((around.high - around.low) / cell_.aim)));
    const auto aim = [&](int i) { return around.low + (around.high - around.low) * i / aims; };
    const std::vector<double> rows = speeds();
    Column before = column(aim(0), rows, {});
    for (int i = 1; i <= aims && !roots_.done(); ++i) {
      Column after = column(aim(i), rows, before);
      for (std::size_t k = 0; k < rows.size() && !roots_.done(); ++k) {
        if (within(before[k]) && !after[k]) after[k] = node(aim(i), rows[k]);
        if (within(after[k]) && !before[k]) before[k] = node(aim(i - 1), rows[k]);
        if (before[k] && after[k]) between(*before[k], *after[k]);
      }
      before = std::move(after);
    }
    if (s_.all || s_.shots.empty()) roots_.seek_rest();
    if (s_.shots.empty()) s_.leads.insert(s_.leads.end(), leads_.begin(), leads_.end());
  }

  void fan_out() {
    const int most = static_cast<int>(std::ceil(radians(180) / cell_.aim));
    Unfolding images(s_, true, restitution(s_.puzzle.physics).at_rest, true);
    while (const auto image = images.next()) {
      const std::vector<Contact> contacts = images.contacts(*image);
      for (int i = 1; i <= 2 * most && !roots_.done(); ++i) {
        const double angle = image->angle + cell_.aim * (i / 2) * (i % 2 == 0 ? 1 : -1);
        if (const auto speed = speed_at(s_, {s_, contacts, image->target}, angle, image->distance)) node(angle, *speed);
      }
    }
  }

 private:
  /// How fast a node's launch is, against those that arrive as asked.
  enum class Place { below, within, beyond };
  struct Node {
    double angle, speed;
    std::vector<Contact> contacts;
    std::vector<BouncePlace> places;
    Place place;
  };
  using Column = std::vector<std::optional<Node>>;  ///< one aim at all speeds, where it is worth while

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
    for (const Vec2d& p : s_.aim_points())
      nearest = std::min(nearest, norm(p - s_.puzzle.ball.at) - s_.capture(s_.reach(p)));
    const double asked = s_.arrival ? s_.arrival->low : 0;
    const double energy = asked * asked + 2 * deceleration(s_.puzzle.physics) * std::max(0.0, nearest);
    return std::max(std::sqrt(energy), 1e-3 * s_.puzzle.speed.high);
  }

  static bool within(const std::optional<Node>& n) { return n && n->place == Place::within; }

  /// Only the speeds around those that arrive as asked matter. They change little from one aim to the next, so begin
  /// near where they began at the neighbour, and go up until a row is too fast, down until one is too slow.
  Column column(double angle, const std::vector<double>& rows, const Column& neighbour) {
    constexpr std::size_t before_band = 2;
    Column out(rows.size());
    const auto first =
        static_cast<std::size_t>(std::find_if(neighbour.begin(), neighbour.end(), within) - neighbour.begin());
    const std::size_t start = first < neighbour.size() ? std::max(first, before_band) - before_band : 0;
    const auto place = [&](std::size_t k) {
      out[k] = node(angle, rows[k]);
      return out[k]->place;
    };
    bool too_fast = false, too_slow = false;
    for (std::size_t k = start; k < rows.size() && !too_fast && !roots_.done(); ++k) {
      const Place p = place(k);
      too_fast = p == Place::beyond;
      too_slow = too_slow || (k == start && p == Place::below);
    }
    for (std::size_t k = start; k-- > 0 && !too_slow && !roots_.done();) too_slow = place(k) == Place::below;
    return out;
  }

  Node node(double angle, double speed) {
    forward(s_, {speed, wrap_angle(angle)}, cell_.locked, forward_);
    for (const Passage& p : forward_.passages) {
      lead(angle, speed, p);
      roots_.visit({s_, std::span<const Contact>(forward_.contacts).first(p.bounces), s_.aim_points()[p.aim_point]},
                   {speed, angle}, p.linear);
    }
    return {angle, speed, forward_.contacts, forward_.places, place()};
  }

  /// Of what was followed last.
  Place place() const {
    if (cell_.whole || !s_.boundary.unfolds())
      return Place::within;  // a reflex vertex sends a little less speed another way
    if (forward_.passages.empty()) return forward_.rests ? Place::below : Place::within;
    const auto steps = [&](const Passage& p) {  // cells of speed to where it arrives as asked
      const Linear& l = p.linear;
      if (s_.one_unknown()) return 0.0;
      if (!s_.stop) return -l.r[1] / l.by_speed[1] / cell_.speed;
      const double diagonal = s_.boundary.diagonal;
      const double outside = -s_.boundary.clearance(
          s_.aim_points()[p.aim_point] - Vec2d{l.r[0], l.r[1]} * diagonal);  // a ball rests there that is too fast
      return outside > 0 ? -outside / (diagonal * std::hypot(l.by_speed[0], l.by_speed[1])) / cell_.speed : 0;
    };
    bool below = true, beyond = true;
    for (const Passage& p : forward_.passages) {
      const double s = steps(p);
      below = below && s > band;
      beyond = beyond && s < -band;
    }
    return below ? Place::below : beyond ? Place::beyond : Place::within;
  }

  /// Keeps a node from which a turn within its cell may reach some part of the target, though perhaps
  /// not its centre, at the speed that arrives as asked.
  void lead(double angle, double speed, const Passage& p) {
    if (!s_.shots.empty()) return;
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
    if (!(std::abs(lateral) < wide && std::abs(step) < seed_reach * cell_.speed)) return;
    const std::span<const Contact> contacts(forward_.contacts.data(), p.bounces);
    for (const Search::Lead& known : leads_)
      if (known.target == target && std::abs(angle_difference(known.launch.angle, angle)) < cell_.aim / 2 &&
          std::ranges::equal(known.contacts, contacts))
        return;
    leads_.push_back(
        {{speed * std::exp(step), wrap_angle(angle)}, {contacts.begin(), contacts.end()}, target, cell_.aim});
  }

  void between(const Node& a, const Node& b) {
    if (a.contacts == b.contacts || hopeless(a, b) || s_.spent()) return;
    if (s_.puzzle.cushions.sequence && cell_.locked) return;
    if (b.angle - a.angle < (s_.puzzle.cushions.sequence ? narrowest_given : narrowest)) return;
    const Node other = node(change(a, b), a.speed);
    between(a, other);
    between(other, b);
  }

  /// A path between them is too fast as well, or ends too early to meet all the cushions.
  bool hopeless(const Node& a, const Node& b) const {
    if (a.place != b.place) return false;
    const auto most = static_cast<int>(std::max(a.contacts.size(), b.contacts.size()));
    return a.place == Place::beyond || (a.place == Place::below && most + 1 < s_.puzzle.cushions.min);
  }

  /// Just beyond where one of two neighbours stops meeting the cushion that the other does not, as far as its
  /// derivatives tell; else half way.
  double change(const Node& a, const Node& b) const {
    const double half_way = a.angle + (b.angle - a.angle) / 2;
    const auto m = static_cast<std::size_t>(
        std::mismatch(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end()).first -
        a.contacts.begin());
    double best = half_way, nearest = (b.angle - a.angle) / 2;
    for (const auto& [node, way] : {std::pair{&a, 1.0}, std::pair{&b, -1.0}}) {
      if (m >= node->contacts.size() || m >= node->places.size()) continue;
      const Wall* const wall = s_.boundary.line(node->contacts[m]);
      if (!wall) continue;
      const BouncePlace& at = node->places[m];
      const double end = dot(wall->along, at.by_aim * way > 0 ? wall->to : wall->from);
      const double turn = std::max(narrowest / 3, 1.02 * (end - at.along) / at.by_aim * way);
      if (turn < nearest) best = node->angle + way * turn, nearest = turn;
    }
    return best;
  }

  Search& s_;
  Spacing cell_;
  Roots roots_;
  Forward forward_{};
  std::vector<Search::Lead> leads_{};
};

}  // namespace

void map(Search& s, const Spacing& spacing) { Map(s, spacing, "sweep").run(); }
void fan_out(Search& s, const Spacing& spacing) { Map(s, spacing, "fan").fan_out(); }

}  // namespace bankshot::planning
