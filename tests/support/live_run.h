// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A run of rivulet-cli whose points come from a live source. @threadsafety one object, one thread.
#pragma once

#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <nlohmann/json.hpp>
#include <string>

#include "support/patience.h"

namespace rivulet::tests {

class LiveRun {
 public:
  LiveRun(const QString& folder, const std::string& arguments) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_STATE_HOME"), folder);
    environment.insert(QStringLiteral("XDG_DATA_HOME"), folder);
    m_process.setProcessEnvironment(environment);
    m_process.start(
        QStringLiteral(RIVULET_CLI),
        words("stream --box -300 300 -300 300 -200 100 --json --feed 1000 " + arguments));
    m_process.setReadChannel(QProcess::StandardError);
    QString said;
    while (m_process.state() != QProcess::NotRunning && !said.startsWith(QLatin1String("Points"))) {
      if (m_process.canReadLine()) {
        said = QString::fromUtf8(m_process.readLine());
      } else {
        m_process.waitForReadyRead(kRunMs);
      }
    }
    source = said.section(QStringLiteral("from "), 1).trimmed().chopped(1).toStdString();
  }
  void send(const std::string& text) {
    m_process.write(text.data(), static_cast<qint64>(text.size()));
    m_process.closeWriteChannel();
  }
  /// As by Ctrl-C.
  void stop() { m_process.terminate(); }
  /// Exit code; the report is in `report` then.
  int finish() {
    if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(kRunMs)) {
      m_process.kill();
      m_process.waitForFinished();
      return -1;
    }
    report = nlohmann::json::parse(m_process.readAllStandardOutput().toStdString(), nullptr, false);
    return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -2;
  }
  [[nodiscard]] std::size_t number(const char* name) const {
    return report.is_object() ? report.value(name, std::size_t{999'999}) : 999'999;
  }
  [[nodiscard]] std::string error() const {
    return report.is_object() && report.contains("error") ? report["error"].dump() : "";
  }
  /// Nothing repeated, skipped or foreign.
  [[nodiscard]] bool isRight() const {
    return report.is_object() && report.value("judged", false) && number("repeated") == 0 &&
           number("skipped") == 0 && number("foreign") == 0 && number("out_of_order") == 0;
  }

  std::string source;  ///< as the program names it
  nlohmann::json report;

 private:
  static QStringList words(const std::string& text) {
    return QString::fromStdString(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
  }

  QProcess m_process;
};

}  // namespace rivulet::tests
