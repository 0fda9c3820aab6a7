// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/traces.h"

#include <QFileInfo>
#include <algorithm>
#include <optional>
#include <utility>

#include "gcode/program.h"
#include "report/trace_source.h"
#include "session/background.h"
#include "trace/analysis/trace_analysis.h"

namespace rivulet::hmi {

namespace {

/// The program of the window, read as finely as an analysis needs it.
struct ProgramToCompare {
  std::filesystem::path file;
  session::Reading reading;

  [[nodiscard]] std::optional<gcode::Program> load() const {
    gcode::LoadOptions options;
    options.setReading(reading);
    auto program = report::loadComparedProgram(file, std::move(options));
    return program ? std::move(*program) : std::nullopt;
  }
};

}  // namespace

/// What is to be shown.
struct Traces::Subject {
  std::filesystem::path file;  ///< to be read; empty: what follows is there
  std::string name;
  std::optional<trace::Trace> trace{};
  std::optional<base::Error> error{};

  void read() {
    if (file.empty()) {
      return;
    }
    auto opened = report::openTrace(file, {}, 0.0);
    if (opened) {
      trace = std::move(*opened);
    } else {
      error = opened.error();
    }
  }

  [[nodiscard]] std::shared_ptr<const trace::ShownTrace> named(trace::ShownTrace shown) const {
    shown.name = name;
    return std::make_shared<const trace::ShownTrace>(std::move(shown));
  }

  [[nodiscard]] std::shared_ptr<const trace::ShownTrace> signalsOnly() const {
    return named(trace::makeShownTrace(*trace));
  }

  [[nodiscard]] std::shared_ptr<const trace::ShownTrace> analysed(
      const gcode::Program* program) const {
    return named(trace::makeShownTrace(*trace, trace::analyseTrace(*trace, {program})));
  }
};

void Traces::open(const QStringList& paths) {
  std::vector<Subject> subjects;
  QStringList names;
  for (const QString& path : paths) {
    names.append(QFileInfo(path).fileName());
    subjects.push_back({path.toStdString(), names.back().toStdString()});
  }
  Q_EMIT reading(names);
  begin(Kind::Files, std::move(subjects));
}

base::Result<void> Traces::setMapping(const std::string& layout,
                                      const trace::TableMapping& mapping) {
  if (auto kept = report::rememberMapping(layout, trace::printTableMapping(mapping)); !kept) {
    return kept;
  }
  begin(m_kind, m_subjects);
  return {};
}

void Traces::show(const std::shared_ptr<const trace::ControlTrace>& trace) {
  if (trace && !trace->samples.empty()) {
    begin(Kind::Run, {{{}, {}, trace::Trace(trace)}});
  }
}

void Traces::show(const std::shared_ptr<const trace::Recording>& recording) {
  begin(Kind::Run, {{{}, recording->start.programName, trace::Trace(recording)}});
}

Traces::Traces(Document& document) : m_document(document) {
  connect(&document, &Document::programLoaded, this, &Traces::compareAgain);
}

Traces::~Traces() = default;

void Traces::cancel() {
  ++m_request;
  m_subjects.clear();
  m_shown = 0;
}

void Traces::emitShown(const List& list) {
  if (m_kind == Kind::Files) {
    Q_EMIT filesShown(list);
  } else {
    Q_EMIT runShown(list);
  }
}

void Traces::begin(Kind kind, std::vector<Subject> subjects) {
  const int request = ++m_request;
  m_kind = kind;
  m_shown = 0;
  m_subjects = std::move(subjects);
  auto read = std::make_shared<std::vector<Subject>>(m_subjects);
  session::inBackground(
      this,
      [read] {
        List list;
        for (Subject& subject : *read) {
          subject.read();
          if (!subject.error) {
            list.push_back(subject.signalsOnly());
          }
        }
        return list;
      },
      [request, read](Traces& self, const List& list) {
        if (self.m_request != request) {
          return;
        }
        for (const Subject& subject : *read) {
          if (subject.error) {
            Q_EMIT self.failed(*subject.error);
          }
        }
        if (!list.empty()) {
          self.m_shown = list.size();
          self.emitShown(list);
          self.analyse(request, read);
        }
      });
}

void Traces::analyse(int request, std::shared_ptr<std::vector<Subject>> read) {
  ProgramToCompare program;
  if (m_document.program() && !m_document.live()) {
    program = {m_document.path().toStdString(), m_document.reading()};
  }
  session::inBackground(
      this,
      [program, read = std::move(read), subjects = m_subjects]() mutable {
        if (!read) {
          read = std::make_shared<std::vector<Subject>>(std::move(subjects));
          for (Subject& subject : *read) {
            subject.read();
          }
        }
        const std::optional<gcode::Program> compared = program.load();
        List list;
        for (const Subject& subject : *read) {
          if (!subject.error) {
            list.push_back(subject.analysed(compared ? &*compared : nullptr));
          }
        }
        return list;
      },
      [request](Traces& self, const List& list) {
        // A file that is gone by now stays as it is shown.
        if (self.m_request == request && list.size() == self.m_shown) {
          self.emitShown(list);
        }
      });
}

void Traces::compareAgain() {
  // What is still being read will be compared with it anyway.
  if (m_shown > 0) {
    analyse(++m_request, nullptr);
  }
}

}  // namespace rivulet::hmi
