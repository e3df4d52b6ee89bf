// SPDX-License-Identifier: MIT
#include "planners/play/leave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/evaluate/rank.hpp"
#include "planners/play/launches.hpp"
#include "planners/play/leave_success.hpp"
#include "planners/play/settings.hpp"
#include "planners/play/two_pots.hpp"
#include "planners/solve/least_change.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::play {
namespace {

using namespace settings::leave;
using branch::aim;
using branch::log_speed;

class Search {
 public:
  Search(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found)
      : request_(request),
        budget_(budget),
        found_(found),
        worth_(request.puzzle()),
        launches_(request, budget, worth_) {
    const auto balls = request.problem->whole->balls();
    for (std::size_t k = 1; k < balls.size(); ++k)
      standing_.push_back({static_cast<int>(k), balls[k].boundary, balls[k].state.at});
  }

  void run(const Roots& roots) {
    {
      // The other half of the budget is for the climbs.
      const EvaluationBudget::Part half(budget_, 2);
      const Range arrivals = request_.arrival.value_or(Range{arrival, arrival});
      const std::vector<LaunchSpin> spins = spins_to_try();
      look_by_stages(request_.starts_at(std::clamp(arrival, arrivals.low, arrivals.high), request_.spin), spins, roots);
      // Roots of another side spin, and at the speed asked for, lead to launches of their own. To an exact place the
      // spins of one root lead as well.
      for (const SearchRequest& sample : request_.samples()) {
        if (!pool_.empty() && (is_exact() || sample.asked != request_.asked)) continue;
        const auto off = [&](const LaunchSpin& s) { return std::abs(s.side - sample.spin.side) > settings::alike; };
        std::vector<LaunchSpin> alike = spins;
        std::erase_if(alike, off);
        look_by_stages(sample, alike, roots);
      }
      follow_waiting_spins();
    }
    if (asked_place() && std::ranges::none_of(pool_, [&](const Launched& one) { return on_place(one); })) {
      grid_ = close;
      const std::vector<LaunchSpin> spins = spins_to_try();
      for (const Root& root : roots_) follow(root, spins);
    }
    choose();
    hand_over();
  }

 private:
  /// Looks for roots by ever more cushions, at the arrival speed and the spin of `starts`, and follows them over these
  /// spins.
  void look_by_stages(const SearchRequest& starts, std::span<const LaunchSpin> spins, const Roots& roots) {
    const bool sent = request_.problem->then() != nullptr;
    const CushionRule &cue = request_.cue_cushions, object = sent ? request_.object_cushions : CushionRule::exactly(0);
    if (request_.problem->carom()) return look(request_, starts, spins, roots);
    for (int n = cue.min + object.min; n <= cue.max + object.max && !over(n); ++n)
      for (int c = std::max(cue.min, n - object.max); c <= std::min(cue.max, n - object.min); ++c) {
        look(request_.stage(c, n - c), starts, spins, roots);
        if (budget_.spent() && found_.not_searched < 0) found_.not_searched = n;
      }
  }

  const LeavePlace* asked_place() const { return std::get_if<LeavePlace>(&*request_.puzzle().leave); }
  /// With `centre` a place is met exactly, or as nearly as it can be.
  bool is_exact() const { return asked_place() && !launches_.safest(); }
  /// No shot by so many cushions can be better than the best that is known.
  bool over(int cushions) {
    if (budget_.spent()) return true;
    if (request_.first() && !pool_.empty()) return true;
    if (request_.all() || request_.puzzle().prefer != Prefer::robust || pool_.empty()) return false;
    measure_promising();
    return best_value() > 1 - cost_of_contacts(cushions) - cost_of({request_.speed.low, 0}, {});
  }

  double best_value() const {
    double best = -infinite;
    for (const Launched& one : pool_)
      if (one.success) best = std::max(best, one.value());
    return best;
  }

