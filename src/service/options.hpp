// SPDX-License-Identifier: MIT
//
// Options of a request, declared once: the command line, the server and the bindings read them from one table.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::service {

/// An option that is unknown, or a value that it does not take. The text names the option.
class BadOption : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Options such as `?all&budget=500`: names as after `--`, and their values.
using Query = std::vector<std::pair<std::string, std::string>>;
/// Splits options such as "all&budget=500" at `between`.
Query query_of(std::string_view options, char between);

/// An option and the variable that it sets.
struct Option {
  /// A flag, a text, a whole number of at least 0, a number, or numbers between commas.
  using Target = std::variant<bool*, std::string*, long*, double*, std::vector<double>*, std::vector<int>*>;
  std::string_view name;  ///< without dashes
  Target target;
  std::string_view help{};
  Range range{};  ///< allowed numbers; for numbers alone
  bool required = false;
  std::string_view excludes{};  ///< the name of an option that cannot be given as well
};

/// Sets the variables of the options that a query gives. A list of numbers has as many as its variable holds. Throws
/// BadOption.
void read(const Query& query, std::span<const Option> options);

/// Says what is wrong with a whole number of at least 0; empty if nothing is.
std::string whole_number(const std::string& text);

}  // namespace bankshot::service
