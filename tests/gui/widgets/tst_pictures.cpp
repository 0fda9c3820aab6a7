// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// One picture of every page, in both themes and both languages, in the folder `pictures` of the
// build: for inspection, and checked here for what a program can check.

#include <QComboBox>
#include <QSlider>
#include <QTabBar>
#include <QTest>
#include <functional>
#include <memory>

#include "base/units.h"
#include "gui/widgets/page_test.h"
#include "gui/widgets/samples.h"
#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "widgets/alarms/alarm_line.h"
#include "widgets/alarms/alarm_page.h"
#include "widgets/alarms/alarm_text.h"
#include "widgets/audit/audit_page.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/commissioning/commissioning_page.h"
#include "widgets/common/log_view.h"
#include "widgets/common/theme.h"
#include "widgets/connection/connection_panel.h"
#include "widgets/feasibility/advice_panel.h"
#include "widgets/feasibility/feasibility_page.h"
#include "widgets/program/file_bars.h"
#include "widgets/program/path_view.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/runs/runs_page.h"
#include "widgets/streaming/correction_panel.h"
#include "widgets/streaming/method_panel.h"
#include "widgets/streaming/report_panel.h"
#include "widgets/streaming/run_panel.h"
#include "widgets/templates/template_page.h"
#include "widgets/trace/trace_page.h"
#include "widgets/users/users_page.h"

using namespace rivulet;
using namespace rivulet::widgets;

