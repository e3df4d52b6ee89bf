// SPDX-License-Identifier: MIT
#include "support/changed_question.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bankshot::test {
namespace {

double hundredths(double v) { return std::round(v * 100) / 100; }

Json bounds(int min, int max) { return {{"min", min}, {"max", max}}; }

/// Draws a rule for at most two cushions, and a wider rule.
std::pair<Json, Json> narrow_and_wide_rule(Random& r, const Table& table) {
  Json narrow = random_cushion_rule(r, table, 2);
  int min = 0, max = 0;
  if (narrow.is_array())
    min = max = static_cast<int>(narrow.size());
  else if (narrow.is_number())
    min = max = narrow.get<int>();
  else
    min = narrow["min"], max = narrow["max"];
  const bool same = narrow.is_array() && !narrow.empty() && r.chance(0.3);  // any cushions, but as many
  if (same) return {narrow, bounds(min, max)};
  const int low = r.integer(0, min);
  return {narrow, bounds(low, r.integer(low < min ? max : max + 1, 3))};
}

class Narrower {
 public:
  Narrower(Random& r, const Json& question) : r_(r), p_(*valid_puzzle(question)), out_{"", question, Json::object()} {}

  std::optional<Widening> by(std::string_view way) {
    out_.way = way;
    out_.narrow["aim"] = aim_of(p_) == Aim::safest ? "safest" : "centre";
    const bool done = way == "speed"           ? speed()
                      : way == "angle"         ? angle()
                      : way == "spin"          ? spin()
                      : way == "arrive"        ? arrive()
                      : way == "cushions"      ? cushions()
                      : way == "then_cushions" ? then_cushions()
                      : way == "ball"          ? ball()
                      : way == "pocket"        ? pocket()
                                               : budget();
    if (!done || !valid_puzzle(out_.narrow) || !valid_puzzle(patched(out_.narrow, out_.patch))) return {};
    return out_;
  }

 private:
  bool speed() {
    if (is_ideal(p_.physics)) return false;  // the speed only affects the cost there
    const double low = hundredths(r_.log_uniform(0.3, 5)), high = hundredths(std::min(10.0, low * r_.uniform(1.05, 3)));
    const bool fixed = aim_of(p_) == Aim::safest && r_.chance(0.15);
    if (fixed) out_.narrow.erase("arrive");
    out_.narrow["speed"] = fixed ? Json(low) : Json{low, high};
    out_.patch["speed"] = nullptr;
    if (r_.chance(0.5))
      out_.patch["speed"] = {hundredths(std::max(0.1, low * r_.uniform(0.3, 1))),
                             hundredths(std::min(10.0, high * r_.uniform(1, 2)) + 0.01)};
    return true;
  }

  bool angle() {
    const auto& others = p_.others;
    const auto k = static_cast<std::size_t>(r_.integer(0, static_cast<int>(others.size())));
    const Vec2d d = k < others.size() ? others[k].at - p_.ball.at : direction(r_.uniform(0, 2 * std::numbers::pi));
    const double middle = std::round(degrees(wrap_angle(std::atan2(d.y, d.x)))), half = r_.integer(5, 60);
    out_.narrow["angle"] = {middle - half, middle + half};
    out_.patch["angle"] = nullptr;
    if (r_.chance(0.6)) out_.patch["angle"] = {middle - half - r_.integer(0, 60), middle + half + r_.integer(5, 60)};
    return true;
  }

  bool spin() {
    if (!carries_spin(p_.physics)) return false;
    const double top = r_.chance(0.5) ? 0 : hundredths(r_.uniform(-0.8, 0.8)),
                 side = r_.chance(0.5) ? 0 : hundredths(r_.uniform(-0.8, 0.8));
    out_.narrow["ball"]["spin"] = {{"top", top}, {"side", side}};
    const auto around = [&](double v) {
      return Json{hundredths(v - r_.uniform(0, 0.6)), hundredths(v + r_.uniform(0.1, 0.6))};
    };
    Json& wide = out_.patch["ball"]["spin"] = Json::object();
    if (r_.chance(0.7)) wide["top"] = around(top);
    if (wide.empty() || r_.chance(0.4)) wide["side"] = around(side);
    return true;
  }

