// SPDX-License-Identifier: MIT
//
// The registry of cushion laws: the data of each law, and one row for each alternative of `CushionVariant`. A row says
// how files, fits, reports and documents know the law; all of them loop over the rows. The equations of a law are in
// the header of its name. A law of balls with spin is named here, there, and in the list of
// includes of contact/any_cushion.hpp.
//
//   for (const CushionModel& model : cushion_registry) std::puts(model.key.data());
//   for_each_coefficient(law, [](const CushionCoefficient& c, double value) { ... });
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "bankshot/contact/restitution.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/body.hpp"

namespace bankshot {

// The laws. Each bounces a ball off a cushion; `away` is a unit vector that points away from the cushion, into the
// table.

template <class T>
struct State;
struct ImpactCourse;

/// Reverses the normal velocity, multiplied by the restitution (contact/mirror.hpp).
template <class C>
struct MirrorOf {
  RestitutionOf<C> restitution{};

  template <class T, class N>
  void bounce(const Body& body, State<T>& s, const Vec2<N>& away) const;
};
using Mirror = MirrorOf<double>;

/// Friction at the nose, sticking or sliding (contact/han2005.hpp).
template <class C>
struct Han2005Of {
  C height{1.28 * 0.028575};  ///< h [m], R < h < 2R
  RestitutionOf<C> restitution{};
  C friction{0.2};  ///< f, between ball and cushion

  template <class T, class N>
  void bounce(const Body& body, State<T>& s, const Vec2<N>& away) const;
};
using Han2005 = Han2005Of<double>;

/// Friction at the nose and at the cloth, integrated over the impact (contact/mathavan2010.hpp).
template <class C>
struct Mathavan2010Of {
  C height{1.28 * 0.028575};  ///< h [m], R < h < 2R
  RestitutionOf<C> restitution{};
  C friction{0.2};          ///< μw, between ball and cushion
  C sliding_friction{0.2};  ///< μs, between ball and cloth, as in the motion
  double tolerance = bankshot::tolerance::impact;

  template <class T, class N>
  void bounce(const Body& body, State<T>& s, const Vec2<N>& away) const;
  /// Does what bounce() does, and returns how the impact went.
  template <class T, class N>
  ImpactCourse course(const Body& body, State<T>& s, const Vec2<N>& away) const;
};
using Mathavan2010 = Mathavan2010Of<double>;

/// Friction at a nose whose rubber gives across as well as along (contact/stronge.hpp).
template <class C>
struct StrongeOf {
  C height{1.28 * 0.028575};  ///< h [m], R < h < 2R
  RestitutionOf<C> restitution{};
  C friction{0.2};         ///< μ, between ball and cushion
  C frequency_ratio{1.8};  ///< Ω, 1 < Ω < 2: frequency of the spring across over that of the spring along

  template <class T, class N>
  void bounce(const Body& body, State<T>& s, const Vec2<N>& away) const;
};
using Stronge = StrongeOf<double>;

/// A law of your own (contact/custom.hpp).
class CushionLaw;
struct CustomCushion {
  const CushionLaw* law = nullptr;  ///< must outlive every physics it is part of
  Restitution restitution{};        ///< approximate share of vn that comes back; planners start from it

  template <class T, class N>
  void bounce(const Body& body, State<T>& s, const Vec2<N>& away) const;
};

using CushionVariant = std::variant<Mirror, Han2005, Mathavan2010, Stronge, CustomCushion>;

/// The law of balls with spin unless another is given. Simulations are compiled for it alone, and for all others
/// together (scene/physics.hpp).
using UsualCushion = Han2005;
/// The law that models most: reports take it for the truth.
using FullestCushion = Mathavan2010;

// The coefficients of cushions. Every law has a restitution besides.

struct CushionCoefficient {
  std::string_view name;                              ///< path in the physics of a puzzle
  std::string_view unit, fallback, example, meaning;  ///< its row in docs/format.md
  double low, high;                                   ///< allowed values; the ends are included unless `open`
  double fit_low, fit_high;                           ///< bounds of a fit, wider than the range of real tables
  double spread;               ///< how much tables differ: a standard error above this says nothing
  bool open = false;           ///< the ends are excluded
  bool in_ball_radii = false;  ///< the numbers above are in radii of the ball

