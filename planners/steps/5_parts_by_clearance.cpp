// SPDX-License-Identifier: MIT
//
// Parts of targets with spin: climbing to where the clearance is largest.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "planners/locked/clearance.hpp"
#include "planners/steps/parts.hpp"

namespace bankshot::planning {
namespace {

/// rad; where a bisection of aims ends, and of speeds, as a share.
constexpr double narrowest = 1e-10;

/// rad: how far the aim may turn from a root until the ball passes all of the target, its speed
/// adapted to arrive as asked.
double half_window(Search& s, const LockedAim& aim, const Launch& root) {
  const auto l = linearise(s, aim, root);
  if (!l) return 0;
  double lateral = l->by_aim[0];  // of the diagonal, per radian
  if (!s.one_unknown()) {
    const double det = l->by_aim[0] * l->by_speed[1] - l->by_aim[1] * l->by_speed[0];
    lateral = det / (s.stop ? std::hypot(l->by_speed[0], l->by_speed[1]) : l->by_speed[1]);
  }
  constexpr double widest = radians(10);
  const double half = s.reach(aim.target) / (std::abs(lateral) * s.boundary.diagonal);
  return half < widest ? half : widest;
}

/// A launch and its clearance.
struct Tried {
  double aim = 0, speed = 0;
  double room = blocked;
  static constexpr double blocked = -std::numeric_limits<double>::infinity();
};

/// The largest clearance between three aims of which the second has the most: golden sections, until little can be
/// gained. `Attempt`: (aim, guess of the speed) -> Tried.
template <class Attempt>
Tried climb(const Attempt& attempt, Tried low, Tried best, Tried high) {
  constexpr double golden = 0.3819660112501051;
  constexpr double finest = 1e-15;  // rad
  constexpr double little = 0.1;    // of what there is or is lacking
  while (high.aim - low.aim > finest) {
    const double gain = best.room - std::min(low.room, high.room);
    if (gain < little * std::abs(best.room)) break;
    const bool up = high.aim - best.aim > best.aim - low.aim;
    const Tried next = attempt(best.aim + golden * ((up ? high : low).aim - best.aim), best.speed);
    if (next.room > best.room) {
      (up ? low : high) = best;
      best = next;
    } else {
      (up ? high : low) = next;
    }
  }
  return best;
}

/// Aims around a lead at the speeds that arrive as asked, and the clearance of each: where that is largest, and
/// positive, a shot is likely and has the most room.
class Widest {
 public:
  Widest(Search& s, const LockedAim& aim, const Search::Lead& lead, std::string_view planner)
      : s_(s), aim_(aim), lead_(lead), planner_(planner) {}

  /// The largest clearance; a shot where that is enough.
  bool find(double& room) {
    const Row row = along_lead();
    for (const std::size_t i : peaks_of(row)) {
      const Tried best =
          climb([&](double aim, double guess) { return attempt(aim, guess); }, before(row, i), row[i], after(row, i));
      room = std::max(room, best.room);
      if (shot(best)) return true;
    }
    return false;
  }

  /// Beside a pocket that is grazed, the speed that arrives as asked jumps with the aim, and passes all speeds
  /// between within the jump: so follow those, each over the aims that have room.
  bool across_jumps() {
    if (s_.one_unknown() || s_.point()) return false;
    const Row row = along_lead();
    const auto peaks = peaks_of(row);
    return std::any_of(peaks.begin(), peaks.end(),
                       [&](std::size_t i) { return across_jump(before(row, i), row[i], after(row, i)); });
  }

 private:
  static constexpr std::size_t aims_across = 17, middle = aims_across / 2;
  using Row = std::array<Tried, aims_across>;

  Row along_lead() {
    Row row;
    row[middle] = attempt(lead_.launch.angle, lead_.launch.speed);
    for (std::size_t i = middle + 1; i < aims_across; ++i) row[i] = attempt(aim_at(i), row[i - 1].speed);
    for (std::size_t i = middle; i-- > 0;) row[i] = attempt(aim_at(i), row[i + 1].speed);
    return row;
  }

  static const Tried& before(const Row& row, std::size_t i) { return row[i > 0 ? i - 1 : i]; }
  static const Tried& after(const Row& row, std::size_t i) { return row[std::min(i + 1, aims_across - 1)]; }

  /// Where the clearance is larger than at the neighbours, largest first.
  static std::vector<std::size_t> peaks_of(const Row& row) {
    std::vector<std::size_t> peaks;
    for (std::size_t i = 0; i < aims_across; ++i)
      if (row[i].room > Tried::blocked && (i == 0 || row[i].room >= row[i - 1].room) &&
          (i + 1 == aims_across || row[i].room > row[i + 1].room))
        peaks.push_back(i);
    std::sort(peaks.begin(), peaks.end(), [&](auto a, auto b) { return row[a].room > row[b].room; });
    return peaks;
  }

  double aim_at(std::size_t i) const { return lead_.launch.angle + lead_.half * (static_cast<double>(i) / middle - 1); }