  bool arrive() {
    const auto asked = arrival_range(p_);
    if (is_ideal(p_.physics) || (asked && asked->high == 0)) return false;
    if (p_.speed.fixed()) out_.narrow.erase("speed");
    const double low = hundredths(r_.uniform(0.2, 2)),
                 high = r_.chance(0.3) ? low : hundredths(low + r_.uniform(0.1, 1));
    out_.narrow["arrive"]["speed"] = {low, high};
    out_.patch["arrive"]["speed"] = {hundredths(low * r_.uniform(0.3, 1)), hundredths(high + r_.uniform(0.1, 3))};
    return true;
  }

  bool cushions() {
    std::tie(out_.narrow["cushions"], out_.patch["cushions"]) = narrow_and_wide_rule(r_, p_.table);
    return true;
  }

  bool then_cushions() {
    Json& target = out_.narrow["target"];
    if (!target.contains("then")) return false;
    // Without a rule, every fall into a pocket counts, and nothing is wider; so the wide puzzle has a rule too.
    auto [narrow, wide] = narrow_and_wide_rule(r_, p_.table);
    target["then"]["cushions"] = narrow;
    out_.patch["target"]["then"]["cushions"] = wide;
    return true;
  }

  bool ball() {
    Json& target = out_.narrow["target"];
    if (!target.contains("ball") || p_.others.size() < 2) return false;
    if (!target["ball"].is_string() || target["ball"] == "any")
      target["ball"] = std::to_string(r_.integer(1, static_cast<int>(p_.others.size())));
    out_.patch["target"]["ball"] = "any";
    return true;
  }

  bool pocket() {
    if (!is_pocket(p_.target)) return false;
    const auto n = static_cast<int>(p_.table.pockets.size());
    const std::string name = p_.table.pockets[static_cast<std::size_t>(r_.integer(0, n - 1))].name;
    Json *narrow = &out_.narrow["target"], *patch = &out_.patch["target"];
    while (narrow->contains("then")) narrow = &(*narrow)["then"], patch = &(*patch)["then"];
    (*narrow)["pocket"] = name;
    (*patch)["pocket"] = "any";
    return true;
  }

  bool budget() {
    const int few = static_cast<int>(std::round(r_.log_uniform(500, 20000)));
    out_.narrow["budget"]["simulations"] = few;
    out_.patch["budget"]["simulations"] = r_.chance(0.5) ? few * r_.integer(2, 10) : 100000;
    return true;
  }

  Random& r_;
  const Puzzle p_;
  Widening out_;
};

constexpr std::string_view ways[] = {"speed",         "angle", "spin",   "arrive", "cushions",
                                     "then_cushions", "ball",  "pocket", "budget"};

/// A mirror of a scene.
struct Mirror {
  Mirrored how;
  Vec2d sum;  ///< coordinates of a place plus those of its image [m]

  bool swaps_x() const { return how != Mirrored::y; }
  bool swaps_y() const { return how != Mirrored::x; }
  bool flips() const { return how != Mirrored::both; }

