// SPDX-License-Identifier: MIT
#include "io/json/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {
namespace {

constexpr std::size_t max_depth = 64;  // a puzzle needs 6; deeper text is garbage
constexpr std::size_t max_quote = 60;  // characters of a value that an error message repeats

std::string clip(std::string s) {
  if (s.size() > max_quote) {
    std::size_t cut = max_quote;
    while (cut > 0 && (static_cast<unsigned char>(s[cut]) & 0xC0) == 0x80) --cut;  // cuts between UTF-8 characters
    s = s.substr(0, cut) + "…";
  }
  for (char& c : s)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return s;
}

/// Returns the word around the last character read, for an error message; empty at the text's end.
std::string_view word_at(std::string_view text, std::size_t characters_read) {
  constexpr std::string_view separators = " \t\r\n,:[]{}";
  if (characters_read == 0 || characters_read > text.size()) return {};
  const std::size_t last = characters_read - 1;
  if (separators.find(text[last]) != std::string_view::npos) return text.substr(last, 1);
  const std::size_t begin = text.find_last_of(separators, last) + 1;  // npos + 1 is 0
  return text.substr(begin, text.find_first_of(separators, last) - begin);
}

/// Returns the line on which brackets first nest deeper than allowed.
int too_deep_line(std::string_view text) {
  std::size_t depth = 0;
  bool in_string = false;
  int line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (c == '"') in_string = !in_string;
    if (in_string) {
      if (c == '\\') ++i;
      continue;
    }
    if ((c == '[' || c == '{') && ++depth > max_depth) break;
    if (c == ']' || c == '}') --depth;
  }
  return line;
}

/// Builds the tree from nlohmann's events. The library's own builder silently keeps only the last of two
/// equal keys.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(std::string_view text) : text_(text) {}
  Json take() { return std::move(root_); }
  std::string take_id() { return std::move(id_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool v) override { return add(v); }
  bool number_integer(number_integer_t v) override { return is_id() ? add(v, std::to_string(v)) : add(v); }
  bool number_unsigned(number_unsigned_t v) override { return is_id() ? add(v, std::to_string(v)) : add(v); }
  bool number_float(number_float_t v, const string_t& written) override { return is_id() ? add(v, written) : add(v); }
  bool string(string_t& v) override {
    if (is_id()) id_ = write_json(Json(v));
    return add(std::move(v));
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& k) override {
    if (stack_.back()->contains(k))
      throw InvalidInput(path() + "/" + quote_key(k), "this key stands twice in one object");
    key_ = std::move(k);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& e) override {
    const std::size_t before = std::min(position > 0 ? position - 1 : 0, text_.size());
    const auto line = 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + static_cast<long>(before), '\n'));
    if (text_.find_first_not_of(" \t\r\n") == std::string_view::npos)
      throw InvalidInput("", "the document is empty", line);
    if (e.id == 406) throw InvalidInput("", "the number " + clip(token) + " is too large", line);
    // "... parse error at line 1, column 5: syntax error while parsing value - WHAT; last read: '...'"
    std::string what = e.what();
    what.resize(std::min(what.size(), what.find("; last read")));
    if (const auto dash = what.find(" - "); dash != std::string::npos) what.erase(0, dash + 3);
    const std::string_view word = word_at(text_, position);
    const std::string near = word.empty() ? "" : " at '" + clip(std::string(word)) + "'";
    throw InvalidInput("", fmt::format("not JSON{}: {}", near, what), line);
  }

 private:
  bool add(Json v) {
    place(std::move(v));
    return true;
  }

  bool is_id() const { return stack_.size() == 1 && root_.is_object() && key_ == "id"; }
  bool add(Json v, std::string written) {
    id_ = std::move(written);
    return add(std::move(v));
  }

  Json* place(Json v) {
    if (stack_.empty()) return &(root_ = std::move(v));
    if (stack_.back()->is_array()) return &stack_.back()->emplace_back(std::move(v));
    // `key` has already checked for duplicates.
    auto& members = stack_.back()->get_ref<Json::object_t&>();
    return &members.Json::object_t::Container::emplace_back(std::move(key_), std::move(v)).second;
  }

  bool open(Json container) {
    if (stack_.size() >= max_depth)
      throw InvalidInput("", fmt::format("nested deeper than {} levels", max_depth), too_deep_line(text_));
    const bool in_list = !stack_.empty() && stack_.back()->is_array();
    keys_.push_back(in_list ? std::to_string(stack_.back()->size()) : key_);
    stack_.push_back(place(std::move(container)));
    return true;
  }

  bool close() {
    stack_.pop_back();
    keys_.pop_back();
    return true;
  }

  std::string path() const {
    std::string p;
    for (std::size_t i = 1; i < keys_.size(); ++i) p += "/" + quote_key(keys_[i]);
    return p;
  }

  std::string_view text_;
  Json root_;
  std::vector<Json*> stack_;
  std::vector<std::string> keys_;
  std::string key_, id_;
};

/// Finds only the top-level "id", so that an answer to broken text still has its id.
class IdFinder : public nlohmann::json_sax<Json> {
 public:
  std::string take() { return found_ == 1 ? id_ : ""; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t v) override { return value(v); }
  bool number_unsigned(number_unsigned_t v) override { return value(v); }
  bool number_float(number_float_t, const string_t& written) override { return token(written); }
  bool string(string_t& v) override { return value(v); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return ++depth_ > 0; }
  bool start_array(std::size_t) override { return depth_++ > 0; }  // a list has no id
  bool end_object() override { return depth_-- > 0; }
  bool end_array() override { return depth_-- > 0; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override { return false; }
  bool key(string_t& k) override {
    if (depth_ == 1) at_id_ = k == "id";
    return true;
  }

 private:
  bool value(const Json& v) { return token(write_json(v)); }

  bool token(std::string text) {
    if (depth_ == 1 && at_id_) {
      id_ = std::move(text);
      ++found_;  // with two of them the id is ambiguous
    }
    return depth_ > 0;
  }

  std::string id_;
  int found_ = 0;
  long depth_ = 0;
  bool at_id_ = false;
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
    out += std::isfinite(v.get<double>()) ? fmt::format("{}", v.get<double>() + 0.0) : "null";  // -0 + 0 is 0
  else
    out += v.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Json parse_document(std::string_view text, std::string* id) {
  // For nlohmann's reader, a zero byte ends the text.
  if (const auto zero = text.find('\0'); zero != std::string_view::npos)
    throw InvalidInput("", "not JSON: there is a zero byte",
                       1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(zero), '\n')));
  Builder builder(text);
  Json::sax_parse(text, &builder);
  if (id) *id = builder.take_id();
  return builder.take();
}

std::string find_id(std::string_view text) {
  IdFinder finder;
  Json::sax_parse(text, &finder);
  return finder.take();
}

std::string write_json(const Json& value) {
  std::string out;
  write(value, out);
  return out;
}

std::string write_json(const std::string& id, const Json& object) {
  const std::string rest = write_json(object);
  if (id.empty()) return rest;
  return fmt::format("{{\"id\":{}{}{}", id, object.empty() ? "" : ",", rest.substr(1));
}

std::string quote(const Json& value) { return clip(write_json(value)); }

std::string quote_key(const std::string& key) {
  const std::string text = write_json(Json(key));
  return clip(text.substr(1, text.size() - 2));
}

}  // namespace bankshot
