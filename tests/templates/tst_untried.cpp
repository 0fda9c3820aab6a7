// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The programs for controls that are not here. Of their languages, as the manuals describe them, an
// interpreter of these tests knows what the programs use; a control may differ.

#include <QRegularExpression>
#include <QtTest>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/test_program.h"
#include "templates/flexible_program.h"
#include "templates/lint/lint.h"
#include "templates/method_template.h"
#include "templates/window_protocol.h"

using namespace rivulet;
using templates::CellMap;
using templates::TargetControl;
using templates::TemplateParameters;
using templates::WindowProtocol;
using templates::WindowState;

namespace {

TemplateParameters parametersFor(TargetControl target) {
  TemplateParameters parameters;
  parameters.target = target;
  parameters.pointsPerLoop = 2;
  return parameters;
}

/// The program as lines of one notation: that of the ISG kernel.
QStringList isgLinesOf(const TemplateParameters& parameters) {
  const QString text = QString::fromStdString(templates::makeProgram(parameters)->text);
  QStringList lines;
  for (QString line : text.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
    if (line.startsWith(QLatin1Char('(')) || line.startsWith(QLatin1String("//"))) {
      continue;
    }
    if (parameters.target == TargetControl::TwinCat) {
      static const QRegularExpression cell(QStringLiteral("^R([0-9]+) :="));
      static const QRegularExpression read(QStringLiteral("rGet\\(([A-Za-z]+)\\)"));
      line.remove(QLatin1Char(';')).remove(QLatin1String("! "));
      line.replace(cell, QStringLiteral("V.E.RIVULET[\\1] ="));
      line.replace(read, QStringLiteral("V.E.RIVULET[\\1]"));
      line.replace(QLatin1String(" := "), QLatin1String(" = "));
      line.remove(QLatin1Char('{')).remove(QLatin1Char('}'));
      if (line.startsWith(QLatin1String("IF ")) || line.startsWith(QLatin1String("WHILE "))) {
        line.prepend(QLatin1Char('$'));
        line.remove(QLatin1String(" THEN")).remove(QLatin1String(" DO"));
        line.replace(QLatin1String(" = "), QLatin1String(" == "));
      }
      const QMap<QString, QString> words{
          {QStringLiteral("ELSE"), QStringLiteral("$ELSE")},
          {QStringLiteral("END_IF"), QStringLiteral("$ENDIF")},
          {QStringLiteral("END_WHILE"), QStringLiteral("$ENDWHILE")},
          {QStringLiteral("sync()"), QStringLiteral("#FLUSH WAIT")},
          {QStringLiteral("G04 X0.02"), QStringLiteral("#TIME 0.02")}};
      line = words.value(line, line);
      if (line.isEmpty() || line == QStringLiteral("VAR") || line == QStringLiteral("END_VAR") ||
          line.contains(QLatin1String(" : ")) || line.startsWith(QLatin1String("unit"))) {
        continue;
      }
    }
    lines << line;
  }
  return lines;
}

/// Executes such lines. The client acts while the axes stand.
class Interpreter {
 public:
  using Client = std::function<void(std::map<int, double>& cells, int pass)>;

  explicit Interpreter(QStringList lines) : m_lines(std::move(lines)) {}

  /// @return false: it did not end, or it does not know a line
  bool run(const Client& client) {
    std::vector<qsizetype> loops;
    int passes = 0;
    for (qsizetype at = 0; at < m_lines.size(); ++at) {
      const QString& line = m_lines[at];
      if (line == QStringLiteral("#FLUSH WAIT")) {
        client(cells, passes++);
        if (passes > 5000) {
          return false;
        }
      } else if (line.startsWith(QLatin1String("$WHILE "))) {
        if (holds(line.mid(7))) {
          loops.push_back(at);
        } else {
          at = endOf(at, QStringLiteral("$WHILE"), QStringLiteral("$ENDWHILE"), false);
        }
      } else if (line == QStringLiteral("$ENDWHILE")) {
        at = loops.back() - 1;
        loops.pop_back();
      } else if (line.startsWith(QLatin1String("$IF "))) {
        if (!holds(line.mid(4))) {
          at = endOf(at, QStringLiteral("$IF"), QStringLiteral("$ENDIF"), true);
        }
      } else if (line == QStringLiteral("$ELSE")) {
        at = endOf(at, QStringLiteral("$IF"), QStringLiteral("$ENDIF"), false);
      } else if (line.startsWith(QLatin1String("G01 "))) {
        move(line.mid(4));
      } else if (line.contains(QLatin1String(" = "))) {
        assign(line);
      } else if (line == QStringLiteral("M30")) {
        return loops.empty();
      } else if (line != QStringLiteral("$ENDIF") && line != QStringLiteral("#TIME 0.02") &&
                 !line.startsWith(QLatin1String("G90"))) {
        qWarning("not known: %s", qPrintable(line));
        return false;
      }
    }
    return false;
  }

