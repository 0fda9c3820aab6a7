// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "report/experiments/experiment_report.h"
#include "report/svg_plot.h"
#include "support/test_program.h"

using namespace rivulet;
using papers::Experiment;
using papers::Plot;
using papers::SeriesStyle;

namespace {

Experiment sample() {
  Experiment experiment;
  experiment.name = "sample";
  experiment.title = "A title with <angles> & more";
  experiment.setup = "Two runs.";
  experiment.checks = {{"first, with a comma", "ms", "[P1] Table I", 4.0, 4.2, 3.0, 5.0},
                       {"second", "", "none", std::nan(""), 9.0, 0.0, 1.0}};
  experiment.tables = {{"A table", {"a (mm)", "b"}, {{"1.5", "say \"x\""}}}};
  Plot plot{"Plot <1>", "F (mm/min)", "δ (mm)", {}};
  plot.series = {{"line & dots", SeriesStyle::Line, false, {0, 1, 2}, {1, 4, 2}, {}},
                 {"band", SeriesStyle::Band, false, {0, 2}, {0, 1}, {2, 3}},
                 {"steps", SeriesStyle::Steps, false, {0, 1}, {0, 1}, {}},
                 {"paper", SeriesStyle::Points, true, {1}, {3}, {}}};
  experiment.plots = {plot};
  experiment.notes = {"A note."};
  return experiment;
}

}  // namespace

class TestExperimentReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textNamesWhatIsOutside() {
    const QString text = QString::fromStdString(report::experimentText(sample()));
    QVERIFY(text.contains(u"OUTSIDE"));
    QVERIFY(text.contains(u"+5.0 %"));
    QVERIFY(text.contains(u"3 to 5"));
  }

  void jsonHasEveryFigure() {
    const auto json = nlohmann::json::parse(report::experimentJson(sample()).dump());
    QCOMPARE(json["passed"].get<bool>(), false);
    QCOMPARE(json["checks"].size(), std::size_t{2});
    QVERIFY(json["checks"][1]["reference"].is_null());
    QCOMPARE(json["plots"][0]["series"][1]["y_upper"][1].get<double>(), 3.0);
  }

  void csvQuotesAndKeepsColumns() {
    const QString text = QString::fromStdString(report::experimentCsv(sample()));
    QVERIFY(text.contains(u"sample,\"first, with a comma\",ms,[P1] Table I,4,4.2,3,5,,,1\n"));
    QVERIFY(text.contains(u"1.5,\"say \"\"x\"\"\"\n"));
    QVERIFY(text.contains(u"band,0,0,2\n"));
  }

  void markdownNamesItsPictures() {
    const QString text =
        QString::fromStdString(report::experimentMarkdown(sample(), {"images/x.svg"}));
    QVERIFY(text.contains(u"](images/x.svg)"));
    QVERIFY(text.contains(u"| first, with a comma | 4 ms | 4.2 ms |"));
  }

  /// A check that a null model passes as well shows nothing, and the page says so.
  void marksAndNullModelsHaveColumnsWhereThereAreAny() {
    Experiment experiment = sample();
    QVERIFY(report::experimentMarkdown(experiment, {}).find("null model") == std::string::npos);
    experiment.checks[0].mark = papers::Mark::Fitted;
    experiment.checks[0].nullModel = 3.5;
    experiment.checks[1].nullModel = 2.0;
    QVERIFY(experiment.checks[0].nullModelPasses() && !experiment.checks[1].nullModelPasses());
    const QString text = QString::fromStdString(report::experimentMarkdown(experiment, {}));
    QVERIFY(
        text.contains(u"| 3.5 ms | 3 to 5 | fitted | [P1] Table I | ok; the null model passes |"));
    QVERIFY(text.contains(u"| 2 | 0 to 1 |  | none | OUTSIDE |"));
  }

  /// One file: nothing is loaded from elsewhere, and a changed figure changes the page's hash.
  void pageNeedsNoOtherFile() {
    Experiment experiment = sample();
    experiment.checks[0].mark = papers::Mark::Predicted;
    const auto pageOf = [](const Experiment& one) {
      return QString::fromStdString(
          report::experimentPage({one, one}, {{"Rivulet", "0.1"}, {"machine", "<mine> & \"x\""}}));
    };
    const QString page = pageOf(experiment);
    QVERIFY(page.contains(u"A title with &lt;angles&gt; &amp; more"));
    QVERIFY(page.contains(u"&lt;mine&gt; &amp;"));
    QVERIFY(page.contains(u"<td>predicted</td>"));
    QVERIFY(page.contains(u"<td class=\"outside\">OUTSIDE</td>"));
    QVERIFY(page.contains(u"<td>1 of 2</td>"));
    QCOMPARE(page.count(QStringLiteral("<svg")), 2);
    for (const char* link : {"src=", "href=", "url(", "@import", "<script", "<?xml"}) {
      QVERIFY2(!page.contains(QLatin1String(link)), link);
    }
    QXmlStreamReader body(
        page.mid(page.indexOf(QStringLiteral("<body>"))).remove(QStringLiteral("</html>")));
    while (!body.atEnd()) {
      body.readNext();
    }
    QVERIFY2(!body.hasError(), qPrintable(body.errorString()));
    const QRegularExpression hash(QStringLiteral("all figures</td><td>([0-9a-f]{64})<"));
    const QString before = hash.match(page).captured(1);
    QCOMPARE(before.size(), 64);
    experiment.checks[0].ours = 4.2000001;
    QVERIFY(hash.match(pageOf(experiment)).captured(1) != before);
  }

  void svgIsWellFormedAndTheSameEachTime() {
    for (const Plot& plot :
         {sample().plots[0], Plot{"empty", "x", "y", {}},
          Plot{"flat", "x", "y", {{"one", SeriesStyle::Line, false, {1, 2}, {3, 3}, {}}}}}) {
      const std::string svg = report::svgPlot(plot);
      QVERIFY(svg == report::svgPlot(plot));
      QXmlStreamReader reader(QString::fromStdString(svg));
      QStringList elements;
      while (!reader.atEnd()) {
        if (reader.readNext() == QXmlStreamReader::StartElement) {
          elements << reader.name().toString();
        }
      }
      QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
      QVERIFY(elements.contains(QStringLiteral("text")));
      QVERIFY(!svg.empty() && svg.find("nan") == std::string::npos);
    }
  }
};

RIVULET_TEST(TestExperimentReport)
#include "tst_experiment_report.moc"
