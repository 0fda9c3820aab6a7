// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/emulator/emulator_page.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/folding_tabs.h"
#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/table_style.h"
#include "widgets/common/theme.h"
#include "widgets/emulator/emulator_text.h"
#include "widgets/emulator/overlay_panel.h"
#include "widgets/emulator/response_panel.h"
#include "widgets/plots/box_plot.h"
#include "widgets/plots/curve_chart.h"
#include "widgets/plots/heat_map.h"

namespace rivulet::widgets {

namespace {

enum Tab { kRecordings, kParameters, kTests, kMatrix, kOverlay };

constexpr int kBarSteps = 1000;
constexpr int kRecordingTablePx = 150;
constexpr int kCurvePx = 150;
constexpr int kMicrometreDigits = 3;

QString nameOfFile(const QString& path) {
  return QFileInfo(path).fileName();
}

/// A number of µm in a column that says so.
QString micrometres(double mm) {
  constexpr double kFinestMm = 1e-6;
  return mm < kFinestMm ? QStringLiteral("<\u00a0%1").arg(numberText(1e3 * kFinestMm, 3))
                        : significantText(1e3 * mm, kMicrometreDigits);
}

QTableView* makeTable(QAbstractItemModel* model, const char* name, QWidget* parent) {
  auto* table = new QTableView(parent);
  styleTable(table);
  table->setObjectName(QLatin1String(name));
  table->setModel(model);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->verticalHeader()->setDefaultSectionSize(kTouchHeightPx);
  return table;
}

}  // namespace

EmulatorPage::EmulatorPage(QWidget* parent)
    : Page(parent),
      m_bar(
          say(new QProgressBar(this), {.name = QT_TR_NOOP("Progress"), .id = "emulatorProgress"})),
      m_tabs(new FoldingTabs(this)) {
  setAcceptDrops(true);
  m_bar->setRange(0, kBarSteps);
  m_tabs->tabs()->setObjectName(QStringLiteral("emulatorTabs"));
  m_tabs->tabs()->setDocumentMode(true);
  m_overlay = new OverlayPanel(this);
  m_tabs->addPage(makeRecordings());
  m_tabs->addPage(makeParameters());
  m_tabs->addPage(makeTests());
  m_tabs->addPage(makeMatrix());
  m_tabs->addPage(m_overlay);
  inColumn({inRow({{m_note, 1, Qt::AlignVCenter}, m_add, m_learn, m_cancel, m_save}),
            m_bar,
            {m_tabs, 1}},
           this);
  connectParts();
  retranslate();
  onTheme([this] { m_recordingsTab.curve->update(); });
}

EmulatorPage::~EmulatorPage() = default;

QWidget* EmulatorPage::makeRecordings() {
  auto* page = new QWidget(this);
  m_recordingsTab.model = new TableModel<RecordingView>(
      {{[] { return tr("Recording"); },
        [](const RecordingView& row) { return nameOfFile(row.trace); }},
       {[] { return tr("Use"); },
        [](const RecordingView& row) { return row.isForTest ? tr("Test") : tr("Learn"); }},
       {[] { return tr("NC program"); },
        [](const RecordingView& row) {
          return row.state == RecordingView::State::NeedsProgram ? tr("missing")
                 : row.program.isEmpty()                         ? tr("not needed")
                                                                 : nameOfFile(row.program);
        }},
       {[] { return tr("Axes"); },
        [](const RecordingView& row) {
          return row.axes.empty() ? noValue() : QString::fromStdString(row.axes);
        }},
       {[] { return tr("Length"); },
        [](const RecordingView& row) {
          return row.lengthS > 0.0 ? durationText(row.lengthS) : noValue();
        },
        true},
       {[] { return tr("Samples per s"); },
        [](const RecordingView& row) {
          return row.samplesPerS > 0.0 ? significantText(row.samplesPerS, 3) : noValue();
        },
        true},
       {[] { return tr("Largest feed"); },
        [](const RecordingView& row) {
          return row.feedMmPerSMax > 0.0 ? feedText(row.feedMmPerSMax) : noValue();
        },
        true}},
      this);
  m_recordingsTab.table = say(makeTable(m_recordingsTab.model, "emulatorRecordings", page),
                              {.tip = QT_TR_NOOP("Enter changes the use of a recording"),
                               .name = QT_TR_NOOP("Recordings")});
  m_recordingsTab.table->setMinimumHeight(kRecordingTablePx);
  m_recordingsTab.table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_recordingsTab.program =
      button({.text = QT_TR_NOOP("NC program…"),
              .tip = QT_TR_NOOP("The program that ran: needed for a recording without set points"),
              .id = "emulatorProgram"},
             &EmulatorPage::chooseProgram);
  m_recordingsTab.use = button(
      {.tip = QT_TR_NOOP("A recording used to test is not learned from"), .id = "emulatorUse"});
  m_recordingsTab.remove =
      button({.text = QT_TR_NOOP("Remove"),
              .tip = QT_TR_NOOP("Takes the recording from the list; the file stays"),
              .id = "emulatorRemove"});
  m_recordingsTab.presets =
      list({.tip = QT_TR_NOOP("Preset that has the limits of the machine; set points of "
                              "programs are planned with them"),
            .name = QT_TR_NOOP("What recordings do not say"),
            .id = "emulatorPreset",
            .isTouch = true});
  m_recordingsTab.presets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_recordingsTab.presets->setMinimumContentsLength(12);
  m_recordingsTab.curve =
      say(new CurveChart(AxisScale::Even, AxisScale::Logarithmic, page), {.id = "emulatorCurve"});
  m_recordingsTab.curve->setMinimumHeight(kCurvePx);
  m_recordingsTab.curve->setCounts();
  inColumn(
      {{m_recordingsTab.table, 1},
       inRow({m_recordingsTab.program, m_recordingsTab.use, m_recordingsTab.remove, spring()}),
       inRow({label({.text = QT_TR_NOOP("What recordings do not say")}, m_recordingsTab.presets),
              m_recordingsTab.presets, spring()}),
       {m_recordingsTab.curve, 1}},
      page, QMargins(4, 6, 4, 4));
  return page;
}

QWidget* EmulatorPage::makeParameters() {
  auto* page = new QWidget(this);
  m_parameters.remark = status({.id = "emulatorRemark"});
  m_parameters.remark->setWordWrap(true);
  const auto withUnit = [](const QString& text, emulator::AxisParameter parameter) {
    const QString unit = parameterUnit(parameter);
    return unit.isEmpty() ? text : QStringLiteral("%1\u00a0%2").arg(text, unit);
  };
  m_parameters.model = new TableModel<ParameterRow>(
      {{[] { return tr("Axis"); },
        [](const ParameterRow& row) { return QString(QLatin1Char(row.axis)); }},
       {[] { return tr("Parameter"); },
        [](const ParameterRow& row) { return parameterName(row.estimate.parameter); }},
       {[] { return tr("Value"); },
        [withUnit](const ParameterRow& row) {
          const emulator::AxisParameter parameter = row.estimate.parameter;
          return withUnit(parameterText(parameter, row.estimate.value), parameter);
        },
        true},
       {[] { return tr("Interval"); },
        [](const ParameterRow& row) {
          const emulator::ParameterEstimate& estimate = row.estimate;
          if (!estimate.hasInterval()) {
            return tr("none: what the model leaves is not chance");
          }
          return tr("%1 to %2")
              .arg(parameterText(estimate.parameter, estimate.low),
                   parameterText(estimate.parameter, estimate.high));
        },
        true},
       {[] { return tr("Meaning"); },
        [](const ParameterRow& row) { return parameterMeaning(row.estimate.parameter); }}},
      this);
  m_parameters.table = say(makeTable(m_parameters.model, "emulatorParameters", page),
                           {.name = QT_TR_NOOP("Parameters")});
  m_parameters.table->setWordWrap(true);
  m_parameters.table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_parameters.table->horizontalHeader()->setSectionResizeMode(
      m_parameters.model->columnCount() - 1, QHeaderView::Stretch);
  m_parameters.table->setMinimumHeight(kRecordingTablePx);
  m_parameters.more = button({.text = QT_TR_NOOP("Bode and step plots"),
                              .tip = QT_TR_NOOP("For those who know control engineering"),
                              .id = "emulatorMore"});
  m_parameters.more->setCheckable(true);
  m_parameters.response = say(new ResponsePanel(page), {.id = "emulatorResponse"});
  m_parameters.response->hide();
  inColumn({m_parameters.remark,
            {m_parameters.table, 1},
            inRow({m_parameters.more, spring()}),
            {m_parameters.response, 1}},
           page, QMargins(4, 6, 4, 4));
  return page;
}

QWidget* EmulatorPage::makeTests() {
  auto* page = new QWidget(this);
  m_tests.stretches = value({.id = "emulatorStretches", .wraps = true});
  m_tests.model = new TableModel<TestRow>(
      {{[] { return tr("Recording"); },
        [](const TestRow& row) { return QString::fromStdString(row.fit.name); }},
       {[] { return tr("Use"); },
        [](const TestRow& row) { return row.isUnseen ? tr("Test") : tr("Learn"); }},
       {[] { return tr("Position RMS, µm"); },
        [](const TestRow& row) { return micrometres(row.fit.positionRmsMm); }, true},
       {[] { return tr("at most, µm"); },
        [](const TestRow& row) { return micrometres(row.fit.positionMaxMm); }, true},
       {[] { return tr("Contour RMS, µm"); },
        [](const TestRow& row) { return micrometres(row.fit.contourRmsMm); }, true},
       {[] { return tr("emulated, µm"); },
        [](const TestRow& row) { return micrometres(row.fit.emulatedContourRmsMm); }, true},
       {[] { return tr("Speed, %"); },
        [](const TestRow& row) { return significantText(1e2 * row.fit.speedRmsShare, 2); }, true}},
      this);
  m_tests.table =
      say(makeTable(m_tests.model, "emulatorTests", page), {.name = QT_TR_NOOP("Tests")});
  m_tests.table->setMinimumHeight(kRecordingTablePx);
  m_tests.table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  inColumn({m_tests.stretches, {m_tests.table, 1}}, page, QMargins(4, 6, 4, 4));
  return page;
}

QWidget* EmulatorPage::makeMatrix() {
  auto* page = new QWidget(this);
  m_comparison.compare =
      button({.text = QT_TR_NOOP("Compare recordings"),
              .tip = QT_TR_NOOP("Takes at most as long as learning, for each recording"),
              .id = "emulatorCompare"});
  m_comparison.text = makeValueLabel(page);
  m_comparison.worthText = makeValueLabel(page);
  m_comparison.matrix = say(new HeatMap(page), {.id = "emulatorMatrix"});
  m_comparison.worth = say(new BoxPlot(page), {.id = "emulatorWorth"});
  auto* charts = new QGridLayout;
  charts->setHorizontalSpacing(16);
  int column = 0;
  for (const auto& [text, chart] :
       {std::pair<QLabel*, QWidget*>{m_comparison.text, m_comparison.matrix},
        {m_comparison.worthText, m_comparison.worth}}) {
    text->setWordWrap(true);
    charts->addWidget(text, 0, column, Qt::AlignTop);
    charts->addWidget(chart, 1, column);
    charts->setColumnStretch(column, 1);
    ++column;
  }
  charts->setRowStretch(1, 1);
  inColumn({inRow({m_comparison.compare, spring()}), {charts, 1}}, page, QMargins(4, 6, 4, 4));
  return page;
}

void EmulatorPage::connectParts() {
  connect(m_comparison.compare, &QPushButton::clicked, this, [this] {
    forgetNews();
    Q_EMIT compareRequested();
  });
  connect(m_recordingsTab.remove, &QPushButton::clicked, this, [this] {
    forgetNews();
    Q_EMIT removeRequested(chosenRecording());
  });
  const auto changeUse = [this] {
    const int row = chosenRecording();
    if (row >= 0 && m_recordingsTab.use->isEnabled()) {
      forgetNews();
      Q_EMIT useChosen(row, !m_recordings[static_cast<std::size_t>(row)].isForTest);
    }
  };
  connect(m_recordingsTab.use, &QPushButton::clicked, this, changeUse);
  connect(m_recordingsTab.table, &QTableView::activated, this, changeUse);
  connect(m_recordingsTab.table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &EmulatorPage::showChoice);
  connect(m_recordingsTab.presets, &QComboBox::activated, this, &EmulatorPage::choosePreset);
  connect(m_parameters.more, &QPushButton::toggled, m_parameters.response, &QWidget::setVisible);
}

int EmulatorPage::chosenRecording() const {
  const int row = m_recordingsTab.table->currentIndex().row();
  return row < static_cast<int>(m_recordings.size()) ? row : -1;
}

void EmulatorPage::setBlocked(const QString& reason) {
  m_blocked = reason;
  refresh();
}

void EmulatorPage::setRecordings(std::vector<RecordingView> recordings) {
  const int row = m_recordingsTab.table->currentIndex().row();
  m_recordings = std::move(recordings);
  m_recordingsTab.model->setRows(m_recordings);
  if (!m_recordings.empty()) {
    m_recordingsTab.table->selectRow(std::clamp(row, 0, static_cast<int>(m_recordings.size()) - 1));
  }
  showChoice();
  refresh();
}

void EmulatorPage::setPresets(const QStringList& names, const QString& chosen) {
  m_presets = names;
  m_preset = chosen;
  if (!m_presets.contains(chosen)) {
    m_presets.append(chosen);
  }
  m_recordingsTab.presets->clear();
  for (const QString& name : std::as_const(m_presets)) {
    m_recordingsTab.presets->addItem(nameOfFile(name));
  }
  m_recordingsTab.presets->addItem(tr("File…"));
  m_recordingsTab.presets->setCurrentIndex(static_cast<int>(m_presets.indexOf(chosen)));
}

void EmulatorPage::startLearning() {
  m_isLearning = true;
  forgetNews();
  m_progress.reset();
  m_steps.clear();
  m_shareShown = 0.0;
  m_tabs->tabs()->setCurrentIndex(kRecordings);
  showCurve();
  refresh();
}

void EmulatorPage::addProgress(const emulator::LearnProgress& progress) {
  m_progress = progress;
  m_shareShown = std::max(m_shareShown, progress.share);
  m_steps[progress.axis].push_back(progress);
  showCurve();
  refresh();
}

void EmulatorPage::showComparing(double share) {
  m_isComparing = true;
  m_shareShown = share;
  refresh();
}

void EmulatorPage::endLearning() {
  m_isLearning = false;
  m_isComparing = false;
  refresh();
}

void EmulatorPage::setEmulator(std::shared_ptr<const EmulatorView> emulator) {
  const bool isNew = emulator && emulator != m_emulator;
  m_emulator = std::move(emulator);
  forgetNews();
  if (isNew) {
    m_crossTest = {};
  }
  showResult();
  QStringList runs;
  if (m_emulator) {
    for (const auto* list : {&m_emulator->learnedFrom, &m_emulator->unseen}) {
      for (const emulator::RunFit& fit : *list) {
        runs.append(QString::fromStdString(fit.name));
      }
    }
  }
  m_overlay->setRuns(runs);
  if (isNew) {
    m_tabs->tabs()->setCurrentIndex(kParameters);
  }
  refresh();
}

void EmulatorPage::setCrossTest(emulator::CrossTest test) {
  m_crossTest = std::move(test);
  showMatrix();
}

void EmulatorPage::forgetNews() {
  m_problem.clear();
  m_saved.clear();
}

void EmulatorPage::showProblem(const QString& sentence) {
  m_problem = sentence;
  refresh();
}

void EmulatorPage::showSaved(const QString& path) {
  m_problem.clear();
  m_saved = path;
  refresh();
}

void EmulatorPage::chooseRecordings() {
  forgetNews();
  askForFiles(
      this,
      {tr("Add recordings"),
       {},
       tr("Traces") + QStringLiteral(" (*.rivulet *.csv *.tsv *.txt *.xml *.zst *.dat *.log);;") +
           tr("All files") + QStringLiteral(" (*)")},
      [this](const QStringList& paths) { Q_EMIT addRequested(paths); });
}

void EmulatorPage::chooseProgram() {
  const int row = chosenRecording();
  if (row < 0) {
    return;
  }
  forgetNews();
  const RecordingView& recording = m_recordings[static_cast<std::size_t>(row)];
  askForFile(this,
             {tr("NC program of %1").arg(nameOfFile(recording.trace)),
              QFileInfo(recording.trace).path(), tr("All files") + QStringLiteral(" (*)")},
             [this, row](const QString& path) { Q_EMIT programChosen(row, path); });
}

void EmulatorPage::choosePreset(int index) {
  const auto choose = [this](const QString& preset) {
    if (!preset.isEmpty() && preset != m_preset) {
      forgetNews();
      Q_EMIT presetChosen(preset);
    }
  };
  m_recordingsTab.presets->setCurrentIndex(static_cast<int>(m_presets.indexOf(m_preset)));
  if (index == m_presets.size()) {
    askForFile(this, {tr("Preset of the machine"), {}, tr("Presets") + QStringLiteral(" (*.toml)")},
               choose);
  } else {
    choose(m_presets.value(index));
  }
}

void EmulatorPage::chooseFileToSave() {
  askWhereToSave(this,
                 {tr("Save as preset"), QStringLiteral("machine.toml"),
                  tr("Presets") + QStringLiteral(" (*.toml)")},
                 [this](QString path, auto) {
                   if (QFileInfo(path).suffix().toLower() != QLatin1String("toml")) {
                     path += QStringLiteral(".toml");
                   }
                   Q_EMIT saveRequested(path);
                 });
}

void EmulatorPage::showChoice() {
  const int row = chosenRecording();
  const bool isFree = row >= 0 && !m_isLearning && !m_isComparing;
  for (QPushButton* button :
       {m_recordingsTab.program, m_recordingsTab.use, m_recordingsTab.remove}) {
    button->setEnabled(isFree);
  }
  const bool isForTest = row >= 0 && m_recordings[static_cast<std::size_t>(row)].isForTest;
  m_recordingsTab.use->setText(isForTest ? tr("Use to learn") : tr("Use to test"));
  m_recordingsTab.use->setAccessibleName(m_recordingsTab.use->text());
}

void EmulatorPage::showCurve() {
  std::vector<ChartCurve> curves;
  std::size_t color = 0;
  for (const auto& [axis, steps] : m_steps) {
    ChartCurve best{QString(QLatin1Char(axis)), color, false, {}};
    ChartCurve tried{{}, color, true, {}};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto at = static_cast<double>(i + 1);
      best.points.emplace_back(at, 1e3 * steps[i].heldOutRmsMm);
      tried.points.emplace_back(at, 1e3 * steps[i].triedRmsMm);
    }
    curves.push_back(std::move(best));
    curves.push_back(std::move(tried));
    ++color;
  }
  m_recordingsTab.curve->setCurves(std::move(curves));
  m_recordingsTab.curve->setVisible(m_isLearning || !m_steps.empty());
}

