// SPDX-License-Identifier: MIT
//
// Checks every claim of an answer in 50-digit arithmetic.
#pragma once

#include "bankshot/plan/planner.hpp"
#include "support/catch.hpp"
#include "truth/claims.hpp"

namespace bankshot::test {

inline void check_claims(const Puzzle& p, const Answer& a) {
  for (const truth::Check& c : truth::check(&p, a.id, a)) {
    INFO(truth::name(c.claim) << ": " << c.what);
    CHECK(c.holds());
  }
}

}  // namespace bankshot::test
