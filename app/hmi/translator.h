// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The language of the application: texts and numbers, switched while it runs.
/// @threadsafety GUI thread.
#pragma once

#include <QString>
#include <QTranslator>

namespace rivulet::hmi {

class Translator {
 public:
  /// @param language "en" or "de"; empty: the system's if it is one of them, else English
  void setLanguage(const QString& language);
  [[nodiscard]] QString language() const { return m_language; }

 private:
  QTranslator m_own;
  QTranslator m_qt;
  QString m_language;
};

}  // namespace rivulet::hmi
