// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/demo.h"

#include <QCoreApplication>
#include <QDir>
#include <QTabWidget>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "report/report_json.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

namespace {

constexpr int kAttemptIntervalMs = 100;
constexpr int kAttemptsMax = 300;  // 30 s for the connection, the program and the machine's state
constexpr std::size_t kLivePictureShare = 2;  // when one part in so many has been executed

constexpr int kAfterRunMs = 1000;
constexpr int kTracesTab = 2;

}  // namespace

Demo::Demo(MainWindow& window, QString folder)
    : QObject(&window), m_window(window), m_folder(std::move(folder)) {
  connect(&m_window, &MainWindow::runFinished, this, &Demo::finish);
  connect(&m_timer, &QTimer::timeout, this, [this] {
    if (m_started) {
      takeLivePicture();
    } else {
      tryStart();
    }
  });
  m_timer.start(kAttemptIntervalMs);
}

void Demo::tryStart() {
  const QString blocked = m_window.startBlockedReason();
  if (blocked.isEmpty()) {
    m_started = m_window.start();
    return;
  }
  if (++m_attempts >= kAttemptsMax) {
    fail(blocked);
  }
}

void Demo::takeLivePicture() {
  const streaming::Counters& counters = m_window.lastUpdate().counters;
  if (counters.total > 0 && counters.executed * kLivePictureShare >= counters.total) {
    m_timer.stop();
    m_window.pages()->setCurrentIndex(0);
    savePicture(QStringLiteral("running.png"));
  }
}

void Demo::finish(const std::shared_ptr<const streaming::RunReport>& report) {
  m_timer.stop();
  // The picture is to show the machine as it stands after the run: it is looked at again soon.
  QTimer::singleShot(kAfterRunMs, this, [this, report] { leave(report); });
}

void Demo::leave(const std::shared_ptr<const streaming::RunReport>& report) {
  m_window.pages()->setCurrentIndex(kTracesTab);
  m_window.tracePage()->redrawNow();
  const bool pictured = savePicture(QStringLiteral("run.png"));
  const std::string json =
      report::runJson(*report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  const auto written =
      base::writeFile((m_folder + QStringLiteral("/report.json")).toStdString(), json);
  if (!pictured || !written) {
    fail(tr("The picture or the report cannot be written to %1.").arg(m_folder));
    return;
  }
  std::printf("%s: %zu of %zu points executed, %zu repeated, %zu skipped\n",
              std::string(streaming::outcomeName(report->outcome)).c_str(),
              report->counters.executed, report->counters.total, report->integrity.repeated,
              report->integrity.skipped);
  QCoreApplication::exit(report->isFaultless() ? 0 : 1);
}

void Demo::fail(const QString& sentence) {
  m_timer.stop();
  std::fprintf(stderr, "rivulet: %s\n", qPrintable(sentence));
  QCoreApplication::exit(3);
}

bool Demo::savePicture(const QString& name) {
  // What is laid out lays out what is in it in the next turn.
  constexpr int kTurns = 4;
  for (int turn = 0; turn < kTurns; ++turn) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
  }
  return QDir().mkpath(m_folder) && m_window.grab().save(m_folder + QLatin1Char('/') + name);
}

}  // namespace rivulet::hmi
