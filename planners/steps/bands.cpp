// SPDX-License-Identifier: MIT
//
// A chain followed forwards. At one launch speed the aims by which a ball is touched along one route are a band; the
// next ball is touched from bands inside it, and the last passes its mark on one side or the other.
// Method: at each speed of a row, aims evenly in the cut across a band are followed through the contact and on, as if
// no other ball stood there. Each leg of the ball that was touched passes the next one at some offset, which is
// continuous along a route; so false position finds where a band begins and ends, and where the last ball is on its
// exact line. From there Newton's method on the whole chain, to the speed that arrives as asked. Balls that fell
// without such a root (rolling along a rail into a pocket, say) are brought to that speed as they are. Narrow bands are
// found at the speeds where they are, which those of other speeds do not tell. Cost: two simulations an aim, some 100
// aims a speed, band and ball. Guarantee: none beyond the proof; a route narrower than the step of aims between two
// others is passed over.
#include "planners/steps/bands.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bankshot/simulate/simulator.hpp"
#include "planners/certify.hpp"
#include "planners/line_search.hpp"
#include "planners/locked/arrival.hpp"
#include "planners/locked/newton.hpp"
#include "planners/proof/replay.hpp"
#include "planners/settings.hpp"
#include "planners/start.hpp"
#include "planners/steps/leg.hpp"
#include "planners/steps/made_as_asked.hpp"
#include "planners/steps/sweeps.hpp"
#include "planners/steps/to_ball.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::bands;

class Bands {
 public:
  Bands(const Question& q, Ledger& ledger, Findings& found, const Objects::Chain& chain)
      : q_(q),
        ledger_(ledger),
        found_(found),
        chain_(chain),
        step_(q.carom() ? word::caroms : word::chains),
        at_speed_(q) {
    for (const Shot& shot : found.shots) made_.insert(route_of(shot));
    for (const Objects::Object* ball : chain.balls) alone_.emplace_back(q.puzzle.table, ball->at_rest.body);
  }

  void run() {
    if (q_.one_unknown() || q_.speed.fixed()) {
      look({q_.fixed_speed()}, false);
      if (q_.all()) bring_to_speed();
      if (found_.shots.empty()) look({q_.fixed_speed()}, true);
      return;
    }
    look({row(0), row(rows)}, false);  // wide steps first, since one root is mostly enough
    for (int step = rows / 2; step > 1; step /= 2) look(between(step), false);
    if (q_.all()) bring_to_speed();  // else at once: other routes may have roots
    if (found_.shots.empty()) look(between(1), true);
  }

 private:
  struct Band {
    Route route;  ///< with the ball that is touched
    Range aims;
  };
  /// What a ball is to meet, and how far it is sent by.
  struct Place {
    Vec2d at;
    double reach;  ///< m
    const Mark* mark = nullptr;
  };
  /// Of one leg, how a place is passed.
  struct Pass {
    double left;  ///< m, of the line of travel
    bool ahead;
  };
  /// By the routes of the ball, as they go on from the band's.
  using Passes = std::map<Route, Pass>;
  /// An aim, and what becomes of the ball.
  struct Sample {
    double aim;
    Passes passes{};
    Route route{};  ///< until it has met more than it may, falls or rests
    Contact end{};
    double nearest = forever;  ///< m, to the place
  };
  using Track = std::vector<std::optional<Pass>>;
  struct Fall {
    Launch launch;
    double arrived;  ///< m/s
    double right;    ///< m, of the pocket's centre
    const Mark* mark;
  };

  bool over() const { return sweeps_over(q_, ledger_, found_); }

  double row(int i) const {
    const double slowest = slowest_tried(q_);
    return slowest * std::pow(q_.speed.high / slowest, static_cast<double>(i) / rows);
  }

  /// The rows between those of twice the step.
  std::vector<double> between(int step) const {
    std::vector<double> speeds;
    for (int i = step; i < rows; i += 2 * step) speeds.push_back(row(i));
    return speeds;
  }

  /// Those by few cushions first, at all of these speeds.
  void look(const std::vector<double>& speeds, bool finely) {
    finely_ = finely;
    std::vector<std::pair<double, Band>> bands;
    for (const double speed : speeds) {
      at(speed);
      for (Band& band : to_first()) bands.emplace_back(speed, std::move(band));
    }
    std::ranges::stable_sort(bands, {}, [](const auto& band) { return band.second.route.size(); });
    for (const auto& [speed, band] : bands) {
      if (over()) return;
      at(speed);
      onward(band);
    }
    if (!q_.all() || finely) bring_to_speed();
  }

