// SPDX-License-Identifier: MIT
//
// The steps of `auto` (docs/architecture.md lists them). methods/auto.cpp decides when each runs; the numbers in the
// names of files tell their usual order. A step reads the request, charges the budget, and adds to the search result.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning::steps {

/// The names of steps in answers.
namespace word {
inline constexpr std::string_view images = "images", sweep = "sweep", map = "map", along = "along", parts = "parts",
                                  jaw_shots = "rattles", chains = "chains", caroms = "caroms", global = "global",
                                  looser = "looser", leave = "leave";
}  // namespace word

using Step = void (*)(const SearchRequest&, EvaluationBudget&, SearchResult&);

void images(const SearchRequest& request, EvaluationBudget& budget,
            SearchResult& found);  ///< stretched images, refined on the locked path
/// All aims and speeds, in cells of this size.
void map(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing);
void along(const SearchRequest& request, EvaluationBudget& budget,
           SearchResult& found);  ///< exactly along a cushion that the ball touches
void jaw_shots(const SearchRequest& request, EvaluationBudget& budget,
               SearchResult& found);                                                       ///< by the jaws of a pocket
void chains(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);  ///< another ball is sent on
/// The same for one arrival speed after the other: of each chain the ways of its last ball, by itself, that need no
/// other look.
using KnownLegs = std::map<const Objects::Chain*, std::vector<Candidate>>;
void chains_again(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, KnownLegs& known);
void caroms(const SearchRequest& request, EvaluationBudget& budget,
            SearchResult& found);  ///< off one ball onto another

/// Cells fine enough that the map leaves nothing out where every shot is wanted.
Spacing usual_spacing(const SearchRequest& request);

/// Launches so near each other lead to one root (settings::parts::alike).
bool alike(const Launch& a, const Launch& b);

/// Parts of a target whose middle is blocked. Leads wait here with the room that was found beside each.
class Parts {
 public:
  /// Climbs to where a lead has most room: the new leads of the search result, until one of them is a shot.
  void climb(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);
  /// Bisects around the hopeful leads, those with most room first, until this share of what is left of the budget is
  /// used.
  void bisect(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, double share);

 private:
  bool was_tried(const Candidate& candidate) const;

  std::vector<Candidate> tried_;
};

/// Where chains and caroms found nothing: what costs ten times as much. Leads are climbed as they are found.
void chains_closely(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Parts& parts);
void caroms_closely(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Parts& parts);
/// And last of all: launch speeds between those at which they were followed.
void speeds_between(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning::steps
