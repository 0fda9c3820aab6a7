// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/certificate_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace rivulet::widgets {

namespace {

struct CertificateTexts {
  Q_DECLARE_TR_FUNCTIONS(CertificateTexts)

 public:
  static QString validity(const QString& from, const QString& to) {
    return tr("%1 to %2").arg(from, to);
  }
  static QString selfSigned() { return tr("itself"); }
  static QString none() { return tr("not given"); }
};

QString dateText(base::UtcMs at) {
  constexpr std::size_t kDateLength = 10;
  return QString::fromStdString(base::utcText(at).substr(0, kDateLength));
}

}  // namespace

QString fingerprintLines(std::string_view fingerprint) {
  constexpr std::size_t kDigitsPerLine = 16;
  QStringList lines;
  for (std::size_t begin = 0; begin < fingerprint.size(); begin += kDigitsPerLine) {
    lines.append(
        QString::fromStdString(opcua::fingerprintText(fingerprint.substr(begin, kDigitsPerLine))));
  }
  return lines.join(QLatin1Char('\n'));
}

QString validityText(const opcua::CertificateFacts& facts) {
  return CertificateTexts::validity(dateText(facts.validFrom), dateText(facts.validTo));
}

QString untrustedText(const std::string& text) {
  constexpr qsizetype kLengthMax = 240;
  constexpr int kUnbrokenMax = 24;
  const QString whole = QString::fromStdString(text);
  QString shown;
  int unbroken = 0;
  for (const QChar c : whole.left(kLengthMax)) {
    const bool isSeen = c.isPrint() && c.category() != QChar::Other_Format;
    shown += isSeen || c.isSurrogate() ? c : QLatin1Char('?');
    const bool ends = QStringLiteral(":/,.=@").contains(c) || ++unbroken >= kUnbrokenMax;
    if (ends && !c.isSurrogate()) {
      shown += QChar(0x200B);  // a line may end here
    }
    unbroken = ends || c.isSpace() ? 0 : unbroken;
  }
  return whole.size() > kLengthMax ? shown + QStringLiteral(" …") : shown;
}

QString issuerText(const opcua::CertificateFacts& facts) {
  return facts.issuer == facts.subject ? CertificateTexts::selfSigned()
                                       : untrustedText(facts.issuer);
}

QString listText(const std::vector<std::string>& texts) {
  QStringList list;
  for (const std::string& text : texts) {
    list.append(untrustedText(text));
  }
  constexpr qsizetype kCountMax = 8;
  const bool isCut = list.size() > kCountMax;
  return list.isEmpty() ? CertificateTexts::none()
                        : list.mid(0, kCountMax).join(QStringLiteral(", ")) +
                              (isCut ? QStringLiteral(", …") : QString());
}

}  // namespace rivulet::widgets
