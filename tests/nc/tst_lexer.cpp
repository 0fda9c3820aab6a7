// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <sys/mman.h>
#include <unistd.h>

#include <QtTest>
#include <algorithm>
#include <clocale>
#include <string>

#include "base/text.h"
#include "nc/syntax/lexer.h"
#include "support/test_program.h"

using namespace rivulet;
using nc::TokenKind;

namespace {

/// "1: X10 X@1=10 | 2: …": per line its tokens as kind, text and, for words, the value read.
std::string tokens(std::string_view text, std::optional<nc::Dialect> dialect = std::nullopt) {
  nc::Lexer lexer(text, dialect.value_or(nc::detectDialect(text).dialect));
  nc::Block block;
  std::string out;
  while (lexer.next(block)) {
    out += out.empty() ? "" : " | ";
    out += std::to_string(block.line.value) + ":";
    for (const nc::Token& token : block.tokens) {
      out += ' ';
      const std::string at = "@" + std::to_string(token.column);
      const std::string value = base::formatNumber(token.value);
      switch (token.kind) {
        case TokenKind::Word:
          out += token.address + value + at;
          break;
        case TokenKind::NamedValue:
          out += std::string(nc::tokenName(token)) + "=" + value + at;
          break;
        case TokenKind::IndexedWord:
          out += "indexed<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::TextWord:
          out += "text<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::Name:
          out += "name<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::Call:
          out += "call<" + std::string(nc::tokenName(token)) + ">" + at;
          break;
        case TokenKind::Label:
          out += "label<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::Expression:
          out += "expression<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::Assignment:
          out += "assignment<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::Statement:
          out += "statement<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::BlockSkip:
          out += "skip" + at;
          break;
        case TokenKind::Tape:
          out += "tape" + at;
          break;
        case TokenKind::Comment:
          out += "comment" + at;
          break;
        case TokenKind::UnexpectedCharacter:
          out += "unexpected<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::NumberMissing:
          out += "missing<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::NumberMalformed:
          out += "malformed<" + std::string(token.text) + ">" + at;
          break;
        case TokenKind::CommentNotClosed:
          out += "unclosed" + at;
          break;
        case TokenKind::CommentNested:
          out += "nested<" + std::string(token.text) + ">" + at;
          break;
      }
    }
  }
  return out;
}

}  // namespace

