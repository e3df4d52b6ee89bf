// SPDX-License-Identifier: MIT
#include "app/book/words.hpp"

#include <fmt/format.h>

#include "bankshot/geometry/boundary.hpp"
#include "io/json/document.hpp"

namespace bankshot::app::book {
namespace {

std::string counted(int n) {
  constexpr const char* words[] = {"Straight",       "One cushion",   "Two cushions",
                                   "Three cushions", "Four cushions", "Five cushions"};
  return n < static_cast<int>(std::size(words)) ? words[n] : fmt::format("{} cushions", n);
}

std::string cushions(const Puzzle& p) {
  const CushionRule& rule = p.cushions;
  if (!rule.sequence)
    return rule.min == rule.max ? counted(rule.min) : fmt::format("{} to {} cushions", rule.min, rule.max);
  if (rule.sequence->empty()) return counted(0);
  std::string names;
  for (const Contact c : *rule.sequence) names += (names.empty() ? "By " : ", ") + contact_name(p.table, c);
  return names;
}

}  // namespace

std::string question(const Puzzle& p) {
  const auto arrive = arrival_range(p);
  const std::string speed = p.speed.fixed() ? fmt::format(", struck at {:.2g} m/s", p.speed.low) : "";
  const bool rests = !is_pocket(p.target) && arrive && arrive->high == 0;
  const std::string asked = cushions(p) + (rests ? ", " : " ") + target_words(p);
  if (!arrive || !arrive->fixed()) return asked + speed;
  return rests ? asked : asked + fmt::format(" at {:.2g} m/s", arrive->low);
}

std::string scene(const Puzzle& p) {
  const Vec2d size = p.table.highest() - p.table.lowest();
  std::string out = p.table.is_rectangle() ? fmt::format("{:.3g} × {:.3g} m", size.x, size.y)
                                           : fmt::format("{} sides", p.table.vertices.size());
  for (const TablePreset& t : table_presets())
    if (make_table(t).vertices == p.table.vertices) out = t.name;
  out += is_ideal(p.physics)        ? ", no friction"
         : !carries_spin(p.physics) ? ", rolling"
                                    : fmt::format(", spin{}", model_of(p.physics.cushion).caption);
  if (p.spin.top != 0) out += fmt::format(", top {:.2g}", p.spin.top);
  if (p.spin.side != 0) out += fmt::format(", side {:.2g}", p.spin.side);
  return out + (p.spin.masse != 0 ? fmt::format(", massé {:.2g}", p.spin.masse) : "");
}

std::string title(const Puzzle& p) {
  const Json about = p.about.empty() ? Json() : parse_document(p.about);
  if (!about.is_object() || !about.contains("title") || !about["title"].is_string()) return "";
  return about["title"].get<std::string>();
}

}  // namespace bankshot::app::book