  void at(double speed) {
    speed_ = speed;
    if (any_arrival()) at_speed_.pinned = speed;
  }
  /// Times as many aims.
  int finer() const { return q_.one_unknown() ? settings::chains::finer_alone : 1; }

  int last() const { return static_cast<int>(chain_.balls.size()); }
  const CushionRule& rule(int ball) const {
    return ball == 0 || q_.carom() ? q_.cushions() : q_.then()->cushions_of(static_cast<std::size_t>(ball) - 1);
  }
  const Objects::Object& object(int ball) const { return *chain_.balls[static_cast<std::size_t>(ball) - 1]; }
  /// After the n-th contact the n-th ball is on its way, in a carom the struck one.
  bool is_struck(int n) const { return n == 0 || q_.carom(); }
  int number(int n) const { return is_struck(n) ? 0 : object(n).ball; }
  const Body& body(int n) const { return is_struck(n) ? q_.puzzle.ball.body : object(n).at_rest.body; }
  const Boundary& alone(int n) const { return is_struck(n) ? q_.alone() : alone_[static_cast<std::size_t>(n) - 1]; }
  Contact touch_of(int n) const { return Contact::ball(object(n).ball); }
  Place next_of(int ball) const {
    const Objects::Object& next = object(ball + 1);
    return {next.at_rest.at, body(ball).radius + next.at_rest.body.radius};
  }
  Launch launch(double aim) const { return {speed_, aim}; }

  /// From the first ball to the mark.
  void onward(const Band& first) {
    std::vector<Band> bands{first};
    for (int ball = 1; ball < last(); ++ball) {
      std::vector<Band> next;
      for (const Band& band : bands) touching(ball, band.route, across(band, cut_steps * finer()), next);
      bands = std::move(next);
    }
    for (const Mark& mark : q_.marks) {
      if (mark.ball != number(last())) continue;
      for (const Band& band : bands)
        if (!over()) roots(mark, band.route, across(band, last_steps * finer()));
    }
  }

  std::vector<Band> to_first() {
    const Place first = next_of(0);
    std::vector<Band> out;
    if (q_.cushions().max == 0 && q_.spin.masse == 0) {
      const Vec2d way = first.at - q_.puzzle.ball.at;
      const double half = widest * std::asin(std::min(1.0, first.reach / norm(way))), to = std::atan2(way.y, way.x);
      out.push_back({{{0, touch_of(1)}}, {to - half, to + half}});
      return out;
    }
    std::vector<double> fan;
    for (int i = 0; i <= fan_steps * finer(); ++i) fan.push_back(radians(360.0) * i / (fan_steps * finer()));
    touching(0, {}, fan, out);
    return out;
  }

  static std::vector<double> across(const Band& band, int each_way) {
    std::vector<double> aims;
    const double middle = (band.aims.low + band.aims.high) / 2, half = (band.aims.high - band.aims.low) / 2;
    for (int i = -each_way; i <= each_way; ++i)
      aims.push_back(middle + half * std::sin(settings::chains::widest_cut * i / each_way));
    return aims;
  }

  /// The bands from which a ball touches the next, of aims in turn.
  void touching(int ball, const Route& before, const std::vector<double>& tried, std::vector<Band>& out) {
    const Place place = next_of(ball);
    each_track(ball, before, place, tried,
               [&](const Route& route, const std::vector<double>& aims, const Track& track) {
                 Route touched = joined(before, route);
                 const auto left = [&](double aim) { return left_of(touched, ball, place, aim); };
                 const std::vector<Range> inside = passing(aims, track, widest * place.reach, left);
                 touched.push_back({number(ball), touch_of(ball + 1)});
                 for (const Range& range : inside) out.push_back({touched, range});
               });
  }

  /// Where a track passes within `edge`.
  template <class Left>
  std::vector<Range> passing(const std::vector<double>& aims, const Track& track, double edge, const Left& left) {
    std::vector<Range> out;
    bool open = false;
    double low = 0;
    const auto begin = [&](double aim) { open = true, low = aim; };
    const auto end = [&](double aim) {
      if (std::exchange(open, false)) out.push_back({low, aim});
    };
    for (std::size_t i = 0; i < aims.size(); ++i) {
      if (!track[i]) {
        if (i > 0) end(aims[i - 1]);
        continue;
      }
      const double to = track[i]->left;
      const bool inside = std::abs(to) < edge;
      if (i > 0 && track[i - 1] && (track[i]->ahead || track[i - 1]->ahead)) {
        const double from = track[i - 1]->left;
        const auto at_level = [&](double level) {
          return crossing(aims[i - 1], from - level, aims[i], to - level, [&](double aim) {
            const auto l = left(aim);
            return l ? std::optional(*l - level) : std::nullopt;
          });
        };
        if (const bool was = std::abs(from) < edge; was && !inside) {
          end(at_level(std::copysign(edge, to)));
        } else if (!was && inside) {
          begin(at_level(std::copysign(edge, from)));
        } else if (!was && (from > 0) != (to > 0)) {
          begin(at_level(std::copysign(edge, from)));
          end(at_level(std::copysign(edge, to)));
        }
      }
      if (inside && !open && track[i]->ahead) begin(aims[i]);
    }
    if (!aims.empty()) end(aims.back());
    return out;
  }

