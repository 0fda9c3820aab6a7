// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/templates/nc_highlighter.h"

#include <QRegularExpression>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

NcHighlighter::NcHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {
}

void NcHighlighter::setColors(const QPalette& palette) {
  m_palette = palette;
  rehighlight();
}

void NcHighlighter::highlightBlock(const QString& text) {
  static const QRegularExpression label(QStringLiteral("^\\s*[A-Za-z_][A-Za-z0-9_]+:"));
  static const QRegularExpression parameter(QStringLiteral("\\b\\$?R(\\d+|\\[[^\\]]*\\])"));
  static const QRegularExpression word(
      QStringLiteral("\\b(IF|ELSE|ENDIF|WHILE|ENDWHILE|LOOP|ENDLOOP|FOR|ENDFOR|GOTO[FBC]?|STOPRE|"
                     "MSG|WHEN|WHENEVER|EVERY|DO|TRUE|FALSE|AND|OR|NOT|DEF|PROC|M\\d+)\\b"));
  const ThemeColors& colors = themeColors(m_palette);
  const auto mark = [&](const QRegularExpression& pattern, const QTextCharFormat& format) {
    for (auto match = pattern.globalMatch(text); match.hasNext();) {
      const QRegularExpressionMatch found = match.next();
      setFormat(static_cast<int>(found.capturedStart()), static_cast<int>(found.capturedLength()),
                format);
    }
  };
  QTextCharFormat bold;
  bold.setFontWeight(QFont::Bold);
  mark(word, bold);
  QTextCharFormat coloured;
  coloured.setForeground(colors.accent);
  mark(parameter, coloured);
  QTextCharFormat boldColoured = bold;
  boldColoured.setForeground(colors.equations[1]);
  mark(label, boldColoured);
  const qsizetype comment = text.indexOf(QLatin1Char(';'));
  if (comment >= 0) {
    QTextCharFormat muted;
    muted.setForeground(colors.mutedText);
    muted.setFontItalic(true);
    setFormat(static_cast<int>(comment), static_cast<int>(text.size() - comment), muted);
  }
}

}  // namespace rivulet::widgets
