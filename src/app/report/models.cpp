// SPDX-License-Identifier: MIT
//
// Section 2: cost of each level of physics, and how far its answers miss when the fullest one is the truth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/circles.hpp"
#include "app/report/compared.hpp"
#include "app/report/sections.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/plan/planner.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot::app::report {
namespace {

constexpr int most_cushions = 5;
constexpr int puzzles_a_shot = 25;  // puzzles with pockets for each shot of a point

struct Model {
  std::string name;
  Physics physics;
};

/// Returns the models, cheapest first; the last is the reference.
std::vector<Model> models_in_order() {
  std::vector<Model> out{{"ideal", ideal_physics()}, {"rolling", rolling_physics()}};
  const auto add = [&](std::size_t i) {
    out.push_back({spin_with(cushion_registry[i]), spin_physics()});
    out.back().physics.cushion = default_cushion(i);
  };
  const std::size_t reference = *find_cushion_model(fullest_cushion.key);
  for (std::size_t i = 0; i < cushion_registry.size(); ++i)
    if (cushion_registry[i].in_files && i != reference) add(i);
  add(reference);
  return out;
}

/// A ball that rolls and comes to rest after exactly n cushions in the fullest model.
struct SearchRequest {
  ShotRequest shot;
  Vec2d rest;
  std::vector<Contact> met;
};

SearchRequest draw_question(Random& draw, const Physics& fullest, int cushions) {
  const double R = comparison_table().body.radius;
  for (;;) {
    ShotRequest shot{.table = rectangle_table(2.54, 1.27), .physics = fullest};
    shot.ball.at = {draw.uniform(R, 2.54 - R), draw.uniform(R, 1.27 - R)};
    shot.launch = {draw.log_uniform(0.5, 5), draw.uniform(0, radians(360))};
    shot.spin = {1, 0, 0};
    const Trajectory t = bankshot::simulate(shot);
    if (t.cushions == cushions) return {shot, t.events.back().state.at, t.sequence()};
  }
}

Puzzle puzzle_of(const SearchRequest& q, const Physics& physics) {
  Puzzle p{.table = q.shot.table,
           .physics = physics,
           .ball = q.shot.ball,
           .target = PointTarget{q.rest},
           .cushions = CushionRule::in_order(q.met),
           .speed = {0.1, 10}};
  p.prefer = Prefer::soft;
  if (is_ideal(physics))
    // This model knows no friction, so it is given the right speed.
    p.speed = {q.shot.launch.speed, q.shot.launch.speed};
  else
    p.arrive = Range{0, 0};
  if (carries_spin(physics)) p.spin = q.shot.spin;
  return p;
}

/// Returns the seconds it takes to simulate the shot in a model, to its rest or its last cushion.
double cost(const SearchRequest& q, const Physics& physics) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) {
    const State<double> start = start_state(q.shot);
    const int last = static_cast<int>(q.met.size());
    return seconds_of([&] {
      Simulator sim(comparison_table(), motion, cushion, start);
      for (int met = 0; met < last;) {
        const Event e = sim.step();
        if (e.final()) break;
        if (e.kind == EventKind::cushion) ++met;
      }
    });
  });
}

struct Result {
  Spread miss, seconds, solve_seconds;
  int solved = 0;
};

Result measure(const Model& m, const std::vector<SearchRequest>& questions, int cushions, std::string& csv) {
  std::vector<double> misses, seconds, solving;
  int solved = 0;
  for (const SearchRequest& q : questions) {
    const Answer a = bankshot::solve(puzzle_of(q, m.physics), {.robustness = false, .suggest = false});
    seconds.push_back(cost(q, m.physics));
    double miss = forever;
    if (!a.shots.empty()) {
      ShotRequest played = q.shot;
      played.launch = a.shots.front().launch;
      miss = norm(bankshot::simulate(played).events.back().state.at - q.rest);
      ++solved;
      misses.push_back(miss);
      solving.push_back(a.time_us * 1e-6);
    }
    csv += fmt::format("\"{}\",{},{:.4g},{:.4g},{:.4g}\n", m.name, cushions, miss, seconds.back(), a.time_us * 1e-6);
  }
  return {spread(misses), spread(seconds), spread(solving), solved};
}

/// Returns how much less steeply a rolling ball leaves a cushion than it came, over the angle of incidence in fine
/// steps. `told` gets the largest change from one angle to the next, in words.
Panel steepness(const std::vector<Model>& all, std::string& csv, std::string& told) {
  constexpr double step = 0.1, from = 0.5, to = 89.5, speed = 2;  // degrees, m/s
  Panel panel{"leaving less steeply than coming, every 0.1°", {"angle to the cushion [°]"}, {"angle lost [°]"}, {}};
  double jump = 0;
  csv = "model,incidence_deg,leaving_deg\n";
  for (const Model& m : all) {
    if (!carries_spin(m.physics)) continue;
    Curve curve{m.name, {}, Curve::Style::dashes};
    for (double a = from; a <= to; a += step) {
      State<double> s{{0, 0}, {speed * std::cos(radians(a)), -speed * std::sin(radians(a))}};
      s.spin = natural_roll(s.velocity, Body{}.radius);
      std::visit([&](const auto& cushion) { cushion.bounce(Body{}, s, Vec2d{0, 1}); }, m.physics.cushion);
      const double leaves = degrees(std::atan2(s.velocity.y, s.velocity.x));
      const double lost = a - leaves;
      if (!curve.points.empty()) jump = std::max(jump, std::abs(lost - curve.points.back().y));
      curve.points.push_back({a, lost, lost, lost});
      csv += fmt::format("\"{}\",{:.1f},{:.6f}\n", m.name, a, leaves);
    }
    panel.curves.push_back(curve);
  }
  told = fmt::format(
      " No cushion law jumps: from one tenth of a degree of incidence to the next, the angle lost changes by at most "
      "{:.2g}°.",
      jump);
  return panel;
}

