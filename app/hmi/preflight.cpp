// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/preflight.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/method_kind.h"
#include "base/units.h"
#include "base/vec3.h"
#include "feasibility/client_turn.h"
#include "hmi/document.h"
#include "hmi/hazard_text.h"
#include "hmi/machine_model.h"
#include "hmi/pages/pages.h"
#include "hmi/run_controller.h"
#include "hmi/users.h"
#include "permission/permission.h"
#include "run/factor_feed.h"
#include "run/stands_within.h"
#include "session/background.h"
#include "streaming/start/first_move.h"
#include "streaming/start/start_policy.h"
#include "streaming/start/stop_bound.h"
#include "widgets/alarms/alarm_text.h"
#include "widgets/common/blocked_text.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_format.h"
#include "widgets/live/live_text.h"
#include "widgets/program/reading_bar.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::hmi {

using widgets::PreflightItem;
using widgets::Status;

namespace {

/// Feeds closer than this are the same, mm/min.
constexpr double kSameFeedMmPerMin = 0.5;
/// The box of a path is known to about this.
constexpr double kTravelStepMm = 0.001;

QString positionText(const base::Vec3& positionMm) {
  return QStringLiteral("X\u00A0%1 Y\u00A0%2 Z\u00A0%3")
      .arg(widgets::numberText(positionMm.x, 3), widgets::numberText(positionMm.y, 3),
           widgets::numberText(positionMm.z, 3));
}

struct StopTexts {
  Q_DECLARE_TR_FUNCTIONS(StopTexts)

 public:
  static QString of(streaming::FeedProof proof) {
    using streaming::FeedProof;
    switch (proof) {
      case FeedProof::Proved:
        break;
      case FeedProof::NotTested:
        return tr(
            "That stop and pause act at once has not been tested on this control: see Stop "
            "test.");
      case FeedProof::OtherServer:
        return tr(
            "That stop and pause act at once was tested with another version of the server: "
            "test it again.");
      case FeedProof::Failed:
        return tr("This control has failed the test that stop and pause act at once.");
      case FeedProof::WithoutMotion:
        return tr("That stop and pause act at once was tested without motion only: see Stop test.");
    }
    return {};
  }
};

QString percentText(double factor) {
  return widgets::numberText(100.0 * factor, 0) + QStringLiteral("\u00A0%");
}

/// The first of the blocks, each with its line.
QString blocksText(const std::vector<const job::NativeBlock*>& blocks) {
  constexpr std::size_t kShown = 6;
  QStringList shown;
  for (std::size_t i = 0; i < std::min(blocks.size(), kShown); ++i) {
    shown.append(Preflight::tr("%1 (line %2)")
                     .arg(QString::fromStdString(blocks[i]->source),
                          widgets::countText(blocks[i]->place.line.value)));
  }
  const QString list = shown.join(QStringLiteral(", "));
  return blocks.size() > kShown
             ? Preflight::tr("%1 and %2 more").arg(list, widgets::countText(blocks.size() - kShown))
             : list;
}

/// What a whole job begins with; null: with a stretch.
const job::NativeBlock* blockBeforePath(const Document& document) {
  if (!document.isJob()) {
    return nullptr;
  }
  for (const job::Part& part : document.view()->plan->parts) {
    const auto* native = std::get_if<job::NativeBlock>(&part);
    if (native != nullptr && !native->text.empty() &&
        native->reason != job::NativeReason::Message) {
      return native;
    }
    if (native == nullptr && std::get<job::Stretch>(part).number > 0) {
      break;
    }
  }
  return nullptr;
}

/// What is not so at the control as the program sets it up.
QStringList setUpLines(const forecast::SetUp& missing, const streaming::EquipmentSeen& seen) {
  QStringList lines;
  if (!missing.tool.empty()) {
    const QString wanted = QString::fromStdString(missing.tool);
    const QString name = QString::fromStdString(seen.toolName.value_or(""));
    const int number = seen.tool.value_or(0);
    lines.append(
        number == 0 && name.isEmpty()
            ? Preflight::tr("The program uses tool %1; there is none in the spindle.").arg(wanted)
            : Preflight::tr("The program uses tool %1; %2 is in the spindle.")
                  .arg(wanted, name.isEmpty() ? QString::number(number) : name));
  }
  if (!missing.workOffset.empty()) {
    lines.append(Preflight::tr("The program works in %1; %2 is active.")
                     .arg(QString::fromStdString(missing.workOffset),
                          QString::fromStdString(seen.workOffset.value_or(""))));
  }
  if (missing.perMin) {
    const auto turning = [](double perMin) {
      return perMin == 0.0 ? Preflight::tr("stands")
                           : Preflight::tr("turns at %1 1/min, %2")
                                 .arg(widgets::numberText(std::abs(perMin), 0),
                                      perMin > 0.0 ? Preflight::tr("clockwise (M3)")
                                                   : Preflight::tr("counterclockwise (M4)"));
    };
    double actual = seen.spindleSetPerMin.value_or(seen.spindlePerMin.value_or(0.0));
    if (seen.turn == opcua::SpindleTurn::Stands) {
      actual = 0.0;
    } else if (seen.turn == opcua::SpindleTurn::Counterclockwise) {
      actual = -actual;
    }
    lines.append(Preflight::tr("In the program the spindle %1; now it %2.")
                     .arg(turning(*missing.perMin), turning(actual)));
  }
  return lines;
}

}  // namespace

Preflight::Preflight(Document& document, MachineModel& machine, RunController& runs)
    : m_document(document), m_machine(machine), m_runs(runs) {
  connect(&m_runs, &RunController::permissionsChanged, this, &Preflight::change);
  connect(&m_runs, &RunController::started, this, &Preflight::close);
  connect(&m_runs, &RunController::resumeAsked, this, &Preflight::close);
  connect(&m_runs, &RunController::placeFound, this, &Preflight::open);
  connect(&m_runs, &RunController::resumeForgotten, this, &Preflight::close);
  connect(&m_document, &Document::programLoaded, this, &Preflight::close);
  connect(&m_runs, &RunController::raised, this, &Preflight::open);
  connect(&m_document, &Document::programLoaded, this, &Preflight::findPath);
  connect(&m_document, &Document::programPlaced, this, &Preflight::findPath);
}

