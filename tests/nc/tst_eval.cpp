// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// What SINUMERIK and the ISO dialects compute. Where two readings were possible, the row names the
/// manual: JP06 is Siemens, Job Planning, Programming Manual 03/2006 (6FC5398-2BP10-1BA0); JP10 the
/// same of 07/2010 (6FC5398-2BP40-0BA0); PG19 is NC Programming 12/2019 (6FC5398-2EP40-0BA0);
/// PGA00 is Programming Guide Advanced 04/2000; NGC is LinuxCNC's interp_execute.cc.

#include <QtTest>

#include "base/text.h"
#include "nc/eval/variables.h"
#include "support/test_program.h"

using namespace rivulet;
using nc::Variables;

namespace {

/// One position of the main run and R0 to R3.
class Program final : public Variables {
 public:
  explicit Program(const nc::Notation& notation)
      : Variables(notation.hasNames ? nc::sinumerikSemantics() : nc::hashSemantics()),
        m_notation(notation) {}

  nc::Expected<nc::Value> system(std::string_view name,
                                 std::span<const nc::Value> indices) const override {
    if (name == "$AA_IW" && indices.size() == 1 && nc::textOf(indices[0]) == "X") {
      return 42.0;
    }
    return Variables::system(name, indices);
  }

  /// "R1=5", or why not.
  std::string assign(std::string_view text) {
    nc::Reader reader(text, m_notation);
    const auto read = reader.assignment();
    if (!read) {
      return "! " + nc::describe(read.error());
    }
    const auto done = Variables::assign(*read);
    return done ? "" : "! " + nc::describe(done.error());
  }
  std::string define(std::string_view text) {
    nc::Reader reader(text, m_notation);
    const auto read = reader.definitions();
    if (!read) {
      return "! " + nc::describe(read.error());
    }
    for (const nc::Definition& definition : *read) {
      if (const auto done = Variables::define(definition); !done) {
        return "! " + nc::describe(done.error());
      }
    }
    return "";
  }
  std::string value(std::string_view text) const {
    const auto read = nc::parseExpression(text, m_notation);
    const auto value = read ? nc::evaluate(*read, *this, semantics()) : nc::fail(read.error());
    if (!value) {
      return "! " + nc::describe(value.error());
    }
    const auto* number = std::get_if<double>(&*value);
    return number != nullptr ? base::formatFixed(*number, 9) : std::get<std::string>(*value);
  }
  /// Enters a subprogram. @param proc  "(REAL A)"  @param call  "(1)"
  std::string call(std::string_view proc, std::string_view call) {
    nc::Reader head(proc, m_notation);
    nc::Reader words(call, m_notation);
    const auto parameters = head.parameters();
    const auto arguments = words.arguments();
    if (!parameters || !arguments) {
      return "! " + nc::describe(parameters ? arguments.error() : parameters.error());
    }
    const auto scope = passed(*parameters, *arguments);
    if (!scope) {
      return "! " + nc::describe(scope.error());
    }
    enter(*scope);
    return "";
  }

 private:
  const nc::Notation& m_notation;
};

void addRow(const char* text, const char* expected) {
  QTest::newRow(text) << QByteArray(text) << QByteArray(expected);
}

}  // namespace

