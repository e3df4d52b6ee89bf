// SPDX-License-Identifier: MIT
#include "bankshot/scene/target.hpp"

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

namespace {

template <class Kind>
const Kind* arrival_at(const Target& target) {
  const Then* const then = then_of(target);
  return then ? std::get_if<Kind>(&then->target) : std::get_if<Kind>(&target);
}

}  // namespace

const PointTarget* point_of(const Target& target) { return arrival_at<PointTarget>(target); }
const PocketTarget* pocket_of(const Target& target) { return arrival_at<PocketTarget>(target); }

bool is_pocket(const Target& target) { return pocket_of(target) != nullptr; }

namespace {

std::string words_of(const PocketTarget& target, const Puzzle& p) {
  return "into " + (target.pocket ? p.table.pockets[static_cast<std::size_t>(*target.pocket)].name : "any pocket");
}

std::string words_of(const PointTarget&, const Puzzle& p) {
  const auto arrive = arrival_range(p);
  return arrive && arrive->high == 0 ? "to rest in the ring" : "through the ring";
}

/// Returns a cushion rule as words, such as " off one cushion" or " by top, right"; empty if no cushion is required.
std::string bank_words(const CushionRule& rule, const Puzzle& p) {
  constexpr std::string_view numbers[] = {"no", "one", "two", "three", "four", "five"};
  const auto counted = [&](int n) {
    return n < static_cast<int>(std::size(numbers)) ? std::string(numbers[n]) : std::to_string(n);
  };
  if (rule.max == 0) return "";
  if (!rule.sequence && rule.min == 0)
    return " off up to " + counted(rule.max) + (rule.max == 1 ? " cushion" : " cushions");
  if (!rule.sequence)
    return rule.min == rule.max ? " off " + counted(rule.max) + (rule.max == 1 ? " cushion" : " cushions")
                                : " off " + counted(rule.min) + " to " + counted(rule.max) + " cushions";
  std::string names;
  for (const Contact c : *rule.sequence) names += (names.empty() ? " by " : ", ") + contact_name(p.table, c);
  return names;
}

std::string words_of(const BallTarget& target, const Puzzle& p) {
  std::string balls;
  for (const int k : target.balls) balls += (balls.empty() ? "" : " or ") + contact_name(p, Contact::ball(k));
  if (target.off) return "off " + contact_name(p, Contact::ball(*target.off)) + " onto " + balls;
  if (!target.then) return "onto " + balls;
  std::string by;
  for (const Link& link : target.then->links)
    by += bank_words(link.cushions, p) + " onto " + contact_name(p, Contact::ball(link.ball)) + " and that";
  by += bank_words(target.then->cushions_of(target.then->links.size()), p);
  return "to send " + balls + by + " " + std::visit([&](const auto& t) { return words_of(t, p); }, target.then->target);
}

}  // namespace

std::string target_words(const Puzzle& p) {
  return std::visit([&](const auto& target) { return words_of(target, p); }, p.target);
}

}  // namespace bankshot
