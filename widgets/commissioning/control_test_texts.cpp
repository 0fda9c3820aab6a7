// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/commissioning/control_test_texts.h"

#include <QCoreApplication>
#include <array>
#include <utility>

#include "base/units.h"
#include "widgets/common/number_format.h"

namespace rivulet::widgets {

namespace {

using streaming::AirMove;
using streaming::CommissioningCheck;

class CreditTestTexts final : public ControlTestTexts {
  Q_DECLARE_TR_FUNCTIONS(CreditTestTexts)

 public:
  static QString figures(const streaming::Commissioning& result) {
    return tr("%1 of %2 answers while busy, the slowest after %3")
        .arg(QString::number(result.answered), QString::number(result.asked),
             millisecondsText(result.slowestAnswer));
  }

 private:
  [[nodiscard]] int cells() const override { return streaming::kCreditTestCells; }
  [[nodiscard]] QString what() const override {
    return tr(
        "Method credit lets the axes move on while the next window is on its way. That is safe "
        "only on a control that answers while its axes are busy. This test finds out: a program "
        "that moves no axis, for a few seconds. The channel must be in reset.");
  }
  [[nodiscard]] QString program(int firstCell,
                                const std::optional<AirMove>& /*move*/) const override {
    return QString::fromStdString(streaming::commissioningProgram(firstCell));
  }
  [[nodiscard]] QString fileName() const override {
    return QString::fromStdString(streaming::commissioningFileName());
  }
  [[nodiscard]] QString lastStep(const std::optional<AirMove>& /*move*/) const override {
    return tr("4. Numbers are sent and must come back while the control is busy.");
  }
  [[nodiscard]] QString notTested() const override {
    return tr("Not tested: method credit does not start on this control");
  }
  [[nodiscard]] QString enough() const override {
    return tr("Passed: method credit may run on this control");
  }
  [[nodiscard]] QString failed() const override {
    return tr("Not passed: method credit does not start. Use method window.");
  }
  [[nodiscard]] QString check(const CommissioningCheck& check) const override {
    const QString name = QString::fromStdString(check.name);
    if (name == QLatin1String("answers-while-busy")) {
      return tr("The control answers the client while blocks wait to be executed.");
    }
    if (name == QLatin1String("main-run-seen-by-client")) {
      return tr("What a synchronized action writes reaches the client.");
    }
    if (name == QLatin1String("main-run-seen-by-program")) {
      return tr("What a synchronized action writes reaches the program without a stop.");
    }
    if (name == QLatin1String("action-with-its-block")) {
      return tr("A synchronized action before a block is executed with that block.");
    }
    if (name == QLatin1String("buffer-level")) {
      return tr("The program can tell, without a stop, whether blocks are waiting ($AC_IPO_BUF).");
    }
    return QString::fromStdString(check.message);
  }
};

struct MoveTexts {
  Q_DECLARE_TR_FUNCTIONS(MoveTexts)
};

QString moveText(const AirMove& move) {
  return MoveTexts::tr("%1 moved by %2 at %3")
      .arg(QLatin1Char(base::kAxisNames[static_cast<std::size_t>(move.axis)]))
      .arg(lengthText(move.mm, 1), feedText(base::mmPerSFromMmPerMin(move.feedMmPerMin)));
}

/// The sentence of a check, by its name; a check that fails adds what the test saw.
template <class Texts, std::size_t size>
QString checkText(const std::array<std::pair<const char*, const char*>, size>& said,
                  const CommissioningCheck& check) {
  for (const auto& [name, sentence] : said) {
    if (check.name == name) {
      return check.passed
                 ? Texts::tr(sentence)
                 : Texts::tr(sentence) + QLatin1Char(' ') + QString::fromStdString(check.message);
    }
  }
  return QString::fromStdString(check.message);
}

class FeedTestTexts final : public ControlTestTexts {
  Q_DECLARE_TR_FUNCTIONS(FeedTestTexts)