class TestEval : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sinumerik_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = addRow;
    // Priorities: PG19 3.1.3.3 "Priority of the operations".
    add("2+3*4-6/3", "12");
    add("20-5-3", "12");
    add("100-10*2+5", "85");
    add("(2+3)*4", "20");
    add("2*-3", "-6");
    add("--5", "5");
    add("1+1-1+-1", "0");
    add("1 B_OR 6 B_AND 4", "5");
    add("6 B_XOR 3", "5");
    add("B_NOT 0", "-1");
    add("1 OR 0 AND 0", "1");
    add("1 OR 0 == 1", "1");
    add("1+1 < 1+2", "1");
    add("NOT 0", "1");
    add("NOT 1+1", "1");
    add("7 DIV 3", "2");
    add("7 DIV 4.1", "1");
    add("-7 DIV 2", "-3");
    add("17 MOD 5", "2");
    add("-7 MOD 4", "-3");
    add("7 MOD 4.1", "2.9");
    // Relative equality of 1e-12 for all six: JP06 1.7.1 "Precision correction (TRUNC)", page 1-23.
    add("0.1+0.2 == 0.3", "1");
    add("0.1+0.2 <> 0.3", "0");
    add("0.1+0.2 > 0.3", "0");
    add("0.3 < 0.1+0.2", "0");
    add("0.1+0.2 <= 0.3", "1");
    add("0.3 >= 0.1+0.2", "1");
    add("1.000000001 > 1", "1");
    // The manual's example: without the tolerance this holds, "jump was performed previously".
    add("ABS(61.02-61.01) > 0.01", "0");
    add("TRUNC(61.02*1000)-TRUNC(61.01*1000) > TRUNC(0.01*1000)", "0");
    add("3<>3", "0");
    add("5>=5", "1");
    // Rounding up "observing the sign", with examples: JP06 1.24, page 1-70.
    add("ROUNDUP(3.1)", "4");
    add("ROUNDUP(-3.6)", "-3");
    add("ROUND(2.5)", "3");
    add("ROUND(-2.5)", "-3");
    add("TRUNC(-2.7)", "-2");
    // Above the maximum counts first: JP10 1.6 "MINVAL, MAXVAL and BOUND", page 70. What a minimum
    // above the maximum gives is not said there; the order of its sentences is kept.
    add("BOUND(2,9,11)", "9");
    add("BOUND(2,9,1)", "2");
    add("BOUND(2,9,5)", "5");
    add("BOUND(9,2,5)", "2");
    add("BOUND(9,2,1)", "9");
    add("MINVAL(3,2)+MAXVAL(3,2)", "5");
    add("SQRT(POT(3)+POT(4))", "5");
    add("ATAN2(30.5,80.1)", "20.845533927");
    add("ATAN2(30.5,-80.1)", "159.154466073");
    add("SIN(30)+COS(60)", "1");
    add("EXP(LN(5))", "5");
    add("8.2EX-3", "0.0082");
    add("2EX2", "200");
    add("'H1F'+'B101'", "36");
    add("R1+R[1+1]", "12");
    add("R[R1-3]", "7");
    // An index is rounded as any REAL that becomes INT: JP10 1.8 "Possible type conversions".
    add("R[1.4]", "5");
    add("R[1.5]", "7");
    add("F[1,2]", "7");
    add("F[0.6,2]", "7");
    add("TRUE+depth", "3.5");
    add("$PI", "3.141592654");
    add("$AA_IW[X]", "42");
    // Concatenation stands between OR and the comparisons: PG19 3.1.3.3.
    add("\"A\"<<1+1", "A2");
    add("\"A\"<<\"B\" == \"AB\"", "1");
    add("NAME == \"A, B\"", "1");
    add("\"A\"<\"B\"", "1");
    add("1/0", "! a division by zero");
    add("1 DIV 0", "! a division by zero");
    add("SQRT(-1)", "! SQRT(-1) has no value");
    add("ACOS(2)", "! ACOS(2) has no value");
    add("LN(0)", "! LN(0) has no value");
    add("EXP(1000)", "! the result is too large");
    add("R9", "! R9 is read before the program sets it: only the control knows it");
    add("R[-1]", "! R[-1] does not exist");
    add("F[2,0]", "! the index is outside the array");
    add("F[0,3]", "! the index is outside the array");
    add("F[1]", "! the array has more dimensions");
    add("F[1,1,1]", "! the array has fewer dimensions");
    add("F", "! an array needs its index in brackets");
    add("FOO", "! FOO is not defined");
    add("FOO(1)", "! FOO is neither a variable nor a function");
    add("1+", "! a value is missing");
    add("(1", "! a bracket is not closed");
    add("1 2", "! \"2\" is not understood");
    add("1EX", "! \"1EX\" is not a number");
    add("R", "! R needs a number or an index in brackets");
    add("SIN", "! SIN needs its argument in brackets");
    add("BOUND(1,2)", "! BOUND needs more arguments");
    add("NAME+1", "! a calculation uses a text");
    add("NAME == 1", "! a calculation uses a text");
    add("$P_TOOL", "! only the control knows the value of $P_TOOL");
    add("$P_EP[Y]", "! only the control knows the value of $P_EP[Y]");
  }
  void sinumerik() {
    Program program(nc::sinumerikNotation());
    QCOMPARE(program.define("REAL F[2,3], DEPTH=2.5"), "");
    QCOMPARE(program.define("STRING[8] NAME=\"A, B\""), "");
    QCOMPARE(program.assign("R1=5"), "");
    QCOMPARE(program.assign("R[2]=R1+2"), "");
    QCOMPARE(program.assign("F[1,2]=7"), "");
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(program.value(text.toStdString())), expected);
  }

  void iso_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = addRow;
    add("[#1+#<depth>*2]", "11");
    add("#[1+1]", "7");
    add("##3", "5");
    add("-#1", "-5");
    add("[2**3**2]", "64");
    add("[7 MOD 4]", "3");
    add("[-7 MOD 4]", "1");
    add("[#1EQ5]", "1");
    add("[#1 GT 5 OR #2 LE 7]", "1");
    add("[1 + 2 EQ 3]", "1");
    // Within 1e-4 for EQ NE LE GE, exact for LT and GT: NGC, execute_binary2.
    add("[1.00005 EQ 1]", "1");
    add("[1.00005 LE 1]", "1");
    add("[1.00005 GT 1]", "1");
    add("ATAN[1]/[-1]", "135");
    add("ATAN[-1]/[-1]", "-135");
    add("FIX[-2.5]+FUP[2.1]", "0");
    add("EXISTS[#<depth>]", "1");
    add("EXISTS[#<width>]", "0");
    add("#4", "0");
    add("#5220", "! only the control knows the value of #5220");
    add("#<width>", "! only the control knows the value of #<WIDTH>");
    add("[1+2", "! a bracket is not closed");
    add("#ABC", "! #ABC is not a variable");
    add("ATAN[1]", "! ATAN is written ATAN[y]/[x]");
  }
  void iso() {
    Program program(nc::hashNotation());
    for (const char* text : {"#1=5", "#2 = [#1 + 2]", "#3=1", "#<depth>=3"}) {
      QCOMPARE(program.assign(text), "");
    }
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(program.value(text.toStdString())), expected);
  }

  void readsNoFurtherThanTheExpression() {
    nc::Reader reader("R11 Y=R12", nc::sinumerikNotation());
    QVERIFY(reader.expression());
    QCOMPARE(reader.length(), std::size_t{3});
  }

  void nodesKnowTheirPlace() {
    const auto read =
        nc::parseExpression("2*(R1+FOO)", nc::sinumerikNotation(), {base::LineNumber{7}, 2, 10});
    QVERIFY(read);
    const auto value =
        nc::evaluate(*read, Program(nc::sinumerikNotation()), nc::sinumerikSemantics());
    QVERIFY(!value);
    QCOMPARE(value.error().place.line.value, 7U);
    QCOMPARE(value.error().place.file, 2);
    QCOMPARE(value.error().place.column, 13);
  }

  /// JP10 1.8 "Possible type conversions", page 73, and 1.1.14 "Data types", page 53.
  void typesConvertOnAssignment() {
    Program program(nc::sinumerikNotation());
    QCOMPARE(program.define("INT N=2.5, M[2]=SET(1.6,2.4)"), "");
    QCOMPARE(program.define("BOOL B=0.3, C"), "");
    QCOMPARE(program.define("CHAR D=\"A\""), "");
    QCOMPARE(program.define("AXIS AX=Y"), "");
    QCOMPARE(program.value("N"), "3");
    QCOMPARE(program.assign("N=-2.5"), "");
    QCOMPARE(program.value("N"), "-3");
    QCOMPARE(program.value("M[0]*10+M[1]"), "22");
    QCOMPARE(program.assign("C=5"), "");
    QCOMPARE(program.value("B*10+C"), "11");
    QCOMPARE(program.value("D"), "65");
    QCOMPARE(program.value("AX"), "Y");
    QCOMPARE(program.assign("N=3EX9"), "! the value is outside the range of type INT");
    QCOMPARE(program.assign("D=256"), "! the value is outside the range of type CHAR");
    QCOMPARE(program.assign("N=\"X\""), "! the value is not of type INT");
    QCOMPARE(program.define("FLOAT X"), "! FLOAT is not a type for DEF");
    QCOMPARE(program.define("REAL HUGE[100000,100000]"),
             "! the size of an array is missing or too large");
  }

  /// SET leaves an element alone where its list is empty, REP fills a number of elements.
  void arraysAreFilled() {
    Program program(nc::sinumerikNotation());
    const auto elements = [&program](const char* name) {
      std::string text;
      for (const nc::Value& value : program.find(name)->values) {
        text += nc::textOf(value) + " ";
      }
      return text;
    };
    QCOMPARE(program.define("REAL A[2,2]=SET(1,,3), B[3]=REP(7), C[4]=REP(7,2), D[3]=5"), "");
    QCOMPARE(elements("A"), "1 0 3 0 ");
    QCOMPARE(elements("B"), "7 7 7 ");
    QCOMPARE(elements("C"), "7 7 0 0 ");
    QCOMPARE(elements("D"), "5 0 0 ");
    QCOMPARE(program.assign("A[0,1]=SET(8,9)"), "");
    QCOMPARE(elements("A"), "1 8 9 0 ");
    QCOMPARE(program.assign("B[1]=REP(4.5)"), "");
    QCOMPARE(elements("B"), "7 4.5 4.5 ");
    QCOMPARE(program.assign("B[1]=SET(1,2,3)"),
             "! the list has more values than the array has elements");
  }

  /// What is computed from a value that failed fails as well, instead of using an older one.
  void faultsSpread() {
    Program program(nc::sinumerikNotation());
    QCOMPARE(program.define("REAL A=1"), "");
    QCOMPARE(program.assign("R1=1"), "");
    QCOMPARE(program.assign("A=1/0"), "! a division by zero");
    QCOMPARE(program.assign("R1=$P_TOOL"), "! only the control knows the value of $P_TOOL");
    QCOMPARE(program.value("A+1"), "! it needs a value that is not known");
    QCOMPARE(program.value("R1"), "! it needs a value that is not known");
    QCOMPARE(program.assign("$AA_OFF[X]=1"), "! a variable of the control would be written");
    QCOMPARE(program.assign("NEW=1"), "! NEW is not defined");
    QCOMPARE(program.assign("1=1"), "! \"1\" cannot be assigned to");
  }

  /// PG19 3.2.1.6 "Parameter transfer", page 494: what is left out is 0, commas keep the order.
  void parametersByValue() {
    Program program(nc::sinumerikNotation());
    QCOMPARE(program.define("REAL WIDTH=20"), "");
    QCOMPARE(program.call("(REAL A, INT B, REAL C=4, STRING[8] D)", "(WIDTH,,,\"T\")"), "");
    QCOMPARE(program.value("A+C+B"), "24");
    QCOMPARE(program.value("D"), "T");
    QCOMPARE(program.assign("A=1"), "");
    program.leave();
    QCOMPARE(program.value("WIDTH"), "20");
    QCOMPARE(program.call("(INT A)", "(2.6)"), "");
    QCOMPARE(program.value("A"), "3");
    QCOMPARE(program.value("WIDTH"), "! WIDTH is not defined");
    program.leave();
    QCOMPARE(program.call("(REAL A)", "(1,2)"), "! the subprogram takes 1 values");
  }

  void parametersByReference() {
    Program program(nc::sinumerikNotation());
    QCOMPARE(program.define("REAL A=1, FIELD[3]=SET(1,2,3)"), "");
    QCOMPARE(program.call("(VAR REAL B, VAR REAL G[], VAR REAL E)", "(A,FIELD,FIELD[2])"), "");
    QCOMPARE(program.assign("B=5"), "");
    QCOMPARE(program.assign("G[1]=B+G[0]"), "");
    QCOMPARE(program.assign("E=E*10"), "");
    program.leave();
    QCOMPARE(program.value("A"), "5");
    QCOMPARE(program.value("FIELD[1]"), "6");
    QCOMPARE(program.value("FIELD[2]"), "30");
    // An array by value is a copy.
    QCOMPARE(program.call("(REAL G[3])", "(FIELD)"), "");
    QCOMPARE(program.assign("G[0]=9"), "");
    program.leave();
    QCOMPARE(program.value("FIELD[0]"), "1");
    QCOMPARE(program.call("(VAR REAL B)", "(A+1)"),
             "! the parameter B is given by reference and needs a variable");
    QCOMPARE(program.call("(VAR INT B)", "(A)"),
             "! the parameter B is given by reference and needs a variable of its own type");
    QCOMPARE(program.call("(VAR REAL B)", "(FIELD)"),
             "! the parameter B is given by reference and needs a variable of its own type");
  }

  void subprogramsHaveTheirOwn() {
    Program program(nc::hashNotation());
    QCOMPARE(program.assign("#1=5"), "");
    QCOMPARE(program.assign("#<_all>=6"), "");
    nc::Scope scope;
    scope.numbers[1] = 9.0;
    program.enter(scope);
    QCOMPARE(program.value("#1"), "9");
    QCOMPARE(program.value("#<_all>"), "6");
    program.leave();
    QCOMPARE(program.value("#1"), "5");
  }

  void deepNestingIsAFault() {
    const Program program(nc::sinumerikNotation());
    const std::string deep = "! the calculation is nested too deeply";
    QCOMPARE(program.value(std::string(100'000, '(') + "1" + std::string(100'000, ')')), deep);
    QCOMPARE(program.value(std::string(100'000, '-') + "1"), deep);
    std::string chain = "1";
    for (int i = 0; i < 100'000; ++i) {
      chain += "+1";
    }
    QCOMPARE(program.value(chain), deep);
    QCOMPARE(Program(nc::hashNotation()).value(std::string(100'000, '#') + "1"), deep);
  }

  /// Synchronized actions keep `$` variables; the rest has its value of the moment.
  void freezes() {
    Program program(nc::sinumerikNotation());
    QCOMPARE(program.assign("R1=5"), "");
    const auto frozen = [&program](const char* text) {
      const auto read = nc::parseExpression(text, nc::sinumerikNotation());
      const auto made = nc::freeze(*read, program, program.semantics());
      return made ? std::string(nc::isConstant(*made) ? "constant" : "open")
                  : "! " + nc::describe(made.error());
    };
    QCOMPARE(frozen("R1*2"), "constant");
    QCOMPARE(frozen("$AA_IM[X] > R1"), "open");
    QCOMPARE(frozen("$R[R1+1]"), "open");
    QCOMPARE(frozen("R[$R1]"),
             "! a synchronized action reads R or an array by an index of the main run: use $R");
    QCOMPARE(frozen("R7+$R1"),
             "! R7 is read before the program sets it: only the control knows it");
  }
};

RIVULET_TEST(TestEval)
#include "tst_eval.moc"
