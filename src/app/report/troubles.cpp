// SPDX-License-Identifier: MIT
#include "app/report/troubles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <span>

#include "app/report/compared.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot::app::report {
namespace {

/// Measures what went wrong with one shot under one stepper. The true events are those of our simulator, which agree
/// with 50 digits.
using Trouble = std::function<double(std::size_t shot, const Scheme& scheme)>;

double energy_of(const State<double>& s) { return energy(Body{}, s); }

/// Returns the relative difference of the energy from the true one at the same moment.
Trouble energy_drift(const std::vector<Timed>& shots, const Physics& physics) {
  return [&shots, physics](std::size_t i, const Scheme& scheme) {
    const Stepped s = step_through(comparison_table(), physics, shots[i].start, shots[i].until, scheme);
    const double truth = energy_of(by_events(comparison_table(), physics, shots[i]));
    return std::abs(energy_of(s.state) / truth - 1);
  };
}

/// Counts the bounces up to the shot's moment; returns a negative number if the ball is pocketed.
int bounces(const Boundary& table, const Physics& physics, const Timed& shot) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) {
    Simulator sim(table, motion, cushion, shot.start);
    for (int met = 0;;) {
      const Event e = sim.step(shot.until - sim.time());
      if (e.kind == EventKind::cushion) ++met;
      if (e.kind == EventKind::pocket) return -1;
      if (e.final()) return met;
    }
  });
}

/// Returns 1 if the ball meets more or fewer cushions than it should.
Trouble corner(const std::vector<Timed>& shots, const Physics& physics) {
  return [&shots, physics](std::size_t i, const Scheme& scheme) {
    const Stepped s = step_through(comparison_table(), physics, shots[i].start, shots[i].until, scheme);
    return s.cushions == bounces(comparison_table(), physics, shots[i]) ? 0.0 : 1.0;
  };
}

/// Returns 1 if the ball passes over the pocket into which it should fall.
Trouble tunnel(const std::vector<Timed>& shots, const Physics& physics) {
  return [&shots, physics](std::size_t i, const Scheme& scheme) {
    return step_through(comparison_table(true), physics, shots[i].start, shots[i].until, scheme).pocketed ? 0.0 : 1.0;
  };
}

/// Draws a shot from a random place towards a point, beside which it passes by at most `beside` metres. It ends `after`
/// seconds after a ball that does not slow down would arrive.
Timed towards(Random& draw, const Vec2d& point, double beside, double after) {
  const Boundary& table = comparison_table();
  const Vec2d low = table.walls[0].from, high = table.walls[1].to;
  const Vec2d at{draw.uniform(low.x, high.x), draw.uniform(low.y, high.y)};
  const Vec2d way = point - at, d = way / norm(way);
  const Vec2d aim = way + perpendicular(d) * draw.uniform(-beside, beside);
  const double speed = draw.log_uniform(1, 8);
  return {launched(at, table.body.radius, aim / norm(aim) * speed, LaunchSpin{.top = draw.uniform(-0.5, 1)}),
          norm(way) / speed + after};
}

std::vector<Timed> into_corners(const Physics& physics, int count) {
  constexpr double beside = 0.02, after = 0.3;
  Random draw(1);
  std::vector<Timed> out;
  while (static_cast<int>(out.size()) < count) {
    const Boundary& table = comparison_table();
    const Timed shot = towards(draw, table.walls[static_cast<std::size_t>(draw.uniform(0, 4))].to, beside, after);
    if (bounces(table, physics, shot) >= 2) out.push_back(shot);
  }
  return out;
}

std::vector<Timed> into_pockets(const Physics& physics, int count) {
  constexpr double after = 1;
  Random draw(2);
  std::vector<Timed> out;
  while (static_cast<int>(out.size()) < count) {
    const Boundary& table = comparison_table(true);
    const Circle& pocket = table.pockets[static_cast<std::size_t>(draw.uniform(0, 6))];
    const Timed shot = towards(draw, pocket.centre, pocket.radius, after);
    if (bounces(table, physics, shot) < 0) out.push_back(shot);
  }
  return out;
}

struct SearchRequest {
  const char *name, *title, *axis;
  Trouble trouble;
  std::size_t shots;
  bool share;  ///< true: share of shots in trouble; false: size of the trouble
};

Panel panel(const SearchRequest& q, std::string& csv) {
  Panel p{q.title, {"step [s]", true}, {q.axis, !q.share}, {}};
  constexpr double finest = 1e-4;
  for (const Series& series : stepping_series(finest)) {
    if (series.scheme.method == Scheme::Method::dormand_prince) continue;  // it has no step of its own
    Curve curve{series.name, {}};
    for (const double step : series.steps) {
      Scheme scheme = series.scheme;
      scheme.step = step;
      std::vector<double> found;
      double sum = 0;
      for (std::size_t i = 0; i < q.shots; ++i) {
        found.push_back(q.trouble(i, scheme));
        sum += found.back();
      }
      const double percent = 100 * sum / static_cast<double>(q.shots);
      const Spread s = q.share ? Spread{percent, percent, percent} : spread(found);
      curve.points.push_back({step, s.median, s.low, s.high});
      csv += fmt::format("{},\"{}\",{:.3g},{},{:.4g},{:.4g},{:.4g}\n", q.name, series.name, step, q.shots, s.low,
                         s.median, s.high);
    }
    p.curves.push_back(curve);
  }
  return p;
}

/// Says how far the seed article's method is off, at the largest step and at 1 ms.
std::string in_words(std::span<const Panel> panels) {
  const auto at = [&](std::size_t panel, double step) {
    const std::vector<Point>& points = panels[panel].curves.front().points;
    return std::min_element(points.begin(), points.end(),
                            [&](const Point& a, const Point& b) { return std::abs(a.x - step) < std::abs(b.x - step); })
        ->y;
  };
  constexpr double large = 0.1, small = 1e-3;
  const auto say = [&](double step) {
    return fmt::format(
        " With steps of {} its energy is off by {:.2g} %. It then bounces wrongly in {:.2g} % of the corners and "
        "passes over {:.2g} % of the pockets.",
        short_time(step), 100 * at(0, step), at(1, step), at(2, step));
  };
  return " The last row shows the seed article's Euler method among others." + say(large) + say(small);
}

}  // namespace

void add_troubles(const Settings& settings, Section& section, Progress& progress) {
  constexpr int times_more = 10;  // these runs are short
  const int count = times_more * settings.shots;
  const Physics physics = spin_physics();
  Random draw(3);
  std::vector<Timed> ordinary;
  for (int i = 0; i < count; ++i) ordinary.push_back(timed_shot(draw, physics, 3));
  const std::vector<Timed> corners = into_corners(physics, count), pockets = into_pockets(physics, count);
  const SearchRequest questions[] = {{"energy_drift", "energy after 3 cushions, spin", "off by a share of",
                                      energy_drift(ordinary, physics), ordinary.size(), false},
                                     {"corner", "stuck or lost in a corner, spin", "wrong bounces [% of shots]",
                                      corner(corners, physics), corners.size(), true},
                                     {"tunnel", "passes over its pocket, spin", "not pocketed [% of shots]",
                                      tunnel(pockets, physics), pockets.size(), true}};
  std::string csv = "trouble,method,step,shots,low_10,median_or_percent,high_90\n";
  for (const SearchRequest& q : questions) {
    section.figure.panels.push_back(panel(q, csv));
    progress.step();
  }
  section.caption += in_words({section.figure.panels.end() - std::size(questions), section.figure.panels.end()});
  section.data.push_back({section.name + "-troubles", csv});
}

}  // namespace bankshot::app::report