void EmulatorPage::showResult() {
  std::vector<ParameterRow> parameters;
  std::vector<TestRow> tests;
  QStringList stretches;
  if (m_emulator) {
    for (const emulator::LearnedAxis& axis : m_emulator->emulator.axes) {
      for (const emulator::ParameterEstimate& estimate : axis.estimates) {
        parameters.push_back({axis.axis, estimate});
      }
      stretches.append(QString(QLatin1Char(axis.axis)) + QLatin1Char(' ') +
                       errorLengthText(axis.heldOutRmsMm));
    }
    for (const emulator::RunFit& fit : m_emulator->unseen) {
      tests.push_back({fit, true});
    }
    for (const emulator::RunFit& fit : m_emulator->learnedFrom) {
      tests.push_back({fit, false});
    }
    const EmulatorRemark remark = emulatorRemark(*m_emulator);
    m_parameters.remark->setStatus(remark.status, remark.text);
  } else {
    m_parameters.remark->setStatus(Status::Unknown, tr("Nothing is learned yet."));
  }
  m_parameters.model->setRows(parameters);
  m_tests.model->setRows(tests);
  m_tests.stretches->setText(
      stretches.isEmpty()
          ? tr("Nothing is learned yet.")
          : tr("On parts that were held out while learning (RMS): %1. A recording used to test "
               "was not learned from at all.")
                .arg(stretches.join(QStringLiteral(", "))));
  m_parameters.response->setAxes(m_emulator ? m_emulator->emulator.axes
                                            : std::vector<emulator::LearnedAxis>{});
  m_parameters.table->setVisible(m_emulator != nullptr);
  m_tests.table->setVisible(m_emulator != nullptr);
  m_parameters.more->setVisible(m_emulator != nullptr);
  m_parameters.response->setVisible(m_emulator != nullptr && m_parameters.more->isChecked());
  showMatrix();
}

