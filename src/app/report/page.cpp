// SPDX-License-Identifier: MIT
#include "app/report/page.hpp"

#include <fmt/format.h>

namespace bankshot::app::report {
namespace {

constexpr const char* title = "Speed against error";
constexpr const char* question =
    "How fast are the simulators and planners of bankshot, how wrong are they, and where do their numbers stop "
    "being good enough? Every error is measured against a reference that does not use the method it judges. Every "
    "time is processor time of one thread.";

constexpr const char* styles = R"(
:root { color-scheme: light; --ink: #1a1a1a; --soft: #5c5c5c; --line: #d8d8d8; --accent: #0b5d3b; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0 auto; max-width: 62rem; padding: 3.5rem 1.5rem 5rem; background: #fff; color: var(--ink);
  font: 17px/1.55 Charter, "Bitstream Charter", "Source Serif 4", Cambria, Georgia, serif; }
h1 { font-size: 2.3rem; line-height: 1.15; font-weight: 600; letter-spacing: -0.01em; margin: 0 0 0.8rem; }
h2 { font-size: 1.45rem; line-height: 1.25; font-weight: 600; margin: 0 0 0.6rem; }
h2 .number { color: var(--accent); margin-right: 0.6em; font-variant-numeric: lining-nums; }
p { margin: 0 0 0.9rem; max-width: 46rem; text-wrap: pretty; }
.lead { font-size: 1.1rem; color: #333; }
.machine, figcaption, .data, footer, nav { color: var(--soft); font-size: 0.86rem; line-height: 1.45; }
nav { border-top: 1px solid var(--line); border-bottom: 1px solid var(--line); padding: 0.7rem 0; margin: 1.6rem 0 0; }
nav ol { margin: 0; padding: 0; list-style: none; display: flex; flex-wrap: wrap; gap: 0.2rem 1.6rem; }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
section { margin-top: 3.6rem; }
.conclusion { border-left: 3px solid var(--accent); padding: 0.1rem 0 0.1rem 1rem; margin: 1.1rem 0 0; font-size: 1.06rem; }
.question { font-style: italic; font-size: 1.06rem; }
figure { margin: 1.4rem 0; }
figure svg { display: block; width: 100%; height: auto; }
figure svg text, table, .data { font-family: "Source Sans 3", "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
figcaption { margin-top: 0.5rem; max-width: 52rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.86rem; line-height: 1.35; font-variant-numeric: tabular-nums lining-nums;
  border-top: 1.5px solid var(--ink); border-bottom: 1.5px solid var(--ink); }
th { font-weight: 600; border-bottom: 1px solid var(--ink); vertical-align: bottom; }
th, td { padding: 0.26rem 0 0.26rem 1.5rem; text-align: right; }
td { white-space: nowrap; }
th:first-child, td:first-child { padding-left: 0.2rem; }
th:last-child, td:last-child { padding-right: 0.2rem; }
th.text, td.text { text-align: left; }
tbody tr:hover { background: #f6f6f2; }
tbody tr.group td { border-top: 1px solid var(--line); }
.data { margin-top: 0.8rem; }
footer { margin-top: 4rem; border-top: 1px solid var(--line); padding-top: 0.8rem; }
@media print { body { padding: 0; font-size: 11pt; } section { break-inside: avoid-page; } }
)";

void replace_all(std::string& text, const std::string& from, const std::string& with) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + with.size()))
    text.replace(at, from.size(), with);
}

std::string escaped(std::string text) {
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, ">", "&gt;");
  replace_all(text, "\"", "&quot;");
  return text;
}

/// Returns the <svg> element alone, with identifiers that differ from those of the other figures.
std::string inlined(std::string svg, const Section& s) {
  const std::size_t begin = svg.find("<svg");
  if (begin == std::string::npos) return "";
  svg.erase(0, begin);
  for (const char* name : {"gpPt", "gpDot", "gp_plot_", "hypertextBox", "hypertext", "greybox"}) {
    const std::string from = name;
    for (const char* quote : {"id='", "id=\"", "'#", "\"#"}) replace_all(svg, quote + from, quote + s.name + from);
  }
  replace_all(svg, "id=\"gnuplot_canvas\"",
              fmt::format("id=\"{}-canvas\" role=\"img\" aria-label=\"{}\"", s.name, escaped(s.title)));
  return svg;
}

