// SPDX-License-Identifier: MIT
//
// Section 1: error of the position at a given moment, against the time that a shot costs.
#include <fmt/format.h>

#include <cmath>

#include "app/report/compared.hpp"
#include "app/report/sections.hpp"
#include "app/report/troubles.hpp"
#include "bankshot/plan/generate.hpp"
#include "truth/condition.hpp"

namespace bankshot::app::report {
namespace {

constexpr double asked_error = 1e-6;       // m, where times are compared
constexpr double claim = 100;              // times faster; the section confirms or denies it
constexpr double floor_of_figure = 1e-18;  // m: an error of 0 is drawn here

struct Kind {
  const char* name;
  Physics physics;
};

std::vector<Kind> kinds() {
  Physics drag = spin_physics();
  std::get<SlideRoll>(drag.motion).rolling_friction = {0.005, 0.01};
  return {{"rolling", rolling_physics()}, {"spin", spin_physics()}, {"speed-dependent friction", drag}};
}

/// Median over the shots of one setting.
struct Setting {
  double step;
  Spread error, seconds;
};

struct Measured {
  std::string name;
  std::vector<Setting> settings;
};

/// The least time at which a method keeps the error asked, interpolated linearly between settings in the log-log
/// figure. If even the finest setting does not keep it, its time is a lower bound.
struct Cost {
  double seconds;
  bool reached;
};
Cost cost_at(const Measured& m, double error) {
  const Setting* before = nullptr;
  for (const Setting& s : m.settings) {
    if (s.error.median <= error) {
      if (!before || before->seconds.median >= s.seconds.median || s.error.median <= 0) return {s.seconds.median, true};
      const double share = std::log(before->error.median / error) / std::log(before->error.median / s.error.median);
      return {before->seconds.median * std::pow(s.seconds.median / before->seconds.median, share), true};
    }
    before = &s;
  }
  return {m.settings.back().seconds.median, false};
}

struct Case {
  const Kind& kind;
  int cushions;
  std::vector<Timed> shots;
  std::vector<Vec2d> truth, rest;  ///< the true position is their sum
};

Case draw_case(const Kind& kind, int cushions, int count) {
  Case c{kind, cushions, {}, {}, {}};
  Random draw(static_cast<std::uint64_t>(cushions));
  for (int i = 0; i < count; ++i) {
    const Timed shot = timed_shot(draw, kind.physics, cushions);
    truth::Run run{comparison_table(), kind.physics, shot.start};
    run.until = shot.until;
    const truth::TruthEvent last = truth::run_truth(run).events.back();
    c.shots.push_back(shot);
    c.truth.push_back(last.state.at);
    c.rest.push_back(last.at_rest);
  }
  return c;
}

/// Raw numbers and their medians, as CSV.
struct Tables {
  std::string shots = "physics,cushions,method,step_or_tolerance,shot,error_m,seconds\n";
  std::string settings =
      "physics,cushions,method,step_or_tolerance,shots,error_low_10,error_median,error_high_90,seconds_low_10,seconds_"
      "median,seconds_high_"
      "90\n";
};

/// Measures one setting over all shots; `run(shot)` returns the position.
template <class Run>
Setting measure(const Case& c, const std::string& name, double step, Tables& csv, const Run& run) {
  std::vector<double> errors, seconds;
  for (std::size_t i = 0; i < c.shots.size(); ++i) {
    Vec2d at{};
    seconds.push_back(seconds_of([&] { at = run(c.shots[i]); }));
    errors.push_back(norm((at - c.truth[i]) - c.rest[i]));
    csv.shots += fmt::format("{},{},\"{}\",{:.3g},{},{:.4g},{:.4g}\n", c.kind.name, c.cushions, name, step, i,
                             errors.back(), seconds.back());
  }
  const Spread e = spread(errors), t = spread(seconds);
  csv.settings += fmt::format("{},{},\"{}\",{:.3g},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g}\n", c.kind.name,
                              c.cushions, name, step, errors.size(), e.low, e.median, e.high, t.low, t.median, t.high);
  return {step, e, t};
}

std::vector<Measured> measure_case(const Case& c, double least_step, Tables& csv, Progress& progress) {
  const Boundary& table = comparison_table();
  std::vector<Measured> out{{event_driven, {measure(c, event_driven, 0, csv, [&](const Timed& t) {
                               return by_events(table, c.kind.physics, t).at;
                             })}}};
  progress.step();
  for (const Series& series : stepping_series(least_step)) {
    Measured m{series.name, {}};
    for (const double step : series.steps) {
      Scheme scheme = series.scheme;
      scheme.step = step;
      m.settings.push_back(measure(c, series.name, step, csv, [&](const Timed& t) {
        return step_through(table, c.kind.physics, t.start, t.until, scheme).state.at;
      }));
    }
    out.push_back(m);
    progress.step();
  }
  return out;
}

Panel panel_of(const Case& c, const std::vector<Measured>& all) {
  Panel p{fmt::format("{}, {} cushion{}", c.kind.name, c.cushions, c.cushions == 1 ? "" : "s"),
          {"processor time per shot [s]", true},
          {"error [m]", true},
          {}};
  for (const Measured& m : all) {
    Curve curve{m.name, {}, m.settings.size() == 1 ? Curve::Style::points : Curve::Style::line_points};
    for (const Setting& s : m.settings) {
      const auto visible = [](double error) { return std::max(error, floor_of_figure); };
      curve.points.push_back({s.seconds.median, visible(s.error.median), visible(s.error.low), visible(s.error.high)});
    }
    p.curves.push_back(curve);
  }
  return p;
}

/// Times of other methods as multiples of ours, collected case by case. There is one verdict on methods that locate
/// events and one on those that do not.
struct Verdict {
  int cases = 0, dominated = 0;
  double least = forever, most = 0;
  std::string where;  ///< the case of the least
};

void judge(const Case& c, const std::vector<Measured>& all, Numbers& table, Verdict (&verdicts)[2]) {
  const std::vector<Series> series = stepping_series(1);
  const Setting& ours = all.front().settings.front();
  std::vector<std::string> row{c.kind.name, fmt::format("{}", c.cushions), short_time(ours.seconds.median),
                               short_length(ours.error.median)};
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Cost cost = cost_at(all[k], asked_error);
    const double times = cost.seconds / ours.seconds.median;
    row.push_back((cost.reached ? "" : "> ") + short_count(times));
    Verdict& v = verdicts[series[k - 1].scheme.locate];
    ++v.cases;
    v.dominated += times >= claim;
    v.most = std::max(v.most, times);
    if (times >= v.least) continue;
    v.least = times;
    v.where = fmt::format("{}, {}, {} cushion{}", all[k].name, c.kind.name, c.cushions, c.cushions == 1 ? "" : "s");
  }
  table.rows.push_back(row);
}

std::string conclude(const Verdict (&verdicts)[2], double worst) {
  const Verdict &plain = verdicts[0], &located = verdicts[1];
  return fmt::format(
      "{} Our simulator has a median error of at most {}. For an error of 1 µm it is at least {} times as fast as "
      "stepping without event location. It is {:.0f} times as fast or more in {} of {} cases. It is only {} to {} "
      "times as fast as methods that locate events, because they integrate the smooth motion between events exactly or "
      "nearly so. Among those it is {:.0f} times as fast or more in {} of {} cases. Its least gain is over this one: "
      "{}.",
      plain.least > 1 ? "Jumping from event to event beats many small steps."
                      : "Jumping from event to event does not always beat many small steps.",
      short_length(worst), short_count(plain.least), claim, plain.dominated, plain.cases, short_count(located.least),
      short_count(located.most), claim, located.dominated, located.cases, located.where);
}

constexpr const char* question =
    "At the same error, how much faster is it to compute events than to take small steps through time?";
constexpr const char* about =
    "Random shots run on a 9-foot table without pockets. Each is stopped at a moment after 1, 3 or 5 cushions. "
    "The truth is the event-driven simulator in 50 digits from the same start. For the methods that step, this "
    "truth is independent of what is judged. For our simulator it judges only the arithmetic. Other tests check "
    "that its events and forces are the right ones: events derived by hand, published paths, and the convergence "
    "of every stepper below to the same place. All methods use the same forces and the same cushion laws: mirror "
    "for rolling, Han (2005) otherwise. Where all forces are constant, a fourth-order method that locates events "
    "has no error but rounding, at any step. The last row of the figure shows the troubles that the seed article "
    "describes, counted over shots, against the length of the step.";

}  // namespace

