// SPDX-License-Identifier: MIT
//
// Records what this build answers, byte by byte, and compares it with what another build answered: a change of
// structure must change nothing. The record holds one digest per answer, so that it stays small.
//   characterise --out before.txt [--count 200] [--seed 1] [--only pot/] [-j 2]
//   characterise --against before.txt
//   characterise --show spin/han2005/level/jaws/pot/1/best/free 17
// Puzzles are drawn for each combination of physics, cushion law, tilt, jaws, target, number of object balls, search
// and route, and for each random family (support/families.hpp); the rest are long paths, and budgets that end a search
// at every count of simulations. The draws are seeded and use nothing of the planners. An answer includes its message,
// its nearest miss and its count of simulations. Batches with 1, 2 and 8 threads must give the same bytes. Budgets are
// small, since a shot that is not found characterises a search as well.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "bankshot/plan/batch.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/scene/scene.hpp"
#include "support/families.hpp"
#include "support/random_question.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

struct Options {
  std::string out, against, only;
  std::vector<std::string> show;
  int count = 200;
  std::uint64_t seed = 1;
  int threads = 1;
};

/// One combination, and how to draw its puzzles.
struct Kind {
  std::string name;
  std::function<Puzzle(Random&)> draw;
  SolveOptions search{};
};

std::uint64_t digest(std::string_view text) {  // FNV-1a
  std::uint64_t hash = 14695981039346656037U;
  for (const unsigned char c : text) hash = (hash ^ c) * 1099511628211U;
  return hash;
}

// Combinations.

struct Law {
  const char *physics, *cushion;
  bool slow = false;  ///< impacts are integrated
};
constexpr Law laws[] = {{"ideal", "mirror"}, {"rolling", "mirror"}, {"spin", "mirror"},
                        {"spin", "han2005"}, {"spin", "stronge"},   {"spin", "mathavan2010", true}};
constexpr const char* targets[] = {"pass",  "rest", "pocket", "any-pocket",  "touch", "cut",
                                   "carom", "pot",  "bank",   "combination", "send"};
constexpr const char* searches[] = {"first", "best", "all"};

struct Combination {
  Law law;
  bool leans, jaws;
  std::string target;
  int others;
  std::string search;
  bool route;

  std::string name() const {
    return fmt::format("{}/{}/{}/{}/{}/{}/{}/{}", law.physics, law.cushion, leans ? "leaning" : "level",
                       jaws ? "jaws" : "circles", target, others, search, route ? "given" : "free");
  }
  bool exists() const {
    const int needed = target == "carom" || target == "combination" ? 2 : on_ball() ? 1 : 0;
    const bool ideal = std::string(law.physics) == "ideal";
    return others >= needed && !(ideal && (leans || target == "rest" || target == "send"));
  }
  bool on_ball() const {
    return target == "touch" || target == "cut" || target == "carom" || target == "pot" || target == "bank" ||
           target == "combination" || target == "send";
  }
  bool slow() const { return law.slow || leans; }
};

Json names(Random& r, const Table& table, int count) {
  Json out = Json::array();
  for (int i = 0; i < count; ++i)
    out.push_back(table.cushions[static_cast<std::size_t>(r.integer(0, static_cast<int>(table.cushions.size()) - 1))]);
  return out;
}

Json target_of(Random& r, const Combination& c, const Table& table, const Json& place) {
  const std::string pocket = table.pockets[static_cast<std::size_t>(r.integer(0, 5))].name;
  if (c.target == "pass" || c.target == "rest") return {{"point", place}, {"within", 0.02}};
  if (c.target == "pocket") return {{"pocket", pocket}};
  if (c.target == "any-pocket") return {{"pocket", "any"}};
  if (c.target == "touch") return {{"ball", "1"}};
  if (c.target == "cut") return {{"ball", "1"}, {"cut", r.integer(-60, 60)}};
  if (c.target == "carom") return {{"carom", {"1", "2"}}};
  if (c.target == "pot") return {{"ball", "1"}, {"pocket", pocket}};
  if (c.target == "bank") return {{"ball", "any"}, {"then", {{"pocket", "any"}, {"cushions", 1}}}};
  if (c.target == "send") return {{"ball", "1"}, {"then", {{"point", place}, {"within", 0.02}}}};
  return {{"ball", "1"}, {"then", {{"ball", "2"}, {"then", {{"pocket", "any"}}}}}};
}

