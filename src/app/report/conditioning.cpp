// SPDX-License-Identifier: MIT
//
// Section 4: digits that a path loses with each cushion, and digits that its condition κ says it may lose.
#include <fmt/format.h>

#include <cmath>

#include "app/report/sections.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/generate.hpp"
#include "bankshot/scene/ball.hpp"
#include "truth/condition.hpp"

namespace bankshot::app::report {
namespace {

constexpr int most_cushions = 20;
constexpr double radius = 0.028575;

struct Scene {
  std::string name;
  Table table;
  Physics physics;
  double low, high;  ///< launch speed [m/s]
};

/// Returns a rectangle whose bottom cushion is a row of pins, closer together than the ball is wide. The ball meets
/// only their tips, which scatter it.
Table with_pins() {
  constexpr double length = 2.54, width = 1.27, height = 0.04;
  constexpr int pins = 50;
  std::vector<Vec2d> vertices;
  for (int i = 0; i < pins; ++i) {
    vertices.push_back({length * i / pins, 0});
    vertices.push_back({length * (i + 0.5) / pins, height});
  }
  vertices.insert(vertices.end(), {{length, 0}, {length, width}, {0, width}});
  return polygon_table(vertices);
}

std::vector<Scene> scenes() {
  const Table plain = rectangle_table(2.54, 1.27);
  Physics lively = spin_physics();  // with hardly any loss the ball meets twenty cushions
  std::get<UsualCushion>(lively.cushion).restitution = Restitution{0.98};
  std::get<SlideRoll>(lively.motion).rolling_friction = 0.001;
  Physics mirrors = lively;
  mirrors.cushion = Mirror{0.98};
  return {{"rectangle, ideal", plain, ideal_physics(), 1, 1},
          {"rectangle, spin, mirror cushions", plain, mirrors, 6, 10},
          {"rectangle, " + spin_with(usual_cushion), plain, lively, 6, 10},
          {"rectangle with a row of pins, ideal", with_pins(), ideal_physics(), 1, 1}};
}

/// Digits lost, and digits that κ allows to be lost, after n cushions.
struct Losses {
  std::vector<double> lost[most_cushions + 1], allowed[most_cushions + 1];
  int parted[most_cushions + 1] = {};  ///< shots whose events differ from those of 50 digits
  int worst_ratio_cushions = 0;
  double worst_ratio = 0;
};

State<double> random_start(Random& draw, const Scene& scene, const Boundary& boundary) {
  for (;;) {
    const Vec2d at{draw.uniform(0, 2.54), draw.uniform(0, 1.27)};
    const LaunchSpin spin{is_ideal(scene.physics) ? 0 : draw.uniform(0, 1),
                          is_ideal(scene.physics) ? 0 : draw.uniform(-0.5, 0.5), 0};
    const Vec2d velocity = direction(draw.uniform(0, radians(360))) *
                           (scene.low == scene.high ? scene.low : draw.uniform(scene.low, scene.high));
    if (boundary.clearance(at) > 0) return launched(at, radius, velocity, spin);
  }
}

int cushions_met(const truth::Run& run) {
  int met = 0;
  for (const truth::TruthEvent& e : truth::run_double(run).events) met += e.kind == EventKind::cushion;
  return met;
}

/// Compares the place of the n-th bounce with 50 digits, for every n.
Losses measure(const Scene& scene, int shots, std::string& csv, Progress& progress) {
  const Boundary boundary(scene.table, {radius});
  Losses out;
  Random draw(4);
  for (int shot = 0; shot < shots; ++shot) {
    const State<double> start = random_start(draw, scene, boundary);
    const int met = cushions_met({boundary, scene.physics, start, most_cushions});
    for (int n = 1; n <= met; ++n) {
      const auto at = static_cast<std::size_t>(n);
      const truth::Compared c = truth::compare_with_truth({boundary, scene.physics, start, n});
      const double unit = 0x1p-53 * boundary.extent;
      if (c.order != truth::Compared::Order::same) {
        ++out.parted[at];
        continue;
      }
      out.lost[at].push_back(std::log10(std::max(c.error / unit, 1.0)));
      out.allowed[at].push_back(std::log10(tolerance::simulation_error * c.kappa));
      out.worst_ratio = std::max(out.worst_ratio, c.ratio() / tolerance::simulation_error);
      csv += fmt::format("\"{}\",{},{},{:.3g},{:.3g}\n", scene.name, shot, n, c.error, c.kappa);
    }
    progress.step();
  }
  return out;
}

/// Returns the first number of cushions after which the median of the digits exceeds `most`; 0 for none.
int too_many(const std::vector<double> (&digits)[most_cushions + 1], double most) {
  for (int n = 1; n <= most_cushions; ++n)
    if (!digits[n].empty() && spread(digits[n]).median > most) return n;
  return 0;
}

Panel panel(const Scene& scene, const Losses& l, double most) {
  Panel p{scene.name, {"cushions", false, Range{0, most_cushions + 1}}, {"digits lost", false}, {}};
  Curve lost{"lost against 50 digits", {}}, allowed{"allowed by κ", {}, Curve::Style::dashes};
  for (int n = 1; n <= most_cushions; ++n) {
    const Spread a = spread(l.lost[n]), b = spread(l.allowed[n]);
    if (l.lost[n].empty()) continue;
    lost.points.push_back({static_cast<double>(n), a.median, a.low, a.high});
    allowed.points.push_back({static_cast<double>(n), b.median, b.low, b.high});
  }
  p.curves = {lost,
              allowed,
              {"1e-9 of the diagonal needs the rest",
               {{0, most, most, most}, {most_cushions + 1.0, most, most, most}},
               Curve::Style::dashes}};
  return p;
}

constexpr const char* question = "How many cushions can a path meet before rounding spoils it?";
constexpr const char* about =
    "The place of the n-th bounce in double is compared with 50 digits. The bound 4 · 2⁻⁵³ · size · κ says how "
    "many digits may be lost. Between straight cushions κ grows like a power of the number of bounces. A ball "
    "meets a reflex vertex as an arc of its own radius, and each reflex vertex multiplies κ. An answer must be "
    "exact to 1e-9 of the diagonal, so about seven of the sixteen digits may be lost. Where the condition of a "
    "shot leaves fewer digits, the answer's message says how many.";

}  // namespace

Section conditioning(const Settings& settings, Progress& progress) {
  const std::vector<Scene> all = scenes();
  const int shots = 2 * settings.shots;
  progress.begin("conditioning", all.size() * static_cast<std::size_t>(shots));
  Section s{.name = "4-conditioning", .title = "Conditioning", .question = question, .about = about};
  s.table = {{"table and physics", "after 5", "10", "15", "20 cushions", "allowed after 20", "parted by 20",
              "worst of the bound", "too few digits from"},
             {}};
  std::string csv = "scene,shot,cushions,error_m,kappa\n",
              medians = "scene,cushions,shots,parted,lost_low_10,lost_median,lost_high_90,allowed_median\n", weak;
  double worst = 0;
  std::size_t weak_scenes = 0;
  for (const Scene& scene : all) {
    const Losses l = measure(scene, shots, csv, progress);
    const double unit = 0x1p-53 * Boundary(scene.table, {radius}).extent / scene.table.diagonal(),
                 most = std::log10(tolerance::exact_miss / unit);
    const int last = too_many(l.lost, most);
    for (int n = 1; n <= most_cushions; ++n) {
      const Spread lost = spread(l.lost[n]);
      medians += fmt::format("\"{}\",{},{},{},{:.3g},{:.3g},{:.3g},{:.3g}\n", scene.name, n, l.lost[n].size(),
                             l.parted[n], lost.low, lost.median, lost.high, spread(l.allowed[n]).median);
    }
    std::vector<std::string> row{scene.name};
    for (const std::size_t n : {5u, 10u, 15u, 20u})
      row.push_back(l.lost[n].empty() ? "–" : fmt::format("{:.1f}", spread(l.lost[n]).median));
    row.push_back(l.allowed[20].empty() ? "–" : fmt::format("{:.1f}", spread(l.allowed[20]).median));
    row.push_back(fmt::format("{} of {}", l.parted[20], shots));
    row.push_back(short_number(l.worst_ratio));
    row.push_back(last ? fmt::format("{} cushions", last) : "never");
    s.table.rows.push_back(row);
    s.figure.panels.push_back(panel(scene, l, most));
    worst = std::max(worst, l.worst_ratio);
    if (!last) continue;
    ++weak_scenes;
    weak += fmt::format(" In the scene “{}” they keep them only through {}.", scene.name, last - 1);
  }
  share_y(s.figure.panels);
  s.figure.columns = 2;
  s.caption = fmt::format(
      "Decimal digits lost, of the sixteen of a double, as medians of {} shots with 10–90 % bands. Parted shots have "
      "other events than in 50 digits, so there is no error to measure. A curve ends where no shot met more cushions.",
      shots);
  s.conclusion = fmt::format(
      "The largest rounding error is {:.0f} % of its bound. In {} of {} scenes half of the shots keep the nine digits "
      "of an exact answer through 20 cushions, or through as many as they meet.{}",
      100 * worst, all.size() - weak_scenes, all.size(), weak);
  s.data = {{s.name, medians}, {s.name + "-shots", csv}};
  return s;
}

}  // namespace bankshot::app::report