void Preflight::findPath() {
  m_path = {};  // it holds a program that may be large
  const auto view = m_document.view();
  if (view && !m_document.live()) {
    session::inBackground(
        this,
        [view] {
          return Path{view, streaming::cutOf(view->points.points)};
        },
        [](Preflight& self, const Path& path) {
          if (path.view == self.m_document.view()) {
            self.m_path = path;
          }
        });
  }
}

void Preflight::open() {
  if (!m_isOpen && !m_runs.isRunning()) {
    m_isOpen = true;
    m_isSetUpConfirmed = m_isRaising = false;
    m_back.reset();
    // A virtual machine has nothing in its way.
    m_isFirstMoveConfirmed = m_isRepeatConfirmed = m_machine.view().isVirtualMachine;
    m_confirmed.clear();
    m_runs.setConfirmed({});
    change();
    Q_EMIT openChanged();
  }
}

void Preflight::openForStart() {
  m_runs.forgetResume();
  open();
}

void Preflight::dismiss() {
  close();
  m_runs.forgetResume();
}

void Preflight::close() {
  m_back.reset();
  if (m_isOpen) {
    m_isOpen = false;
    change();
    Q_EMIT openChanged();
  }
}

std::vector<PreflightItem> Preflight::items() const {
  if (!m_document.view()) {
    return {};
  }
  std::vector<PreflightItem> items;
  if (const auto blocked = isForResume() ? m_runs.placeBlocked() : m_runs.startBlocked()) {
    items.push_back({Status::Fault, tr("In the way"), widgets::blockedText(blocked), {}, 0});
  }
  if (m_back) {
    items.push_back(backItem());
    items.push_back(stopItem());
    return items;
  }
  if (raise()) {
    items.push_back(raiseItem());
    items.push_back(stopItem());
    return items;
  }
  for (PreflightItem& item : m_document.live() ? liveItems() : programItems()) {
    items.push_back(std::move(item));
  }
  if (const auto agreed = run::agreedFactor(m_document.runSettings())) {
    items.push_back(factorItem(*agreed));
  }
  items.push_back(accessItem());
  items.push_back(originItem());
  if (m_users != nullptr && m_users->isSetUp()) {
    items.push_back(releaseItem());
  }
  return items;
}

std::vector<PreflightItem> Preflight::programItems() const {
  std::vector<PreflightItem> items;
  items.push_back(programItem());
  if (PreflightItem reading = readingItem(); !reading.text.isEmpty()) {
    items.push_back(std::move(reading));
  }
  items.push_back(machineItem());
  if (m_document.outline() != nullptr && !isForChosenLine()) {
    items.push_back(jobItem());
  }
  if (!m_document.foreignFunctions().empty()) {
    items.push_back(functionsItem());
  }
  items.push_back(isForResume() ? resumeItem() : firstMoveItem());
  if (cutOnTheWay() && !m_machine.view().isVirtualMachine) {
    items.push_back(straightItem());
  }
  if (isForChosenLine()) {
    items.push_back(stateItem());
  }
  if (mayRepeat() && !m_machine.view().isVirtualMachine) {
    items.push_back(repeatItem());
  }
  items.push_back(travelItem());
  items.push_back(feedItem());
  items.push_back(methodItem());
  items.push_back(stopItem());
  if (const auto rehearsal = rehearsalView(m_document.findings())) {
    items.push_back({rehearsal->hasFailed() ? Status::Fault
                     : rehearsal->isDone    ? Status::Good
                                            : Status::Busy,
                     tr("Simulation"),
                     widgets::rehearsalText(*rehearsal),
                     {},
                     0});
  }
  return items;
}

std::vector<PreflightItem> Preflight::liveItems() const {
  const Document::LiveInput& live = *m_document.live();
  const live::Agreement& agreed = live.setup.agreement;
  const QString name = QString::fromStdString(live.name);
  std::vector<PreflightItem> items;
  items.push_back(
      live.obstacle
          ? PreflightItem{Status::Fault, tr("Live source"), widgets::errorText(*live.obstacle),
                          tr("Change …"), ChangeLive}
          : PreflightItem{Status::Good, tr("Live source"),
                          tr("%1 is open. What it sends is read from the start on.").arg(name),
                          tr("Change …"), ChangeLive});
  items.push_back(machineItem());
  QStringList box;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    box.append(QStringLiteral("%1\u00A0%2")
                   .arg(QLatin1Char(base::kAxisNames[axis]))
                   .arg(widgets::boxText(agreed, axis)));
  }
  items.push_back({Status::Plain,
                   tr("Agreed"),
                   tr("No point is outside %1. No step is longer than %2. Anything else ends the "
                      "run after the last good point.")
                       .arg(box.join(QStringLiteral(", ")), widgets::lengthText(agreed.stepMmMax)),
                   {},
                   0,
                   true});
  items.push_back(liveStartItem());
  items.push_back(travelItem(agreed.highestMm - agreed.lowestMm));
  items.push_back({Status::Plain,
                   tr("Feed"),
                   tr("The F of the points, at most %1; that is also the feed before the first F.")
                       .arg(widgets::feedText(base::mmPerSFromMmPerMin(agreed.feedMmPerMinMax))),
                   {},
                   0});
  items.push_back(stopItem());
  items.push_back({Status::Plain,
                   tr("No points"),
                   tr("The machine waits at the end of the last window: %1.")
                       .arg(widgets::silenceText(live.setup.limits)),
                   {},
                   0});
  return items;
}

PreflightItem Preflight::factorItem(const live::FactorAgreement& agreed) const {
  const QString source = QString::fromStdString(m_document.settings().factor.address);
  const QString silence = widgets::secondsText(base::toSeconds(agreed.silence), 1);
  const QString follows =
      tr("%1 multiplies your override: %2 to %3, and no more than 120 % in all.")
          .arg(source, percentText(agreed.least), percentText(agreed.most));
  return {
      Status::Plain,
      tr("Adaptive feed"),
      follows + QLatin1Char(' ') +
          (agreed.holdsInSilence
               ? tr("Without a factor for %1 the axes are held; nothing moves before the first.")
                     .arg(silence)
               : tr("Without a factor for %1 your override acts alone.").arg(silence)),
      {},
      0,
      true};
}