Section simulators(const Settings& settings, Progress& progress) {
  const double least_step = settings.shots < 3 ? 1e-3 : settings.quick ? 1e-5 : 1e-6;
  const std::vector<Kind> all = kinds();
  constexpr int cushions[] = {1, 3, 5};
  progress.begin("simulators", all.size() * std::size(cushions) * (stepping_series(1).size() + 1) + troubles_steps);
  Section s{.name = "1-simulators", .title = "Simulators", .question = question, .about = about};
  s.table = {{"physics", "cushions", "our time", "our error", "Euler", "semi-implicit Euler", "Runge–Kutta 4",
              "Runge–Kutta 4, located", "Dormand–Prince, located"},
             {},
             2};
  Tables csv;
  Verdict verdicts[2];
  double worst = 0;
  for (const Kind& kind : all)
    for (const int n : cushions) {
      const Case c = draw_case(kind, n, settings.shots);
      const std::vector<Measured> measured = measure_case(c, least_step, csv, progress);
      s.figure.panels.push_back(panel_of(c, measured));
      judge(c, measured, s.table, verdicts);
      worst = std::max(worst, measured.front().settings.front().error.median);
    }
  share_x(s.figure.panels);
  share_y(s.figure.panels);
  s.figure.columns = static_cast<int>(std::size(cushions));
  s.conclusion = conclude(verdicts, worst);
  s.caption = fmt::format(
      "Error against the truth and time per shot, as medians of {} shots with 10–90 % bands. Steps go from 0.1 s to "
      "{}. Tolerances go from 1e-3 to 1e-12. The table says how many times as long as ours each method takes to keep 1 "
      "µm. “>” means that it does not, in the longest time measured.",
      settings.shots, short_time(least_step));
  s.data = {{s.name, csv.settings}, {s.name + "-shots", csv.shots}};
  add_troubles(settings, s, progress);
  return s;
}

}  // namespace bankshot::app::report
