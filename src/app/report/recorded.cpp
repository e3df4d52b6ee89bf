// SPDX-License-Identifier: MIT
//
// Section 8: which law of the cushions explains recorded shots, and predicts shots left out of the fit.
#include <fmt/format.h>

#include <algorithm>

#include "app/option_checks.hpp"
#include "app/report/sections.hpp"
#include "bankshot/learn/fit.hpp"

namespace bankshot::app::report {
namespace {

constexpr int many_cushions = 3;
constexpr double mm = 1000;

using BySpeed = FitWish::BySpeed;

struct Law {
  std::string name, cushion;
  BySpeed by_speed;  ///< how restitution and rolling friction depend on the speed
};

/// Returns the laws to try; with `quick`, those that do not depend on the speed.
std::vector<Law> laws_to_try(bool quick) {
  std::vector<Law> out;
  for (const CushionModel& model : cushion_registry)
    if (model.in_files && !model.integrated)
      out.push_back({std::string(model.key), std::string(model.key), BySpeed::constant});
  for (const CushionModel& model : cushion_registry)
    if (model.tried_by_fit && !quick)
      out.push_back({std::string(model.key) + ", by speed", std::string(model.key), BySpeed::linear});
  return out;
}

struct Result {
  const Law* law;
  Fit fit;

