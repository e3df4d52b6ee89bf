// SPDX-License-Identifier: MIT
//
// The objects of a scene (table, physics, balls), key by key (format/key.hpp explains the rows).
#pragma once

#include <array>
#include <cstddef>

#include "bankshot/contact/cushion_registry.hpp"
#include "io/format/key.hpp"

namespace bankshot::format {

inline constexpr std::string_view table_names[] = {"pool-7ft",     "pool-8ft",   "pool-9ft",
                                                   "snooker-12ft", "carom-10ft", "seed"};
inline constexpr std::string_view layouts[] = {"none", "six"};
inline constexpr std::string_view physics_names[] = {"ideal", "rolling", "spin"};
/// The keys of the cushion laws that files can describe, in alphabetical order.
inline constexpr auto cushion_models = [] {
  constexpr std::size_t size = [] {
    std::size_t n = 0;
    for (const CushionModel& model : cushion_registry) n += model.in_files;
    return n;
  }();
  std::array<std::string_view, size> out{};
  std::size_t n = 0;
  for (const CushionModel& model : cushion_registry) {
    if (!model.in_files) continue;
    std::size_t at = n++;
    for (; at > 0 && model.key < out[at - 1]; --at) out[at] = out[at - 1];
    out[at] = model.key;
  }
  return out;
}();
/// The keys of the default law, and of one for examples.
inline constexpr std::string_view usual_cushion = CushionRow<UsualCushion>::model.key;
inline constexpr std::string_view other_cushion = CushionRow<FullestCushion>::model.key;

// The table.

inline constexpr Key mouth_keys[] = {
    {"corner", "number", "m", "pool-7ft's, scaled with the ball", "0.118", "width of the mouth of a corner pocket",
     positive},
    {"middle", "number", "m", "pool-7ft's, scaled with the ball", "0.137", "width of the mouth of a middle pocket",
     positive},
};
inline constexpr Object mouth{"mouth", "How wide the pockets of the layout `six` are; half a mouth captures.",
                              mouth_keys};

inline constexpr Key pocket_keys[] = {
    {"name", "string", "", required, R"("well")", "unique, and not `any`"},
    {"at", "point", "m", required, "[1.2, 0.6]", "its centre"},
    {"radius", "number", "m", required, "0.06",
     "a ball falls when its centre comes this close; 0 only for a ball of radius 0", at_least(0)},
};
inline constexpr Object pocket{"pocket", "A pocket of your own.", pocket_keys};

inline constexpr Key own_cushion_keys[] = {
    {"restitution", "number | {restitution_of_speed}", "", "the physics'", "0.8",
     "speed after a square bounce over the speed before", between(0, 1)},
    {"friction", "number", "", "the physics'", "0.25", "between ball and cushion; only with the physics `spin`",
     at_least(0)},
};
inline constexpr Object own_cushion{"own_cushion", "Values that the cushion of one rail has of its own.",
                                    own_cushion_keys};

inline constexpr Key pockets_key{"pockets",  "word | [{pocket}]",       "", R"("none")",
                                 R"("six")", "`six` needs a rectangle", {}, layouts};
inline constexpr Key mouth_key{
    "mouth", "{mouth}", "", "pool-7ft's, scaled with the ball", R"({"corner": 0.115})", "only with the layout `six`"};
inline constexpr Key jaws_key{"jaws", "boolean", "", "false", "true", "the cushions end in jaws at the pockets `six`"};
inline constexpr Key tilt_key{
    "tilt", "pair", "", "[0, 0]", "[0.002, 0]", "rise of the cloth per metre, along x and y", between(-1, 1)};
inline constexpr Key own_cushions_key{"cushions",
                                      "<{own_cushion}>",
                                      "",
                                      "all as in the physics",
                                      R"({"top": {"restitution": 0.8}})",
                                      "values of single cushions, by name"};

inline constexpr Key rectangle_keys[] = {
    {"length", "number", "m", required, "2.54", "from nose to nose, along x", positive},
    {"width", "number", "m", required, "1.27", "from nose to nose, along y", positive},
    pockets_key,
    mouth_key,
    jaws_key,
    tilt_key,
    own_cushions_key,
};
inline constexpr Object rectangle{"rectangle", "A table of your own with four cushions: bottom, right, top, left.",
                                  rectangle_keys};

inline constexpr Key preset_keys[] = {
    {"preset", "word", "", required, R"("pool-9ft")", "the table to change", {}, table_names},
    {"jaws", "boolean", "", "true where it has pockets", "false",
     "the cushions end in jaws at the pockets; else those are circles half as wide as their mouths"},
    {"mouth", "{mouth}", "", "the preset's", R"({"corner": 0.115})", "how wide the pockets are"},
    tilt_key,
    own_cushions_key,
};
inline constexpr Object preset{"preset", "A ready-made table, changed.", preset_keys};

inline constexpr Key polygon_keys[] = {
    {"vertices", "[point]", "m", required, "[[0, 0], [2, 0], [1, 1.5]]",
     "the corners of the cushions' noses, anticlockwise; convex or not, three or more"},
    {"names", "[string]", "", "c0, c1, …", R"(["floor", "right", "left"])",
     "one for each cushion, from vertex 0 on; a bounce on a reflex vertex i is on `v<i>`"},
    pockets_key,
    mouth_key,
    jaws_key,
    tilt_key,
    own_cushions_key,
};
inline constexpr Object polygon{"polygon", "A table of any simple outline.", polygon_keys};

// The physics.

inline constexpr Key of_speed_keys[] = {
    {"at_rest", "number", "", required, "0.01", "a of a + b·v; greater than 0 where b is", at_least(0)},
    {"per_speed", "number", "s/m", required, "0.002", "b of a + b·v", at_least(0)},
};
inline constexpr Object friction_of_speed{"friction_of_speed", "Rolling friction a + b·v at speed v.", of_speed_keys};

inline constexpr Key bounce_of_speed_keys[] = {
    {"at_rest", "number", "", required, "0.9", "a of a + b·v", between(0, 1)},
    {"per_speed", "number", "s/m", required, "-0.03", "b of a + b·v + c·v², the sum kept between 0 and 1"},
    {"per_speed2", "number", "s²/m²", "0", "-0.01", "c of a + b·v + c·v²"},
};
inline constexpr Object restitution_of_speed{
    "restitution_of_speed", "Restitution a + b·v + c·v² at the speed v towards the cushion.", bounce_of_speed_keys};

inline constexpr Text usual_model{"\"", usual_cushion, "\""}, other_model{"\"", other_cushion, "\""};
/// Returns the row of a coefficient. The radius of a ball is not known here, so it bounds nothing.
constexpr Key key_of(const CushionCoefficient& c) {
  return {
      c.key(), "number", c.unit, c.fallback, c.example, c.meaning, c.in_ball_radii ? Bounds{} : between(c.low, c.high)};
}
inline constexpr auto cushion_keys = [] {
  constexpr std::size_t own = 2;
  std::array<Key, own + std::size(cushion_coefficients)> out{
      {{"model", "word", "", usual_model, other_model, "the law of a bounce", {}, cushion_models},
       {"restitution", "number | {restitution_of_speed}", "", "0.85", "0.9",
        "speed after a square bounce over the speed before", between(0, 1)}}};
  for (std::size_t i = 0; i < std::size(cushion_coefficients); ++i) out[own + i] = key_of(*cushion_coefficients[i]);
  return out;
}();
inline constexpr Object cushion{"cushion", "What a bounce does with speed and spin.", cushion_keys};

inline constexpr Key gravity_key{"g", "number", "m/s²", "9.81", "9.8", "gravity", positive};

inline constexpr auto coefficient_names = [] {
  constexpr std::string_view before[] = {"sliding_friction",
                                         "rolling_friction",
                                         "rolling_friction.at_rest",
                                         "rolling_friction.per_speed",
                                         "spinning_friction",
                                         "friction",
                                         "restitution",
                                         "cushion.restitution",
                                         "cushion.restitution.at_rest",
                                         "cushion.restitution.per_speed",
                                         "cushion.restitution.per_speed2"};
  constexpr std::string_view after[] = {"ball_ball.restitution", "ball_ball.friction", "ball_ball.friction.a",
                                        "ball_ball.friction.b", "ball_ball.friction.c"};
  std::array<std::string_view, std::size(before) + std::size(cushion_coefficients) + std::size(after)> out{};
  std::size_t n = 0;
  for (const std::string_view name : before) out[n++] = name;
  for (const CushionCoefficient* c : cushion_coefficients) out[n++] = c->name;
  for (const std::string_view name : after) out[n++] = name;
  return out;
}();
inline constexpr Key covariance_keys[] = {
    {"names",
     "[word]",
     "",
     required,
     R"(["cushion.friction"])",
     "of coefficients, as `fit` names them",
     {},
     coefficient_names},
    {"matrix", "[[number]]", "", required, "[[0.0001]]", "their covariance, in the units of each"},
};
inline constexpr Object covariance{"covariance", "How well the coefficients are known: written by `fit`.",
                                   covariance_keys};
inline constexpr Key covariance_key{
    "covariance",
    "{covariance}",
    "",
    "they are exact",
    R"({"names": ["cushion.friction"], "matrix": [[0.0001]]})",
    "how well the coefficients are known, written by `fit`; `success` then allows for all values that they may have"};

inline constexpr std::string_view only_ideal[] = {"ideal"}, only_rolling[] = {"rolling"}, only_spin[] = {"spin"};
inline constexpr Key ideal_keys[] = {
    {"model", "word", "", required, R"("ideal")", "", {}, only_ideal},
};
inline constexpr Object ideal{"ideal", "No friction: constant speed, and cushions that are mirrors.", ideal_keys};

inline constexpr Key rolling_balls_keys[] = {
    {"restitution", "number", "", "0.95", "1", "speed at which two balls part over that at which they met",
     between(0, 1)},
};
inline constexpr Object rolling_balls{
    "rolling_balls", "What a contact of two balls does, after which both roll at once.", rolling_balls_keys};

inline constexpr Key friction_of_slip_keys[] = {
    {"a", "number", "", required, "0.00995", "a of a + b exp(−c·s)", at_least(0)},
    {"b", "number", "", required, "0.108", "b of a + b exp(−c·s)", at_least(0)},
    {"c", "number", "s/m", required, "1.088", "c of a + b exp(−c·s)", at_least(0)},
};
inline constexpr Object friction_of_slip{
    "friction_of_slip", "Friction of two balls a + b exp(−c·s) at the slip speed s.", friction_of_slip_keys};

inline constexpr Key ball_ball_keys[] = {
    {"restitution", "number", "", "0.95", "0.93", "speed at which two balls part over that at which they met",
     between(0, 1)},
    {"friction", "number | {friction_of_slip}", "", "0.05", "0.06", "between two balls: throw", at_least(0)},
};
inline constexpr Object ball_ball{"ball_ball", "What a contact of two balls does.", ball_ball_keys};

inline constexpr Key rolling_keys[] = {
    {"model", "word", "", required, R"("rolling")", "", {}, only_rolling},
    {"friction", "number", "", "0.01", "0.05", "deceleration over g", at_least(0)},
    {"restitution", "number", "", "0.85", "1", "speed towards the cushion after a bounce over that before",
     between(0, 1)},
    gravity_key,
    {"ball_ball", "{rolling_balls}", "", "restitution 0.95", R"({"restitution": 1})",
     "what a contact of two balls does"},
    covariance_key,
};
inline constexpr Object rolling{"rolling", "The ball rolls from the start, and cushions are mirrors that take speed.",
                                rolling_keys};

inline constexpr Text cushion_example{R"({"model": ")", other_cushion, R"(", "friction": 0.14})"};
inline constexpr Key spin_keys[] = {
    {"model", "word", "", required, R"("spin")", "", {}, only_spin},
    {"sliding_friction", "number", "", "0.2", "0.22", "between ball and cloth while it slides", at_least(0)},
    {"rolling_friction", "number | {friction_of_speed}", "", "0.01", "0.012",
     "deceleration over g of a ball that rolls", at_least(0)},
    {"spinning_friction", "number", "", "(4/9 per metre) R", "0.0127", "how fast spin about the vertical dies out",
     at_least(0)},
    gravity_key,
    {"cushion", "{cushion}", "", usual_cushion, cushion_example, "what a bounce does"},
    {"ball_ball", "{ball_ball}", "", "restitution 0.95, friction 0.05", R"({"friction": 0.06})",
     "what a contact of two balls does"},
    covariance_key,
};
inline constexpr Object spin_physics{"spin_physics", "Sliding, rolling, side spin and massé, as on cloth.", spin_keys};

// The ball.

inline constexpr Key spins_keys[] = {
    {"top", "range", "natural roll", "0", "[-0.5, 1]", "follow: 0 slides, 1 rolls from the start, -1 draws"},
    {"side", "range", "natural roll", "0", "0.5", "english: positive is right-hand, anticlockwise seen from above"},
    {"masse", "range", "natural roll", "0", "0.2",
     "massé, spin about the line of travel: positive curves to the right"},
};
inline constexpr Object spins{
    "spins",
    "Spin at launch, each ω R / v; a pair [low, high] leaves the choice to the planner. Spin that no tip on the ball "
    "can give (2/5 R √(top² + side²) above R) is `invalid` in a puzzle.",
    spins_keys};

inline constexpr std::string_view hand_words[] = {"anywhere"}, hand_lines[] = {"head-string"};
inline constexpr Key behind_keys[] = {
    {"behind",
     "word",
     "",
     required,
     R"("head-string")",
     "the first quarter of a pool table, or the D of a snooker table",
     {},
     hand_lines},
};
inline constexpr Object behind{"behind", "Ball in hand behind a line.", behind_keys};

inline constexpr Key ball_keys[] = {
    {"at",
     "point | word | [point] | {behind}",
     "m",
     required,
     "[0.635, 0.4]",
     "its centre; at least the radius away from every cushion, and in no pocket. In a puzzle it may be in hand, and "
     "the "
     "planner chooses the place: `anywhere`, inside a polygon, or behind a line",
     {},
     hand_words},
    {"radius", "number", "m", "that of the table's preset, else 0.028575", "0.03",
     "0 is a point, in `ideal` and `rolling`", at_least(0)},
    {"mass", "number", "kg", "that of the table's preset, else 0.170097", "0.17", "", positive},
    {"spin", "{spins}", "", "no spin", R"({"side": 0.5})", "only with the physics `spin`"},
};
inline constexpr Object ball{"ball", "The cue ball.", ball_keys};

inline constexpr Key other_keys[] = {
    {"id", "string", "", required, R"("8")", "unique, and not `cue`"},
    {"at", "point", "m", required, "[1.9, 0.635]",
     "its centre, in no pocket; balls touch at 2 √(R1 R2) in plan, and overlap by no more than 1e-9 m (see `settle`)"},
    {"radius", "number", "m", "the cue ball's", "0.0262", "", positive},
    {"mass", "number", "kg", "the cue ball's", "0.17", "", positive},
};
inline constexpr Object other{"other", "A ball that stands on the table.", other_keys};

}  // namespace bankshot::format