/// Compares the simpler models, all but the last, with the fullest one. The first, `ideal`, is given the right speed.
std::string in_words(const std::vector<Model>& all, const std::vector<Result>& results) {
  const auto simpler_end = results.end() - 1;
  const auto miss = [](const Result& r) { return r.miss.median; };
  const auto cost = [](const Result& r) { return r.seconds.median; };
  const auto [nearest, farthest] = std::ranges::minmax_element(results.begin() + 1, simpler_end, {}, miss);
  const auto [cheapest, dearest] = std::ranges::minmax_element(results.begin(), simpler_end, {}, cost);
  const auto name = [&](auto result) { return all[static_cast<std::size_t>(result - results.begin())].name; };
  return fmt::format(
      "A shot planned with a simpler model misses in the fullest one. After three cushions the nearest that chooses "
      "its "
      "own speed ({}) misses by {} in the median, and the farthest ({}) by {}. A simulated shot costs {} to {} in the "
      "simpler models and {} in "
      "the fullest.",
      name(nearest), short_length(nearest->miss.median), name(farthest), short_length(farthest->miss.median),
      short_time(cheapest->seconds.median), short_time(dearest->seconds.median),
      short_time(results.back().seconds.median));
}

constexpr const char* question =
    "How simple may the physics be, and by how much does a shot planned with a simpler model miss?";
constexpr const char* about =
    "Random shots of a rolling ball rest after 1 to 5 cushions in the fullest model, which is spin with {}. Each "
    "simpler model is asked for the launch to the same place by the same cushions. Its answer "
    "is played in the fullest model; the miss is how far from that place the ball rests. The model ideal knows no "
    "friction and is given the right speed. All cushions have a restitution of 0.85. No model has air. At 5 m/s "
    "the drag of air is about 0.10 m/s², as much as rolling friction. The Magnus force is then about 0.07 m/s², "
    "which moves a ball by 8 mm over 2.5 m. Below 2 m/s both are negligible.";

}  // namespace

Section models(const Settings& settings, Progress& progress) {
  const std::vector<Model> all = models_in_order();
  progress.begin("models", all.size() * most_cushions + circle_steps);
  Section s{
      .name = "2-models", .title = "Models", .question = question, .about = fmt::format(about, fullest_cushion.key)};
  s.table = {
      {"model", "cushions", "time per shot", "time per answer", "answered", "miss, 10 %", "median", "90 %"}, {}, 2};
  std::string csv = "model,cushions,miss_m,seconds_a_shot,seconds_an_answer\n";
  std::string medians =
      "model,cushions,shots,answered,miss_low_10,miss_median,miss_high_90,seconds_a_shot,seconds_an_answer\n";
  Panel by_cushions{"miss when played in the fullest model",
                    {"cushions", false, Range{0.5, most_cushions + 0.5}},
                    {"miss [m]", true},
                    {}};
  Panel by_cost{"the same against what a shot costs, 1 to 5 cushions",
                {"processor time per shot [s]", true},
                {"miss [m]", true},
                {}};
  std::vector<std::vector<SearchRequest>> questions;
  Random draw(2);
  for (int n = 1; n <= most_cushions; ++n) {
    questions.emplace_back();
    for (int i = 0; i < settings.shots; ++i) questions.back().push_back(draw_question(draw, all.back().physics, n));
  }
  std::vector<Result> at_three;
  for (const Model& m : all) {
    Curve misses{m.name, {}}, costs{m.name, {}};
    for (int n = 1; n <= most_cushions; ++n) {
      const Result r = measure(m, questions[static_cast<std::size_t>(n - 1)], n, csv);
      s.table.rows.push_back({m.name, fmt::format("{}", n), short_time(r.seconds.median),
                              short_time(r.solve_seconds.median), fmt::format("{} of {}", r.solved, settings.shots),
                              short_length(r.miss.low), short_length(r.miss.median), short_length(r.miss.high)});
      medians +=
          fmt::format("\"{}\",{},{},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g}\n", m.name, n, settings.shots, r.solved,
                      r.miss.low, r.miss.median, r.miss.high, r.seconds.median, r.solve_seconds.median);
      if (n == 3) at_three.push_back(r);
      misses.points.push_back({static_cast<double>(n), r.miss.median, r.miss.low, r.miss.high});
      costs.points.push_back({r.seconds.median, r.miss.median, r.miss.median, r.miss.median});
      progress.step();
    }
    if (&m == &all.back()) continue;  // it misses only by rounding
    by_cushions.curves.push_back(misses);
    by_cost.curves.push_back(costs);
  }
  s.figure.panels = {by_cushions, by_cost};
  share_y(s.figure.panels);
  const CirclesForJaws circles = circles_for_jaws(settings.shots * puzzles_a_shot, progress);
  s.figure.panels.push_back(circles.panel);
  std::string sweep, smooth;
  s.figure.panels.push_back(steepness(all, sweep, smooth));
  s.figure.columns = 2;
  s.figure.row_height = 300;
  s.caption = fmt::format("Medians of {} shots per point, with 10–90 % bands on the left.", settings.shots);
  s.conclusion = in_words(all, at_three) + circles.told + smooth;
  s.data = {
      {s.name, medians}, {s.name + "-shots", csv}, {s.name + "-circles", circles.csv}, {s.name + "-incidence", sweep}};
  return s;
}

}  // namespace bankshot::app::report
