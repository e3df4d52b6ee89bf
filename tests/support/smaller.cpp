// SPDX-License-Identifier: MIT
//
// Makes a counterexample smaller, change by change, as long as it still fails.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/properties.hpp"

namespace bankshot::test {
namespace {

using Change = std::function<void(Json& question)>;

/// Returns true when the target names this ball.
bool names(const Json& target, const Json& id) {
  if (target.is_array() || target.is_object())
    return std::ranges::any_of(target, [&](const Json& inner) { return names(inner, id); });
  return target == id;
}

void round_to(Json& v, double unit) {
  if (v.is_array())
    for (Json& each : v) round_to(each, unit);
  else if (v.is_number_float())
    v = std::round(v.get<double>() / unit) / std::round(1 / unit);
}

std::vector<Change> changes(const Json& question) {
  std::vector<Change> out;
  if (question.contains("others"))
    for (const Json& other : question["others"]) {
      const Json id = other["id"];
      if (names(question["target"], id)) continue;
      out.push_back([id](Json& q) {
        auto& all = q["others"];
        all.erase(std::remove_if(all.begin(), all.end(), [&](const Json& each) { return each["id"] == id; }),
                  all.end());
        if (all.empty()) q.erase("others");
      });
    }
  for (const char* key : {"noise", "arrive", "angle", "speed", "cushions", "prefer", "budget", "aim"})
    if (question.contains(key)) out.push_back([key](Json& q) { q.erase(key); });
  for (const char* key : {"spin", "radius", "mass"})
    if (question["ball"].contains(key)) out.push_back([key](Json& q) { q["ball"].erase(key); });
  if (question["table"].is_object() && question["table"].contains("preset"))
    out.push_back([](Json& q) { q["table"] = Json(q["table"].at("preset")); });
  if (question["table"].is_object())
    for (const char* key : {"tilt", "cushions", "mouth", "jaws"})
      if (question["table"].contains(key))
        out.push_back([key](Json& q) {
          if (q["table"].is_object()) q["table"].erase(key);
        });
  if (question["physics"].is_object()) out.push_back([](Json& q) { q["physics"] = Json(q["physics"].at("model")); });
  if (question["physics"] != "rolling") out.push_back([](Json& q) { q["physics"] = "rolling"; });
  for (const double unit : {0.1, 0.01}) {
    out.push_back([unit](Json& q) {
      round_to(q["ball"]["at"], unit);
      if (q.contains("others"))
        for (Json& other : q["others"]) round_to(other["at"], unit);
      for (const char* key : {"speed", "arrive"})
        if (q.contains(key)) round_to(key == std::string("arrive") ? q[key]["speed"] : q[key], unit);
    });
    out.push_back([unit](Json& q) { round_to(q["ball"]["at"], unit); });
    for (std::size_t i = 0; question.contains("others") && i < question["others"].size(); ++i)
      out.push_back([unit, i](Json& q) {
        if (i < q["others"].size()) round_to(q["others"][i]["at"], unit);
      });
  }
  return out;
}

/// Returns true when the case still fails, at least half as badly.
bool fails(const Case& c, double off) {
  constexpr double share = 0.5;
  try {
    const Outcome o = check(c);
    return o.failed && o.off >= share * off;
  } catch (const std::exception&) {
    return false;
  }
}

bool is_valid(const Case& c) {
  return valid_puzzle(c.question) &&
         (!c.change.contains("patch") || valid_puzzle(patched(c.question, c.change["patch"])));
}

}  // namespace

Case smaller(Case failing, double off, int most) {
  int used = 0;
  for (bool changed = true; changed && used < most;) {
    changed = false;
    for (const Change& change : changes(failing.question)) {
      Case next = failing;
      change(next.question);
      if (next.question == failing.question || !is_valid(next)) continue;
      if (used++ >= most) break;
      if (!fails(next, off)) continue;
      failing = std::move(next);
      changed = true;
    }
  }
  return failing;
}

}  // namespace bankshot::test
