// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QPainter>
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

  /// Who stands at the control has everything on one page of paper.
  void stepsArePrinted() {
    for (const bool isGerman : {false, true}) {
      test::Language language;
      if (isGerman) {
        language.german();
      }
      TemplatePage page;
      templates::TemplateParameters parameters;
      const auto program = templates::makeProgram(parameters);
      page.setTemplate(*program);
      const paper::Page sheet = page.sheet(QStringLiteral("1.2"));
      const QString html = paper::pageHtml(sheet);
      for (const QString& fact :
           {QString::fromStdString(program->name), QString::number(program->layoutNumber),
            QStringLiteral("R%1").arg(program->cells.last()), QStringLiteral("GiveUserAccess"),
            QStringLiteral("DeleteUserAccess"), QStringLiteral("Rivulet 1.2"),
            isGerman ? QStringLiteral("NC-Start") : QStringLiteral("cycle start")}) {
        QVERIFY2(html.contains(fact), qPrintable(fact));
      }
      QCOMPARE(sheet.sections.size(), std::size_t{4});
      // Numbered through, so that a step can be named on the phone.
      QVERIFY(sheet.sections.front().sentences.front().startsWith(QStringLiteral("1. ")));
      QVERIFY(sheet.sections.back().sentences.front().startsWith(
          QString::number(sheet.sections.front().sentences.size() + 1)));
      QImage picture(QSize(1240, 1754), QImage::Format_RGB32);
      picture.fill(Qt::white);
      QPainter painter(&picture);
      constexpr double kPxPerMm = 1240.0 / 210.0;
      paper::paintPage(painter, QRectF(picture.rect()).adjusted(80, 80, -80, -80), kPxPerMm, sheet);
      painter.end();
      test::keep(picture, isGerman ? QStringLiteral("template-steps-de")
                                   : QStringLiteral("template-steps-en"));
    }
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
