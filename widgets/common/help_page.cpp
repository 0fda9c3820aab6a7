// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/help_page.h"

#include <QAbstractTextDocumentLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>

namespace rivulet::widgets {

namespace {

constexpr qreal kTextPt = 11.0;

class Manual final : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  /// The comment at the top of a file says who may use it, not how to use the program.
  QVariant loadResource(int type, const QUrl& name) override {
    const QVariant content = QTextBrowser::loadResource(type, name);
    if (type != static_cast<int>(QTextDocument::MarkdownResource)) {
      return content;
    }
    QString text = QString::fromUtf8(content.toByteArray());
    const qsizetype end = text.indexOf(QStringLiteral("-->"));
    return text.startsWith(QStringLiteral("<!--")) && end > 0 ? text.mid(end + 3) : text;
  }
};

}  // namespace

HelpPage::HelpPage(const QString& folder, QWidget* parent)
    : Page(parent), m_text(say(new Manual(this), {.name = QT_TR_NOOP("Manual")})) {
  m_text->setSearchPaths({folder});
  m_text->setOpenExternalLinks(false);
  QFont font = m_text->font();
  font.setPointSizeF(kTextPt);
  m_text->setFont(font);
  inColumn({inRow({m_back, spring(), m_close}), {m_text, 1}}, this);
  m_back->setEnabled(false);
  connect(m_text, &QTextBrowser::backwardAvailable, m_back, &QPushButton::setEnabled);
  connect(m_back, &QPushButton::clicked, m_text, &QTextBrowser::backward);
  restyle();
}

void HelpPage::open(const QString& file, const QString& heading) {
  m_text->setSource(QUrl(file), QTextDocument::MarkdownResource);
  for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0 && block.text() == heading) {
      m_text->setTextCursor(QTextCursor(block));
      m_text->verticalScrollBar()->setValue(
          static_cast<int>(m_text->document()->documentLayout()->blockBoundingRect(block).top()));
      return;
    }
  }
  m_text->moveCursor(QTextCursor::Start);
}

QString HelpPage::headingShown() const {
  return m_text->textCursor().block().text();
}

void HelpPage::restyle() {
  if (!m_text->source().isEmpty()) {
    m_text->reload();  // links have the colour they were made with
  }
}

}  // namespace rivulet::widgets
