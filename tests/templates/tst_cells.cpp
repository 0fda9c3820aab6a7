// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>
#include <set>

#include "support/test_program.h"
#include "templates/cells.h"
#include "templates/flexible_program.h"
#include "templates/method_template.h"

using namespace rivulet;
using base::MethodKind;
using templates::Layout;
using templates::SignalStop;
using templates::TemplateError;
using templates::TemplateParameters;

namespace {

/// All combinations of method, layout, signal stop and axes; N is left to the caller.
std::vector<TemplateParameters> variants() {
  std::vector<TemplateParameters> all;
  for (const MethodKind method : base::kPaperMethods) {
    for (const Layout layout : {Layout::Paper, Layout::Contiguous}) {
      for (const SignalStop stop : {SignalStop::EachSignal, SignalStop::OncePerLoop}) {
        if (method == MethodKind::Position && stop == SignalStop::OncePerLoop) {
          continue;  // the setting has no meaning there
        }
        for (unsigned axes = 1; axes < 8; ++axes) {
          TemplateParameters parameters;
          parameters.method = method;
          parameters.layout = layout;
          parameters.signalStop = stop;
          parameters.axes = {(axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0};
          all.push_back(parameters);
        }
      }
    }
  }
  return all;
}

TemplateParameters signal() {
  TemplateParameters parameters;
  parameters.method = MethodKind::Signal;
  return parameters;
}

TemplateParameters window() {
  TemplateParameters parameters;
  parameters.method = MethodKind::Window;
  return parameters;
}

TemplateParameters credit() {
  TemplateParameters parameters;
  parameters.method = MethodKind::Credit;
  return parameters;
}

}  // namespace

class TestCells : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void paperLayoutIsThatOfThePaper() {
    const auto cells = templates::planCells(signal());
    QVERIFY(cells.has_value());
    QCOMPARE(cells->slotCells(0), (std::vector<int>{11, 12, 13}));
    QCOMPARE(cells->slotCells(1), (std::vector<int>{21, 22, 23}));
    QCOMPARE(cells->slotCells(6), (std::vector<int>{71, 72, 73}));
    QCOMPARE(cells->last(), 73);
  }

  void paperLayoutKeepsThePlaceOfAnAxis() {
    TemplateParameters parameters = signal();
    parameters.axes = {true, false, true};
    const auto cells = templates::planCells(parameters);
    QVERIFY(cells.has_value());
    QCOMPARE(cells->slotCells(1), (std::vector<int>{21, 23}));
  }

  /// Five cells per point, in the order X Y Z A B C; the check number has a factor for each.
  void rotaryAxesFollowTheOthers() {
    TemplateParameters parameters = window();
    QVERIFY(templates::chooseAxes(parameters, "CAXYZ"));
    QCOMPARE(templates::axisLetters(parameters), std::string("XYZAC"));
    parameters.pointsPerLoop = 3;
    const auto cells = templates::planCells(parameters);
    QVERIFY(cells.has_value());
    QCOMPARE(cells->slotCells(0), (std::vector<int>{15, 16, 17, 18, 19}));
    QCOMPARE(cells->slotCells(1), (std::vector<int>{20, 21, 22, 23, 24}));
    QCOMPARE(cells->windowStride, 3 + 5 * 3);
    const auto program = templates::makeProgram(parameters);
    QVERIFY(program.has_value());
    QVERIFY(
        program->text.find("G1 X=RIV_C[0] Y=RIV_C[1] Z=RIV_C[2] A=RIV_C[3] C=RIV_C[4] F=RIV_F") !=
        std::string::npos);
    for (int number = 0; number < 15; ++number) {
      QVERIFY(program->text.find("*RIV_C[" + std::to_string(number) + "]") != std::string::npos);
    }
    QVERIFY(templates::chooseAxes(parameters, "A"));
    QCOMPARE(templates::planCells(parameters)->slotCells(1), std::vector<int>{16});
  }

  void rotaryAxesAreRefusedWhereTheyCannotBe() {
    TemplateParameters parameters = window();
    for (const char* letters : {"XQ", "xyz", "XX", "AA", "X Y"}) {
      const auto chosen = templates::chooseAxes(parameters, letters);
      QVERIFY(!chosen && chosen.error().code == TemplateError::BadAxes);
      QCOMPARE(templates::axisLetters(parameters), std::string("XYZ"));
    }
    QVERIFY(templates::chooseAxes(parameters, "XYZABC"));
    QVERIFY(templates::planCells(parameters).error().code == TemplateError::TooManyAxes);
    QVERIFY(templates::chooseAxes(parameters, "XYZB"));
    for (const MethodKind method : base::kPaperMethods) {
      parameters.method = method;
      QVERIFY(templates::planCells(parameters).error().code == TemplateError::RotaryNeedsWindow);
    }
  }