Json question_of(Random& r, const Combination& c) {
  Json question{{"table", {{"preset", "pool-9ft"}, {"jaws", c.jaws}}}, {"physics", {{"model", c.law.physics}}}};
  if (c.leans) question["table"]["tilt"] = {r.uniform(-3e-3, 3e-3), 1e-3};
  if (std::string(c.law.physics) == "spin") question["physics"]["cushion"] = {{"model", c.law.cushion}};
  const Scene scene = read_scene(question["table"].dump(), question["physics"].dump());
  std::vector<Ball> balls;
  for (int k = 0; k <= c.others; ++k) {
    const auto at = free_place(r, scene.table, balls, scene.ball.body);
    balls.push_back({*at, scene.ball.body, std::to_string(k)});
    if (k == 0)
      question["ball"]["at"] = {at->x, at->y};
    else
      question["others"].push_back({{"id", std::to_string(k)}, {"at", {at->x, at->y}}});
  }
  const auto place = free_place(r, scene.table, balls, scene.ball.body);
  question["target"] = target_of(r, c, scene.table, {place->x, place->y});
  if (c.target == "pass") question["arrive"] = {{"speed", r.uniform(0.3, 1.5)}};
  const int most = r.integer(0, 3);
  question["cushions"] = c.route ? names(r, scene.table, most) : Json{{"max", most}};
  if (std::string(c.law.physics) == "spin") question["ball"]["spin"] = {{"top", r.integer(-5, 10) / 10.0}};
  question["budget"] = {{"simulations", c.slow() ? 150 : 1500}};
  return question;
}

Puzzle puzzle_of(Random& r, const Combination& c) {
  for (;;)
    if (auto puzzle = valid_puzzle(question_of(r, c))) return *puzzle;
}

SolveOptions search_of(const Combination& c) {
  SolveOptions out;
  out.first = c.search == "first";
  out.all = c.search == "all";
  out.robustness = c.search == "best" && !c.slow();
  return out;
}

void add_combinations(std::vector<Kind>& kinds) {
  for (const Law& law : laws)
    for (const bool leans : {false, true})
      for (const bool jaws : {false, true})
        for (const char* target : targets)
          for (int others = 0; others <= 3; ++others)
            for (const char* search : searches)
              for (const bool route : {false, true})
                if (const Combination c{law, leans, jaws, target, others, search, route}; c.exists())
                  kinds.push_back({c.name(), [c](Random& r) { return puzzle_of(r, c); }, search_of(c)});
}

// Families, long paths and ended searches.

void add_families(std::vector<Kind>& kinds) {
  for (const NamedFamily& family : named_families())
    for (const Model model : {Model::rolling, Model::spin})
      for (const bool all : {false, true})
        kinds.push_back({fmt::format("family/{}/{}/{}", family.name, model == Model::spin ? "spin" : "rolling",
                                     all ? "all" : "best"),
                         [make = family.make, model](Random& r) {
                           Puzzle p = make(r, model, -1).puzzle;
                           if (!p.budget) p.budget = 5000;
                           return p;
                         },
                         {.all = all, .robustness = false}});
}

void add_rest(std::vector<Kind>& kinds) {
  const auto many = [](const char* physics, int cushions) {
    return [=](Random& r) {
      Json question{{"table", {{"length", 2}, {"width", 1}}},
                    {"physics", physics},
                    {"ball", {{"at", {r.uniform(0.1, 1.9), r.uniform(0.1, 0.9)}}, {"radius", 0}}},
                    {"target", {{"point", {r.uniform(0.1, 1.9), r.uniform(0.1, 0.9)}}}},
                    {"cushions", cushions}};
      if (std::string(physics) == "rolling") question["speed"] = {0.1, 1000};
      return read_puzzle(question.dump());
    };
  };
  for (const int cushions : {10'005, 20'000})
    for (const char* physics : {"ideal", "rolling"})
      kinds.push_back({fmt::format("long/{}/{}", physics, cushions), many(physics, cushions), {.robustness = false}});
  // The n-th puzzle may spend n simulations.
  for (const char* target : {"pocket", "rest", "pot", "combination", "carom"})
    for (const char* search : searches) {
      const Combination c{laws[3], false, true, target, 3, search, false};
      kinds.push_back({fmt::format("budget/{}/{}", target, search),
                       [c, budget = std::make_shared<std::atomic<long>>(0)](Random&) {
                         Random same(7);
                         Puzzle p = puzzle_of(same, c);
                         p.budget = ++*budget;
                         return p;
                       },
                       search_of(c)});
    }
}

std::vector<Kind> all_kinds(const Options& options) {
  std::vector<Kind> kinds;
  add_combinations(kinds);
  add_families(kinds);
  add_rest(kinds);
  std::erase_if(kinds, [&](const Kind& k) { return k.name.find(options.only) == std::string::npos; });
  return kinds;
}

// Recording and comparing.

struct Answered {
  Puzzle puzzle;
  Answer answer;
  std::string text;
};

/// Answers the puzzles of a kind, in order; `see` gets each.
template <class See>
void answer_all(const Kind& kind, const Options& options, const See& see) {
  const bool few = kind.name.starts_with("long/");
  for (int i = 0; i < (few ? std::min(options.count, 3) : options.count); ++i) {
    Random random(digest(kind.name) ^ (options.seed * 1'000'003 + static_cast<std::uint64_t>(i)));
    Answered a{kind.draw(random), {}, {}};
    a.answer = solve(a.puzzle, kind.search);
    a.text = to_json(a.puzzle, a.answer, false);
    see(i, a);
  }
}

using Digests = std::map<std::string, std::vector<std::uint64_t>>;

class Recorder {
 public:
  Recorder(const Options& options, const std::vector<Kind>& kinds) : options_(options), kinds_(kinds) {}

