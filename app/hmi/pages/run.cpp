// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Parts that set a run up and drive it: method, online correction, resuming, start and stop.

#include <QCoreApplication>
#include <QInputDialog>
#include <algorithm>
#include <functional>

#include "base/units.h"
#include "base/vec3.h"
#include "hmi/alarms.h"
#include "hmi/document.h"
#include "hmi/found_runs.h"
#include "hmi/machine_model.h"
#include "hmi/pages/pages.h"
#include "hmi/preflight.h"
#include "hmi/run_controller.h"
#include "session/correction_feed.h"
#include "widgets/calibration/calibration_page.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/common/sheet_area.h"
#include "widgets/program/program_page.h"
#include "widgets/program/program_panel.h"
#include "widgets/setup/profile_page.h"
#include "widgets/streaming/back_dialog.h"
#include "widgets/streaming/correction_panel.h"
#include "widgets/streaming/factor_panel.h"
#include "widgets/streaming/found_run_bar.h"
#include "widgets/streaming/method_panel.h"
#include "widgets/streaming/preflight_sheet.h"
#include "widgets/streaming/run_panel.h"
#include "widgets/streaming/wrong_motion_bar.h"

namespace rivulet::hmi {

using session::CorrectionFeed;
using widgets::CorrectionPanel;
using widgets::FactorPanel;
using widgets::FoundRunBar;
using widgets::MethodPanel;
using widgets::PreflightSheet;
using widgets::ResumeBar;
using widgets::RunPanel;
using widgets::WrongMotionBar;

namespace {

struct RunTexts {
  Q_DECLARE_TR_FUNCTIONS(RunTexts)

