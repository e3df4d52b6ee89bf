// SPDX-License-Identifier: MIT
//
// Section 5: scenes that are hard by construction, each class against its bound.
#include <fmt/format.h>

#include <cmath>

#include "app/report/sections.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/planner.hpp"
#include "truth/hard_cases.hpp"

namespace bankshot::app::report {
namespace {

struct Tally {
  std::string name;
  int cases = 0, ties = 0, beyond = 0;
  double error = 0, kappa = 1;
  std::vector<double> shares{};  ///< share of the bound that each case uses
  double worst() const { return shares.empty() ? 0 : *std::max_element(shares.begin(), shares.end()); }
};

Tally simulated(std::string_view name) {
  Tally t{.name = std::string(name)};
  for (const truth::HardCase& hard : truth::hard_cases(name)) {
    const truth::Compared c = truth::compare_with_truth(hard);
    ++t.cases;
    if (c.order == truth::Compared::Order::tie) {
      ++t.ties;
      continue;
    }
    t.error = std::max(t.error, c.error);
    t.kappa = std::max(t.kappa, c.kappa);
    t.shares.push_back(c.ratio() / tolerance::simulation_error);
    if (c.order == truth::Compared::Order::wrong || t.shares.back() > 1) ++t.beyond;
  }
  return t;
}

Tally planned(std::string_view name) {
  Tally t{.name = std::string(name)};
  for (const Puzzle& p : truth::hard_puzzles(name)) {
    const Answer a = bankshot::solve(p, {.robustness = false, .suggest = false});
    ++t.cases;
    if (a.shots.empty()) {
      ++t.beyond;
      continue;
    }
    const Shot& shot = a.shots.front();
    t.error = std::max(t.error, shot.verification.miss);
    t.kappa = std::max(t.kappa, shot.verification.condition / p.table.diagonal());
    t.shares.push_back(shot.verification.miss / (tolerance::exact_miss * p.table.diagonal()));
    if (t.shares.back() > 1) ++t.beyond;
  }
  return t;
}

Curve as_points(const std::string& name, const std::vector<Tally>& all, std::size_t first, bool worst) {
  constexpr double invisible = 1e-9;  // of the bound: an error of 0 is drawn here
  Curve c{name, {}, Curve::Style::points};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double middle = std::max(invisible, spread(all[i].shares).median), most = std::max(invisible, all[i].worst());
    const double row = -static_cast<double>(first + i);
    c.points.push_back(worst ? Point{most, row, row, row} : Point{middle, row, row, row});
  }
  return c;
}

constexpr const char* question = "Do the error bounds hold in scenes that are built to break them?";
constexpr const char* about =
    "Each scene of tests/hard aims at one way in which numbers break. A simulated shot is compared with 50 "
    "digits. Its error must keep the bound 4 · 2⁻⁵³ · size · κ, where the dual numbers of the run itself measure "
    "κ. An integrated impact puts its tolerance in place of 2⁻⁵³. The replay of a puzzle's answer must miss by at "
    "most 1e-9 of the table's diagonal. A tie is a pair of events closer to each other than the bound. Either "
    "order is then right, and the paths may part.";

}  // namespace

Section hard_cases(const Settings&, Progress& progress) {
  const auto classes = truth::hard_classes(), puzzles = truth::hard_puzzle_classes();
  progress.begin("hard cases", classes.size() + puzzles.size());
  Section s{.name = "5-hard-cases", .title = "Hard cases", .question = question, .about = about};
  std::vector<Tally> all;
  for (const auto name : classes) all.push_back(simulated(name)), progress.step();
  for (const auto name : puzzles) all.push_back(planned(name)), progress.step();

  s.table = {{"class", "cases", "ties", "beyond the bound", "worst error", "κ up to", "of the bound, median", "worst"},
             {}};
  std::string csv = "class,kind,cases,ties,beyond,worst_error_m,kappa,median_of_bound,worst_of_bound\n";
  Panel p{"share of the bound that is used", {"error / bound", true}, {"", false}, {}};
  int cases = 0, ties = 0, beyond = 0;
  const Tally* worst = &all.front();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Tally& t = all[i];
    const double median = spread(t.shares).median;
    s.table.rows.push_back({t.name, fmt::format("{}", t.cases), fmt::format("{}", t.ties), fmt::format("{}", t.beyond),
                            short_length(t.error), short_number(t.kappa), short_number(median),
                            short_number(t.worst())});
    csv += fmt::format("{},{},{},{},{},{:.3g},{:.3g},{:.3g},{:.3g}\n", t.name, i < classes.size() ? "shots" : "puzzles",
                       t.cases, t.ties, t.beyond, t.error, t.kappa, median, t.worst());
    p.y.names.push_back(t.name);
    cases += t.cases;
    ties += t.ties;
    beyond += t.beyond;
    if (t.worst() > worst->worst()) worst = &t;
  }
  p.curves = {as_points("worst of the class", all, 0, true), as_points("median", all, 0, false)};
  const double rows = static_cast<double>(all.size());
  p.y.range = Range{-rows + 0.4, 0.6};
  p.curves.push_back({"the bound", {{1, -rows + 0.4, 0, 0}, {1, 0.6, 0, 0}}, Curve::Style::dashes});
  for (Point& point : p.curves.back().points) point.low = point.high = point.y;
  s.figure.panels.push_back(p);
  s.figure.row_height = 430;
  s.figure.left = 190;
  s.caption = "Largest and median error of each class over its bound. An error of exactly 0 is drawn at 1e-9.";
  s.conclusion =
      beyond == 0
          ? fmt::format(
                "All {} hard cases keep their bound, {} of them at ties. The closest, in the class “{}”, comes to "
                "{:.0f} % of it.",
                cases, ties, worst->name, 100 * worst->worst())
          : fmt::format(
                "{} of {} hard cases break their bound. The worst, in the class “{}”, is {:.2g} times the bound.",
                beyond, cases, worst->name, worst->worst());
  s.data.push_back({s.name, csv});
  return s;
}

}  // namespace bankshot::app::report
