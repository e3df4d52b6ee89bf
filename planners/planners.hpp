// SPDX-License-Identifier: MIT
//
// The planners: each proposes launches for a search and certifies them. They share nothing but it.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

void image(Search& s);         ///< image.cpp
void sweep(Search& s);         ///< sweep.cpp
void ceres(Search& s);         ///< ceres.cpp
void map(Search& s);           ///< map.cpp, what `sweep` does where paths depend on the speed
void nlopt_bobyqa(Search& s);  ///< nlopt.cpp
void nlopt_direct(Search& s);  ///< nlopt.cpp
void automatic(Search& s);     ///< auto.cpp

}  // namespace bankshot::planning
