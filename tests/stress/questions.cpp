// SPDX-License-Identifier: MIT
//
// Gives typical puzzles of players to any build of the program, and counts how often it answers one worse than a
// narrower puzzle of the same layout.
//   questions --program build/release/bankshot [--seed 1] [--share 1] [-j 2] [--csv FILE] [--list FILE]
// Table:
//   1 "What should I play?" by up to two cushions: unsolved, and worse than the best direct pot
//   2 one ball, any pocket, by up to one cushion: worse than with launch speeds of [0.1, 2], [1, 3] or [2, 5] m/s alone
//   3 the same layouts: `safest` below `centre`
//   4 a ball that hangs in a corner, or a cue ball straight at an open one: played by a cushion or at more than 3 m/s
//     although a soft direct shot has a success within 0.02
// Worse means by 0.02 of value, which is success less the cost of the shot. It is computed here, so that every build is
// judged alike; a second column judges by success alone. Each puzzle runs in a process of its own; times are wall-clock
// times.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "bankshot/scene/scene.hpp"
#include "support/random_question.hpp"

namespace {

using namespace bankshot;
using namespace bankshot::test;

constexpr double worse_by = 0.02, hard = 3;  // value; m/s

struct Options {
  std::string program, list;
  std::uint64_t seed = 1;
  double share = 1;
  int threads = 1;
};

struct Reply {
  bool solved = false;
  double success = 0, value = 0, speed = 0, seconds = 0;
  std::size_t cushions = 0;
};

/// Reads the value of the best shot of an answer.
Reply read_reply(const std::string& text) {
  Reply reply;
  const Json answer = Json::parse(text, nullptr, false);
  if (answer.is_discarded() || answer.value("status", "") != "solved") return reply;
  const Json& shot = answer["shots"][0];
  reply.solved = true;
  reply.success = shot.value("success", 0.0);
  reply.speed = shot["speed"];
  reply.cushions = shot["cushions"].size();
  if (shot.contains("then")) {
    const Json& then = shot["then"];
    for (const Json& sent : then.is_array() ? then : Json::array({then}))
      if (sent.contains("cushions")) reply.cushions += sent["cushions"].size();
  }
  constexpr double cushion = 0.005, per_speed = 0.004;  // the tip is in the centre
  reply.value = reply.success - cushion * static_cast<double>(reply.cushions) - per_speed * reply.speed;
  return reply;
}

Reply ask(const Options& options, const Json& question, std::size_t number) {
  const auto file = std::filesystem::temp_directory_path() /
                    fmt::format("questions-{}-{}.json", std::hash<std::string>()(options.program) % 100000, number);
  std::ofstream(file) << question.dump();
  const std::string command = fmt::format("'{}' solve '{}' --json 2>/dev/null", options.program, file.string());
  const auto begin = std::chrono::steady_clock::now();
  std::string out;
  if (FILE* pipe = popen(command.c_str(), "r")) {
    std::array<char, 4096> part;
    while (fgets(part.data(), part.size(), pipe)) out += part.data();
    pclose(pipe);
  }
  Reply reply = read_reply(out);
  reply.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::filesystem::remove(file);
  return reply;
}

std::vector<Reply> ask_all(const Options& options, const std::vector<Json>& questions) {
  std::vector<Reply> replies(questions.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < options.threads; ++t)
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < questions.size(); i = next++) replies[i] = ask(options, questions[i], i);
    });
  for (std::thread& t : threads) t.join();
  return replies;
}

/// Draws balls anywhere on a 9-foot pool table.
Json layout(Random& r, int balls) {
  const Scene scene = preset_scene("pool-9ft");
  std::vector<Ball> all;
  Json question{{"table", "pool-9ft"}};
  for (int k = 0; k <= balls; ++k) {
    const auto at = free_place(r, scene.table, all, scene.ball.body);
    all.push_back({*at, scene.ball.body, std::to_string(k)});
    if (k == 0)
      question["ball"]["at"] = {at->x, at->y};
    else
      question["others"].push_back({{"id", std::to_string(k)}, {"at", {at->x, at->y}}});
  }
  return question;
}

/// Returns a copy of the puzzle with other keys.
Json with(Json question, const Json& keys) {
  question.update(keys);
  return question;
}

Json pot(int cushions) {
  return {{"target",
           {{"ball", "any"},
            {"then", {{"pocket", "any"}, {"cushions", cushions > 0 ? Json{{"max", cushions}} : Json(0)}}}}}};
}