PreflightItem Preflight::liveStartItem() const {
  PreflightItem item{Status::Plain, tr("First move"), {}, {}, 0, true};
  const live::Agreement& agreed = m_document.live()->setup.agreement;
  const auto toolMm = m_machine.positionNowMm();
  if (!toolMm) {
    item.status = Status::Unknown;
    item.text = tr("The position of the tool is not known.");
    return item;
  }
  item.text = tr("From %1 in a straight line to the first point, which may be %2 away.")
                  .arg(positionText(*toolMm), widgets::lengthText(agreed.startMmMax));
  if (!live::reaches(agreed, *toolMm)) {
    item.status = Status::Attention;
    item.text += QLatin1Char('\n') + tr("The tool is so far outside the box that no first point "
                                        "can be in it. Move the tool, or change the box.");
  }
  return item;
}

PreflightItem Preflight::programItem() const {
  const gcode::Program& program = *m_document.program();
  if (m_document.hasFileChanged()) {
    return {Status::Fault, tr("Program"),
            tr("%1 has changed on disk since version %2 was read.")
                .arg(QString::fromStdString(program.name), QString::fromStdString(program.hash)),
            tr("Reload"), ReloadProgram};
  }
  QString text =
      tr("%1, version %2, %Ln points", nullptr, static_cast<int>(m_document.points().size()))
          .arg(QString::fromStdString(program.name), QString::fromStdString(program.hash));
  if (const auto& merged = program.merged) {
    text += QLatin1Char('\n') +
            tr("Within the tolerance %1 of %2 points are left, at most %3 off the program.")
                .arg(widgets::countText(merged->to), widgets::countText(merged->of),
                     widgets::lengthText(merged->deviationMm, 4));
  } else if (m_document.settings().tolerance > 0.0) {
    text += QLatin1Char('\n') +
            (m_document.isJob() ? tr("All points are streamed: a whole job has no tolerance.")
                                : tr("All points are streamed: fewer cannot be kept within the "
                                     "tolerance."));
  }
  return {program.isStreamable() ? Status::Good : Status::Fault, tr("Program"), text, {}, 0, true};
}

PreflightItem Preflight::readingItem() const {
  using gcode::DiagnosticCode;
  const gcode::Program& program = *m_document.program();
  const session::Reading& reading = m_document.reading();
  PreflightItem item{Status::Plain, tr("Read as"), {}, {}, 0};
  QStringList parts;
  if (reading.dialect) {
    parts.append(tr("a program for %1").arg(widgets::controlName(*reading.dialect)));
  }
  const auto open = [&](DiagnosticCode code) {
    const gcode::Diagnostic* const found = gcode::findingOf(program, code);
    if (found == nullptr) {
      return std::optional<QString>();
    }
    item.status = Status::Attention;
    return std::optional(QString::fromStdString(found->argument));
  };
  if (const auto sizes = open(DiagnosticCode::UnitsNotSaid)) {
    parts.append(
        tr("mm, because this machine is metric; the program does not say (%1)").arg(*sizes));
  } else if (reading.units) {
    parts.append(*reading.units == gcode::FileUnits::Inches
                     ? tr("inch where the program does not say it, as chosen")
                     : tr("mm where the program does not say it, as chosen"));
  }
  if (const auto sizes = open(DiagnosticCode::NoDecimalPoint)) {
    parts.append(tr("whole units where a number has no decimal point (%1)").arg(*sizes));
  } else if (reading.noPoint) {
    parts.append(*reading.noPoint == gcode::NoPoint::Increments
                     ? tr("thousandths where a number has no decimal point, as chosen")
                     : tr("whole units where a number has no decimal point, as chosen"));
  }
  if (open(DiagnosticCode::ControlSettingOpen)) {
    parts.append(tr("what it leaves out as a virtual machine is set (%1)")
                     .arg(QString::fromStdString(gcode::textOf(gcode::openSettings(program)))));
  } else if (!reading.settings.empty()) {
    parts.append(tr("what it leaves out as chosen (%1)")
                     .arg(QString::fromStdString(gcode::textOf(reading.settings))));
  }
  if (!reading.accepted.empty()) {
    QStringList words;
    for (const std::string& word : reading.accepted) {
      words.append(QString::fromStdString(word));
    }
    parts.append(tr("without %1, which does not change the path, as confirmed")
                     .arg(words.join(QStringLiteral(", "))));
  }
  item.text = parts.join(QStringLiteral("; "));
  return item;
}

PreflightItem Preflight::functionsItem() const {
  PreflightItem item{Status::Plain, tr("M functions and axes of another machine"), {}, {}, 0, true};
  QStringList lines;
  for (const job::FunctionUse& use : m_document.foreignFunctions()) {
    const QString call = tr("%1 (line %2, %Ln times)", nullptr, static_cast<int>(use.count))
                             .arg(QString::fromStdString(job::textOf(use.name)))
                             .arg(use.line.value);
    if (!use.text.empty()) {
      lines.append(tr("%1: the control executes %2").arg(call, QString::fromStdString(use.text)));
    } else if (use.isAssumed) {
      item.status = Status::Attention;
      lines.append(tr("%1: left out, because nobody has said what this machine does for it "
                      "(Configure, Limits)")
                       .arg(call));
    } else {
      lines.append(tr("%1: left out").arg(call));
    }
  }
  item.text = lines.join(QLatin1Char('\n'));
  return item;
}

PreflightItem Preflight::machineItem() const {
  if (!m_machine.isConnected()) {
    return {Status::Fault, tr("Machine"), tr("Not connected"), {}, 0};
  }
  return m_machine.view().isVirtualMachine
             ? PreflightItem{Status::Simulated,
                             tr("Machine"),
                             tr("%1: a virtual machine, no real axis moves")
                                 .arg(m_machine.endpoint()),
                             {},
                             0}
             : PreflightItem{Status::Good,
                             tr("Machine"),
                             tr("%1: the axes of this machine will move").arg(m_machine.endpoint()),
                             {},
                             0,
                             true};
}

