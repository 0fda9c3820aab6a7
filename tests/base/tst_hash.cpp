// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <string>

#include "base/hash.h"
#include "support/test_program.h"

using rivulet::base::hashOf;
using rivulet::base::hashOfFile;

class TestHash : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The test vectors of the function's authors (draft-eastlake-fnv, appendix C).
  void isFnv1a() {
    QCOMPARE(hashOf(""), 0xCBF29CE484222325ULL);
    QCOMPARE(hashOf("a"), 0xAF63DC4C8601EC8CULL);
    QCOMPARE(hashOf("foobar"), 0x85944171F73967E8ULL);
  }

  /// Recordings carry this number: it must not change.
  void hashOfFileIsFixed() { QCOMPARE(hashOfFile("G1 X1 Y2 F500\nM30\n"), 0xA61ED320B72B07DCULL); }

  void everyByteOfAFileCounts() {
    const std::string text = "G1 X1 Y2 F500\nM30\n";
    for (std::size_t i = 0; i < text.size(); ++i) {
      std::string other = text;
      other[i] = static_cast<char>(other[i] + 1);
      QVERIFY(hashOfFile(other) != hashOfFile(text));
    }
    QVERIFY(hashOfFile(text + '\0') != hashOfFile(text));
  }
};

RIVULET_TEST(TestHash)

#include "tst_hash.moc"
