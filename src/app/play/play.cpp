// SPDX-License-Identifier: MIT
//
// bankshot play: what to play, thinking of the next balls. It is `solve` with a game as target.
#include "app/commands.hpp"
#include "app/layout.hpp"
#include "app/option_checks.hpp"
#include "app/solve/solve.hpp"
#include "io/format/puzzle_keys.hpp"

namespace bankshot::app::play {
namespace {

struct Arguments : solve::Arguments {
  std::string game, group;
  std::vector<std::string> order;
};

/// Returns the target that the options give, if any.
std::optional<Json> game_of(const Arguments& a) {
  if (a.game.empty() && a.group.empty() && a.order.empty()) return std::nullopt;
  Json target{{"game", !a.game.empty() ? a.game : !a.group.empty() ? "eight" : "list"}};
  if (!a.group.empty()) target["group"] = a.group;
  if (!a.order.empty()) target["order"] = a.order;
  return target;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("play", "What should I play, thinking of the next balls?");
  command->add_option("layout", a->file, "A layout in JSON: a puzzle without target; - reads standard input")
      ->capture_default_str();
  const auto words = [](std::span<const std::string_view> all) {
    return std::vector<std::string>(all.begin(), all.end());
  };
  command
      ->add_option("--game", a->game,
                   "Which ball may be potted next: the lowest, any, one of the own group, or by --order")
      ->check(CLI::IsMember(words(format::games)));
  command->add_option("--group", a->group, "The own group in the game eight")
      ->check(CLI::IsMember(words(format::groups)));
  command->add_option("--order", a->order, "Balls one after the other, with commas between")->delimiter(',');
  solve::add_arguments(*command, *a);
  explain(
      *command,
      "The answer is the pot that most likely makes a ball and also leaves the next one: where the cue ball stops,\n"
      "the next ball and its pocket, and how likely the balls are cleared. Where a pot would leave the opponent\n"
      "more than it wins, the answer is a safety. The probabilities of later balls are estimates.\n"
      "A layout has the keys of a puzzle; docs/format.md has them all. Without \"spin\" the cue ball may be struck\n"
      "within half its radius of the centre.",
      {{"bankshot play rack.json", "rotation: the lowest ball first"},
       {"bankshot play rack.json --game any", "any ball at any time"},
       {"bankshot play rack.json --group solids", "eight-ball: the own group, then the 8"},
       {"bankshot play rack.json --order 3,1,2", "an order of your own"},
       {"bankshot play rack.json --svg plan.svg", "with a picture of the plan"}},
      "0 solved; 1 no shot, or the budget ran out; 2 bad input or usage.");
  return [a] {
    output_is_free(a->csv, a->json);
    return solve::run(*a, [&](const std::string& text) { return as_puzzle(text, game_of(*a)); });
  };
}

}  // namespace bankshot::app::play