  std::map<int, double> cells;
  std::vector<std::map<char, double>> moves;

 private:
  [[nodiscard]] double value(const QString& word) {
    bool isNumber = false;
    const double number = word.toDouble(&isNumber);
    if (isNumber) {
      return number;
    }
    if (word.startsWith(QLatin1String("V.E.RIVULET["))) {
      return cells[cellOf(word)];
    }
    return m_variables[word];
  }
  [[nodiscard]] int cellOf(const QString& word) {
    return static_cast<int>(value(word.mid(12, word.size() - 13)));
  }
  /// Sums, differences and products, from left to right; products first.
  [[nodiscard]] double evaluate(const QString& expression) {
    const QStringList words = expression.split(QLatin1Char(' '));
    double sum = 0.0;
    double product = value(words[0]);
    double sign = 1.0;
    for (qsizetype i = 1; i + 1 < words.size(); i += 2) {
      if (words[i] == QStringLiteral("*")) {
        product *= value(words[i + 1]);
      } else {
        sum += sign * product;
        sign = words[i] == QStringLiteral("-") ? -1.0 : 1.0;
        product = value(words[i + 1]);
      }
    }
    return sum + sign * product;
  }
  [[nodiscard]] bool holds(const QString& condition) {
    const QStringList words = condition.split(QLatin1Char(' '));
    const double left = value(words[0]);
    const double right = value(words[2]);
    return words[1] == QStringLiteral(">")   ? left > right
           : words[1] == QStringLiteral("<") ? left < right
                                             : left == right;
  }
  void assign(const QString& line) {
    const QString target = line.section(QStringLiteral(" = "), 0, 0);
    const double result = evaluate(line.section(QStringLiteral(" = "), 1));
    if (target.startsWith(QLatin1String("V.E.RIVULET["))) {
      cells[cellOf(target)] = result;
    } else {
      m_variables[target] = result;
    }
  }
  void move(const QString& words) {
    std::map<char, double> to;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
      to[word[0].toLatin1()] = value(word.mid(1));
    }
    moves.push_back(to);
  }
  [[nodiscard]] qsizetype endOf(qsizetype at, const QString& begin, const QString& end,
                                bool stopsAtElse) const {
    int depth = 1;
    for (++at; at < m_lines.size(); ++at) {
      depth += m_lines[at].startsWith(begin + QLatin1Char(' ')) ? 1 : m_lines[at] == end ? -1 : 0;
      if (depth == 0 || (stopsAtElse && depth == 1 && m_lines[at] == QStringLiteral("$ELSE"))) {
        break;
      }
    }
    return at;
  }

  QStringList m_lines;
  std::map<QString, double> m_variables;
};

/// Writes a window as the client does: its number last.
void deliver(std::map<int, double>& cells, const CellMap& map, int number, int count,
             const std::vector<double>& values, double error = 0.0) {
  const int window = (number - 1) % map.windows;
  const double feed = 600.0;
  double check = 5.0 + WindowProtocol::kCheckNumber * number + WindowProtocol::kCheckCount * count +
                 WindowProtocol::kCheckFeed * feed + error;
  int place = 0;
  for (int slot = 0; slot < map.pointsPerLoop; ++slot) {
    for (const int cell : map.slotCells(window * map.pointsPerLoop + slot)) {
      const auto index = static_cast<std::size_t>(place);
      cells[cell] = index < values.size() ? values[index] : 0.0;
      check += WindowProtocol::checkFactor(place++) * cells[cell];
    }
  }
  cells[map.windowCount(window)] = count;
  cells[map.windowFeed(window)] = feed;
  cells[map.windowCheck(window)] = check;
  cells[map.delivered] = number;
}

}  // namespace