class TestLexer : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void reads_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("expected");
    const auto add = [](const char* name, const char* text, const char* expected) {
      QTest::newRow(name) << QByteArray(text) << QByteArray(expected);
    };
    add("words", "N10 G1 X10.5 Y-2.25 F600", "1: N10@1 G1@5 X10.5@8 Y-2.25@14 F600@21");
    add("packed", "g01x.5y-.5z+3.", "1: G1@1 X0.5@4 Y-0.5@7 Z3@11");
    add("blanks inside", "X 10\tY - 2", "1: X10@1 Y-2@6");
    add("assigned", "X=10 Y = -2.5", "1: X10@1 Y-2.5@6");
    add("line ends", "X1\nY2\r\nZ3\rX4\n\nX5",
        "1: X1@1 | 2: Y2@1 | 3: Z3@1 | 4: X4@1 | 5: | 6: X5@1");
    add("doubled carriage returns", "X1\r\r\nX2\r\r\nX3", "1: X1@1 | 2: X2@1 | 3: X3@1");
    add("mixed ends", "X1\rX2\r\nX3\n", "1: X1@1 | 2: X2@1 | 3: X3@1");
    add("comments", "(a) G1 (b X9) X1 ; to Y2", "1: G1@5 X1@15");
    add("nested comment", "(a (b) X9) X1", "1: nested<(a (b) X9)>@1 X1@12");
    add("open comment", "X1 (open\nX2", "1: X1@1 unclosed@4 | 2: X2@1");
    add("tape", "%\n%_N_A_MPF\nX1", "1: tape@1 | 2: tape@1 | 3: X1@1");
    add("skip", "/X1\n/3 X2\nN5 /X3", "1: skip@1 X1@2 | 2: skip@1 X2@4 | 3: N5@1 skip@4 X3@5");
    add("main block", ":10 X1", "1: N10@1 X1@5");
    add("radius", "CR=-12.5 cr = 3", "1: CR=-12.5@1 cr=3@10");
    add("names", "SOFT G642 ADIS=0.1", "1: name<SOFT>@1 G642@6 ADIS=0.1@11");
    add("call", "MSG(\"a;b (c\") X1", "1: call<MSG>@1 X1@15");
    add("call behind blank", "MSG (\"a\")", "1: call<MSG>@1");
    add("name and comment", "RET (done)", "1: name<RET>@1");
    add("label", "START: X1", "1: label<START:>@1 X1@8");
    add("tool name", "T=\"MILL 10\" D1", "1: text<T=\"MILL 10\">@1 D1@13");
    add("indexed", "M1=3 S2=500 M30", "1: indexed<M1=3>@1 indexed<S2=500>@6 M30@13");
    add("text put together", "TAG=\"A\"<<R1 X=1\nTAG=R1 << \"B\" Z1",
        "1: assignment<TAG=\"A\"<<R1>@1 X1@13 | 2: assignment<TAG=R1 << \"B\">@1 Z1@15");
    add("indexed by a value", "STOPRE\nM[1]=3 S[R1]=R2*2 Z1",
        "1: name<STOPRE>@1 | 2: indexed<M[1]=3>@1 indexed<S[R1]=R2*2>@8 Z1@19");
    add("R assignment", "R1=5 R2=R1+2", "1: assignment<R1=5>@1 assignment<R2=R1+2>@6");
    add("axis expression", "G1 X=R1+2 Y=AC(10) Z3",
        "1: G1@1 expression<X=R1+2>@4 expression<Y=AC(10)>@11 Z3@20");
    add("operator words", "X=5 DIV R1 Y=R2 MOD 3 Z1",
        "1: expression<X=5 DIV R1>@1 expression<Y=R2 MOD 3>@12 Z1@23");
    add("own addresses", "G1 X=AC(1) A3=0.5 I1=2 CR=R1",
        "1: G1@1 expression<X=AC(1)>@4 A3=0.5@12 I1=2@19 assignment<CR=R1>@24");
    add("text", "TAG = \"B-2\"\nX=1", "1: text<TAG = \"B-2\">@1 | 2: X1@1");
    add("values of hashes", "G1 X#1Y[#2+1]Z-#<depth>F[100]",
        "1: G1@1 expression<X#1>@4 expression<Y[#2+1]>@7 expression<Z-#<depth>>@14 "
        "expression<F[100]>@24");
    add("hash and comment", "#1=[2*3](six) #2=3", "1: assignment<#1=[2*3]>@1 assignment<#2=3>@15");
    add("jumps of ISO", "IF[#1EQ2]GOTO10\nGOTO 20\nEND1",
        "1: statement<IF[#1EQ2]GOTO10>@1 | 2: statement<GOTO 20>@1 | 3: statement<END1>@1");
    add("numbered o word", "o100 while [#1 LT 3]", "1: statement<o100 while [#1 LT 3]>@1");
    add("spaced expression", "X=R1 + 2 Y3", "1: expression<X=R1 + 2>@1 Y3@10");
    add("sum", "X=10+5", "1: expression<X=10+5>@1");
    add("hash", "#1=2 ; c", "1: assignment<#1=2>@1");
    add("hash value", "X#1 Y-[2] Z1", "1: expression<X#1>@1 expression<Y-[2]>@5 Z1@11");
    add("system variable", "$AA_OFF[X]=1", "1: assignment<$AA_OFF[X]=1>@1");
    add("statement", "N5 IF R1==2 GOTOF END ; c", "1: N5@1 statement<IF R1==2 GOTOF END>@4");
    add("o word", "o<sub> call", "1: statement<o<sub> call>@1");
    add("array", "DEF REAL A[2]", "1: statement<DEF REAL A[2]>@1");
    add("missing", "G1 X Y2\nZ-", "1: G1@1 missing<X>@4 Y2@6 | 2: missing<Z>@1");
    add("decimal comma", "X1,5 Y2", "1: malformed<1,5>@2 Y2@6");
    add("corner word", "X10.,R2. Y2", "1: X10@1 ,R=2@5 Y2@10");
    add("two points", "X1.2.3 Y2", "1: malformed<1.2.3>@2 Y2@8");
    add("point only", "X. Y2", "1: malformed<.>@2 Y2@4");
    add("no exponent", "X1E5 Y2", "1: malformed<1E5>@2 Y2@6");
    add("printed exponent", "X8.77e-05 Y2\nF1.e+03",
        "1: malformed<8.77e-05>@2 Y2@11 | 2: malformed<1.e+03>@2");
    add("unit behind a number", "X10mm F5_2", "1: malformed<10mm>@2 malformed<5_2>@8");
    add("packed E word", "G76P1E0.5", "1: G76@1 P1@4 E0.5@6");
    add("not a number", "XNAN", "1: name<XNAN>@1");
    add("other bytes", "X1 \xC3\xA4 & Y2", "1: X1@1 unexpected<\xC3\xA4>@4 unexpected<&>@7 Y2@9");
    add("stray bracket", "X1)", "1: X1@1 unexpected<)>@3");
    add("byte order mark", "\xEF\xBB\xBFG1", "1: G1@1");
    add("end mark", "G1\n\x1A", "1: G1@1");
    add("many digits", "X0.1234567890123456789", "1: X0.12345678901234568@1");
    add("nothing", "", "");
  }

  void reads() {
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, expected);
    QCOMPARE(QByteArray::fromStdString(tokens(text.toStdString())), expected);
  }

  void readsNumbers_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("iso");  ///< also GRBL
    QTest::addColumn<QByteArray>("linuxCnc");
    QTest::addColumn<QByteArray>("sinumerik");
    const auto add = [](const char* text, const char* iso, const char* linuxCnc,
                        const char* sinumerik) {
      QTest::newRow(text) << QByteArray(text) << QByteArray(iso) << QByteArray(linuxCnc)
                          << QByteArray(sinumerik);
    };
    const auto same = [&add](const char* text, const char* expected) {
      add(text, expected, expected, expected);
    };
    // The values of LinuxCNC are those of its own interpreter, `rs274 -g`.
    const auto spaced = [&add](const char* text, const char* put, const char* refused) {
      add(text, put, put, refused);
    };
    spaced("X1 0 Y2", "1: X10@1 Y2@6", "1: malformed<1 0>@2 Y2@6");
    spaced("F1 00", "1: F100@1", "1: malformed<1 00>@2");
    spaced("X - 2 . 5", "1: X-2.5@1", "1: malformed<- 2 . 5>@3");
    spaced("G0X 1 . 5Y 2", "1: G0@1 X1.5@3 Y2@10", "1: G0@1 malformed<1 . 5>@5 Y2@10");
    spaced("X1\t.\t5", "1: X1.5@1", "1: malformed<1\t.\t5>@2");
    spaced("G 9 1 X1", "1: G91@1 X1@7", "1: malformed<9 1>@3 X1@7");
    spaced("N1 0 X4", "1: N10@1 X4@6", "1: malformed<1 0>@2 X4@6");
    spaced("X. 5", "1: X0.5@1", "1: malformed<. 5>@2");
    spaced("X=1 0 Y2", "1: X10@1 Y2@7", "1: malformed<1 0>@3 Y2@7");
    spaced("X0 . 0001 0001 0001 0001 0001", "1: X0.00010001000100010001@1",
           "1: malformed<0 . 0001 0001 0001 0001 0001>@2");
    add("X1 . 2 . 3 Y1", "1: malformed<1 . 2 . 3>@2 Y1@12", "1: malformed<1 . 2 . 3>@2 Y1@12",
        "1: malformed<1 . 2 . 3>@2 Y1@12");
    same("X 1 ", "1: X1@1");
    same("X- 5", "1: X-5@1");
    same("X+ .5", "1: X0.5@1");
    same("X007 Y-0.50", "1: X7@1 Y-0.5@6");
    same("X5. Y+5", "1: X5@1 Y5@5");
    add("X--5", "1: malformed<--5>@2", "1: X5@1", "1: malformed<--5>@2");
    add("X+-5 Y1", "1: malformed<+-5>@2 Y1@6", "1: X-5@1 Y1@6", "1: malformed<+-5>@2 Y1@6");
    add("X1EX3 Y1", "1: malformed<1EX3>@2 Y1@7", "1: malformed<1EX3>@2 Y1@7", "1: X1000@1 Y1@7");
    add("X-2.5ex-1", "1: malformed<-2.5ex-1>@2", "1: malformed<-2.5ex-1>@2", "1: X-0.25@1");
  }

  void readsNumbers() {
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, iso);
    QFETCH(const QByteArray, linuxCnc);
    QFETCH(const QByteArray, sinumerik);
    const auto read = [&text](nc::Dialect dialect) {
      return QByteArray::fromStdString(tokens(text.toStdString(), dialect));
    };
    QCOMPARE(read(nc::Dialect::Fanuc), iso);
    QCOMPARE(read(nc::Dialect::Grbl), iso);
    QCOMPARE(read(nc::Dialect::LinuxCnc), linuxCnc);
    QCOMPARE(read(nc::Dialect::Sinumerik), sinumerik);
  }

  /// Cutting a program anywhere must neither read past its end nor lose the lines before.
  void survivesEveryCut() {
    const std::string text =
        "%\nO12 (a)\n/N5 G1 X=R1+[2*3] Y-.5 CR=-2 T=\"A\" MSG(\"b\") M1=3 ;c\r\nIF X GOTO\rX1,2\n";
    for (std::size_t size = 0; size <= text.size(); ++size) {
      const std::string cut = text.substr(0, size);  // its own buffer: a sanitizer sees overruns
      nc::Lexer lexer(cut);
      nc::Block block;
      while (lexer.next(block)) {
        for (const nc::Token& token : block.tokens) {
          QVERIFY(token.text.data() >= cut.data());
          QVERIFY(token.text.data() + token.text.size() <= cut.data() + cut.size());
          QVERIFY(token.column >= 1);
        }
      }
      QVERIFY(lexer.lines() <= 5);
    }
  }

  void numbersDoNotDependOnTheLocale() {
    std::setlocale(LC_ALL, "tr_TR.UTF-8");
    QCOMPARE(tokens("X1.5"), std::string("1: X1.5@1"));
    std::setlocale(LC_ALL, "C");
  }

  /// The page before the text cannot be read.
  void doesNotLookBeforeItsText() {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    void* const pages =
        mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    QVERIFY(pages != MAP_FAILED);
    QCOMPARE(mprotect(pages, page, PROT_NONE), 0);
    char* const text = static_cast<char*>(pages) + page;
    for (const std::string_view line : {"#<probe_z>=#5063", "#", "$", "=1", "X", "@", ")"}) {
      std::copy(line.begin(), line.end(), text);
      for (const nc::Dialect dialect : nc::kDialects) {
        nc::Lexer lexer({text, line.size()}, dialect);
        nc::Block block;
        QVERIFY(lexer.next(block));
        QVERIFY(!lexer.next(block));
      }
    }
    munmap(pages, 2 * page);
  }

  void reusesTheBuffer() {
    nc::Lexer lexer("X1 Y2 Z3\nX4\n");
    nc::Block block;
    QVERIFY(lexer.next(block));
    const auto capacity = block.tokens.capacity();
    QVERIFY(lexer.next(block));
    QCOMPARE(block.tokens.capacity(), capacity);
    QCOMPARE(block.tokens.size(), std::size_t{1});
    QVERIFY(!lexer.next(block));
  }
};

RIVULET_TEST(TestLexer)
#include "tst_lexer.moc"
