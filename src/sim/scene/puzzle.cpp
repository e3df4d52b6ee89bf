// SPDX-License-Identifier: MIT
#include "bankshot/scene/puzzle.hpp"

#include <algorithm>
#include <string>

#include "sim/scene/ideal_speeds.hpp"

namespace bankshot {

std::string contact_name(const Puzzle& p, Contact contact) {
  if (contact.kind != ContactKind::ball) return contact_name(p.table, contact);
  return "ball \"" + (contact.index == 0 ? p.ball : p.others[static_cast<std::size_t>(contact.index) - 1]).id + '"';
}

std::optional<Range> arrival_range(const Puzzle& p) {
  if (is_ideal(p.physics) || p.speed.fixed()) return {};
  if (p.arrive) return p.arrive;
  constexpr Range rests{0, 0}, touches{0.5, 0.5}, any_contact{0.1, 5}, caroms{0.2, 5}, drops{0.2, 3};
  if (first_of_carom(p.target)) return caroms;
  if (const BallTarget* const touch = touch_of(p.target)) return touch->cut ? touches : any_contact;
  return is_pocket(p.target) ? drops : rests;
}

Aim aim_of(const Puzzle& p) {
  if (p.aim) return *p.aim;
  const BallTarget* const touch = touch_of(p.target);
  const bool contact = touch && !touch->cut;
  return p.prefer == Prefer::robust && (contact || is_pocket(p.target)) ? Aim::safest : Aim::centre;
}

long budget_of(const Puzzle& p) {
  if (p.budget) return *p.budget;
  constexpr long usual = 100'000, most = 2'000'000, usual_pairs = 6;
  const PocketTarget* const pocket = pocket_of(p.target);
  const std::size_t balls = std::max<std::size_t>(1, touched_first(p.target).size()),
                    pockets = pocket && !pocket->pocket ? p.table.pockets.size() : 1;
  return std::min(most, usual * std::max(usual_pairs, static_cast<long>(balls * pockets)) / usual_pairs);
}

double ideal_speed(const Puzzle& p) {
  const Range speeds = ideal_speeds(p);
  return std::clamp(1.0, speeds.low, speeds.high);
}

}  // namespace bankshot
