// SPDX-License-Identifier: MIT
#include "truth/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "truth/arrival.hpp"

namespace bankshot::truth {
namespace {

/// Checks one shot.
class ShotCheck {
 public:
  ShotCheck(const Puzzle& p, const Shot& shot) : p_(p), shot_(shot), scene_(p), place_(place_tolerance()) {}

  std::vector<Check> run() {
    bounds();
    asked_cushions();
    if (shot_.verification.digits == 0)
      return std::move(out_);  // rounding decides the number of bounces, so nothing is guaranteed
    const Then* const then = then_of(p_.target);
    if (shot_.path.then.size() != (then ? 1 + then->links.size() : 0))
      return fails(Claim::hits, fmt::format("sends {} balls on", shot_.path.then.size()));
    const Arrived there = scene_.replay(shot_.launch, shot_, place_);
    const bool all = there.cushions.size() == shot_.path.cushions.size();
    if (all && !there.in_order)
      return fails(Claim::cushions, fmt::format("meets {}, not {}", names(there.cushions), names(shot_.path.cushions)));
    if (!there.why.empty()) return fails(Claim::target, fmt::format("{} after {}", there.why, names(there.cushions)));
    for (std::size_t i = 0; i < there.then.size(); ++i) {
      const auto &met = there.then[i].cushions, &said = shot_.path.then[i].cushions;
      if (met != said) return fails(Claim::cushions, fmt::format("sends it to {}, not {}", names(met), names(said)));
    }
    holds(Claim::cushions);
    holds(Claim::target);
    arrives(there);
    condition();
    if (shot_.robustness.margin) margin();
    if (shot_.robustness.success) success();
    if (shot_.robustness.value) value();
    if (shot_.leave) leave();
    return std::move(out_);
  }

 private:
  void holds(Claim c) { out_.push_back({c}); }
  std::vector<Check>& fails(Claim c, std::string what) {
    out_.push_back({c, 1, 0, std::move(what)});
    return out_;
  }
  /// Adds a check; `words` describe the claim and the truth.
  void compare(Claim c, double off, double allowed, std::string words) {
    if (!(off >= 0)) off = std::isnan(off) ? HUGE_VAL : 0;
    out_.push_back(
        {c, off, allowed,
         off <= allowed ? "" : fmt::format("{}: off by {:.3g} {}, allowed {:.3g}", words, off, unit(c), allowed)});
  }

  std::string names(const std::vector<Contact>& contacts) const {
    std::string out;
    for (const Contact c : contacts) out += (out.empty() ? "" : ", ") + contact_name(p_.table, c);
    return out.empty() ? "no cushion" : out;
  }

  /// Returns the shot with other cushions.
  Shot named(const std::vector<Contact>& cushions) const {
    Shot other = shot_;
    other.path.cushions = cushions;
    return other;
  }

  /// Returns the allowed relative error: `share`, or more if the shot guarantees fewer digits.
  double promised(double share) const {
    return shot_.verification.digits ? std::max(share, std::pow(10, -*shot_.verification.digits)) : share;
  }
  double place_tolerance() const { return promised(tolerance::exact_miss) * scene_.boundary.diagonal; }

  void bounds() {
    const double v = shot_.launch.speed;
    const auto outside = [](double x, const Range& r) { return std::max({0.0, r.low - x, x - r.high}); };
    compare(Claim::speed, outside(v, p_.speed), tolerance::bound * std::max(1.0, p_.speed.high),
            fmt::format("{} m/s is outside {} to {}", v, p_.speed.low, p_.speed.high));
    if (is_ideal(p_.physics))
      compare(Claim::speed, std::abs(v - ideal_speed(p_)), tolerance::bound,
              fmt::format("{} m/s, and it keeps {}", v, ideal_speed(p_)));
    if (p_.angle) {
      constexpr double turn = radians(360);
      const double a = shot_.launch.angle,
                   off = std::min({outside(a, *p_.angle), outside(a + turn, *p_.angle), outside(a - turn, *p_.angle)});
      compare(Claim::angle, off, tolerance::bound * turn,
              fmt::format("{}° is outside {}° to {}°", degrees(a), degrees(p_.angle->low), degrees(p_.angle->high)));
    }
    const SpinRange exactly{{p_.spin.top, p_.spin.top}, {p_.spin.side, p_.spin.side}, {p_.spin.masse, p_.spin.masse}};
    const SpinRange& r = p_.spin_range ? *p_.spin_range : exactly;
    const LaunchSpin& s = shot_.spin;
    const double off = std::max({outside(s.top, r.top), outside(s.side, r.side), outside(s.masse, r.masse)});
    compare(Claim::spin, off, 0,
            fmt::format("top {}, side {}, masse {} is not the spin asked", s.top, s.side, s.masse));
  }

