// SPDX-License-Identifier: MIT
#include "app/report/derivatives.hpp"

#include <fmt/format.h>

#include "app/report/one_root.hpp"
#include "app/report/suite.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::app::report {
namespace {

constexpr double floor_of_figure = 1e-17;  // m: a miss of 0 is drawn here

struct Way {
  const char* name;
  Derivatives derivatives;
};
constexpr Way ways[] = {
    {"Newton, dual numbers", Derivatives::dual},
    {"Newton, forward differences", Derivatives::forward},
    {"Newton, central differences", Derivatives::central},
#if BANKSHOT_NLOPT
    {"BOBYQA, no derivatives", Derivatives::none},
#endif
};

/// Medians over the puzzles after each step: simulations, time and the least miss so far. A run that has ended keeps
/// its last values.
struct Approach {
  const char* name;
  std::vector<double> simulations, seconds;
  std::vector<Spread> miss;
};

Approach measure(const Way& way, const std::vector<Puzzle>& puzzles, std::string& csv) {
  std::vector<std::vector<Iterate>> runs;
  for (const Puzzle& p : puzzles) {
    auto run = approach(p, way.derivatives, cpu_seconds);
    const auto again = approach(p, way.derivatives, cpu_seconds);
    for (std::size_t i = 0; i < std::min(run.size(), again.size()); ++i)
      run[i].seconds = std::min(run[i].seconds, again[i].seconds);
    if (!run.empty()) runs.push_back(std::move(run));
  }
  Approach out{way.name, {}, {}, {}};
  std::size_t longest = 0;
  for (const auto& run : runs) longest = std::max(longest, run.size());
  for (std::size_t k = 0; k < longest; ++k) {
    std::vector<double> miss, simulations, seconds;
    for (const auto& run : runs) {
      const Iterate& it = run[std::min(k, run.size() - 1)];
      miss.push_back(std::max(it.miss, floor_of_figure));
      simulations.push_back(static_cast<double>(it.simulations));
      seconds.push_back(it.seconds);
    }
    out.miss.push_back(spread(miss));
    out.simulations.push_back(spread(simulations).median);
    out.seconds.push_back(spread(seconds).median);
    csv += fmt::format("\"{}\",{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g}\n", way.name, runs.size(), k,
                       out.simulations.back(), out.seconds.back(), out.miss.back().low, out.miss.back().median,
                       out.miss.back().high);
  }
  return out;
}

/// Returns the entry of `of` at the first step whose median miss is below `exact` [m]; null if there is none.
const double* first_exact(const Approach& a, const std::vector<double>& of, double exact) {
  for (std::size_t k = 0; k < a.miss.size(); ++k)
    if (a.miss[k].median < exact) return &of[k];
  return nullptr;
}

}  // namespace

std::string add_derivatives(const Settings& settings, Section& s, Progress& progress) {
  std::vector<Puzzle> puzzles;
  for (const Level level : levels)
    for (const Puzzle& p : suite(spin_physics(), level, 4 * settings.shots))
      if (p.cushions.sequence) puzzles.push_back(p);
  std::string csv = "method,puzzles,step,simulations,seconds,miss_low_10,miss_median,miss_high_90\n", text;
  const std::string title = "one root, " + spin_with(usual_cushion);
  Panel time{title, {"processor time [s]", true}, {"miss [m]", true}, {}},
      simulations{title, {"simulations", true}, {"miss [m]", true}, {}};
  for (const Way& way : ways) {
    const Approach a = measure(way, puzzles, csv);
    Curve by_time{way.name, {}}, by_simulations{way.name, {}};
    for (std::size_t k = 0; k < a.miss.size(); ++k) {
      by_time.points.push_back({a.seconds[k], a.miss[k].median, a.miss[k].low, a.miss[k].high});
      by_simulations.points.push_back({a.simulations[k], a.miss[k].median, a.miss[k].low, a.miss[k].high});
    }
    time.curves.push_back(by_time);
    simulations.curves.push_back(by_simulations);
    const double exact = tolerance::exact_miss * puzzles.front().table.diagonal();
    const double *n = first_exact(a, a.simulations, exact), *t = first_exact(a, a.seconds, exact);
    text += n ? fmt::format(" “{}” needs {} simulations ({}) in the median.", way.name, *n, short_time(*t))
              : fmt::format(" “{}” finds no exact root in the median.", way.name);
    progress.step();
  }
  Panel legend;
  for (const Way& way : ways) legend.legend.emplace_back(way.name);
  s.figure.panels.insert(s.figure.panels.end(), {time, simulations, legend});
  s.data.push_back({s.name + "-derivatives", csv});
  return text;
}

}  // namespace bankshot::app::report
