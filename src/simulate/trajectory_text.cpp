// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "json/document.hpp"

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
  if (e.kind == EventKind::cushion) j["cushion"] = contact_name(r.table, e.contact);
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

std::string to_csv(const ShotRequest& r, const Trajectory& t, double rate) {
  std::string out = "t,ball,x,y,vx,vy,wx,wy,wz\n";
  const auto row = [&](double time, const State<double>& s) {
    const Vec3<double>& w = s.spin;
    out +=
        fmt::format("{},cue,{},{},{},{},{},{},{}\n", time, s.at.x, s.at.y, s.velocity.x, s.velocity.y, w.x, w.y, w.z);
  };
  auto event = t.events.begin();
  const auto events_until = [&](double time) {
    for (; event != t.events.end() && event->time <= time; ++event) row(event->time, event->state);
  };
  long sample = 1;  // the launch is an event
  for (const Leg& leg : t.legs) {
    events_until(leg.begin);
    const double end = leg.begin + leg.arc.seconds(leg.duration);
    for (double s = static_cast<double>(sample) / rate; s < end; s = static_cast<double>(++sample) / rate)
      if (s > leg.begin) row(s, state_at(r, leg, s - leg.begin));
  }
  events_until(forever);
  return out;
}

}  // namespace bankshot
