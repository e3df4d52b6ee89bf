// SPDX-License-Identifier: MIT
//
// Section 6: the cost of a shot as it grows: in cushions, in edges of the table, in length, in digits.
#include <fmt/format.h>

#include <cmath>

#include "app/report/compared.hpp"
#include "app/report/sections.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "truth/condition.hpp"

namespace bankshot::app::report {
namespace {

constexpr double radius = 0.028575;

/// Returns physics in which a ball hardly slows down, so that it meets any number of cushions.
Physics lively_spin() {
  Physics p = spin_physics();
  std::get<SlideRoll>(p.motion).rolling_friction = 1e-5;
  std::get<SlideRoll>(p.motion).sliding_friction = 1e-3;
  p.cushion = Mirror{1};
  return p;
}

/// Simulates up to `cushions` bounces and returns how many were met.
int run(const Boundary& boundary, const Physics& physics, const State<double>& start, int cushions) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) {
    Simulator sim(boundary, motion, cushion, start);
    int met = 0;
    while (met < cushions) {
      const Event e = sim.step();
      if (e.final()) break;
      if (e.kind == EventKind::cushion) ++met;
    }
    return met;
  });
}

State<double> start_in(Random& draw, const Boundary& boundary, double size, double speed) {
  for (;;) {
    const Vec2d at{draw.uniform(0, 2 * size), draw.uniform(0, 2 * size)};
    if (boundary.clearance(at) > 0)
      return launched(at, boundary.body.radius, direction(draw.uniform(0, radians(360))) * speed,
                      LaunchSpin{.top = 0.5});
  }
}

/// One curve: `seconds(draw, x)` for each x, over some shots. It ends at the first x that no shot reaches.
struct Measured {
  std::string what, name;
  std::vector<double> x;
  std::vector<Spread> seconds;
};
template <class Seconds>
Measured sweep(const char* what, const char* name, std::vector<double> xs, int shots, const Seconds& seconds) {
  Measured m{what, name, std::move(xs), {}};
  for (const double x : m.x) {
    Random draw(6);
    std::vector<double> all;
    for (int i = 0; i < shots; ++i)
      if (const double s = seconds(draw, x); s > 0) all.push_back(s);
    if (all.empty()) break;
    m.seconds.push_back(spread(all));
  }
  m.x.resize(m.seconds.size());
  return m;
}

Measured by_cushions(const char* name, const Physics& physics, double speed, int shots) {
  const Boundary table(rectangle_table(2.54, 1.27), {radius});
  return sweep("cushions", name, {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}, shots, [&](Random& draw, double n) {
    constexpr int tries = 50;
    for (int i = 0; i < tries; ++i) {
      const State<double> start = start_in(draw, table, 1.27, speed);
      const int cushions = static_cast<int>(n);
      if (run(table, physics, start, cushions) == cushions)
        return seconds_of([&] { run(table, physics, start, cushions); });
    }
    return 0.0;
  });
}

Table regular(int edges) {
  std::vector<Vec2d> vertices;
  for (int i = 0; i < edges; ++i) {
    const double angle = radians(360.0 * (i + 0.3) / edges);
    vertices.push_back({1 + std::cos(angle), 1 + std::sin(angle)});
  }
  return polygon_table(vertices);
}

Measured by_edges(const char* name, const Physics& physics, int shots) {
  return sweep("edges", name, {3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128}, shots, [&](Random& draw, double n) {
    const Boundary table(regular(static_cast<int>(n)), {radius});
    const State<double> start = start_in(draw, table, 1, 5);
    constexpr int cushions = 5;
    return seconds_of([&] { run(table, physics, start, cushions); });
  });
}

/// Measures five cushions on tables of many sizes; the path's length grows with the table.
Measured by_length(const char* name, const Physics& physics, std::optional<Scheme> scheme, int shots) {
  constexpr int cushions = 5;
  constexpr double speed = 4, ball = 0.001;
  Measured m = sweep("length", name, {0.1, 0.3, 1, 3, 10, 30, 100}, shots, [&](Random& draw, double size) {
    const Boundary table(rectangle_table(2 * size, size), {ball});
    const State<double> start = start_in(draw, table, size, speed);
    truth::Run whole{table, physics, start, cushions};
    const double until = truth::run_double(whole).events.back().time;
    if (scheme) return seconds_of([&] { step_through(table, physics, start, until, *scheme); });
    return seconds_of([&] { run(table, physics, start, cushions); });
  });
  constexpr double sizes_a_path = 5;  // approximate: five cushions on a table of two to one
  for (double& x : m.x) x *= sizes_a_path;
  return m;
}

Measured by_digits(const char* name, const Physics& physics, int shots) {
  const Boundary table(rectangle_table(2.54, 1.27), {radius});
  return sweep("digits", name, {16, 25, 50, 100}, shots, [&](Random& draw, double digits) {
    const State<double> start = start_in(draw, table, 1.27, 5);
    constexpr int cushions = 5;
    if (digits == 16) return seconds_of([&] { run(table, physics, start, cushions); });
    return seconds_of([&] { truth::run_in_digits({table, physics, start, cushions}, static_cast<int>(digits)); });
  });
}

