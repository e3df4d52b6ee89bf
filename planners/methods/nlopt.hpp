// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "planners/findings.hpp"
#include "planners/ledger.hpp"
#include "planners/question.hpp"

namespace bankshot::planning::methods {

/// The global search over the whole box of bounds (NLopt DIRECT-L), on the real path; `step` names it in answers.
void search_box(const Question& q, Ledger& ledger, Findings& found, std::string_view step);

}  // namespace bankshot::planning::methods
