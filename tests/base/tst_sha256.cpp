// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/sha256.h"

#include <QCryptographicHash>
#include <QTest>

#include "support/test_program.h"

using namespace rivulet;

class TestSha256 : public QObject {
  Q_OBJECT

 private slots:
  /// Examples of FIPS 180-4.
  void knownMessages() {
    QCOMPARE(base::sha256Hex("abc"),
             std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
    QCOMPARE(base::sha256Hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
             std::string("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"));
  }

  /// Every length around a block and its padding, against another implementation.
  void everyLength() {
    std::string text;
    for (int length = 0; length <= 200; ++length) {
      const QByteArray expected =
          QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
              .toHex();
      QCOMPARE(base::sha256Hex(text), expected.toStdString());
      text += static_cast<char>(length * 7 + 3);
    }
  }

  /// PBKDF2 with HMAC-SHA-256, the known answers of the test vectors of RFC 6070 for this hash.
  void passwords() {
    const auto hash = [](int iterations) {
      return base::passwordHashHex("password", "salt", iterations);
    };
    QCOMPARE(hash(1),
             std::string("120fb6cffcf8b32c43e7225256c4f837a86548c92ccc35480805987cb70be17b"));
    QCOMPARE(hash(2),
             std::string("ae4d0c95af6b46d32d0adff928f06dd02a303f8ef3c251dfd6e2d85a95474c43"));
    QCOMPARE(hash(4096),
             std::string("c5e478d59288c841aa530db6845c4c8d962893a001ce4e11a4963873aa98134a"));
  }
};

RIVULET_TEST(TestSha256)
#include "tst_sha256.moc"
