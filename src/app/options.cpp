// SPDX-License-Identifier: MIT
#include "app/options.hpp"

#include <string>

namespace bankshot::app {
namespace {

/// Adds one option. CLI11 knows how to read the variable by its type.
class Adder {
 public:
  Adder(CLI::App& command, const service::Option& option)
      : command_(command), option_(option), name_("--" + std::string(option.name)), help_(option.help) {}

  CLI::Option* operator()(bool* target) const { return command_.add_flag(name_, *target, help_); }
  CLI::Option* operator()(long* target) const {
    return command_.add_option(name_, *target, help_)->check(service::whole_number);
  }
  CLI::Option* operator()(std::string* target) const {
    CLI::Option* const added = command_.add_option(name_, *target, help_);
    return target->empty() ? added : added->capture_default_str();
  }
  CLI::Option* operator()(double* target) const { return command_.add_option(name_, *target, help_)->check(range()); }
  template <class T>
  CLI::Option* operator()(std::vector<T>* target) const {
    return command_.add_option(name_, *target, help_)
        ->delimiter(',')
        ->expected(static_cast<int>(target->size()))
        ->check(range());
  }

 private:
  CLI::Range range() const { return {option_.range.low, option_.range.high}; }

  CLI::App& command_;
  const service::Option& option_;
  std::string name_, help_;
};

}  // namespace

void add_options(CLI::App& command, std::span<const service::Option> options) {
  for (const service::Option& option : options)
    std::visit(Adder(command, option), option.target)->required(option.required);
  for (const service::Option& option : options)
    if (!option.excludes.empty())
      command.get_option("--" + std::string(option.name))
          ->excludes(command.get_option("--" + std::string(option.excludes)));
}

}  // namespace bankshot::app