  /// Where the last ball is on its exact line, and from there as fast as asked.
  void roots(const Mark& mark, const Route& before, const std::vector<double>& tried) {
    const Place place{mark.at, mark.reach, &mark};
    each_track(last(), before, place, tried,
               [&](const Route& route, const std::vector<double>& aims, const Track& track) {
                 const Route whole = joined(before, route);
                 for (std::size_t i = 1; i < aims.size(); ++i) {
                   const auto &a = track[i - 1], &b = track[i];
                   if (over()) return;
                   if (!a || !b || (a->left > 0) == (b->left > 0) || !(a->ahead || b->ahead)) continue;
                   root(mark, whole, crossing(aims[i - 1], a->left, aims[i], b->left, [&](double aim) {
                          return left_of(whole, last(), place, aim);
                        }));
                 }
               });
  }

  void root(const Mark& mark, const Route& route, double at) {
    if (any_arrival() && made_.contains(route)) return;
    const Question& own = any_arrival() ? at_speed_ : q_;
    const LockedAim aim{own, route, mark};
    const auto l = linearise(aim, ledger_, launch(at));
    const auto step = l ? newton_step(*l, own.one_unknown()) : std::nullopt;
    if (!step || !(std::abs((*step)[1]) < farthest)) return;
    std::vector<Launch>& known = roots_[route];
    const auto found = newton(aim, ledger_, launch(at), settings::wide);
    if (!found) return;
    const auto same = [&](const Launch& k) {
      return std::abs(angle_difference(k.angle, found.launch.angle)) < settings::parts::alike &&
             std::abs(std::log(k.speed / found.launch.speed)) < settings::parts::alike;
    };
    if (std::ranges::any_of(known, same)) return;
    known.push_back(found.launch);
    if (certify_root(aim, ledger_, found_, found.launch, step_)) made_.insert(route);
  }

  /// All of a range will do, so the row's speed is one.
  bool any_arrival() const { return q_.carom() && !q_.one_unknown() && !q_.arrival->fixed(); }

  static Route joined(const Route& a, const Route& b) {
    Route out = a;
    out.insert(out.end(), b.begin(), b.end());
    return out;
  }

