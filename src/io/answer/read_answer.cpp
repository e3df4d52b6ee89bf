// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/json.hpp"
#include "io/format/answer_keys.hpp"
#include "io/json/reader.hpp"

namespace bankshot {
namespace {

void note_unread(const Json& object, const format::Object& known, std::set<std::string>* unread) {
  if (!unread) return;
  for (auto member = object.begin(); member != object.end(); ++member)
    if (std::none_of(known.keys.begin(), known.keys.end(), [&](const auto& key) { return key.name == member.key(); }))
      unread->insert(member.key());
}

std::vector<Contact> read_contacts(const Reader& r, const Table& table) {
  std::vector<Contact> contacts;
  for (const Reader& item : r.items()) {
    if (const auto found = find_cushion(table, item.text())) {
      contacts.push_back(*found);
      continue;
    }
    std::vector<std::string> all = table.cushions;
    for (int i = 0; i < static_cast<int>(table.vertices.size()); ++i)
      all.push_back(contact_name(table, Contact::vertex(i)));
    const std::vector<std::string_view> names(all.begin(), all.end());
    item.word("cushion", names);  // throws
  }
  return contacts;
}

/// Reads the launch spin. Answers in `ideal` and `rolling` physics print natural roll, which is subtracted.
LaunchSpin read_spin(const Reader& r, const Puzzle& p) {
  LaunchSpin spin{r.need("top").number(), r.need("side").number(), 0};
  if (const auto v = r.find("masse")) spin.masse = v->number();
  if (!carries_spin(p.physics)) spin.top -= 1;
  return spin;
}

std::array<std::optional<double>, 2> read_bounds(const Reader& r, double unit) {
  if (!r.is_array() || r.size() != 2) r.fail("must be a pair [down, up]");
  std::array<std::optional<double>, 2> out;
  const auto ends = r.items();
  for (std::size_t i = 0; i < 2; ++i)
    if (!ends[i].is_null()) out[i] = ends[i].number() * unit;
  return out;
}

int read_ball(const Reader& r, const Puzzle& p) {
  std::vector<std::string_view> names;
  for (const Ball& other : p.others) names.push_back(other.id);
  return 1 + static_cast<int>(r.need("ball").word("ball", names));
}

Hit read_hit(const Reader& r, const Puzzle& p) {
  return {read_ball(r, p), radians(r.need("cut").number()), r.need("speed").at_least(0), r.need("at").point()};
}

void read_cue_rests(const Reader& r, const Puzzle& p, Shot& s) {
  if (!r.is_string()) return void(s.path.cue_rests = r.point());
  std::vector<std::string_view> names;
  for (const Pocket& pocket : p.table.pockets) names.push_back(pocket.name);
  s.path.scratch_pocket = static_cast<int>(r.word("pocket", names));
}

ShotLeave read_leave(const Reader& r, const Puzzle& p) {
  ShotLeave leave{r.need("at").point(), r.need("miss").at_least(0), r.need("success").at_least(0),
                  read_contacts(r.need("cushions"), p.table)};
  if (const auto v = r.find("spread")) {
    const Vec2d sigma = v->need("sigma").pair(format::spread["sigma"].bounds);
    leave.spread = Spread{v->need("at").point(), {sigma.x, sigma.y}, radians(v->need("angle").number())};
  }
  if (const auto v = r.find("next")) {
    std::vector<std::string_view> names;
    for (const Pocket& pocket : p.table.pockets) names.push_back(pocket.name);
    leave.next = NextBall{read_ball(*v, p), static_cast<int>(v->need("pocket").word("pocket", names)),
                          v->need("success").at_least(0)};
  }
  return leave;
}

Shot read_shot(const Reader& r, const Puzzle& asked, const std::optional<Vec2d>& placed = {}) {
  Shot s{.placed = placed};
  if (const auto v = r.find("safety")) s.safety = v->boolean();
  const Puzzle p = as_played(asked, s);
  s.launch = {r.need("speed").positive(), wrap_angle(radians(r.need("angle").number()))};
  s.spin = read_spin(r.need("spin"), p);
  s.path.cushions = read_contacts(r.need("cushions"), p.table);
  s.verification.miss = r.need("miss").at_least(0);
  if (const auto v = r.find("offset")) s.verification.offset = v->number();
  if (const auto v = r.find("hits"))
    for (const Reader& hit : v->items()) s.path.hits.push_back(read_hit(hit, p));
  for (auto v = r.find("then"); v; v = v->find("then"))
    s.path.then.push_back({read_ball(*v, p), read_contacts(v->need("cushions"), p.table)});
  if (const auto v = r.find("scratch")) s.path.scratch = v->boolean();
  if (const auto v = r.find("cue_rests")) read_cue_rests(*v, p, s);
  if (const auto v = r.find("leave")) s.leave = read_leave(*v, p);
  if (const auto v = r.find("rattles")) s.path.touches_jaws = v->boolean();
  if (const auto v = r.find("off_centre")) s.verification.off_centre = v->boolean();
  if (r.find("aim")) s.provenance.moved = s.verification.off_centre = true;
  const Reader arrival = r.need("arrival");
  s.path.arrival = {arrival.need("time").at_least(0), arrival.need("speed").at_least(0), arrival.need("at").point()};
  if (const auto v = r.find("pocket")) {
    const Pocket* reached = pocket_reached(p, s);
    if (!reached || v->text() != reached->name)
      v->fail("is not the pocket that this shot reaches" + (reached ? ", " + reached->name : ""));
  }
  s.verification.condition = r.need("condition").at_least(0);
  if (const auto v = r.find("digits")) s.verification.digits = static_cast<int>(std::min(v->count(), 9L));
  if (const auto m = r.find("margin"))
    s.robustness.margin = Margin{read_bounds(m->need("angle"), radians(1)), read_bounds(m->need("speed"), 1)};
  if (const auto v = r.find("success")) s.robustness.success = v->number();
  if (const auto v = r.find("value")) s.robustness.value = v->number();
  if (const auto v = r.find("sensitivity"))
    for (const auto& [coefficient, by] : v->members()) s.robustness.sensitivity.push_back({coefficient, by.number()});
  s.provenance.planner = r.need("planner").text();
  s.provenance.simulations = r.need("simulations").count();
  return s;
}

/// Reads what a plan promises; the shots after the first are not read back.
Plan read_plan(const Reader& r) {
  Plan plan;
  for (const Reader& share : r.need("clears").items()) plan.clears.push_back(share.at_least(0));
  plan.whole = r.need("table").boolean();
  if (const auto v = r.find("why")) plan.why = v->text();
  return plan;
}

/// Checks that `settle` moves the balls as the answer says.
void check_settled(const Reader& r, const Puzzle& p) {
  const auto members = r.members();
  for (std::size_t i = 0; i < p.settled.size(); ++i) {
    const std::string& id = i == 0 ? p.ball.id : p.others[i - 1].id;
    const auto said = std::ranges::find(members, id, [](const auto& member) { return member.first; });
    const Vec2d by = said == members.end() ? Vec2d{} : said->second.point();
    if (norm(by - p.settled[i]) > tolerance::overlap) r.fail("is not by how much ball " + id + " is moved");
  }
}

Status read_status(const Reader& r) { return static_cast<Status>(r.word("status", format::statuses)); }

}  // namespace

Answer read_answer(std::string_view text, const Puzzle* puzzle, std::set<std::string>* unread) {
  const Json json = parse_document(text);
  const Reader doc(json);
  Answer a{.id = read_id(text), .about = read_about(text), .status = read_status(doc.need("status"))};
  note_unread(json, format::answer, unread);
  const auto shots = doc.need("shots").items();
  a.message = doc.need("message").text();
  if (const auto e = doc.find("error")) a.error = {e->need("path").text(), e->need("reason").text()};
  if (!puzzle) return a;
  std::optional<Vec2d> placed;
  if (const auto v = doc.find("ball"); v && puzzle->in_hand) placed = v->need("at").point();
  for (std::size_t i = 0; i < shots.size(); ++i) {
    a.shots.push_back(read_shot(shots[i], *puzzle, placed));
    note_unread(json["shots"][i], format::answer_shot, unread);
  }
  if (const auto n = doc.find("nearest"); n && !n->is_null())
    a.nearest = Answer::Nearest{read_shot(*n, *puzzle), n->need("why").text()};
  if (a.status == Status::invalid) return a;
  if (const auto v = doc.find("plan")) a.plan = read_plan(*v);
  for (const Reader& m : doc.need("modelled").items()) a.modelled.push_back(m.text());
  a.simulations = doc.need("simulations").count();
  if (const auto t = doc.find("time_us")) a.time_us = t->at_least(0);
  if (const auto v = doc.find("settled")) check_settled(*v, *puzzle);
  return a;
}

}  // namespace bankshot