PreflightItem Preflight::jobItem() const {
  const overview::JobOutline& outline = *m_document.outline();
  const auto& blocks = outline.needed();
  if (m_document.dryRunMm() > 0.0) {
    return {
        Status::Attention, tr("Dry run"),
        tr("Everything takes place %1 higher than programmed. The spindle does not turn, and no "
           "coolant flows; tools are changed, and retracts in machine coordinates are made.")
            .arg(widgets::lengthText(m_document.dryRunMm(), 1)),
        tr("Run the whole job"), RunWholeJob};
  }
  if (m_document.isJob()) {
    return {Status::Good, tr("Whole job"),
            tr("Streamed: %1; the control executes %Ln blocks: %2", nullptr,
               static_cast<int>(blocks.size()))
                .arg(tr("%Ln parts", nullptr, static_cast<int>(outline.stretches())),
                     blocksText(blocks)),
            isForResume() || outline.stretches() < 2 || !m_runs.canChangeSettings()
                ? QString()
                : tr("Begin with a part …"),
            ChooseStretch};
  }
  PreflightItem item{Status::Attention, tr("Motion only"),
                     tr("%Ln blocks are left out: %1", nullptr, static_cast<int>(blocks.size()))
                             .arg(blocksText(blocks)) +
                         QLatin1Char('\n') + tr("Set tool, spindle and coolant at the control."),
                     m_document.jobObstacle() ? QString() : tr("Run the whole job"), RunWholeJob};
  const forecast::SetUp missing = missingSetUp();
  if (missing.isEmpty()) {
    return item;
  }
  for (const QString& line : setUpLines(missing, *m_machine.view().equipment)) {
    item.text += QLatin1Char('\n') + line;
  }
  if (m_isSetUpConfirmed) {
    item.text += QLatin1Char('\n') + tr("Confirmed: it starts like this.");
  } else {
    item.status = Status::Fault;
    item.remedy = tr("Start like this");
    item.remedyId = ConfirmSetUp;
  }
  return item;
}

forecast::SetUp Preflight::missingSetUp() const {
  const auto& view = m_document.view();
  const auto& equipment = m_machine.view().equipment;
  if (!view || !view->plan || view->isJob() || m_document.live() || isForResume() || !equipment) {
    return {};
  }
  const auto& machine = m_document.jobMachine();
  if (m_setUpOf.lock() != view->plan || m_setUpOn != machine) {
    m_setUpOf = view->plan;
    m_setUpOn = machine;
    m_setUp = forecast::setUpOf(*view->plan, machine ? *machine : usualMachine());
  }
  return forecast::missingOf(m_setUp, *equipment);
}

PreflightItem Preflight::firstMoveItem() const {
  PreflightItem item{Status::Plain, tr("First move"), {}, {}, 0, true};
  if (const job::NativeBlock* first = blockBeforePath(m_document)) {
    item.text = tr("First the control executes line %1: %2. Then the tool moves from where it "
                   "stands to the first point of part 1.")
                    .arg(widgets::countText(first->place.line.value),
                         QString::fromStdString(first->source));
    warnOfCut(item);
    return item;
  }
  const auto toolMm = m_machine.positionNowMm();
  if (!toolMm || m_document.points().empty()) {
    item.status = Status::Unknown;
    item.text = tr("The position of the tool is not known.");
    return item;
  }
  const base::Vec3& firstMm = m_document.points().front().positionMm;
  item.text = tr("From %1 in a straight line over %2 to point 1 at %3")
                  .arg(positionText(*toolMm), widgets::lengthText(base::distance(*toolMm, firstMm)),
                       positionText(firstMm));
  warnOfCut(item);
  const auto& report = m_runs.report();
  // One that was refused before it began has left nothing.
  if (report && report->outcome != streaming::Outcome::Completed &&
      m_runs.update().counters.total > 0) {
    item.status = Status::Attention;
    item.text += QLatin1Char('\n') +
                 tr("The last run was left at %1 of %2 points. This start does not go on there: it "
                    "moves from where the tool stands, perhaps in the cut, to the first point.")
                     .arg(widgets::countText(m_runs.update().counters.executed),
                          widgets::countText(m_runs.update().counters.total));
  }
  return item;
}

widgets::FirstMove Preflight::firstMove() const {
  const auto& toolMm = m_machine.view().positionMm;
  if (!m_isOpen || m_document.live() || m_document.points().empty()) {
    return {};
  }
  widgets::FirstMove move{m_document.view(), {}};
  if (!toolMm) {
    return move;
  }
  move.wayMm.push_back(*toolMm);
  if (m_back) {
    for (const auto& place :
         m_back->way ? m_back->way->places : std::vector<base::AxisPosition>()) {
      move.wayMm.push_back(place.mm);
    }
  } else if (const auto raised = raise()) {
    move.wayMm.push_back({toolMm->x, toolMm->y, raised->toMm});
  } else if (isForResume()) {
    move.wayMm.push_back(m_runs.place()->positionMm);
  } else if (blockBeforePath(m_document) == nullptr) {
    move.wayMm.push_back(m_document.points().front().positionMm);
  }
  if (!base::isFinite(move.wayMm.back())) {
    move.wayMm.pop_back();
  }
  return move;
}

const std::optional<streaming::CutOnTheWay>& Preflight::cutOnTheWay() const {
  if (!m_cut) {
    m_cut = findCut();
  }
  return *m_cut;
}

void Preflight::change() {
  m_cut.reset();
  Q_EMIT changed();
}

std::optional<streaming::CutOnTheWay> Preflight::findCut() const {
  // Also between two readings: a place that is a second old is better than none.
  const auto& toolMm = m_machine.view().positionMm;
  const bool goesOn = isForResume() && !isForChosenLine();
  if (!toolMm || goesOn || m_document.live() || m_document.points().empty()) {
    return std::nullopt;
  }
  if (m_document.isJob()) {
    const streaming::CutBox* cut = m_document.jobCut();
    return cut != nullptr ? forecast::cutOnTheWay(*m_document.view()->plan,
                                                  *m_document.jobMachine(), {*toolMm, {}}, *cut)
                          : std::nullopt;
  }
  if (m_path.view != m_document.view()) {  // not yet
    m_path = {m_document.view(), streaming::cutOf(m_document.points())};
  }
  return streaming::cutOnTheWay(
      *toolMm,
      isForChosenLine() ? m_runs.place()->positionMm
                        : streaming::firstPlace(m_document.program()->trajectory, *toolMm),
      m_path.cut);
}

