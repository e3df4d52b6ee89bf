// SPDX-License-Identifier: MIT
#include "service/wishes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "bankshot/scene/json.hpp"
#include "io/json/reader.hpp"
#include "service/options.hpp"
#include "service/scene_words.hpp"

namespace bankshot::service {
namespace {

int whole(const std::string& text) {
  constexpr std::size_t most_digits = 5;
  const bool digits =
      !text.empty() && text.size() <= most_digits && text.find_first_not_of("0123456789") == std::string::npos;
  const int n = digits ? std::stoi(text) : -1;
  return n <= max_cushions ? n : -1;
}

/// Reads "2", "1-3" or "top,left".
CushionRule read_rule(const std::string& text, const Table& table, std::string_view flag) {
  if (const int n = whole(text); n >= 0) return CushionRule::exactly(n);
  const auto dash = text.find('-');
  const int low = whole(text.substr(0, dash)), high = dash == std::string::npos ? -1 : whole(text.substr(dash + 1));
  if (low >= 0 && high >= low) return {low, high, {}};
  const std::vector<std::string>& all = table.cushions;
  const std::vector<std::string_view> names(all.begin(), all.end());
  std::vector<Contact> contacts;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const auto it = std::find(all.begin(), all.end(), word);
    if (it == all.end())
      throw BadOption(fmt::format("{}: {} is neither a number, LOW-HIGH nor a cushion{}", flag, quote(word),
                                  known_words(word, names)));
    contacts.push_back(Contact::rail(static_cast<int>(it - all.begin())));
  }
  return CushionRule::in_order(std::move(contacts));
}

}  // namespace

Wish read_wish(const Wishes& a) {
  Wish w;
  const Scene scene = read_scene_words(a.table, a.physics, "--");
  w.table = scene.table, w.physics = scene.physics, w.ball = scene.ball;
  w.cushions = read_rule(a.cushions, w.table, "--cushions");
  w.then = read_rule(a.then, w.table, "--then");
  w.others = a.balls;
  constexpr std::array levels{Difficulty::easy, Difficulty::medium, Difficulty::hard};
  const auto asked = [&](Difficulty level) { return a.difficulty == name(level); };
  if (const auto at = std::ranges::find_if(levels, asked); at != levels.end())
    w.difficulty = *at;
  else if (!a.difficulty.empty())
    throw BadOption("--difficulty: " + quote(a.difficulty) + " is neither easy, medium nor hard");
  if (const auto at = std::ranges::find(kinds, a.target); at != std::end(kinds))
    w.kind = static_cast<Wish::Kind>(at - std::begin(kinds));
  else if (!a.target.empty())
    throw BadOption("--target: " + quote(a.target) + " is no target" + known_words(a.target, kinds));
  if ((w.kind == Wish::Kind::pocket || w.kind == Wish::Kind::pot) && w.table.pockets.empty())
    throw BadOption("--target " + a.target + ": this table has no pockets");
  if (a.then != "0" && w.kind != Wish::Kind::pot)
    throw BadOption("--then: is of the ball that is sent into a pocket, with --target pot");
  if (w.kind == Wish::Kind::stop && deceleration(w.physics) == 0)
    throw BadOption("--target stop: without friction no ball comes to rest");
  w.unique = a.unique;
  w.spins = !a.no_spin;
  if (a.speed.empty()) return w;
  const Range speed{a.speed.front(), a.speed.back()};
  if (a.speed.size() > 2 || !(speed.low > 0) || !(speed.low <= speed.high) || !std::isfinite(speed.high))
    throw BadOption("--speed: a speed above 0, or the lowest and the highest with a comma between [m/s]");
  w.speed = speed;
  return w;
}

Made make(const Wishes& a, const Wish& w, long number) {
  Made made;
  Random random(a.seed, static_cast<std::uint64_t>(number));
  auto g = bankshot::generate(w, random, &made.tries);
  if (!g) return made;
  g->puzzle.id = fmt::format("\"{}-{}\"", a.seed, number);
  g->puzzle.about = fmt::format(R"({{"difficulty":"{}"}})", name(difficulty(g->answer.shots.front())));
  made.line = write_puzzle(g->puzzle, as_json(a.table), as_json(a.physics)) + "\n";
  return made;
}

}  // namespace bankshot::service
