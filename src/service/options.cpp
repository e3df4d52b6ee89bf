// SPDX-License-Identifier: MIT
#include "service/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "io/json/reader.hpp"

namespace bankshot::service {
namespace {

[[noreturn]] void refuse(const Option& option, const std::string& reason) {
  throw BadOption(fmt::format("--{}: {}", option.name, reason));
}

/// Reads one text into the variable of an option.
class Reader {
 public:
  Reader(const Option& option, const std::string& text) : option_(option), text_(text) {}

  void operator()(bool* target) const {
    if (!text_.empty() && text_ != "true" && text_ != "false") refuse(option_, quote(text_) + " must be true or false");
    *target = text_ != "false";
  }
  void operator()(std::string* target) const {
    if (text_.empty()) refuse(option_, "needs a value");
    *target = text_;
  }
  void operator()(long* target) const {
    if (const std::string wrong = whole_number(text_); !wrong.empty()) refuse(option_, wrong);
    *target = std::stol(text_);
  }
  void operator()(double* target) const { *target = number(text_); }
  void operator()(std::vector<double>* target) const { list(*target); }
  void operator()(std::vector<int>* target) const { list(*target); }

 private:
  double number(const std::string& text) const {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') refuse(option_, quote(text) + " is no number");
    if (!option_.range.contains(value))
      refuse(option_, fmt::format("{} must be from {:g} to {:g}", text, option_.range.low, option_.range.high));
    return value;
  }
  template <class T>
  void list(std::vector<T>& target) const {
    std::vector<T> values;
    for (const std::string& text : parts()) {
      const T value = static_cast<T>(number(text));
      if (static_cast<double>(value) != number(text)) refuse(option_, quote(text) + " must be a whole number");
      values.push_back(value);
    }
    if (values.size() != target.size())
      refuse(option_, fmt::format("{} must be {} numbers with commas between", quote(text_), target.size()));
    target = std::move(values);
  }
  std::vector<std::string> parts() const {
    std::vector<std::string> out{""};
    for (const char c : text_)
      if (c == ',')
        out.emplace_back();
      else
        out.back() += c;
    return out;
  }

  const Option& option_;
  const std::string& text_;
};

}  // namespace

Query query_of(std::string_view options, char between) {
  Query query;
  while (!options.empty()) {
    const std::string_view one = options.substr(0, options.find(between));
    const std::size_t end = std::min(one.find('='), one.size());
    if (!one.empty()) query.emplace_back(one.substr(0, end), one.substr(std::min(end + 1, one.size())));
    options.remove_prefix(std::min(one.size() + 1, options.size()));
  }
  return query;
}

void read(const Query& query, std::span<const Option> options) {
  const auto given = [&](std::string_view name) {
    return std::ranges::any_of(query, [&](const auto& one) { return one.first == name; });
  };
  for (const auto& [name, value] : query) {
    const auto option = std::ranges::find(options, name, &Option::name);
    if (option == options.end()) {
      std::vector<std::string_view> names;
      for (const Option& known : options) names.push_back(known.name);
      throw BadOption(fmt::format("--{} is no option here{}", name, names.empty() ? "" : known_words(name, names)));
    }
    std::visit(Reader(*option, value), option->target);
  }
  for (const Option& option : options) {
    if (option.required && !given(option.name)) refuse(option, "is required");
    if (!option.excludes.empty() && given(option.name) && given(option.excludes))
      refuse(option, fmt::format("excludes --{}", option.excludes));
  }
}

std::string whole_number(const std::string& text) {
  constexpr std::size_t most_digits = 18;  // fits a long
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return digits && text.size() <= most_digits ? "" : "\"" + text + "\" must be a whole number, at least 0";
}

}  // namespace bankshot::service
