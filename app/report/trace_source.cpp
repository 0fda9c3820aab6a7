// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/trace_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/byte_source.h"
#include "base/file.h"
#include "base/file_lock.h"
#include "base/hash.h"
#include "platform/thread_executor.h"
#include "platform/user_folders.h"
#include "report/json_members.h"

namespace rivulet::report {

namespace {

std::filesystem::path layoutsFile() {
  return folders::configHome() / "rivulet" / "trace_layouts.json";
}

/// Mappings by the headings of their tables. A file that is damaged counts as empty; it is kept
/// under another name before it is replaced.
nlohmann::ordered_json readLayouts() {
  nlohmann::ordered_json layouts =
      readJson<nlohmann::ordered_json>(layoutsFile()).value_or(nlohmann::ordered_json::object());
  return layouts.is_object() ? layouts : nlohmann::ordered_json::object();
}

bool isDamaged(const std::filesystem::path& file) {
  const auto layouts = readJson(file);
  return layouts ? !layouts->is_object() : layouts.error().code == base::BudgetError::Exceeded;
}

/// What was said of a layout; empty: nothing.
std::string rememberedMapping(const std::string& layout) {
  const nlohmann::ordered_json layouts = readLayouts();
  const auto found = layouts.find(layout);
  return found != layouts.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Reads the trace, as often as it is asked for.
using Parse = std::function<base::Result<trace::Trace>(const trace::TableMapping& mapping)>;

/// @param trace  of a file of another tool, read with `mapping`
base::Result<trace::Trace> parseAsRemembered(const Parse& parse, trace::Trace trace,
                                             const trace::TableMapping& mapping) {
  const std::string remembered = rememberedMapping(trace.imported()->layout);
  auto known = trace::parseTableMapping(remembered);
  if (remembered.empty() || !known) {
    return trace;
  }
  known->rateHz = mapping.rateHz ? mapping.rateHz : known->rateHz;
  trace = trace::Trace(trace::ImportedTrace());  // both would be there at once
  const auto mapped = parse(*known);
  if (!mapped) {
    return parse(mapping);
  }
  trace::ImportedTrace said = *mapped->imported();
  said.table.isCertain = true;  // somebody has said so
  said.trace.remarks.push_back({trace::RemarkCode::Remembered, {remembered}});
  return trace::Trace(std::move(said));
}

/// @return nothing: it is no large table
base::Result<std::optional<trace::Trace>> readLarge(const std::filesystem::path& file,
                                                    const trace::TableMapping& mapping,
                                                    const base::Budget& budget,
                                                    base::Executor& executor) {
  auto source = base::FileBytes::open(file);
  return source ? trace::readLargeTrace(*source, mapping, budget, &executor)
                : base::fail(source.error());
}

base::Result<trace::Trace> openParsed(const Parse& parse, const std::string& name,
                                      const std::string& columns, double rateHz) {
  const auto inFile = [&name](base::Error error) {
    error.context = name;
    return base::fail(std::move(error));
  };
  auto mapping = trace::parseTableMapping(columns);
  if (!mapping) {
    return inFile(mapping.error());
  }
  mapping->rateHz = rateHz > 0.0 ? rateHz : mapping->rateHz;
  auto trace = parse(*mapping);
  if (!trace) {
    return inFile(trace.error());
  }
  if (trace->imported() == nullptr) {
    return trace;
  }
  if (columns.empty()) {
    return parseAsRemembered(parse, std::move(*trace), *mapping);
  }
  // Failing to remember is no reason not to analyse.
  if (const auto done = rememberMapping(trace->imported()->layout, columns); !done) {
    fmt::print(stderr, "The meaning of the columns is not remembered: {}\n", done.error().text());
  }
  return trace;
}

}  // namespace

base::Result<void> rememberMapping(const std::string& layout, const std::string& mapping) {
  if (rememberedMapping(layout) == mapping) {
    return {};
  }
  std::error_code ignored;
  std::filesystem::create_directories(layoutsFile().parent_path(), ignored);
  const auto changing = base::FileLock::take(std::filesystem::path(layoutsFile()) += ".lock");
  if (!changing) {
    return base::fail(changing.error());
  }
  nlohmann::ordered_json layouts = readLayouts();
  layouts[layout] = mapping;
  if (isDamaged(layoutsFile()) && folders::moveAside(layoutsFile()).empty()) {
    return base::fail(base::FileError::NotWritable,
                      "A damaged file is in the way and cannot be renamed. Move it away.",
                      layoutsFile().string());
  }
  return base::writeFile(
      layoutsFile(),
      layouts.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

base::Result<std::optional<gcode::Program>> loadComparedProgram(const std::filesystem::path& file,
                                                                gcode::LoadOptions loading) {
  if (file.empty()) {
    return std::nullopt;
  }
  loading.chordToleranceMm = std::min(loading.chordToleranceMm, kComparedChordMm);
  auto program = gcode::loadProgram(file, loading);
  if (!program) {
    return base::fail(program.error());
  }
  return std::move(*program);
}

base::Result<trace::Trace> openTrace(const std::filesystem::path& file, const std::string& columns,
                                     double rateHz, const base::Budget& budget) {
  parallel::ThreadExecutor executor;
  std::optional<std::string> bytes;
  const Parse parse = [&](const trace::TableMapping& mapping) -> base::Result<trace::Trace> {
    // What is no ordinary file can be read once only, and as a whole.
    std::error_code ignored;
    if (!bytes && std::filesystem::is_regular_file(file, ignored)) {
      auto large = readLarge(file, mapping, budget, executor);
      if (!large) {
        return base::fail(large.error());
      }
      if (*large) {
        return std::move(**large);
      }
    }
    if (!bytes) {
      auto read = base::readFile(file, budget);
      if (!read) {
        return base::fail(read.error());
      }
      bytes = std::move(*read);
    }
    return trace::parseTrace(*bytes, mapping, budget.without(bytes->capacity()), &executor);
  };
  return openParsed(parse, file.string(), columns, rateHz);
}

base::Result<trace::Trace> openTraceBytes(const std::string& bytes, const std::string& name,
                                          const std::string& columns, double rateHz,
                                          const base::Budget& budget) {
  parallel::ThreadExecutor executor;
  const base::Budget rest = budget.without(bytes.capacity());
  const Parse parse = [&](const trace::TableMapping& mapping) {
    return trace::parseTrace(bytes, mapping, rest, &executor);
  };
  return openParsed(parse, name, columns, rateHz);
}

}  // namespace rivulet::report