/// Returns the exponent p of seconds ~ x^p over the upper half of the range.
double growth(const Measured& m) {
  const std::size_t last = m.x.size() - 1, from = last / 2;
  return std::log(m.seconds[last].median / m.seconds[from].median) / std::log(m.x[last] / m.x[from]);
}

Panel panel(const char* title, const char* axis, std::vector<Measured> curves) {
  Panel p{title, {axis, true}, {"processor time per shot [s]", true}, {}};
  for (const Measured& m : curves) {
    Curve c{m.name, {}};
    for (std::size_t i = 0; i < m.x.size(); ++i)
      c.points.push_back({m.x[i], m.seconds[i].median, m.seconds[i].low, m.seconds[i].high});
    p.curves.push_back(c);
  }
  return p;
}

constexpr const char* question =
    "What makes a shot take longer: more cushions, more edges, a longer path or more digits?";
constexpr const char* about =
    "One quantity grows, and all others are held. It is the number of cushions on a rectangle, the edges of a "
    "regular polygon, the size of the table, or the digits of the arithmetic. All but the first have 5 cushions. "
    "On a larger table the path is longer; there the ball has 1 mm, and friction hardly slows it. For the length "
    "two stepping simulators are shown as well. Growth is the exponent p of time ~ xᵖ over the upper half of the "
    "range. With 1 the time doubles where x doubles; with 0 it does not grow.";

}  // namespace

Section scaling(const Settings& settings, Progress& progress) {
  const int shots = settings.shots;
  progress.begin("scaling", 4);
  Physics free_rolling{Rolling{.friction = 1e-6}, Mirror{1}};
  const char *ideal = "ideal", *spin = "spin";
  std::vector<std::vector<Measured>> all;
  all.push_back({by_cushions(ideal, ideal_physics(), 1, shots), by_cushions(spin, lively_spin(), 8, shots)});
  progress.step();
  all.push_back({by_edges(ideal, ideal_physics(), shots), by_edges(spin, lively_spin(), shots)});
  progress.step();
  all.push_back(
      {by_length("rolling", free_rolling, {}, shots),
       by_length("Euler, step 1 ms", free_rolling, Scheme{Scheme::Method::euler, false, 1e-3}, shots),
       by_length("Runge–Kutta 4, located, step 10 ms", free_rolling, Scheme{Scheme::Method::rk4, true, 1e-2}, shots)});
  progress.step();
  all.push_back({by_digits(ideal, ideal_physics(), shots), by_digits(spin, spin_physics(), shots)});
  progress.step();

  Section s{.name = "6-scaling", .title = "Scaling", .question = question, .about = about};
  constexpr const char* titles[] = {"cushions", "edges of the table, 5 cushions", "length of the path, 5 cushions",
                                    "digits, 5 cushions"};
  constexpr const char* axes[] = {"cushions", "edges", "length [m], about", "decimal digits"};
  s.table = {{"grows", "simulator", "from", "time", "to", "time", "growth"}, {}, 2};
  std::string csv = "what,simulator,x,low_10_s,median_s,high_90_s\n";
  for (std::size_t k = 0; k < all.size(); ++k) {
    s.figure.panels.push_back(panel(titles[k], axes[k], all[k]));
    for (const Measured& m : all[k]) {
      s.table.rows.push_back({m.what, m.name, short_number(m.x.front()), short_time(m.seconds.front().median),
                              short_number(m.x.back()), short_time(m.seconds.back().median), short_power(growth(m))});
      for (std::size_t i = 0; i < m.x.size(); ++i)
        csv += fmt::format("{},\"{}\",{:.4g},{:.4g},{:.4g},{:.4g}\n", m.what, m.name, m.x[i], m.seconds[i].low,
                           m.seconds[i].median, m.seconds[i].high);
    }
  }
  s.figure.columns = 2;
  s.caption = fmt::format("Medians of {} shots with 10–90 % bands.", shots);
  const double thousand = all[0][1].seconds.back().median / all[0][1].x.back(),
               digits = all[3][1].seconds[2].median / all[3][1].seconds[0].median;
  const auto doubled = [](const Measured& m) { return std::exp2(growth(m)); };
  s.conclusion = fmt::format(
      "Twice as many cushions make a shot take {:.1f} times as long, and twice as many edges {:.1f} times. With spin "
      "each cushion takes {}. A path of twice the length takes {:.1f} times as long, where stepping takes {:.1f} "
      "times. A shot in 50 digits takes {:.0f} times as long as in double.",
      doubled(all[0][1]), doubled(all[1][1]), short_time(thousand), doubled(all[2][0]), doubled(all[2][1]), digits);
  s.data.push_back({s.name, csv});
  return s;
}

}  // namespace bankshot::app::report