  void asked_cushions() {
    const CushionRule& rule = p_.cushions;
    const int n = static_cast<int>(shot_.path.cushions.size());
    if (n < rule.min || n > rule.max)
      fails(Claim::rule, fmt::format("{} cushions, and {} to {} are asked", n, rule.min, rule.max));
    else if (rule.sequence && !scene_.replay(shot_.launch, named(*rule.sequence), place_).in_order)
      fails(Claim::rule, fmt::format("{}, and {} is asked", names(shot_.path.cushions), names(*rule.sequence)));
    else
      holds(Claim::rule);
  }

  /// Returns the time error [s] of a position error at the speed of the ball. For a ball at rest the launch speed is
  /// used. If it rests on a cushion, rounding decides whether it first bounces off at a crawl, which adds time.
  double time_tolerance(const Arrived& there, double place) const {
    if (there.speed > 0) return place / there.speed;
    const bool on_cushion = scene_.boundary.clearance(there.at) <= place;
    return place / shot_.launch.speed + (on_cushion ? std::sqrt(2 * place / deceleration(p_.physics)) : 0);
  }

  void arrives(const Arrived& there) {
    const Arrival& said = shot_.path.arrival;
    const double place = place_ / there.incidence, miss = scene_.miss(there);
    // If no line in this direction leads straight in, there is no exact line to miss.
    const bool no_line = std::isnan(miss) && shot_.path.touches_jaws;
    compare(Claim::miss, no_line ? 0 : std::abs(miss - shot_.verification.miss), place_,
            fmt::format("says {:.6g} m and misses by {:.6g} m", shot_.verification.miss, miss));
    if (there.touches_jaws != shot_.path.touches_jaws)
      return fails(Claim::form, there.touches_jaws ? "touches jaws and does not say so" : "says that it touches jaws"),
             void();
    if (!shot_.verification.off_centre)
      compare(Claim::centre, miss, place_, "does not reach the centre and does not say so");
    hits(there, place);
    if (there.taken_by.kind != ContactKind::ball)
      compare(Claim::offset, std::abs(there.offset - shot_.verification.offset), place_,
              fmt::format("says {:.6g} m and passes the pocket's centre at {:.6g} m", shot_.verification.offset,
                          there.offset));
    compare(Claim::place, norm(said.at - there.at), place,
            fmt::format("says ({}, {}) and arrives at ({}, {})", said.at.x, said.at.y, there.at.x, there.at.y));
    compare(Claim::time, std::abs(said.time - there.time),
            time_tolerance(there, place) + tolerance::exact_speed * there.time,
            fmt::format("says {} s and arrives after {} s", said.time, there.time));
    compare(Claim::arrival, std::abs(said.speed - there.speed),
            promised(tolerance::exact_speed) * std::max(1.0, there.speed),
            fmt::format("says {} m/s and arrives at {} m/s", said.speed, there.speed));
    // The safest launch need not arrive at the required speed, because "made" does not depend on that speed.
    if (const auto asked = arrival_range(p_); asked && !shot_.provenance.moved)
      compare(Claim::asked, std::max(asked->low - there.speed, there.speed - asked->high),
              promised(tolerance::exact_speed) * std::max(1.0, asked->high),
              fmt::format("arrives at {} m/s, and {} to {} is asked", there.speed, asked->low, asked->high));
  }

  void hits(const Arrived& there, double place) {
    if (shot_.path.hits.size() != there.hits.size())
      return fails(Claim::hits, fmt::format("names {} contacts with balls", shot_.path.hits.size())), void();
    for (std::size_t i = 0; i < there.hits.size(); ++i) compare_hit(shot_.path.hits[i], i, there.hits[i], place);
  }

  /// Checks contact number `nth` of the shot.
  void compare_hit(const Hit& said, std::size_t nth, const Arrived::Hit& hit, double place) {
    const Contact ball = Contact::ball(hit.ball);
    if (said.ball != hit.ball) return fails(Claim::hits, "meets " + contact_name(p_, ball)), void();
    const int by = nth == 0 || shot_.path.then.empty() ? 0 : shot_.path.then[nth - 1].ball;
    const double offset = -hit.passing.lateral, speed = hit.passing.speed;
    const double as_said = -scene_.boundary_of(by).rim(ball)->radius * std::sin(said.cut);
    compare(Claim::hits, std::abs(as_said - offset), place_,
            fmt::format("says a cut of {:.6g}°, the offset {:.6g} m, and it is {:.6g} m", degrees(said.cut), as_said,
                        offset));
    // The error of the contact along the path is the error across it over the cosine of the cut.
    compare(Claim::hits, norm(said.at - hit.passing.at), place / std::max(std::cos(said.cut), 1e-6),
            "the contact is elsewhere");
    compare(Claim::hits, std::abs(said.speed - speed), tolerance::exact_speed * std::max(1.0, speed),
            fmt::format("says {} m/s and meets it at {} m/s", said.speed, speed));
  }

