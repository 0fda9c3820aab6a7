// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gui/look_check.h"

#include <QAbstractButton>
#include <QAbstractItemDelegate>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QGraphicsView>
#include <QGroupBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QStyle>
#include <QStyleOption>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>
#include <QToolTip>
#include <QTranslator>
#include <algorithm>
#include <map>
#include <vector>

#include "widgets/common/elided_label.h"
#include "widgets/common/theme.h"

namespace rivulet::tests {

namespace {

constexpr double kContrastMin = 4.5;
constexpr double kContrastLargeMin = 3.0;
constexpr double kLargePt = 18.0;
constexpr double kLargeBoldPt = 14.0;
/// A frame may share a line with its neighbour.
constexpr int kSharedPx = 2;
constexpr int kLowWindowPx = 600;
constexpr int kLowTabPx = 30;

QString nameOf(const QWidget* widget) {
  QString text;
  if (const auto* label = qobject_cast<const QLabel*>(widget)) {
    text = label->text();
  } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
    text = button->text();
  } else if (const auto* group = qobject_cast<const QGroupBox*>(widget)) {
    text = group->title();
  }
  const QString className = QString::fromLatin1(widget->metaObject()->className());
  return QStringLiteral("%1 \"%2\"")
      .arg(className.section(QStringLiteral("::"), -1),
           (text.isEmpty() ? widget->objectName() : text).left(50));
}

QString placeOf(const QWidget* widget) {
  QStringList names;
  for (const QWidget* at = widget->parentWidget(); at != nullptr && names.size() < 3;
       at = at->parentWidget()) {
    const QString className = QString::fromLatin1(at->metaObject()->className());
    if (className != QLatin1String("QWidget")) {
      names.append(className.section(QStringLiteral("::"), -1));
    }
  }
  return nameOf(widget) + QStringLiteral(" in ") + names.join(QStringLiteral(" < "));
}

bool isLarge(const QFont& font) {
  return font.pointSizeF() >= kLargePt || (font.bold() && font.pointSizeF() >= kLargeBoldPt);
}

/// Its children belong to Qt, not to us.
bool isSealed(const QWidget* widget) {
  return qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
         qobject_cast<const QHeaderView*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QComboBox*>(widget) != nullptr ||
         qobject_cast<const QGraphicsView*>(widget) != nullptr ||
         qobject_cast<const QMenuBar*>(widget) != nullptr ||
         qobject_cast<const QTabBar*>(widget) != nullptr ||
         qobject_cast<const QScrollBar*>(widget) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
         qobject_cast<const QLineEdit*>(widget) != nullptr;
}

class Inspector {
 public:
  Inspector(const QWidget& window, const QImage& picture) : m_window(window), m_picture(picture) {}

  QStringList inspect() {
    visit(&m_window);
    checkFocusOrder();
    return m_faults;
  }

 private:
  void complain(const QWidget* widget, const QString& what) {
    m_faults.append(placeOf(widget) + QStringLiteral(": ") + what);
  }

  void visit(const QWidget* widget) {
    checkText(widget);
    checkTouch(widget);
    checkName(widget);
    checkMnemonic(widget);
    if (isSealed(widget)) {
      return;
    }
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget);
    if (area != nullptr) {
      if (const auto* scroll = qobject_cast<const QScrollArea*>(widget)) {
        if (scroll->horizontalScrollBar()->isVisible()) {
          complain(widget, QStringLiteral("has to be scrolled sideways, by %1 px")
                               .arg(scroll->horizontalScrollBar()->maximum()));
        }
        if (scroll->widget() != nullptr) {
          visit(scroll->widget());
        }
      }
      return;
    }
    std::vector<const QWidget*> children;
    for (const QObject* child : widget->children()) {
      const auto* part = qobject_cast<const QWidget*>(child);
      if (part != nullptr && !part->isWindow() && part->isVisible() &&
          !part->testAttribute(Qt::WA_TransparentForMouseEvents)) {
        children.push_back(part);
      }
    }
    for (std::size_t i = 0; i < children.size(); ++i) {
      const QRect place = children[i]->geometry();
      if (!widget->rect().contains(place) && !place.isEmpty()) {
        complain(children[i], QStringLiteral("%1,%2 %3x%4 is outside its parent of %5x%6")
                                  .arg(place.x())
                                  .arg(place.y())
                                  .arg(place.width())
                                  .arg(place.height())
                                  .arg(widget->width())
                                  .arg(widget->height()));
      }
      for (std::size_t j = 0; j < i; ++j) {
        const QRect shared = place & children[j]->geometry();
        if (shared.width() > kSharedPx && shared.height() > kSharedPx) {
          complain(children[i], QStringLiteral("overlaps ") + nameOf(children[j]));
        }
      }
    }
    for (const QWidget* child : children) {
      visit(child);
    }
  }

