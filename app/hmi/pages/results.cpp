// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Pages that show what a run left behind: traces, report, log; and messages above them.

#include <QDateTime>

#include "hmi/pages/pages.h"
#include "widgets/common/log_view.h"
#include "widgets/common/message_area.h"
#include "widgets/streaming/report_panel.h"
#include "widgets/trace/trace_page.h"

namespace rivulet::hmi {

QWidget* makeTracePage(const Models& models, QWidget* parent) {
  auto* page = new widgets::TracePage(parent);
  QObject::connect(&models.runs, &RunController::started, page, &widgets::TracePage::clear);
  QObject::connect(&models.runs, &RunController::sampled, page, &widgets::TracePage::append);
  QObject::connect(&models.runs, &RunController::paused, page, &widgets::TracePage::addPause);
  QObject::connect(&models.runs, &RunController::finished, page,
                   [page](const std::shared_ptr<const streaming::RunReport>& report) {
                     if (report->controlTrace) {
                       page->showControlTrace(report->controlTrace, report->pauses);
                     }
                   });
  return page;
}

QWidget* makeReportPage(const Models& models, QWidget* parent) {
  auto* page = new widgets::ReportPanel(parent);
  QObject::connect(&models.runs, &RunController::started, page,
                   [page] { page->setReport(std::nullopt); });
  QObject::connect(&models.runs, &RunController::finished, page,
                   [page](const std::shared_ptr<const streaming::RunReport>& report) {
                     page->setReport(*report);
                   });
  return page;
}

QWidget* makeLogPage(const Models& models, QWidget* parent) {
  auto* page = new widgets::LogView(parent);
  QObject::connect(&models.messages, &Messages::logged, page,
                   [page](gcode::Severity severity, const QString& text) {
                     page->append({QDateTime::currentDateTime(), severity, text});
                   });
  QObject::connect(page, &widgets::LogView::saveRequested, page,
                   [page, models](const QString& path) { saveText(models, path, page->toText()); });
  return page;
}

QWidget* makeMessageArea(const Models& models, QWidget* parent) {
  auto* area = new widgets::MessageArea(parent);
  QObject::connect(&models.messages, &Messages::shown, area, &widgets::MessageArea::showMessage);
  QObject::connect(&models.messages, &Messages::cleared, area, &widgets::MessageArea::clear);
  return area;
}

}  // namespace rivulet::hmi
