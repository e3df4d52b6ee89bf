// SPDX-License-Identifier: MIT
//
// What to do: a launch that was replayed in the plain simulator, with its proof and how robust it is.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

struct Arrival {
  double time = 0;   ///< s since the launch
  double speed = 0;  ///< m/s
  Vec2d at{};        ///< centre of the ball [m]
};

/// How far each launch number can move down and up, the other held, with the shot still made by
/// the same cushions; none where nothing breaks it.
struct Margin {
  std::array<std::optional<double>, 2> angle;  ///< rad, [<= 0, >= 0]
  std::array<std::optional<double>, 2> speed;  ///< m/s, [<= 0, >= 0]
};

/// Of a ball with another, just before.
struct Hit {
  int ball = 0;      ///< which of the others, from 1
  double cut = 0;    ///< rad, see BallTarget
  double speed = 0;  ///< m/s
  Vec2d at{};        ///< centre of the ball that hits [m]
  int after = 0;     ///< cushions that the ball that hits had met
};

/// A ball that is sent on.
struct Onward {
  int ball = 0;                     ///< which of the others, from 1
  std::vector<Contact> cushions{};  ///< of its own, in order
};

/// What a wrong coefficient of the table costs.
struct Sensitivity {
  std::string coefficient;  ///< its path in `physics`, such as "cushion.height"; "tilt.x" and "tilt.y" are the table's
  double by;                ///< m that the arrival moves, as by_angle, per unit of the coefficient
};

struct Shot {
  Launch launch{};
  LaunchSpin spin{};
  bool cushion_stick = false;       ///< some cushion's law left the ball moving into it: it stayed there
  std::vector<Contact> cushions{};  ///< contacts in order
  Arrival arrival{};                ///< of the ball that reaches the target
  double miss = 0;                  ///< m, from the replay: to the point, or from the exact line to a pocket or ball
  double offset = 0;  ///< m, into a pocket: of the line of travel (geometry/opening.hpp); exactly 0 through its centre
  bool rattles = false;        ///< it touches the jaws of a pocket on its way
  std::vector<Contact> met{};  ///< if so, jaws and cushions in order
  std::vector<Hit> hits{};     ///< in order, up to the target
  std::vector<Onward> then{};  ///< those that are sent on, in order: the last one arrives; none: the cue ball does
  int jaws = 0;                ///< contacts with jaws, of any ball of the shot, before the target
  bool scratch = false;        ///< the cue ball falls into a pocket after it has touched its target
  std::optional<int> scratch_pocket{};  ///< which, if so
  std::optional<Vec2d> cue_rests{};     ///< m, where it comes to rest instead, when all balls do; of shots with hits
  bool off_centre = false;              ///< it is made, but beside the exact line or point
  double condition = 0;                 ///< m of arrival per rad of aim or per unit of relative speed, the larger
  /// Decimal digits of the arrival, of the table's diagonal, that can be promised; none: nine or more. 0: rounding
  /// decides how often the ball bounces at its target.
  std::optional<int> digits{};
  /// Derivatives of the arrival: where the ball rests, or else the closest point of its line of travel
  /// to the target, which moves across the line only.
  Vec2d by_angle{};  ///< m/rad
  Vec2d by_speed{};  ///< m per m/s
  /// First-order margin in standard deviations of the player: orders shots when success is not
  /// computed.
  double first_order = 0;
  double chance = 0;  ///< `success` to first order, from one simulation (planners/merit/first_order.hpp)
  std::optional<Margin> margin{};
  std::optional<double> success{};         ///< probability of a legal shot under the puzzle's noise
  std::optional<double> value{};           ///< success less `cost_of` the shot
  bool moved = false;                      ///< off its exact root, to where the value is larger
  std::vector<Sensitivity> sensitivity{};  ///< where it was asked for
  std::string planner{};
  long simulations = 0;  ///< spent until this shot was certified

  /// The number of the ball that reaches the target: 0 is the cue ball.
  int arriving() const { return then.empty() ? 0 : then.back().ball; }
  /// Cushions and jaws that any ball of the shot meets before the target.
  int contacts() const;
};

/// What a shot costs beside its success, which less this is its value: 0.005 a contact, 0.004 for each m/s of the
/// launch, 0.02 for each radius that the tip is off the centre. So a soft and simple shot wins among those about as
/// likely.
double cost_of(const Shot& shot);
/// The part of it that a launch has whatever it meets.
double cost_of(const Launch& launch, const LaunchSpin& spin);
/// The part of it for cushions and jaws.
double cost_of_contacts(int contacts);

/// How much of the ball that is hit the one that hits it covers, seen along its line of travel: 1 is a full hit, 0.5 a
/// half-ball hit. With radii a of the one that hits and b: (a + b − d) / 2b, d the distance of the line of travel from
/// the other centre. `by` is the number of the ball that hits; 0 is the cue ball.
double fullness(const Puzzle& puzzle, const Hit& hit, int by = 0);

/// The cue ball nearly touches the first object ball without being frozen to it, and the hit is fairly full: the cue
/// may strike the cue ball a second time, which is a foul.
bool may_double_hit(const Puzzle& puzzle, const Shot& shot);

/// The player makes it less than once in a hundred tries. Never in `ideal`, of a player without errors, or where
/// success is not known.
bool is_hopeless(const Puzzle& puzzle, const Shot& shot);

/// What a player should know before trying it: a likely miscue, a likely double hit. Mostly empty.
std::vector<std::string> warnings(const Puzzle& puzzle, const Shot& shot);

/// The shot as a `simulate` request that ends where the ball reaches its target.
ShotRequest as_request(const Puzzle& puzzle, const Shot& shot);
/// Of the cue ball, up to there.
Trajectory path_of(const Puzzle& puzzle, const Shot& shot);

/// The pocket that takes the ball of a made shot; null where a point is the target.
const Pocket* pocket_reached(const Puzzle& puzzle, const Shot& shot);

}  // namespace bankshot
