// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_report/write_page.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QLoggingCategory>
#include <memory>

#include "base/file.h"
#include "language/translator.h"

namespace rivulet::trace_report {

namespace {

/// Painting text needs an application. It outlives the page.
struct PageApplication {
  int count = 1;
  char name[12] = "rivulet-cli";
  char* arguments[2] = {name, nullptr};
  std::unique_ptr<QGuiApplication> application;
  language::Translator translator;

  PageApplication() {
    if (QCoreApplication::instance() == nullptr) {
      qputenv("QT_QPA_PLATFORM", "offscreen");
      // Qt's warnings about a missing desktop do not matter here.
      QLoggingCategory::setFilterRules(QStringLiteral("default.warning=false\nqt.*=false"));
      application = std::make_unique<QGuiApplication>(count, arguments);
    }
  }
};

struct TrendWords {
  Q_DECLARE_TR_FUNCTIONS(TrendWords)

 public:
  static void translate(report::TrendTexts& texts) {
    texts.decimalSign = QLocale().decimalPoint().at(0).toLatin1();
    texts.title = tr("Trend of the runs").toStdString();
    texts.machine = tr("Machine").toStdString();
    texts.runs = tr("Runs").toStdString();
    texts.days = tr("Days").toStdString();
    texts.access = tr("Access, ms").toStdString();
    texts.paused = tr("Paused, s").toStdString();
    texts.perRun = tr("per run").toStdString();
    texts.perDay = tr("per day").toStdString();
    texts.accessPicture = tr("Access time per run").toStdString();
    texts.accessAxis = tr("Mean access time, ms").toStdString();
    texts.pausedPicture = tr("Pauses per run").toStdString();
    texts.pausedAxis = tr("Time in pauses, s").toStdString();
    texts.runAxis = tr("Run of the machine").toStdString();
    texts.dayAxis = tr("Days since %1", "a date").toStdString();
    texts.line = tr("%1, trend", "of a machine").toStdString();
  }
};

}  // namespace

report::TrendTexts trendTexts(const std::string& language) {
  PageApplication application;
  application.translator.setLanguage(QString::fromStdString(language));
  report::TrendTexts texts;
  TrendWords::translate(texts);
  texts.language = language;
  return texts;
}

base::Result<void> writeTracePage(const std::filesystem::path& file, const std::string& language,
                                  const TraceFacts& facts) {
  PageApplication application;
  application.translator.setLanguage(QString::fromStdString(language));
  const std::string ending = file.extension().string();
  if (ending == ".pdf") {
    if (paper::writePdf(QString::fromStdString(file.string()), tracePage(facts))) {
      return {};
    }
    return base::fail(base::FileError::NotWritable,
                      "The report cannot be written. Check the folder, the permissions and the "
                      "free space.",
                      file.string());
  }
  if (ending == ".html" || ending == ".htm") {
    return base::writeFile(file, paper::pageHtml(tracePage(facts)).toStdString());
  }
  return base::fail(base::FileError::NotWritable,
                    "A report is a .pdf or an .html file: choose one of these endings.",
                    file.string());
}

}  // namespace rivulet::trace_report
