// SPDX-License-Identifier: MIT
//
// The sections of the report, one file per section.
#pragma once

#include <span>
#include <string>

#include "app/report/page.hpp"
#include "app/report/progress.hpp"
#include "bankshot/contact/cushion_registry.hpp"

namespace bankshot {
struct Recording;
}

namespace bankshot::app::report {

struct Settings {
  bool quick = false;
  int shots = 0;  ///< shots per point of a curve; other quantities that grow with the effort follow from it
};

inline constexpr CushionModel usual_cushion = CushionRow<UsualCushion>::model;
inline constexpr CushionModel fullest_cushion = CushionRow<FullestCushion>::model;
/// Returns the name of the physics `spin` with cushions of this model.
inline std::string spin_with(const CushionModel& cushion) { return "spin, " + std::string(cushion.key); }

Section simulators(const Settings& settings, Progress& progress);  ///< simulators.cpp, with troubles.cpp
Section models(const Settings& settings, Progress& progress);
Section planners(const Settings& settings, Progress& progress);  ///< planners.cpp, with suite.cpp and derivatives.cpp
Section conditioning(const Settings& settings, Progress& progress);
Section hard_cases(const Settings& settings, Progress& progress);
Section scaling(const Settings& settings, Progress& progress);
Section tilt(const Settings& settings, Progress& progress);
/// Exists only if the program learns from recordings. All recordings have the same physics model, which has spin.
Section recorded(std::span<const Recording> recordings, const Settings& settings, Progress& progress);

}  // namespace bankshot::app::report
