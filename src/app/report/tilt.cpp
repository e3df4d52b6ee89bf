// SPDX-License-Identifier: MIT
//
// Section 7: error and time of ways to follow a ball on a table that leans, and how fast they converge.
#include <fmt/format.h>

#include <cmath>

#include "app/report/inclines.hpp"
#include "app/report/sections.hpp"
#include "bankshot/contact/any_cushion.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "truth/run.hpp"

namespace bankshot::app::report {
namespace {

constexpr double asked_error = 1e-9;       // m, where times are compared
constexpr double floor_of_figure = 1e-18;  // m: an error of 0 is drawn here
constexpr double least_rise = 1e-4, most_rise = 1e-2;
constexpr int most_steps = 256;
constexpr const char* whole = "ours, simulated";
constexpr const char* closed = "ours, closed form";
constexpr const char* integrated = "Dormand–Prince";
constexpr const char* first_order = "perturbed level path";

/// Returns a table so large that no ball meets a cushion.
const Boundary& open_cloth() {
  static const Boundary boundary = [] {
    Table t = rectangle_table(2000, 2000);
    for (Vec2d& v : t.vertices) v = v - Vec2d{1000, 1000};
    return Boundary(t, Body{});
  }();
  return boundary;
}

/// A ball that slides until it rolls, or rolls until it rests, and its position at that moment.
struct Shot {
  Tilted motion;
  State<double> start;
  detail::Incline<double> law;
  Vec2d w;       ///< slip of a slide, velocity of a roll
  double share;  ///< change of the velocity per change of w
  Vec2d truth, rest;