  void contiguousLayoutHasNoGaps() {
    for (TemplateParameters parameters : variants()) {
      parameters.layout = Layout::Contiguous;
      const auto cells = templates::planCells(parameters);
      QVERIFY(cells.has_value());
      int next = 10;
      for (int slot = 0; slot < parameters.pointsPerLoop; ++slot) {
        for (const int cell : cells->slotCells(slot)) {
          QCOMPARE(cell, next++);
        }
      }
      QCOMPARE(cells->last(), next - 1);
    }
  }

  void noCellIsUsedTwice() {
    for (TemplateParameters parameters : variants()) {
      const auto cells = templates::planCells(parameters);
      QVERIFY(cells.has_value());
      std::set<int> used{cells->signal, cells->run, cells->stop, cells->feed, cells->layout};
      QCOMPARE(used.size(), std::size_t{5});
      for (int slot = 0; slot < parameters.pointsPerLoop; ++slot) {
        for (const int cell : cells->slotCells(slot)) {
          QVERIFY(used.insert(cell).second);
          QVERIFY(cell < parameters.rParameterCount);
        }
      }
      QCOMPARE(*used.rbegin(), cells->last());
    }
  }

  /// Everything a window carries lies in one run of cells: one array node can take it.
  void windowsAreContiguous() {
    for (unsigned axes = 1; axes < 8; ++axes) {
      for (const int windows : {1, 2, 5}) {
        TemplateParameters parameters = window();
        parameters.axes = {(axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0};
        parameters.windows = windows;
        parameters.baseCell = 20;
        parameters.rParameterCount = 400;
        const auto cells = templates::planCells(parameters);
        QVERIFY(cells.has_value());
        std::set<int> used{
            cells->run,       cells->delivered,      cells->latched,     cells->layout,
            cells->executed,  cells->state,          cells->client,      cells->owner,
            cells->heartbeat, cells->overrideWanted, cells->overrideActs};
        QCOMPARE(used.size(), std::size_t{11});
        QVERIFY(*used.begin() == 20 && *used.rbegin() < 32);
        int next = 32;
        for (int number = 0; number < windows; ++number) {
          QCOMPARE(cells->windowCount(number), next++);
          QCOMPARE(cells->windowFeed(number), next++);
          QCOMPARE(cells->windowCheck(number), next++);
          for (int place = 0; place < parameters.pointsPerLoop; ++place) {
            for (const int cell : cells->slotCells(number * parameters.pointsPerLoop + place)) {
              QCOMPARE(cell, next++);
            }
          }
        }
        QCOMPARE(cells->last(), next - 1);
        // The factor of the override is behind all others, which stay where they are.
        parameters.factorLeast = 0.2;
        parameters.factorMost = 1.2;
        const auto adaptive = templates::planCells(parameters);
        QVERIFY(adaptive.has_value() && !cells->hasFactor());
        QCOMPARE(adaptive->factor, next);
        QCOMPARE(adaptive->last(), next);
      }
    }
  }

  void boundsOfTheFactor() {
    for (const auto& [least, most] : {std::pair{0.2, 1.2}, {1.0, 1.0}, {0.01, 2.0}}) {
      TemplateParameters parameters = window();
      parameters.factorLeast = least;
      parameters.factorMost = most;
      QVERIFY(templates::planCells(parameters).has_value());
    }
    for (const auto& [least, most] : {std::pair{0.0, 1.2},
                                      {0.2, 0.9},
                                      {1.1, 1.2},
                                      {0.2, 2.1},
                                      {-1.0, 1.0},
                                      {1.2, 0.2},
                                      {std::nan(""), 1.2},
                                      {0.2, std::nan("")},
                                      {0.2, HUGE_VAL}}) {
      TemplateParameters parameters = window();
      parameters.factorLeast = least;
      parameters.factorMost = most;
      const auto cells = templates::planCells(parameters);
      QVERIFY(!cells && cells.error().code == TemplateError::BadFactor);
    }
  }

  /// The factors are apart by more than the tolerance of the check leaves open, and print exactly.
  void checkFactorsAreDistinct() {
    std::set<double> seen;
    for (int place = 0; place < 3000; ++place) {
      const double factor = templates::WindowProtocol::checkFactor(place);
      QVERIFY(factor >= 1.0 && factor < 2.0);
      QCOMPARE(QString::number(factor, 'f', 6).toDouble(), factor);
      seen.insert(factor);
    }
    QCOMPARE(seen.size(), std::size_t{3000});
  }

  void badWindowCellsAreRefused() {
    for (const int windows : {0, -1, 9}) {
      TemplateParameters parameters = window();
      parameters.windows = windows;
      QVERIFY(templates::planCells(parameters).error().code == TemplateError::BadCells);
    }
    for (const int base : {-1, 2'000'000'000}) {
      TemplateParameters parameters = window();
      parameters.baseCell = base;
      QVERIFY(templates::planCells(parameters).error().code == TemplateError::BadCells);
    }
    for (const int stride : {-1, 2, 101}) {
      TemplateParameters parameters = window();
      parameters.slotStride = stride;
      QVERIFY(templates::planCells(parameters).error().code == TemplateError::BadCells);
    }
  }

  void whatFitsFitsAndOneMoreDoesNot() {
    std::vector<TemplateParameters> all = variants();
    for (const int windows : {1, 2, 3}) {
      for (const int base : {0, 30}) {
        for (const int stride : {0, 7}) {
          all.push_back(window());
          all.back().windows = windows;
          all.back().baseCell = base;
          all.back().slotStride = stride;
        }
      }
    }
    for (TemplateParameters parameters : all) {
      for (const int count : {5, 12, 13, 14, 15, 25, 99, 100, 999, 1000, 5000}) {
        parameters.rParameterCount = count;
        const int max = templates::pointsPerLoopMax(parameters);
        const int min = parameters.method == MethodKind::Signal ? 2 : 1;
        for (int n = min; n <= max; n += std::max(1, max / 7)) {
          parameters.pointsPerLoop = n;
          QVERIFY(templates::planCells(parameters).has_value());
        }
        if (max > 0) {
          parameters.pointsPerLoop = max;
          QVERIFY(templates::planCells(parameters).has_value());
        }
        parameters.pointsPerLoop = std::max(min, max + 1);
        const auto refused = templates::planCells(parameters);
        QVERIFY(!refused);
        QVERIFY(refused.error().code == TemplateError::DoesNotFit);
        // The value of MD28050 that the message names is enough, and one less is not.
        const std::string& message = refused.error().message;
        const std::size_t at = message.find("MD28050 to ");
        QVERIFY(at != std::string::npos);
        parameters.rParameterCount = std::stoi(message.substr(at + 11));
        QVERIFY(templates::planCells(parameters).has_value());
        --parameters.rParameterCount;
        QVERIFY(!templates::planCells(parameters));
      }
    }
  }

  void refusalSaysWhatToDo() {
    TemplateParameters parameters = signal();
    parameters.pointsPerLoop = 12;
    const auto refused = templates::planCells(parameters);
    QVERIFY(!refused);
    QCOMPARE(refused.error().message,
             std::string("N = 12 needs R-parameters up to R123, but the control has 100: N = 9 is "
                         "the largest that fits, or set MD28050 to 124."));
    parameters.pointsPerLoop = 2'000'000'000;
    QVERIFY(!templates::planCells(parameters));
  }

  void refusesTooFewPointsAndNoAxis() {
    TemplateParameters parameters = signal();
    for (const int n : {1, 0, -3}) {
      parameters.pointsPerLoop = n;
      const auto refused = templates::planCells(parameters);
      QVERIFY(!refused);
      QVERIFY(refused.error().code == TemplateError::TooFewPointsPerLoop);
    }
    parameters.pointsPerLoop = 1;
    parameters.method = MethodKind::Position;
    QVERIFY(templates::planCells(parameters).has_value());
    parameters.axes = {false, false, false};
    const auto refused = templates::planCells(parameters);
    QVERIFY(!refused);
    QVERIFY(refused.error().code == TemplateError::NoAxis);
    QCOMPARE(templates::pointsPerLoopMax(parameters), 0);
  }

  /// A client never drives a program with another meaning: whatever is changed, the number changes.
  void layoutNumbersTellProgramsApart() {
    std::set<int> seen;
    std::size_t count = 0;
    const auto add = [&](const TemplateParameters& parameters) {
      if (!templates::planCells(parameters)) {
        return;
      }
      const int number = templates::makeProgram(parameters)->layoutNumber;
      QVERIFY(number > 0 && number < (1 << 24));
      QCOMPARE(number, static_cast<int>(static_cast<float>(number)));  // survives 32-bit cells
      seen.insert(number);
      ++count;
    };
    for (TemplateParameters parameters : variants()) {
      for (parameters.pointsPerLoop = 1; parameters.pointsPerLoop < 9; ++parameters.pointsPerLoop) {
        add(parameters);
      }
    }
    for (TemplateParameters parameters : {window(), credit()}) {
      for (const double limitMm : {0.0, 0.01, 0.02, 0.1, 1.0}) {
        parameters.correctionLimitMm = limitMm;
        for (parameters.windows = 1; parameters.windows <= 4; ++parameters.windows) {
          for (parameters.pointsPerLoop = 1; parameters.pointsPerLoop < 6;
               ++parameters.pointsPerLoop) {
            add(parameters);
          }
        }
      }
    }
    for (unsigned axes = 1; axes < 64; ++axes) {
      TemplateParameters parameters = window();
      parameters.axes = {(axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0};
      parameters.rotaryAxes = {(axes & 8) != 0, (axes & 16) != 0, (axes & 32) != 0};
      add(parameters);
    }
    for (int ahead = 1; ahead <= 8; ++ahead) {
      TemplateParameters parameters = credit();
      parameters.pointsPerLoop = 3;
      parameters.windowsAhead = ahead;
      parameters.slowDown = false;
      add(parameters);
    }
    for (const int cell : {1, 2, 20}) {
      TemplateParameters parameters = window();
      parameters.pointsPerLoop = 6;
      parameters.baseCell = cell;
      add(parameters);
    }
    QVERIFY(count > 300);
    // It is a hash of 24 bits: among so many, two that are the same are expected in one of a
    // hundred sets.
    QCOMPARE(seen.size(), count);
  }

  void correctionHasCellsBehindTheSlots() {
    TemplateParameters parameters = window();
    const int last = templates::planCells(parameters)->last();
    QVERIFY(!templates::planCells(parameters)->corrects());
    parameters.correctionLimitMm = 0.05;
    const auto cells = templates::planCells(parameters);
    QVERIFY(cells && cells->corrects());
    QCOMPARE(cells->correction, (std::array{last + 1, last + 2, last + 3}));
    QCOMPARE(cells->last(), last + 3);
    parameters.axes = {true, false, true};
    const auto xz = templates::planCells(parameters);
    QCOMPARE(xz->correction[1], -1);
    QCOMPARE(xz->correction[2], xz->correction[0] + 1);
    QCOMPARE(xz->last(), xz->correction[2]);
    // The largest N leaves room for them, and no more.
    for (const int stride : {0, 5}) {
      for (int count = 30; count < 120; ++count) {
        parameters.slotStride = stride;
        parameters.rParameterCount = count;
        parameters.pointsPerLoop = templates::pointsPerLoopMax(parameters);
        QVERIFY(parameters.pointsPerLoop == 0 || templates::planCells(parameters));
        ++parameters.pointsPerLoop;
        QVERIFY(!templates::planCells(parameters));
      }
    }
  }

  void correctionIsRefused_data() {
    QTest::addColumn<TemplateParameters>("parameters");
    for (const double limitMm : {-0.1, 0.0001, 1.001, 1e300, std::nan("")}) {
      TemplateParameters parameters = window();
      parameters.correctionLimitMm = limitMm;
      QTest::addRow("%g mm", limitMm) << parameters;
    }
    TemplateParameters other = signal();
    other.correctionLimitMm = 0.1;
    QTest::newRow("method signal") << other;
    TemplateParameters rotary = window();
    rotary.correctionLimitMm = 0.1;
    rotary.axes = {false, false, false};
    rotary.rotaryAxes = {true, false, false};
    QTest::newRow("no linear axis") << rotary;
  }
  void correctionIsRefused() {
    QFETCH(TemplateParameters, parameters);
    const auto refused = templates::planCells(parameters);
    QVERIFY(!refused && refused.error().code == TemplateError::BadCorrection);
  }

  /// The number is of the text that runs: what does not change the text does not change it.
  void layoutNumberIsOfTheText() {
    const int number = templates::makeProgram(signal())->layoutNumber;
    TemplateParameters other = signal();
    other.rParameterCount = 500;
    QCOMPARE(templates::makeProgram(other)->layoutNumber, number);
    other.windows = 5;  // without meaning for method signal
    QCOMPARE(templates::makeProgram(other)->layoutNumber, number);
    other.method = MethodKind::Position;
    const int position = templates::makeProgram(other)->layoutNumber;
    QVERIFY(position != number);
    other.signalStop = SignalStop::OncePerLoop;  // without meaning for method position
    QCOMPARE(templates::makeProgram(other)->layoutNumber, position);
    other.pointsPerLoop = 0;  // no program
    QVERIFY(!templates::makeProgram(other));
  }

  void layoutNames() {
    for (const Layout layout : {Layout::Paper, Layout::Contiguous}) {
      QCOMPARE(templates::layoutFromName(templates::layoutName(layout)), std::optional(layout));
    }
    QVERIFY(!templates::layoutFromName("other"));
  }
};

RIVULET_TEST(TestCells)
#include "tst_cells.moc"