  /// `look(route, aims, its passes)` of each route that some aim has, with its neighbours' on the locked path.
  template <class Look>
  void each_track(int ball, const Route& before, const Place& place, const std::vector<double>& aims,
                  const Look& look) {
    const std::vector<Sample> samples = followed(ball, before, place, aims);
    std::vector<double> all;
    std::map<Route, Track> tracks;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      all.push_back(samples[i].aim);
      for (const auto& [route, pass] : samples[i].passes) {
        Track& track = tracks[route];
        track.resize(samples.size());
        track[i] = pass;
      }
    }
    for (auto& [route, track] : tracks) {
      const Track real = track;
      const Route whole = joined(before, route);
      for (std::size_t i = 0; i < all.size(); ++i)
        if (!real[i] && ((i > 0 && real[i - 1]) || (i + 1 < all.size() && real[i + 1])))
          track[i] = locked_pass(whole, ball, place, all[i]);
      look(route, all, track);
    }
  }

  std::vector<Sample> followed(int ball, const Route& before, const Place& place, const std::vector<double>& aims) {
    std::vector<Sample> out;
    for (const double aim : aims) {
      if (over()) break;
      Sample now = follow(ball, before, place, aim);
      if (finely_ && place.mark && place.mark->captures() && !out.empty())
        divide(ball, before, place, Sample(out.back()), now, out);
      out.push_back(std::move(now));
    }
    return out;
  }

  /// Between two aims whose balls end otherwise, near the mark: others may end there.
  void divide(int ball, const Route& before, const Place& place, const Sample& a, const Sample& b,
              std::vector<Sample>& out, int left = most_divisions) {
    if (left == 0 || (a.route == b.route && a.end == b.end) || over() ||
        !(std::min(a.nearest, b.nearest) < near * place.reach))
      return;
    const Sample middle = follow(ball, before, place, (a.aim + b.aim) / 2);
    divide(ball, before, place, a, middle, out, left - 1);
    out.push_back(middle);
    divide(ball, before, place, middle, b, out, left - 1);
  }

  int least(int ball) const { return q_.carom() && ball == 0 ? 0 : rule(ball).min; }
  bool is_on(int ball, const std::vector<Contact>& met) const {
    const auto& asked = rule(ball).sequence;
    return static_cast<int>(met.size()) <= rule(ball).max &&
           (!asked || (met.size() <= asked->size() && std::equal(met.begin(), met.end(), asked->begin())));
  }

  /// The ball that this aim sends on, as if it were alone from then.
  Sample follow(int ball, const Route& before, const Place& place, double aim) {
    Sample out{aim};
    ledger_.charge(before.size(), before.empty() ? 1 : 2);
    with_physics(q_.puzzle.physics, [&](const auto& motion, const auto& cushion) {
      const auto path = follow_locked(q_.balls(), motion, cushion, before, start_of(q_, launch(aim)));
      if (path.end != LockedEnd::complete || !(dot(path.state.velocity, path.state.velocity) > 0)) return;
      onward(motion, cushion, ball, path.state, before, place, out);
    });
    return out;
  }

  template <class Motion, class Cushion>
  void onward(const Motion& motion, const Cushion& cushion, int ball, const State<double>& sent, const Route& before,
              const Place& place, Sample& out) {
    Simulator sim(alone(ball), motion, cushion, sent);
    std::vector<Contact> met;
    if (ball > 0 && q_.carom()) met = contacts_of(before);
    for (;;) {
      double nearest = forever;
      Pass pass{0, false};
      State<double> passing = sent;
      const auto look = [&](const Arc<double>& arc, double travelled) {
        const double t = closest_time(arc, travelled, place.at);
        const Vec2d off = place.at - arc.position(t), v = arc.velocity_at(t);
        if (!(norm(off) < nearest) || !(norm(v) > 0)) return;
        nearest = norm(off), pass = pass_of(place, v / norm(v), off);
        passing.at = arc.position(t), passing.velocity = v;
      };
      Event e;
      do {
        e = sim.step(forever, look);
        look(sim.arc(), sim.travelled());
      } while (e.kind == EventKind::slide_to_roll);
      const bool counts = static_cast<int>(met.size()) >= least(ball);
      out.end = e.contact;
      out.nearest = std::min(out.nearest, nearest);
      if (counts && nearest < forever) out.passes.emplace(out.route, pass);
      if (counts && place.mark && e.kind == EventKind::pocket && e.contact == place.mark->taken_by)
        fell(joined(before, out.route), *place.mark, sim.state(), out.aim);
      if (counts && place.mark && !place.mark->drops() && nearest < place.reach)
        fell(joined(before, out.route), *place.mark, passing, out.aim);
      if (e.kind != EventKind::cushion) return;
      met.push_back(e.contact);
      if (!is_on(ball, met)) return;
      out.route.push_back({number(ball), e.contact});
    }
  }

  void fell(const Route& route, const Mark& mark, const State<double>& s, double aim) {
    const double speed = norm(s.velocity);
    if (speed > 0) falls_[route].push_back({launch(aim), speed, -cross(s.velocity, mark.at - s.at) / speed, &mark});
  }

  static Pass pass_of(const Place& place, const Vec2d& u, const Vec2d& off) {
    const double left = place.mark ? beside_exact(*place.mark, u, off) : cross(u, off);
    return {left, dot(u, off) > -place.reach};
  }

  std::optional<Pass> locked_pass(const Route& route, int ball, const Place& place, double aim) {
    if (ledger_.spent()) return {};
    ledger_.charge(route.size());
    return with_physics(q_.puzzle.physics, [&](const auto& motion, const auto& cushion) -> std::optional<Pass> {
      const auto path = follow_locked(q_.balls(), motion, cushion, route, start_of(q_, launch(aim)));
      if (path.end != LockedEnd::complete || !(dot(path.state.velocity, path.state.velocity) > 0)) return {};
      const auto there =
          arrive_locked(motion, body(ball), path.state, place.at, place.mark ? place.mark->capture() : 0, false);
      if (!(dot(there.heading, there.heading) > 0)) return {};
      return pass_of(place, there.heading / norm(there.heading), place.at - there.state.at);
    });
  }
  std::optional<double> left_of(const Route& route, int ball, const Place& place, double aim) {
    const auto pass = locked_pass(route, ball, place, aim);
    return pass ? std::optional(pass->left) : std::nullopt;
  }

  /// False position, the end that stays weighed down (Illinois): where `value` is 0 between a and b.
  template <class Value>
  double crossing(double a, double at_a, double b, double at_b, const Value& value) {
    double middle = a;
    const double enough = settled * (std::abs(at_a) + std::abs(at_b));
    for (int i = 0; i < most_halvings && !ledger_.spent(); ++i) {
      middle = at_a == at_b ? (a + b) / 2 : a + (b - a) * at_a / (at_a - at_b);
      const auto there = value(middle);
      if (!there) return middle;
      if (std::abs(*there) < enough) break;
      if ((*there > 0) == (at_b > 0))
        at_a /= 2;
      else
        a = b, at_a = at_b;
      b = middle, at_b = *there;
    }
    return middle;
  }

  /// Balls that fell by a route which led to no shot: those first that arrived nearly as asked.
  void bring_to_speed() {
    const Question brought = to_bring();
    const auto off = [&](const Fall& f) { return std::abs(std::log(f.arrived / brought.asked)); };
    auto all = std::exchange(falls_, {});
    for (auto& [route, falls] : all) {
      if (made_.contains(route)) continue;
      if (!q_.one_unknown()) std::ranges::sort(falls, {}, off);
      std::size_t tried = 0;
      for (const Fall& fall : falls) {
        if (over()) return;
        if (tried == most_falls) break;
        const Launch at{fall.launch.speed, wrap_angle(fall.launch.angle)};
        if (!replay(brought, ledger_, at, Goal::of(brought, Demand::made)).made) continue;
        ++tried;
        if (beside(route, fall) || by_replays(brought, route, fall)) break;
      }
    }
  }

  /// To rest at a point it is brought to pass there so slowly that it rests half as far beyond as it may.
  Question to_bring() const {
    if (!q_.stop) return q_;
    Question passing = q_;
    passing.stop = false;
    passing.asked = std::sqrt(deceleration(q_.puzzle.physics) * q_.marks.front().reach);
    passing.arrival = Range{passing.asked, passing.asked};
    return passing;
  }

  /// On the line on which it fell.
  bool beside(const Route& route, const Fall& fall) {
    if (!fall.mark->captures()) return false;
    Mark mark = *fall.mark;
    mark.cuts = Cuts{fall.right, fall.right, fall.right};
    const auto there = newton({q_, route, mark}, ledger_, fall.launch, settings::wide);
    return there && certify(q_, ledger_, found_, there.launch, bounces_of(route), step_, Demand::off_centre);
  }

  /// Where no locked path leads, along a rail for one: as the last ball is touched.
  bool by_replays(const Question& brought, const Route& route, const Fall& fall) {
    const auto made = made_as_asked(brought, ledger_, fall.launch, turn_of(route, fall.launch));
    return made && certify(q_, ledger_, found_, made->launch, made->replay.bounces, step_, Demand::off_centre);
  }

  /// Rad per ln speed that keep the cut of the last ball.
  double turn_of(const Route& route, const Launch& at) {
    const auto touch = std::ranges::find(route, touch_of(last()), &Meeting::with);
    const Route before(route.begin(), touch);
    const auto left = [&](const Launch& l) {
      speed_ = l.speed;
      return left_of(before, last() - 1, next_of(last() - 1), l.angle);
    };
    const auto here = left(at), faster = left({at.speed * (1 + small), at.angle}),
               turned = left({at.speed, at.angle + small});
    if (!here || !faster || !turned || *turned == *here) return 0;
    return -(*faster - *here) / (*turned - *here);
  }

  const Question& q_;
  Ledger& ledger_;
  Findings& found_;
  const Objects::Chain& chain_;
  std::string_view step_;
  Question at_speed_;              ///< of the row
  std::vector<Boundary> alone_{};  ///< the table as each ball sees it by itself
  double speed_ = 0;               ///< m/s, of the row
  std::map<Route, std::vector<Launch>> roots_{};
  std::map<Route, std::vector<Fall>> falls_{};
  std::set<Route> made_{};  ///< which have a shot on the exact line
  bool finely_ = false;
};

}  // namespace

void bands(const Question& q, Ledger& ledger, Findings& found, const Objects::Chain& chain) {
  Bands(q, ledger, found, chain).run();
}

}  // namespace bankshot::planning::steps
