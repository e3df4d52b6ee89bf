// SPDX-License-Identifier: MIT
//
// Tests the table of keys: it is the source of the schema and of docs/format.md, and it agrees with the readers.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bankshot/scene/table.hpp"
#include "io/format/objects.hpp"
#include "io/format/scene_keys.hpp"
#include "io/format/schema.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using namespace bankshot;
using test::run_program;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("docs/format.md holds the tables that the program prints") {
  const std::string text = test::read_repository_file("docs/format.md");
  for (const std::string_view document : format::documents()) {
    INFO(document << ": bash docs/tables.sh writes them anew");
    const std::string begin = fmt::format("<!-- bankshot schema {} --markdown -->\n", document);
    REQUIRE(text.find(begin) != std::string::npos);
    const std::size_t at = text.find(begin) + begin.size();
    CHECK(text.substr(at, text.find("<!-- end -->", at) - at) == format::markdown(document));
    CHECK(run_program(fmt::format("schema {} --markdown", document)).out == format::markdown(document));
    CHECK(Json::parse(run_program(fmt::format("schema {}", document)).out).at("type") == "object");
  }
  CHECK(run_program("schema").out == run_program("schema puzzle").out);
}

TEST_CASE("the format names every table that there is") {
  REQUIRE(table_presets().size() == std::size(format::table_names));
  for (std::size_t i = 0; i < table_presets().size(); ++i) CHECK(table_presets()[i].name == format::table_names[i]);
}

TEST_CASE("each object has its keys once, and each example is JSON") {
  int rows = 0;
  for (const std::string_view document : format::documents())
    for (const format::Object* object : format::objects_of(document))
      for (const format::Key& key : object->keys) {
        INFO(object->name << "." << key.name);
        const auto same = [&](const format::Key& other) { return other.name == key.name; };
        CHECK(std::count_if(object->keys.begin(), object->keys.end(), same) == 1);
        if (key.type == format::later) continue;
        CHECK(Json::accept(key.example));
        CHECK(!key.fallback.empty());
        ++rows;
      }
  CHECK(rows > 100);
}

TEST_CASE("an unknown document is refused") {
  CHECK_THAT(run_program("schema puzle").err, Catch::Contains("did you mean \"puzzle\"?"));
  CHECK(run_program("schema puzle").exit == 2);
}
