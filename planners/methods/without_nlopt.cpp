// SPDX-License-Identifier: MIT
//
// In place of nlopt.cpp where the library is built without NLopt (CMake's BANKSHOT_NLOPT is off): the last step of
// `auto` proposes nothing, and solve.cpp lists no planner named nlopt-*.
#include "planners/methods/methods.hpp"

namespace bankshot::planning {

void nlopt_bobyqa(Search&) {}
void nlopt_sbplx(Search&) {}
void nlopt_slsqp(Search&) {}
void nlopt_direct(Search&) {}
void nlopt_crs(Search&) {}
void nlopt_mlsl(Search&) {}

}  // namespace bankshot::planning