  Vec2d weight() const { return law.down * (share < 1 ? law.pull * (1 - share) : 0); }
  Vec2d place(const Slipped& s) const {
    return start.at + start.velocity * s.time + (s.moved - w * s.time) * share + weight() * (s.time * s.time / 2);
  }
  double error(const Vec2d& at) const { return norm((at - truth) - rest); }
};

Shot draw_shot(Random& draw, bool slides, double rise) {
  Physics physics = spin_physics();
  physics.tilt = direction(draw.uniform(0, radians(360))) * rise;
  const double speed = draw.log_uniform(0.3, 4);
  const LaunchSpin spin = slides ? LaunchSpin{draw.uniform(-1, 0.5), 0, draw.uniform(-0.5, 0.5)} : LaunchSpin{1, 0, 0};
  const Vec2d velocity = direction(draw.uniform(0, radians(360))) * speed;
  Shot shot{tilted(physics), launched({0, 0}, Body{}.radius, velocity, spin), {}, velocity, 1, {}, {}};
  if (!slides) shot.start.spin = natural_roll(velocity, Body{}.radius);
  const double g = shot.motion.g, size = norm(physics.tilt);
  shot.law = {shot.motion.rolling_friction.at_rest * g, 0, size * g * 5 / 7, physics.tilt / -size};
  if (slides) {
    shot.law.friction = shot.motion.sliding_friction * g * 7 / 2, shot.law.pull = size * g;
    shot.w = SlideRoll::slip(Body{}, shot.start);
    shot.share = 2.0 / 7;
  }
  truth::Run run{open_cloth(), physics, shot.start};
  run.events = 1;
  const truth::TruthEvent last = truth::run_truth(run).events.back();
  shot.truth = last.state.at, shot.rest = last.at_rest;
  return shot;
}

Vec2d simulated(const Shot& shot) {
  Simulator sim(open_cloth(), shot.motion, AnyCushion{Mirror{}}, shot.start);
  sim.step();
  return sim.state().at;
}

struct Tables {
  std::string costs =
      "motion,method,tolerance,shots,error_low_10,error_median,error_high_90,seconds_low_10,seconds_median,seconds_"
      "high_90\n";
  std::string orders = "method,steps,shots,error_low_10,error_median,error_high_90\n";
  std::string slopes = "method,rise,shots,error_low_10,error_median,error_high_90\n";
};

struct Setting {
  double tolerance;
  Spread error, seconds;
};

template <class Place>
Setting measure(const std::vector<Shot>& shots, const char* motion, const char* name, double tolerance, Tables& csv,
                const Place& place) {
  std::vector<double> errors, seconds;
  for (const Shot& shot : shots) {
    Vec2d at{};
    seconds.push_back(seconds_of([&] { at = place(shot); }));
    errors.push_back(shot.error(at));
  }
  const Setting s{tolerance, spread(errors), spread(seconds)};
  csv.costs += fmt::format("{},\"{}\",{:.3g},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g}\n", motion, name, tolerance,
                           shots.size(), s.error.low, s.error.median, s.error.high, s.seconds.low, s.seconds.median,
                           s.seconds.high);
  return s;
}

Curve curve_of(const char* name, const std::vector<Setting>& settings) {
  Curve c{name, {}, settings.size() == 1 ? Curve::Style::points : Curve::Style::line_points};
  const auto shown = [](double error) { return std::max(error, floor_of_figure); };
  for (const Setting& s : settings)
    c.points.push_back({s.seconds.median, shown(s.error.median), shown(s.error.low), shown(s.error.high)});
  return c;
}

/// Error against time; each method has a row in the table.
struct Costs {
  Panel panel;
  double ours = 0, alone = 0, theirs = 0;  ///< s: simulated, closed form, Dormand–Prince at the error asked
  double error = 0, perturbed = 0;         ///< m, medians
};

Costs costs(const std::vector<Shot>& shots, const char* motion, Numbers& table, Tables& csv, Progress& progress) {
  Costs out{{fmt::format("{}, to its end", motion), {"processor time [s]", true}, {"error [m]", true}, {}}};
  const auto row = [&](const char* name, const Setting& s) {
    table.rows.push_back({motion, name, s.tolerance > 0 ? short_number(s.tolerance) : "–", short_length(s.error.median),
                          short_length(s.error.high), short_time(s.seconds.median)});
  };
  const Setting ours = measure(shots, motion, whole, 0, csv, simulated);
  const Setting alone =
      measure(shots, motion, closed, 0, csv, [](const Shot& s) { return s.place(exactly(s.law, s.w)); });
  std::vector<Setting> theirs;
  for (int digits = 3; digits <= 14; ++digits) {
    const double tolerance = std::pow(10, -digits);
    theirs.push_back(measure(shots, motion, integrated, tolerance, csv,
                             [&](const Shot& s) { return s.place(dormand_prince_to_stop(s.law, s.w, tolerance)); }));
  }
  const Setting near =
      measure(shots, motion, first_order, 0, csv, [](const Shot& s) { return s.place(perturbed(s.law, s.w)); });
  const auto enough = std::ranges::find_if(theirs, [](const Setting& s) { return s.error.median <= asked_error; });
  const Setting& chosen = enough == theirs.end() ? theirs.back() : *enough;
  row(whole, ours);
  row(closed, alone);
  row(integrated, chosen);
  row(first_order, near);
  out.panel.curves = {curve_of(whole, {ours}), curve_of(closed, {alone}), curve_of(integrated, theirs),
                      curve_of(first_order, {near})};
  out.ours = ours.seconds.median, out.alone = alone.seconds.median, out.theirs = chosen.seconds.median;
  out.error = ours.error.median, out.perturbed = near.error.median;
  progress.step();
  return out;
}

/// Returns the slope of log error over log x between the last two points above rounding.
double order(const Curve& c) {
  constexpr double rounding = 1e-12;  // m
  std::size_t last = c.points.size() - 1;
  while (last > 1 && !(c.points[last].y > rounding)) --last;
  const Point &p = c.points[last - 1], &q = c.points[last];
  return std::log(q.y / p.y) / std::log(q.x / p.x);
}

/// Returns the largest distance in a piece between the path and its chord, the parabola through both ends.
double chord_error(const Shot& shot, double lasts) {
  const Slipped end = exactly(shot.law, shot.w, lasts);
  const Vec2d beyond = end.moved - shot.w * lasts;
  double worst = 0;
  for (const double part : {0.25, 0.5, 0.75}) {
    const Slipped there = exactly(shot.law, shot.w, part * lasts);
    worst = std::max(worst, norm(there.moved - shot.w * there.time - beyond * (part * part)) * shot.share);
  }
  return worst;
}

/// Plots the error against the number of equal steps through the first half of a roll.
Panel orders(const std::vector<Shot>& shots, Numbers& table, Tables& csv, Progress& progress) {
  Panel panel{"through the first half of a roll", {"steps", true}, {"error [m]", true}, {}};
  const auto add = [&](const char* name, const auto& error) {
    Curve c{name, {}};
    for (int steps = 1; steps <= most_steps; steps *= 2) {
      std::vector<double> errors;
      for (const Shot& shot : shots) errors.push_back(error(shot, exactly(shot.law, shot.w).time / 2, steps));
      const Spread s = spread(errors);
      c.points.push_back({static_cast<double>(steps), std::max(s.median, floor_of_figure),
                          std::max(s.low, floor_of_figure), std::max(s.high, floor_of_figure)});
      csv.orders +=
          fmt::format("\"{}\",{},{},{:.3g},{:.3g},{:.3g}\n", name, steps, shots.size(), s.low, s.median, s.high);
    }
    panel.curves.push_back(c);
    table.rows.push_back({"order of convergence", name, fmt::format("{:.2f}", -order(c)),
                          short_length(c.points.front().y), short_length(c.points.back().y), "–"});
  };
  const auto by_series = [](int terms) {
    return [terms](const Shot& s, double until, int steps) {
      return norm(series(s.law, s.w, until, terms, steps).moved - exactly(s.law, s.w, until).moved);
    };
  };
  add("chord from path", [](const Shot& s, double until, int steps) { return chord_error(s, until / steps); });
  add(integrated, [](const Shot& s, double until, int steps) {
    return norm(dormand_prince(s.law, s.w, until, steps).moved - exactly(s.law, s.w, until).moved);
  });
  add("series, 3 terms", by_series(3));
  add("series, 6 terms", by_series(6));
  add("series, 12 terms", by_series(12));
  progress.step();
  return panel;
}

/// Plots the error against the slope of the table.
Panel slopes(int count, Numbers& table, Tables& csv, Progress& progress) {
  Panel panel{"a roll to its end", {"rise of the table [m/m]", true}, {"error [m]", true}, {}};
  Curve ours{whole, {}}, near{first_order, {}};
  for (const double rise : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}) {
    Random draw(7);
    std::vector<double> errors, misses;
    for (int i = 0; i < count; ++i) {
      const Shot shot = draw_shot(draw, false, rise);
      errors.push_back(shot.error(simulated(shot)));
      misses.push_back(shot.error(shot.place(perturbed(shot.law, shot.w))));
    }
    const auto add = [&](Curve& c, const Spread& s) {
      c.points.push_back({rise, std::max(s.median, floor_of_figure), std::max(s.low, floor_of_figure),
                          std::max(s.high, floor_of_figure)});
      csv.slopes +=
          fmt::format("\"{}\",{:.3g},{},{:.3g},{:.3g},{:.3g}\n", c.name, rise, count, s.low, s.median, s.high);
    };
    add(ours, spread(errors));
    add(near, spread(misses));
    progress.step();
  }
  table.rows.push_back({"order in the slope", first_order, fmt::format("{:.2f}", order(near)),
                        short_length(near.points.front().y), short_length(near.points.back().y), "–"});
  panel.curves = {ours, near};
  return panel;
}

constexpr const char* question = "What does it cost to follow a ball exactly on a table that leans?";
constexpr const char* about =
    "A ball slides or rolls on a cloth that rises by 0.1 to 10 mm per metre, and meets nothing. The quantity "
    "compared is its place when that motion ends. The truth is the simulator in 50 digits, which tests compare "
    "with closed forms with exponentials. Our simulator has a closed form for the end and a power series for "
    "moments before it. It finds cushions and balls on chords of the path. “Simulated” pays for all of this, "
    "“closed form” for the end alone. Dormand–Prince (Boost.Odeint) keeps a tolerance until the direction of "
    "friction is lost, and goes straight on from there. It looks for no events. The closed form of a level table, "
    "perturbed to first order in the slope, is as cheap as can be. In the third panel each method takes the same "
    "number of equal steps half way to the stop, and is compared with the closed form. The chord's error is its "
    "distance from the path of one piece of that length.";

}  // namespace

