// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// The page of all runs: the table, its filters, what is shown of a run and what is asked for.

#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "widgets/common/theme.h"
#include "widgets/runs/run_sheet.h"
#include "widgets/runs/runs_page.h"

using namespace rivulet;
using namespace rivulet::widgets;
using streaming::RunSummary;

namespace {

QPushButton* button(const RunsPage& page, const QString& text) {
  for (QPushButton* candidate : page.findChildren<QPushButton*>()) {
    if (candidate->text() == text) {
      return candidate;
    }
  }
  return nullptr;
}

QStringList column(const RunsPage& page, int column) {
  const QAbstractItemModel* model = page.table()->model();
  QStringList texts;
  for (int row = 0; row < model->rowCount(); ++row) {
    texts.append(model->index(row, column).data().toString());
  }
  return texts;
}

}  // namespace

class TestRunsPage : public QObject {
  Q_OBJECT

  std::unique_ptr<RunsPage> m_page;
  const std::vector<RunSummary> m_runs = test::pastRuns();

 private Q_SLOTS:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
    m_page = std::make_unique<RunsPage>();
    m_page->resize(1000, 700);
    m_page->show();
  }

  void saysThatThereIsNoRun() {
    m_page->setRuns({}, {});
    QVERIFY(test::visibleText(*m_page).contains(QStringLiteral("No run yet")));
    QVERIFY(!button(*m_page, QStringLiteral("Repeat with these settings"))->isEnabled());
    QVERIFY(!button(*m_page, QStringLiteral("Table as CSV…"))->isEnabled());
  }

  void namesTheFeedsOfTheProgram() {
    std::vector<RunSummary> runs{m_runs.front()};
    runs.front().overrideFactor = 0.8;
    m_page->setRuns(runs, {});
    QCOMPARE(column(*m_page, RunsModel::Feed), QStringList{QStringLiteral("program, 80 %")});
    streaming::RunReport report = test::report();
    report.settings.programFeeds = gcode::ProgramFeeds{0.8, 500.0, 500.0};
    m_page->setDetail(runs.front().id, report);
    QCOMPARE(test::visibleText(*m_page).count(QStringLiteral("program, 80 %")), 1);
  }

  void showsTheNewestAndAsksForItsReport() {
    QSignalSpy asked(m_page.get(), &RunsPage::detailRequested);
    m_page->setRuns(m_runs, {});
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked[0][0].toString(), QString::fromStdString(m_runs.front().id));
    QCOMPARE(m_page->current()->id, m_runs.front().id);
    // Nothing can be done with it before its report is there.
    QVERIFY(!button(*m_page, QStringLiteral("Page as PDF…"))->isEnabled());
    m_page->setDetail("another", test::report());
    QVERIFY(!button(*m_page, QStringLiteral("Page as PDF…"))->isEnabled());
    m_page->setDetail(m_runs.front().id, test::report());
    QVERIFY(button(*m_page, QStringLiteral("Page as PDF…"))->isEnabled());
    QVERIFY(test::visibleText(*m_page).contains(QStringLiteral("1,353 of 1,353")));
  }

  void sortsByValuesNotByTexts() {
    m_page->setRuns(m_runs, {});
    m_page->table()->sortByColumn(RunsModel::Executed, Qt::AscendingOrder);
    QCOMPARE(column(*m_page, RunsModel::Executed).first(), QStringLiteral("210 of 12,000"));
    QCOMPARE(column(*m_page, RunsModel::Executed).last(), QStringLiteral("12,000 of 12,000"));
    m_page->table()->sortByColumn(RunsModel::Duration, Qt::DescendingOrder);
    QCOMPARE(column(*m_page, RunsModel::Duration).first(), QStringLiteral("1:02:05\u00A0h"));
  }

  void filtersByWordsResultAndMachine() {
    m_page->setRuns(m_runs, {});
    const int all = static_cast<int>(m_runs.size());
    m_page->search()->setText(QStringLiteral("pocket anna"));
    QVERIFY(m_page->table()->model()->rowCount() < all);
    QVERIFY(m_page->table()->model()->rowCount() > 0);
    for (const QString& program : column(*m_page, RunsModel::Program)) {
      QVERIFY(program.contains(QStringLiteral("POCKET")));
    }
    m_page->search()->setText(QStringLiteral("nothing has this"));
    QCOMPARE(m_page->table()->model()->rowCount(), 0);
    QVERIFY(test::visibleText(*m_page).contains(QStringLiteral("Runs: 0 of %1").arg(all)));
    m_page->search()->clear();
    QCOMPARE(m_page->table()->model()->rowCount(), all);
    for (QComboBox* box : m_page->findChildren<QComboBox*>()) {
      const int wrong = box->findText(QStringLiteral("Failed or wrong"));
      if (wrong >= 0) {
        box->setCurrentIndex(wrong);
      }
    }
    QCOMPARE(m_page->shownRuns().size(), std::size_t{2});
    for (const RunSummary& run : m_page->shownRuns()) {
      QVERIFY(run.finding == streaming::RunFinding::Faulty);
    }
  }

  void keepsTheSelectionWhenTheListIsNew() {
    m_page->setRuns(m_runs, {});
    m_page->select(m_runs[2].id);
    m_page->setDetail(m_runs[2].id, test::report());
    QSignalSpy asked(m_page.get(), &RunsPage::detailRequested);
    std::vector<RunSummary> more = m_runs;
    more.insert(more.begin(), m_runs.front());
    more.front().id = "newer";
    more.front().origin.startedAtUtc = "2026-11-30T05:12:07Z";
    m_page->setRuns(more, {});
    QCOMPARE(m_page->current()->id, m_runs[2].id);
    QCOMPARE(asked.count(), 0);
    QVERIFY(button(*m_page, QStringLiteral("Page as PDF…"))->isEnabled());
    // Removed meanwhile: the newest is shown.
    more.erase(more.begin() + 3);
    m_page->setRuns(more, {});
    QCOMPARE(m_page->current()->id, std::string("newer"));
    QCOMPARE(asked.count(), 1);
  }

  void offersWhatIsPossible() {
    m_page->setRuns(m_runs, {});
    m_page->setDetail(m_runs.front().id, test::report());
    QPushButton* resume = button(*m_page, QStringLiteral("Resume"));
    QVERIFY(!resume->isEnabled());
    QVERIFY(!resume->toolTip().isEmpty());
    m_page->setResumable(m_runs[1].runNumber);
    QVERIFY(!resume->isEnabled());
    m_page->setResumable(m_runs.front().runNumber);
    QVERIFY(resume->isEnabled());
    QSignalSpy resumed(m_page.get(), &RunsPage::resumeRequested);
    QTest::mouseClick(resume, Qt::LeftButton);
    QCOMPARE(resumed.count(), 1);
    QPushButton* repeat = button(*m_page, QStringLiteral("Repeat with these settings"));
    QVERIFY(repeat->isEnabled());
    m_page->setRepeatEnabled(false);
    QVERIFY(!repeat->isEnabled());
    QVERIFY(button(*m_page, QStringLiteral("Open in Traces"))->isEnabled());
    m_page->select(m_runs[1].id);  // was not recorded
    m_page->setDetail(m_runs[1].id, test::report());
    QVERIFY(!button(*m_page, QStringLiteral("Open in Traces"))->isEnabled());
  }

  void saysWhyARunCannotBeShown() {
    m_page->setRuns(m_runs, {{QStringLiteral("old.report.json"), QStringLiteral("Too new.")}});
    QVERIFY(test::visibleText(*m_page).contains(QStringLiteral("old.report.json: Too new.")));
    m_page->setDetailProblem(m_runs.front().id, QStringLiteral("The report is damaged."));
    QVERIFY(test::visibleText(*m_page).contains(QStringLiteral("The report is damaged.")));
    QVERIFY(!button(*m_page, QStringLiteral("Repeat with these settings"))->isEnabled());
  }

  void asksForOtherBoundsOnlyIfTheOperatorChangesThem() {
    QSignalSpy asked(m_page.get(), &RunsPage::boundsRequested);
    m_page->setBounds({50, 2});
    QCOMPARE(asked.count(), 0);
    m_page->findChildren<QSpinBox*>().first()->setValue(40);
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked[0][0].value<HistoryBounds>().runs, 40);
    QCOMPARE(asked[0][0].value<HistoryBounds>().gibibytes, 2);
  }

  /// One page, with words, in both languages; a path that was not kept is said.
  void printsOnePage() {
    QTemporaryDir folder;
    test::Language language;
    for (const bool german : {false, true}) {
      if (german) {
        language.german();
      }
      const QString path = folder.filePath(QStringLiteral("run.pdf"));
      QVERIFY(paper::writePdf(path, runPage(test::runSheet())));
      QFile file(path);
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QByteArray pdf = file.readAll();
      QVERIFY(pdf.startsWith("%PDF-"));
      QCOMPARE(pdf.count("/Type /Page\n"), 1);
      QImage image(840, 1188, QImage::Format_RGB32);
      image.fill(Qt::white);
      QPainter painter(&image);
      painter.translate(72, 72);
      paper::paintPage(painter, QRectF(0, 0, 696, 1044), 4.0, runPage(test::runSheet()));
      painter.end();
      test::keep(image, german ? QStringLiteral("run_sheet_de") : QStringLiteral("run_sheet_en"));
      QVERIFY(test::colourCount(image) >= 20);
    }
    QVERIFY(!paper::writePdf(folder.filePath(QStringLiteral("no/such/folder.pdf")),
                             runPage(test::runSheet())));
  }
};

RIVULET_TEST(TestRunsPage)
#include "tst_runs_page.moc"
