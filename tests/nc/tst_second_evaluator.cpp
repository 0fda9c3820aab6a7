// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The second evaluator against drawn paths, so that the two judges confirm each other, and against
// Rivulet on the programs of others. What it does not follow is counted by word.

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QtTest>

#include "evaluated_path.h"
#include "gcode/block_observer.h"
#include "gcode/program.h"
#include "spellings.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::tests;

namespace {

const QString kCorpus = QStringLiteral(RIVULET_SOURCE_DIR "/../shared/corpus/");

QString wordList(const std::map<std::string, int>& words) {
  QString text;
  for (const auto& [word, times] : words) {
    text += QStringLiteral(" %1: %2;").arg(QString::fromStdString(word)).arg(times);
  }
  return text;
}

}  // namespace

class TestSecondEvaluator : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void drawnPaths_data() {
    QTest::addColumn<int>("control");
    for (const Control control : kControls) {
      QTest::newRow(std::string(controlName(control)).c_str()) << static_cast<int>(control);
    }
  }
  void drawnPaths() {
    QFETCH(const int, control);
    constexpr std::uint64_t kCount = 600;
    Spelling spelling;
    spelling.control = static_cast<Control>(control);
    std::map<std::string, int> stopped;
    int followed = 0;
    for (std::uint64_t seed = 1; seed <= kCount; ++seed) {
      const std::vector<DrawnMove> moves = drawMoves(seed);
      std::vector<EvaluatedMove> path;
      for (const PathMove& move : pathOf(moves)) {
        EvaluatedMove& made = path.emplace_back();
        made.kind = static_cast<EvaluatedMove::Kind>(move.kind);
        made.end = {move.end.x, move.end.y, move.end.z, std::nan(""), std::nan(""), std::nan("")};
        made.centre = move.centre;
        made.axis = move.axis;
        made.sweepDeg = move.sweepDeg;
        made.feed = move.feed;
      }
      spelling.seed = seed;
      const Written written = writePath(moves, spelling);
      const Evaluation evaluation = evaluate(
          controlName(spelling.control), written.text,
          [&written](std::string_view name) -> std::optional<std::string> {
            const auto found = written.beside.find(name);
            return found == written.beside.end() ? std::nullopt : std::optional(found->second);
          });
      if (!evaluation.cannotFollow.empty()) {
        ++stopped[evaluation.cannotFollow];
        continue;
      }
      ++followed;
      const std::string difference = differenceOf(evaluation.moves, path, 1e-9);
      QVERIFY2(difference.empty(),
               ("seed " + std::to_string(seed) + ", " + difference + "\n" + written.text).c_str());
    }
    qInfo().noquote() << followed << "followed, not followed:" << wordList(stopped);
    QVERIFY(followed > static_cast<int>(kCount) / 8);
  }

  void programsOfOthers() {
    if (!QDir(kCorpus).exists()) {
      QSKIP("the collection of foreign NC programs is not beside this checkout");
    }
    std::map<std::string, int> stopped;
    QStringList differing;
    int followed = 0;
    int refused = 0;
    QDirIterator files(kCorpus, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString path = files.next();
      const QString shown = path.mid(kCorpus.size());
      QFile file(path);
      if (!isProgram(path.toStdString()) || !file.open(QIODevice::ReadOnly)) {
        continue;
      }
      const std::string text = file.readAll().toStdString();
      gcode::LoadOptions options;
      options.keepArcs = true;
      const auto program = gcode::loadProgram(path.toStdString(), options);
      if (!program || !program->isUnderstood()) {
        ++refused;
        continue;
      }
      const std::string dialect(gcode::dialectName(program->dialect));
      const Evaluation evaluation =
          evaluate(dialect == "iso" ? "fanuc" : dialect, text,
                   [&path](std::string_view name) -> std::optional<std::string> {
                     const auto found = gcode::subprogramsBeside(path.toStdString())(name);
                     return found ? std::optional(found->text) : std::nullopt;
                   });
      if (!evaluation.cannotFollow.empty()) {
        ++stopped[evaluation.cannotFollow];
        continue;
      }
      ++followed;
      const std::string difference =
          differenceOf(evaluation.moves, movesOf(program->trajectory), 1e-9);
      if (!difference.empty()) {
        differing.append(shown + QStringLiteral(" (%1): ").arg(QString::fromStdString(dialect)) +
                         QString::fromStdString(difference));
      }
    }
    qInfo().noquote() << followed << "followed," << refused
                      << "refused by Rivulet, not followed:" << wordList(stopped);
    QVERIFY2(differing.isEmpty(), qPrintable(differing.join(QLatin1Char('\n'))));
    QVERIFY(followed > 40);
  }

  /// What it does not know stops it by name.
  void unknownWords_data() {
    QTest::addColumn<QString>("control");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("word");
    QTest::newRow("cycle") << "fanuc"
                           << "G81 X1 Z-5 R2 F100"
                           << "G81";
    QTest::newRow("compensation") << "linuxcnc"
                                  << "G41 G1 X5"
                                  << "G41";
    QTest::newRow("name") << "sinumerik"
                          << "TRAORI"
                          << "TRAORI";
    QTest::newRow("variable of the control") << "fanuc"
                                             << "G1 X#5041"
                                             << "#5041";
    QTest::newRow("plain text") << "heidenhain"
                                << "PLANE RESET STAY"
                                << "PLANE";
    QTest::newRow("M function") << "grbl"
                                << "M62"
                                << "M62";
  }
  void unknownWords() {
    QFETCH(const QString, control);
    QFETCH(const QString, text);
    QFETCH(const QString, word);
    QCOMPARE(evaluate(control.toStdString(), text.toStdString()).cannotFollow, word.toStdString());
  }
};

RIVULET_TEST(TestSecondEvaluator)
#include "tst_second_evaluator.moc"