Section tilt(const Settings& settings, Progress& progress) {
  Section s{.name = "7-tilt", .title = "Tilt", .question = question, .about = about};
  progress.begin("tilt", 10);
  s.table = {{"motion", "method", "tolerance, or order", "error, median", "error, 90 %", "time"}, {}, 2};
  Tables csv;
  std::vector<Costs> both;
  std::vector<Shot> rolls;
  for (const bool slides : {true, false}) {
    Random draw(7);
    std::vector<Shot> shots;
    for (int i = 0; i < settings.shots; ++i)
      shots.push_back(draw_shot(draw, slides, draw.log_uniform(least_rise, most_rise)));
    both.push_back(costs(shots, slides ? "slide" : "roll", s.table, csv, progress));
    s.figure.panels.push_back(both.back().panel);
    if (!slides) rolls = shots;
  }
  share_x(s.figure.panels);
  share_y(s.figure.panels);
  s.figure.panels.push_back(orders(rolls, s.table, csv, progress));
  s.figure.panels.push_back(slopes(settings.shots, s.table, csv, progress));
  s.figure.names = {whole, closed, integrated, first_order};
  s.figure.columns = 2;
  s.figure.row_height = 300;
  s.caption = fmt::format(
      "Medians of {} shots with 10–90 % bands. Tolerances go from 1e-3 to 1e-14. For Dormand–Prince the table has the "
      "first tolerance whose median error is within 1 nm. Orders are measured between the two finest points above "
      "rounding, and their errors are those at the first and the last point of the curve.",
      settings.shots);
  const Costs &slide = both[0], &roll = both[1];
  s.conclusion = fmt::format(
      "The closed form says in {} where a slide ends and in {} where a roll ends. Dormand–Prince takes {} and {} for "
      "an error of 1 nm. A simulated shot also looks for events along all its chords, and takes {} and {}. Its errors "
      "are {} and {}. A level path with a correction for the slope is off by {} and {}.",
      short_time(slide.alone), short_time(roll.alone), short_time(slide.theirs), short_time(roll.theirs),
      short_time(slide.ours), short_time(roll.ours), short_length(slide.error), short_length(roll.error),
      short_length(slide.perturbed), short_length(roll.perturbed));
  s.data = {{s.name, csv.costs}, {s.name + "-orders", csv.orders}, {s.name + "-slopes", csv.slopes}};
  return s;
}

}  // namespace bankshot::app::report
