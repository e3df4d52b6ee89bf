// SPDX-License-Identifier: MIT
//
// In place of nlopt.cpp where the library is built without NLopt (CMake's BANKSHOT_NLOPT is off): the last step of
// `auto` proposes nothing, and methods.cpp lists no planner named nlopt-*.
#include "planners/methods/methods.hpp"
#include "planners/methods/nlopt.hpp"

namespace bankshot::planning::methods {

void search_box(const Question&, Ledger&, Findings&, std::string_view) {}

void nlopt_bobyqa(const Question&, Ledger&, Findings&) {}
void nlopt_sbplx(const Question&, Ledger&, Findings&) {}
void nlopt_slsqp(const Question&, Ledger&, Findings&) {}
void nlopt_direct(const Question&, Ledger&, Findings&) {}
void nlopt_crs(const Question&, Ledger&, Findings&) {}
void nlopt_mlsl(const Question&, Ledger&, Findings&) {}

}  // namespace bankshot::planning::methods
