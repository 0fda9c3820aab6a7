// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The language of the application: texts and numbers, switched while it runs.
/// @threadsafety GUI thread.
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>
#include <QTranslator>
#include <vector>

namespace rivulet::language {

struct Language {
  QString code;  ///< as in the name of its file: "fr" of rivulet_fr.ts
  QString name;  ///< in itself, so that everybody finds the own one
};

/// The languages of the window. English, that of the sources, comes first.
[[nodiscard]] const std::vector<Language>& languages();

/// The first that the window has; "en" if it has none of them.
/// @param wanted  as ISO 639 with or without a region ("fr", "fr-CA", "fr_CA"), the best first
[[nodiscard]] QString languageFor(const QStringList& wanted);

/// How numbers are written: as in the region of the computer if its language is this one (a decimal
/// comma in Spain, a point in Mexico), else as in the language's own country.
[[nodiscard]] QLocale localeFor(const QString& language, const QLocale& system);

class Translator {
 public:
  /// @param language  one of `languages()`; empty: the first of the system's that is one of them.
  ///                  Any other is English.
  void setLanguage(const QString& language);
  [[nodiscard]] QString language() const { return m_language; }

 private:
  QTranslator m_own;
  QTranslator m_qt;
  QString m_language;
};

}  // namespace rivulet::language
