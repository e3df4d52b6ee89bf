// SPDX-License-Identifier: MIT
#include "bindings/verified.hpp"

#include <algorithm>

#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/json.hpp"
#include "io/json/writer.hpp"
#include "truth/claims.hpp"

namespace bankshot::bindings {

std::pair<bool, std::string> verified(const std::string& puzzle_text, const std::string& answer_text) {
  const Puzzle puzzle = read_puzzle(puzzle_text);
  const Answer answer = read_answer(answer_text, &puzzle, nullptr);
  const auto checks = truth::check(&puzzle, puzzle.id, answer);
  const bool holds = std::ranges::all_of(checks, [](const auto& c) { return c.holds(); });
  JsonWriter w;
  w.open('{');
  w.boolean("holds", holds);
  w.integer("checked", static_cast<long>(checks.size()));
  w.key("failed"), w.open('[');
  for (const auto& c : checks) {
    if (c.holds()) continue;
    w.open('{');
    w.integer("shot", static_cast<long>(c.shot));
    w.string("claim", truth::name(c.claim));
    w.number("off", c.off), w.number("allowed", c.allowed);
    w.string("what", c.what);
    w.close('}');
  }
  w.close(']'), w.close('}');
  return {holds, w.take() + "\n"};
}

}  // namespace bankshot::bindings