  static constexpr std::string_view prefix = "cushion.";
  /// Returns the key in a file.
  constexpr std::string_view key() const { return name.substr(prefix.size()); }
  /// Returns the unit of the numbers above for a ball of this radius [m].
  constexpr double scale(double radius) const { return in_ball_radii ? radius : 1; }
  constexpr bool allows(double value, double radius) const {
    const double least = low * scale(radius), most = high * scale(radius);
    return open ? value > least && value < most : value >= least && value <= most;
  }
};

namespace cushion_coefficient {

inline constexpr CushionCoefficient friction{
    .name = "cushion.friction",
    .unit = "",
    .fallback = "0.2",
    .example = "0.14",
    .meaning = "between ball and cushion",
    .low = 0,
    .high = std::numeric_limits<double>::infinity(),
    .fit_low = 1e-3,
    .fit_high = 1,
    .spread = 0.1,
};
inline constexpr CushionCoefficient height{
    .name = "cushion.height",
    .unit = "m",
    .fallback = "1.28 R of the preset's ball, else of the largest ball; carom-10ft 0.037, snooker-12ft 0.03675",
    .example = "0.0366",
    .meaning = "of the nose over the cloth, between R and 2 R",
    .low = 1,
    .high = 2,
    .fit_low = 1.02,
    .fit_high = 1.9,
    .spread = 0.1,
    .open = true,
    .in_ball_radii = true,
};
inline constexpr CushionCoefficient frequency_ratio{
    .name = "cushion.frequency_ratio",
    .unit = "",
    .fallback = "1.8",
    .example = "1.7",
    .meaning = "of `stronge` alone: how fast the rubber gives across over how fast it gives along, between 1 and 2",
    .low = 1,
    .high = 2,
    .fit_low = 1.001,
    .fit_high = 1.999,
    .spread = 0.3,
    .open = true,
};

}  // namespace cushion_coefficient

/// All coefficients, in the order of files.
inline constexpr const CushionCoefficient* cushion_coefficients[] = {
    &cushion_coefficient::friction, &cushion_coefficient::height, &cushion_coefficient::frequency_ratio};

// The rows.

struct CushionModel {
  std::string_view key;        ///< `model` in files
  std::string_view about;      ///< what it models
  std::string_view source{};   ///< docs/bibliography.md has more
  std::string_view caption{};  ///< what captions add to "spin"
  bool in_files = true;        ///< files can describe it
  bool tried_by_fit = false;   ///< a fit of the model "any" tries it
  bool integrated = false;     ///< its impacts are integrated to a tolerance
};

/// The place of a coefficient in a law whose coefficients have the type C.
template <class Law, class C>
struct CushionPlace {
  const CushionCoefficient* coefficient;
  C Law::*member;
};

/// The row of a law, with the coefficients that it has, in the order of files.
template <class Law>
struct CushionRow;

template <class C>
struct CushionRow<MirrorOf<C>> {
  static constexpr CushionModel model{
      .key = "mirror", .about = "reverses the speed towards the cushion, and keeps the rest and the spin"};
  static constexpr std::array<CushionPlace<MirrorOf<C>, C>, 0> coefficients{};
};

template <class C>
struct CushionRow<Han2005Of<C>> {
  using Law = Han2005Of<C>;
  static constexpr CushionModel model{.key = "han2005",
                                      .about = "friction at the nose, sticking or sliding",
                                      .source = "Han 2005",
                                      .tried_by_fit = true};
  static constexpr CushionPlace<Law, C> coefficients[] = {{&cushion_coefficient::friction, &Law::friction},
                                                          {&cushion_coefficient::height, &Law::height}};
};

template <class C>
struct CushionRow<Mathavan2010Of<C>> {
  using Law = Mathavan2010Of<C>;
  static constexpr CushionModel model{.key = "mathavan2010",
                                      .about = "friction at the nose and at the cloth, integrated",
                                      .source = "Mathavan, Jackson & Parkin 2010",
                                      .caption = " after Mathavan",
                                      .integrated = true};
  static constexpr CushionPlace<Law, C> coefficients[] = {{&cushion_coefficient::friction, &Law::friction},
                                                          {&cushion_coefficient::height, &Law::height}};
};

template <class C>
struct CushionRow<StrongeOf<C>> {
  using Law = StrongeOf<C>;
  static constexpr CushionModel model{.key = "stronge",
                                      .about = "friction at a nose whose rubber gives across as well as along",
                                      .source = "Stronge 2018",
                                      .tried_by_fit = true};
  static constexpr CushionPlace<Law, C> coefficients[] = {
      {&cushion_coefficient::friction, &Law::friction},
      {&cushion_coefficient::height, &Law::height},
      {&cushion_coefficient::frequency_ratio, &Law::frequency_ratio}};
};

template <>
struct CushionRow<CustomCushion> {
  static constexpr CushionModel model{.key = "custom", .about = "a law of one's own in C++", .in_files = false};
  static constexpr std::array<CushionPlace<CustomCushion, double>, 0> coefficients{};
};

/// All rows, in the order of the variant.
inline constexpr auto cushion_registry = []<class... Law>(std::type_identity<std::variant<Law...>>) {
  return std::array{CushionRow<Law>::model...};
}(std::type_identity<CushionVariant>{});

inline const CushionModel& model_of(const CushionVariant& cushion) { return cushion_registry[cushion.index()]; }

// Functions over the rows.

/// Returns the index in the variant of the model that files know by this key.
std::optional<std::size_t> find_cushion_model(std::string_view key);

/// Returns a law with its default coefficients by its index in the variant.
CushionVariant default_cushion(std::size_t index);

/// Returns the place of a coefficient; null if the law does not have it.
double* find_coefficient(CushionVariant& cushion, const CushionCoefficient& coefficient);

/// Sets the restitution, and those coefficients that both laws have, to those of `from`.
void take_coefficients(CushionVariant& cushion, const CushionVariant& from);

/// Returns the place of the friction between ball and cloth in a law that counts it during an impact; null in others.
double* cloth_friction(CushionVariant& cushion);
const double* cloth_friction(const CushionVariant& cushion);

/// Returns the place of the tolerance of an integrated law; null in others.
double* impact_tolerance(CushionVariant& cushion);
const double* impact_tolerance(const CushionVariant& cushion);

/// Calls `f(coefficient, value)` for each coefficient of a law, in the order of files.
template <class Law, class F>
void for_each_coefficient(Law& law, F&& f) {
  for (const auto& place : CushionRow<std::remove_const_t<Law>>::coefficients) f(*place.coefficient, law.*place.member);
}

/// Calls `f(value)` for each number of a law besides the restitution: its coefficients, and the cloth's friction.
template <class Law, class F>
void for_each_number(Law& law, F&& f) {
  for_each_coefficient(law, [&](const CushionCoefficient&, auto& number) { f(number); });
  if constexpr (requires { law.sliding_friction; }) f(law.sliding_friction);
}

/// Returns how many numbers `for_each_number` visits.
template <class Law>
constexpr std::size_t count_numbers() {
  return std::size(CushionRow<Law>::coefficients) + (requires(Law law) { law.sliding_friction; } ? 1 : 0);
}

/// Returns a law with numbers of another type, such as dual numbers.
template <class To, template <class> class Law, class From>
Law<To> with_numbers(const Law<From>& law) {
  Law<To> out;
  const auto& e = law.restitution;
  out.restitution = {To(e.at_rest), To(e.per_speed), To(e.per_speed2)};
  std::array<From, count_numbers<Law<From>>()> from{};
  std::size_t i = 0, k = 0;
  for_each_number(law, [&](const From& number) { from[i++] = number; });
  for_each_number(out, [&](To& number) { number = To(from[k++]); });
  if constexpr (requires { law.tolerance; }) out.tolerance = law.tolerance;
  return out;
}

}  // namespace bankshot