/// Answers in the rows of a table, one puzzle per column.
class Questions {
 public:
  Questions(const Options& options, std::string title) : options_(options), title_(std::move(title)) {}
  void add(std::vector<Json> row) {
    width_ = row.size();
    for (Json& question : row) all_.push_back(std::move(question));
  }
  void run() { replies_ = ask_all(options_, all_); }
  std::size_t rows() const { return all_.size() / width_; }
  const Reply& at(std::size_t row, std::size_t column) const { return replies_[row * width_ + column]; }

  /// Counts the bad rows and notes them in the list. `column` selects the puzzle that is noted.
  int count(const std::string& what, std::size_t column, const std::function<bool(std::size_t)>& is_bad) {
    int n = 0;
    for (std::size_t row = 0; row < rows(); ++row) {
      if (!is_bad(row)) continue;
      ++n;
      if (options_.list.empty()) continue;
      Json replies = Json::array();
      for (std::size_t k = 0; k < width_; ++k) {
        const Reply& r = at(row, k);
        replies.push_back({{"value", r.value}, {"success", r.success}, {"speed", r.speed}, {"cushions", r.cushions}});
      }
      std::ofstream(options_.list, std::ios::app)
          << Json{{"question", title_}, {"what", what}, {"puzzle", all_[row * width_ + column]}, {"replies", replies}}
                 .dump()
          << '\n';
    }
    return n;
  }

  /// Returns a quantile of the times of the first column.
  double seconds(double quantile) const {
    std::vector<double> all;
    for (std::size_t row = 0; row < rows(); ++row) all.push_back(at(row, 0).seconds);
    std::ranges::sort(all);
    return all[std::min(all.size() - 1, static_cast<std::size_t>(quantile * static_cast<double>(all.size())))];
  }

 private:
  const Options& options_;
  std::string title_;
  std::size_t width_ = 1;
  std::vector<Json> all_{};
  std::vector<Reply> replies_{};
};

class Counts {
 public:
  explicit Counts(const std::string& file) {
    if (!file.empty()) file_.open(file);
    file_ << "question,layouts,what,count,median_s,99_percent_s\n";
    std::cout << fmt::format("{:34} {:>7} {:40} {:>6} {:>9} {:>9}\n", "question", "layouts", "", "count", "median s",
                             "99 % s");
  }
  void row(const std::string& question, const Questions& q, const std::string& what, int count) {
    std::cout << fmt::format("{:34} {:7} {:40} {:6} {:9.3f} {:9.3f}\n", question, q.rows(), what, count, q.seconds(0.5),
                             q.seconds(0.99))
              << std::flush;
    file_ << fmt::format("{},{},{},{},{:.3f},{:.3f}\n", question, q.rows(), what, count, q.seconds(0.5),
                         q.seconds(0.99));
  }

 private:
  std::ofstream file_;
};

/// Returns true when `a` is solved but worse than `b`.
bool worse(const Reply& a, const Reply& b, double Reply::*by) { return a.solved && a.*by < b.*by - worse_by; }

int as_many(const Options& o, int usual) { return std::max(1, static_cast<int>(std::lround(o.share * usual))); }

void what_should_i_play(const Options& o, Counts& table, Random& r) {
  for (const int balls : {2, 3, 5, 7, 9}) {
    const std::string title = fmt::format("1 what should I play: {} balls", balls);
    Questions q(o, title);
    for (int i = 0; i < as_many(o, 12); ++i) {
      const Json scene = layout(r, balls);
      Json direct = pot(0);
      direct["cushions"] = 0;
      q.add({with(scene, pot(2)), with(scene, direct)});
    }
    q.run();
    table.row(title, q, "unsolved", q.count("unsolved", 0, [&](auto i) { return !q.at(i, 0).solved; }));
    table.row(title, q, "worse than direct by value",
              q.count("worse than direct", 0, [&](auto i) { return worse(q.at(i, 0), q.at(i, 1), &Reply::value); }));
    table.row(title, q, "worse than direct by success",
              q.count("likelier direct", 0, [&](auto i) { return worse(q.at(i, 0), q.at(i, 1), &Reply::success); }));
  }
}

