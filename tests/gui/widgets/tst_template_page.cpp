// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "templates/generator.h"
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
    const templates::TemplateParameters parameters;
    const QString text = QString::fromStdString(templates::generateTemplate(parameters).value());
    page.setTemplate(text, QString::fromStdString(templates::templateFileName(parameters)),
                     templates::planCells(parameters).value(), templates::layoutNumber(parameters));
    QCOMPARE(page.text(), text);
    QVERIFY(page.findChild<QPlainTextEdit*>()->isReadOnly());
    QVERIFY(test::visibleText(page).contains("RIVULET_SIGNAL_7.MPF"));
    page.findChildren<QPushButton*>().first()->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), text);
    page.setProblem("N = 20 does not fit.");
    QVERIFY(page.text().isEmpty());
    QVERIFY(test::visibleText(page).contains("No template: N = 20 does not fit."));
  }

  void cellsAreNamed() {
    test::Language language;
    CellModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    templates::TemplateParameters parameters;
    parameters.axes = {true, true, false};
    model.setCells(templates::planCells(parameters).value());
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

QTEST_MAIN(TestTemplatePage)
#include "tst_template_page.moc"
