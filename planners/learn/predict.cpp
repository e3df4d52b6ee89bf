// SPDX-License-Identifier: MIT
#include "planners/learn/predict.hpp"

#include <cmath>

#include "planners/learn/launch.hpp"
#include "planners/learn/settings.hpp"

namespace bankshot::planning {

Prediction predict(const Recording& recording, const Common& common, double noise, Spent& work) {
  Recording unseen = recording;  // a prediction must not know what the ball met later
  unseen.cushions.reset();
  Seen seen(unseen, noise);
  seen.robust = settings::learn::robust;
  seen.spread[masse] = settings::learn::masse_of_first_part;
  mark_apart(seen);
  Prediction out{recording.scene.id, 0, 0};
  if (!(fit_first_part(seen, common, work) < forever)) return out;
  const double from = seen.window;
  seen.window = forever;
  tell(seen, common, work);
  mark_outliers(seen, common);
  const auto off = misses(seen, common);
  double sum = 0;
  for (std::size_t k = 0; k < off.size(); ++k)
    for (std::size_t i = 0; i < off[k].size(); ++i)
      if (unseen.tracks[k].samples[i].time > from && !seen.outlier[k][i])
        sum += dot(off[k][i], off[k][i]), ++out.samples;
  if (out.samples > 0) out.rms = std::sqrt(sum / out.samples);
  return out;
}

std::vector<Prediction> held_out(const Recordings& all, const Asked& asked, int group, Spent& work,
                                 const std::function<void(double)>& progress) {
  std::vector<Prediction> out;
  const auto size = static_cast<std::size_t>(group);
  for (std::size_t from = 0; from < all.size(); from += size) {
    Recordings others, left;
    for (std::size_t i = 0; i < all.size(); ++i) (i >= from && i < from + size ? left : others).push_back(all[i]);
    if (others.empty()) break;
    const Learnt l = learn(others, asked, work, [](double) {});
    for (const Recording* r : left) out.push_back(predict(*r, l.common, l.noise, work));
    progress(static_cast<double>(out.size()) / static_cast<double>(all.size()));
  }
  return out;
}

}  // namespace bankshot::planning
