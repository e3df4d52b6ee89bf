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
bool is_ball(const Target& target) { return touch_of(target) || then_of(target); }

const Then* then_of(const Target& target) {
  const auto* sends = std::get_if<ObjectBallTarget>(&target);
  return sends ? &sends->then : nullptr;
}

const BallTarget* touch_of(const Target& target) {
  const auto* carom = std::get_if<CaromTarget>(&target);
  return carom ? &carom->second : std::get_if<BallTarget>(&target);
}

int first_of_carom(const Target& target) {
  const auto* carom = std::get_if<CaromTarget>(&target);
  return carom ? carom->first : 0;
}

bool is_in_any_order(const Target& target) {
  const auto* carom = std::get_if<CaromTarget>(&target);
  return carom && carom->any_order;
}

Target in_order(Target target, int first) {
  auto* const carom = std::get_if<CaromTarget>(&target);
  if (!carom) return target;
  carom->any_order = false;
  if (first != carom->first) std::swap(carom->first, carom->second.balls.front());
  return target;
}

bool goes_on_after_contact(const Target& target) { return then_of(target) || first_of_carom(target) != 0; }

std::vector<int> touched_first(const Target& target) {
  if (const int first = first_of_carom(target)) return {first};
  if (const auto* sends = std::get_if<ObjectBallTarget>(&target)) return sends->balls;
  const BallTarget* const touched = touch_of(target);
  return touched ? touched->balls : std::vector<int>{};
}

std::vector<int*> balls_of(Target& target) {
  std::vector<int*> all;
  const auto add = [&](std::vector<int>& balls) {
    for (int& ball : balls) all.push_back(&ball);
  };
  if (auto* touched = std::get_if<BallTarget>(&target)) add(touched->balls);
  if (auto* carom = std::get_if<CaromTarget>(&target)) all.push_back(&carom->first), add(carom->second.balls);
  if (auto* sends = std::get_if<ObjectBallTarget>(&target)) {
    add(sends->balls);
    for (Link& link : sends->then.links) all.push_back(&link.ball);
  }
  return all;
}

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

std::string words_of(const std::vector<int>& balls, const Puzzle& p) {
  std::string names;
  for (const int k : balls) names += (names.empty() ? "" : " or ") + contact_name(p, Contact::ball(k));
  return names;
}

std::string words_of(const BallTarget& target, const Puzzle& p) { return "onto " + words_of(target.balls, p); }

std::string words_of(const CaromTarget& target, const Puzzle& p) {
  if (target.any_order)
    return words_of(target.second, p) + " and " + contact_name(p, Contact::ball(target.first)) + ", in either order";
  return "off " + contact_name(p, Contact::ball(target.first)) + ' ' + words_of(target.second, p);
}

std::string words_of(const ObjectBallTarget& target, const Puzzle& p) {
  const Then& then = target.then;
  std::string by;
  for (const Link& link : then.links)
    by += bank_words(link.cushions, p) + " onto " + contact_name(p, Contact::ball(link.ball)) + " and that";
  by += bank_words(then.cushions_of(then.links.size()), p);
  return "to send " + words_of(target.balls, p) + by + ' ' +
         std::visit([&](const auto& t) { return words_of(t, p); }, then.target);
}

}  // namespace

std::string target_words(const Puzzle& p) {
  return std::visit([&](const auto& target) { return words_of(target, p); }, p.target);
}

}  // namespace bankshot
