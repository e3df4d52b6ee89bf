// SPDX-License-Identifier: MIT
#include "planners/merit/all_errors.hpp"

#include "planners/merit/plays.hpp"
#include "planners/merit/settings.hpp"
#include "planners/proof/replay.hpp"

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
