// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report/trace_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/file_lock.h"
#include "base/hash.h"
#include "platform/user_folders.h"
#include "trace/frames.h"
#include "trace/import/compression.h"

namespace rivulet::report {

namespace {

std::filesystem::path layoutsFile() {
  return folders::configHome() / "rivulet" / "trace_layouts.json";
}

/// Mappings by the headings of their tables. A file that is damaged counts as empty; it is kept
/// under another name before it is replaced.
nlohmann::ordered_json readLayouts() {
  const auto text = base::readFile(layoutsFile());
  nlohmann::ordered_json layouts = text ? nlohmann::ordered_json::parse(*text, nullptr, false)
                                        : nlohmann::ordered_json::object();
  return layouts.is_object() ? layouts : nlohmann::ordered_json::object();
}

bool isDamaged(const std::filesystem::path& file) {
  const auto text = base::readFile(file);
  return text && !nlohmann::ordered_json::parse(*text, nullptr, false).is_object();
}

/// What was said of a layout; empty: nothing.
std::string rememberedMapping(const std::string& layout) {
  const nlohmann::ordered_json layouts = readLayouts();
  const auto found = layouts.find(layout);
  return found != layouts.end() && found->is_string() ? found->get<std::string>() : std::string();
}

base::Result<trace::ImportedTrace> import(const std::string& bytes, const std::string& columns,
                                          double rateHz) {
  auto mapping = trace::parseTableMapping(columns);
  if (!mapping) {
    return base::fail(mapping.error());
  }
  if (rateHz > 0.0) {
    mapping->rateHz = rateHz;
  }
  auto imported = trace::importTrace(bytes, *mapping);
  if (!imported) {
    return imported;
  }
  if (!columns.empty()) {
    // Failing to remember is no reason not to analyse.
    if (const auto done = rememberMapping(imported->layout, columns); !done) {
      fmt::print(stderr, "The meaning of the columns is not remembered: {}\n", done.error().text());
    }
    return imported;
  }
  const std::string remembered = rememberedMapping(imported->layout);
  auto known = trace::parseTableMapping(remembered);
  if (remembered.empty() || !known) {
    return imported;
  }
  known->rateHz = rateHz > 0.0 ? rateHz : known->rateHz;
  auto mapped = trace::importTrace(bytes, *known);
  if (!mapped) {
    return imported;
  }
  mapped->table.isCertain = true;  // somebody has said so
  mapped->trace.remarks.push_back({trace::RemarkCode::Remembered, {remembered}});
  return mapped;
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

void TraceSource::cut(double fromS, double untilS) {
  const trace::Motion motion = trace::motionOf(subject());
  const base::Instant origin = motion.samples.empty() ? base::Instant{} : motion.samples.front().at;
  const base::Instant from{origin + base::fromSeconds(fromS)};
  const base::Instant until{origin + base::fromSeconds(untilS)};
  const auto keep = [&](auto& list, auto instantOf) {
    std::erase_if(list,
                  [&](const auto& one) { return instantOf(one) < from || instantOf(one) > until; });
  };
  const auto at = [](const auto& one) { return one.at; };
  const auto cutTrace = [&](trace::ControlTrace& control) {
    keep(control.samples, at);
    keep(control.blocks, [](const auto& block) { return block.from; });
    keep(control.events, [](const auto& event) { return event.from; });
    control.truncated = true;
  };
  if (controlTrace) {
    cutTrace(*controlTrace);
  }
  if (recording) {
    keep(recording->samples, at);
    keep(recording->notes, at);
    keep(recording->accesses, [](const auto& access) { return access.sent; });
    keep(recording->pauses, [](const auto& pause) { return pause.start; });
    if (recording->controlTrace) {
      cutTrace(*recording->controlTrace);
    }
  }
  if (imported) {
    trace::SignalTrace& file = imported->trace;
    for (std::size_t base = 0; base < file.timeBases.size(); ++base) {
      std::vector<base::Instant>& times = file.timeBases[base].at;
      const auto first = std::lower_bound(times.begin(), times.end(), from) - times.begin();
      const auto last = std::upper_bound(times.begin(), times.end(), until) - times.begin();
      const auto cutList = [&](auto& list) {
        list.erase(list.begin() + std::max(first, last), list.end());
        list.erase(list.begin(), list.begin() + first);
      };
      cutList(times);
      for (trace::Signal& signal : file.signalList) {
        if (signal.timeBase == base) {
          cutList(signal.values);
        }
      }
    }
  }
}

trace::TraceSubject TraceSource::subject() const {
  trace::TraceSubject subject;
  subject.recording = recording ? &*recording : nullptr;
  subject.controlTrace = controlTrace ? &*controlTrace : nullptr;
  subject.imported = imported ? &*imported : nullptr;
  return subject;
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

base::Result<TraceSource> openTrace(const std::filesystem::path& file, const std::string& columns,
                                    double rateHz) {
  const auto bytes = base::readFile(file);
  if (!bytes) {
    return base::fail(bytes.error());
  }
  const auto inFile = [&file](base::Error error) {
    error.context = file.string();
    return base::fail(std::move(error));
  };
  TraceSource source;
  // Recordings are compressed in frames, but for those of earlier versions.
  const auto ends = trace::isCompressed(*bytes) ? trace::readFrameEnds(*bytes, 0) : std::nullopt;
  const std::string_view head = ends ? std::string_view(ends->head) : std::string_view(*bytes);
  if (head.substr(0, 17) == "rivulet-recording") {
    auto recording = trace::parseRecording(*bytes);
    if (!recording) {
      return inFile(recording.error());
    }
    source.recording = std::move(*recording);
  } else if (bytes->substr(0, 21) == "rivulet-control-trace") {
    auto controlTrace = trace::parseControlTrace(*bytes);
    if (!controlTrace) {
      return inFile(controlTrace.error());
    }
    source.controlTrace = std::move(*controlTrace);
  } else {
    auto imported = import(*bytes, columns, rateHz);
    if (!imported) {
      return inFile(imported.error());
    }
    source.imported = std::move(*imported);
  }
  return source;
}

}  // namespace rivulet::report