  void condition() {
    constexpr double digits = 1e-6;  // relative accuracy that users may rely on
    // If the position has fewer digits, its error turns the normals of round obstacles, whose size is a ball's or more.
    double allowed = std::max(digits, shot_.verification.digits ? place_ / scene_.boundary.body.radius : 0);
    // Within rounding of the launch the condition may jump: a cushion may hold the ball on one side of the shot only,
    // or the ball may creep up to a cushion. Any value between is then correct.
    constexpr Scene::Sides sides[] = {{1, 1}, {1, 1, true}, {-1, 1, true}, {1, -1, true}, {-1, -1, true}};
    std::optional<Range> truth;
    double off = 0;
    for (const Scene::Sides& side : sides) {
      const auto seen = scene_.condition(shot_, side);
      if (!seen) break;
      const double m = seen->metres;
      truth = truth ? Range{std::min(truth->low, m), std::max(truth->high, m)} : Range{m, m};
      allowed = std::max(allowed, seen->rounding);
      off = std::max({0.0, truth->low - shot_.verification.condition, shot_.verification.condition - truth->high}) /
            std::max(truth->high, scene_.boundary.extent);
      if (off <= allowed) break;
    }
    if (truth)
      compare(Claim::condition, off, allowed,
              fmt::format("says {} m and it is {} to {} m", shot_.verification.condition, truth->low, truth->high));
  }

  /// Checks both sides of each end, slightly more than its tolerance away, and launches between 0 and the end.
  void margin() {
    constexpr double beside = 3 * tolerance::margin, least = tolerance::same_aim;
    constexpr int places = 50;
    double wrong = 0;
    std::string what;
    if (shot_.path.scratch && !is_ideal(p_.physics)) return scratched();
    const auto end = [&](std::optional<double> m, double turned, double pushed, const char* which) {
      if (!m) return;
      const auto launch = [&](double k, double beyond = 0) {
        const double by = *m * k + std::copysign(least, turned + pushed) * beyond;
        return Launch{shot_.launch.speed + std::abs(pushed) * by,
                      wrap_angle(shot_.launch.angle + std::abs(turned) * by)};
      };
      const auto made = [&](const Launch& l) { return scene_.counts(l, shot_); };
      const auto gap = [&] {
        for (int i = 0; i < places; ++i) {
          const Launch l = launch((i + 0.5) / places);
          if (!scene_.seems_to_count(l, shot_) && !made(l)) return true;
        }
        return false;
      };
      // Intervals in which the cue ball falls may be narrower than the tolerance of an end.
      const auto goes_on = [&] {
        if (!made(launch(1 + beside, 1))) return false;
        constexpr int looks = 16;
        for (int i = -looks; i < looks && scene_.may_scratch(); ++i)
          if (!made(launch(1 + beside * i / looks, static_cast<double>(i) / looks))) return false;
        return true;
      };
      // Launches nearer than `least` cannot be distinguished from the shot's.
      const bool inside = std::abs(*m) <= least || made(launch(1 - beside, -1));
      const char* const trouble = !inside     ? "is not made"
                                  : goes_on() ? "does not break it"
                                  : gap()     ? "jumps launches that are not made"
                                              : nullptr;
      if (!trouble) return;
      wrong += 1;
      what +=
          fmt::format("{}{} of {:.6g} {}", what.empty() ? "" : "; ", which, turned != 0 ? degrees(*m) : *m, trouble);
    };
    end(shot_.robustness.margin->angle[0], -1, 0, "angle");
    end(shot_.robustness.margin->angle[1], 1, 0, "angle");
    end(shot_.robustness.margin->speed[0], 0, -1, "speed");
    end(shot_.robustness.margin->speed[1], 0, 1, "speed");
    compare(Claim::margin, wrong, 0, what);
  }

  /// Checks that the margins of a shot that scratches are 0.
  void scratched() {
    const auto& [angle, speed] = *shot_.robustness.margin;
    const auto wrong = [](const auto& ends) { return std::ranges::count_if(ends, [](auto m) { return m != 0.0; }); };
    compare(Claim::margin, static_cast<double>(wrong(angle) + wrong(speed)), 0, "is not 0, and the cue ball falls");
  }

  /// Checks the value. An answer does not contain the number of jaw contacts; for a jaw shot, any whole number from 1
  /// is accepted.
  void value() {
    constexpr double digits = 1e-9, per_contact = 0.005;
    if (!shot_.robustness.success) return compare(Claim::value, HUGE_VAL, digits, "is given without a success");
    const double success = shot_.leave ? shot_.leave->success : *shot_.robustness.success;
    const double without_jaws = success - cost_of(shot_) + per_contact * shot_.path.jaws;
    const double jaws =
        shot_.path.touches_jaws ? std::max(1.0, std::round((without_jaws - *shot_.robustness.value) / per_contact)) : 0;
    compare(Claim::value, std::abs(without_jaws - per_contact * jaws - *shot_.robustness.value), digits,
            fmt::format("says {:.6g} and success less costs is {:.6g}", *shot_.robustness.value, without_jaws));
  }