std::string table_html(const Numbers& t) {
  const auto cell = [&](const char* tag, std::size_t i, const std::string& text) {
    return fmt::format("<{0}{1}>{2}</{0}>", tag, i < t.text_columns ? " class=\"text\"" : "", escaped(text));
  };
  std::string out = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (std::size_t i = 0; i < t.header.size(); ++i) out += cell("th", i, t.header[i]);
  out += "</tr></thead>\n<tbody>\n";
  std::string group;
  for (const auto& row : t.rows) {
    // A line above a row begins a group: it stands where the first column changes.
    const bool begins = t.text_columns > 1 && row[0] != group;
    out += begins ? "<tr class=\"group\">" : "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      out += cell("td", i, i == 0 && t.text_columns > 1 && !begins ? "" : row[i]);
    group = row[0];
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string section_html(const Section& s, std::size_t number, const std::string& figure) {
  std::string out = fmt::format(
      "<section id=\"{}\">\n<h2><span class=\"number\">{}</span>{}</h2>\n<p class=\"question\">{}</p>\n<p>{}</p>\n",
      s.name, number, escaped(s.title), escaped(s.question), escaped(s.about));
  if (!figure.empty())
    out += fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", inlined(figure, s), escaped(s.caption));
  out += table_html(s.table) + "<p class=\"data\">Raw data:";
  for (const Csv& c : s.data) out += fmt::format(" <a href=\"{0}.csv\">{0}.csv</a>", c.name);
  return out + fmt::format("</p>\n<p class=\"conclusion\"><strong>Conclusion.</strong> {}</p>\n</section>\n",
                           escaped(s.conclusion));
}

std::string in_cell(std::string text) {
  replace_all(text, "|", "\\|");
  return text;
}

std::string table_markdown(const Numbers& t) {
  std::string out = "|", rule = "|";
  for (std::size_t i = 0; i < t.header.size(); ++i) {
    out += " " + in_cell(t.header[i]) + " |";
    rule += i < t.text_columns ? "---|" : "---:|";
  }
  out += "\n" + rule + "\n";
  for (const auto& row : t.rows) {
    out += "|";
    for (const std::string& cell : row) out += " " + in_cell(cell) + " |";
    out += "\n";
  }
  return out;
}

}  // namespace

std::string to_html(const Page& page, const std::vector<std::string>& figures) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, "
      "initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>bankshot: "
      "{}</title>\n<style>{}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n<p "
      "class=\"lead\">{}</p>\n"
      "<p class=\"machine\">{}</p>\n<nav><ol>\n",
      escaped(title), styles, escaped(title), escaped(question), escaped(page.caption));
  for (std::size_t i = 0; i < page.sections.size(); ++i)
    out += fmt::format("<li><a href=\"#{}\">{}&ensp;{}</a></li>\n", page.sections[i].name, i + 1,
                       escaped(page.sections[i].title));
  out += "</ol></nav>\n</header>\n<main>\n";
  for (std::size_t i = 0; i < page.sections.size(); ++i) out += section_html(page.sections[i], i + 1, figures[i]);
  return out + fmt::format(
                   "</main>\n<footer>{}. Made by <code>bankshot report</code>, which measures all of it "
                   "again.</footer>\n</body>\n</html>\n",
                   escaped(page.caption));
}

std::string to_markdown(const Page& page, const std::vector<std::string>& figures) {
  std::string out = fmt::format("# {}\n\n{}\n\n*{}*\n", title, question, page.caption);
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    const Section& s = page.sections[i];
    out += fmt::format("\n## {}. {}\n\n{}\n\n{}\n", i + 1, s.title, s.question, s.about);
    if (!figures[i].empty()) out += fmt::format("\n![{}](figures/{}.svg)\n\n*{}*\n", s.title, s.name, s.caption);
    out += "\n" + table_markdown(s.table) + "\nRaw data:";
    for (const Csv& c : s.data) out += fmt::format(" [{0}.csv]({0}.csv)", c.name);
    out += fmt::format("\n\n**Conclusion.** {}\n", s.conclusion);
  }
  return out;
}

}  // namespace bankshot::app::report