  // ------------------------------------------------------------------------------ text

  void checkText(const QWidget* widget) {
    if (const auto* elided = qobject_cast<const widgets::ElidedLabel*>(widget)) {
      checkContrast(elided, elided->rect(), elided->text(), elided->font());
    } else if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      if (!label->text().isEmpty()) {
        checkLabel(label);
        checkContrast(label, label->rect(), label->text(), label->font());
      }
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      checkButton(button);
      checkContrast(button, button->rect(), button->text(), button->font());
    } else if (const auto* group = qobject_cast<const QGroupBox*>(widget)) {
      const int needed = group->fontMetrics().horizontalAdvance(group->title());
      if (needed > group->width()) {
        complain(group, QStringLiteral("the title is cut"));
      }
      checkContrast(group, QRect(0, 0, group->width(), group->fontMetrics().height()),
                    group->title(), group->font());
    } else if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
      const QRect room = combo->style()->subControlRect(QStyle::CC_ComboBox, &comboOption(combo),
                                                        QStyle::SC_ComboBoxEditField, combo);
      if (combo->fontMetrics().horizontalAdvance(combo->currentText()) > room.width() &&
          combo->toolTip().isEmpty()) {
        complain(combo, QStringLiteral("cuts \"%1\"").arg(combo->currentText()));
      }
      checkContrast(combo, combo->rect(), combo->currentText(), combo->font());
    } else if (const auto* spin = qobject_cast<const QAbstractSpinBox*>(widget)) {
      const auto* line = spin->findChild<QLineEdit*>();
      checkLine(spin, line);
      checkContrast(spin, spin->rect(), line->text(), spin->font());
    } else if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
      checkLine(line, line);
      checkContrast(line, line->rect(), line->text(), line->font());
    } else if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
      checkTabs(tabs);
    } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
      if (qobject_cast<const QHeaderView*>(widget) == nullptr) {
        checkCells(view);
      }
    }
  }

  void checkLabel(const QLabel* label) {
    const QSize room = label->contentsRect().size();
    if (label->wordWrap()) {
      if (label->heightForWidth(label->width()) > label->height()) {
        complain(label, QStringLiteral("%1 px high, the text needs %2")
                            .arg(label->height())
                            .arg(label->heightForWidth(label->width())));
      }
      // A word longer than the line is cut.
      if (label->textFormat() == Qt::PlainText) {
        // A line may end at a blank, a line feed and a space without width.
        for (const QString& word :
             label->text().split(QRegularExpression(QStringLiteral("[ \n\u200B]")))) {
          if (label->fontMetrics().horizontalAdvance(word) > room.width()) {
            complain(label, QStringLiteral("cuts the word \"%1\"").arg(word));
          }
        }
      }
      return;
    }
    const QSize needed = label->sizeHint();
    if (needed.width() > label->width() || needed.height() > label->height()) {
      complain(label, QStringLiteral("%1x%2, the text needs %3x%4")
                          .arg(label->width())
                          .arg(label->height())
                          .arg(needed.width())
                          .arg(needed.height()));
    }
  }

  void checkButton(const QAbstractButton* button) {
    if (button->text().isEmpty()) {
      return;
    }
    const QString text = QString(button->text()).remove(QLatin1Char('&'));
    const QSize needed = button->fontMetrics().size(Qt::TextShowMnemonic, button->text());
    int room = button->width();
    if (!button->icon().isNull()) {
      room -= button->iconSize().width() + 4;
    } else if (qobject_cast<const QCheckBox*>(button) != nullptr ||
               qobject_cast<const QRadioButton*>(button) != nullptr) {
      room -= button->style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, button) + 4;
    }
    if (needed.width() > room || needed.height() > button->height()) {
      complain(button, QStringLiteral("%1x%2 of room, the text needs %3x%4")
                           .arg(room)
                           .arg(button->height())
                           .arg(needed.width())
                           .arg(needed.height()));
    }
  }

  void checkLine(const QWidget* owner, const QLineEdit* line) {
    const int room = line->contentsRect().width() - 4;
    if (line->fontMetrics().horizontalAdvance(line->displayText()) > room &&
        owner->toolTip().isEmpty()) {
      complain(owner, QStringLiteral("cuts \"%1\"").arg(line->displayText()));
    }
  }

  void checkTabs(const QTabBar* tabs) {
    for (int i = 0; i < tabs->count(); ++i) {
      if (!tabs->isTabVisible(i)) {
        continue;
      }
      const QRect place = tabs->tabRect(i);
      if (!tabs->rect().contains(place)) {
        complain(tabs, QStringLiteral("tab \"%1\" is not wholly visible").arg(tabs->tabText(i)));
      } else if (tabs->fontMetrics().horizontalAdvance(tabs->tabText(i)) > place.width()) {
        complain(tabs, QStringLiteral("tab \"%1\" is cut").arg(tabs->tabText(i)));
      }
      if (tabs->isTabEnabled(i)) {
        checkContrast(tabs, place & tabs->rect(), tabs->tabText(i), tabs->font());
      }
      // A low window is one on a screen scaled to 200 %.
      const int needed = m_window.height() < kLowWindowPx ? kLowTabPx : widgets::kTouchHeightPx;
      if (place.height() < needed) {
        complain(tabs, QStringLiteral("tab \"%1\" is %2 px high, too low for a finger")
                           .arg(tabs->tabText(i))
                           .arg(place.height()));
      }
    }
  }

  void checkCells(const QAbstractItemView* view) {
    const QAbstractItemModel* model = view->model();
    if (model == nullptr) {
      return;
    }
    for (int column = 0; column < model->columnCount(); ++column) {
      int told = 0;
      for (int row = 0; row < model->rowCount() && told == 0; ++row) {
        const QModelIndex index = model->index(row, column);
        const QRect cell = view->visualRect(index);
        const QString text = index.data().toString();
        if (!cell.intersects(view->viewport()->rect()) || text.isEmpty()) {
          continue;
        }
        constexpr int kPaddingPx = 10;
        const int decoration = index.data(Qt::DecorationRole).isValid() ? 20 : 0;
        const QVariant font = index.data(Qt::FontRole);
        const QFontMetrics metrics(font.isValid() ? font.value<QFont>() : view->font());
        const int lines = std::max(1, cell.height() / metrics.lineSpacing());
        const int needed = metrics.horizontalAdvance(text) + kPaddingPx + decoration;
        if (needed > cell.width() * lines && toolTipOf(view, index, cell).isEmpty()) {
          complain(view, QStringLiteral("cuts the cell \"%1\"").arg(text.left(60)));
          ++told;
        }
      }
    }
    const auto* header = view->findChild<QHeaderView*>();
    for (const auto* each : view->findChildren<QHeaderView*>()) {
      if (each->orientation() == Qt::Horizontal && each->isVisible()) {
        header = each;
      }
    }
    if (header != nullptr && header->isVisible() && header->orientation() == Qt::Horizontal) {
      for (int section = 0; section < header->count(); ++section) {
        const QString title = model->headerData(section, Qt::Horizontal).toString();
        if (header->fontMetrics().horizontalAdvance(title) + 6 > header->sectionSize(section) &&
            model->headerData(section, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty()) {
          complain(view, QStringLiteral("cuts the heading \"%1\"").arg(title));
        }
      }
    }
  }

  /// What one reads who points at a cell.
  static QString toolTipOf(const QAbstractItemView* view, const QModelIndex& index,
                           const QRect& cell) {
    QStyleOptionViewItem option;
    option.initFrom(view);
    option.rect = cell;
    auto* asked = const_cast<QAbstractItemView*>(view);
    const QPoint middle = cell.center();
    QHelpEvent event(QEvent::ToolTip, middle, asked->viewport()->mapToGlobal(middle));
    view->itemDelegateForIndex(index)->helpEvent(&event, asked, option, index);
    const QString text = QToolTip::text();
    QToolTip::hideText();
    return text;
  }

  static const QStyleOptionComboBox& comboOption(const QComboBox* combo) {
    static QStyleOptionComboBox option;
    option = {};
    option.initFrom(combo);
    option.editable = combo->isEditable();
    option.frame = combo->hasFrame();
    return option;
  }

  // ------------------------------------------------------------------------------ contrast

  /// The background is the most frequent colour; the ink is what differs most from it. Strokes are
  /// smoothed, so a very thin text counts as paler than it is.
  void checkContrast(const QWidget* widget, const QRect& part, const QString& text,
                     const QFont& font) {
    if (text.trimmed().isEmpty() || !widget->isEnabled()) {
      return;
    }
    const QRect seen = widget->visibleRegion().boundingRect() & part;
    if (seen.isEmpty() || seen != (part & widget->rect())) {
      return;  // half of it is scrolled away: another size shows it
    }
    const qreal ratio = m_picture.devicePixelRatio();
    const QPoint corner = widget->mapTo(&m_window, seen.topLeft());
    const QRect pixels(static_cast<int>(corner.x() * ratio), static_cast<int>(corner.y() * ratio),
                       static_cast<int>(seen.width() * ratio),
                       static_cast<int>(seen.height() * ratio));
    const int border = isControl(widget) ? static_cast<int>(3.0 * ratio) : 0;
    const QRect inside = pixels.adjusted(border, border, -border, -border) & m_picture.rect();
    std::map<QRgb, int> colours;
    std::map<QRgb, int> shades;  // of a surface that is not quite even
    for (int y = inside.top(); y <= inside.bottom(); ++y) {
      for (int x = inside.left(); x <= inside.right(); ++x) {
        const QRgb pixel = m_picture.pixel(x, y);
        ++colours[pixel];
        ++shades[pixel & 0xfff0f0f0];
      }
    }
    if (colours.empty()) {
      return;
    }
    const auto isRarer = [](const auto& a, const auto& b) { return a.second < b.second; };
    const QRgb shade = std::max_element(shades.begin(), shades.end(), isRarer)->first;
    QColor ground(shade);
    int most = 0;
    for (const auto& [colour, count] : colours) {
      if ((colour & 0xfff0f0f0) == shade && count > most) {
        most = count;
        ground = QColor(colour);
      }
    }
    double best = 1.0;
    for (const auto& [colour, count] : colours) {
      best = std::max(best, widgets::contrastRatio(ground, QColor(colour)));
    }
    const double wanted = isLarge(font) ? kContrastLargeMin : kContrastMin;
    if (best < wanted) {
      complain(widget, QStringLiteral("contrast of \"%1\" is %2:1 on %3")
                           .arg(text.left(30))
                           .arg(best, 0, 'f', 1)
                           .arg(ground.name()));
    }
  }

  // ------------------------------------------------------------------------------ controls

  static bool isControl(const QWidget* widget) {
    return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QSlider*>(widget) != nullptr ||
           qobject_cast<const QLineEdit*>(widget) != nullptr;
  }

  void checkTouch(const QWidget* widget) {
    if (isControl(widget) && widget->height() < widgets::kTouchHeightPx) {
      complain(widget, QStringLiteral("%1 px high, too low for a finger").arg(widget->height()));
    }
  }

  void checkName(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool isInput = qobject_cast<const QComboBox*>(widget) != nullptr ||
                         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                         qobject_cast<const QSlider*>(widget) != nullptr ||
                         qobject_cast<const QLineEdit*>(widget) != nullptr ||
                         qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
                         (qobject_cast<const QAbstractItemView*>(widget) != nullptr &&
                          qobject_cast<const QHeaderView*>(widget) == nullptr) ||
                         (button != nullptr && button->text().isEmpty());
    if (!isInput) {
      return;
    }
    QAccessibleInterface* interface =
        QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
    if (interface == nullptr || interface->text(QAccessible::Name).isEmpty()) {
      complain(widget, QStringLiteral("has no name for a screen reader"));
    }
  }

  /// One letter, one control: Alt and that letter must not be a guess.
  void checkMnemonic(const QWidget* widget) {
    QString text;
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      text = button->text();
    } else if (const auto* label = qobject_cast<const QLabel*>(widget);
               label != nullptr && label->buddy() != nullptr) {
      text = label->text();
    }
    const QString keys = QKeySequence::mnemonic(text).toString();
    if (!keys.isEmpty() && !m_mnemonics.emplace(keys, nameOf(widget)).second) {
      complain(widget, QStringLiteral("%1 is also that of %2").arg(keys, m_mnemonics[keys]));
    }
  }

  /// Among controls of one parent, Tab goes the way one reads: never to a row further up.
  void checkFocusOrder() {
    std::map<const QWidget*, const QWidget*> lastIn;
    const QWidget* at = &m_window;
    do {
      at = at->nextInFocusChain();
      if (at->window() != &m_window || !at->isVisible() || !at->isEnabled() ||
          (at->focusPolicy() & Qt::TabFocus) != Qt::TabFocus || at->focusProxy() != nullptr) {
        continue;
      }
      const QWidget*& last = lastIn[at->parentWidget()];
      if (last != nullptr && at->geometry().bottom() < last->geometry().top()) {
        complain(at,
                 QStringLiteral("the focus comes here from further down, from ") + nameOf(last));
      }
      last = at;
    } while (at != &m_window);
  }

  const QWidget& m_window;
  const QImage& m_picture;
  std::map<QString, QString> m_mnemonics;
  QStringList m_faults;
};

