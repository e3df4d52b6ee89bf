// SPDX-License-Identifier: MIT
//
// Measures how often the known noise and bias of players lie within the intervals that `advise` gives, on a known
// table.
#include "bankshot/learn/advise.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <map>

#include "bankshot/scene/scene.hpp"
#include "support/attempts.hpp"

int main(int argc, char** argv) {
  using namespace bankshot;
  CLI::App app("players whose noise is known");
  int repeats = 20, threads = 1;
  std::uint64_t seed = 1;
  test::AttemptWish wish;
  double least = 0.89, most = 0.99;
  bool csv = false;
  app.add_option("--repeats", repeats, "Players")->capture_default_str();
  app.add_option("--attempts", wish.attempts, "Of each")->capture_default_str();
  app.add_option("--seed", seed)->capture_default_str();
  app.add_option("--threads", threads)->capture_default_str();
  app.add_flag("--rests", wish.rests_only, "Only where the ball came to rest is seen");
  app.add_flag("--made", wish.made_only, "Only whether it was made is seen");
  app.add_option("--least", least, "Share of intervals of 95 % that must hold the truth, of each number")
      ->capture_default_str();
  app.add_option("--most", most, "The same, at most")->capture_default_str();
  app.add_flag("--csv", csv, "A row for each number in the text's place");
  CLI11_PARSE(app, argc, argv);

  struct Count {
    int told = 0, covered = 0;
    double off = 0;
  };
  std::map<std::string, Count> counts;
  double seconds = 0;
  for (int i = 0; i < repeats; ++i) {
    Random random(seed, static_cast<std::uint64_t>(i));
    test::Player player = test::random_player(random);
    if (wish.made_only) {  // errors of spin and biases are not identifiable then
      player.habits["side"] = player.habits["top"] = {0, 0};
      player.habits["angle"].bias = player.habits["speed"].bias = 0;
    }
    const auto attempts = test::attempts_of(player, wish, random);
    const auto before = std::chrono::steady_clock::now();
    const Advice advice = bankshot::advise(attempts, {.threads = threads});
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
    for (const PlayerError& e : advice.errors) {
      const auto count = [&](const std::string& name, double truth, double value, const Range& interval) {
        Count& c = counts[name];
        const bool covered = truth >= interval.low && truth <= interval.high;
        ++c.told, c.covered += covered, c.off += (value - truth) / (interval.high - interval.low);
      };
      const test::Habit& truth = player.habits.at(e.name);
      count(e.name, truth.sigma, e.sigma, e.sigma_interval);
      if (e.bias_is_told) count(e.name + " bias", truth.bias, e.bias, e.bias_interval);
    }
  }
  bool good = true;
  Count all;
  if (csv) fmt::print("repeats,attempts,number,told,covered,mean_off,seconds\n");
  const auto print = [&](const std::string& name, const Count& c) {
    const double share = c.told > 0 ? static_cast<double>(c.covered) / c.told : 1;
    if (csv)
      fmt::print("{},{},{},{},{},{:.3f},{:.2f}\n", repeats, wish.attempts, name, c.told, c.covered, c.off / c.told,
                 seconds / repeats);
    else
      fmt::print(
          "{:<12} in {} of {} intervals of 95 %: {:.1f} %; above the truth by {:.3f} of the interval on average\n",
          name, c.covered, c.told, 100 * share, c.off / c.told);
    return share;
  };
  for (const auto& [name, c] : counts) {
    const double share = print(name, c);
    good = good && share >= least && share <= most;
    all.told += c.told, all.covered += c.covered, all.off += c.off;
  }
  print("all", all);
  if (!csv) fmt::print("{:.2f} s for {} attempts on {} threads\n", seconds / repeats, wish.attempts, threads);
  return good ? 0 : 1;
}