class TestUntried : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void targets() {
    QTest::addColumn<TargetControl>("target");
    QTest::newRow("twincat") << TargetControl::TwinCat;
    QTest::newRow("isg") << TargetControl::Isg;
  }

  void sayThatTheyAreUntried_data() { targets(); }
  void sayThatTheyAreUntried() {
    QFETCH(const TargetControl, target);
    const auto program = templates::makeProgram(parametersFor(target));
    QVERIFY(program);
    QVERIFY(
        QString::fromStdString(program->text).section(QLatin1Char('\n'), 0, 0).contains("UNTRIED"));
    QVERIFY(!templates::isTried(target));
    const auto sound = templates::requireSound(*program);
    QVERIFY(!sound && sound.error().code == templates::TemplateError::NotOnTarget);
    QVERIFY(templates::targetFromName(templates::targetName(target)) == target);
    QVERIFY(templates::requireTried(TargetControl::LinuxCnc));
  }

  void windowsAreExecutedInTurn_data() { targets(); }
  void windowsAreExecutedInTurn() {
    QFETCH(const TargetControl, target);
    const TemplateParameters parameters = parametersFor(target);
    const CellMap map = *templates::planCells(parameters);
    Interpreter control(isgLinesOf(parameters));
    const bool ended = control.run([&](std::map<int, double>& cells, int pass) {
      if (pass == 3) {
        QCOMPARE(cells[map.layout],
                 static_cast<double>(templates::makeProgram(parameters)->layoutNumber));
        cells[map.client] = 5.0;
      } else if (pass == 6) {
        QCOMPARE(cells[map.owner], 5.0);
        cells[map.client] = 6.0;  // comes too late
        deliver(cells, map, 1, 2, {1, 2, 3, 4, 5, 6});
        deliver(cells, map, 2, 2, {7, 8, 9, 10, 11, 12});
      } else if (pass == 8) {
        QCOMPARE(cells[map.latched], 0.0);
        cells[map.run] = WindowProtocol::kRun;
      } else if (pass == 12) {
        QCOMPARE(cells[map.executed], 2.0);
        deliver(cells, map, 3, -1, {13, 14, 15});
      }
    });
    QVERIFY(ended);
    QCOMPARE(control.moves.size(), std::size_t{5});
    for (std::size_t i = 0; i < control.moves.size(); ++i) {
      const double first = 1.0 + 3.0 * static_cast<double>(i);
      const std::map<char, double> expected{
          {'X', first}, {'Y', first + 1.0}, {'Z', first + 2.0}, {'F', 600.0}};
      QVERIFY(control.moves[i] == expected);
    }
    QCOMPARE(control.cells[map.owner], 5.0);
    QCOMPARE(control.cells[map.executed], 3.0);
    QCOMPARE(control.cells[map.state], static_cast<double>(WindowState::Done));
  }

  void aDamagedWindowIsNotExecuted_data() { targets(); }
  void aDamagedWindowIsNotExecuted() {
    QFETCH(const TargetControl, target);
    for (const double error : {0.01, -0.01, std::nan("")}) {
      const TemplateParameters parameters = parametersFor(target);
      const CellMap map = *templates::planCells(parameters);
      Interpreter control(isgLinesOf(parameters));
      QVERIFY(control.run([&](std::map<int, double>& cells, int pass) {
        cells[map.client] = 5.0;
        cells[map.run] = WindowProtocol::kRun;
        if (pass == 4) {
          deliver(cells, map, 1, 2, {1, 2, 3, 4, 5, 6}, error);
        }
      }));
      QVERIFY(control.moves.empty());
      QCOMPARE(control.cells[map.executed], 0.0);
      QCOMPARE(control.cells[map.state], static_cast<double>(WindowState::Damaged));
    }
  }

  void theClientEndsIt_data() { targets(); }
  void theClientEndsIt() {
    QFETCH(const TargetControl, target);
    const TemplateParameters parameters = parametersFor(target);
    const CellMap map = *templates::planCells(parameters);
    Interpreter control(isgLinesOf(parameters));
    QVERIFY(control.run([&](std::map<int, double>& cells, int pass) {
      cells[map.client] = 5.0;
      cells[map.run] = pass < 5 ? WindowProtocol::kRun : WindowProtocol::kEnd;
      if (pass == 5) {
        deliver(cells, map, 1, 2, {1, 2, 3, 4, 5, 6});
      }
    }));
    QVERIFY(control.moves.empty());
    QCOMPARE(control.cells[map.state], static_cast<double>(WindowState::Stopped));
  }

  void aSilentClientEndsIt_data() { targets(); }
  void aSilentClientEndsIt() {
    QFETCH(const TargetControl, target);
    const TemplateParameters parameters = parametersFor(target);
    const CellMap map = *templates::planCells(parameters);
    Interpreter control(isgLinesOf(parameters));
    int last = 0;
    QVERIFY(control.run([&](std::map<int, double>& cells, int pass) {
      last = pass;
      if (pass <= 2000) {
        cells[map.heartbeat] = pass;
      }
    }));
    QVERIFY2(last > 2900 && last < 3100, qPrintable(QString::number(last)));
    QCOMPARE(control.cells[map.state], static_cast<double>(WindowState::Abandoned));
  }

  void twinCatHasNoMoreCells() {
    TemplateParameters parameters = parametersFor(TargetControl::TwinCat);
    parameters.rParameterCount = 2000;
    parameters.pointsPerLoop = 100;
    parameters.windows = 4;
    const auto cells = templates::planCells(parameters);
    QVERIFY(!cells && cells.error().code == templates::TemplateError::DoesNotFit);
    parameters.windows = 2;
    QVERIFY(templates::planCells(parameters));
  }
};

RIVULET_TEST(TestUntried)
#include "tst_untried.moc"
