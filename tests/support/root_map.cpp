// SPDX-License-Identifier: MIT
#include "support/root_map.hpp"

#include <algorithm>
#include <cmath>

namespace bankshot::test {
namespace {

/// A crossing of the arrival speed asked, at one aim: between two launch speeds, or beyond the first or last of its
/// route.
struct Crossing {
  std::uint64_t route;
  int bounces, arrival, nth;              ///< arrival: index of the speed; nth: like crossings before it at this aim
  double angle, speed, flown_at, beside;  ///< rad, m/s, m/s of a simulated launch, m
  bool like(const Crossing& o) const { return route == o.route && arrival == o.arrival && nth == o.nth; }
};
using Column = std::vector<Crossing>;

const Crossing* find(const Column& column, const Crossing& c) {
  const auto found = std::find_if(column.begin(), column.end(), [&](const Crossing& o) { return o.like(c); });
  return found == column.end() ? nullptr : &*found;
}

/// The map of one spin and one list of arrival speeds.
class Map {
 public:
  Map(const Aimed& aimed, const LaunchSpin& spin, std::vector<double> arrivals, long& simulations)
      : a_(aimed), spin_(spin), arrivals_(std::move(arrivals)), simulations_(simulations) {}

  std::vector<Root> roots(const Grid& grid) {
    speeds(grid.speed);
    const Range aims = a_.puzzle.angle.value_or(Range{0, radians(360)});
    const int n = std::max(4, static_cast<int>(std::ceil((aims.high - aims.low) / grid.aim)));
    step_ = (aims.high - aims.low) / n;
    const bool around = !a_.puzzle.angle;
    Column before, here = column(aims.low - (around ? step_ : 0)), after;
    for (int i = around ? 0 : 1; i <= n; ++i) {
      after = column(aims.low + step_ * i);
      between(before, here, after);
      before = std::move(here);
      here = std::move(after);
    }
    between(before, here, {});
    return std::move(found_);
  }

  /// Returns the root near a launch, by its route and at an arrival speed; none when there is none.
  std::optional<Root> refine(Launch launch, std::uint64_t route, double arrival) const {
    constexpr int steps = 25;
    constexpr double h = 1e-7, farthest = 0.05;
    auto at = residual(launch, route, arrival);
    if (!at) return {};
    for (int i = 0; i < steps && at->size() > 1e-14; ++i) {
      const auto turned = residual({launch.speed, launch.angle + h}, route, arrival);
      const auto faster = fixed() ? at : residual({launch.speed * (1 + h), launch.angle}, route, arrival);
      if (!turned || !faster) return {};
      double turn = 0, gain = 0;
      if (fixed()) {
        turn = -at->beside * h / (turned->beside - at->beside);
      } else {
        const double a = (turned->beside - at->beside) / h, b = (faster->beside - at->beside) / h,
                     c = (turned->fast - at->fast) / h, d = (faster->fast - at->fast) / h, det = a * d - b * c;
        turn = (b * at->fast - d * at->beside) / det;
        gain = (c * at->beside - a * at->fast) / det;
      }
      const double long_step = std::max(std::abs(turn), std::abs(gain));
      if (!std::isfinite(long_step)) return {};
      double share = std::min(1.0, farthest / std::max(long_step, 1e-300));
      bool better = false;
      for (int k = 0; k < 12 && !better; ++k, share /= 2) {
        const Launch next{launch.speed * std::exp(gain * share), launch.angle + turn * share};
        const auto there = residual(next, route, arrival);
        better = there && there->size() < at->size();
        if (better) launch = next, at = there;
      }
      if (!better) break;
    }
    return proved(launch, route, arrival, *at);
  }

 private:
  /// Distance of a pass from the target. `beside` is in diagonals, `fast` in m²/s² and `off` in m/s; for a stop both
  /// are in diagonals.
  struct Residual {
    double beside, fast, off, time, arrival;
    double size() const { return std::abs(beside) + std::abs(fast); }
  };

  bool fixed() const { return a_.puzzle.speed.fixed(); }

  Flight flown(const Launch& launch) const {
    ++simulations_;
    return fly(a_, launch, spin_, arrivals_.back());
  }