void one_ball(const Options& o, Counts& table, Random& r) {
  const std::string title = "2 one ball into any pocket by up to one cushion";
  Questions q(o, title);
  for (int i = 0; i < as_many(o, 80); ++i) {
    const Json question = with(layout(r, 1), pot(1));
    q.add({question, with(question, {{"speed", {0.1, 2}}}), with(question, {{"speed", {1, 3}}}),
           with(question, {{"speed", {2, 5}}}), with(question, {{"aim", "safest"}}),
           with(question, {{"aim", "centre"}})});
  }
  q.run();
  const auto worse_than_one = [&](std::size_t i, double Reply::*by) {
    return worse(q.at(i, 0), q.at(i, 1), by) || worse(q.at(i, 0), q.at(i, 2), by) || worse(q.at(i, 0), q.at(i, 3), by);
  };
  table.row(title, q, "unsolved", q.count("unsolved", 0, [&](auto i) { return !q.at(i, 0).solved; }));
  table.row(title, q, "worse than a narrower speed by value",
            q.count("worse than a narrower speed", 0, [&](auto i) { return worse_than_one(i, &Reply::value); }));
  table.row(title, q, "worse than a narrower speed by success",
            q.count("likelier at a narrower speed", 0, [&](auto i) { return worse_than_one(i, &Reply::success); }));
  constexpr double nothing = 1e-6;
  table.row("3 the same layouts", q, "safest below centre by value",
            q.count("safest below centre", 4, [&](auto i) { return q.at(i, 4).value < q.at(i, 5).value - nothing; }));
  table.row("3 the same layouts", q, "safest below centre by success",
            q.count("safest less likely than centre", 4,
                    [&](auto i) { return q.at(i, 4).success < q.at(i, 5).success - nothing; }));
}

/// Draws a ball that hangs in a corner with the cue ball anywhere, or a cue ball alone that lies straight in front of a
/// corner.
Json at_corner(Random& r, bool hangs) {
  const Scene scene = preset_scene("pool-9ft");
  constexpr int corners[] = {0, 2, 3, 5};
  const Pocket& pocket = scene.table.pockets[static_cast<std::size_t>(corners[r.integer(0, 3)])];
  const Vec2d middle = scene.table.highest() / 2.0, corner = pocket.place();
  const double towards =
      std::atan2(corner.y > middle.y ? -1 : 1, corner.x > middle.x ? -1 : 1) + radians(r.uniform(-5, 5));
  const auto from_corner = [&](double d) {
    const Vec2d at = corner + direction(wrap_angle(towards)) * d;
    return Json{in_millimetres(at.x), in_millimetres(at.y)};
  };
  Json question{{"table", "pool-9ft"}};
  if (!hangs) {
    question["ball"]["at"] = from_corner(r.uniform(0.3, 1.2));
    question["target"]["pocket"] = "any";
    return question;
  }
  question["others"] = {{{"id", "1"}, {"at", from_corner(r.uniform(0.08, 0.15))}}};
  const Json& at = question["others"][0]["at"];
  const Ball ball{{at[0], at[1]}, scene.ball.body, "1"};
  const auto cue = free_place(r, scene.table, std::span(&ball, 1), scene.ball.body);
  question["ball"]["at"] = {cue->x, cue->y};
  question.update(pot(2));
  return question;
}

void open_corner(const Options& o, Counts& table, Random& r) {
  for (const bool hangs : {true, false}) {
    const std::string title = hangs ? "4 a ball hangs in a corner" : "4 cue ball at an open corner";
    Questions q(o, title);
    for (int i = 0; i < as_many(o, 30);) {
      const Json question = at_corner(r, hangs);
      if (!valid_puzzle(question)) continue;
      ++i;
      Json soft = with(question, {{"cushions", 0}, {"speed", {0.1, hard}}});
      if (hangs) soft["target"]["then"]["cushions"] = 0;
      q.add({question, soft});
    }
    q.run();
    table.row(title, q, "unsolved", q.count("unsolved", 0, [&](auto i) { return !q.at(i, 0).solved; }));
    table.row(title, q, "by cushions or hard for nothing", q.count("by cushions or hard", 0, [&](auto i) {
      const Reply &played = q.at(i, 0), &soft = q.at(i, 1);
      return played.solved && soft.solved && (played.cushions > 0 || played.speed > hard) &&
             soft.success >= played.success - worse_by;
    }));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("What players ask, and how often a narrower question is answered better");
  Options options;
  std::string csv;
  std::vector<int> parts{1, 2, 4};
  app.add_option("--program", options.program, "The bankshot program to ask")->required()->check(CLI::ExistingFile);
  app.add_option("--seed", options.seed, "Other seeds, other layouts")->capture_default_str();
  app.add_option("--share", options.share, "Of the usual number of layouts")->capture_default_str();
  app.add_option("--part", parts, "1, 2 (with 3) or 4; all without")->delimiter(',');
  app.add_option("--csv", csv, "Write the table to this file, too");
  app.add_option("--list", options.list, "Add the questions that are counted to this file, one per line");
  app.add_option("-j", options.threads, "Questions at a time")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  Counts table(csv);
  for (const int part : parts) {
    Random random(options.seed, static_cast<std::uint64_t>(part));
    if (part == 1) what_should_i_play(options, table, random);
    if (part == 2) one_ball(options, table, random);
    if (part == 4) open_corner(options, table, random);
  }
  return 0;
}
