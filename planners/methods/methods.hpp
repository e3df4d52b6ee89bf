// SPDX-License-Identifier: MIT
//
// The planners: each proposes launches for a search and certifies them. They share nothing but it.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

void image(Search& s);  ///< image.cpp
void sweep(Search& s);  ///< sweep.cpp
void ceres(Search& s);  ///< ceres.cpp
/// The images of `ceres` alone; `quickly` by Newton's method, which fails a little more often.
void image_seeds(Search& s, bool quickly);
void nlopt_bobyqa(Search& s);  ///< nlopt.cpp, and the five below
void nlopt_sbplx(Search& s);
void nlopt_slsqp(Search& s);
void nlopt_direct(Search& s);
void nlopt_crs(Search& s);
void nlopt_mlsl(Search& s);
void automatic(Search& s);  ///< auto.cpp

void along_touched(Search& s);  ///< along.cpp

/// The cells of a forward map: rad of aim, and of ln speed. In map.cpp; what `sweep` does where paths
/// depend on the speed.
struct Spacing {
  double aim = radians(2), speed = 0.12;
  bool whole = false;  ///< also speeds at which neighbouring paths arrive too fast or never
  bool locked = true;  ///< follow a sequence that is given on its locked path, not where it really occurs
};
void map(Search& s, const Spacing& spacing);
/// The same of a sequence that is given, only at the speeds that arrive as asked, and outward from its image.
void fan_out(Search& s, const Spacing& spacing);

}  // namespace bankshot::planning