std::optional<Preflight::Raise> Preflight::raise() const {
  const auto cut = m_isRaising && !isForResume() ? cutOnTheWay() : std::nullopt;
  if (!cut || !cut->isClearFromAbove) {
    return std::nullopt;
  }
  return Raise{cut->heightMm, carefulMmPerS()};
}

double Preflight::carefulMmPerS() const {
  const streaming::StreamSettings& settings = m_document.settings();
  const auto feeds = m_document.view()->cuttingMmPerS;
  return settings.usesProgramFeeds() && feeds
             ? feeds->first * std::min(1.0, settings.overrideFactor)
             : m_document.runSettings().feedMmPerS;
}

void Preflight::setBack(const streaming::BackWish& wish, double feedMmPerS) {
  m_back = Back{m_runs.wayBack(wish), feedMmPerS};
  change();
}

PreflightItem Preflight::backItem() const {
  PreflightItem item{
      Status::Attention, tr("Back along the path"), {}, tr("Change …"), DriveBack, true};
  if (!m_back->way) {
    item.status = Status::Fault;
    item.text = widgets::errorText(m_back->way.error());
    return item;
  }
  item.text =
      tr("The tool goes back by %1 along the path that it has cut, at %2, to %3. Then this "
         "page comes again, and the run goes on from there.")
          .arg(widgets::lengthText(m_back->way->lengthMm, 1), widgets::feedText(m_back->feedMmPerS),
               positionText(m_back->way->places.back().mm));
  return item;
}

void Preflight::warnOfCut(PreflightItem& item) const {
  const auto cut = cutOnTheWay();
  if (!cut) {
    return;
  }
  item.status = m_isFirstMoveConfirmed ? Status::Attention : Status::Fault;
  item.text += QLatin1Char('\n') +
               tr("This way passes within what the program cuts, which reaches up to Z %1.")
                   .arg(widgets::lengthText(cut->heightMm, 3));
  if (cut->isClearFromAbove && !isForResume()) {
    item.remedy = tr("Raise the tool …");
    item.remedyId = RaiseTool;
  } else {
    item.text += QLatin1Char(' ') + tr("Bring the tool to a place from which it is clear.");
  }
}

PreflightItem Preflight::straightItem() const {
  return m_isFirstMoveConfirmed
             ? PreflightItem{Status::Attention,
                             tr("Straight way"),
                             tr("Confirmed: nothing is in the way of the first move."),
                             {},
                             0}
             : PreflightItem{Status::Attention, tr("Straight way"),
                             tr("If nothing is in the way of the first move, confirm it."),
                             tr("It is clear …"), ConfirmFirstMove};
}

void Preflight::confirmFirstMove() {
  confirm(m_isFirstMoveConfirmed, "first move");
}

void Preflight::confirm(bool& question, std::string_view name) {
  if (!std::exchange(question, true)) {
    m_confirmed.append(m_confirmed.empty() ? "" : ", ").append(name);
    m_runs.setConfirmed(m_confirmed);
  }
  change();
}

bool Preflight::mayRepeat() const {
  return streaming::mayRepeat(m_document.settings().parameters.method);
}

PreflightItem Preflight::repeatItem() const {
  const QString method = widgets::methodText(m_document.settings().parameters.method);
  const QString what = tr("Method %1 may execute old points again: if this computer is late for a "
                          "moment, the tool goes back through the workpiece, and nothing stops it "
                          "before it has moved. Method window does not.")
                           .arg(method);
  return m_isRepeatConfirmed
             ? PreflightItem{Status::Attention,
                             tr("Method"),
                             what + QLatin1Char(' ') + tr("Confirmed."),
                             {},
                             0}
             : PreflightItem{Status::Fault, tr("Method"), what, tr("Accept it …"), ConfirmRepeats};
}

void Preflight::confirmRepeats() {
  confirm(m_isRepeatConfirmed, "repeats");
}

PreflightItem Preflight::raiseItem() const {
  const Raise raise = *this->raise();
  const double byMm = raise.toMm - m_machine.view().positionMm->z;
  return {Status::Attention,
          tr("Raise the tool"),
          tr("The tool goes straight up by %1 to Z %2, at %3. Nothing else moves. Then this page "
             "comes again.")
              .arg(widgets::lengthText(byMm, 3), widgets::lengthText(raise.toMm, 3),
                   widgets::feedText(raise.feedMmPerS)),
          {},
          0,
          true};
}

PreflightItem Preflight::hazardItem() const {
  PreflightItem item{Status::Plain, tr("Travel, spindle and tools"), {}, {}, 0};
  const Findings& findings = m_document.findings();
  const run::JobRestart* restart = m_runs.restart();
  const session::Hazards* hazards = restart != nullptr ? &restart->hazards : findings.hazards.get();
  if (restart == nullptr && !findings.isJobChecked) {
    item.status = Status::Unknown;
    item.text = tr("Not checked: nobody has entered the limits of this machine.");
    item.remedy = tr("Enter …");
    item.remedyId = EnterLimits;
    return item;
  }
  if (hazards == nullptr) {
    item.status = Status::Busy;
    item.text = tr("The job is being compared with the machine.");
    return item;
  }
  const QString stops = hazardsText(*hazards, true);
  const QString others = hazardsText(*hazards, false);
  if (stops.isEmpty() && others.isEmpty()) {
    item.status = Status::Good;
    const auto& machine = m_document.jobMachine();
    item.text = machine && machine->tools
                    ? tr("Every block is within the travel of the axes, the speed of the spindle "
                         "and the tool table.")
                    : tr("Every block is within the travel of the axes and the speed of the "
                         "spindle. Tools are not compared: this machine has no tool table here.");
    return item;
  }
  item.status = stops.isEmpty() ? Status::Attention : Status::Fault;
  item.text = stops.isEmpty()    ? others
              : others.isEmpty() ? stops
                                 : stops + QLatin1Char('\n') + others;
  return item;
}

PreflightItem Preflight::travelItem() const {
  if (m_document.isJob()) {
    return hazardItem();
  }
  const overview::SpaceBox& box = m_document.view()->levels.box();
  base::Vec3 sizeMm;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    sizeMm.set(axis, box.high[axis] - box.low[axis]);
  }
  return travelItem(sizeMm);
}