  /// The roots of a stage, and all that they lead to.
  void look(const SearchRequest& stage, const SearchRequest& sample, std::span<const LaunchSpin> spins,
            const Roots& roots) {
    SearchRequest starts = stage.starts_at(sample.asked, sample.spin);
    if (!request_.all() && !pool_.empty()) starts.likelier = std::max(0.0, best_value());
    SearchResult candidates;
    roots(starts, budget_, candidates);
    for (const Candidate& c : candidates.candidates) {
      if (budget_.spent()) return;
      routes_.push_back(c.route);
      const Vector x = branch::vector_of({c.launch.speed, branch::near_window(c.launch.angle, request_.angle)}, c.spin);
      roots_.push_back({{request_, routes_.back(), c.aim_point}, x});
      launches_.look_across(roots_.back());
      // There are many launches of each spin where any contact counts, so all spins but one wait for all roots.
      const std::size_t now = launches_.any_offset(roots_.back().branch) ? 1 : spins.size();
      follow(roots_.back(), spins.first(now));
    }
  }

  /// Values of a free spin, those nearest to none first.
  std::vector<double> values(double low, double high) const {
    if (!(low < high)) return {low};
    std::vector<double> out;
    for (int i = 0; i < grid_.spins; ++i) out.push_back(low + (high - low) * i / (grid_.spins - 1));
    std::ranges::stable_sort(out, {}, [](double v) { return std::abs(v); });
    return out;
  }

  /// Returns places across the target of a root: the middle, or several and the exact line where there is room for the
  /// player's errors beside each.
  std::vector<double> shifts_of(const Root& root) const {
    if (launches_.any_offset(root.branch)) {
      std::vector<double> out{0};
      const Cuts& cuts = *root.branch.aim_point.cuts;
      for (int i = 1; i < contacts; ++i)
        if (const double offset = cuts.low + (cuts.high - cuts.low) * i / contacts; offset != cuts.exact)
          out.push_back(cuts.exact - offset);
      return out;
    }
    if (!root.made) return {0};
    const auto [low, high] = *root.made;
    const double apart = room_for_errors * root.slope * request_.puzzle().noise.angle;
    const int count = std::clamp(static_cast<int>((high - low) / apart), 1, most_shifts);
    std::vector<double> out;
    for (int i = 0; i < count; ++i) out.push_back(low + (high - low) * (i + 0.5) / count);
    if (count > 1) out.push_back(0);
    return out;
  }

  /// Follows a root over speeds, these spins and places across the target; then to the place asked for.
  void follow(const Root& root, std::span<const LaunchSpin> spins) {
    const std::size_t first = pool_.size();
    for (const LaunchSpin& spin : spins)
      for (const double shift : shifts_of(root)) follow_speeds(root, shift, spin);
    if (asked_place()) go_to_place(root, first);
  }

  void follow_waiting_spins() {
    const std::vector<LaunchSpin> spins = spins_to_try();
    for (std::size_t i = 1; i < spins.size(); ++i)
      for (const Root& root : roots_) {
        if (budget_.spent()) return;
        if (launches_.any_offset(root.branch)) follow(root, std::span(spins).subspan(i, 1));
      }
  }

  std::vector<LaunchSpin> spins_to_try() const {
    const branch::Box& box = launches_.box();
    std::vector<LaunchSpin> out;
    for (const double top : values(box.low[branch::top], box.high[branch::top]))
      for (const double side : values(box.low[branch::side], box.high[branch::side]))
        for (const double masse : values(box.low[branch::masse], box.high[branch::masse]))
          out.push_back({top, side, masse});
    return out;
  }

