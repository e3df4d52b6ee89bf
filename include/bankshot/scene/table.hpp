// SPDX-License-Identifier: MIT
//
// The table: a simple polygon of cushion nose lines, vertices anticlockwise, and its pockets.
// Lengths in metres. A rectangle is the polygon (0,0) (length,0) (length,width) (0,width) with
// the cushions bottom, right, top, left.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bankshot/contact/rail_cushion.hpp"
#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/body.hpp"

namespace bankshot {

/// How the cushions end at a pocket: each rail in a round tip, and that in a straight facing which leads in. Source:
/// the shape of pooltool's tables.
struct Jaws {
  Vec2d at{};    ///< the corner of the nose lines, or the middle of the mouth
  double mouth;  ///< m, between the points where the rails would end without tips
  double angle;  ///< rad, inside the rubber, between rail and facing
  double tip;    ///< m, its radius
  double depth;  ///< m, how far the facings reach behind the nose line

  bool operator==(const Jaws&) const = default;
};

/// A ball whose centre comes within `radius` of `at` is pocketed.
struct Pocket {
  std::string name;
  Vec2d at;
  double radius;
  std::optional<Jaws> jaws{};

  /// On the nose lines: its corner, or the middle of its mouth; without jaws its centre.
  const Vec2d& place() const { return jaws ? jaws->at : at; }
  /// Half its mouth [m].
  double half() const { return jaws ? jaws->mouth / 2 : radius; }
  bool operator==(const Pocket&) const = default;
};

/// Widths of the pocket mouths [m]; a capture radius is half of one.
struct Mouth {
  double corner, middle;
};

inline constexpr Mouth pool_7ft_mouth{0.118, 0.137};

struct Table {
  std::vector<Vec2d> vertices{};
  std::vector<std::string> cushions{};  ///< cushions[i] runs from vertex i to vertex i+1
  std::vector<Pocket> pockets{};
  std::vector<RailCushion> own{};  ///< of each cushion, in their order; none where all are the physics'

  bool operator==(const Table&) const = default;
  bool is_rectangle() const;
  /// Diagonal of the bounding box: the length that tolerances are scaled with.
  double diagonal() const;
  Vec2d lowest() const;   ///< lower-left corner of the bounding box
  Vec2d highest() const;  ///< upper-right corner of the bounding box
};

/// How a pocket is seen from the table. `out`: unit, away from the rails that it cuts; 0 in the open. `half_view`
/// [rad]: a line that turns so far from `out` is parallel to one of them.
struct PocketView {
  Vec2d out;
  double half_view;
};
PocketView view(const Table& table, const Pocket& pocket);

/// A table without pockets.
Table rectangle_table(double length, double width);
Table polygon_table(std::vector<Vec2d> vertices);

/// A pocket with jaws: lengths in metres, the angle in radians (see Jaws). `capture`: the radius of its circle, whose
/// centre is `set_back` behind the corner of the nose lines or the middle of the mouth.
struct JawShape {
  double mouth, angle, tip, capture, set_back;
};
struct JawShapes {
  JawShape corner, middle;
  double depth;  ///< of the facings
};
extern const JawShapes pool_7ft_jaws;
JawShapes with_mouth(JawShapes jaws, Mouth mouth);
/// All lengths times `by`.
Mouth scaled(Mouth mouth, double by);
JawShapes scaled(const JawShapes& jaws, double by);

/// bottom-left, bottom-middle, bottom-right, top-left, top-middle, top-right of a rectangle.
std::vector<Pocket> six_pockets(const Table& rectangle, Mouth mouth);
std::vector<Pocket> six_pockets_with_jaws(const Table& rectangle, const JawShapes& jaws);

/// A ready-made table with the ball that is played on it.
struct TablePreset {
  std::string_view name;
  double length, width;                 ///< playing area [m]
  Body body;                            ///< the ball
  std::optional<Mouth> mouth;           ///< no pockets without
  std::optional<double> nose_height{};  ///< of the cushions over the cloth [m]; without, 1.28 R of that ball
  std::optional<JawShapes> jaws{};

  double nose() const { return nose_height.value_or(1.28 * body.radius); }
};

/// Sources: WPA equipment specification, WPBSA and UMB rules; `seed` is the seed article's table.
const std::vector<TablePreset>& table_presets();
const TablePreset* find_table_preset(std::string_view name);
/// Its pockets with jaws, or as plain circles half as wide as their mouths.
Table make_table(const TablePreset& preset, bool jaws = true);

}  // namespace bankshot