  Json place(const Json& at) const {
    const double x = at[0], y = at[1];
    return {swaps_x() ? sum.x - x : x, swaps_y() ? sum.y - y : y};
  }
  /// Mirrors the name of a cushion or pocket of a rectangle: swaps bottom and top, left and right.
  std::string name(std::string name) const {
    const auto swap = [&](const std::string& a, const std::string& b) {
      const auto at = name.find(a), other = name.find(b);
      if (at != std::string::npos)
        name.replace(at, a.size(), b);
      else if (other != std::string::npos)
        name.replace(other, b.size(), a);
    };
    if (swaps_y()) swap("bottom", "top");
    if (swaps_x()) swap("left", "right");
    return name;
  }
  Json negative(const Json& v) const {
    if (!flips()) return v;
    const auto minus = [](double x) { return x == 0 ? 0.0 : -x; };
    return v.is_array() ? Json{minus(v[1]), minus(v[0])} : Json(minus(v.get<double>()));
  }
  void rule(Json& holder) const {
    if (!holder.contains("cushions") || !holder["cushions"].is_array()) return;
    for (Json& cushion : holder["cushions"]) cushion = name(cushion);
  }
  void target(Json& t) const {
    if (t.contains("point")) t["point"] = place(t["point"]);
    if (t.contains("pocket")) t["pocket"] = name(t["pocket"]);
    if (t.contains("cut")) t["cut"] = negative(t["cut"]);
    rule(t);
    if (t.contains("then")) target(t["then"]);
  }
  void table(Json& t) const {
    if (!t.is_object()) return;
    if (t.contains("tilt"))
      t["tilt"] = {(swaps_x() ? -1 : 1) * t["tilt"][0].get<double>(),
                   (swaps_y() ? -1 : 1) * t["tilt"][1].get<double>()};
    if (t.contains("cushions")) {
      Json own = Json::object();
      for (const auto& [rail, of_it] : t["cushions"].items()) own[name(rail)] = of_it;
      t["cushions"] = own;
    }
    if (t.contains("vertices")) polygon(t);
    if (t.contains("pockets") && t["pockets"].is_array())
      for (Json& pocket : t["pockets"]) pocket["at"] = place(pocket["at"]);
  }
  /// Mirrors a polygon; each name stays with the edge it names.
  void polygon(Json& t) const {
    for (Json& v : t["vertices"]) v = place(v);
    if (!flips()) return;
    std::reverse(t["vertices"].begin(), t["vertices"].end());
    // Edge i ran from vertex i to i + 1; after the reversal it is edge n − 2 − i.
    auto& names = t["names"];
    std::reverse(names.begin(), names.end());
    std::rotate(names.begin(), names.begin() + 1, names.end());
  }
};

double mirrored_degrees(double aim, Mirrored how) {
  return how == Mirrored::x ? 180 - aim : how == Mirrored::y ? -aim : aim + 180;
}

}  // namespace

Json patched(Json question, const Json& patch) {
  question.merge_patch(patch);
  return question;
}

std::optional<Widening> random_widening(Random& r, const Json& question, std::string_view way) {
  if (way.empty()) way = ways[r.integer(0, static_cast<int>(std::size(ways)) - 1)];
  return Narrower(r, question).by(way);
}

Json mirrored(const Json& question, Mirrored how) {
  const Puzzle p = *valid_puzzle(question);
  // A rectangle is mirrored onto itself, a polygon to the other side of the origin.
  const bool polygon = question["table"].contains("vertices");
  const Mirror m{how, polygon ? Vec2d{} : p.table.highest()};
  Json out = question;
  m.table(out["table"]);
  Json& ball = out["ball"];
  ball["at"] = m.place(ball["at"]);
  if (ball.contains("spin"))
    for (const char* key : {"side", "masse"})
      if (ball["spin"].contains(key)) ball["spin"][key] = m.negative(ball["spin"][key]);
  if (out.contains("others"))
    for (Json& other : out["others"]) other["at"] = m.place(other["at"]);
  m.target(out["target"]);
  if (out.contains("leave")) m.target(out["leave"]);
  m.rule(out);
  if (out.contains("angle")) {
    double from = mirrored_degrees(out["angle"][0], how), to = mirrored_degrees(out["angle"][1], how);
    if (m.flips()) std::swap(from, to);
    out["angle"] = {from, to};
  }
  return out;
}

double mirrored_aim(double aim, Mirrored how) { return wrap_angle(radians(mirrored_degrees(degrees(aim), how))); }

Json reordered(Json question) {
  if (question.contains("others")) std::reverse(question["others"].begin(), question["others"].end());
  return question;
}

}  // namespace bankshot::test
