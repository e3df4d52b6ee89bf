// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <span>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/tip.hpp"
#include "io/answer/answer_path.hpp"
#include "io/json/writer.hpp"

namespace bankshot {
namespace {

void write_bounds(JsonWriter& w, std::string_view key, const std::array<std::optional<double>, 2>& b, double unit) {
  w.key(key);
  w.open('[');
  for (const auto& v : b) v ? w.number(*v * unit) : w.null();
  w.close(']');
}

void write_point(JsonWriter& w, const Vec2d& at, std::string_view key = "at") {
  w.key(key);
  w.open('[');
  w.number(at.x);
  w.number(at.y);
  w.close(']');
}

void write_cushions(JsonWriter& w, const Puzzle& p, const std::vector<Contact>& cushions) {
  w.key("cushions");
  w.open('[');
  for (const Contact c : cushions) w.string(contact_name(p.table, c));
  w.close(']');
}

void write_path(JsonWriter& w, const Puzzle& p, const Shot& shot) {
  write_cushions(w, p, shot.path.cushions);
  w.number("miss", shot.verification.miss);
  w.key("arrival");
  w.open('{');
  w.number("time", shot.path.arrival.time);
  w.number("speed", shot.path.arrival.speed);
  write_point(w, shot.path.arrival.at);
  w.close('}');
}

void write_hits(JsonWriter& w, const Puzzle& p, const std::vector<Hit>& hits) {
  w.key("hits");
  w.open('[');
  for (const Hit& hit : hits) {
    w.open('{');
    w.string("ball", p.others[static_cast<std::size_t>(hit.ball) - 1].id);
    w.number("cut", degrees(hit.cut));
    w.number("speed", hit.speed);
    write_point(w, hit.at);
    w.close('}');
  }
  w.close(']');
}

void write_contact(JsonWriter& w, const Puzzle& p, const Hit& hit) {
  w.key("contact");
  w.open('{');
  w.number("fullness", fullness(p, hit));
  write_point(w, hit.at, "ghost");
  w.close('}');
}

/// Writes where the cue ball comes to rest, or the pocket that it falls into.
void write_cue_rests(JsonWriter& w, const Puzzle& p, const Shot& shot) {
  if (shot.path.cue_rests) write_point(w, *shot.path.cue_rests, "cue_rests");
  if (shot.path.scratch_pocket && !is_ideal(p.physics))
    w.string("cue_rests", p.table.pockets[static_cast<std::size_t>(*shot.path.scratch_pocket)].name);
}

void write_leave(JsonWriter& w, const Puzzle& p, const ShotLeave& leave) {
  w.key("leave");
  w.open('{');
  write_point(w, leave.at);
  w.number("miss", leave.miss);
  w.number("success", leave.success);
  write_cushions(w, p, leave.cushions);
  if (leave.spread) {
    w.key("spread");
    w.open('{');
    write_point(w, leave.spread->at);
    w.key("sigma");
    w.open('[');
    for (const double sigma : leave.spread->sigma) w.number(sigma);
    w.close(']');
    w.number("angle", exact_degrees(leave.spread->angle));
    w.close('}');
  }
  if (leave.next) {
    w.key("next");
    w.open('{');
    w.string("ball", p.others[static_cast<std::size_t>(leave.next->ball) - 1].id);
    w.string("pocket", p.table.pockets[static_cast<std::size_t>(leave.next->pocket)].name);
    w.number("success", leave.next->success);
    w.close('}');
  }
  w.close('}');
}

void write_then(JsonWriter& w, const Puzzle& p, std::span<const ObjectBallPath> then, const Pocket* pocket) {
  const ObjectBallPath& first = then.front();
  w.key("then");
  w.open('{');
  w.string("ball", p.others[static_cast<std::size_t>(first.ball) - 1].id);
  write_cushions(w, p, first.cushions);
  if (then.size() > 1)
    write_then(w, p, then.subspan(1), pocket);
  else if (pocket)
    w.string("pocket", pocket->name);
  w.close('}');
}

void write_spin(JsonWriter& w, const LaunchSpin& spin) {
  w.key("spin");
  w.open('{');
  w.number("top", spin.top);
  w.number("side", spin.side);
  if (spin.masse != 0) w.number("masse", spin.masse);
  w.close('}');
}

/// Writes what is planned after the best shot of a game.
void write_plan(JsonWriter& w, const Plan& plan) {
  w.key("plan");
  w.open('{');
  w.key("next");
  w.open('[');
  for (const Plan::Step& step : plan.next) {
    w.open('{');
    w.string("ball", step.puzzle.others[static_cast<std::size_t>(step.shot.arriving()) - 1].id);
    if (const Pocket* const pocket = pocket_reached(step.puzzle, step.shot)) w.string("pocket", pocket->name);
    write_point(w, step.puzzle.ball.at, "from");
    w.number("speed", step.shot.launch.speed);
    w.number("angle", exact_degrees(step.shot.launch.angle));
    write_spin(w, step.shot.spin);
    if (step.shot.path.cue_rests) write_point(w, *step.shot.path.cue_rests, "cue_rests");
    if (step.shot.robustness.success) w.number("success", *step.shot.robustness.success);
    w.close('}');
  }
  w.close(']');
  w.key("clears");
  w.open('[');
  for (const double share : plan.clears) w.number(share);
  w.close(']');
  w.boolean("table", plan.whole);
  if (!plan.why.empty()) w.string("why", plan.why);
  w.close('}');
}

/// Writes a shot, or a nearest miss if `why` gives its reason.
void write_shot(JsonWriter& w, const Puzzle& asked, const Shot& shot, bool path, const std::string* why = nullptr) {
  const Puzzle p = as_played(asked, shot);
  // Without the physics `spin`, the ball rolls from the start: natural roll, as if hit 2/5 R above centre.
  const LaunchSpin spin = !carries_spin(p.physics) ? LaunchSpin{.top = 1} : shot.spin;
  w.open('{');
  w.number("speed", shot.launch.speed);
  w.number("angle", exact_degrees(shot.launch.angle));
  write_spin(w, spin);
  w.key("tip");
  w.open('{');
  const Tip tip = tip_of(spin, p.ball.body.radius);
  w.number("right", tip.right);
  w.number("up", tip.up);
  w.close('}');
  write_path(w, p, shot);
  const Pocket* const pocket = why ? nullptr : pocket_reached(p, shot);
  if (pocket && shot.path.then.empty()) w.string("pocket", pocket->name);
  if (shot.verification.offset != 0 && !why) w.number("offset", shot.verification.offset);
  if (!shot.path.hits.empty() && !why) write_hits(w, p, shot.path.hits), write_contact(w, p, shot.path.hits.front());
  if (!shot.path.then.empty() && !why) write_then(w, p, shot.path.then, pocket);
  if (shot.path.scratch && !why) w.boolean("scratch", true);
  if (!why) write_cue_rests(w, p, shot);
  if (shot.leave && !why) write_leave(w, p, *shot.leave);
  if (shot.safety) w.boolean("safety", true);
  if (shot.path.touches_jaws && !why) w.boolean("rattles", true);
  if (shot.provenance.moved && !why) w.string("aim", "safest");
  if (shot.verification.off_centre && !shot.provenance.moved && !why) w.boolean("off_centre", true);
  w.number("condition", shot.verification.condition);
  if (shot.verification.digits) w.integer("digits", *shot.verification.digits);
  if (shot.robustness.margin) {
    w.key("margin");
    w.open('{');
    write_bounds(w, "angle", shot.robustness.margin->angle, degrees(1));
    write_bounds(w, "speed", shot.robustness.margin->speed, 1);
    w.close('}');
  }
  if (shot.robustness.success) w.number("success", *shot.robustness.success);
  if (shot.robustness.value) w.number("value", *shot.robustness.value);
  if (!shot.robustness.sensitivity.empty()) {
    w.key("sensitivity");
    w.open('{');
    for (const Sensitivity& s : shot.robustness.sensitivity) w.number(s.coefficient, s.by);
    w.close('}');
  }
  if (path) write_points(w, p, shot);
  w.string("planner", shot.provenance.planner);
  w.integer("simulations", shot.provenance.simulations);
  if (why) w.string("why", *why);
  w.close('}');
}

/// Writes the displacement of each ball that `settle` moved.
void write_settled(JsonWriter& w, const Puzzle& p) {
  w.key("settled");
  w.open('{');
  for (std::size_t i = 0; i < p.settled.size(); ++i)
    if (!(p.settled[i] == Vec2d{})) write_point(w, p.settled[i], i == 0 ? p.ball.id : p.others[i - 1].id);
  w.close('}');
}

/// Writes the answer up to the list of shots, which is left open.
void write_head(JsonWriter& w, const Answer& a) {
  w.open('{');
  if (!a.id.empty()) w.key("id"), w.raw(a.id);
  w.string("status", name(a.status));
  w.key("shots");
  w.open('[');
}

void write_tail(JsonWriter& w, const Answer& a) {
  w.string("message", a.message);
  if (!a.about.empty()) w.key("about"), w.raw(a.about);
  w.close('}');
}

}  // namespace

const char* name(Status status) {
  switch (status) {
    case Status::solved:
      return "solved";
    case Status::no_shot:
      return "no-shot";
    case Status::budget:
      return "budget";
    case Status::invalid:
      break;
  }
  return "invalid";
}

Answer invalid_answer(std::string id, const InvalidInput& error, std::string about) {
  Answer a{.id = std::move(id), .about = std::move(about), .status = Status::invalid};
  a.error = {error.path, error.line ? "line " + std::to_string(error.line) + ": " + error.what() : error.what()};
  a.message = a.error->path.empty() ? a.error->reason : a.error->path + ": " + a.error->reason;
  return a;
}

std::string to_json(const Puzzle& puzzle, const Answer& a, bool timing, bool path) {
  JsonWriter w;
  write_head(w, a);
  for (const Shot& s : a.shots) write_shot(w, puzzle, s, path);
  w.close(']');
  w.key("nearest");
  a.nearest ? write_shot(w, puzzle, a.nearest->shot, false, &a.nearest->why) : w.null();
  if (!a.shots.empty() && a.shots.front().placed) {
    w.key("ball");
    w.open('{');
    write_point(w, *a.shots.front().placed);
    w.close('}');
  }
  if (a.plan) write_plan(w, *a.plan);
  w.key("modelled");
  w.open('[');
  for (const std::string& m : a.modelled) w.string(m);
  w.close(']');
  w.integer("simulations", a.simulations);
  if (timing) w.number("time_us", a.time_us);
  if (!puzzle.settled.empty()) write_settled(w, puzzle);
  write_tail(w, a);
  return w.take();
}

std::string to_json(const Answer& a) {
  JsonWriter w;
  write_head(w, a);
  w.close(']');
  w.key("nearest");
  w.null();
  if (a.error) {
    w.key("error");
    w.open('{');
    w.string("path", a.error->path);
    w.string("reason", a.error->reason);
    w.close('}');
  }
  write_tail(w, a);
  return w.take();
}

}  // namespace bankshot