void EmulatorPage::showMatrix() {
  const bool isThere = !m_crossTest.runs.empty();
  QStringList names;
  for (const std::string& run : m_crossTest.runs) {
    names.append(QString::fromStdString(run));
  }
  std::vector<std::vector<double>> micrometre = m_crossTest.rmsMm;
  for (std::vector<double>& row : micrometre) {
    for (double& value : row) {
      value *= 1e3;
    }
  }
  m_comparison.matrix->setCells(names, std::move(micrometre));
  std::vector<ChartBox> boxes;
  std::size_t color = 0;
  for (const emulator::ParameterWorth& worth : m_crossTest.worth) {
    if (!boxes.empty() && !boxes.back().name.startsWith(QLatin1Char(worth.axis))) {
      ++color;
    }
    ChartBox box{
        QString(QLatin1Char(worth.axis)) + QLatin1Char(' ') + parameterName(worth.parameter),
        color,
        {}};
    for (const double mm : worth.rmsMm) {
      box.values.push_back(1e3 * mm);
    }
    boxes.push_back(std::move(box));
  }
  m_comparison.worth->setBoxes(std::move(boxes));
  m_comparison.text->setText(
      isThere ? tr("How far an emulator is off that was learned from one recording alone.")
              : tr("Learns from each recording alone and tests on all others. So you see which "
                   "recordings teach most, and what each parameter is worth."));
  m_comparison.worthText->setText(
      tr("How much the positions would change on each recording if a parameter were 10 % larger."));
  m_comparison.matrix->setVisible(isThere);
  m_comparison.worthText->setVisible(isThere);
  m_comparison.worth->setVisible(isThere);
}