namespace {

struct Sample {
  QString name;
  QSize size;
  std::function<std::unique_ptr<QWidget>()> make;
};

std::unique_ptr<QWidget> methodPanel(base::MethodKind method, double feedMmPerMin) {
  auto panel = std::make_unique<MethodPanel>();
  streaming::StreamSettings settings;
  settings.parameters.method = method;
  settings.feedMmPerS = base::mmPerSFromMmPerMin(feedMmPerMin);
  panel->setSettings(settings);
  const auto model = test::feasibilityModel(method, feedMmPerMin);
  panel->setVerdict(feasibility::judge(model.operatingPoint, model.distances).value(),
                    std::nullopt);
  return panel;
}

std::unique_ptr<QWidget> runPanel(streaming::RunState state) {
  auto panel = std::make_unique<RunPanel>();
  panel->setTotal(1353);
  if (state == streaming::RunState::Idle) {
    panel->setStartBlocked(QStringLiteral("N = 20, MD28050"));
    return panel;
  }
  streaming::LiveUpdate update;
  update.state = state;
  update.counters = {412, 409, 405, 1353};
  update.margin = std::chrono::microseconds{12'400};
  if (state == streaming::RunState::Aborted) {
    update.stopConfirmedAfter = std::chrono::milliseconds{830};
  }
  panel->setUpdate(update);
  return panel;
}

/// @param live  nothing: by hand
std::unique_ptr<QWidget> correctionPanel(const std::optional<LiveSourceView>& live) {
  auto panel = std::make_unique<CorrectionPanel>();
  panel->setLimit(0.1, {true, true, true});
  panel->setRunning(true);
  panel->setCorrection(streaming::Correction{{0.012, -0.1, 0.03}, {0.012, -0.085, 0.03}});
  if (live) {
    panel->findChild<QComboBox*>()->setCurrentIndex(1);
    panel->setLiveSource(*live);
  } else {
    const auto sliders = panel->findChildren<QSlider*>();
    sliders.at(0)->setValue(12);
    sliders.at(1)->setValue(-100);
    sliders.at(2)->setValue(30);
  }
  return panel;
}

std::unique_ptr<QWidget> feasibilityPage(base::MethodKind method, feasibility::SweepAxis axis,
                                         double feedMmPerMin) {
  auto page = std::make_unique<FeasibilityPage>();
  page->setModel(test::feasibilityModel(method, feedMmPerMin));
  page->showChart(axis);
  return page;
}

/// With the feeds of the program: rapids of 40 m/min, at 60 %.
std::unique_ptr<QWidget> overridePage(feasibility::SweepAxis axis) {
  auto page = std::make_unique<FeasibilityPage>();
  const double fullMmPerS = base::mmPerSFromMmPerMin(40000.0);
  auto model = test::feasibilityModel(base::MethodKind::Window, 24000.0);
  model.scale.fullFeedMmPerS = fullMmPerS;
  model.distances.pointDistanceMmMin *= 60.0;
  model.distances.windowLengthMmMin *= 60.0;
  for (double& distanceMm : model.smallestDistancesMm) {
    distanceMm *= 60.0;
  }
  model.limitedBy = overrideLimitText({0.83, {214}, base::mmPerSFromMmPerMin(2000.0), 0.3, false});
  model.verdict = feasibility::judge(model.operatingPoint, model.distances).value();
  page->setModel(model);
  page->showChart(axis);
  feasibility::Advice advice;
  advice.kind = feasibility::AdviceKind::PointsPerLoop;
  advice.before = advice.after = model.operatingPoint;
  advice.after.pointsPerLoop = 9;
  advice.feedMmPerSMaxBefore = 0.83 * fullMmPerS;
  advice.feedMmPerSMaxAfter = 1.09 * fullMmPerS;
  page->advice()->setAdvice({advice});
  return page;
}

std::unique_ptr<QWidget> simulatedPage(base::MethodKind method, feasibility::SweepAxis axis,
                                       double feedMmPerMin) {
  auto page = std::make_unique<FeasibilityPage>();
  const auto model = test::feasibilityModel(method, feedMmPerMin);
  page->setModel(model);
  page->showChart(axis);
  const auto wanted = page->chart(axis)->simulationWanted();
  page->setRegion(test::simulatedRegion(model, wanted, 1.3 * feedMmPerMin));
  page->advice()->setAdvice(test::advice(model));
  return page;
}

std::unique_ptr<QWidget> simulatingPage() {
  auto page = std::make_unique<FeasibilityPage>();
  page->setModel(test::feasibilityModel(base::MethodKind::Position, 100.0));
  page->setSimulationProgress(42);
  return page;
}

std::unique_ptr<QWidget> commissioningPage(bool passed) {
  auto page = std::make_unique<CommissioningPage>(creditTestTexts());
  page->setTest(shownTest(test::creditTest(passed)), false);
  return page;
}

std::unique_ptr<QWidget> runsPage() {
  auto page = std::make_unique<RunsPage>();
  const auto runs = test::pastRuns();
  page->setRuns(runs, {});
  page->setDetail(runs.front().id, test::report());
  page->setBounds({1000, 4});
  return page;
}

std::unique_ptr<QWidget> pathView(PathCanvas::View from) {
  auto view = std::make_unique<PathView>();
  const auto program = test::viewOf(test::pocket());
  view->setProgram(program);
  const auto& points = program->points.points;
  view->setExecuted(700);
  view->setToolPosition(points[700].positionMm);
  view->setView(from);
  return view;
}

std::unique_ptr<QWidget> programPanel(const std::shared_ptr<const gcode::Program>& program) {
  auto panel = std::make_unique<ProgramPanel>();
  const auto view = test::viewOf(program);
  panel->setRecentFiles({QStringLiteral("/data/a.mpf")});
  panel->setProgram(view);
  panel->setReading(std::nullopt, program->isStreamable() ? std::vector<std::string>{}
                                                          : std::vector<std::string>{"G41"});
  panel->setDistances(view->distances);
  panel->setTimes(test::timesOf(*view));
  return panel;
}

std::unique_ptr<QWidget> programPage(const std::shared_ptr<const gcode::Program>& program,
                                     overview::PathColouring colouring) {
  auto page = std::make_unique<ProgramPage>();
  const auto view = test::viewOf(program);
  page->setProgram(view);
  page->setTimes(test::timesOf(*view));
  page->panel()->setDistances(view->distances);
  page->path()->setOperatingPoint(
      test::feasibilityModel(base::MethodKind::Signal, 1500.0).operatingPoint);
  page->path()->setColouring(colouring);
  page->showLine(program->isStreamable() ? 700 : 3);
  return page;
}

std::unique_ptr<QWidget> jobPage() {
  auto page = std::make_unique<ProgramPage>();
  const auto view = test::jobView();
  page->setProgram(view);
  page->setExecuted(view->stretchStarts[1] + 2);
  page->panel()->setDistances(view->distances);
  return page;
}

std::unique_ptr<QWidget> fileBanner(FileBanner::State state, bool running) {
  auto banner = std::make_unique<FileBanner>();
  banner->setProgram(QStringLiteral("POCKET_60x40.MPF"), QStringLiteral("0123456789abcdef"));
  banner->setRunning(running);
  banner->setState(state);
  return banner;
}

std::unique_ptr<QWidget> loadBar() {
  auto bar = std::make_unique<LoadBar>();
  bar->setProgress(0.42, QStringLiteral("SURFACE.MPF"));
  return bar;
}

std::unique_ptr<QWidget> connectionPanel(ConnectionState state) {
  auto panel = std::make_unique<ConnectionPanel>();
  panel->setConnectionState(state);
  MachineView machine = test::runningMachine();
  if (state == ConnectionState::Lost) {
    machine.alarmNumber = 10'870;
    machine.channelStatus = 2;
  }
  panel->setMachineState(machine);
  return panel;
}

std::unique_ptr<QWidget> tracePage(bool control) {
  auto page = std::make_unique<TracePage>();
  const auto trace = test::controlTrace(0.9);
  if (control) {
    page->showTraces({test::shownTrace(*trace)}, TracePage::Source::Control);
    return page;
  }
  for (std::size_t index = 0; index < trace->samples.size(); index += 12) {
    const auto& sample = trace->samples[index];
    page->append({base::toSeconds(sample.at) - 1.0, sample.actualMm, sample.feedMmPerS});
  }
  int count = 0;
  for (trace::Pause pause : test::pausesOf(*trace)) {
    pause.start -= std::chrono::seconds{1};
    pause.origin = static_cast<trace::PauseOrigin>(count++ % 3);
    page->addPause(pause);
  }
  return page;
}

std::unique_ptr<QWidget> templatePage() {
  auto page = std::make_unique<TemplatePage>();
  page->setTemplate(*templates::makeProgram({}));
  return page;
}

enum class Calibrated { Never, Now, Outdated, Busy, Spread };

std::unique_ptr<QWidget> calibrationPage(Calibrated state) {
  auto page = std::make_unique<CalibrationPage>();
  if (state != Calibrated::Never) {
    page->setRecord(test::calibrationRecord(), state == Calibrated::Outdated);
  }
  if (state == Calibrated::Outdated) {
    page->setBlocked(QStringLiteral("R50: MD28050"));
  } else if (state == Calibrated::Busy) {
    streaming::CalibrationProgress progress;
    progress.phase = streaming::CalibrationProgress::Phase::Shots;
    progress.share = 0.37;
    progress.left = std::chrono::seconds{341};
    progress.shotsMade = 5231;
    progress.shotsPlanned = 14'200;
    page->setProgress(progress);
  } else if (state == Calibrated::Spread) {
    page->showSpread(3);
  }
  return page;
}

std::unique_ptr<QWidget> calibratedRegion() {
  auto page = std::make_unique<FeasibilityPage>();
  FeasibilityModel model = test::feasibilityModel(base::MethodKind::Window, 1500.0);
  model.source = {test::calibrationRecord(), false, opcua::Grouping::ArrayCount, 24};
  model.access.measured = feasibility::MeasuredAccess{{std::chrono::microseconds{5150}, {}},
                                                      {std::chrono::microseconds{5600}, {}}};
  page->setModel(model);
  return page;
}

std::unique_ptr<QWidget> logView() {
  auto view = std::make_unique<LogView>();
  const QDateTime at(QDate(2026, 3, 4), QTime(9, 15, 2, 125));
  view->append({at, gcode::Severity::Note, alarm::Source::Connection,
                [] { return QStringLiteral("Connected to opc.tcp://127.0.0.1:4840"); }});
  view->append({at.addMSecs(310), gcode::Severity::Warning, alarm::Source::Run,
                [] { return QStringLiteral("Access time 12 ms"); }});
  view->append({at.addMSecs(5210), gcode::Severity::Error, alarm::Source::Control,
                [] { return alarmText(test::alarms().front()); }});
  return view;
}

std::unique_ptr<QWidget> alarmLine(std::size_t index) {
  auto line = std::make_unique<AlarmLine>();
  line->setAlarm(test::alarms()[index], test::alarms().size());
  return line;
}

std::unique_ptr<QWidget> auditPage(std::size_t firstChange) {
  auto page = std::make_unique<AuditPage>();
  AuditView view;
  const auto add = [&view](const char* who, const char* role, const char* act,
                           const char* details) {
    const std::size_t line = view.rows.size() + 1;
    view.rows.push_back({line, 1'795'336'205'000 + static_cast<base::UtcMs>(line) * 61'000,
                         QString::fromUtf8(who), QString::fromUtf8(role), QString::fromUtf8(act),
                         QString::fromUtf8(details), false});
  };
  add("anna", "engineer", "log-in", "");
  add("anna", "engineer", "open-program", "program=POCKET_60x40.MPF; hash=6f1c0a9be2d4c3a1");
  add("anna", "engineer", "change-settings", "feed=829 -> 1090; points=7 -> 9");
  add("anna", "engineer", "release", "program=POCKET_60x40.MPF; hash=6f1c0a9be2d4c3a1");
  add("otto", "operator", "start", "program=POCKET_60x40.MPF; first_point=1");
  add("otto", "operator", "stop", "point=412");
  view.firstChange = firstChange;
  if (firstChange > 0) {
    view.rows[firstChange - 1].isSuspect = true;
  }
  view.lastHash = QString(64, QLatin1Char('a'));
  view.file = QStringLiteral("audit.jsonl");
  page->setAudit(view);
  return page;
}

UsersView usersView() {
  UsersView view;
  view.users = {{"anna", permission::Role::Engineer, true},
                {"otto", permission::Role::Operator, true},
                {"cell", permission::Role::Operator, false}};
  view.current = "anna";
  view.idleMinutes = 15;
  view.systemUser = "cell";
  return view;
}

std::unique_ptr<QWidget> usersPage(const UsersView& view) {
  auto page = std::make_unique<UsersPage>();
  page->setUsers(view, true);
  return page;
}

std::unique_ptr<QWidget> logIn() {
  auto dialog = std::make_unique<LogInDialog>(usersView());
  dialog->showFailure(30);
  return dialog;
}

std::unique_ptr<QWidget> alarmPage(bool history) {
  auto page = std::make_unique<AlarmPage>();
  page->setAlarms(test::alarms());
  std::vector<alarm::Transition> transitions;
  for (const alarm::Alarm& alarm : test::alarms()) {
    transitions.push_back({alarm.raisedAt + 65'000, alarm::Event::Acknowledged, alarm, "anna"});
    transitions.push_back({alarm.raisedAt, alarm::Event::Raised, alarm, {}});
  }
  page->setHistory(transitions);
  page->findChild<QTabBar*>()->setCurrentIndex(history ? 1 : 0);
  return page;
}

std::unique_ptr<QWidget> reportPanel(bool faulty) {
  auto panel = std::make_unique<ReportPanel>();
  streaming::RunReport report = test::report();
  if (faulty) {
    report.outcome = streaming::Outcome::Stopped;
    report.integrity.repeated = 14;
    report.integrity.skipped = 2;
    report.stopConfirmedAfter = std::chrono::milliseconds{830};
  }
  panel->setReport(report);
  return panel;
}

std::vector<Sample> samples() {
  using base::MethodKind;
  using feasibility::SweepAxis;
  using streaming::RunState;
  return {
      {"connection", {360, 560}, [] { return connectionPanel(ConnectionState::Connected); }},
      {"connection_lost", {360, 560}, [] { return connectionPanel(ConnectionState::Lost); }},
      {"program_page_kind",
       {760, 640},
       [] { return programPage(test::pocket(), overview::PathColouring::Kind); }},
      {"program_page_job", {760, 640}, [] { return jobPage(); }},
      {"program_page_feed",
       {760, 640},
       [] { return programPage(test::pocket(), overview::PathColouring::Feed); }},
      {"program_page_margin",
       {760, 640},
       [] { return programPage(test::pocket(), overview::PathColouring::Margin); }},
      {"program_page_time",
       {760, 640},
       [] { return programPage(test::pocket(), overview::PathColouring::Time); }},
      {"program_page_broken",
       {760, 640},
       [] { return programPage(test::brokenProgram(), overview::PathColouring::Kind); }},
      {"file_changed", {800, 56}, [] { return fileBanner(FileBanner::State::Changed, false); }},
      {"file_changed_running",
       {800, 56},
       [] { return fileBanner(FileBanner::State::Changed, true); }},
      {"file_gone", {800, 56}, [] { return fileBanner(FileBanner::State::Gone, false); }},
      {"loading", {800, 56}, [] { return loadBar(); }},
      {"program", {420, 700}, [] { return programPanel(test::pocket()); }},
      {"program_broken", {420, 700}, [] { return programPanel(test::brokenProgram()); }},
      {"path_space", {640, 520}, [] { return pathView(PathCanvas::View::Space); }},
      {"path_top", {640, 520}, [] { return pathView(PathCanvas::View::Top); }},
      {"path_front", {640, 520}, [] { return pathView(PathCanvas::View::Front); }},
      {"method_feasible", {380, 560}, [] { return methodPanel(MethodKind::Position, 60.0); }},
      {"method_infeasible", {380, 560}, [] { return methodPanel(MethodKind::Signal, 4000.0); }},
      {"correction_hand", {360, 420}, [] { return correctionPanel(std::nullopt); }},
      {"correction_live",
       {360, 520},
       [] {
         return correctionPanel(LiveSourceView{true, true, false, 0});
       }},
      {"correction_silent",
       {360, 520},
       [] {
         return correctionPanel(LiveSourceView{true, true, true, 0});
       }},
      {"run_idle", {1000, 110}, [] { return runPanel(RunState::Idle); }},
      {"run_running", {1280, 110}, [] { return runPanel(RunState::Running); }},
      {"run_aborted", {512, 180}, [] { return runPanel(RunState::Aborted); }},
      {"feasibility_distance",
       {900, 600},
       [] { return feasibilityPage(MethodKind::Position, SweepAxis::PointDistance, 100.0); }},
      {"feasibility_points",
       {900, 600},
       [] { return feasibilityPage(MethodKind::Signal, SweepAxis::PointsPerLoop, 300.0); }},
      {"feasibility_delta",
       {900, 600},
       [] { return feasibilityPage(MethodKind::Position, SweepAxis::Delta, 100.0); }},
      {"feasibility_simulated_points",
       {900, 600},
       [] { return simulatedPage(MethodKind::Signal, SweepAxis::PointsPerLoop, 300.0); }},
      {"feasibility_simulated_delta",
       {900, 600},
       [] { return simulatedPage(MethodKind::Position, SweepAxis::Delta, 100.0); }},
      {"feasibility_override", {900, 600}, [] { return overridePage(SweepAxis::PointDistance); }},
      {"feasibility_override_points",
       {900, 600},
       [] { return overridePage(SweepAxis::PointsPerLoop); }},
      {"feasibility_simulating", {900, 600}, [] { return simulatingPage(); }},
      {"trace_live", {1000, 640}, [] { return tracePage(false); }},
      {"trace_control", {1000, 640}, [] { return tracePage(true); }},
      {"template", {900, 560}, [] { return templatePage(); }},
      {"calibration_never", {780, 640}, [] { return calibrationPage(Calibrated::Never); }},
      {"calibration_lines", {780, 640}, [] { return calibrationPage(Calibrated::Now); }},
      {"calibration_spread", {780, 640}, [] { return calibrationPage(Calibrated::Spread); }},
      {"calibration_busy", {780, 640}, [] { return calibrationPage(Calibrated::Busy); }},
      {"calibration_outdated", {780, 640}, [] { return calibrationPage(Calibrated::Outdated); }},
      {"feasibility_calibrated", {900, 600}, [] { return calibratedRegion(); }},
      {"report", {700, 520}, [] { return reportPanel(false); }},
      {"report_faulty", {700, 520}, [] { return reportPanel(true); }},
      {"log", {960, 300}, [] { return logView(); }},
      {"alarm_line", {860, 48}, [] { return alarmLine(0); }},
      {"alarm_line_medium", {860, 48}, [] { return alarmLine(3); }},
      {"alarms", {960, 560}, [] { return alarmPage(false); }},
      {"alarms_none", {960, 400}, [] { return std::make_unique<AlarmPage>(); }},
      {"audit", {1000, 420}, [] { return auditPage(0); }},
      {"audit_changed", {1000, 420}, [] { return auditPage(3); }},
      {"users", {900, 460}, [] { return usersPage(usersView()); }},
      {"users_none", {900, 400}, [] { return usersPage({}); }},
      {"log_in", {300, 480}, [] { return logIn(); }},
      {"alarms_history", {960, 400}, [] { return alarmPage(true); }},
      {"credit_test_passed", {780, 640}, [] { return commissioningPage(true); }},
      {"credit_test_failed", {780, 640}, [] { return commissioningPage(false); }},
      {"runs_800", {800, 620}, [] { return runsPage(); }},
      {"runs_1400", {1400, 760}, [] { return runsPage(); }},
  };
}

}  // namespace

class TestPictures : public QObject {
  Q_OBJECT

 private slots:
  void init() { test::failOnWarnings(); }

  void pages_data() {
    QTest::addColumn<int>("sample");
    QTest::addColumn<bool>("dark");
    QTest::addColumn<bool>("german");
    const auto all = samples();
    for (std::size_t index = 0; index < all.size(); ++index) {
      for (const bool dark : {false, true}) {
        for (const bool german : {false, true}) {
          QTest::addRow("%s_%s_%s", qPrintable(all[index].name), dark ? "dark" : "light",
                        german ? "de" : "en")
              << static_cast<int>(index) << dark << german;
        }
      }
    }
  }
  void pages() {
    QFETCH(int, sample);
    QFETCH(bool, dark);
    QFETCH(bool, german);
    test::Language language;
    applyTheme(Theme::Light);
    const auto all = samples();
    const Sample& one = all[static_cast<std::size_t>(sample)];
    const std::unique_ptr<QWidget> page = one.make();
    // Theme and language change while the page is there, as in the application.
    if (dark) {
      applyTheme(Theme::Dark);
    }
    if (german) {
      language.german();
    }
    const QImage picture = test::picture(*page, one.size);
    test::keep(picture, QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(test::colourCount(picture) >= 20);
    const QStringList cut = test::cutTexts(*page);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(" | ")));
    // The page is as dark as its theme: no part stayed behind in the other.
    const QColor window = themePalette(dark ? Theme::Dark : Theme::Light).color(QPalette::Window);
    const QColor average =
        picture.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).pixelColor(0, 0);
    QVERIFY(std::abs(average.lightness() - window.lightness()) < 60);
  }
};

RIVULET_TEST(TestPictures)
#include "tst_pictures.moc"
