// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/pipeline_run.h"

#include <fmt/format.h>

#include <QFile>
#include <QFileInfo>
#include <cmath>
#include <string>
#include <utility>

#include "base/file.h"
#include "hmi/helper_program.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

namespace {

using TaskRunState = widgets::PipelineView::State;

constexpr int kCncQuitMs = 3000;

/// A spiral of short lines.
std::string exampleProgram() {
  constexpr int kLines = 240;
  constexpr double kStepRad = 0.12;
  constexpr double kStepMm = 0.1;
  std::string text = "G90 G17 G71 G64\nS3000 M3\nG0 X0 Y0 Z0\nF1500\n";
  for (int i = 1; i <= kLines; ++i) {
    const double angle = kStepRad * i;
    const double radiusMm = kStepMm * i;
    text +=
        fmt::format("G1 X{:.3f} Y{:.3f}\n", radiusMm * std::cos(angle), radiusMm * std::sin(angle));
  }
  return text + "M5\nM30\n";
}

QString policyName(pipeline::PolicyKind kind) {
  const std::string_view name = pipeline::factsOf(kind).name;
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

}  // namespace

QString PipelineRun::cncMissing() {
  return tr("The program rivulet-cnc is missing. Install it beside this window.");
}

PipelineRun::PipelineRun(QObject* parent) : QObject(parent) {
  connect(&m_process, &QProcess::readyReadStandardOutput, this, &PipelineRun::readEvents);
  connect(&m_process, &QProcess::readyReadStandardError, this,
          [this] { m_errors += m_process.readAllStandardError(); });
  connect(&m_process, &QProcess::finished, this, &PipelineRun::finish);
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) {
      fail(cncMissing());
    }
  });
}

PipelineRun::~PipelineRun() {
  m_process.disconnect(this);
  endProgram(m_process, kCncQuitMs);
}

void PipelineRun::begin(const QString& name) {
  m_view = {};
  m_view.name = name;
  m_rest.clear();
  m_errors.clear();
  m_isStopped = false;
  m_reader = {};
  m_records.reset();
}

void PipelineRun::start(const widgets::PipelineChoice& choice, const QString& program) {
  if (isRunning()) {
    return;
  }
  QString file = program;
  if (file.isEmpty()) {
    file = m_folder.filePath(QStringLiteral("spiral.mpf"));
    if (auto written = base::writeFile(file.toStdString(), exampleProgram()); !written) {
      fail(widgets::errorText(written.error()));
      return;
    }
  }
  begin(QFileInfo(file).fileName());
  const QString cnc = programOfRivulet(QStringLiteral("rivulet-cnc"), QStringLiteral("cnc"));
  if (cnc.isEmpty()) {
    fail(cncMissing());
    return;
  }
  QFile::remove(eventFile());
  QStringList arguments{QStringLiteral("run"),
                        file,
                        QStringLiteral("--live"),
                        QStringLiteral("--events"),
                        eventFile(),
                        QStringLiteral("--policy"),
                        policyName(choice.policy),
                        QStringLiteral("--processors"),
                        QString::number(choice.processors),
                        QStringLiteral("--cycle"),
                        QString::number(choice.cycleMs)};
  if (choice.isRealTime) {
    arguments.append(QStringLiteral("--real-time"));
  }
  m_view.state = TaskRunState::Running;
  m_process.start(cnc, arguments);
  Q_EMIT changed();
}

void PipelineRun::stop() {
  if (isRunning()) {
    m_isStopped = true;
    m_process.terminate();
  }
}

void PipelineRun::readEvents() {
  m_rest += m_process.readAllStandardOutput();
  qsizetype from = 0;
  for (qsizetype end = m_rest.indexOf('\n'); end >= 0; end = m_rest.indexOf('\n', from)) {
    const std::string_view line(m_rest.constData() + from, static_cast<std::size_t>(end - from));
    if (const auto added = m_reader.addLine(line); !added) {
      m_errors = QByteArray::fromStdString(added.error().message);
      m_process.kill();
      return;
    }
    from = end + 1;
  }
  m_rest.remove(0, from);
  takeEvents();
  Q_EMIT changed();
}

void PipelineRun::takeEvents() {
  if (!m_reader.recording()) {
    return;
  }
  cnc::EventRecording& recording = *m_reader.recording();
  if (!m_records) {
    m_records.emplace(recording.dispatch);
    m_view.dispatch = recording.dispatch;
    m_view.policy = recording.policy;
  }
  for (const pipeline::Event& event : recording.events) {
    m_records->add(event);
    m_view.history.add(event.at, event.levels);
    m_view.levels = event.levels;
    m_view.length = event.at.time_since_epoch();
  }
  recording.events.clear();
  m_view.records = m_records->records();
}

void PipelineRun::finish(int exitCode, QProcess::ExitStatus status) {
  readEvents();
  m_view.canBeSaved = QFile::exists(eventFile());
  if (m_isStopped) {
    m_view.state = TaskRunState::Stopped;
  } else if (exitCode == 0 && status == QProcess::NormalExit) {
    m_view.state = TaskRunState::Ended;
  } else {
    // The last line says what has ended it.
    const QString said = QString::fromUtf8(m_errors).trimmed().section(QLatin1Char('\n'), -1);
    fail(said.isEmpty() ? tr("The tasks have ended without a message. Execute the program again.")
                        : said);
    return;
  }
  Q_EMIT changed();
}

void PipelineRun::fail(const QString& sentence) {
  m_view.state = TaskRunState::Failed;
  m_view.message = sentence;
  Q_EMIT changed();
}

void PipelineRun::open(const QString& path) {
  if (isRunning()) {
    return;
  }
  begin(QFileInfo(path).fileName());
  const auto text = base::readFile(path.toStdString());
  if (!text) {
    fail(widgets::errorText(text.error()));
    return;
  }
  auto recording = cnc::parseEvents(*text);
  if (!recording) {
    fail(widgets::errorText(recording.error()));
    return;
  }
  m_reader.recording() = std::move(*recording);
  m_view.state = TaskRunState::Recorded;
  takeEvents();
  Q_EMIT changed();
}

void PipelineRun::save(const QString& path) {
  const auto text = base::readFile(eventFile().toStdString());
  const auto written = text ? base::writeFile(path.toStdString(), *text)
                            : base::Result<void>(base::fail(text.error()));
  if (!written) {
    fail(widgets::errorText(written.error()));
  }
}

}  // namespace rivulet::hmi