class PseudoTranslator final : public QTranslator {
 public:
  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context, const char* source,
                                  const char* /*disambiguation*/, int /*n*/) const override {
    // Qt's own contexts include layouts by text ("LTR") and formats.
    return QLatin1String(context).startsWith(QLatin1Char('Q'))
               ? QString()
               : pseudoText(QString::fromUtf8(source));
  }
};

}  // namespace

QStringList lookFaults(const QWidget& window, const QImage& picture) {
  return Inspector(window, picture).inspect();
}

QString pseudoText(const QString& english) {
  static const std::map<QChar, QChar> kAccents{
      {u'a', u'á'}, {u'e', u'é'}, {u'i', u'í'}, {u'o', u'ó'}, {u'u', u'ú'},
      {u'A', u'Á'}, {u'E', u'É'}, {u'I', u'Í'}, {u'O', u'Ó'}, {u'U', u'Ú'}};
  const qsizetype more = (english.size() * 2 + 4) / 5;
  qsizetype added = 2;  // the brackets
  QString text = QStringLiteral("[");
  for (qsizetype i = 0; i < english.size(); ++i) {
    const QChar sign = english[i];
    if (sign == u'%' && i + 1 < english.size()) {  // %1, %n, %L1
      text += sign;
      text += english[++i];
      continue;
    }
    const auto accent = kAccents.find(sign);
    text += accent == kAccents.end() ? sign : accent->second;
    if (accent != kAccents.end() && added < more && (i == 0 || english[i - 1] != u'&')) {
      text += accent->second;
      ++added;
    }
  }
  for (; added < more; ++added) {
    text += u'x';
  }
  return text + QLatin1Char(']');
}

std::unique_ptr<QTranslator> makePseudoTranslator() {
  return std::make_unique<PseudoTranslator>();
}

}  // namespace rivulet::tests