PreflightItem Preflight::travelItem(const base::Vec3& sizesMm) const {
  PreflightItem item{Status::Plain, tr("Travel"), {}, {}, 0};
  const auto& machine = m_document.machine();
  if (!machine) {
    item.status = Status::Unknown;
    item.text = tr("Not checked: nobody has entered the limits of this machine.");
    item.remedy = tr("Enter …");
    item.remedyId = EnterLimits;
    return item;
  }
  QStringList sizes;
  QStringList tooLong;
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const double sizeMm = sizesMm[axis];
    const double travelMm = machine->axes[axis].positionMmMax - machine->axes[axis].positionMmMin;
    const QLatin1Char name(base::kAxisNames[axis]);
    sizes.push_back(name + QStringLiteral("\u00A0%1").arg(widgets::numberText(sizeMm, 1)));
    if (sizeMm > travelMm + kTravelStepMm) {
      tooLong.push_back(tr("%1 needs %2, the machine has %3")
                            .arg(name)
                            .arg(widgets::lengthText(sizeMm, 1), widgets::lengthText(travelMm, 1)));
    }
  }
  if (!tooLong.isEmpty()) {
    item.status = Status::Fault;
    item.text =
        tr("The path is longer than the travel: %1.").arg(tooLong.join(QStringLiteral("; ")));
  } else {
    item.status = Status::Good;
    item.text =
        tr("The path (%1 mm) is not longer than the travel of the axes. Where the workpiece "
           "lies is not known to Rivulet.")
            .arg(sizes.join(QLatin1Char(' ')));
  }
  return item;
}

PreflightItem Preflight::jobResumeItem() const {
  const widgets::ResumePlace& place = *m_runs.place();
  PreflightItem item{Status::Plain, tr("First the control executes"), {}, {}, 0, true};
  QStringList lines;
  if (place.restMm) {
    lines.append(widgets::restText(place));
  }
  for (std::size_t i = 0; i < place.steps.size(); ++i) {
    lines.append(QStringLiteral("%1. %2").arg(widgets::countText(i + 1),
                                              QString::fromStdString(place.steps[i])));
  }
  const QString line = widgets::countText(place.line.value);
  lines.append(place.block.empty()
                   ? tr("Then the job goes on in part %1 at point %2 of %3 (line %4).")
                         .arg(widgets::countText(static_cast<std::size_t>(place.stretch)),
                              widgets::countText(place.point + 1), widgets::countText(place.points),
                              line)
                   : tr("Then the job goes on at line %1: %2")
                         .arg(line, QString::fromStdString(place.block)));
  if (!place.notRestored.empty()) {
    item.status = Status::Attention;
    QStringList blocks;
    for (const std::string& block : place.notRestored) {
      blocks.append(QString::fromStdString(block));
    }
    lines.append(tr("Not done again, because only the control knows their effect: %1")
                     .arg(blocks.join(QStringLiteral("; "))));
  }
  item.text = lines.join(QLatin1Char('\n'));
  return item;
}

PreflightItem Preflight::resumeItem() const {
  const widgets::ResumePlace& place = *m_runs.place();
  if (place.isJob) {
    return jobResumeItem();
  }
  PreflightItem item{Status::Plain, tr("First move"), {}, {}, 0, true};
  const QString point = tr("point %1 of %2 at %3")
                            .arg(widgets::countText(place.point + 1),
                                 widgets::countText(place.points), positionText(place.positionMm));
  if (place.isChosen) {
    return chosenItem(point);
  }
  if (place.restMm && place.approachMm) {
    item.text = widgets::restText(place) + QLatin1Char('\n') +
                tr("Then in a straight line over %1 to %2.")
                    .arg(widgets::lengthText(*place.approachMm), point);
  } else {
    item.text = place.approachMm
                    ? tr("In a straight line over %1 to %2. %Ln points have been executed.",
                         nullptr, static_cast<int>(place.point))
                          .arg(widgets::lengthText(*place.approachMm), point)
                    : tr("In a straight line to %1. %Ln points have been executed.", nullptr,
                         static_cast<int>(place.point))
                          .arg(point);
  }
  if (!place.restMm) {
    item.remedy = tr("Drive back …");
    item.remedyId = DriveBack;
  }
  if (place.changedFrom) {
    item.status = Status::Attention;
    item.text += QLatin1Char('\n') +
                 tr("From point %1 on, the program differs from that of the interrupted run.")
                     .arg(widgets::countText(*place.changedFrom + 1));
  }
  return item;
}

PreflightItem Preflight::chosenItem(const QString& point) const {
  const widgets::ResumePlace& place = *m_runs.place();
  const QString feed = widgets::feedText(place.feedMmPerS);
  const QString how = place.isRapid ? tr("as a rapid, %1").arg(feed) : tr("at %1").arg(feed);
  PreflightItem item{Status::Attention, tr("First move"), {}, {}, 0};
  item.text =
      (place.approachMm
           ? tr("From where the tool stands in a straight line over %1, %2, to where line %3 "
                "begins: %4.")
                 .arg(widgets::lengthText(*place.approachMm), how,
                      widgets::countText(place.line.value), point)
           : tr("From where the tool stands in a straight line, %1, to where line %2 begins: %3.")
                 .arg(how, widgets::countText(place.line.value), point)) +
      QLatin1Char('\n') +
      tr("The %Ln points before it are not executed.", nullptr, static_cast<int>(place.point));
  warnOfCut(item);
  return item;
}

PreflightItem Preflight::stateItem() const {
  const widgets::ResumePlace& place = *m_runs.place();
  std::vector<const job::NativeBlock*> before;  // the last first: it is what holds
  if (const overview::JobOutline* outline = m_document.outline()) {
    for (const job::NativeBlock* block : outline->needed()) {
      if (block->place.line.value < place.line.value) {
        before.insert(before.begin(), block);
      }
    }
  }
  const QString feed =
      tr("Feeds are those that the program has commanded up to each line, and "
         "the work offset is the one that is active at the control.");
  if (before.empty()) {
    return {Status::Plain, tr("State at this line"), feed, {}, 0};
  }
  return {Status::Attention,
          tr("State at this line"),
          feed + QLatin1Char('\n') +
              tr("Left out before this line, the last one first: %1. Set at the control what holds "
                 "here.")
                  .arg(blocksText(before)),
          {},
          0};
}

