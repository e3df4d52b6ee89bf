// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "json/document.hpp"
#include "simulate/csv.hpp"

namespace bankshot {
namespace {

Json event_json(const ShotRequest& r, const Record& e) {
  const Vec3<double>& w = e.state.spin;
  Json j{{"type", words(e.kind).type},
         {"time", e.time},
         {"ball", "cue"},
         {"at", {e.state.at.x, e.state.at.y}},
         {"velocity", {e.state.velocity.x, e.state.velocity.y}},
         {"spin", {w.x, w.y, w.z}}};
  if (is_bounce(e.kind)) j["cushion"] = contact_name(r.table, e.contact);
  if (e.kind == EventKind::pocket) j["pocket"] = contact_name(r.table, e.contact);
  return j;
}

}  // namespace

std::string to_json(const ShotRequest& r, const Trajectory& t) {
  Json j = Json::object();
  j["events"] = Json::array();
  for (const Record& e : t.events) j["events"].push_back(event_json(r, e));
  const Record& last = t.events.back();
  j["end"] = {{"reason", words(t.end).reason},
              {"time", last.time},
              {"at", {last.state.at.x, last.state.at.y}},
              {"cushions", t.cushions},
              {"length", t.length}};
  j["energy"] = {{"start", energy(r.ball.body, t.events.front().state)}, {"end", energy(r.ball.body, last.state)}};
  return write_json(r.id, j);
}

void sample(const ShotRequest& r, const Trajectory& t, double rate,
            const std::function<void(double, const State<double>&)>& see) {
  auto event = t.events.begin();
  const auto events_until = [&](double time) {
    for (; event != t.events.end() && event->time <= time; ++event) see(event->time, event->state);
  };
  long number = 1;  // the launch is an event
  for (const Leg& leg : t.legs) {
    events_until(leg.begin);
    const double end = leg.begin + leg.arc.seconds(leg.duration);
    for (double s = static_cast<double>(number) / rate; s < end; s = static_cast<double>(++number) / rate)
      if (s > leg.begin) see(s, state_at(r, leg, s - leg.begin));
  }
  events_until(forever);
}

std::string csv_row(double time, const State<double>& s) {
  const Vec3<double>& w = s.spin;
  return fmt::format("{},cue,{},{},{},{},{},{},{}", time, s.at.x, s.at.y, s.velocity.x, s.velocity.y, w.x, w.y, w.z);
}

std::string to_csv(const ShotRequest& r, const Trajectory& t, double rate) {
  std::string out = std::string(csv_header) + "\n";
  sample(r, t, rate, [&](double time, const State<double>& s) { out += csv_row(time, s) + "\n"; });
  return out;
}

}  // namespace bankshot
