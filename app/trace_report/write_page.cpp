// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_report/write_page.h"

#include <QGuiApplication>
#include <QLoggingCategory>
#include <memory>

#include "base/file.h"
#include "hmi/translator.h"

namespace rivulet::trace_report {

namespace {

/// Painting text needs an application. It outlives the page.
struct PageApplication {
  int count = 1;
  char name[12] = "rivulet-cli";
  char* arguments[2] = {name, nullptr};
  std::unique_ptr<QGuiApplication> application;
  hmi::Translator translator;

  PageApplication() {
    if (QCoreApplication::instance() == nullptr) {
      qputenv("QT_QPA_PLATFORM", "offscreen");
      // What Qt says about the desktop that is not there helps nobody.
      QLoggingCategory::setFilterRules(QStringLiteral("default.warning=false\nqt.*=false"));
      application = std::make_unique<QGuiApplication>(count, arguments);
    }
  }
};

}  // namespace

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
