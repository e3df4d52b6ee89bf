// SPDX-License-Identifier: MIT
//
// What is asked. SI units and radians; the JSON form (degrees) is read by scene/json.hpp.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "bankshot/geometry/contact.hpp"
#include "bankshot/scene/ball.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/scene/table.hpp"
#include "bankshot/scene/target.hpp"

namespace bankshot {

/// A closed range; `[a, a]` fixes the value.
struct Range {
  double low, high;
  bool fixed() const { return low == high; }
  bool contains(double v) const { return low <= v && v <= high; }
};

enum class Prefer { robust, soft, quick };
/// centre: an exact root. safest: may leave it, inside what still counts as made, to raise the value.
enum class Aim { centre, safest };

/// Spins that the planner may choose from, each in units of natural roll (see LaunchSpin).
struct SpinRange {
  Range top{0, 0}, side{0, 0}, masse{0, 0};
};

/// Standard deviations of a player's errors, which are normal and independent.
struct Noise {
  double angle = radians(0.125);  ///< rad, of the aim
  double speed = 0.075;           ///< m/s, of the launch
  double side = 0, top = 0;       ///< of the spin at launch, in units of LaunchSpin
  double at = 0;                  ///< m, of each coordinate of each ball; the aim stays
  double speed_share = 0;         ///< of the launch speed
  double tip = 0;                 ///< m, of each coordinate of the place where the tip meets the ball

  /// m/s, of a launch at this speed.
  double speed_at(double launch_speed) const {
    return speed_share > 0 ? std::hypot(speed, speed_share * launch_speed) : speed;
  }
  /// In units of LaunchSpin, from the tip too.
  double side_of(double radius) const { return spin_of(side, radius); }
  double top_of(double radius) const { return spin_of(top, radius); }
  /// In more than aim and speed.
  bool in_more() const { return side > 0 || top > 0 || at > 0 || tip > 0; }
  /// In nothing at all.
  bool none() const { return angle == 0 && speed == 0 && speed_share == 0 && !in_more(); }
  bool operator==(const Noise&) const = default;

 private:
  double spin_of(double own, double radius) const { return tip > 0 ? std::hypot(own, tip / (0.4 * radius)) : own; }
};

/// A player by name, as `noise` of a puzzle may give it.
struct Player {
  std::string_view name;
  Noise noise;
  std::string_view about;   ///< what the errors mean
  std::string_view source;  ///< where the numbers come from
};
/// From the best to the worst.
std::span<const Player> players();

struct Puzzle {
  std::string id{};     ///< JSON text of the identifier, echoed in the answer; empty without
  std::string about{};  ///< JSON text of whatever the author wrote there, echoed too; empty without
  Table table{};
  Physics physics = rolling_physics();
  Ball ball{};
  std::vector<Ball> others{};             ///< at rest; number k of them is ball k + 1
  LaunchSpin spin{};                      ///< at launch, where `spin_range` is not given
  std::optional<SpinRange> spin_range{};  ///< then `prefer` chooses
  Target target{};
  CushionRule cushions{};
  std::optional<Range> arrive{};  ///< speed at the target [m/s]; the default depends on the target
  Range speed{0.1, 10};           ///< launch speed [m/s]
  std::optional<Range> angle{};   ///< rad, from low anticlockwise to high; high may exceed 2π
  Prefer prefer = Prefer::robust;
  /// m: of shots as robust as any, that after which the cue ball rests nearest to this. With balls as targets.
  std::optional<Vec2d> leave{};
  std::optional<Aim> aim{};          ///< the default depends on the target: `aim_of`
  Noise noise{.speed_share = 0.03};  ///< the Computer Olympiad's pool noise, which grows with the speed
  std::optional<long> budget{};      ///< simulations; the default depends on the target: `budget_of`
  /// m: by how much `settle` moved each ball, the cue ball first; empty where it was not asked for.
  std::vector<Vec2d> settled{};

  /// The chance of a shot is that under more than errors of aim and speed.
  bool errs_in_more() const { return noise.in_more() || physics.errors; }
};

/// A `simulate` document: a scene and a launch, and when to stop looking.
struct ShotRequest {
  std::string id{};
  Table table{};
  Physics physics = rolling_physics();
  Ball ball{};
  std::vector<Ball> others{};  ///< at rest; number k of them is ball k + 1
  Launch launch{1, 0};
  LaunchSpin spin{};
  struct Until {
    std::optional<double> time{};    ///< s
    std::optional<int> cushions{};   ///< bounces
    std::optional<double> length{};  ///< m, along the path
  } until{};
  std::vector<Vec2d> settled{};  ///< m: by how much `settle` moved each ball, as in a puzzle
};

/// The name of what can be met: the table's, and of balls `ball "8"`.
std::string contact_name(const Puzzle& puzzle, Contact contact);

/// Of the balls that are to reach its target.
std::vector<Mark> marks_of(const Puzzle& puzzle);

/// As the end of a sentence about a ball: "into top-right", "to rest in the ring", "through the ring", "onto ball "8"".
std::string target_words(const Puzzle& puzzle);

/// The aim that is given, or else `safest` with `robust` for pockets, also of other balls, and for contacts without a
/// cut; `centre` for all else.
Aim aim_of(const Puzzle& puzzle);

/// The budget that is given, or else 100,000 simulations for each six pairs of a ball and a pocket that the target
/// allows, between 100,000 and 2,000,000.
long budget_of(const Puzzle& puzzle);

/// Speed asked at the target, none where any speed does (`ideal`, or a fixed launch speed).
std::optional<Range> arrival_range(const Puzzle& puzzle);

/// The speed of a ball that never slows, where the physics is `ideal` [m/s]: the one launched or asked at the target
/// that is nearest to 1.
double ideal_speed(const Puzzle& puzzle);

/// Input that breaks a rule: `path` is the JSON path of the offender ("/ball/at/0"), empty for the
/// document itself; `line` is set when the text is no JSON at all.
class InvalidInput : public std::runtime_error {
 public:
  InvalidInput(std::string where, const std::string& reason, long at_line = 0)
      : std::runtime_error(reason), path(std::move(where)), line(at_line) {}
  std::string path;
  long line;
};

/// Throws InvalidInput when the scene breaks a rule of geometry or range.
void validate(const Puzzle& puzzle);
void validate(const ShotRequest& request);

}  // namespace bankshot