 public:
  /// Why there is no verdict; nothing: there is one.
  static std::optional<QString> problem(const Document& document) {
    const Findings& findings = document.findings();
    if (findings.settingsError) {
      return widgets::errorText(*findings.settingsError);
    }
    if (!document.view()) {
      return tr("No program is loaded.");
    }
    if (document.live()) {
      return tr("A live source needs no verdict: the machine waits for points that are late.");
    }
    if (!document.program()->isStreamable()) {
      return widgets::blockedText(streaming::programBlocked(*document.program()));
    }
    if (findings.isBeingMeasured) {
      return tr("The path is being measured.");
    }
    return findings.verdict ? std::nullopt
                            : std::optional(tr("The program has fewer than two points."));
  }
  /// Why a program with blocks for the control can only be run without them; empty: it need not.
  static QString obstacle(const Document& document) {
    const auto obstacle = document.jobObstacle();
    if (!obstacle) {
      return {};
    }
    switch (*obstacle) {
      case Document::JobObstacle::Machine:
        return tr("Whole jobs have not been tested on this machine: Configure, Job test.");
      case Document::JobObstacle::Method:
        return tr("Whole jobs need method window or credit.");
      case Document::JobObstacle::Correction:
        return tr("A whole job cannot be corrected online.");
      case Document::JobObstacle::NotWhole:
        return document.view()->plan->refusals.empty()
                   ? tr("Parts of the program are not known: see the findings.")
                   : tr("%1 (line %2) cannot be given to the control.")
                         .arg(QString::fromStdString(
                                  document.view()->plan->refusals.front().argument),
                              widgets::countText(
                                  document.view()->plan->refusals.front().line.value));
    }
    return {};
  }
  static QString fromStretchTitle() { return tr("Begin with a part"); }
  static QString fromStretch(int stretches) {
    return tr("Part (1 to %1). What the machine needs there is listed before anything moves.")
        .arg(stretches);
  }
  static QString straightTitle() { return tr("Straight way to the first point"); }
  //: What the operator types; a translation may be any one word.
  static QString clearWord() { return tr("CLEAR"); }
  static QString straight() {
    return tr("The tool goes straight through the space in which the program cuts. Look whether "
              "anything is in its way: workpiece, clamps. If nothing is, type %1.")
        .arg(clearWord());
  }
  static QString repeatsTitle() { return tr("Method that may repeat points"); }
  //: What the operator types, word by word.
  static QString repeatsWords() { return tr("this may execute old points again"); }
  static QString repeats() {
    return tr("This method of the publication knows no numbered windows. If this computer is late, "
              "the control executes old points again. To start all the same, type:\n%1")
        .arg(repeatsWords());
  }
  static QString title(const Document& document, bool isRunning) {
    const gcode::Program& program = *document.program();
    if (document.live()) {
      return tr("Live points from %1").arg(QString::fromStdString(program.name));
    }
    return (isRunning ? tr("Running: %1, version %2") : tr("Program: %1, version %2"))
        .arg(QString::fromStdString(program.name), QString::fromStdString(program.hash));
  }
};

/// What a click confirms too easily is typed. @param words  whether in capitals or not
void askForWords(QWidget* page, const QString& title, const QString& question, const QString& words,
                 const std::function<void()>& confirmed) {
  auto* dialog = new QInputDialog;
  dialog->setInputMode(QInputDialog::TextInput);
  dialog->setWindowTitle(title);
  dialog->setLabelText(question);
  QObject::connect(dialog, &QInputDialog::textValueSelected, page,
                   [words, confirmed](const QString& typed) {
                     if (typed.simplified().compare(words, Qt::CaseInsensitive) == 0) {
                       confirmed();
                     }
                   });
  widgets::openSheet(dialog, page);
}

/// Numbers of the alarms of wrong motion that nobody has acknowledged.
std::vector<int> openWrongMotion(const Alarms& alarms) {
  std::vector<int> numbers;
  for (const alarm::Alarm& item : alarms.list().alarms()) {
    const bool isWrongMotion =
        item.code == alarm::Code::WrongMotion || item.code == alarm::Code::MovesWrong;
    if (isWrongMotion && !item.isAcknowledged) {
      numbers.push_back(item.number);
    }
  }
  return numbers;
}

/// The way from the last point that is known to be executed to the last one that the control has.
std::optional<widgets::MotionLeft> motionLeft(const Document& document,
                                              const streaming::Counters& counters) {
  const auto& points = document.points();
  const auto now = document.timeLeft(counters.executed);
  const auto then = document.timeLeft(counters.accepted);
  if (!now || !then || counters.accepted > points.size() || counters.accepted < counters.executed) {
    return std::nullopt;
  }
  widgets::MotionLeft left{0.0, now->totalS - then->totalS};
  for (std::size_t i = std::max<std::size_t>(counters.executed, 1); i < counters.accepted; ++i) {
    left.lengthMm += base::distance(points[i - 1].positionMm, points[i].positionMm);
  }
  return left;
}

widgets::RunProgress progressOf(const Document& document, const RunController& runs) {
  const streaming::LiveUpdate& update = runs.update();
  widgets::RunProgress progress;
  if (!document.view()) {
    return progress;
  }
  progress.isLive = document.live().has_value();
  progress.lines = progress.isLive ? 0 : document.view()->text.lines();
  const auto& points = document.points();
  progress.passed = runs.passed();
  progress.line = runs.runLine();
  if (progress.line == 0 && progress.passed > 0 && progress.passed <= points.size()) {
    progress.line = points[progress.passed - 1].line.value;
  }
  progress.left = document.timeLeft(progress.passed, runs.nativeLine());
  if (update.state == streaming::RunState::Stopping) {
    progress.delivered = motionLeft(document, update.counters);
  }
  return progress;
}

std::optional<widgets::JobProgress> jobProgress(const RunController& runs,
                                                const Document& document) {
  if (!runs.job() || document.outline() == nullptr) {
    return std::nullopt;
  }
  const session::JobUpdate& job = *runs.job();
  return widgets::JobProgress{static_cast<std::size_t>(job.stretch),
                              document.outline()->stretches(),
                              job.isNative,
                              job.line.value,
                              QString::fromStdString(job.block),
                              job.waitsForCycleStart,
                              document.dryRunMm() > 0.0};
}

void connectFeed(CorrectionPanel* panel, RunController* runs) {
  auto* feed = new CorrectionFeed(panel);
  QObject::connect(panel, &CorrectionPanel::inputChanged, feed,
                   [feed](const widgets::CorrectionInput& input) {
                     constexpr double kMsOfSecond = 1000.0;
                     if (input.isLive) {
                       feed->open(static_cast<quint16>(input.port),
                                  static_cast<int>(input.silenceS * kMsOfSecond));
                     } else {
                       feed->close();
                     }
                   });
  QObject::connect(feed, &CorrectionFeed::valueArrived, runs, &RunController::correct);
  QObject::connect(
      feed, &CorrectionFeed::stateChanged, panel, [panel](const session::FeedState& state) {
        panel->setLiveSource({state.isOpen, state.hasValue, state.isSilent, state.unknown});
      });
  QObject::connect(runs, &RunController::started, feed, &CorrectionFeed::forget);
}

/// What holding Start would do, and how soon Stop acts then.
void followPreflight(RunPanel* panel, const Preflight& preflight) {
  panel->setPreflightPassed(preflight.hasPassed() && !preflight.isForResume());
  if (preflight.isOpen()) {
    panel->setStopWithin(preflight.stopSeconds());
  }
}

}  // namespace

QWidget* makeMethodPanel(Document* document, RunController* runs) {
  auto* panel = new MethodPanel;
  panel->setFeedMax(document->feedMmPerSMax());
  panel->setSettings(document->settings());
  QObject::connect(panel, &MethodPanel::settingsChanged, document, &Document::editSettings);
  QObject::connect(document, &Document::settingsChanged, panel,
                   [panel, document] { panel->setSettings(document->settings()); });
  QObject::connect(panel, &MethodPanel::jobChosen, document, &Document::chooseJob);
  QObject::connect(document, &Document::judged, panel, [panel, document] {
    panel->setLive(document->live().has_value());
    panel->setJob(document->outline() != nullptr, document->isJob(), RunTexts::obstacle(*document));
    panel->setOverrideLimit(document->findings().overrideLimit,
                            document->view() ? document->view()->fastestMmPerS : 0.0);
    panel->setRehearsal(rehearsalView(document->findings()));
    panel->setVerdict(document->findings().verdict, RunTexts::problem(*document));
  });
  QObject::connect(document, &Document::pausesChanged, panel,
                   [panel, document] { panel->setPauses(document->pauseSummary()); });
  QObject::connect(runs, &RunController::permissionsChanged, panel,
                   [panel, runs] { panel->setEditable(runs->canChangeSettings()); });
  return panel;
}

QWidget* makeCorrectionPanel(Document* document, RunController* runs) {
  auto* panel = new CorrectionPanel;
  connectFeed(panel, runs);
  QObject::connect(document, &Document::judged, panel, [panel, document] {
    const auto& flexible = document->findings().flexible;
    const templates::TemplateParameters& parameters = document->settings().parameters;
    panel->setLimit(flexible && flexible->cells.corrects() ? parameters.correctionLimitMm : 0.0,
                    parameters.axes);
  });
  QObject::connect(panel, &CorrectionPanel::correctionRequested, runs, &RunController::correct);
  QObject::connect(runs, &RunController::started, panel, [panel] { panel->setRunning(true); });
  QObject::connect(runs, &RunController::finished, panel, [panel] { panel->setRunning(false); });
  QObject::connect(
      runs, &RunController::updated, panel,
      [panel](const streaming::LiveUpdate& update) { panel->setCorrection(update.correction); });
  return panel;
}

QWidget* makeFactorPanel(Document* document, RunController* runs) {
  auto* panel = new FactorPanel;
  const auto show = [panel, document] {
    const streaming::StreamSettings& settings = document->settings();
    panel->setChoice(
        {settings.factor, settings.parameters.factorLeast, settings.parameters.factorMost});
  };
  show();
  QObject::connect(document, &Document::settingsChanged, panel, show);
  QObject::connect(panel, &FactorPanel::choiceChanged, document,
                   [document](const widgets::FactorChoice& choice) {
                     streaming::StreamSettings settings = document->settings();
                     settings.factor = choice.source;
                     settings.parameters.factorLeast = choice.least;
                     settings.parameters.factorMost = choice.most;
                     document->setSettings(settings);
                   });
  QObject::connect(runs, &RunController::permissionsChanged, panel,
                   [panel, runs] { panel->setEditable(runs->canChangeSettings()); });
  QObject::connect(runs, &RunController::updated, panel,
                   [panel](const streaming::LiveUpdate& update) { panel->setFeed(update.feed); });
  QObject::connect(runs, &RunController::finished, panel,
                   [panel] { panel->setFeed(std::nullopt); });
  return panel;
}

QWidget* makeWrongMotionBar(Alarms* alarms, RunController* runs, QWidget* parent) {
  auto* bar = new WrongMotionBar(parent);
  QObject::connect(runs, &RunController::wrongMotionChanged, bar,
                   [bar, runs] { bar->setWrong(runs->wrongMotion(), runs->isRunning()); });
  QObject::connect(bar, &WrongMotionBar::stopRequested, runs, &RunController::stop);
  QObject::connect(bar, &WrongMotionBar::acknowledged, alarms, [alarms, runs] {
    for (const int number : openWrongMotion(*alarms)) {
      alarms->acknowledge(number);
    }
    runs->acknowledgeWrongMotion();
  });
  // In the list of alarms it is acknowledged as well.
  QObject::connect(alarms, &Alarms::changed, runs, [alarms, runs] {
    if (openWrongMotion(*alarms).empty()) {
      runs->acknowledgeWrongMotion();
    }
  });
  return bar;
}

QWidget* makeFoundRunBar(RunController* runs, FoundRuns* found, QWidget* parent) {
  auto* bar = new FoundRunBar(parent);
  const auto show = [bar, found, runs] {
    const auto view = found->view();
    // While it is being resumed, the bar for that says the rest.
    const bool isBeingResumed = view && !view->isOnControl() && runs->place();
    bar->setRun(isBeingResumed ? std::nullopt : view);
  };
  QObject::connect(found, &FoundRuns::changed, bar, show);
  QObject::connect(runs, &RunController::permissionsChanged, bar, show);
  QObject::connect(bar, &FoundRunBar::watchRequested, found, &FoundRuns::watch);
  QObject::connect(bar, &FoundRunBar::stopRequested, found, &FoundRuns::stop);
  QObject::connect(bar, &FoundRunBar::endRequested, found, &FoundRuns::end);
  QObject::connect(bar, &FoundRunBar::resumeRequested, found, &FoundRuns::resume);
  QObject::connect(bar, &FoundRunBar::dismissed, found, &FoundRuns::dismiss);
  return bar;
}

QWidget* makeResumeBar(RunController* runs, Preflight* preflight, QWidget* parent) {
  auto* bar = new ResumeBar(parent);
  QObject::connect(runs, &RunController::resumeAsked, bar, &ResumeBar::showAsking);
  QObject::connect(runs, &RunController::placeFound, bar, &ResumeBar::showPlace);
  QObject::connect(runs, &RunController::resumeRefused, bar, &ResumeBar::showRefusal);
  QObject::connect(runs, &RunController::resumeForgotten, bar, &ResumeBar::showNothing);
  QObject::connect(bar, &ResumeBar::goOnRequested, runs, &RunController::resume);
  QObject::connect(bar, &ResumeBar::dismissed, runs, &RunController::forgetResume);
  QObject::connect(preflight, &Preflight::changed, bar, [bar, preflight] {
    if (preflight->back()) {
      bar->showNothing();  // what is held now is Start
    }
  });
  return bar;
}

QWidget* makePreflightSheet(RunController* runs, Preflight* preflight, QWidget* parent) {
  auto* sheet = new PreflightSheet(parent);
  const auto show = [sheet, preflight] {
    sheet->setFirstMove(preflight->firstMove());
    if (preflight->isOpen()) {
      sheet->setItems(preflight->items(), preflight->hasPassed(),
                      preflight->isForChosenLine() ? PreflightSheet::Kind::StartHere
                      : preflight->isForResume()   ? PreflightSheet::Kind::Resume
                      : preflight->back()          ? PreflightSheet::Kind::Back
                      : preflight->raise()         ? PreflightSheet::Kind::Raise
                                                   : PreflightSheet::Kind::Start);
    }
  };
  QObject::connect(preflight, &Preflight::changed, sheet, show);
  QObject::connect(sheet, &PreflightSheet::closeRequested, preflight, &Preflight::dismiss);
  QObject::connect(sheet, &PreflightSheet::remedyRequested, preflight, &Preflight::remedy);
  QObject::connect(preflight, &Preflight::stretchRequested, sheet, [sheet, runs](int stretches) {
    auto* question = new QInputDialog;
    question->setInputMode(QInputDialog::IntInput);
    question->setWindowTitle(RunTexts::fromStretchTitle());
    question->setLabelText(RunTexts::fromStretch(stretches));
    question->setIntRange(1, stretches);
    QObject::connect(question, &QInputDialog::intValueSelected, runs,
                     &RunController::askFromStretch);
    widgets::openSheet(question, sheet);
  });
  QObject::connect(preflight, &Preflight::backRequested, sheet,
                   [sheet, preflight](double feedMmPerMin, double feedMmPerMinMax) {
                     auto* question = new widgets::BackDialog(feedMmPerMin, feedMmPerMinMax);
                     QObject::connect(
                         question, &widgets::BackDialog::chosen, preflight,
                         [preflight](double lengthMm, double chosenMmPerMin) {
                           preflight->setBack(
                               {lengthMm > 0.0 ? std::optional(lengthMm) : std::nullopt},
                               base::mmPerSFromMmPerMin(chosenMmPerMin));
                         });
                     widgets::openSheet(question, sheet);
                   });
  QObject::connect(preflight, &Preflight::straightRequested, sheet, [sheet, preflight] {
    askForWords(sheet, RunTexts::straightTitle(), RunTexts::straight(), RunTexts::clearWord(),
                [preflight] { preflight->confirmFirstMove(); });
  });
  QObject::connect(preflight, &Preflight::repeatsRequested, sheet, [sheet, preflight] {
    askForWords(sheet, RunTexts::repeatsTitle(), RunTexts::repeats(), RunTexts::repeatsWords(),
                [preflight] { preflight->confirmRepeats(); });
  });
  QObject::connect(preflight, &Preflight::liveRequested, sheet, [sheet] {
    if (auto* page = sheet->window()->findChild<widgets::ProgramPage*>()) {
      Q_EMIT page->panel()->liveRequested();
    }
  });
  QObject::connect(preflight, &Preflight::calibrationRequested, sheet, [sheet] {
    if (auto* page = sheet->window()->findChild<widgets::CalibrationPage*>()) {
      showPageOf(page);
    }
  });
  QObject::connect(preflight, &Preflight::limitsRequested, sheet, [sheet] {
    if (auto* page = sheet->window()->findChild<widgets::ProfilePage*>()) {
      showPageOf(page);
    }
  });
  return sheet;
}

QWidget* makeRunPanel(Users* users, MachineModel* machine, Document* document, RunController* runs,
                      Preflight* preflight, FoundRuns* found, QWidget* parent) {
  auto* panel = new RunPanel(parent);
  QObject::connect(panel, &RunPanel::preflightRequested, preflight, &Preflight::openForStart);
  QObject::connect(panel, &RunPanel::startRequested, runs, [runs, preflight] {
    if (const auto& back = preflight->back(); back && back->way) {
      const streaming::BackWay way = *back->way;  // starting closes the sheet
      runs->driveBack(way, back->feedMmPerS);
    } else if (!preflight->isRaising()) {
      runs->start();
    } else if (const auto raise = preflight->raise()) {
      runs->raise(raise->toMm, raise->feedMmPerS);
    }
  });
  QObject::connect(panel, &RunPanel::stopRequested, runs, [runs, found] {
    if (runs->isRunning() || !found->isOnControl()) {
      runs->stop();
    } else {
      found->stop();
    }
  });
  QObject::connect(found, &FoundRuns::changed, panel,
                   [panel, found] { panel->setFound(found->view()); });
  QObject::connect(machine, &MachineModel::viewChanged, panel,
                   [panel, machine] { panel->setMayMove(machine->mayMove()); });
  QObject::connect(panel, &RunPanel::holdRequested, runs, &RunController::hold);
  QObject::connect(panel, &RunPanel::endRequested, runs, &RunController::end);
  QObject::connect(panel, &RunPanel::overrideRequested, runs, &RunController::setOverride);
  QObject::connect(panel, &RunPanel::liftRequested, runs, &RunController::lift);
  QObject::connect(document, &Document::judged, panel, [panel, document, runs, preflight] {
    const auto& flexible = document->findings().flexible;
    panel->setLift(flexible && flexible->cells.lifts ? document->parameters().liftMm : 0.0);
    if (!runs->isRunning() && !preflight->isOpen()) {
      panel->setStopWithin(std::nullopt);  // of other settings
    }
  });
  QObject::connect(panel, &RunPanel::resumeRequested, runs, &RunController::askResume);
  QObject::connect(runs, &RunController::updated, panel, &RunPanel::setUpdate);
  QObject::connect(runs, &RunController::jobChanged, panel,
                   [panel, runs, document] { panel->setJob(jobProgress(*runs, *document)); });
  QObject::connect(runs, &RunController::wrongMotionChanged, panel,
                   [panel, runs] { panel->setWrongMotion(!runs->wrongMotion().isEmpty()); });
  QObject::connect(runs, &RunController::finished, panel,
                   [panel](const std::shared_ptr<const streaming::RunReport>& report) {
                     panel->setReport(*report);
                   });
  QObject::connect(runs, &RunController::permissionsChanged, panel, [panel, users, runs, document] {
    panel->setStartBlocked(widgets::blockedText(runs->startBlocked()));
    panel->setResume(runs->hasRunToResume(), widgets::blockedText(runs->resumeBlocked()));
    panel->setCanHold(runs->canHold());
    panel->setOverrideAllowed(runs->canOverride(),
                              permission::overridePercentMax(users->standing().role));
    if (document->program()) {
      panel->setTitle(RunTexts::title(*document, runs->isRunning() && !runs->isPositioning()));
    }
  });
  const auto showProgress = [panel, document, runs] {
    panel->setProgress(progressOf(*document, *runs));
  };
  for (const auto signal : {&Document::programLoaded, &Document::programPlaced,
                            &Document::settingsChanged, &Document::pausesChanged}) {
    QObject::connect(document, signal, panel, showProgress);
  }
  QObject::connect(runs, &RunController::updated, panel, showProgress);
  QObject::connect(runs, &RunController::jobChanged, panel, showProgress);
  QObject::connect(runs, &RunController::started, panel,
                   [panel, runs] { panel->setRunBegin(runs->runBegin()); });
  QObject::connect(preflight, &Preflight::changed, panel,
                   [panel, preflight] { followPreflight(panel, *preflight); });
  QObject::connect(document, &Document::programLoaded, panel,
                   [panel, document] { panel->setProgram(document->points().size()); });
  QObject::connect(document, &Document::programPlaced, panel, [panel, document, runs] {
    // The counters of a run stay shown; the tool is elsewhere after it.
    if (!runs->isRunning() && !runs->report()) {
      panel->setTotal(document->points().size());
    }
  });
  return panel;
}

}  // namespace rivulet::hmi