PreflightItem Preflight::programFeedItem() const {
  PreflightItem item{Status::Plain, tr("Feed"), {}, {}, 0, true};
  const double overrideFactor = m_document.settings().overrideFactor;
  const auto programmed = m_document.view()->cuttingMmPerS;
  const QString percent = percentText(overrideFactor);
  if (!programmed) {
    item.text = tr("The feeds of the program at %1. It names none.").arg(percent);
    return item;
  }
  const auto [least, largest] = *programmed;
  item.text = least == largest
                  ? tr("That of the program, %1, at %2").arg(widgets::feedText(least), percent)
                  : tr("Those of the program, %1 to %2, at %3; each block its own")
                        .arg(widgets::feedText(least), widgets::feedText(largest), percent);
  item.text += QLatin1Char('\n') +
               tr("Rapids at %1 at most").arg(widgets::feedText(m_document.feedMmPerSMax()));
  if (overrideFactor > 1.0) {
    item.status = Status::Attention;
    item.text += QLatin1Char('\n') + tr("Blocks will be cut faster than programmed.");
    item.remedy = tr("Use 100 %");
    item.remedyId = UseProgramFeed;
  }
  return item;
}

PreflightItem Preflight::originItem() const {
  const streaming::RunOrigin origin = report::thisUser();
  PreflightItem item{Status::Plain, tr("Who starts"), {}, {}, 0};
  const bool hasUsers = m_users != nullptr && m_users->isSetUp();
  item.text = tr("%1 on %2")
                  .arg(hasUsers ? m_users->name() : QString::fromStdString(origin.user),
                       QString::fromStdString(origin.computer));
  return item;
}

PreflightItem Preflight::feedItem() const {
  if (m_document.settings().usesProgramFeeds()) {
    return programFeedItem();
  }
  const double feedMmPerS = m_document.settings().feedMmPerS;
  PreflightItem item{Status::Plain, tr("Feed"), {}, {}, 0, true};
  const auto programmed = m_document.view()->cuttingMmPerS;
  const bool isPublished = base::isPublished(m_document.settings().parameters.method);
  const QString fixed =
      (isPublished ? tr("%1 for every block: this method has one feed, as it was published")
                   : tr("%1 for every block, set here"))
          .arg(widgets::feedText(feedMmPerS));
  if (!programmed) {
    item.text = tr("%1. The program names no feed.").arg(fixed);
    return item;
  }
  const QString range =
      programmed->first == programmed->second
          ? widgets::feedText(programmed->first)
          : tr("%1 to %2")
                .arg(widgets::feedText(programmed->first), widgets::feedText(programmed->second));
  item.text = tr("%1. The program's own feed, %2, is not used.").arg(fixed, range);
  constexpr double kSPerMin = 60.0;
  if (feedMmPerS > programmed->first + kSameFeedMmPerMin / kSPerMin) {
    item.status = Status::Attention;
    item.text += QLatin1Char(' ') + tr("Some blocks will be cut %1 times as fast as programmed.")
                                        .arg(widgets::factorText(feedMmPerS / programmed->first));
    item.remedy = isPublished ? tr("Use F = %1").arg(widgets::feedText(programmed->first))
                              : tr("Use the feeds of the program");
    item.remedyId = UseProgramFeed;
  }
  return item;
}

PreflightItem Preflight::methodItem() const {
  const Findings& findings = m_document.findings();
  PreflightItem item{Status::Plain, tr("Verdict"), {}, {}, 0};
  if (findings.isBeingMeasured) {
    item.status = Status::Busy;
    item.text = tr("The path is being measured.");
  } else if (!findings.verdict) {
    item.status = Status::Unknown;
    item.text = tr("There is no verdict.");
  } else if (findings.verdict->waits) {
    item.status = Status::Attention;
    item.text = findings.overrideLimit
                    ? tr("Safe, but the machine will wait for points. Largest override without "
                         "waiting: %1.")
                          .arg(widgets::overrideLimitText(*findings.overrideLimit))
                    : tr("Safe, but the machine will wait for points. Largest feed without "
                         "waiting: %1.")
                          .arg(widgets::feedText(findings.verdict->feedMmPerSMax));
  } else {
    item.status = findings.verdict->feasible ? Status::Good : Status::Fault;
    const QString margin = widgets::factorText(findings.verdict->limiting.margin);
    item.text = findings.overrideLimit
                    ? tr("Margin %1 ×, largest override %2")
                          .arg(margin, widgets::overrideLimitText(*findings.overrideLimit))
                    : tr("Margin %1 ×, largest feed %2")
                          .arg(margin, widgets::feedText(findings.verdict->feedMmPerSMax));
  }
  return item;
}

bool Preflight::standsAtOnce(const streaming::RunSettings& settings) const {
  return base::hasWindows(settings.parameters.method) &&
         m_document.feedProof() == streaming::FeedProof::Proved;
}

PreflightItem Preflight::stopItem() const {
  const streaming::RunSettings settings = m_document.runSettings();
  if (!standsAtOnce(settings)) {
    return runCellItem(settings);
  }
  const std::optional<double> seconds = feedCellSeconds();
  return {Status::Plain,
          tr("Stop"),
          seconds ? tr("The axes stand on the path within %1; threads and tapping at their end.")
                        .arg(widgets::secondsText(*seconds, 1))
                  : tr("The axes stand at once, on the path. How long they brake is not known."),
          {},
          0,
          true};
}

std::optional<double> Preflight::stopSeconds() const {
  const streaming::RunSettings settings = m_document.runSettings();
  if (standsAtOnce(settings)) {
    return feedCellSeconds();
  }
  if (m_document.live()) {
    return settings.windowSMax;
  }
  return streaming::stopBound(m_document.points(), m_machine.positionNowMm(), settings).seconds;
}

std::optional<double> Preflight::feedCellSeconds() const {
  const streaming::StreamSettings& settings = m_document.settings();
  const auto& machine = m_document.jobMachine();
  if (!machine) {
    return std::nullopt;
  }
  const auto& live = m_document.live();
  const double feedMmPerS =
      live ? base::mmPerSFromMmPerMin(live->setup.agreement.feedMmPerMinMax)
           : (settings.usesProgramFeeds() ? m_document.feedMmPerSMax() : settings.feedMmPerS);
  return base::toSeconds(run::standsWithin(
      *machine, m_document.findings().operatingPoint.turn(),
      m_document.findings().access.timePerNode(m_document.findings().operatingPoint.turn()),
      feedMmPerS));
}

