// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/experiments/experiment_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/sha256.h"
#include "report/markup.h"
#include "report/svg_plot.h"

namespace rivulet::report {

using nlohmann::ordered_json;
using papers::Check;
using papers::Experiment;
using papers::Plot;
using papers::Series;
using papers::Table;

namespace {

/// Four significant digits; nothing if it is not a number.
std::string figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string();
}

std::string withUnit(double value, const std::string& unit) {
  const std::string text = figure(value);
  return text.empty() || unit.empty() ? text : text + " " + unit;
}

std::string deviation(const Check& check) {
  const double value = check.deviation();
  return std::isfinite(value) ? fmt::format("{:+.1f} %", 100.0 * value) : std::string();
}

std::string accepted(const Check& check) {
  if (std::isinf(check.lowest) && std::isinf(check.highest)) {
    return "any";
  }
  if (check.lowest == check.highest) {
    return figure(check.lowest);
  }
  if (std::isinf(check.lowest)) {
    return "at most " + figure(check.highest);
  }
  if (std::isinf(check.highest)) {
    return "at least " + figure(check.lowest);
  }
  return figure(check.lowest) + " to " + figure(check.highest);
}

const char* textOf(papers::Mark mark) {
  using papers::Mark;
  switch (mark) {
    case Mark::None:
      return "";
    case Mark::Input:
      return "input";
    case Mark::Fitted:
      return "fitted";
    case Mark::ByConstruction:
      return "by construction";
    case Mark::Predicted:
      return "predicted";
  }
  return "";
}

std::string verdict(const Check& check) {
  std::string text = check.passed() ? "ok" : "OUTSIDE";
  if (check.nullModelPasses()) {
    text += "; the null model passes";
  }
  return text;
}

/// Marks and null models have a column where there are any.
Table checkTable(const Experiment& experiment) {
  const bool hasMarks = std::ranges::any_of(
      experiment.checks, [](const Check& check) { return check.mark != papers::Mark::None; });
  const bool hasNullModels = std::ranges::any_of(
      experiment.checks, [](const Check& check) { return std::isfinite(check.nullModel); });
  Table table{"", {"figure", "reference", "ours", "deviation"}, {}};
  const auto add = [](std::vector<std::string>& cells, bool isShown, std::string text) {
    if (isShown) {
      cells.push_back(std::move(text));
    }
  };
  add(table.columns, hasNullModels, "null model");
  add(table.columns, true, "accepted");
  add(table.columns, hasMarks, "mark");
  add(table.columns, true, "source");
  add(table.columns, true, "verdict");
  for (const Check& check : experiment.checks) {
    std::vector<std::string> row{check.what, withUnit(check.reference, check.unit),
                                 withUnit(check.ours, check.unit), deviation(check)};
    add(row, hasNullModels, withUnit(check.nullModel, check.unit));
    add(row, true, accepted(check));
    add(row, hasMarks, textOf(check.mark));
    add(row, true, check.source);
    add(row, true, verdict(check));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Characters of UTF-8 text, for alignment.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  }));
}

std::string alignedTable(const Table& table) {
  std::vector<std::size_t> widths;
  for (const std::string& column : table.columns) {
    widths.push_back(widthOf(column));
  }
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], widthOf(row[i]));
    }
  }
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string out = " ";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      out += " " + cells[i] + std::string(widths[i] - widthOf(cells[i]) + 1, ' ');
    }
    out.erase(out.find_last_not_of(' ') + 1);
    text += out + "\n";
  };
  line(table.columns);
  for (const auto& row : table.rows) {
    line(row);
  }
  return text;
}

std::string markdownTable(const Table& table) {
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) {
      text += "| " + cell + " ";
    }
    text += "|\n";
  };
  line(table.columns);
  line(std::vector<std::string>(table.columns.size(), "---"));
  for (const auto& row : table.rows) {
    line(row);
  }
  return text;
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string csvLine(const std::vector<std::string>& cells) {
  std::string text;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text += (i > 0 ? "," : "") + csvField(cells[i]);
  }
  return text + "\n";
}

