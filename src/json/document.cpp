// SPDX-License-Identifier: MIT
#include "json/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {
namespace {

constexpr std::size_t max_depth = 64;  // a puzzle needs 6; deeper text is garbage
constexpr std::size_t max_quote = 60;  // characters of a value worth repeating in an error

std::string clip(std::string s) {
  if (s.size() > max_quote) s = s.substr(0, max_quote) + "…";
  for (char& c : s)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return s;
}

/// Builds the tree from nlohmann's events; the library's own builder keeps only the last of two
/// equal keys and says nothing.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(std::string_view text) : text_(text) {}
  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool v) override { return add(v); }
  bool number_integer(number_integer_t v) override { return add(v); }
  bool number_unsigned(number_unsigned_t v) override { return add(v); }
  bool number_float(number_float_t v, const string_t&) override { return add(v); }
  bool string(string_t& v) override { return add(std::move(v)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& k) override {
    if (stack_.back()->contains(k))
      throw InvalidInput(path() + "/" + k, "this key stands twice in one object");
    key_ = std::move(k);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::json::exception& e) override {
    const auto end = text_.begin() + static_cast<long>(std::min(position, text_.size()));
    const auto line = 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
    if (text_.find_first_not_of(" \t\r\n") == std::string_view::npos)
      throw InvalidInput("", "the document is empty", line);
    std::string what = e.what();
    if (e.id == 406) throw InvalidInput("", "the number " + clip(token) + " is too large", line);
    const auto last = what.find("; last read");
    const auto colon = what.find(": ", what.find("column"));
    what = colon == std::string::npos ? what : what.substr(colon + 2, last - colon - 2);
    throw InvalidInput("", fmt::format("not JSON near '{}': {}", clip(token), clip(what)), line);
  }

 private:
  bool add(Json v) {
    place(std::move(v));
    return true;
  }

  Json* place(Json v) {
    if (stack_.empty()) return &(root_ = std::move(v));
    if (stack_.back()->is_array()) return &stack_.back()->emplace_back(std::move(v));
    return &((*stack_.back())[key_] = std::move(v));
  }

  bool open(Json container) {
    if (stack_.size() >= max_depth)
      throw InvalidInput("", fmt::format("nested deeper than {} levels", max_depth), 1);
    stack_.push_back(place(std::move(container)));
    keys_.push_back(key_);
    return true;
  }

  bool close() {
    stack_.pop_back();
    keys_.pop_back();
    return true;
  }

  std::string path() const {
    std::string p;
    for (std::size_t i = 1; i < keys_.size(); ++i) p += "/" + keys_[i];
    return p;
  }

  std::string_view text_;
  Json root_;
  std::vector<Json*> stack_;
  std::vector<std::string> keys_;
  std::string key_;
};

void write(const Json& v, std::string& out) {
  const auto sequence = [&](char open, char close, auto&& each) {
    out += open;
    bool first = true;
    for (auto it = v.begin(); it != v.end(); ++it) {
      if (!std::exchange(first, false)) out += ',';
      each(it);
    }
    out += close;
  };
  if (v.is_object())
    sequence('{', '}', [&](auto it) {
      out += Json(it.key()).dump() + ":";
      write(*it, out);
    });
  else if (v.is_array())
    sequence('[', ']', [&](auto it) { write(*it, out); });
  else if (v.is_number_float())
    out += std::isfinite(v.get<double>()) ? fmt::format("{}", v.get<double>()) : "null";
  else
    out += v.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json parse_document(std::string_view text) {
  Builder builder(text);
  Json::sax_parse(text, &builder);
  return builder.take();
}

std::string write_json(const Json& value) {
  std::string out;
  write(value, out);
  return out;
}

std::string quote(const Json& value) { return clip(write_json(value)); }

}  // namespace bankshot
