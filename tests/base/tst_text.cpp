// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <clocale>

#include "base/text.h"
#include "support/test_program.h"

using namespace rivulet::base;

class TestText : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void parsesNumbersWhateverTheLocale() {
    std::setlocale(LC_ALL, "tr_TR.UTF-8");  // where it is installed; harmless elsewhere
    QCOMPARE(parseNumber("1.5"), std::optional<double>(1.5));
    QCOMPARE(parseNumber("+.5"), std::optional<double>(0.5));
    QCOMPARE(parseNumber("-60."), std::optional<double>(-60.0));
    QVERIFY(!parseNumber("1,5"));
    QVERIFY(!parseNumber(""));
    QVERIFY(!parseNumber("+-1"));
    QVERIFY(!parseNumber("12x"));
    std::setlocale(LC_ALL, "C");
  }

  void formatsShortestAndFixed() {
    QCOMPARE(formatNumber(0.1), std::string("0.1"));
    QCOMPARE(formatFixed(12.50, 3), std::string("12.5"));
    QCOMPARE(formatFixed(3.0, 3), std::string("3"));
    QCOMPARE(formatFixed(-0.0001, 3), std::string("0"));
    QCOMPARE(formatFixed(100.0, 0), std::string("100"));
  }

  void trimsAndRaises() {
    QCOMPARE(trim(" \tG1 X0\r\n"), std::string_view("G1 X0"));
    QCOMPARE(trim(" \t"), std::string_view(""));
    QCOMPARE(toUpper("g1 x\xC3\xA4"), std::string("G1 X\xC3\xA4"));
  }

  void readsUtf16() {
    const std::string text = "G1 X1 (\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x94\xA7)\r\n";
    const std::u16string units = QString::fromStdString(text).toStdU16String();
    for (const bool isBig : {false, true}) {
      std::string content;
      for (const char16_t unit : units) {
        const char low = static_cast<char>(unit & 0xFF);
        const char high = static_cast<char>(unit >> 8);
        content += isBig ? high : low;
        content += isBig ? low : high;
      }
      QCOMPARE(asUtf8((isBig ? "\xFE\xFF" : "\xFF\xFE") + content), text);
    }
    using namespace std::string_literals;
    QCOMPARE(asUtf8("G\0001\0 \0X\0"s), "G1 X"s);
    QCOMPARE(asUtf8("\0G\0001\0 \0X"s), "G1 X"s);
    QCOMPARE(asUtf8("\xFF\xFE"s), ""s);
    // Neither an odd byte at the end nor half a character is read beyond.
    QCOMPARE(asUtf8("\xFF\xFEG\0X"s), "G"s);
    QCOMPARE(asUtf8("\xFF\xFEG\0\x3D\xD8"s), "G\xED\xA0\xBD"s);
    // Other content stays as it is.
    for (const std::string& same :
         {"G1 X1\n"s, "\xEF\xBB\xBFG1"s, "G1\0\0\0"s, "\0\0G1"s, ""s, "\xA0"s}) {
      QCOMPARE(asUtf8(same), same);
    }
  }

  void namesInvisibleCharacters() {
    QCOMPARE(invisibleCharacter("\xC2\xA0X1"), std::string("U+00A0"));
    QCOMPARE(invisibleCharacter("\xA0"), std::string("U+00A0"));
    QCOMPARE(invisibleCharacter("\xE2\x80\x8B"), std::string("U+200B"));
    QCOMPARE(invisibleCharacter("\xEF\xBB\xBF"), std::string("U+FEFF"));
    QCOMPARE(invisibleCharacter("\xE3\x80\x80"), std::string("U+3000"));
    QCOMPARE(invisibleCharacter("\xC3\xA4"), std::string());
    QCOMPARE(invisibleCharacter("X"), std::string());
    QCOMPARE(invisibleCharacter(""), std::string());
  }
};

RIVULET_TEST(TestText)
#include "tst_text.moc"