 public:
  static QString figures(const streaming::FeedCommissioning& result) {
    if (!result.move) {
      return tr("no axis was moved");
    }
    const QString lift =
        result.provedLiftMm() > 0.0
            ? tr("; the tool may be lifted by %1").arg(lengthText(result.provedLiftMm(), 1))
            : QString();
    return moveText(*result.move) +
           tr("; held, it was seen to stand after %1").arg(millisecondsText(result.braking)) + lift;
  }

 private:
  [[nodiscard]] int cells() const override { return streaming::kFeedTestCells; }
  [[nodiscard]] bool mayMove() const override { return true; }
  [[nodiscard]] QString what() const override {
    return tr(
        "Stop, pause and override act at once because the control obeys an R-parameter in every "
        "interpolation cycle. This test finds out whether it does: first without motion, then, if "
        "you agree, with one axis that moves back and forth in the air and is held on its way. "
        "The channel must be in reset.");
  }
  [[nodiscard]] QString program(int firstCell, const std::optional<AirMove>& move) const override {
    streaming::FeedTestPlan plan;
    plan.firstCell = firstCell;
    plan.move = move;
    return QString::fromStdString(streaming::feedTestProgram(plan));
  }
  [[nodiscard]] QString fileName() const override {
    return QString::fromStdString(streaming::feedTestFileName());
  }
  [[nodiscard]] QString lastStep(const std::optional<AirMove>& move) const override {
    return move && move->liftMm > 0.0
               ? tr("4. The override is changed while the axis moves; held, the tool goes up and "
                    "comes back, twice. Then press cycle start once more: the next program must "
                    "move at its own feed, and only the control can stop it.")
           : move
               ? tr("4. The override is changed while the axis moves. Then press cycle start once "
                    "more: the next program must move at its own feed, and only the control can "
                    "stop it.")
               : tr("4. The override is changed; no axis moves.");
  }
  [[nodiscard]] QString notTested() const override {
    return tr("Not tested: on this control a stop is sure to act only before the next window");
  }
  [[nodiscard]] QString enough() const override {
    return tr("Passed: stop, pause and override act at once on this control");
  }
  [[nodiscard]] QString notEnough() const override {
    return tr("Passed without motion. Whether the axes obey shows only when one moves.");
  }
  [[nodiscard]] QString failed() const override {
    return tr("Not passed: on this control a stop is sure to act only before the next window");
  }
  [[nodiscard]] QString check(const CommissioningCheck& check) const override {
    static const std::array<std::pair<const char*, const char*>, 15> kSaid{{
        {"actions-follow",
         QT_TR_NOOP("Synchronized actions make the override that is wanted, and keep it.")},
        {"silence-holds", QT_TR_NOOP("Without a sign of the client the override is 0.")},
        {"path-at-half-feed", QT_TR_NOOP("At 50 % the axis takes twice as long.")},
        {"path-held", QT_TR_NOOP("At 0 % the axis stands on its way.")},
        {"held-at-once", QT_TR_NOOP("It brakes at once when 0 % is wanted.")},
        {"stays-held", QT_TR_NOOP("It moves in no interpolation cycle while it is held.")},
        {"ends-with-program", QT_TR_NOOP("The synchronized actions end with their program.")},
        {"taken-back", QT_TR_NOOP("The next program moves at its own feed.")},
        {"overlay-fits", QT_TR_NOOP("The control allows the overlay of Z that the lift needs.")},
        {"lift-bounds", QT_TR_NOOP("Nothing but 0 to the lift moves the tool.")},
        {"lifts", QT_TR_NOOP("The tool is lifted while the axis is held.")},
        {"stands-lifted", QT_TR_NOOP("The axis stands while the tool is lifted.")},
        {"lowers", QT_TR_NOOP("The tool comes back to its path.")},
        {"waits-for-tool", QT_TR_NOOP("Let go, the axis moves only when the tool is back.")},
        {"only-this-client", QT_TR_NOOP("No other client writes the override of this test.")},
    }};
    return checkText<FeedTestTexts>(kSaid, check);
  }
};

class JobTestTexts final : public ControlTestTexts {
  Q_DECLARE_TR_FUNCTIONS(JobTestTexts)

 public:
  static QString figures(const streaming::JobCommissioning& result) {
    return moveText(result.move);
  }