  std::optional<Residual> residual(const Launch& launch, std::uint64_t route, double arrival) const {
    const Flight f = flown({launch.speed, wrap_angle(launch.angle)});
    std::optional<Residual> best;
    const double diagonal = a_.boundary.diagonal;
    for (int i = 0; i < f.count; ++i) {
      const Pass& p = f.passes[static_cast<std::size_t>(i)];
      if (p.route != route) continue;
      const double scale = a_.stops ? diagonal : 1, off = fixed() ? 0 : (p.fast - arrival) / scale;
      const double fast = fixed() ? 0 : (level(p.fast) - level(arrival)) / scale;
      const Residual r{p.beside / diagonal, fast, off, p.time, a_.stops ? 0 : p.fast};
      if (!best || r.size() < best->size()) best = r;
    }
    return best;
  }

  std::optional<Root> proved(const Launch& found, std::uint64_t route, double arrival, const Residual& at) const {
    constexpr double exact = 1e-9;
    if (!(std::abs(at.beside) <= exact && std::abs(at.off) <= exact * std::max(1.0, arrival))) return {};
    const Puzzle& p = a_.puzzle;
    Root root{{found.speed, wrap_angle(found.angle)}, spin_, {}, route, at.arrival, at.time};
    const double slack = 1e-12 * std::max(1.0, p.speed.high);
    if (root.launch.speed < p.speed.low - slack || root.launch.speed > p.speed.high + slack) return {};
    if (p.angle && wrap_angle(root.launch.angle - p.angle->low) > p.angle->high - p.angle->low) return {};
    fly(a_, root.launch, spin_, arrivals_.back(), &root.cushions);
    return root;
  }

  void speeds(double step) {
    const Range& v = a_.puzzle.speed;
    double slowest = v.low;
    if (!a_.falls && !a_.stops && !fixed()) slowest = std::max(slowest, arrivals_.front() / 2);  // topspin drives on
    slowest = std::min(std::max(slowest, v.high / 1e3), v.high);
    const int n = fixed() ? 0 : std::max(2, static_cast<int>(std::ceil(std::log(v.high / slowest) / step)));
    speeds_.clear();
    for (int i = 0; i <= n; ++i) speeds_.push_back(n ? slowest * std::pow(v.high / slowest, 1.0 * i / n) : v.high);
  }

  Column column(double angle) const {
    constexpr int enough = 3;  // so many launches in a row were too fast
    std::vector<Flight> flights;
    int too_fast = 0;
    for (const double v : speeds_) {
      flights.push_back(flown({v, wrap_angle(angle)}));
      too_fast = flights.back().too_fast ? too_fast + 1 : 0;
      if (too_fast == enough) break;
    }
    Column out;
    for (std::size_t i = 0; i < flights.size(); ++i)
      for (int k = 0; k < flights[i].count; ++k) crossings(angle, flights, i, k, out);
    return out;
  }

  static const Pass* same(const std::vector<Flight>& flights, std::size_t i, const Pass& pass, int nth) {
    if (i >= flights.size()) return nullptr;
    for (int k = 0; k < flights[i].count; ++k) {
      const Pass& p = flights[i].passes[static_cast<std::size_t>(k)];
      if (p.route == pass.route && nth-- == 0) return &p;
    }
    return nullptr;
  }

  /// Returns a quantity that is about linear in the square of the launch speed: the squared speed, or the distance
  /// rolled beyond the target.
  double level(double fast) const { return a_.stops ? fast : fast * fast; }

  /// The launch speed of a pass, and the numbers that decide about a root.
  struct Point {
    double speed, level, beside;
  };

