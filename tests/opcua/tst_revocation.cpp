// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Revocation lists and certificates of users, as an authority has made them (tests/data).

#include <QtTest>
#include <string>
#include <string_view>

#include "base/file.h"
#include "opcua/certificate.h"
#include "opcua/error.h"
#include "opcua/pem.h"
#include "opcua/revocation.h"
#include "opcua/user_certificate.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

std::string textOf(const std::string& name) {
  const auto text =
      base::readFile(std::string(RIVULET_SOURCE_DIR "/tests/data/certificates/") + name, 65536);
  return text.value_or(std::string());
}

std::string derOf(const std::string& name, std::string_view label) {
  return opcua::pemPart(textOf(name), label).value_or(std::string());
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? std::string() : text.replace(at, what.size(), with);
}

}  // namespace

class TestRevocation : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aListRevokesWhatItNamesOfItsIssuer() {
    const auto list = opcua::readRevocationList(textOf("shop.crl"));
    QVERIFY(list.has_value());
    QCOMPARE(list->issuer, std::string("CN=Shop CA, O=Example"));
    QCOMPARE(base::utcText(list->issuedAt), std::string("2026-11-23T17:17:54.000Z"));
    QVERIFY(list->nextAt.has_value());
    QCOMPARE(base::utcText(*list->nextAt), std::string("2126-10-30T17:17:54.000Z"));
    QCOMPARE(list->serials, std::set<std::string>{std::string("\0\x81\xa2", 3)});

    const std::string anna = derOf("anna.pem", "CERTIFICATE");
    QVERIFY(opcua::isRevoked({&*list, 1}, anna));
    QVERIFY(opcua::isRevoked({&*list, 1}, anna + "rest of a chain"));
    QVERIFY(!opcua::isRevoked({&*list, 1}, derOf("bert.pem", "CERTIFICATE")));
    QVERIFY(!opcua::isRevoked({}, anna));
    // The same number of another issuer.
    const std::string other = replaced(anna, "Shop CA", "Shop CB");
    QVERIFY(opcua::readCertificate(other).has_value());
    QVERIFY(!opcua::isRevoked({&*list, 1}, other));
  }

  void aListIsReadFromBothForms() {
    const auto list = opcua::readRevocationList(derOf("shop.crl", "X509 CRL"));
    QVERIFY(list.has_value());
    QCOMPARE(list->serials.size(), std::size_t{1});
  }

  /// Half a list would let in what the other half revokes.
  void aDamagedListIsRefused() {
    const std::string der = derOf("shop.crl", "X509 CRL");
    QVERIFY(!der.empty());
    for (std::size_t size = 0; size < der.size(); ++size) {
      QVERIFY2(!opcua::readRevocationList(der.substr(0, size)), std::to_string(size).c_str());
    }
    const std::string entry = replaced(der, std::string_view("\x02\x03\x00\x81\xa2", 5),
                                       std::string_view("\x02\x7f\x00\x81\xa2", 5));
    QVERIFY(!entry.empty());
    const auto refused = opcua::readRevocationList(entry);
    QVERIFY(!refused && refused.error().code == opcua::LinkError::CertificateInvalid);
    QVERIFY(!opcua::readRevocationList(textOf("anna.pem")));
    QVERIFY(!opcua::readRevocationList(derOf("anna.pem", "CERTIFICATE")));
  }

  void aPartOfATextIsUnpacked() {
    QCOMPARE(opcua::pemPart("-----BEGIN A-----\nUml2dWxldA==\n-----END A-----\n", "A").value_or(""),
             std::string("Rivulet"));
    QCOMPARE(opcua::pemPart("-----BEGIN A-----\n-----END A-----\n-----BEGIN B-----\r\nUml2\r\n"
                            "-----END B-----",
                            "B")
                 .value_or(""),
             std::string("Riv"));
    QVERIFY(!opcua::pemPart("-----BEGIN A-----\nUml2", "A"));
    QVERIFY(!opcua::pemPart("-----BEGIN A-----\nUm*2\n-----END A-----", "A"));
    QVERIFY(!opcua::pemPart("-----BEGIN A-----\nUml2dWxldA==\n-----END A-----", "B"));
  }

  void whatIsNoCertificateOrNoKeyIsSaid() {
    const auto messageOf = [](std::string_view certificate, std::string_view key) {
      const auto user = opcua::readUserCertificate(certificate, key);
      return user ? std::string() : user.error().message;
    };
    const std::string anna = textOf("anna.pem");
    QVERIFY(messageOf("no certificate", "no key").find("no certificate") != std::string::npos);
    QVERIFY(messageOf(anna, anna).find("no RSA key") != std::string::npos);
    QVERIFY(messageOf(anna, "-----BEGIN ENCRYPTED PRIVATE KEY-----").find("password") !=
            std::string::npos);
  }

  void aCertificateThatHasEndedIsNotShown() {
    const opcua::UserCertificate anna{derOf("anna.pem", "CERTIFICATE"), ""};
    const auto facts = opcua::readCertificate(anna.certificate);
    QVERIFY(facts.has_value());
    QVERIFY(opcua::checkUserCertificate(anna, facts->validFrom));
    QVERIFY(opcua::checkUserCertificate(anna, facts->validTo));
    QVERIFY(!opcua::checkUserCertificate(anna, facts->validFrom - 1));
    const auto ended = opcua::checkUserCertificate(anna, facts->validTo + 1);
    QVERIFY(!ended && ended.error().message.find("2126-10-30") != std::string::npos);
  }
};

RIVULET_TEST(TestRevocation)
#include "tst_revocation.moc"
