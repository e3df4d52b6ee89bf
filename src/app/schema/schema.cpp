// SPDX-License-Identifier: MIT
//
// bankshot schema: the format of files, from the same table of keys that the readers use.
#include "io/format/schema.hpp"

#include "app/commands.hpp"
#include "app/files.hpp"
#include "io/json/reader.hpp"

namespace bankshot::app::schema {
namespace {

struct Arguments {
  std::string document = "puzzle";
  bool markdown = false;
};

int run(const Arguments& a) {
  const auto known = format::documents();
  if (std::find(known.begin(), known.end(), a.document) == known.end())
    throw FileError(quote(a.document) + " is no document" + known_words(a.document, known));
  print(a.markdown ? format::markdown(a.document) : format::schema(a.document));
  return done;
}

}  // namespace

Run add(CLI::App& app) {
  auto a = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("schema", "Print the format of a file as a JSON Schema (draft 2020-12)");
  command->add_option("document", a->document, "The kind of file")
      ->type_name("TEXT:{puzzle,shot,answer,recording,play}")
      ->capture_default_str();
  command->add_flag("--markdown", a->markdown, "Print the tables of docs/format.md instead");
  explain(
      *command,
      "What a schema refuses, the program refuses too. The program also knows geometry: whether a ball lies on the\n"
      "table, whether an outline crosses itself.",
      {{"bankshot schema", "of a puzzle"}, {"bankshot schema answer > answer.schema.json", "of an answer"}},
      "0 done; 2 bad usage.");
  return [a] { return run(*a); };
}

}  // namespace bankshot::app::schema
