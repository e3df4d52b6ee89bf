// SPDX-License-Identifier: MIT
//
// The table: a simple polygon of cushion nose lines with anticlockwise vertices, and its pockets.
// Lengths are in metres. A rectangle is the polygon (0,0) (length,0) (length,width) (0,width) with
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

/// The shape of the cushions at a pocket. Each rail ends in a round tip, followed by a straight facing that leads into
/// the pocket. Source: the tables of pooltool.
struct Jaws {
  Vec2d at{};    ///< the corner of the nose lines, or the middle of the mouth
  double mouth;  ///< m; between the points where the rails would end without tips
  double angle;  ///< rad; inside the rubber, between rail and facing
  double tip;    ///< m; radius of the tip
  double depth;  ///< m; how far the facings reach behind the nose line

  bool operator==(const Jaws&) const = default;
};

/// A ball whose centre comes within `radius` of `at` is pocketed.
struct Pocket {
  std::string name;
  Vec2d at;
  double radius;
  std::optional<Jaws> jaws{};

  /// Returns its point on the nose lines: the corner or the middle of the mouth. Without jaws, it is the centre.
  const Vec2d& place() const { return jaws ? jaws->at : at; }
  /// Returns half the width of the mouth [m].
  double half() const { return jaws ? jaws->mouth / 2 : radius; }
  bool operator==(const Pocket&) const = default;
};

/// Widths of the pocket mouths [m]. The capture radius of a pocket without jaws is half the width.
struct Mouth {
  double corner, middle;
};

inline constexpr Mouth pool_7ft_mouth{0.118, 0.137};

struct Table {
  std::vector<Vec2d> vertices{};
  std::vector<std::string> cushions{};  ///< cushions[i] runs from vertex i to vertex i+1
  std::vector<Pocket> pockets{};
  std::vector<RailCushion> own{};  ///< own coefficients of each cushion, in order; empty if all use the physics'

  bool operator==(const Table&) const = default;
  bool is_rectangle() const;
  /// Returns the diagonal of the bounding box, the length that scales tolerances.
  double diagonal() const;
  Vec2d lowest() const;   ///< lower-left corner of the bounding box
  Vec2d highest() const;  ///< upper-right corner of the bounding box
};

/// The view of a pocket from the table. `out` is the unit vector away from the table, across the rails that the pocket
/// interrupts; 0 if it interrupts none. A line at an angle of `half_view` [rad] from `out` is parallel to one of the
/// rails.
struct PocketView {
  Vec2d out;
  double half_view;
};
PocketView view(const Table& table, const Pocket& pocket);

/// Both return a table without pockets.
Table rectangle_table(double length, double width);
Table polygon_table(std::vector<Vec2d> vertices);

/// The dimensions of a pocket with jaws: lengths in metres, the angle in radians (see Jaws). `capture` is the radius of
/// its circle, whose centre is `set_back` behind the corner of the nose lines or the middle of the mouth.
struct JawShape {
  double mouth, angle, tip, capture, set_back;
};
struct JawShapes {
  JawShape corner, middle;
  double depth;  ///< m; depth of the facings
};
extern const JawShapes pool_7ft_jaws;
JawShapes with_mouth(JawShapes jaws, Mouth mouth);
/// Returns the shape with all lengths multiplied by `by`.
Mouth scaled(Mouth mouth, double by);
JawShapes scaled(const JawShapes& jaws, double by);

/// Returns the pockets bottom-left, bottom-middle, bottom-right, top-left, top-middle, top-right of a rectangle.
std::vector<Pocket> six_pockets(const Table& rectangle, Mouth mouth);
std::vector<Pocket> six_pockets_with_jaws(const Table& rectangle, const JawShapes& jaws);

/// A ready-made table with the ball that is played on it.
struct TablePreset {
  std::string_view name;
  double length, width;                 ///< playing area [m]
  Body body;                            ///< the ball
  std::optional<Mouth> mouth;           ///< none: no pockets
  std::optional<double> nose_height{};  ///< height of the cushion nose above the cloth [m]; default 1.28 R
  std::optional<JawShapes> jaws{};

  double nose() const { return nose_height.value_or(1.28 * body.radius); }
};

/// Sources: WPA equipment specification, WPBSA and UMB rules; `seed` is the seed article's table.
const std::vector<TablePreset>& table_presets();
const TablePreset* find_table_preset(std::string_view name);
/// Makes the preset's table. Its pockets have jaws, or are plain circles whose radius is half the mouth.
Table make_table(const TablePreset& preset, bool jaws = true);

}  // namespace bankshot