 private:
  [[nodiscard]] int cells() const override { return streaming::kJobTestCells; }
  [[nodiscard]] bool mayMove() const override { return true; }
  [[nodiscard]] bool isOfJobs() const override { return true; }
  [[nodiscard]] QString what() const override {
    return tr(
        "In a whole job the control executes blocks of its own between stretches that Rivulet "
        "streams. This test finds out whether it does that once, in order and only when it may, "
        "and whether stop, pause and a lost connection act in both: one axis moves back and forth "
        "in the air. Enter the blocks that your jobs have, one a line, each so that nothing is in "
        "its way; other kinds are not released. The channel must be in reset.");
  }
  [[nodiscard]] QString program(int /*firstCell*/,
                                const std::optional<AirMove>& /*move*/) const override {
    return {};
  }
  [[nodiscard]] QString fileName() const override {
    return QString::fromStdString(streaming::jobTestName());
  }
  [[nodiscard]] QString lastStep(const std::optional<AirMove>& /*move*/) const override {
    return tr("4. The job is stopped and left alone, in a block and in a stretch, then it goes "
              "through: "
              "press cycle start each time, %1 times in all.")
        .arg(streaming::kJobTestStarts);
  }
  [[nodiscard]] QString notTested() const override {
    return tr("Not tested: on a real control only the motion of a program runs");
  }
  [[nodiscard]] QString enough() const override {
    return tr("Passed: whole jobs may run on this control, with the blocks that were tried");
  }
  [[nodiscard]] QString failed() const override {
    return tr("Not passed: on a real control only the motion of a program runs");
  }
  [[nodiscard]] QString check(const CommissioningCheck& check) const override {
    static const std::array<std::pair<const char*, const char*>, 11> kSaid{{
        {"waits-for-client", QT_TR_NOOP("No block is executed before Rivulet permits it.")},
        {"waits-after-stretch",
         QT_TR_NOOP("After a stretch no block is executed before Rivulet permits it.")},
        {"stopped-in-block", QT_TR_NOOP("A stop in a block ends the job after that block.")},
        {"stopped-in-stretch", QT_TR_NOOP("A stop in a stretch ends the job there.")},
        {"silence-in-block",
         QT_TR_NOOP("In a block the axis stands when the connection is lost, and the job can be "
                    "ended.")},
        {"silence-in-stretch",
         QT_TR_NOOP("In a stretch the axis stands when the connection is lost, and the job can be "
                    "ended.")},
        {"held-in-block", QT_TR_NOOP("In a block the axis stands while it is held.")},
        {"held-in-stretch", QT_TR_NOOP("In a stretch the axis stands while it is held.")},
        {"hand-over", QT_TR_NOOP("Blocks and stretches are executed in turns, once each.")},
        {"executes-blocks", QT_TR_NOOP("No block is passed over.")},
        {"ends-with-job", QT_TR_NOOP("The override of the job ends with it.")},
    }};
    return checkText<JobTestTexts>(kSaid, check);
  }
};

template <class Texts, class Test>
ShownTest shownOf(const Test& test, bool isEnough) {
  return {test.endpoint,
          test.server,
          test.testedAtUtc,
          test.result,
          [result = test.result] { return Texts::figures(result); },
          isEnough,
          {}};
}

}  // namespace

std::unique_ptr<ControlTestTexts> creditTestTexts() {
  return std::make_unique<CreditTestTexts>();
}

std::unique_ptr<ControlTestTexts> feedTestTexts() {
  return std::make_unique<FeedTestTexts>();
}

std::unique_ptr<ControlTestTexts> jobTestTexts() {
  return std::make_unique<JobTestTexts>();
}

ShownTest shownTest(const streaming::JobTest& test) {
  ShownTest shown = shownOf<JobTestTexts>(test, test.result.passed());
  shown.tried = test.result.tried;
  return shown;
}

ShownTest shownTest(const streaming::CreditTest& test) {
  return shownOf<CreditTestTexts>(test, test.result.passed());
}

ShownTest shownTest(const streaming::FeedTest& test) {
  return shownOf<FeedTestTexts>(test, test.result.proves());
}

}  // namespace rivulet::widgets