  void follow_speeds(const Root& root, double shift, const LaunchSpin& spin) {
    const branch::Box& box = launches_.box();
    Vector x = root.x;
    x[branch::top] = spin.top, x[branch::side] = spin.side, x[branch::masse] = spin.masse;
    const bool given = launches_.speed_given();
    double low = root.x[log_speed] + std::log(slowest), high = root.x[log_speed] + std::log(fastest);
    if (grid_.to_bounds) low = std::max(low, box.low[log_speed]), high = std::min(high, box.high[log_speed]);
    for (int i = 0; i < (given ? 1 : grid_.speeds) && !budget_.spent(); ++i) {
      Vector from = x;
      if (!given) from[log_speed] = std::lerp(low, high, i / (grid_.speeds - 1.0));
      if (!box.free(log_speed)) from[log_speed] = box.low[log_speed];
      if (from[log_speed] < box.low[log_speed] || from[log_speed] > box.high[log_speed]) continue;
      auto one = launches_.play_near(root, from, shift);
      // At another speed than the root's the middle may be blocked.
      if (!one && shift != 0 && !launches_.any_offset(root.branch)) one = launches_.play_near(root, from, 0);
      if (!one) continue;
      x = one->x;
      pool_.push_back(*std::move(one));
    }
  }

  /// From the launches of a root that rest near the place asked for, to those that rest there.
  void go_to_place(const Root& root, std::size_t first) {
    const Vec2d wanted = asked_place()->at;
    const auto vary = request_.puzzle().spin_range ? branch::Vary::spin_too : branch::Vary::launch;
    std::map<Route, std::vector<std::pair<double, std::size_t>>> near;
    for (std::size_t i = first; i < pool_.size(); ++i) {
      const double off = norm(*pool_[i].ending.cue_rests() - wanted);
      if (pool_[i].ending.traceable) near[pool_[i].ending.cue].emplace_back(off, i);
    }
    std::vector<Launched> reached;
    for (auto& [route, from] : near) {
      std::ranges::sort(from);
      std::set<std::pair<long, long>> known;
      for (std::size_t k = 0; k < std::min(grid_.nearest, from.size()) && !budget_.spent(); ++k) {
        const Launched& start = pool_[from[k].second];
        const auto at =
            place(root.branch, budget_, {route, standing_}, wanted, launches_.box(), start.x, start.shift, vary);
        if (!at) continue;
        // Two launches that agree to 1e-6 are one.
        constexpr double apart = 1e6;
        if (!known.insert({std::lround((*at)[aim] * apart), std::lround((*at)[log_speed] * apart)}).second) continue;
        auto one = launches_.play(root, *at, start.shift);
        if (!one) continue;
        one->promise = estimated(*one) - cost_of(one->shot);
        reached.push_back(*std::move(one));
      }
    }
    std::ranges::move(reached, std::back_inserter(pool_));
  }

  double miss_of(const Launched& one) const {
    return bankshot::miss_of(*request_.puzzle().leave, *one.ending.cue_rests());
  }

  /// Returns the success of a launch by five plays: that the target is made, to first order, and what they leave.
  double estimated(const Launched& one) {
    EvaluationBudget aside(std::numeric_limits<long>::max(), budget_);
    return launches_.likely(*one.root, one.shift, one.shot) *
           estimated_worth(request_, aside, worth_, one.shot, one.ending);
  }

  /// Returns how many of the best launches are told apart from the others where so many are enough.
  std::size_t told_apart(std::size_t enough) const {
    return request_.all() || request_.puzzle().prefer != Prefer::robust ? pool_.size() : enough;
  }

  /// Measures the success of a launch by so many plays, and goes on from those that are known. It ends as soon as the
  /// value must be less than `least`; the mean so far is then less as well.
  void measure(Launched& one, int plays, double least = -infinite) {
    EvaluationBudget aside(std::numeric_limits<long>::max(), budget_);
    const auto* next = std::get_if<LeaveForNext>(&*request_.puzzle().leave);
    const auto both = [&](const Ending& ending) {
      return two_pots(request_, aside, worth_.next_pot(), next->order, ending);
    };
    const Worth worth = next && next->plies > 1 ? Worth(both) : Worth(std::cref(worth_));
    const double may_lose = (1 - least - cost_of(one.shot)) * plays;
    play_leave(request_, aside, worth, one.shot, plays, one.plays, [&](double won) {
      ++one.plays, one.lost += 1 - won;
      return one.lost <= may_lose;
    });
    // A launch without speed is no play, and wins nothing.
    if (one.lost <= may_lose) one.lost += plays - one.plays, one.plays = plays;
    one.success = 1 - one.lost / one.plays;
  }

