// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/json/document.hpp"
#include "io/simulate/csv.hpp"

namespace bankshot {
namespace {

void put_state(Json& j, const ShotRequest& r, int ball, const State<double>& s) {
  j["ball"] = ball_of(r, ball).id;
  j["at"] = {s.at.x, s.at.y};
  j["velocity"] = {s.velocity.x, s.velocity.y};
  j["spin"] = {s.spin.x, s.spin.y, s.spin.z};
}

Json event_json(const ShotRequest& r, const Record& e) {
  Json j{{"type", words(e.kind).type}, {"time", e.time}};
  put_state(j, r, e.ball, e.state);
  if (is_bounce(e.kind)) j["cushion"] = contact_name(r.table, e.contact);
  if (e.kind == EventKind::pocket) j["pocket"] = contact_name(r.table, e.contact);
  if (e.kind == EventKind::ball) put_state(j["other"], r, e.contact.index, e.other);
  return j;
}

/// Returns the energy at the end; with other balls, that of the balls in play.
double energy_at_end(const ShotRequest& r, const Trajectory& t) {
  if (r.others.empty()) return energy(r.physics, r.ball.body, t.events.back().state);
  double sum = 0;
  std::vector<bool> fell(r.others.size() + 1);
  for (const Record& e : t.events) {
    const auto ball = static_cast<std::size_t>(e.ball);
    if (e.kind == EventKind::pocket) fell[ball] = true;
    if (e.kind == EventKind::end && !fell[ball]) sum += energy(r.physics, ball_of(r, e.ball).body, e.state);
  }
  return sum;
}

}  // namespace

std::string to_json(const ShotRequest& r, const Trajectory& t) {
  Json j = Json::object();
  j["events"] = Json::array();
  for (const Record& e : t.events) j["events"].push_back(event_json(r, e));
  const Record& end = end_of(t, 0);
  j["end"] = {{"reason", words(t.end).reason},
              {"time", t.events.back().time},
              {"at", {end.state.at.x, end.state.at.y}},
              {"cushions", t.cushions},
              {"length", t.length}};
  // The other balls are at rest at the start.
  j["energy"] = {{"start", energy(r.physics, r.ball.body, t.events.front().state)}, {"end", energy_at_end(r, t)}};
  if (!r.settled.empty()) j["settled"] = Json::object();
  for (std::size_t i = 0; i < r.settled.size(); ++i)
    if (const Vec2d& by = r.settled[i]; !(by == Vec2d{}))
      j["settled"][ball_of(r, static_cast<int>(i)).id] = {by.x, by.y};
  return write_json(r.id, j);
}

std::string csv_row(double time, std::string_view ball, const State<double>& s) {
  const Vec3<double>& w = s.spin;
  return fmt::format("{},{},{},{},{},{},{},{},{}", time, ball, s.at.x, s.at.y, s.velocity.x, s.velocity.y, w.x, w.y,
                     w.z);
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

std::string to_csv(const ShotRequest& r, const Trajectory& t, double rate) {
  std::string out = std::string(csv_header) + "\n";
  sample(r, t, rate, [&](double time, int ball, const State<double>& s) {
    out += csv_row(time, csv_field(ball_of(r, ball).id), s) + "\n";
  });
  return out;
}

}  // namespace bankshot
