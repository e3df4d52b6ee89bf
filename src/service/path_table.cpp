// SPDX-License-Identifier: MIT
#include "service/path_table.hpp"

#include <fmt/format.h>

namespace bankshot::service {

std::string path_table(const ShotRequest& request, const Trajectory& t, double rate, double most_rows) {
  const double rows = t.events.back().time * rate * static_cast<double>(1 + request.others.size());
  if (rows > most_rows)
    throw TooLong(fmt::format("--rate {} for {:.6g} s would write {:.2g} rows, and {:.0g} is the most", rate,
                              t.events.back().time, rows, most_rows));
  return to_csv(request, t, rate);
}

}  // namespace bankshot::service
