// SPDX-License-Identifier: MIT
#include "planners/evaluate/all_errors.hpp"

#include "planners/evaluate/plays.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {

double success_under_all_errors(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot) {
  long made = 0;
  each_play(request.spinning(shot.spin), shot.launch, settings::all_errors::draws,
            [&](const SearchRequest& own, const Launch& struck) {
              made += replay(own, budget, struck, Goal::counted(own, shot)).made;
              return true;
            });
  return static_cast<double>(made) / settings::all_errors::draws;
}

}  // namespace bankshot::planning