  /// Orders by the promise, which ends with how near the cue ball comes.
  void order_pool() {
    std::ranges::stable_sort(pool_, [&](const Launched& a, const Launched& b) {
      if (a.promise != b.promise) return a.promise > b.promise;
      return miss_of(a) < miss_of(b);
    });
  }

  /// One way to play a shot: what the balls meet, and about how fast.
  using Way = std::tuple<Route, Route, long>;
  static Way way_of(const Launched& one) {
    return {route_of(one.shot), one.ending.cue, std::lround(one.x[log_speed] / alike_speed)};
  }

  /// Measures the launches that promise most; of one way to play the shot not more than two.
  void measure_promising() {
    order_pool();
    std::map<Way, int> times;
    std::size_t looked = 0;
    std::vector<double> best;
    const std::size_t enough = told_apart(compared);
    const auto add = [&](const Launched& one) {
      best.insert(std::ranges::upper_bound(best, one.value(), std::greater()), one.value());
      if (best.size() > enough) best.pop_back();
    };
    for (const Launched& one : pool_)
      if (one.success) add(one);
    for (Launched& one : pool_) {
      if (looked == looked_at) return;
      if (++times[way_of(one)] > 2) continue;
      ++looked;
      if (one.success) continue;
      measure(one, first_plays, best.size() < enough ? -infinite : best.back());
      add(one);
    }
  }

  /// Climbs from the best launches by their estimates, then by plays, from fewer of them with each halved step.
  void improve() {
    for (Launched& best : pool_) {
      Launched up = best;
      up.success = estimated(up);
      for (const double scale : {1.0, 0.5})
        launches_.climb(up, scale, [&](Launched& one) {
          one.success = estimated(one);
          return one.value() > up.value();
        });
      measure(best, step_plays);
      measure(up, step_plays, best.value());
      if (up.value() > best.value()) best = std::move(up);
    }
    double scale = 1;
    for (const std::size_t some : improved) {
      order();
      for (Launched& best : std::span(pool_).first(std::min(told_apart(some), pool_.size()))) {
        if (!(*best.success > 0)) continue;
        launches_.climb(best, scale, [&](Launched& one) {
          measure(one, step_plays, best.value());
          return one.value() > best.value();
        });
      }
      scale /= 2;
    }
  }

  bool on_place(const Launched& one) const {
    return asked_place() && miss_of(one) <= tolerance::exact_miss * request_.problem->boundary.diagonal;
  }

  /// Chooses the shots that are handed over, best first, and measures them well.
  void choose() {
    if (pool_.empty()) return;
    if (is_exact()) {
      if (std::ranges::none_of(pool_, [&](const Launched& one) { return on_place(one); })) return keep_nearest();
      std::erase_if(pool_, [&](const Launched& one) { return !on_place(one); });
    }
    measure_promising();
    if (std::ranges::none_of(pool_, [](const Launched& one) { return one.success.value_or(0) > hopeless; }))
      return keep_nearest();
    order();
    // The best of many first looks are flattered by luck.
    for (Launched& one : std::span(pool_).first(std::min(told_apart(compared), pool_.size())))
      if (one.success) measure(one, step_plays);
    order();
    std::vector<Launched> best;
    std::set<Way> known;
    for (Launched& one : pool_) {
      if (!one.success || (!request_.all() && best.size() == compared)) continue;
      if (known.insert(way_of(one)).second) best.push_back(std::move(one));
    }
    pool_ = std::move(best);
    if (!is_exact() && request_.puzzle().prefer == Prefer::robust) improve();
    order();
    pool_.resize(std::min(told_apart(improved.front()), pool_.size()));
    for (Launched& one : pool_) measure(one, judged_plays);
    order();
    if (!request_.all()) return void(pool_.erase(pool_.begin() + 1, pool_.end()));
    std::set<std::pair<Route, Route>> listed;
    std::erase_if(pool_, [&](const Launched& one) {
      return !listed.insert({route_of(one.shot), one.ending.cue}).second;
    });
  }

