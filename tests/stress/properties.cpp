// SPDX-License-Identifier: MIT
//
// Checks properties that answers must always have (listed in support/properties.hpp) on random puzzles as wide as the
// format. Each counterexample is made smaller and printed as a line of JSON with puzzles for `bankshot solve`.
//   properties --count 100 --seed 1 [--property a,b] [--max-balls 3] [--leaves] [--csv FILE] [-j 2] [--allow a=0.2,c=1]
// Exit 1 if more than the allowed percentage of the judged cases of a property fails.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

#include "support/properties.hpp"
#include "support/seed.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

struct Options {
  int count = 40, first = 0, threads = 1, shrink = 40, max_balls = 15;
  std::uint64_t seed = 1;
  double slow = 60;  // s
  bool quick = false, list = false, leaves = false;
};

struct Tally {
  int scenes = 0, judged = 0, failed = 0;
  double worst = 0, seconds = 0;
};

/// Returns a counterexample as one line.
Json told(const Case& c, const Outcome& o, std::uint64_t seed, int number) {
  return {{"property", std::string(1, c.property)},
          {"seed", seed},
          {"question", c.question},
          {"number", number},
          {"change", c.change},
          {"questions", o.questions},
          {"values", o.values},
          {"off", o.off},
          {"what", o.what}};
}

/// Draws the case of a number, again and again until one suits the property.
Case drawn(char property, std::uint64_t seed, int number, const QuestionWish& wish) {
  constexpr std::uint64_t apart = 1'000'003;
  Random r(seed * apart + static_cast<std::uint64_t>(property), static_cast<std::uint64_t>(number));
  for (;;)
    if (auto c = random_case(property, r, wish)) return *c;
}

Outcome checked(const Case& c) {
  try {
    return check(c);
  } catch (const std::exception& error) {
    return {.judged = true, .failed = true, .off = 1, .what = error.what(), .questions = {c.question}};
  }
}

/// Reports cases that run longer than a given time, while they run.
class Watch {
 public:
  explicit Watch(double seconds) : seconds_(seconds), thread_([this] { look(); }) {}
  ~Watch() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  void begin(const Case& c, std::uint64_t seed, int number) {
    const std::lock_guard lock(mutex_);
    running_[std::this_thread::get_id()] = {std::chrono::steady_clock::now(), told(c, {}, seed, number)};
  }
  void end() {
    const std::lock_guard lock(mutex_);
    running_.erase(std::this_thread::get_id());
  }

 private:
  struct Running {
    std::chrono::steady_clock::time_point since;
    Json line;
    bool said = false;
  };
  void look() {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::seconds(1), [this] { return over_; }))
      for (auto& [thread, running] : running_) {
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - running.since;
        if (running.said || took.count() < seconds_) continue;
        std::cerr << "slow: " << running.line.dump() << std::endl;
        running.said = true;
      }
  }

  double seconds_;
  std::mutex mutex_{};
  std::condition_variable wake_{};
  bool over_ = false;
  std::map<std::thread::id, Running> running_{};
  std::thread thread_;
};

Tally run(char property, const Options& options) {
  Watch watch(options.slow);
  Tally tally;
  std::mutex writing;
  std::atomic<int> next{options.first};
  const QuestionWish wish{.most_balls = options.max_balls, .quick = options.quick, .leaves = options.leaves};
  const auto begin = std::chrono::steady_clock::now();
  const auto work = [&] {
    for (int i = next++; i < options.first + options.count; i = next++) {
      Case c = drawn(property, options.seed, i, wish);
      if (options.list) {
        const std::lock_guard lock(writing);
        std::cout << told(c, {}, options.seed, i).dump() << std::endl;
        continue;
      }
      watch.begin(c, options.seed, i);
      Outcome o = checked(c);
      watch.end();
      if (o.failed && options.shrink > 0) {
        Case less = smaller(c, o.off, options.shrink);
        Outcome again = checked(less);
        if (again.failed)
          c = std::move(less), o.what = std::move(again.what), o.questions = again.questions, o.values = again.values;
      }
      const std::lock_guard lock(writing);
      ++tally.scenes;
      tally.judged += o.judged;
      tally.failed += o.failed;
      if (o.judged) tally.worst = std::max(tally.worst, o.off);
      if (o.failed) std::cout << told(c, o, options.seed, i).dump() << std::endl;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < options.threads; ++i) threads.emplace_back(work);
  for (std::thread& t : threads) t.join();
  tally.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return tally;
}

/// Reads percentages by property, such as "a=0.2,c=1".
std::map<char, double> read_allowed(const std::vector<std::string>& words) {
  std::map<char, double> out;
  for (const std::string& word : words) {
    if (word.size() < 3 || word[1] != '=') throw CLI::ValidationError("--allow", word + " is not like a=0.2");
    out[word[0]] = std::stod(word.substr(2));
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Properties of answers that must always hold");
  Options options;
  options.seed = seed_or_fresh(1);
  std::vector<std::string> properties, allow;
  std::string csv;
  app.add_option("--count", options.count, "Cases of each property")->capture_default_str();
  app.add_option("--first", options.first, "Number of the first case: with --count 1 that case alone");
  app.add_option("--seed", options.seed, "Other seeds, other cases; BANKSHOT_SEED moves the default");
  app.add_option("--property", properties, "Some of a to h; all without")->delimiter(',');
  app.add_flag("--leaves", options.leaves, "Each puzzle has a leave or asks for a game");
  app.add_option("--max-balls", options.max_balls, "Object balls at most")->capture_default_str();
  app.add_option("--shrink", options.shrink, "Cases to check to make a counterexample smaller; 0: none");
  app.add_option("--csv", csv, "Write the table to this file, too");
  app.add_option("--allow", allow, "Percentages of judged cases that may fail, as a=0.2,c=1")->delimiter(',');
  app.add_option("-j", options.threads, "Threads")->capture_default_str();
  app.add_flag("--quick", options.quick, "Small scenes, small budgets");
  app.add_option("--slow", options.slow, "Seconds after which a case is told while it runs")->capture_default_str();
  app.add_flag("--list", options.list, "Print the cases and check none");
  CLI11_PARSE(app, argc, argv);
  const std::map<char, double> allowed = read_allowed(allow);
  std::string chosen;
  for (const std::string& p : properties) chosen += p;
  if (chosen.empty()) chosen = all_properties;
  std::ofstream file;
  if (!csv.empty()) file.open(csv);
  file << "property,seed,scenes,judged,failures,worst\n";
  std::string table = fmt::format("seed {}\n{:30} {:>7} {:>7} {:>9} {:>9} {:>8}\n", options.seed, "property", "scenes",
                                  "judged", "failures", "worst", "seconds");
  bool bad = false;
  for (const char p : chosen) {
    const Tally t = run(p, options);
    table += fmt::format("{:30} {:7} {:7} {:9} {:9.2g} {:8.0f}\n", fmt::format("{} {}", p, about(p)), t.scenes,
                         t.judged, t.failed, t.worst, t.seconds);
    file << fmt::format("{},{},{},{},{},{:.3g}\n", p, options.seed, t.scenes, t.judged, t.failed, t.worst);
    const auto may = allowed.find(p);
    bad = bad || t.failed > (may == allowed.end() ? 0 : may->second / 100 * t.judged);
  }
  std::cout << table;
  return bad ? 1 : 0;
}
