// SPDX-License-Identifier: MIT
#include "support/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/plan/generate.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/scene/scene.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/legal.hpp"
#include "truth/claims.hpp"

namespace bankshot::test {
namespace {

constexpr double lost = 0.01;          // value that a wider puzzle may lose
constexpr double same_value = 1e-6;    // value difference allowed in the mirrored puzzle
constexpr double exactly = 1e-9;       // value, rad, m/s
constexpr double same_of_all = 1e-3;   // difference allowed between the best and the first of all
constexpr double same_launch = 1e-6;   // rad, m/s
constexpr double nothing_near = 1e-3;  // value that another launch may lose beside a far ball
constexpr double far_in_radii = 4;
constexpr int noisy_plays = 300, counted_plays = 2000, draws = 4096, leave_plays = 512;

struct Answered {
  Puzzle puzzle;
  Answer answer;
  bool solved() const { return !answer.shots.empty(); }
  const Shot& best() const { return answer.shots.front(); }
  /// Returns the value by which its best shot ranks: a shot that scratches comes after all others.
  double value() const { return value_of(answer) - (solved() && best().path.scratch ? 2 : 0); }
  double success() const {
    if (!solved()) return 0;
    return best().leave ? best().leave->success : best().robustness.success.value_or(0);
  }
  bool budget_ended() const {
    return answer.status == Status::budget || answer.message.find("budget") != std::string::npos;
  }
  /// Returns true when success is an integral; otherwise it is counted over draws.
  bool integrated() const { return !puzzle.errs_in_more() && !puzzle.leave; }
};

Answered answered(const Json& question, bool all = false) {
  Puzzle p = read_puzzle(question.dump());
  Answer a = solve(p, {.all = all, .suggest = false});
  return {std::move(p), std::move(a)};
}

/// Returns three standard errors of the difference of two successes that are counted over draws.
double three_errors(const Answered& a, const Answered& b) {
  const int count = a.puzzle.leave ? leave_plays : draws;
  const auto variance = [&](double p) { return std::max(p * (1 - p), 1.0 / count) / count; };
  return 3 * std::sqrt(variance(a.success()) + variance(b.success()));
}

Outcome outcome(std::vector<Json> questions, const std::vector<const Answered*>& answers) {
  Outcome o;
  o.judged = true;
  o.questions = std::move(questions);
  for (const Answered* a : answers) o.values.push_back(a->value());
  return o;
}

std::string words(const Answered& a) {
  if (!a.solved()) return fmt::format("{}: {}", name(a.answer.status), a.answer.message);
  const Shot& s = a.best();
  return fmt::format("{:.4f} at {:.4f} m/s, {:.4f} degrees, {} contacts, success {:.4f}, by {}", a.value(),
                     s.launch.speed, degrees(s.launch.angle), s.path.contacts(), a.success(), s.provenance.planner);
}

/// Records by how much `worse` is worse than `better`; fails beyond `allowed`.
void compare(Outcome& o, const Answered& better, const Answered& worse, double allowed) {
  // A shot that is hardly ever made may have a negative value, but it is still a shot.
  o.off = !better.solved()  ? 0
          : !worse.solved() ? std::max({better.value(), better.success(), 2 * allowed})
                            : better.value() - worse.value();
  o.failed = o.off > allowed;
  o.what = words(better) + "; then " + words(worse);
}

Outcome wider(const Case& c) {
  const Json wide = patched(c.question, c.change.at("patch"));
  const Answered narrow = answered(c.question);
  if (!narrow.solved()) return {};
  const Answered answer = answered(wide);
  if (answer.budget_ended()) return {};
  Outcome o = outcome({c.question, wide}, {&narrow, &answer});
  compare(o, narrow, answer, answer.integrated() ? lost : lost + three_errors(narrow, answer));
  o.what = c.change.value("way", "") + ": " + o.what;
  return o;
}

Outcome safest(const Case& c) {
  Json exact = c.question, moved = c.question;
  exact["aim"] = "centre", moved["aim"] = "safest";
  const Answered centre = answered(exact);
  if (!centre.solved()) return {};
  const Answered answer = answered(moved);
  Outcome o = outcome({exact, moved}, {&centre, &answer});
  compare(o, centre, answer, answer.integrated() ? exactly : three_errors(centre, answer));
  return o;
}

Outcome first_of_all(const Case& c) {
  const Answered best = answered(c.question), all = answered(c.question, true);
  if ((!best.solved() && !all.solved()) || best.budget_ended() || all.budget_ended()) return {};
  Outcome o = outcome({c.question}, {&best, &all});
  o.off = best.solved() && all.solved() ? std::abs(best.value() - all.value()) : 1;
  if (best.puzzle.prefer == Prefer::soft) o.off = std::abs(best.best().launch.speed - all.best().launch.speed);
  if (best.puzzle.prefer == Prefer::quick)
    o.off = std::abs(best.best().path.arrival.time - all.best().path.arrival.time);
  o.failed = o.off > same_of_all;
  o.what = words(best) + "; of all " + words(all);
  return o;
}

/// Compares two forms of one puzzle.
Outcome same(const Case& c, const Json& other, double allowed) {
  const Answered one = answered(c.question), two = answered(other);
  if (!one.solved() && !two.solved()) return {};
  Outcome o = outcome({c.question, other}, {&one, &two});
  o.off = one.solved() && two.solved() ? std::abs(one.value() - two.value()) : 1;
  o.what = words(one) + "; then " + words(two);
  o.failed = o.off > (one.integrated() ? allowed : three_errors(one, two));
  return o;
}

double aims_apart(double a, double b) { return std::abs(wrap_angle(a - b + radians(180)) - radians(180)); }

double launches_apart(const Shot& a, const Shot& b) {
  return std::max(aims_apart(a.launch.angle, b.launch.angle), std::abs(a.launch.speed - b.launch.speed));
}

Outcome other_order(const Case& c) {
  const Json other = reordered(c.question);
  const Answered one = answered(c.question), two = answered(other);
  if (!one.solved() && !two.solved()) return {};
  Outcome o = outcome({c.question, other}, {&one, &two});
  o.what = words(one) + "; then " + words(two);
  if (!one.solved() || !two.solved()) {
    o.off = 1, o.failed = true;
  } else if (one.puzzle.noise.at > 0) {  // each ball has other draws
    o.off = std::abs(one.value() - two.value());
    o.failed = o.off > three_errors(one, two) + lost;
  } else {
    o.off = std::max(std::abs(one.value() - two.value()), launches_apart(one.best(), two.best()));
    o.failed = o.off > exactly;
  }
  return o;
}

/// Straight pieces of the paths of all balls.
using Pieces = std::vector<std::pair<Vec2d, Vec2d>>;

void add_paths(const ShotRequest& played, Pieces& pieces) {
  constexpr double rate = 60;
  std::vector<std::optional<Vec2d>> last(1 + played.others.size());
  sample(played, simulate(played), rate, [&](double, int ball, const State<double>& s) {
    auto& before = last[static_cast<std::size_t>(ball)];
    if (!before || norm(s.at - *before) > 0) pieces.push_back({before.value_or(s.at), s.at});
    before = s.at;
  });
}

double distance(const Vec2d& at, const std::pair<Vec2d, Vec2d>& piece) {
  const Vec2d along = piece.second - piece.first;
  const double length2 = dot(along, along);
  const double share = length2 > 0 ? std::clamp(dot(at - piece.first, along) / length2, 0.0, 1.0) : 0;
  return norm(at - piece.first - along * share);
}

/// Returns the paths of all balls in the shot and in its noisy plays.
Pieces paths_of(const Answered& a) {
  Pieces pieces;
  const Puzzle& p = a.puzzle;
  add_paths({{}, p.table, p.physics, p.ball, p.others, a.best().launch, a.best().spin, {}}, pieces);
  Random random(1);
  for (int i = 0; i < noisy_plays; ++i)
    if (const auto played = noisy_play(p, a.best(), random)) add_paths(*played, pieces);
  return pieces;
}

bool far_from(const Vec2d& at, const Pieces& pieces, double distance_away) {
  return std::ranges::all_of(pieces, [&](const auto& piece) { return distance(at, piece) > distance_away; });
}

Outcome far_ball(const Case& c) {
  const Answered without = answered(c.question);
  if (!without.solved() || without.budget_ended()) return {};
  const Vec2d at{c.change["at"][0], c.change["at"][1]};
  if (!far_from(at, paths_of(without), far_in_radii * without.puzzle.ball.body.radius)) return {};
  Json with = c.question;
  with["others"].push_back({{"id", "far"}, {"at", c.change["at"]}});
  if (!valid_puzzle(with)) return {};
  const Answered answer = answered(with);
  Outcome o = outcome({c.question, with}, {&without, &answer});
  const bool another = answer.solved() && launches_apart(without.best(), answer.best()) > same_launch;
  const double allowed = another ? nothing_near : lost;
  compare(o, without, answer, answer.integrated() ? allowed : allowed + three_errors(without, answer));
  return o;
}

Outcome in_50_digits(const Case& c) {
  const Answered a = answered(c.question);
  Outcome o = outcome({c.question}, {&a});
  if (!a.solved()) {
    o.off = 1, o.failed = true, o.what = "no longer solved: " + a.answer.message;
    return o;
  }
  for (const truth::Check& claim : truth::check(&a.puzzle, a.answer.id, a.answer)) {
    if (claim.holds()) continue;
    o.failed = true;
    o.off = 1;
    o.what += fmt::format("{}{}: {}", o.what.empty() ? "" : "; ", truth::name(claim.claim), claim.what);
  }
  return o;
}

Outcome plays(const Case& c) {
  const Answered a = answered(c.question);
  if (!a.solved()) return {};
  Outcome o = outcome({c.question}, {&a});
  const double share = share_of_plays(a.puzzle, a.best(), counted_plays, 1), success = a.success();
  const double p = std::clamp((share + success) / 2, 1.0 / counted_plays, 1 - 1.0 / counted_plays);
  const double variance = p * (1 - p) / counted_plays + (a.integrated() ? 0 : p * (1 - p) / draws);
  o.values = {success, share};
  o.off = std::abs(share - success);
  o.failed = o.off > 4 * std::sqrt(variance) + 0.005;
  o.what = fmt::format("success {:.4f}, of plays {:.4f}: {}", success, share, words(a));
  return o;
}

/// Draws a puzzle of a kind that `generate` knows.
std::optional<Json> generated(Random& r, const QuestionWish& wish) {
  constexpr const char* tables[] = {"pool-9ft", "pool-7ft", "snooker-12ft", "carom-10ft"};
  constexpr const char* physics[] = {"spin", "spin", "spin", "rolling", "ideal"};
  const Scene scene = read_scene(Json(tables[r.integer(0, 3)]).dump(), Json(physics[r.integer(0, 4)]).dump());
  Wish asked{.table = scene.table, .physics = scene.physics, .ball = scene.ball};
  using Kind = Wish::Kind;
  constexpr Kind kinds[] = {Kind::pocket, Kind::stop, Kind::pass, Kind::kick, Kind::pot, Kind::carom};
  asked.kind = kinds[r.integer(0, 5)];
  const bool none = scene.table.pockets.empty() && (asked.kind == Kind::pocket || asked.kind == Kind::pot);
  if (none || (asked.kind == Kind::stop && is_ideal(scene.physics))) return {};
  const int cushions = r.integer(0, wish.quick ? 1 : 2);
  asked.cushions = {0, cushions, {}};
  if (asked.kind == Kind::pot) asked.then = r.chance(0.3) ? CushionRule{1, 1, {}} : CushionRule{0, 0, {}};
  if (r.chance(0.5)) asked.others = r.integer(1, std::min(4, wish.most_balls));
  asked.tries = 20;
  const auto made = generate(asked, r);
  if (!made) return {};
  return Json::parse(write_puzzle(made->puzzle));
}

bool names_its_ball(const Json& question) {
  const Json& target = question.at("target");
  return !target.contains("ball") || (target["ball"].is_string() && target["ball"] != "any");
}

std::optional<Case> far_case(Random& r, const Json& question) {
  if (!names_its_ball(question) || is_ideal(valid_puzzle(question)->physics)) return {};  // no ball rests there
  const Answered a = answered(question);
  if (!a.solved() || a.budget_ended()) return {};
  const Pieces pieces = paths_of(a);
  std::vector<Ball> standing = a.puzzle.others;
  standing.push_back(a.puzzle.ball);
  for (int tries = 0; tries < 60; ++tries) {
    const Body& body = a.puzzle.ball.body;
    const auto at = free_place(r, a.puzzle.table, standing, body);
    if (at && far_from(*at, pieces, far_in_radii * body.radius)) return Case{'f', question, {{"at", {at->x, at->y}}}};
  }
  return {};
}

constexpr const char* mirrors[] = {"x", "y", "both"};

Mirrored mirror_of(const Case& c) {
  const std::string how = c.change.at("mirror");
  return how == "x" ? Mirrored::x : how == "y" ? Mirrored::y : Mirrored::both;
}

bool is_whole(const Json& question) {
  const auto puzzle = valid_puzzle(question);
  return puzzle && !(is_ideal(puzzle->physics) && is_ball(puzzle->target));
}

}  // namespace

std::string_view about(char property) {
  switch (property) {
    case 'a':
      return "a wider question";
    case 'b':
      return "safest against centre";
    case 'c':
      return "first of all";
    case 'd':
      return "mirror images";
    case 'e':
      return "order of others";
    case 'f':
      return "a ball far away";
    case 'g':
      return "generate in 50 digits";
    default:
      return "success by plays";
  }
}

double value_of(const Answer& answer) {
  if (answer.shots.empty()) return 0;
  const Shot& best = answer.shots.front();
  return best.robustness.value ? *best.robustness.value : best.robustness.success.value_or(0) - cost_of(best);
}

std::optional<Case> random_case(char property, Random& r, const QuestionWish& usual) {
  QuestionWish wish = usual;
  wish.robust_only = wish.robust_only || property == 'a' || property == 'b';
  if (property == 'g') {
    auto question = generated(r, wish);
    return question ? std::optional(Case{'g', std::move(*question)}) : std::nullopt;
  }
  Json question = random_question(r, wish);
  switch (property) {
    case 'a': {
      const auto widening = random_widening(r, question);
      if (!widening) return {};
      return Case{'a', widening->narrow, {{"way", widening->way}, {"patch", widening->patch}}};
    }
    case 'd':
      return Case{'d', std::move(question), {{"mirror", mirrors[r.integer(0, 2)]}}};
    case 'e':
      if (question["others"].size() < 2) return {};
      break;
    case 'f':
      return far_case(r, question);
    case 'h':
      // No ball rests in ideal physics, so no time is known after which the cue ball cannot fall.
      if (!is_whole(question)) return {};
      break;
    default:
      break;
  }
  return Case{property, std::move(question)};
}

Outcome check(const Case& c) {
  switch (c.property) {
    case 'a':
      return wider(c);
    case 'b':
      return safest(c);
    case 'c':
      return first_of_all(c);
    case 'd':
      return same(c, mirrored(c.question, mirror_of(c)), same_value);
    case 'e':
      return other_order(c);
    case 'f':
      return far_ball(c);
    case 'g':
      return in_50_digits(c);
    default:
      return plays(c);
  }
}

}  // namespace bankshot::test
