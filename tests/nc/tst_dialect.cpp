// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "nc/syntax/dialect.h"
#include "support/test_program.h"

using namespace rivulet;
using nc::Dialect;

class TestDialect : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesAreTheirOwn() {
    for (const Dialect dialect : nc::kDialects) {
      QVERIFY(nc::dialectOfName(nc::dialectName(dialect)) == dialect);
    }
    QVERIFY(nc::dialectOfName("iso") == Dialect::Fanuc);
    QVERIFY(!nc::dialectOfName("fortran"));
  }

  void detects_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("expected");
    QTest::addColumn<QByteArray>("evidence");
    const auto add = [](const char* text, Dialect expected, const char* evidence) {
      QTest::newRow(QByteArray(text).simplified().left(40).constData())
          << QByteArray(text) << static_cast<int>(expected) << QByteArray(evidence);
    };
    add("", Dialect::Fanuc, "");
    add("G0 X1\nG1 Y2 F100\n", Dialect::Fanuc, "");
    add("%\nO1234 (PART)\nG0 X1\nM30\n%", Dialect::Fanuc, "Onnnn");
    add("N10 TRAORI\nN20 G0 X1", Dialect::Sinumerik, "TRAORI");
    add("G2 X1 Y1 CR=5", Dialect::Sinumerik, "CR=");
    add("R1=5\nG0 X=R1", Dialect::Sinumerik, "Rn=");
    add("%_N_PART_MPF\nG0 X1", Dialect::Sinumerik, "%_N_");
    add("(TRAORI is a comment)\nG0 X1", Dialect::Fanuc, "");
    add("; MCALL in a comment\nG0 X1", Dialect::Fanuc, "");
    add("O<part> sub\nO<part> endsub", Dialect::LinuxCnc, "O<");
    add("#<depth>=3\nG1 Z-#<depth> F100", Dialect::LinuxCnc, "#<");
    add("$H\nG0 X1", Dialect::Grbl, "$H");
    // LinuxCNC refuses a comment there.
    add("o1 (why) if [1]\nG0 X1\no1 endif\n", Dialect::FluidNc, "On (...)");
    add("o1 if [1] (why)\nG0 X1\no1 endif\n", Dialect::LinuxCnc, "ENDIF");
    add("(for FluidNC)\n#<x>=1\nG0 X#<x>\n", Dialect::FluidNc, "FLUIDNC");
    add("0 BEGIN PGM A MM\n1 L X+0 Y+0 FMAX\n2 END PGM A MM", Dialect::Heidenhain, "BEGIN PGM");
  }

  void detects() {
    QFETCH(const QByteArray, text);
    QFETCH(const int, expected);
    QFETCH(const QByteArray, evidence);
    const nc::DialectGuess guess = nc::detectDialect(text.toStdString());
    QCOMPARE(static_cast<int>(guess.dialect), expected);
    QCOMPARE(QByteArray::fromStdString(guess.evidence), evidence);
  }

  /// What the name of the file says holds until the text says otherwise.
  void fileNameDecides() {
    const auto of = [](std::string_view text, std::string_view file) {
      return nc::detectDialect(text, file);
    };
    QVERIFY(of("G0 X1\n", "PART.MPF").dialect == Dialect::Sinumerik);
    QVERIFY(of("G0 X1\n", "part.ngc").dialect == Dialect::LinuxCnc);
    QCOMPARE(of("G0 X1\n", "part.spf").evidence, std::string(".SPF"));
    QVERIFY(of("G0 X1\n", "part.nc").dialect == Dialect::Fanuc);
    QVERIFY(of("0 BEGIN PGM A MM\n1 L X+0\n2 END PGM A MM", "A.MPF").dialect ==
            Dialect::Heidenhain);
    QVERIFY(of("O<part> sub\nO<part> endsub\n", "A.SPF").dialect == Dialect::LinuxCnc);
  }
};

RIVULET_TEST(TestDialect)
#include "tst_dialect.moc"
