// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "widgets/common/diagnostic_text.h"
#include "widgets/program/diagnostic_model.h"
#include "widgets/program/program_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;

class TestProgramPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void showsTheFiguresOfAProgram() {
    test::Language language;
    ProgramPanel panel;
    QVERIFY(test::visibleText(panel).contains("No program"));
    const auto program = test::pocket();
    panel.setProgram(program);
    const auto points = test::streamed(*program);
    panel.setDistances(feasibility::programDistances(points, 7));
    const QString text = test::visibleText(panel);
    QVERIFY(text.contains("POCKET_60x40.MPF"));
    QVERIFY(text.contains(QString::fromStdString(program->hash)));
    QVERIFY(text.contains("G3 2"));
    QVERIFY(text.contains(QString("-30.000 … 30.000") + QChar(0x00A0) + "mm"));
    QVERIFY(text.contains("(3 values)"));
    QVERIFY(text.contains("(lines "));
    QVERIFY(!text.contains("Cannot be streamed"));
    panel.setProgram(nullptr);
    QVERIFY(test::visibleText(panel).contains("No program"));
    QVERIFY(!test::visibleText(panel).contains("(lines "));
  }

  void listsFindings() {
    test::Language language;
    DiagnosticModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    const auto program = test::brokenProgram();
    QVERIFY(!program->isStreamable());
    model.setProgram(program);
    QCOMPARE(model.rowCount(), static_cast<int>(program->diagnostics.size()));
    QCOMPARE(model.index(0, DiagnosticModel::SeverityColumn).data().toString(), QString("Error"));
    QCOMPARE(model.index(0, DiagnosticModel::Line).data().toString(), QString("3"));
    QVERIFY(model.index(0, DiagnosticModel::Text).data().toString().contains("G87"));
    ProgramPanel panel;
    panel.setProgram(program);
    QVERIFY(test::visibleText(panel).contains("Cannot be streamed"));
    // The sentence of the first finding stands there in full, and in the present language.
    QVERIFY(test::visibleText(panel).contains(diagnosticText(program->diagnostics.front())));
    language.german();
    QCOMPARE(model.index(0, DiagnosticModel::SeverityColumn).data().toString(), QString("Fehler"));
    QVERIFY(test::visibleText(panel).contains("Nicht streambar"));
    QVERIFY(test::visibleText(panel).contains(diagnosticText(program->diagnostics.front())));
    model.setProgram(nullptr);
    QCOMPARE(model.rowCount(), 0);
  }

  void asksForRecentAndDroppedFiles() {
    ProgramPanel panel;
    QSignalSpy opens(&panel, &ProgramPanel::openRequested);
    QSignalSpy drops(&panel, &ProgramPanel::fileDropped);
    panel.setRecentFiles({"/data/a.mpf", "/data/b.mpf"});
    const auto actions = panel.findChild<QMenu*>()->actions();
    QCOMPARE(actions.size(), 2);
    actions[1]->trigger();
    QCOMPARE(opens.count(), 1);
    QCOMPARE(opens.first().first().toString(), QString("/data/b.mpf"));

    QMimeData data;
    data.setUrls({QUrl("https://example.org/x.mpf"), QUrl::fromLocalFile("/data/c.mpf")});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel, &drop);
    QCOMPARE(drops.count(), 1);
    QCOMPARE(drops.first().first().toString(), QString("/data/c.mpf"));
  }

  void opensNothingWhileARunLasts() {
    ProgramPanel panel;
    panel.setRecentFiles({"/data/a.mpf"});
    panel.setOpenEnabled(false);
    for (const QPushButton* button : panel.findChildren<QPushButton*>()) {
      QVERIFY(!button->isEnabled());
    }
    QVERIFY(!panel.acceptDrops());
    panel.setOpenEnabled(true);
    for (const QPushButton* button : panel.findChildren<QPushButton*>()) {
      QVERIFY(button->isEnabled());
    }
  }
};

QTEST_MAIN(TestProgramPanel)
#include "tst_program_panel.moc"
