// SPDX-License-Identifier: MIT
//
// Method: draw a ball and a launch, simulate, ask where the ball got to (or draw a target for a wished sequence), round
// the numbers, solve.
// Cost: a few simulations per draw, one search per try.
// Guarantee: a puzzle that is returned was solved as it will be read.
#include "bankshot/plan/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/planner.hpp"

namespace bankshot {
namespace {

constexpr long draws_a_try = 50;

double rounded(double x, double unit) { return std::round(x / unit) / std::round(1 / unit); }

/// Returns a thousandth of the power of ten below the diagonal: millimetres on any playable table.
double unit_of(const Table& table) { return std::pow(10, std::floor(std::log10(table.diagonal())) - 3); }

Vec2d rounded(const Vec2d& p, double unit) { return {rounded(p.x, unit), rounded(p.y, unit)}; }

/// Returns whether a place is clear of cushions and pockets.
bool is_free(const Boundary& b, const Vec2d& p) {
  if (b.clearance(p) < b.body.radius / 2) return false;
  return std::all_of(b.pockets.begin(), b.pockets.end(),
                     [&](const Circle& c) { return norm(p - c.centre) > c.radius + b.body.radius; });
}

std::optional<Vec2d> free_place(Random& r, const Boundary& b, const Table& table) {
  constexpr int enough = 1000;  // a table without space for the ball must not hang
  const Vec2d low = table.lowest(), high = table.highest();
  for (int i = 0; i < enough; ++i) {
    const Vec2d p = rounded({r.uniform(low.x, high.x), r.uniform(low.y, high.y)}, unit_of(table));
    if (is_free(b, p)) return p;
  }
  return {};
}

/// Draws the spin: half of all shots are struck in the centre, others with tenths of natural roll.
LaunchSpin draw_spin(Random& r, const Wish& w) {
  if (!w.spins || !carries_spin(w.physics) || r.chance(0.5)) return {};
  LaunchSpin s{r.integer(-5, 10) / 10.0, r.integer(-5, 5) / 10.0, 0};
  if (r.chance(0.1)) s.masse = r.integer(-5, 5) / 10.0;
  return s;
}

Wish::Kind kind_of(const Puzzle& p) {
  if (then_of(p.target)) return Wish::Kind::pot;
  if (first_of_carom(p.target) != 0) return Wish::Kind::carom;
  if (is_ball(p.target)) return Wish::Kind::kick;
  if (is_pocket(p.target)) return Wish::Kind::pocket;
  const auto asked = arrival_range(p);
  return asked && asked->high == 0 ? Wish::Kind::stop : Wish::Kind::pass;
}

/// Rounds numbers as a person would write them, and uses the wish or defaults where possible.
void tidy(Puzzle& p, const Wish& w) {
  constexpr double tenth = 0.1;
  const bool stops = kind_of(p) == Wish::Kind::stop;
  if (auto* point = std::get_if<PointTarget>(&p.target)) {
    const double unit = unit_of(p.table);
    *point = {rounded(point->at, unit), std::min(point->within, 10 * unit)};  // the default on any playable table
  }
  const auto in_tenths = [&](double v) { return std::max(tenth, rounded(v, tenth)); };
  const Range any = is_ideal(p.physics) ? Puzzle{}.speed : w.speed.value_or(Puzzle{}.speed);
  const double speed = std::clamp(in_tenths(p.speed.low), any.low, any.high);
  p.speed = is_ideal(p.physics) || !p.speed.fixed() ? any : Range{speed, speed};
  constexpr double dropping = 0.5;  // m/s; one speed, so that a pocket has one answer too
  if (kind_of(p) == Wish::Kind::pocket && !is_ideal(p.physics) && !p.speed.fixed())
    p.arrive = Range{dropping, dropping};
  else if (p.arrive && !stops)
    p.arrive = Range{in_tenths(p.arrive->low), in_tenths(p.arrive->low)};
  else
    p.arrive.reset();
}

/// Makes a puzzle from a random shot; none if the shot has other bounces or falls into another pocket. Without the
/// choice of a pocket most would drop into the middle ones.
std::optional<Puzzle> from_shot(Random& r, const Wish& w, const Boundary& boundary, int pocket) {
  const auto at = free_place(r, boundary, w.table);
  if (!at) return {};
  ShotRequest shot{.table = w.table, .physics = w.physics, .ball = w.ball};
  shot.ball.at = *at;
  shot.spin = draw_spin(r, w);
  const Range speed = w.speed.value_or(Range{0.3, 8});
  shot.launch = {r.log_uniform(speed.low, speed.high), radians(r.uniform(0, 360))};
  const int n = r.integer(w.cushions.min, w.cushions.max);
  shot.until.cushions = n + 1;
  auto asked = ask(r, shot, simulate(shot), n, n);
  if (!asked) return {};
  const AimPoint aim_point = aim_points_of(asked->puzzle.target, boundary).front();
  if (aim_point.captures() && aim_point.taken_by.index != pocket) return {};
  asked->puzzle.cushions = CushionRule::exactly(n);
  return asked->puzzle;
}

bool touches_balls(const Wish& w) { return w.kind && *w.kind >= Wish::Kind::kick; }

/// Puts balls at free places, none touching another; returns false if there is no space.
bool scatter(Random& r, const Wish& w, const Boundary& boundary, Puzzle& p) {
  constexpr int usual = 3, patience = 200;
  const bool carom = w.kind == Wish::Kind::carom;
  const int needed = carom ? 2 : touches_balls(w) ? 1 : 0;
  const int count = needed > 0 && w.others == 0 ? usual : std::max(w.others, needed);
  const auto id = [&](std::size_t k) {
    return carom && k < 2 ? std::string(k == 0 ? "red" : "yellow") : std::to_string(k + 1);
  };
  for (int tries = 0; tries < patience && static_cast<int>(p.others.size()) < count; ++tries) {
    const auto at = free_place(r, boundary, w.table);
    const auto clear = [&](const Ball& b) { return norm(b.at - *at) > touching_distance(b.body, w.ball.body); };
    if (at && clear(p.ball) && std::ranges::all_of(p.others, clear))
      p.others.push_back({*at, w.ball.body, id(p.others.size())});
  }
  return static_cast<int>(p.others.size()) == count;
}

PocketTarget some_pocket(Random& r, const Wish& w) {
  return {r.integer(0, static_cast<int>(w.table.pockets.size()) - 1)};
}

Target draw_ball(Random& r, const Wish& w) {
  if (w.kind == Wish::Kind::carom) return CaromTarget{1, {.balls = {2}}};
  if (w.kind == Wish::Kind::pot) return ObjectBallTarget{{1}, {some_pocket(r, w), w.then, {}}};
  return BallTarget{.balls = {1}};
}

/// Draws balls and a target at random, for wishes that hardly any random shot meets.
std::optional<Puzzle> from_target(Random& r, const Wish& w, const Boundary& boundary) {
  const auto at = free_place(r, boundary, w.table), target = free_place(r, boundary, w.table);
  if (!at || !target) return {};
  if (w.kind == Wish::Kind::pot && w.table.pockets.empty()) return {};
  Puzzle p{.table = w.table, .physics = w.physics, .ball = w.ball};
  p.ball.at = *at;
  p.spin = draw_spin(r, w);
  p.cushions = w.cushions;
  if (!p.cushions.sequence && w.kind != Wish::Kind::carom)
    p.cushions = CushionRule::exactly(r.integer(w.cushions.min, w.cushions.max));
  if (!scatter(r, w, boundary, p)) return {};
  p.target = PointTarget{*target};
  if (touches_balls(w))
    p.target = draw_ball(r, w);
  else if (!w.table.pockets.empty() && r.chance(0.5))
    p.target = some_pocket(r, w);
  else if (r.chance(0.5))
    p.arrive = Range{0.5, 0.5};
  return p;
}

/// Returns whether the puzzle is valid as written and worth asking: the target is a fifth of the diagonal away or more.
bool is_sound(const Puzzle& p, const Boundary& boundary) {
  try {
    validate(p);
  } catch (const InvalidInput&) {
    return false;
  }
  constexpr double near = 0.2;
  const AimPoint aim_point = aim_points_of(p).front();
  return norm(aim_point.at - p.ball.at) >= near * boundary.diagonal;
}

/// Returns whether a shot is found quickly. A random target often has none, and to be sure of that costs far more than
/// to find one.
bool has_quick_shot(Puzzle p) {
  // In simulations; a carom is looked for among all aims across its first ball.
  const long quick = first_of_carom(p.target) != 0 ? 50000 : 2000;
  p.budget = std::min(budget_of(p), quick);
  return solve(p, {.robustness = false, .suggest = false}).status == Status::solved;
}

}  // namespace

std::optional<Made> ask(Random& r, const ShotRequest& shot, const Trajectory& t, int least, int most) {
  Made q{{.table = shot.table, .physics = shot.physics, .ball = shot.ball, .spin = shot.spin}, shot.launch, 0};
  Puzzle& p = q.puzzle;
  const Record& last = t.events.back();
  double arrival = 0;
  const auto touches_jaws = [](const Record& e) { return e.kind == EventKind::jaw; };
  if (t.legs.empty() || std::ranges::any_of(t.events, touches_jaws)) return {};
  if (t.end == EventKind::pocket) {
    p.target = PocketTarget{t.events[t.events.size() - 2].contact.index};
    q.bounces = t.cushions;
    arrival = norm(last.state.velocity);
  } else if (t.end == EventKind::rest && r.chance(0.5)) {
    p.target = PointTarget{last.state.at};
    q.bounces = t.cushions;
  } else {
    const auto leg = static_cast<std::size_t>(r.integer(0, static_cast<int>(t.legs.size()) - 1));
    const Leg& l = t.legs[leg];
    const double time = l.duration * (r.chance(0.2) ? 1.0 : r.uniform(0.05, 1));
    const State<double> there = state_on(shot, l, time);
    p.target = PointTarget{there.at};
    q.bounces = static_cast<int>(std::count_if(t.events.begin(), t.events.end(), [&](const Record& e) {
      return e.kind == EventKind::cushion && e.time <= l.begin;
    }));
    arrival = norm(there.velocity);
    if (!(arrival > 1e-3)) return {};
  }
  if (q.bounces < least || q.bounces > most) return {};
  p.speed = {shot.launch.speed / 2, shot.launch.speed * 2};
  const bool ideal = is_ideal(shot.physics), stops = !ideal && arrival == 0;
  if (!stops && r.chance(0.5))
    p.speed = {shot.launch.speed, shot.launch.speed};
  else if (!ideal && !stops)
    p.arrive = Range{arrival, arrival};
  std::vector<Contact> contacts = t.sequence();
  contacts.resize(static_cast<std::size_t>(q.bounces));
  p.cushions = r.chance(0.5) ? CushionRule::in_order(contacts) : CushionRule::exactly(q.bounces);
  return q;
}

const char* name(Difficulty d) {
  constexpr const char* names[] = {"easy", "medium", "hard"};
  return names[static_cast<int>(d)];
}

Difficulty difficulty(const Shot& shot) {
  const auto side = [](const std::optional<double>& m) { return m ? std::abs(*m) : radians(180); };
  const double margin = std::min(side(shot.robustness.margin.value().angle[0]), side(shot.robustness.margin->angle[1])),
               success = shot.robustness.success.value();
  if (success < hard_success || margin < hard_margin) return Difficulty::hard;
  return success >= easy_success && margin >= easy_margin ? Difficulty::easy : Difficulty::medium;
}

std::string Tries::text() const {
  if (no_room) return "the table has no free place for the ball";
  std::string out =
      fmt::format("{} shots drawn, {} with the bounces and the target wished and solved for", draws, solved);
  if (no_shot) out += fmt::format("; {} had no exact shot", no_shot);
  if (other_difficulty) out += fmt::format("; {} had another difficulty", other_difficulty);
  if (not_unique) out += fmt::format("; {} had more than one shot", not_unique);
  return out;
}

std::optional<Generated> generate(const Wish& w, Random& r, Tries* counts) {
  Tries own;
  Tries& tries = counts ? *counts : own;
  const Boundary boundary(w.table, w.ball.body);
  Random look(1);
  tries.no_room = !free_place(look, boundary, w.table);
  if (tries.no_room) return {};
  int pocket = 0;
  while (tries.solved < w.tries && tries.draws < draws_a_try * w.tries) {
    constexpr long patience = 1000;  // draws for one pocket, which may have no such shot
    if (tries.draws++ % patience == 0) pocket = r.integer(0, std::max(0, static_cast<int>(w.table.pockets.size()) - 1));
    const bool drawn = w.cushions.sequence || w.others > 0 || touches_balls(w);
    auto p = drawn ? from_target(r, w, boundary) : from_shot(r, w, boundary, pocket);
    if (!p) continue;
    tidy(*p, w);
    if ((w.kind && kind_of(*p) != *w.kind) || !is_sound(*p, boundary)) continue;
    ++tries.solved;
    if (drawn && !has_quick_shot(*p)) {
      ++tries.no_shot;
      continue;
    }
    Puzzle centred = *p;  // a puzzle is as hard as its exact shot
    centred.aim = Aim::centre;
    Answer a = solve(centred, {.suggest = false});
    const bool exact =
        a.status == Status::solved && a.shots.front().verification.miss <= tolerance::exact_miss * boundary.diagonal;
    if (!exact) {
      ++tries.no_shot;
    } else if (w.difficulty && difficulty(a.shots.front()) != *w.difficulty) {
      ++tries.other_difficulty;
    } else if (w.unique && solve(*p, {.all = true, .robustness = false}).shots.size() != 1) {
      ++tries.not_unique;
    } else {
      return Generated{std::move(*p), std::move(a)};
    }
  }
  return {};
}

}  // namespace bankshot