  double predicted() const { return median_rms(fit.predictions); }
};

/// Returns the models whose impacts are integrated.
std::string integrated_models() {
  std::string out;
  for (const CushionModel& model : cushion_registry)
    if (model.integrated) out += (out.empty() ? "" : " and ") + std::string(model.key);
  return out;
}

constexpr std::size_t percent = 100;

Result measure(const Law& law, std::span<const Recording> recordings, int holdout, Progress& progress) {
  std::size_t shown = 0;
  FitWish wish{.model = law.cushion, .threads = threads_for(0)};
  wish.restitution = wish.rolling = law.by_speed;
  wish.holdout = holdout;
  wish.progress = [&](double share) {
    for (; shown < static_cast<std::size_t>(share * percent); ++shown) progress.step();
  };
  return {&law, bankshot::fit(recordings, wish)};
}

template <class Measured>
Curve share_within(const std::string& name, const std::vector<Measured>& all) {
  std::vector<double> rms;
  for (const Measured& m : all)
    if (m.samples > 0) rms.push_back(mm * m.rms);
  std::ranges::sort(rms);
  Curve curve{name, {}};
  for (std::size_t i = 0; i < rms.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(rms.size());
    curve.points.push_back({rms[i], share, share, share});
  }
  return curve;
}

/// Counts the shots whose prediction is off by more than three times the median, and names the worst.
std::string failures(const Result& best) {
  constexpr double far = 3;
  const Prediction* worst = nullptr;
  int others = 0;
  for (const Prediction& p : best.fit.predictions) {
    if (p.samples == 0 || p.rms <= far * best.predicted()) continue;
    ++others;
    if (!worst || p.rms > worst->rms) worst = &p;
  }
  return worst ? fmt::format(" It is more than three times as far off on {} of them. The worst is {} ({}).", others,
                             worst->id.empty() ? "one without a name" : worst->id, short_length(worst->rms))
               : " It predicts none worse than three times that.";
}

std::string conclusion(const std::vector<Result>& results) {
  const auto had = [](const Prediction& p) { return p.samples > 0; };
  const Result& best = *std::ranges::min_element(results, {}, &Result::predicted);
  const auto predicted = std::ranges::count_if(best.fit.predictions, had);
  if (predicted == 0) return "No shot goes on after its first part, so no law could be tried by prediction.";
  return fmt::format(
      "The cushion law {} explains these shots best. It follows half of all shots within {}. Of {} shots that go on "
      "after their first part, it predicts half within {} from what other shots taught.{}",
      best.law->name, short_length(median_rms(best.fit.shots)), predicted, short_length(best.predicted()),
      failures(best));
}

constexpr const char* question = "Which cushion law explains shots on a real table?";
constexpr const char* about =
    "A camera tracked these shots. For each cushion law the table's coefficients and all launches are fitted to "
    "all shots. Then a quarter of the shots is left out at a time, and the coefficients are fitted to the others. "
    "Each shot left out is predicted from its first part, which ends 0.25 s after its first bounce. Distances are "
    "root mean squares over a shot's samples at the same time. Laws whose impacts are integrated ({}) take about ten "
    "times as long and are not tried. By speed: restitution and rolling friction may "
    "change with the speed. The time is that of learning from all shots, by wall clock, with as many threads as "
    "there are cores.";

}  // namespace

Section recorded(std::span<const Recording> recordings, const Settings& settings, Progress& progress) {
  constexpr std::size_t groups = 4;
  const int holdout = static_cast<int>(std::max<std::size_t>(1, recordings.size() / groups));
  const std::vector<Law> tried = laws_to_try(settings.quick);
  progress.begin("recorded shots", percent * tried.size());
  std::vector<Result> results;
  for (const Law& law : tried) results.push_back(measure(law, recordings, holdout, progress));

  Section s{.name = "8-recorded",
            .title = "Models against real shots",
            .question = question,
            .about = fmt::format(about, integrated_models())};
  const std::string long_ones = fmt::format("{} and more cushions", many_cushions);
  s.table = {{"cushions", "followed, median", long_ones, "predicted, median", "sigma", "time of a fit"}, {}, 1};
  std::string csv = "model,shots,rms_median_mm,rms_many_mm,predictions,predicted_median_mm,sigma_mm,seconds\n";
  std::string each = "model,shot,cushions,rms_mm,predicted_mm\n";
  Panel predicted{"left out and predicted", {"distance [mm]", true}, {"share of the shots", false, Range{0, 1}}, {}};
  Panel followed{"followed", {"distance [mm]", true}, {"share of the shots", false, Range{0, 1}}, {}};
  for (const Result& r : results) {
    const Fit& fit = r.fit;
    const double all = median_rms(fit.shots), many = median_rms(fit.shots, many_cushions);
    const bool has_many = std::ranges::any_of(fit.shots, [](const auto& f) { return f.cushions >= many_cushions; });
    const auto predictions = std::ranges::count_if(fit.predictions, [](const Prediction& p) { return p.samples > 0; });
    s.table.rows.push_back({r.law->name, short_length(all), has_many ? short_length(many) : "",
                            predictions > 0 ? short_length(r.predicted()) : "", short_length(fit.sigma),
                            short_time(fit.seconds)});
    csv += fmt::format("\"{}\",{},{:.4g},{:.4g},{},{:.4g},{:.4g},{:.3g}\n", r.law->name, fit.shots.size(), mm * all,
                       mm * many, predictions, mm * r.predicted(), mm * fit.sigma, fit.seconds);
    for (std::size_t i = 0; i < fit.shots.size(); ++i) {
      const Prediction p = i < fit.predictions.size() ? fit.predictions[i] : Prediction{};
      each += fmt::format("\"{}\",{},{},{:.4g},{}\n", r.law->name, i + 1, fit.shots[i].cushions, mm * fit.shots[i].rms,
                          p.samples > 0 ? fmt::format("{:.4g}", mm * p.rms) : "");
    }
    predicted.curves.push_back(share_within(r.law->name, fit.predictions));
    followed.curves.push_back(share_within(r.law->name, fit.shots));
  }
  s.figure.panels = {predicted, followed};
  s.figure.columns = 2;
  s.caption = fmt::format("The share of {} shots that is off by no more than that.", recordings.size());
  s.conclusion = conclusion(results);
  s.data = {{s.name, csv}, {s.name + "-shots", each}};
  return s;
}

}  // namespace bankshot::app::report
