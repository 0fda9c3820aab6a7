// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gui/widgets/page_test.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QGroupBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTimer>
#include <algorithm>

namespace rivulet::test {

void failOnWarnings() {
  QTest::failOnWarning(
      QRegularExpression(QStringLiteral("^(?!This plugin does not support propagateSizeHints)")));
}

Language::Language() {
  const bool loaded = m_translator.load(QStringLiteral(RIVULET_GERMAN));
  if (!loaded) {
    qFatal("%s cannot be loaded", RIVULET_GERMAN);
  }
  english();
}

Language::~Language() {
  english();
}

void Language::german() {
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  QCoreApplication::installTranslator(&m_translator);
  QCoreApplication::processEvents();  // windows are told by a posted event
}

void Language::english() {
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  if (!QCoreApplication::removeTranslator(&m_translator)) {
    // Nothing was installed: the locale alone may have changed.
    QEvent event(QEvent::LanguageChange);
    QCoreApplication::sendEvent(QCoreApplication::instance(), &event);
  }
  QCoreApplication::processEvents();
}

QString hintOf(const QWidget& widget, const QString& value) {
  const auto labels = widget.findChildren<QLabel*>();
  for (const QLabel* label : labels) {
    if (label->text() == value) {
      return label->parentWidget()->parentWidget()->toolTip();
    }
  }
  return {};
}

QString visibleText(const QWidget& widget) {
  QStringList texts;
  for (const QWidget* child : widget.findChildren<QWidget*>()) {
    if (!child->isVisibleTo(&widget)) {
      continue;
    }
    if (const auto* label = qobject_cast<const QLabel*>(child)) {
      texts.append(label->text());
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(child)) {
      texts.append(button->text());
    } else if (const auto* group = qobject_cast<const QGroupBox*>(child)) {
      texts.append(group->title());
    } else if (const auto* combo = qobject_cast<const QComboBox*>(child)) {
      texts.append(combo->currentText());
    }
  }
  return texts.join(QLatin1Char('\n'));
}

bool settle(const QWidget& widget) {
  const auto rests = [&widget] {
    const auto timers = widget.findChildren<QTimer*>();
    return std::none_of(timers.begin(), timers.end(), [](const QTimer* timer) {
      return timer->isSingleShot() && timer->isActive();
    });
  };
  QCoreApplication::processEvents();  // what begins the timers: layouts, sizes
  return QTest::qWaitFor(rests);
}

QImage picture(QWidget& widget, QSize size) {
  widget.resize(size);
  widget.show();
  if (!settle(widget)) {
    qFatal("the widget never comes to rest");
  }
  return widget.grab().toImage();
}

void keep(const QImage& picture, const QString& name) {
  QDir().mkpath(QStringLiteral(RIVULET_PICTURES));
  const QString path = QStringLiteral(RIVULET_PICTURES "/%1.png").arg(name);
  if (!picture.save(path)) {
    qFatal("%s cannot be written", qPrintable(path));
  }
}

int colourCount(const QImage& picture, int limit) {
  QSet<QRgb> colours;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      colours.insert(picture.pixel(x, y));
      if (colours.size() >= limit) {
        return limit;
      }
    }
  }
  return static_cast<int>(colours.size());
}

QStringList cutTexts(const QWidget& widget) {
  QStringList cut;
  for (const QWidget* child : widget.findChildren<QWidget*>()) {
    if (!child->isVisibleTo(&widget)) {
      continue;
    }
    const QFontMetrics metrics = child->fontMetrics();
    if (const auto* label = qobject_cast<const QLabel*>(child)) {
      if (!label->wordWrap() && !label->text().isEmpty() &&
          label->sizeHint().width() > label->width()) {
        cut.append(label->text());
      }
      if (label->wordWrap() && label->heightForWidth(label->width()) > label->height()) {
        cut.append(label->text());
      }
    } else if (const auto* button = qobject_cast<const QPushButton*>(child)) {
      const int icon = button->icon().isNull() ? 0 : button->iconSize().width();
      if (metrics.horizontalAdvance(button->text()) + icon + 8 > button->width()) {
        cut.append(button->text());
      }
    } else if (const auto* combo = qobject_cast<const QComboBox*>(child)) {
      if (metrics.horizontalAdvance(combo->currentText()) + 24 > combo->width()) {
        cut.append(combo->currentText());
      }
    }
  }
  return cut;
}

}  // namespace rivulet::test
