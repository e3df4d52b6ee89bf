// SPDX-License-Identifier: MIT
//
// The planners: each proposes launches for a search and certifies them. They share nothing but it.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

void image(Search& s);         ///< image.cpp
void sweep(Search& s);         ///< sweep.cpp
void ceres(Search& s);         ///< ceres.cpp
void image_seeds(Search& s);   ///< ceres.cpp, its images alone
void nlopt_bobyqa(Search& s);  ///< nlopt.cpp, and the five below
void nlopt_sbplx(Search& s);
void nlopt_slsqp(Search& s);
void nlopt_direct(Search& s);
void nlopt_crs(Search& s);
void nlopt_mlsl(Search& s);
void automatic(Search& s);     ///< auto.cpp

/// The cells of a forward map: rad of aim, and of ln speed. In map.cpp; what `sweep` does where paths
/// depend on the speed.
struct Spacing {
  double aim = radians(2), speed = 0.12;
};
void map(Search& s, const Spacing& spacing);

}  // namespace bankshot::planning