std::string htmlTable(const Table& table) {
  std::string text = "<div class=\"wide\"><table>\n";
  const auto line = [&](const std::vector<std::string>& cells, const char* tag) {
    text += "<tr>";
    for (const std::string& cell : cells) {
      text +=
          fmt::format("<{0}{1}>{2}</{0}>", tag,
                      cell.starts_with("OUTSIDE") ? " class=\"outside\"" : "", markupText(cell));
    }
    text += "</tr>\n";
  };
  line(table.columns, "th");
  for (const auto& row : table.rows) {
    line(row, "td");
  }
  return text + "</table></div>\n";
}

std::string htmlSection(const Experiment& experiment) {
  std::string text = fmt::format("<section id=\"{0}\"><h2>{0}: {1}</h2>\n<p>{2}</p>\n{3}",
                                 experiment.name, markupText(experiment.title),
                                 markupText(experiment.setup), htmlTable(checkTable(experiment)));
  for (const Table& table : experiment.tables) {
    text += fmt::format("<h3>{}</h3>\n{}", markupText(table.title), htmlTable(table));
  }
  for (const Plot& plot : experiment.plots) {
    const std::string svg = svgPlot(plot);
    text += "<figure>" + svg.substr(std::min(svg.find("<svg"), svg.size())) + "</figure>\n";
  }
  for (const std::string& note : experiment.notes) {
    text += fmt::format("<p>{}</p>\n", markupText(note));
  }
  return text + "</section>\n";
}

constexpr std::string_view kPageStyle =
    "body{font:16px/1.45 sans-serif;max-width:75em;margin:2em auto;padding:0 1em;color:#1b1f24;"
    "background:#fff}table{border-collapse:collapse;font-size:14px}th,td{border:1px solid #c5ccd3;"
    "padding:.25em .6em;text-align:left;vertical-align:top}th{background:#eef1f4}"
    ".wide{overflow-x:auto}.outside{background:#fbe3df;font-weight:bold}"
    "figure{margin:1em 0}svg{max-width:100%;height:auto}";

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

}  // namespace

std::string experimentText(const Experiment& experiment) {
  std::string text = fmt::format("{}: {}\n{}\n\n{}", experiment.name, experiment.title,
                                 experiment.setup, alignedTable(checkTable(experiment)));
  for (const Table& table : experiment.tables) {
    text += "\n" + table.title + "\n" + alignedTable(table);
  }
  for (const std::string& note : experiment.notes) {
    text += "\n" + note + "\n";
  }
  return text;
}

ordered_json experimentJson(const Experiment& experiment) {
  ordered_json json{{"name", experiment.name},         {"title", experiment.title},
                    {"setup", experiment.setup},       {"passed", experiment.passed()},
                    {"checks", ordered_json::array()}, {"tables", ordered_json::array()},
                    {"plots", ordered_json::array()},  {"notes", experiment.notes}};
  for (const Check& check : experiment.checks) {
    json["checks"].push_back({{"what", check.what},
                              {"unit", check.unit},
                              {"source", check.source},
                              {"reference", number(check.reference)},
                              {"ours", number(check.ours)},
                              {"deviation", number(check.deviation())},
                              {"lowest", number(check.lowest)},
                              {"highest", number(check.highest)},
                              {"mark", textOf(check.mark)},
                              {"null_model", number(check.nullModel)},
                              {"passed", check.passed()}});
  }
  for (const Table& table : experiment.tables) {
    json["tables"].push_back(
        {{"title", table.title}, {"columns", table.columns}, {"rows", table.rows}});
  }
  for (const Plot& plot : experiment.plots) {
    ordered_json series = ordered_json::array();
    for (const Series& line : plot.series) {
      ordered_json entry{{"name", line.name}, {"x", line.x}, {"y", line.y}};
      if (!line.yUpper.empty()) {
        entry["y_upper"] = line.yUpper;
      }
      series.push_back(std::move(entry));
    }
    json["plots"].push_back({{"title", plot.title},
                             {"x", plot.xLabel},
                             {"y", plot.yLabel},
                             {"series", std::move(series)}});
  }
  return json;
}

