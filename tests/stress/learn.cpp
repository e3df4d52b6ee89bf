// SPDX-License-Identifier: MIT
//
// Fits tables whose truth is known, and counts how often the truth lies within the errors that `fit` states.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>

#include "bankshot/learn/fit.hpp"
#include "bankshot/scene/scene.hpp"
#include "support/filmed.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  CLI::App app("fits tables whose truth is known");
  int repeats = 10, from = 0, threads = 1;
  std::uint64_t seed = 1;
  test::FilmWish wish;
  double least = 0.89, most = 0.99;
  bool csv = false, untold = false, each = false;
  long named = 0;
  app.add_option("--repeats", repeats, "Tables")->capture_default_str();
  app.add_option("--from", from, "The first one's number, to look at one again")->capture_default_str();
  app.add_option("--shots", wish.shots, "Recordings of each")->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--noise", wish.camera.noise, "m")->capture_default_str();
  app.add_option("--outliers", wish.camera.outliers, "Share")->capture_default_str();
  app.add_option("--threads", threads)->capture_default_str();
  app.add_option("--least", least, "Share of intervals of 95 % that must hold the truth, of each coefficient")
      ->capture_default_str();
  app.add_option("--most", most, "The same, at most")->capture_default_str();
  app.add_flag("--untold", untold, "Shots that meet no cushion: 95 % of what they cannot tell must be held and named");
  app.add_flag("--csv", csv, "A row for each coefficient in the text's place");
  app.add_flag("--each", each, "Tell each table on standard error: by how many of its errors each coefficient is off");
  CLI11_PARSE(app, argc, argv);
  wish.bounces = !untold;

  struct Count {
    int told = 0, covered = 0, held = 0;
    double squares = 0;
  };
  std::map<std::string, Count> counts;
  double seconds = 0, slowest = 0;
  long simulations = 0;
  constexpr double normal95 = 1.959964;
  for (int i = from; i < from + repeats; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    const Physics truth = test::random_table(random, preset_scene("carom-10ft").ball.body);
    const test::Filmed filmed = test::filmed(truth, wish, random);
    const auto before = std::chrono::steady_clock::now();
    const Fit fit = bankshot::fit(filmed.recordings, {.threads = threads});
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    seconds += took, slowest = std::max(slowest, took), simulations += fit.simulations;
    std::string line = fmt::format("{} {:.1f} s, {} simulations:", i, took, fit.simulations);
    for (const FittedCoefficient& p : fit.parameters) {
      Count& c = counts[p.name];
      const double off = (p.value - test::coefficient(truth, p.name)) / p.error;
      ++c.told, c.covered += std::abs(off) < normal95, c.squares += off * off;
      line += fmt::format(" {} {:.2f}", p.name, off);
      constexpr double far = 6;
      if (!(std::abs(off) < far))
        std::cerr << fmt::format("FAILED repeat {} of seed {}: {} is {} with error {}, truth {}\n", i, seed, p.name,
                                 p.value, p.error, test::coefficient(truth, p.name));
    }
    for (const HeldCoefficient& h : fit.held) ++counts[h.name].held;
    if (each) std::cerr << line << '\n';
    for (const char* name : test::told_by_bounces)
      named += std::ranges::find(fit.held, name, &HeldCoefficient::name) != fit.held.end();
  }
  bool good = true;
  Count all;
  if (csv)
    fmt::print("from,repeats,shots,noise_mm,outliers,coefficient,told,covered,rms_errors,held,seconds,slowest\n");
  const auto print = [&](const std::string& name, const Count& c) {
    constexpr double mm = 1000;
    const double share = c.told > 0 ? static_cast<double>(c.covered) / c.told : 1;
    const double rms = std::sqrt(c.squares / std::max(1, c.told));
    if (csv)
      fmt::print("{},{},{},{:g},{:g},{},{},{},{:.3f},{},{:.2f},{:.2f}\n", from, repeats, wish.shots,
                 mm * wish.camera.noise, wish.camera.outliers, name, c.told, c.covered, rms, c.held, seconds / repeats,
                 slowest);
    else
      fmt::print("{:<22} in {} of {} intervals of 95 %: {:.1f} %; root mean square {:.2f} errors; held {}\n", name,
                 c.covered, c.told, 100 * share, rms, c.held);
    return share;
  };
  for (const auto& [name, c] : counts) {
    const double share = print(name, c);
    good = good && share >= least && share <= most;
    all.told += c.told, all.covered += c.covered, all.held += c.held, all.squares += c.squares;
  }
  print("all", all);
  if (!csv)
    fmt::print("{:.2f} s a fit, {:.2f} the slowest, on {} threads; {} simulations a fit\n", seconds / repeats, slowest,
               threads, simulations / repeats);
  if (untold) {
    const long all_named = repeats * static_cast<long>(std::size(test::told_by_bounces));
    if (!csv) fmt::print("{} of {} that these shots cannot tell were held and named\n", named, all_named);
    constexpr double most_of_them = 0.95;
    good = static_cast<double>(named) >= most_of_them * static_cast<double>(all_named);
  }
  return good ? 0 : 1;
}
