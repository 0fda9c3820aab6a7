// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "language/translator.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <algorithm>

namespace rivulet::language {

const std::vector<Language>& languages() {
  static const std::vector<Language> all{
      {QStringLiteral("en"), QStringLiteral("English")},
      {QStringLiteral("de"), QStringLiteral("Deutsch")},
      {QStringLiteral("fr"), QStringLiteral("Français")},
      {QStringLiteral("it"), QStringLiteral("Italiano")},
      {QStringLiteral("es"), QStringLiteral("Español")},
  };
  return all;
}

QString languageFor(const QStringList& wanted) {
  for (QString code : wanted) {
    code = code.replace(QLatin1Char('_'), QLatin1Char('-')).section(QLatin1Char('-'), 0, 0);
    const auto& all = languages();
    const auto found = std::find_if(all.begin(), all.end(), [&code](const Language& language) {
      return language.code == code;
    });
    if (found != all.end()) {
      return found->code;
    }
  }
  return languages().front().code;
}

QLocale localeFor(const QString& language, const QLocale& system) {
  const QLocale own(language);
  return system.language() == own.language() ? QLocale(system.name()) : own;
}

void Translator::setLanguage(const QString& language) {
  const QLocale system = QLocale::system();
  m_language = languageFor(language.isEmpty() ? system.uiLanguages() : QStringList{language});
  // Numbers first: the texts are made anew when the translators change.
  QLocale::setDefault(localeFor(m_language, system));
  QCoreApplication::removeTranslator(&m_own);
  QCoreApplication::removeTranslator(&m_qt);
  if (m_qt.load(QStringLiteral("qtbase_") + m_language,
                QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(&m_qt);
  }
  if (m_own.load(QStringLiteral(":/rivulet/i18n/rivulet_") + m_language)) {
    QCoreApplication::installTranslator(&m_own);
  }
}

}  // namespace rivulet::language
