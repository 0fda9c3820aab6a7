// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/icons.h"

#include <QAbstractButton>
#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <QVariant>

#include "base/contract.h"

namespace rivulet::widgets {
namespace {

constexpr auto kIconProperty = "themedIcon";  // what the icon of a button was made of

}  // namespace

QPixmap iconPixmap(const QString& name, const QColor& color, int sizePx, qreal devicePixelRatio) {
  // Drawing takes about a millisecond, and the strip asks for its icons at each update of a run.
  const QString key =
      QStringLiteral("rivulet-icon/%1/%2/%3/%4")
          .arg(name, color.name(), QString::number(sizePx), QString::number(devicePixelRatio));
  if (QPixmap kept; QPixmapCache::find(key, &kept)) {
    return kept;
  }
  QFile file(QStringLiteral(":/rivulet/icons/%1.svg").arg(name));
  const bool found = file.open(QIODevice::ReadOnly);
  RIVULET_ASSERT(found);
  QByteArray svg = file.readAll();
  svg.replace("currentColor", color.name().toLatin1());
  QPixmap pixmap(QSize(sizePx, sizePx) * devicePixelRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  QSvgRenderer renderer(svg);
  renderer.render(&painter);
  painter.end();
  pixmap.setDevicePixelRatio(devicePixelRatio);
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

QIcon themedIcon(const QString& name, const QColor& color) {
  const QColor selected = QGuiApplication::palette().color(QPalette::HighlightedText);
  QIcon icon;
  for (const int size : {16, 20, 24, 32, 48, 64}) {
    icon.addPixmap(iconPixmap(name, color, size));
  }
  for (const int size : {16, 24}) {
    icon.addPixmap(iconPixmap(name, selected, size), QIcon::Selected);
  }
  return icon;
}

void setThemedIcon(QAbstractButton& button, const QString& name, const QColor& color) {
  const QString wanted = name + color.name(QColor::HexArgb);
  if (button.property(kIconProperty) != wanted) {
    button.setProperty(kIconProperty, wanted);
    button.setIcon(themedIcon(name, color));
  }
}

}  // namespace rivulet::widgets