QString EmulatorPage::obstacle() const {
  bool learnsFrom = false;
  for (const RecordingView& row : m_recordings) {
    if (row.state == RecordingView::State::Reading) {
      return tr("Reading %1 …").arg(nameOfFile(row.trace));
    }
    if (row.state == RecordingView::State::NeedsProgram) {
      return tr("%1 has no set points: choose its NC program.").arg(nameOfFile(row.trace));
    }
    learnsFrom = learnsFrom || !row.isForTest;
  }
  if (m_recordings.empty()) {
    return tr(
        "Record a few programs with different feeds, corners and reversals, and add the "
        "recordings here.");
  }
  return learnsFrom ? QString() : tr("All recordings are used to test: use one to learn.");
}

void EmulatorPage::refresh() {
  const QString blocking = obstacle();
  const bool isBusy = m_isLearning || m_isComparing;
  m_learn->setVisible(!isBusy);
  m_cancel->setVisible(isBusy);
  m_bar->setVisible(isBusy);
  m_add->setEnabled(!isBusy);
  m_save->setEnabled(!isBusy && m_emulator != nullptr);
  m_comparison.compare->setEnabled(!isBusy && m_blocked.isEmpty() && m_emulator != nullptr);
  m_recordingsTab.presets->setEnabled(!isBusy);
  m_learn->setEnabled(m_blocked.isEmpty() && blocking.isEmpty());
  m_bar->setValue(static_cast<int>(std::lround(kBarSteps * m_shareShown)));
  showChoice();
  if (m_isComparing) {
    m_note->setStatus(Status::Busy, tr("Learning from each recording alone …"));
  } else if (m_isLearning) {
    m_note->setStatus(
        Status::Busy,
        m_progress ? tr("Learning axis %1: %2 of %3 models tried, the best is right within %4.")
                         .arg(QString(QLatin1Char(m_progress->axis)),
                              QString::number(m_progress->step), QString::number(m_progress->steps),
                              errorLengthText(m_progress->heldOutRmsMm))
                   : tr("Learning …"));
  } else if (!m_problem.isEmpty()) {
    m_note->setStatus(Status::Fault, m_problem);
  } else if (!m_blocked.isEmpty()) {
    m_note->setStatus(Status::Attention, m_blocked);
  } else if (!m_saved.isEmpty()) {
    m_note->setStatus(
        Status::Good,
        tr("Saved as %1. Give it to the virtual machine as its preset.").arg(m_saved));
  } else if (!blocking.isEmpty()) {
    const bool isReading = std::any_of(
        m_recordings.begin(), m_recordings.end(),
        [](const RecordingView& row) { return row.state == RecordingView::State::Reading; });
    m_note->setStatus(isReading              ? Status::Busy
                      : m_recordings.empty() ? Status::Plain
                                             : Status::Attention,
                      blocking);
  } else if (m_emulator) {
    m_note->setStatus(Status::Good, tr("Learned and tested. Save it as a preset to use it."));
  } else {
    m_note->setStatus(Status::Plain, tr("Ready to learn. Recordings used to test show how good the "
                                        "emulator is on programs it has not seen."));
  }
}