  /// Checks where the cue ball stops, and how far that is from where it should.
  void leave() {
    constexpr double rest_digits = 1000;  // the rest is not polished like an arrival
    const Trajectory t = simulate(ShotRequest{{}, p_.table, p_.physics, p_.ball, p_.others, shot_.launch, shot_.spin});
    const Vec2d rests = end_of(t, 0).state.at;
    const double allowed = tolerance::exact_miss * p_.table.diagonal() * rest_digits;
    compare(Claim::leave, norm(rests - shot_.leave->at), allowed,
            fmt::format("says [{:.9g}, {:.9g}] and the cue ball stops at [{:.9g}, {:.9g}]", shot_.leave->at.x,
                        shot_.leave->at.y, rests.x, rests.y));
    const double miss = p_.leave ? miss_of(*p_.leave, rests) : 0;
    compare(Claim::leave, std::abs(miss - shot_.leave->miss), allowed,
            fmt::format("says a miss of {:.9g} m, and it is {:.9g} m", shot_.leave->miss, miss));
  }

  void success() {
    constexpr int draws = 1000;
    constexpr double deviations = 5;  // standard deviations of the fraction made in these draws
    const double p = *shot_.robustness.success, seen = scene_.chance(shot_, draws);
    const double spread = std::sqrt(std::max(seen * (1 - seen), 1.0 / draws) / draws);
    const bool possible = p >= 0 && p <= 1;
    compare(Claim::success, possible ? std::abs(p - seen) : HUGE_VAL, tolerance::success + deviations * spread,
            fmt::format("says {:.4g} and {} draws make {:.4g}", p, draws, seen));
  }

  const Puzzle& p_;
  const Shot& shot_;
  Scene scene_;
  double place_;  ///< m
  std::vector<Check> out_;
};

std::string form(const Answer& a) {
  if (a.status == Status::solved && a.shots.empty()) return "is solved and has no shot";
  if (a.status != Status::solved && !a.shots.empty()) return "has a shot and is not solved";
  if (a.status != Status::no_shot && a.nearest) return "has a nearest miss and is no `no-shot`";
  if (a.message.empty()) return "has no message";
  if (a.status == Status::invalid && (!a.error || a.error->reason.empty())) return "is invalid and gives no reason";
  return "";
}

}  // namespace

std::string_view name(Claim c) {
  constexpr std::string_view names[claims] = {
      "id",          "form",      "status", "launch speed", "aim",   "spin",  "rule", "cushions",
      "target",      "centre",    "miss",   "offset",       "hits",  "place", "time", "arrival speed",
      "speed asked", "condition", "margin", "success",      "value", "leave"};
  return names[static_cast<int>(c)];
}

std::string_view unit(Claim c) {
  constexpr std::string_view units[claims] = {"",  "", "",  "m/s", "rad", "",    "",      "",     "", "m", "m",
                                              "m", "", "m", "s",   "m/s", "m/s", "of it", "ends", "", "",  "m"};
  return units[static_cast<int>(c)];
}

std::vector<Check> check(const Puzzle* puzzle, const std::string& id, const Answer& a) {
  std::vector<Check> out;
  const auto text = [](const std::string& s) { return s.empty() ? std::string("none") : s; };
  out.push_back({Claim::id, id == a.id ? 0.0 : 1.0, 0,
                 id == a.id ? "" : fmt::format("the answer's is {}, the puzzle's {}", text(a.id), text(id))});
  const bool other = puzzle && puzzle->about != a.about;
  const std::string missing = other ? "does not bring back the puzzle's \"about\"" : form(a);
  out.push_back({Claim::form, missing.empty() ? 0.0 : 1.0, 0, missing});
  const bool invalid = a.status == Status::invalid;
  if (invalid == (puzzle != nullptr))
    out.push_back({Claim::status, 1, 0,
                   invalid ? "is invalid, and the puzzle can be read"
                           : "the puzzle cannot be read, and the answer is not `invalid`"});
  else
    out.push_back({Claim::status});
  if (!puzzle) return out;
  for (std::size_t i = 0; i < a.shots.size(); ++i) {
    const Puzzle played = as_played(*puzzle, a.shots[i]);
    for (Check& c : ShotCheck(played, a.shots[i]).run()) {
      c.shot = i;
      out.push_back(std::move(c));
    }
  }
  return out;
}

}  // namespace bankshot::truth
