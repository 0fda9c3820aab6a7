// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/pages/pages.h"
#include "hmi/document.h"
#include "hmi/messages.h"

#include <QCoreApplication>
#include <QStackedWidget>
#include <QTabWidget>

#include "base/file.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

namespace {

struct Pages {
  Q_DECLARE_TR_FUNCTIONS(Pages)
};

}  // namespace

QString pageTitle(const PageEntry& entry) {
  return Pages::tr(entry.title);
}

std::optional<widgets::RehearsalView> rehearsalView(const Findings& findings) {
  if (!findings.rehearsed) {
    return std::nullopt;
  }
  widgets::RehearsalView view;
  if (const auto& outcome = findings.rehearsal) {
    view = {true,
            outcome->runs,
            outcome->faulty,
            outcome->points,
            outcome->isWhole,
            outcome->safeFeedMmPerS};
  }
  return view;
}

void showPageOf(QWidget* widget) {
  for (QWidget* page = widget; page != nullptr; page = page->parentWidget()) {
    auto* stack = qobject_cast<QStackedWidget*>(page->parentWidget());
    if (stack == nullptr) {
      continue;
    }
    if (auto* tabs = qobject_cast<QTabWidget*>(stack->parentWidget())) {
      tabs->setCurrentWidget(page);
    } else {
      stack->setCurrentWidget(page);
    }
  }
}

void saveSheet(Messages* messages, const QString& path, const paper::Page& page) {
  if (path.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive)) {
    saveText(messages, path, paper::pageHtml(page));
  } else if (paper::writePdf(path, page)) {
    messages->log(gcode::Severity::Note, Messages::Source::Computer,
                  [path] { return Pages::tr("Saved %1.").arg(path); });
  } else {
    messages->show(gcode::Severity::Error, [path] {
      return widgets::errorText(
          base::makeError(base::FileError::NotWritable, {}, path.toStdString()));
    });
  }
}

void saveText(Messages* messages, const QString& path, const QString& text) {
  const auto written = base::writeFile(path.toStdString(), text.toStdString());
  if (!written) {
    messages->show(gcode::Severity::Error,
                   [error = written.error()] { return widgets::errorText(error); });
    return;
  }
  messages->log(gcode::Severity::Note, Messages::Source::Computer,
                [path] { return Pages::tr("Saved %1.").arg(path); });
}

}  // namespace rivulet::hmi
