// SPDX-License-Identifier: MIT
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/boundary.hpp"
#include "json/document.hpp"

namespace bankshot {
namespace {

Json bounds(const std::array<std::optional<double>, 2>& b, double unit) {
  Json out = Json::array();
  for (const auto& v : b) out.push_back(v ? Json(*v * unit) : Json(nullptr));
  return out;
}

Json shot_json(const Puzzle& p, const Shot& shot) {
  Json names = Json::array();
  for (const int c : shot.cushions) names.push_back(contact_name(p.table, c));
  // Without the physics `spin` the ball rolls from the start: natural roll, hit 2/5 R above centre.
  const LaunchSpin spin = is_straight(p.physics) ? LaunchSpin{.top = 1} : shot.spin;
  Json j{{"speed", shot.launch.speed},
         {"angle", exact_degrees(shot.launch.angle)},
         {"spin", {{"top", spin.top}, {"side", spin.side}}},
         {"tip", {{"right", 0.4 * p.ball.radius * spin.side}, {"up", 0.4 * p.ball.radius * spin.top}}},
         {"cushions", std::move(names)},
         {"miss", shot.miss},
         {"arrival", {{"time", shot.arrival.time}, {"speed", shot.arrival.speed}, {"at", {shot.arrival.at.x, shot.arrival.at.y}}}},
         {"condition", shot.condition}};
  if (spin.masse != 0) j["spin"]["masse"] = spin.masse;
  if (shot.margin)
    j["margin"] = {{"angle", bounds(shot.margin->angle, degrees(1))}, {"speed", bounds(shot.margin->speed, 1)}};
  if (shot.success) j["success"] = *shot.success;
  j["planner"] = shot.planner;
  j["simulations"] = shot.simulations;
  return j;
}

Json head(const Answer& a) {
  Json j = Json::object();
  j["status"] = name(a.status);
  j["shots"] = Json::array();
  j["nearest"] = nullptr;
  return j;
}

}  // namespace

const char* name(Status status) {
  switch (status) {
    case Status::solved: return "solved";
    case Status::no_shot: return "no-shot";
    case Status::budget: return "budget";
    case Status::invalid: break;
  }
  return "invalid";
}

Answer invalid_answer(std::string id, const InvalidInput& error) {
  Answer a{.id = std::move(id), .status = Status::invalid};
  a.error = {error.path, error.line ? "line " + std::to_string(error.line) + ": " + error.what() : error.what()};
  a.message = a.error->path.empty() ? a.error->reason : a.error->path + ": " + a.error->reason;
  return a;
}

std::string to_json(const Puzzle& puzzle, const Answer& a, bool timing) {
  Json j = head(a);
  for (const Shot& s : a.shots) j["shots"].push_back(shot_json(puzzle, s));
  if (a.nearest) {
    j["nearest"] = shot_json(puzzle, a.nearest->shot);
    j["nearest"]["why"] = a.nearest->why;
  }
  j["modelled"] = a.modelled;
  j["simulations"] = a.simulations;
  if (timing) j["time_us"] = a.time_us;
  j["message"] = a.message;
  return write_json(a.id, j);
}

std::string to_json(const Answer& a) {
  Json j = head(a);
  if (a.error) j["error"] = {{"path", a.error->path}, {"reason", a.error->reason}};
  j["message"] = a.message;
  return write_json(a.id, j);
}

ShotRequest as_request(const Puzzle& p, const Shot& shot) {
  ShotRequest r{p.id, p.table, p.physics, p.ball, shot.launch, shot.spin, {}};
  r.until.time = shot.arrival.time;
  return r;
}

}  // namespace bankshot
