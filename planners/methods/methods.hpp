// SPDX-License-Identifier: MIT
//
// The planners that a user can name, one file each, and their list. docs/architecture.md says how each proposes
// candidates, and what it guarantees.
#pragma once

#include <span>
#include <string>

#include "bankshot/plan/planner.hpp"
#include "planners/propose/proposers.hpp"

namespace bankshot::planning::methods {

void automatic(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);  ///< auto.cpp
void image(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);
void sweep(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);
void ceres(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

struct Method {
  PlannerInfo info;
  propose::Proposer plan;
};

std::span<const Method> all();
/// Returns the planner of this name. Throws InvalidInput that names the known ones.
const Method& find(const std::string& name);

}  // namespace bankshot::planning::methods