  Digests run() {
    std::vector<std::thread> threads;
    for (int t = 0; t < options_.threads; ++t)
      threads.emplace_back([&] {
        for (std::size_t i = next_++; i < kinds_.size(); i = next_++) record(kinds_[i]);
      });
    for (std::thread& t : threads) t.join();
    return std::move(record_);
  }
  void print_wins() const {
    fmt::print("shots by the step that found them:");
    for (const auto& [step, count] : wins_) fmt::print(" {} {}", step, count);
    fmt::print("\n");
  }

 private:
  void record(const Kind& kind) {
    std::vector<std::uint64_t> digests;
    std::map<std::string, long> wins;
    answer_all(kind, options_, [&](int, const Answered& a) {
      digests.push_back(digest(a.text));
      for (const Shot& shot : a.answer.shots) ++wins[shot.provenance.planner];
    });
    const std::lock_guard lock(mutex_);
    record_[kind.name] = std::move(digests);
    for (const auto& [step, count] : wins) wins_[step] += count;
  }

  const Options& options_;
  const std::vector<Kind>& kinds_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  Digests record_;
  std::map<std::string, long> wins_;
};

void write(const std::string& file, const Options& options, const Digests& record) {
  std::ofstream out(file);
  out << fmt::format("count {} seed {}\n", options.count, options.seed);
  std::string all;
  for (const auto& [name, digests] : record) {
    out << name;
    for (const std::uint64_t d : digests) out << fmt::format(" {:x}", d), all += fmt::format("{:x}", d);
    out << '\n';
  }
  fmt::print("digest of all {:016x}\n", digest(all));
}

/// Reads a record, and takes its count and seed.
Digests read(const std::string& file, Options& options) {
  std::ifstream in(file);
  std::string word;
  if (!(in >> word >> options.count >> word >> options.seed)) throw CLI::ValidationError(file + ": is no record");
  Digests record;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    words >> std::hex;
    for (std::uint64_t d = 0; words >> d;) record[name].push_back(d);
  }
  return record;
}

int compare(const Digests& before, const Digests& now) {
  long answers = 0, differ = 0;
  for (const auto& [name, digests] : now) {
    const auto then = before.find(name);
    if (then == before.end()) {
      fmt::print("{}: not in the record\n", name);
      ++differ;
      continue;
    }
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < digests.size(); ++i)
      if (i >= then->second.size() || digests[i] != then->second[i]) places.push_back(i);
    answers += static_cast<long>(digests.size());
    differ += static_cast<long>(places.size());
    if (!places.empty())
      fmt::print("{}: {} of {} differ, the first is {}\n", name, places.size(), digests.size(), places.front());
  }
  fmt::print("{} of {} answers differ\n", differ, answers);
  return differ == 0 ? 0 : 1;
}

/// Returns 1 if the number of threads changes a byte.
int compare_threads(const Options& options) {
  const Combination c{laws[3], false, true, "bank", 3, "best", false};
  Random random(options.seed);
  std::vector<Puzzle> puzzles;
  for (int i = 0; i < options.count; ++i) puzzles.push_back(puzzle_of(random, c));
  std::vector<std::string> texts;
  for (const int threads : {1, 2, 8}) {
    const std::vector<Answer> answers = solve_batch(puzzles, {.threads = threads});
    std::string text;
    for (std::size_t i = 0; i < puzzles.size(); ++i) text += to_json(puzzles[i], answers[i], false) + '\n';
    texts.push_back(std::move(text));
  }
  const bool same = texts[0] == texts[1] && texts[0] == texts[2];
  fmt::print("1, 2 and 8 threads: {}\n", same ? "the same bytes" : "DIFFERENT");
  return same ? 0 : 1;
}

int show(const std::vector<Kind>& kinds, const Options& options) {
  for (const Kind& kind : kinds)
    if (kind.name == options.show[0])
      answer_all(kind, options, [&](int i, const Answered& a) {
        if (i == std::stoi(options.show[1])) fmt::print("{}\n{}\n", write_puzzle(a.puzzle), a.text);
      });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Records what this build answers, and compares it with another build's record");
  app.add_option("--out", options.out, "Write the record to this file");
  app.add_option("--against", options.against, "Compare with this record; takes its count and seed");
  app.add_option("--only", options.only, "Kinds whose names contain this");
  app.add_option("--count", options.count, "Puzzles of each kind")->capture_default_str();
  app.add_option("--seed", options.seed, "Other seeds, other puzzles")->capture_default_str();
  app.add_option("--show", options.show, "Print one puzzle and its answer: KIND NUMBER")->expected(2);
  app.add_option("-j", options.threads, "Threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  Digests before;
  if (!options.against.empty()) before = read(options.against, options);
  const std::vector<Kind> kinds = all_kinds(options);
  if (!options.show.empty()) return show(kinds, options);
  fmt::print("{} kinds, {} puzzles each, seed {}\n", kinds.size(), options.count, options.seed);
  Recorder recorder(options, kinds);
  const Digests now = recorder.run();
  recorder.print_wins();
  if (!options.out.empty()) write(options.out, options, now);
  const int threads = options.only.empty() ? compare_threads(options) : 0;
  return options.against.empty() ? threads : std::max(threads, compare(before, now));
}