std::string experimentCsv(const Experiment& experiment) {
  std::string text = csvLine({"experiment", "check", "unit", "source", "reference", "ours",
                              "lowest", "highest", "mark", "null model", "passed"});
  const auto exact = [](double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string();
  };
  for (const Check& check : experiment.checks) {
    text += csvLine({experiment.name, check.what, check.unit, check.source, exact(check.reference),
                     exact(check.ours), exact(check.lowest), exact(check.highest),
                     textOf(check.mark), exact(check.nullModel), check.passed() ? "1" : "0"});
  }
  for (const Table& table : experiment.tables) {
    text += "\n" + csvLine(table.columns);
    for (const auto& row : table.rows) {
      text += csvLine(row);
    }
  }
  for (const Plot& plot : experiment.plots) {
    text += "\n" + csvLine({"series", plot.xLabel, plot.yLabel, "upper"});
    for (const Series& line : plot.series) {
      for (std::size_t i = 0; i < line.x.size(); ++i) {
        text += csvLine({line.name, exact(line.x[i]), exact(line.y[i]),
                         line.yUpper.empty() ? "" : exact(line.yUpper[i])});
      }
    }
  }
  return text;
}

std::string experimentMarkdown(const Experiment& experiment,
                               const std::vector<std::string>& images) {
  std::string text = fmt::format("## `{}`: {}\n\n{}\n\n{}", experiment.name, experiment.title,
                                 experiment.setup, markdownTable(checkTable(experiment)));
  for (const Table& table : experiment.tables) {
    text += "\n" + table.title + "\n\n" + markdownTable(table);
  }
  for (std::size_t i = 0; i < experiment.plots.size() && i < images.size(); ++i) {
    text += fmt::format("\n![{}]({})\n", experiment.plots[i].title, images[i]);
  }
  for (const std::string& note : experiment.notes) {
    text += "\n" + note + "\n";
  }
  return text;
}

std::string experimentPage(const std::vector<Experiment>& experiments, const ReportFacts& facts) {
  ordered_json figures = ordered_json::array();
  Table overview{"", {"experiment", "what", "checks passed"}, {}};
  std::string sections;
  for (const Experiment& experiment : experiments) {
    figures.push_back(experimentJson(experiment));
    overview.rows.push_back(
        {experiment.name, experiment.title,
         fmt::format("{} of {}", std::ranges::count_if(experiment.checks, &Check::passed),
                     experiment.checks.size())});
    sections += htmlSection(experiment);
  }
  Table made{"", {"made with", ""}, {}};
  for (const auto& [name, value] : facts) {
    made.rows.push_back({name, value});
  }
  made.rows.push_back(
      {"SHA-256 of all figures",
       base::sha256Hex(figures.dump(-1, ' ', false, ordered_json::error_handler_t::replace))});
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta "
      "charset=\"utf-8\"><title>Experiments</title>\n"
      "<style>{}</style></head><body>\n<h1>The papers' figures beside ours</h1>\n"
      "<p>The mark says how a figure of ours came about: <i>input</i> (the machine or the run was "
      "given it), <i>fitted</i> (free numbers of the machine were chosen by it), <i>by "
      "construction</i> (it follows from how program and machine are built), <i>predicted</i> "
      "(nothing was chosen by it). A null model is a machine or model without what is shown. "
      "OUTSIDE is a result, too.</p>\n{}{}{}</body></html>\n",
      kPageStyle, htmlTable(made), htmlTable(overview), sections);
}

}  // namespace rivulet::report
