// SPDX-License-Identifier: MIT
//
// The planners: each proposes launches for a search and certifies them. They share nothing but it.
#pragma once

#include "planners/search.hpp"

namespace bankshot::planning {

void image(Search& s);         ///< image.cpp
void sweep(Search& s);         ///< sweep.cpp
void ceres(Search& s);         ///< ceres.cpp
void nlopt_bobyqa(Search& s);  ///< nlopt.cpp
void nlopt_direct(Search& s);  ///< nlopt.cpp
void automatic(Search& s);     ///< auto.cpp

/// A launch near a root, moved onto it by Levenberg–Marquardt along a locked sequence; none where
/// that does not converge. In ceres.cpp.
std::optional<Launch> refine(Search& s, const Launch& seed, const std::vector<int>& contacts);

}  // namespace bankshot::planning