/// A stop acts where the program looks at its run cell, or at the end of its loop.
PreflightItem Preflight::runCellItem(const streaming::RunSettings& settings) const {
  constexpr double kLongS = 5.0;
  PreflightItem item{Status::Plain, tr("Stop"), {}, {}, 0, true};
  const bool hasWindows = base::hasWindows(settings.parameters.method);
  if (m_document.live()) {
    item.status = Status::Attention;
    item.text =
        tr("After Stop the control still executes its window, of at most %1 moves within the "
           "agreed box, and of at most %2: longer moves are divided.")
            .arg(settings.parameters.pointsPerLoop *
                 streaming::windowsAfterStop(settings.parameters))
            .arg(widgets::secondsText(settings.windowSMax, 1));
  } else {
    const streaming::StopBound bound =
        streaming::stopBound(m_document.points(), m_machine.positionNowMm(), settings);
    const double limitS = hasWindows ? settings.windowSMax : kLongS;
    item.status = bound.seconds > limitS ? Status::Attention : Status::Plain;
    const QString mm = widgets::lengthText(bound.mm, 0);
    const QString seconds = widgets::secondsText(bound.seconds, 1);
    item.text = hasWindows
                    ? tr("After Stop the control still executes its window, at most %1 in %2.")
                          .arg(mm, seconds)
                    : tr("With this method, after Stop the control still executes its "
                         "loop, at most %1 in %2.")
                          .arg(mm, seconds);
    if (bound.longMove) {
      item.text += QLatin1Char(' ') + (bound.longMove->isFirst
                                           ? tr("The first move, to line %1, alone takes %2: bring "
                                                "the tool nearer before the start.")
                                           : tr("The move of line %1 alone takes %2; it is not "
                                                "divided."))
                                          .arg(bound.longMove->line.value)
                                          .arg(widgets::secondsText(bound.longMove->seconds, 1));
    }
  }
  if (hasWindows) {
    item.status = Status::Attention;
    item.text += QLatin1Char(' ') + StopTexts::of(m_document.feedProof());
  }
  return item;
}

PreflightItem Preflight::accessItem() const {
  const Findings& findings = m_document.findings();
  const base::Duration time = findings.access.timePerNode(findings.operatingPoint.turn());
  if (findings.source.isUsed()) {
    return {
        Status::Good, tr("Access"), widgets::accessSourceText(findings.source, time).text, {}, 0};
  }
  const QString each = widgets::millisecondsText(time, 2);
  const bool mayMeasure = m_users != nullptr && !m_users->refusal(permission::Act::Calibrate);
  return {Status::Attention, tr("Access"),
          findings.source.isOutdated
              ? tr("Since it was measured how fast this control can be written to, its software "
                   "has changed: %1 for each R-parameter are assumed.")
                    .arg(each)
              : tr("It has not been measured how fast this control can be written to: %1 for each "
                   "R-parameter are assumed.")
                    .arg(each),
          mayMeasure ? tr("Measure …") : QString(), MeasureAccess};
}

void Preflight::setReleases(Releases& releases, Users& users) {
  m_releases = &releases;
  m_users = &users;
  connect(m_releases, &Releases::changed, this, &Preflight::change);
}

PreflightItem Preflight::releaseItem() const {
  const bool mayRelease = !m_users->refusal(permission::Act::Release);
  if (const permission::Release* release = m_releases->release()) {
    return {Status::Good, tr("Release"),
            tr("Released by %1 on %2, who starts: %3")
                .arg(QString::fromStdString(release->by), widgets::dateTimeText(release->at),
                     m_users->name()),
            mayRelease ? tr("Take back") : QString(), TakeBackRelease};
  }
  const QString text = tr("This program with these settings and this calibration is not released.");
  return mayRelease ? PreflightItem{Status::Plain, tr("Release"), text, tr("Release"), ReleaseJob}
                    : PreflightItem{Status::Fault, tr("Release"), text, {}, 0};
}

void Preflight::remedy(int remedyId) {
  if (remedyId == ReleaseJob) {
    m_releases->give();
    return;
  }
  if (remedyId == TakeBackRelease) {
    m_releases->takeBack();
    return;
  }
  if (remedyId == ConfirmSetUp) {
    confirm(m_isSetUpConfirmed, "set-up");
    return;
  }
  if (remedyId == ConfirmFirstMove) {
    Q_EMIT straightRequested();
    return;
  }
  if (remedyId == ConfirmRepeats) {
    Q_EMIT repeatsRequested();
    return;
  }
  if (remedyId == RaiseTool) {
    m_isRaising = true;
    change();
    return;
  }
  if (remedyId == DriveBack) {
    Q_EMIT backRequested(base::mmPerMinFromMmPerS(carefulMmPerS()),
                         base::mmPerMinFromMmPerS(m_document.feedMmPerSMax()));
    return;
  }
  if (remedyId == RunWholeJob) {
    m_document.chooseJob(true);
    return;
  }
  if (remedyId == ChangeLive) {
    close();
    Q_EMIT liveRequested();
    return;
  }
  if (remedyId == ChooseStretch) {
    Q_EMIT stretchRequested(static_cast<int>(m_document.outline()->stretches()));
    return;
  }
  if (remedyId == EnterLimits) {
    close();
    Q_EMIT limitsRequested();
    return;
  }
  if (remedyId == MeasureAccess) {
    close();
    Q_EMIT calibrationRequested();
    return;
  }
  if (remedyId == ReloadProgram) {
    m_document.readAgain(m_document.reading());
  } else if (const auto feeds = m_document.view()->cuttingMmPerS; feeds) {
    streaming::StreamSettings settings = m_document.settings();
    if (settings.usesProgramFeeds()) {
      settings.overrideFactor = 1.0;
    } else if (base::isPublished(settings.parameters.method)) {
      settings.feedMmPerS = feeds->first;
    } else {
      settings.programFeeds = true;
      settings.overrideFactor = 1.0;
    }
    m_document.setSettings(settings);
  }
}

}  // namespace rivulet::hmi