  /// Nothing leaves the cue ball as asked: the launch that leaves it nearest. With `safest` it is one that the player
  /// makes at least half as often as any other.
  void keep_nearest() {
    const auto likely = [](const Launched& one) { return one.shot.robustness.success_estimate; };
    const double least = launches_.safest() ? likely(*std::ranges::max_element(pool_, {}, likely)) / 2 : 0;
    const auto rank = [&](const Launched& one) { return std::tuple(likely(one) < least, miss_of(one), -likely(one)); };
    std::ranges::stable_sort(pool_, {}, rank);
    std::vector<Launched> nearest;
    std::set<Way> known;
    for (Launched& one : pool_)
      if (nearest.size() < approached && known.insert(way_of(one)).second) nearest.push_back(std::move(one));
    for (Launched& best : nearest)
      for (int k = 0; k < approach_halvings; ++k)
        launches_.climb(best, std::ldexp(1.0, -k), [&](const Launched& one) { return rank(one) < rank(best); });
    Launched& best = *std::ranges::min_element(nearest, {}, rank);
    measure(best, step_plays);
    pool_ = {std::move(best)};
    left_ = false;
  }

  /// Best first: by `prefer`, then by value.
  void order() {
    std::ranges::stable_sort(pool_, [&](const Launched& a, const Launched& b) {
      const bool first = a.success.value_or(0) > hopeless, second = b.success.value_or(0) > hopeless;
      if (first != second) return first;
      if (request_.puzzle().prefer == Prefer::soft) return a.shot.launch.speed < b.shot.launch.speed;
      if (request_.puzzle().prefer == Prefer::quick) return a.shot.path.arrival.time < b.shot.path.arrival.time;
      return a.value() > b.value();
    });
  }

  /// Returns the best pot of the next ball, if one is asked for and can be potted.
  std::optional<NextBall> next_of(const Launched& one) const {
    const auto* next = std::get_if<LeaveForNext>(&*request_.puzzle().leave);
    if (!next) return {};
    const NextPot::Best best = worth_.next_pot().best(next->order, one.ending.places);
    if (best.pocket < 0) return {};
    return NextBall{best.ball, best.pocket, best.chance};
  }

  void hand_over() {
    for (Launched& one : pool_) {
      Shot& shot = one.shot;
      const Route& cue = one.ending.cue;
      const double miss = miss_of(one);
      shot.leave = ShotLeave{*one.ending.cue_rests(),
                             miss,
                             *one.success,
                             contacts_of(std::span(cue).subspan(one.ending.after_balls)),
                             {},
                             next_of(one)};
      shot.provenance.moved = launches_.safest() && shot.verification.off_centre;
      shot.verification.digits = promised_digits(request_, shot);
      found_.shots.push_back(std::move(shot));
    }
    if (found_.shots.empty()) return;
    const Shot& best = found_.shots.front();
    const bool spins = carries_spin(request_.puzzle().physics) && !request_.puzzle().spin_range;
    if (spins && (!left_ || best.leave->success < likely_left))
      found_.add_note(R"(ranges in "ball.spin", such as "top": [-1, 1], would leave the cue ball more freely)");
    if (left_) return;
    if (best.leave->miss > 0)
      found_.add_note(fmt::format("no shot was found that stops the cue ball there; the nearest stops {:.2f} m away",
                                  best.leave->miss));
    else
      found_.add_note("no shot was found that leaves the cue ball as asked");
  }

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  LeaveWorth worth_;
  Launches launches_;
  Grid grid_ = usual;
  bool left_ = true;  ///< some shot leaves the cue ball as asked
  std::vector<StandingBall> standing_;
  std::list<Route> routes_;  ///< lists, since branches and launches point to their elements
  std::list<Root> roots_;
  std::vector<Launched> pool_;
};

}  // namespace

void leave(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Roots& roots) {
  Search(request, budget, found).run(roots);
}

}  // namespace bankshot::planning::play
