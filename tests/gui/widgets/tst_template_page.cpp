// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "widgets/templates/cell_model.h"
#include "widgets/templates/template_page.h"

using namespace rivulet;
using namespace rivulet::widgets;

class TestTemplatePage : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void showsAndCopiesTheTemplate() {
    test::Language language;
    TemplatePage page;
    QVERIFY(test::visibleText(page).contains("No template yet"));
    for (const QPushButton* button : page.findChildren<QPushButton*>()) {
      QVERIFY(!button->isEnabled());
    }
    templates::TemplateParameters parameters;
    parameters.method = base::MethodKind::Signal;
    const auto program = templates::makeProgram(parameters);
    const QString text = QString::fromStdString(program->text);
    page.setTemplate(*program);
    QCOMPARE(page.text(), text);
    QVERIFY(page.findChild<QPlainTextEdit*>()->isReadOnly());
    QVERIFY(test::visibleText(page).contains("RIVULET_SIGNAL_7.MPF"));
    page.findChildren<QPushButton*>().first()->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), text);
    page.setProblem("N = 20 does not fit.");
    QVERIFY(page.text().isEmpty());
    QVERIFY(test::visibleText(page).contains("No template: N = 20 does not fit."));
  }

  void cellsOfWindowsAreNamed() {
    test::Language language;
    CellModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    templates::TemplateParameters parameters;
    parameters.method = base::MethodKind::Window;
    parameters.pointsPerLoop = 3;
    const auto cells = templates::makeProgram(parameters)->cells;
    model.setCells(cells);
    QCOMPARE(model.rowCount(), 9 + 2 * (3 + 3));
    QSet<QString> seen;
    for (int row = 0; row < model.rowCount(); ++row) {
      QVERIFY(!model.index(row, CellModel::Role).data().toString().isEmpty());
      for (const QString& cell :
           model.index(row, CellModel::Parameters).data().toString().split(u' ')) {
        QVERIFY2(!seen.contains(cell), qPrintable(cell));
        seen.insert(cell);
      }
    }
    QVERIFY(seen.contains(QStringLiteral("R%1").arg(cells.last())));
    QCOMPARE(model.index(model.rowCount() - 1, CellModel::Role).data().toString(),
             QString("Window 2 point 3: X Y Z"));
    QCOMPARE(model.index(2, CellModel::Writer).data().toString(), QString("NC"));
    language.german();
    QCOMPARE(model.index(model.rowCount() - 1, CellModel::Role).data().toString(),
             QString("Fenster 2 Punkt 3: X Y Z"));
  }

  void cellsAreNamed() {
    test::Language language;
    CellModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    templates::TemplateParameters parameters;
    parameters.method = base::MethodKind::Signal;
    parameters.axes = {true, true, false};
    model.setCells(templates::makeProgram(parameters)->cells);
    QCOMPARE(model.rowCount(), 5 + 7);
    QCOMPARE(model.index(5, CellModel::Role).data().toString(), QString("Point 1: X Y"));
    QCOMPARE(model.index(5, CellModel::Parameters).data().toString(), QString("R11 R12"));
    QCOMPARE(model.index(4, CellModel::Writer).data().toString(), QString("NC"));
    language.german();
    QCOMPARE(model.index(5, CellModel::Role).data().toString(), QString("Punkt 1: X Y"));
    model.setCells(std::nullopt);
    QCOMPARE(model.rowCount(), 0);
  }
};

RIVULET_TEST(TestTemplatePage)
#include "tst_template_page.moc"