  /// Adds the crossings between a pass and the pass of the next faster launch. Before the first pass of a route and
  /// after its last, the pass is extrapolated.
  void crossings(double angle, const std::vector<Flight>& flights, std::size_t i, int k, Column& out) const {
    const Pass& p = flights[i].passes[static_cast<std::size_t>(k)];
    if (fixed()) return add(out, {p.route, p.bounces, 0, 0, angle, speeds_[i], speeds_[i], p.beside});
    int nth = 0;
    for (int m = 0; m < k; ++m) nth += flights[i].passes[static_cast<std::size_t>(m)].route == p.route;
    const double ratio = speeds_[1] / speeds_[0], v = speeds_[i];
    const Pass *const faster = same(flights, i + 1, p, nth), *const slower = i ? same(flights, i - 1, p, nth) : nullptr;
    const Point here{v, level(p.fast), p.beside};
    const double usual = (ratio - 1) * (a_.stops ? a_.boundary.diagonal : v * v);
    const auto beyond = [&](double speed, const Pass* before, double gain) {
      return before ? Point{speed, 2 * here.level - level(before->fast), 2 * here.beside - before->beside}
                    : Point{speed, here.level + gain, here.beside};
    };
    segment(out, angle, p, v, here,
            faster ? Point{v * ratio, level(faster->fast), faster->beside} : beyond(v * ratio, slower, usual));
    if (!slower) segment(out, angle, p, v, beyond(v / ratio, faster, -usual), here);
  }

  void segment(Column& out, double angle, const Pass& p, double flown_at, const Point& from, const Point& to) const {
    for (std::size_t s = 0; s < arrivals_.size(); ++s) {
      const double a = from.level - level(arrivals_[s]), b = to.level - level(arrivals_[s]);
      if ((a > 0) == (b > 0)) continue;
      const double share = a / (a - b);
      add(out, {p.route, p.bounces, static_cast<int>(s), 0, angle, from.speed + (to.speed - from.speed) * share,
                flown_at, from.beside + (to.beside - from.beside) * share});
    }
  }

  static void add(Column& out, Crossing c) {
    while (find(out, c)) ++c.nth;
    out.push_back(c);
  }

  /// Finds roots between `here` and `after`, and beside `here` where a route begins or ends.
  void between(const Column& before, const Column& here, const Column& after) {
    constexpr double steepest = 20;  // m/rad
    for (const Crossing& c : here) {
      const Crossing *const p = find(before, c), *const q = find(after, c);
      if (q && (c.beside > 0) != (q->beside > 0)) try_between(c, *q);
      if (p && !q && (c.beside > 0) != (2 * c.beside - p->beside > 0)) try_at(c);
      if (q && !p && (c.beside > 0) != (2 * c.beside - q->beside > 0)) try_at(c);
      if (!p && !q && std::abs(c.beside) < steepest * step_) try_at(c);
    }
  }

  void try_between(const Crossing& a, const Crossing& b) {
    const double share = a.beside / (a.beside - b.beside);
    Crossing c = a;
    c.angle += (b.angle - a.angle) * share;
    c.speed += (b.speed - a.speed) * share;
    if (!try_at(c) && !try_at(a)) try_at(b);
  }

  bool try_at(const Crossing& c) {
    const double arrival = fixed() ? 0 : arrivals_[static_cast<std::size_t>(c.arrival)];
    auto root = refine({c.speed, c.angle}, c.route, arrival);
    if (!root) root = refine({c.flown_at, c.angle}, c.route, arrival);
    if (!root) return false;
    constexpr double same = 1e-8;
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const Root& r) {
      return r.route == root->route && std::abs(r.launch.angle - root->launch.angle) < same &&
             std::abs(r.launch.speed - root->launch.speed) < same * r.launch.speed;
    });
    if (!known) found_.push_back(*root);
    return true;
  }

  const Aimed& a_;
  LaunchSpin spin_;
  std::vector<double> arrivals_;  ///< ascending; 0 for a stop
  long& simulations_;
  double step_ = 0;
  std::vector<double> speeds_{};
  std::vector<Root> found_{};
};

}  // namespace

std::vector<Root> roots_on_grid(const Aimed& aimed, const LaunchSpin& spin, const std::vector<double>& arrivals,
                                const Grid& grid, long& simulations) {
  return Map(aimed, spin, arrivals, simulations).roots(grid);
}

std::optional<Root> root_near(const Aimed& aimed, const Root& near, const LaunchSpin& spin, double arrival,
                              long& simulations) {
  return Map(aimed, spin, {arrival}, simulations).refine(near.launch, near.route, arrival);
}

}  // namespace bankshot::test