  Tried attempt(double aim, double guess) {
    const auto speed = s_.spent() ? std::nullopt : speed_near(s_, aim_, aim, guess);
    return speed ? at_speed(aim, *speed) : Tried{aim, guess};
  }
  Tried at_speed(double aim, double speed) {
    if (s_.spent()) return {aim, speed};
    return {aim, speed, clearance(s_, aim_, {speed, aim}).value_or(Tried::blocked)};
  }

  bool shot(const Tried& t) {
    const double least = -10 * s_.boundary.touch;  // a path through a corner has no room at all
    if (!(t.room > least) || s_.spent()) return false;
    const Launch launch{t.speed, wrap_angle(t.aim)};
    if (s_.point()) {  // from some part of a point it is not far to the point itself
      const auto root = solve_locked(s_, aim_, launch);
      if (root && certify(s_, *root, static_cast<int>(aim_.contacts.size()), planner_)) return true;
    }
    return certify(s_, launch, static_cast<int>(aim_.contacts.size()), planner_, true);
  }

  bool across_jump(const Tried& low, const Tried& best, const Tried& high) {
    constexpr int rows = 8;
    constexpr double jump = 1.002, beyond = 1.01;
    const auto [slow, fast] = std::minmax({low.speed, best.speed, high.speed});
    if (!(fast > jump * slow)) return false;
    const Range aims{low.aim - (high.aim - low.aim) / 2, high.aim + (high.aim - low.aim) / 2};
    std::optional<Roomy> last;
    for (int i = 0; i <= rows && !s_.spent(); ++i) {
      const double speed = slow / beyond * std::pow(fast / slow * beyond * beyond, static_cast<double>(i) / rows);
      const auto now = roomy(aims, speed);
      if (now && along(*now)) return true;
      if (now && last && (now->excess > 0) != (last->excess > 0) && between(aims, *last, *now)) return true;
      last = now;
    }
    return false;
  }

  /// At one speed, an aim with room, and by how much too fast it arrives.
  struct Roomy {
    Tried at;
    double excess, low, high;  ///< rad: the aims that have room
  };

  std::optional<Roomy> roomy(const Range& aims, double speed) {
    Row row;
    for (std::size_t i = 0; i < aims_across; ++i)
      row[i] = at_speed(aims.low + (aims.high - aims.low) * static_cast<double>(i) / (aims_across - 1), speed);
    const auto same_speed = [&](double aim, double) { return at_speed(aim, speed); };
    for (const std::size_t i : peaks_of(row)) {
      const Tried best = climb(same_speed, before(row, i), row[i], after(row, i));
      if (best.room > 0) return Roomy{best, excess(best.aim, speed), edge(best, aims.low), edge(best, aims.high)};
    }
    return {};
  }

  double excess(double aim, double speed) {
    const auto l = linearise(s_, aim_, {speed, aim});
    return l ? l->r[1] : 0;
  }

  /// The end of the room towards `limit`.
  double edge(const Tried& inside, double limit) {
    double in = inside.aim, out = limit;
    while (std::abs(out - in) > narrowest && !s_.spent()) {
      const double half_way = in + (out - in) / 2;
      (at_speed(half_way, inside.speed).room > 0 ? in : out) = half_way;
    }
    return in;
  }

  /// A shot at this speed, where on the way to an edge the ball gets as slow or as fast as asked.
  bool along(const Roomy& r) {
    for (const double end : {r.low, r.high}) {
      if ((excess(end, r.at.speed) > 0) == (r.excess > 0)) continue;
      double a = r.at.aim, b = end;
      for (double half_way = a + (b - a) / 2; half_way != a && half_way != b && !s_.spent(); half_way = a + (b - a) / 2)
        ((excess(half_way, r.at.speed) > 0) == (r.excess > 0) ? a : b) = half_way;
      if (shot({a, r.at.speed, 0})) return true;
    }
    return false;
  }

  bool between(const Range& aims, Roomy a, Roomy b) {
    while (b.at.speed / a.at.speed - 1 > narrowest && !s_.spent()) {
      const auto half_way = roomy(aims, std::sqrt(a.at.speed * b.at.speed));
      if (!half_way) return false;
      if (along(*half_way)) return true;
      ((half_way->excess > 0) == (a.excess > 0) ? a : b) = *half_way;
    }
    return false;
  }

  Search& s_;
  const LockedAim& aim_;
  const Search::Lead& lead_;
  std::string_view planner_;
};

}  // namespace

bool reach_part(Search& s, Search::Lead& lead, std::string_view planner) {
  const LockedAim locked{s, lead.contacts, lead.target};
  if (!(lead.half > 0)) lead.half = half_window(s, locked, lead.launch);
  return lead.half > 0 && Widest(s, locked, lead, planner).find(lead.room);
}

bool reach_part_thoroughly(Search& s, const Search::Lead& lead, std::string_view planner) {
  const LockedAim locked{s, lead.contacts, lead.target};
  return Widest(s, locked, lead, planner).across_jumps() || bisect_lead(s, lead, planner);
}

}  // namespace bankshot::planning
