// SPDX-License-Identifier: MIT
#include "support/random_question.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/json.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {
namespace {

double rounded(double v, double unit) { return std::round(v / unit) / std::round(1 / unit); }
double hundredths(double v) { return rounded(v, 0.01); }

template <class T>
const T& one_of(Random& r, const std::vector<T>& all) {
  return all[static_cast<std::size_t>(r.integer(0, static_cast<int>(all.size()) - 1))];
}

Json rectangle(Random& r) {
  const double length = hundredths(r.uniform(1, 3.5));
  Json table{{"length", length}, {"width", hundredths(length * r.uniform(0.4, 0.8))}};
  if (r.chance(0.2)) return table;
  table["pockets"] = "six";
  if (r.chance(0.6)) table["jaws"] = true;
  if (r.chance(0.3))
    table["mouth"] = {{"corner", in_millimetres(r.uniform(0.1, 0.14))},
                      {"middle", in_millimetres(r.uniform(0.12, 0.15))}};
  return table;
}

/// Draws a polygon whose cushions have names, so that it can be mirrored, and round pockets at some of its corners.
Json polygon(Random& r) {
  const Table drawn = random_polygon(r, r.chance(0.6));
  Json table{{"vertices", Json::array()}, {"names", Json::array()}};
  for (std::size_t i = 0; i < drawn.vertices.size(); ++i) {
    const Vec2d& v = drawn.vertices[i];
    table["vertices"].push_back({in_millimetres(v.x), in_millimetres(v.y)});
    table["names"].push_back("rail-" + std::to_string(i));
  }
  if (r.chance(0.4)) return table;
  Json pockets = Json::array();
  for (std::size_t i = 0; i < drawn.vertices.size(); i += static_cast<std::size_t>(r.integer(1, 2)))
    pockets.push_back({{"name", "pocket-" + std::to_string(i)},
                       {"at", table["vertices"][i]},
                       {"radius", in_millimetres(r.uniform(0.06, 0.1))}});
  table["pockets"] = pockets;
  return table;
}

Json random_table(Random& r, bool quick) {
  static const std::vector<std::string> presets{"pool-7ft",     "pool-8ft",   "pool-9ft", "pool-9ft",
                                                "snooker-12ft", "carom-10ft", "seed"};
  static const std::vector<std::string> with_pockets{"pool-7ft", "pool-8ft", "pool-9ft", "snooker-12ft"};
  const double kind = r.uniform(0, 1);
  Json table;
  if (kind < 0.6)
    table = {{"preset", one_of(r, presets)}};
  else if (kind < 0.75)
    table = {{"preset", one_of(r, with_pockets)}, {"jaws", false}};
  else if (kind < 0.9 || quick)
    table = rectangle(r);
  else
    table = polygon(r);
  if (!quick && r.chance(0.04)) table["tilt"] = {rounded(r.uniform(-1, 1) * 3e-3, 1e-4), 0.001};
  if (!quick && !table.contains("vertices") && r.chance(0.04))
    table["cushions"] = {{"top", {{"restitution", hundredths(r.uniform(0.6, 0.95))}}}};
  return table.size() == 1 && table.contains("preset") ? table["preset"] : table;
}

Json random_physics(Random& r, bool quick) {
  const double kind = r.uniform(0, 1);
  if (kind < 0.65) return "spin";
  if (kind < 0.78) return "rolling";
  if (kind < 0.86) return "ideal";
  if (kind < 0.93 || quick)
    return {{"model", "spin"},
            {"sliding_friction", hundredths(r.uniform(0.12, 0.3))},
            {"cushion", {{"restitution", hundredths(r.uniform(0.7, 0.95))}}}};
  if (kind < 0.97) return {{"model", "spin"}, {"cushion", {{"model", "stronge"}}}};
  if (kind < 0.98) return {{"model", "spin"}, {"cushion", {{"model", "mathavan2010"}}}};
  return {{"model", "rolling"}, {"friction", rounded(r.uniform(0.005, 0.03), 1e-3)}};
}

bool stands(const Table& table, std::span<const Ball> others, const Body& body, const Vec2d& at) {
  const Boundary boundary(table, body);
  const auto apart = [&](const Ball& b) { return norm(b.at - at) >= touching_distance(b.body, body); };
  return boundary.clearance(at) >= 0 && !boundary.pocket_around(at) && std::ranges::all_of(others, apart);
}

/// Draws a place beside another ball or at a cushion, touching it.
Vec2d touching(Random& r, const Table& table, std::span<const Ball> others, const Body& body) {
  const Vec2d low = table.lowest(), high = table.highest();
  if (others.empty() || r.chance(0.7))
    return {in_millimetres(r.uniform(low.x, high.x)), r.chance(0.5) ? low.y + body.radius : high.y - body.radius};
  return others.back().at + Vec2d{r.chance(0.5) ? 1.0 : -1.0, 0.0} * touching_distance(others.back().body, body);
}

/// Places the cue ball and the others in the puzzle and in the scene; returns false when there is no space.
bool place_balls(Random& r, const QuestionWish& wish, Puzzle& scene, Json& question) {
  const int count = wish.quick                              ? r.integer(1, 2)
                    : wish.most_balls > 3 && r.chance(0.05) ? r.integer(4, wish.most_balls)
                                                            : r.integer(1, std::min(3, wish.most_balls));
  std::vector<Ball> standing;
  const auto place = [&](const Body& body) -> std::optional<Vec2d> {
    if (!wish.quick && r.chance(0.05))
      if (const Vec2d at = touching(r, scene.table, standing, body); stands(scene.table, standing, body, at)) return at;
    return free_place(r, scene.table, standing, body);
  };
  Json& ball = question["ball"];
  if (!wish.quick && r.chance(0.04)) {
    ball["radius"] = scene.ball.body.radius = in_millimetres(r.uniform(0.024, 0.031));
    ball["mass"] = scene.ball.body.mass = hundredths(r.uniform(0.1, 0.25));
  }
  const bool sizes = !wish.quick && r.chance(0.04);
  for (int k = 0; k <= count; ++k) {
    Body body = scene.ball.body;
    Json other{{"id", std::to_string(k)}};
    if (sizes && k > 0) {
      other["radius"] = body.radius = in_millimetres(body.radius * r.uniform(0.9, 1.1));
      other["mass"] = body.mass = hundredths(r.uniform(0.1, 0.25));
    }
    const auto at = place(body);
    if (!at) return false;
    standing.push_back({*at, body, std::to_string(k)});
    (k == 0 ? ball : other)["at"] = {at->x, at->y};
    if (k > 0) question["others"].push_back(other);
  }
  scene.ball.at = standing.front().at;
  scene.others.assign(standing.begin() + 1, standing.end());
  return true;
}

Json random_point(Random& r, const Puzzle& scene) {
  const auto at = free_place(r, scene.table, scene.others, scene.ball.body);
  Json point{{"point", at ? Json{at->x, at->y} : Json{0, 0}}};
  if (r.chance(0.7)) point["within"] = hundredths(r.uniform(0.02, 0.15));
  return point;
}

Json random_pocket(Random& r, const Table& table) {
  const int n = static_cast<int>(table.pockets.size());
  return r.chance(0.4) ? Json("any") : Json(table.pockets[static_cast<std::size_t>(r.integer(0, n - 1))].name);
}

Json random_ball(Random& r, int count) {
  if (count > 1 && r.chance(0.25)) return "any";
  if (count > 2 && r.chance(0.1)) return {"1", "2"};
  return std::to_string(r.integer(1, count));
}

/// Draws what an object ball is to do: fall into a pocket or reach a point.
Json random_then(Random& r, const Puzzle& scene) {
  const bool pot = !scene.table.pockets.empty() && r.chance(0.85);
  Json then = pot ? Json{{"pocket", random_pocket(r, scene.table)}} : random_point(r, scene);
  if (r.chance(0.35))
    then["cushions"] = r.chance(0.5) ? Json{{"max", r.integer(1, 2)}} : random_cushion_rule(r, scene.table, 2);
  return then;
}

Json random_contact(Random& r, Json target) {
  if (r.chance(0.25)) target["cut"] = r.integer(-60, 60);
  if (r.chance(0.2)) target["within"] = r.integer(3, 30);
  return target;
}

Json random_target(Random& r, const Puzzle& scene) {
  const int count = static_cast<int>(scene.others.size());
  const bool pockets = !scene.table.pockets.empty();
  const double kind = r.uniform(0, 1);
  if (kind < 0.12 && pockets) return {{"pocket", random_pocket(r, scene.table)}};
  if (kind < 0.2) return random_point(r, scene);
  if (kind < 0.32) return random_contact(r, {{"ball", random_ball(r, count)}});
  if (kind < 0.42 && count > 1) return random_contact(r, {{"carom", r.chance(0.5) ? Json{"1", "2"} : Json{"2", "1"}}});
  if (kind < 0.45 && count > 1) return {{"ball", "1"}, {"then", {{"ball", "2"}, {"then", random_then(r, scene)}}}};
  return {{"ball", random_ball(r, count)}, {"then", random_then(r, scene)}};
}

Json random_noise(Random& r, const Puzzle& scene, bool quick) {
  static const std::vector<std::string> players{"pro", "league", "beginner"};
  const bool spin = carries_spin(scene.physics);
  if (!quick && spin && r.chance(0.35)) return one_of(r, players);
  Json noise{{"angle", rounded(r.log_uniform(0.03, 0.6), 1e-3)}, {"speed", rounded(r.log_uniform(0.02, 0.2), 1e-3)}};
  if (r.chance(0.3)) noise["speed_share"] = hundredths(r.uniform(0.01, 0.1));
  if (!quick && spin && r.chance(0.15)) noise["side"] = 0.03, noise["top"] = 0.05;
  if (!quick && r.chance(0.1)) noise["at"] = 0.001;
  return noise;
}

/// Draws a spin whose tip is on the ball; some of it may be a range.
Json random_spin(Random& r) {
  Json spin{{"top", rounded(r.uniform(-1, 1.2), 0.1)}, {"side", rounded(r.uniform(-1, 1), 0.1)}};
  if (r.chance(0.1)) spin["masse"] = rounded(r.uniform(-0.5, 0.5), 0.1);
  if (r.chance(0.3)) spin["top"] = {rounded(r.uniform(-1, 0), 0.1), rounded(r.uniform(0.1, 1), 0.1)};
  if (r.chance(0.15)) spin["side"] = {rounded(r.uniform(-0.8, 0), 0.1), rounded(r.uniform(0.1, 0.8), 0.1)};
  return spin;
}

void add_bounds(Random& r, const QuestionWish& wish, const Puzzle& scene, Json& question) {
  const bool fixed = r.chance(0.06);
  if (r.chance(0.2)) {
    const double low = hundredths(r.log_uniform(0.2, 3)), high = hundredths(std::min(10.0, low * r.uniform(1.3, 4)));
    question["speed"] = {low, high};
  }
  if (fixed) question["speed"] = hundredths(r.log_uniform(0.5, 6));
  if (!fixed && !is_ideal(scene.physics) && r.chance(0.12)) {
    const double low = hundredths(r.uniform(0.2, 1.5));
    question["arrive"] = {{"speed", r.chance(0.3) ? Json(low) : Json{low, hundredths(low + r.uniform(0.3, 2))}}};
  }
  if (r.chance(0.1)) {
    const double from = r.integer(0, 359);
    question["angle"] = {from, from + r.integer(60, 240)};
  }
  if (carries_spin(scene.physics) && r.chance(0.35)) question["ball"]["spin"] = random_spin(r);
  if (r.chance(0.3)) question["noise"] = random_noise(r, scene, wish.quick);
  if (!wish.robust_only && r.chance(0.06)) question["prefer"] = r.chance(0.5) ? "soft" : "quick";
  if (r.chance(0.1)) question["aim"] = r.chance(0.5) ? "centre" : "safest";
}

/// Adds a leave, or turns the puzzle into one of a game.
void add_leave(Random& r, const Puzzle& scene, Json& question) {
  const int count = static_cast<int>(scene.others.size());
  const double kind = r.uniform(0, 1);
  if (kind < 0.2 && !scene.table.pockets.empty()) {
    question["target"] = {{"game", r.chance(0.5) ? "rotation" : "any"}};
    for (const char* key : {"prefer", "arrive", "cushions"}) question.erase(key);
    return;
  }
  if (kind < 0.6)
    question["leave"] = random_point(r, scene);
  else if (kind < 0.85 && !scene.table.pockets.empty())
    question["leave"] = {{"for", std::to_string(r.integer(1, count))}};
  else
    question["leave"] = {{"safe", {std::to_string(r.integer(1, count))}}};
}

std::optional<Json> try_question(Random& r, const QuestionWish& wish) {
  Json question{{"table", random_table(r, wish.quick)}, {"physics", random_physics(r, wish.quick)}};
  Scene scene;
  try {
    scene = read_scene(question["table"].dump(), question["physics"].dump());
  } catch (const InvalidInput&) {
    return {};
  }
  Puzzle placed{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  if (!place_balls(r, wish, placed, question)) return {};
  question["target"] = random_target(r, placed);
  const bool sends = question["target"].contains("then");
  if (r.chance(sends ? 0.35 : 0.1))
    question["cushions"] = 0;
  else if (r.chance(0.25))
    question["cushions"] = random_cushion_rule(r, placed.table, 2);
  if (question["target"].contains("carom") && r.chance(0.15)) question["cushions"] = {{"min", 2}, {"max", 4}};
  add_bounds(r, wish, placed, question);
  if (wish.leaves) add_leave(r, placed, question);
  if (wish.quick) question["budget"] = {{"simulations", 20000}};
  return question;
}

}  // namespace

double in_millimetres(double metres) { return rounded(metres, 1e-3); }

Json random_cushion_rule(Random& r, const Table& table, int most) {
  const int n = r.integer(0, most);
  if (r.chance(0.4)) return n;
  if (r.chance(0.6)) return {{"min", n}, {"max", r.integer(n, most)}};
  Json names = Json::array();
  for (int i = 0; i < n; ++i) names.push_back(one_of(r, table.cushions));
  return names;
}

std::optional<Vec2d> free_place(Random& r, const Table& table, std::span<const Ball> others, const Body& body) {
  const Vec2d low = table.lowest(), high = table.highest();
  for (int i = 0; i < 100; ++i) {
    const Vec2d at{in_millimetres(r.uniform(low.x, high.x)), in_millimetres(r.uniform(low.y, high.y))};
    if (stands(table, others, body, at)) return at;
  }
  return {};
}

std::optional<Puzzle> valid_puzzle(const Json& question) {
  try {
    Puzzle p = read_puzzle(question.dump());
    validate(p);
    return p;
  } catch (const InvalidInput&) {
    return {};
  }
}

Json random_question(Random& r, const QuestionWish& wish) {
  for (;;)
    if (const auto question = try_question(r, wish); question && valid_puzzle(*question)) return *question;
}

}  // namespace bankshot::test