void EmulatorPage::retranslate() {
  m_recordingsTab.presets->setItemText(m_recordingsTab.presets->count() - 1, tr("File…"));
  m_recordingsTab.curve->setTitles(tr("Error on parts held out, while learning"),
                                   tr("Models tried"), tr("Error, µm"));
  m_comparison.matrix->setTitles(tr("Matrix of errors"), tr("Tested on"),
                                 tr("Learned from (error RMS in µm)"));
  m_comparison.worth->setTitles(tr("Worth of the parameters"),
                                tr("Change of the positions, RMS, µm"));
  m_tabs->setTexts(
      {tr("Recordings"), tr("Parameters"), tr("Tests"), tr("Matrix"), tr("Comparison")},
      tr("Part of the page"));
  m_recordingsTab.model->refresh();
  m_parameters.model->refresh();
  m_tests.model->refresh();
  showCurve();
  showResult();
  refresh();
}

void EmulatorPage::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  const bool isFile =
      std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
  if (isFile && m_add->isEnabled()) {
    event->acceptProposedAction();
  }
}

void EmulatorPage::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) {
      paths.append(url.toLocalFile());
    }
  }
  if (!paths.isEmpty()) {
    forgetNews();
    event->acceptProposedAction();
    Q_EMIT addRequested(paths);
  }
}

}  // namespace rivulet::widgets
