// SPDX-License-Identifier: MIT
#include "app/batch/rows.hpp"

#include <fmt/format.h>

#include "app/files.hpp"
#include "app/line_file.hpp"
#include "io/json/document.hpp"
#include "io/simulate/csv.hpp"

namespace bankshot::app::batch {
namespace {

/// Returns what a JSON object holds under a path, as a field; empty if it holds nothing there.
std::string field(const Json& object, const char* path) {
  const Json::json_pointer at(path);
  if (!object.contains(at) || object.at(at).is_null()) return "";
  const Json& value = object.at(at);
  if (value.is_string()) return csv_field(value.get<std::string>());
  if (!value.is_array()) return value.dump();
  std::string names;
  for (const Json& name : value) names += (names.empty() ? "" : " ") + name.get<std::string>();
  return csv_field(names);
}

}  // namespace

std::string rows_header() {
  return "line,id,status,shots,speed_m_per_s,angle_deg,top,side,cushions,ball,pocket,time_s,success,leave_success,"
         "value,miss_m,simulations,message\n";
}

std::string row_of(long line, const std::string& answer) {
  const Json a = Json::parse(answer);
  std::string out =
      fmt::format("{},{},{},{}", line, field(a, "/id"), field(a, "/status"), a.value("shots", Json::array()).size());
  for (const char* of_shot : {"speed", "angle", "spin/top", "spin/side", "cushions", "then/ball", "then/pocket",
                              "arrival/time", "success", "leave/success", "value", "miss"})
    out += "," + field(a, fmt::format("/shots/0/{}", of_shot).c_str());
  return out + fmt::format(",{},{}\n", field(a, "/simulations"), field(a, "/message"));
}

void write_rows(const std::string& answers, const std::string& csv) {
  LineFile lines(answers);
  std::string out = rows_header();
  for (std::string line; lines.next(line);) out += row_of(lines.number, line);
  write_file(csv, out);
}

}  // namespace bankshot::app::batch
