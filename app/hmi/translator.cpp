// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/translator.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace rivulet::hmi {

void Translator::setLanguage(const QString& language) {
  QString wanted = language;
  if (wanted.isEmpty()) {
    wanted = QLocale::system().language() == QLocale::German ? QStringLiteral("de")
                                                             : QStringLiteral("en");
  }
  m_language = wanted;
  // Numbers first: the texts are made anew when the translators change.
  QLocale::setDefault(QLocale(wanted));
  QCoreApplication::removeTranslator(&m_own);
  QCoreApplication::removeTranslator(&m_qt);
  if (wanted == QLatin1String("en")) {
    return;
  }
  if (m_qt.load(QStringLiteral("qtbase_") + wanted,
                QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(&m_qt);
  }
  if (m_own.load(QStringLiteral(":/rivulet/i18n/rivulet_") + wanted)) {
    QCoreApplication::installTranslator(&m_own);
  }
}

}  // namespace rivulet::hmi
