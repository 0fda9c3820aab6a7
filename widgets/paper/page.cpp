// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/paper/page.h"

#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace rivulet::paper {

namespace {

constexpr double kTitlePt = 16.0;
constexpr double kResultPt = 12.0;
constexpr double kTextPt = 9.0;
constexpr double kSmallPt = 7.5;
constexpr double kMmPerPt = 25.4 / 72.0;
constexpr double kLineMm = 4.6;
constexpr double kRowMm = 3.9;
constexpr double kGapMm = 6.0;  ///< between two groups side by side
constexpr double kPictureMmMax = 85.0;
/// The table gives way to pictures of this height.
constexpr double kPictureMmWanted = 34.0;
constexpr double kPictureMmMin = 25.0;
constexpr double kSignatureMm = 19.0;
constexpr double kFooterMm = 3.2;
/// A map takes this part of a row that it shares with the next picture.
constexpr double kMapShare = 0.38;
constexpr double kMarginMm = 15.0;
const QColor kFaded(0x4d, 0x55, 0x5d);

/// A map stands beside the picture after it.
bool sharesRow(const std::vector<Picture>& pictures, std::size_t i) {
  return pictures[i].isMap && i + 1 < pictures.size() && !pictures[i + 1].isMap;
}

std::size_t pictureRows(const std::vector<Picture>& pictures) {
  std::size_t rows = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i, ++rows) {
    i += sharesRow(pictures, i) ? 1 : 0;
  }
  return rows;
}

/// Height of the pictures of a row with its share of the room, caption excluded.
double pictureHeightMm(double roomMm, std::size_t rows) {
  const double share = roomMm / static_cast<double>(std::max<std::size_t>(rows, 1)) - kLineMm - 1.0;
  return std::clamp(share, kPictureMmMin, kPictureMmMax);
}

/// Draws from the top of the page to its end.
class PagePainter {
 public:
  PagePainter(QPainter& painter, const QRectF& room, double millimetre)
      : m_painter(painter), m_room(room), m_mm(millimetre), m_y(room.top()) {}

  void heading(const QString& text, double sizePt, const QColor& color = Qt::black) {
    font(sizePt, true);
    m_painter.setPen(color);
    const double height = sizePt * 0.55 * m_mm;
    m_painter.drawText(QRectF(m_room.left(), m_y, m_room.width(), height),
                       Qt::AlignLeft | Qt::AlignVCenter, elided(text, m_room.width()));
    m_painter.setPen(Qt::black);
    m_y += height + m_mm;
  }
  void sentence(const QString& text) {
    font(kTextPt, false);
    const QRectF room(m_room.left(), m_y, m_room.width(), m_room.height());
    QRectF drawn;
    m_painter.drawText(room, Qt::AlignLeft | Qt::TextWordWrap, text, &drawn);
    m_y += drawn.height() + m_mm;
  }
  void section(const Section& section) {
    font(kTextPt + 1.0, true);
    const double line = kLineMm * m_mm;
    m_painter.drawText(QRectF(m_room.left(), m_y, m_room.width(), line),
                       Qt::AlignLeft | Qt::AlignVCenter, section.title);
    m_y += line + 0.5 * m_mm;
    for (const QString& text : section.sentences) {
      sentence(text);
    }
    m_y += m_mm;
  }
  void rule() {
    m_painter.setPen(QPen(Qt::gray, 0.2 * m_mm));
    m_painter.drawLine(QPointF(m_room.left(), m_y), QPointF(m_room.right(), m_y));
    m_painter.setPen(Qt::black);
    m_y += 2.0 * m_mm;
  }
  void groups(const std::vector<Group>& groups) {
    const double width = (m_room.width() - kGapMm * m_mm) / 2.0;
    for (std::size_t i = 0; i < groups.size(); i += 2) {
      const double top = m_y;
      group(m_room.left(), width, groups[i]);
      const double bottom = m_y;
      if (i + 1 < groups.size()) {
        m_y = top;
        group(m_room.left() + width + kGapMm * m_mm, width, groups[i + 1]);
      }
      m_y = std::max(m_y, bottom) + 2.0 * m_mm;
    }
  }
  void pictures(const std::vector<Picture>& pictures, double heightMm) {
    const double gap = 3.0 * m_mm;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      if (sharesRow(pictures, i)) {
        const double width = kMapShare * m_room.width();
        picture(pictures[i], m_room.left(), width - gap, heightMm);
        ++i;
        picture(pictures[i], m_room.left() + width, m_room.width() - width, heightMm);
      } else {
        picture(pictures[i], m_room.left(), m_room.width(), heightMm);
      }
      m_y += (kLineMm + heightMm + 1.0) * m_mm;
    }
  }
  void table(const Table& table, qsizetype rows) {
    font(kTextPt + 1.0, true);
    m_y += m_mm;
    const double line = kLineMm * m_mm;
    m_painter.drawText(QRectF(m_room.left(), m_y, m_room.width(), line),
                       Qt::AlignLeft | Qt::AlignVCenter, table.title);
    m_y += line;
    font(kTextPt - 1.0, false);
    m_painter.setPen(kFaded);
    row(table, table.headings);
    m_painter.setPen(Qt::black);
    for (qsizetype i = 0; i < rows; ++i) {
      row(table, table.rows[i]);
    }
  }
  void signature(const QString& text) {
    const double y = m_room.bottom() - 12.0 * m_mm;
    m_painter.drawLine(QPointF(m_room.left(), y), QPointF(m_room.left() + 80.0 * m_mm, y));
    font(kSmallPt, false);
    m_painter.drawText(QPointF(m_room.left(), y + 3.5 * m_mm), text);
  }
  void footer(const QStringList& lines) {
    font(kSmallPt - 1.0, false);
    m_painter.setPen(kFaded);
    double y = m_room.bottom();
    for (qsizetype i = lines.size(); i-- > 0;) {
      y -= kFooterMm * m_mm;
      m_painter.drawText(QRectF(m_room.left(), y, m_room.width(), kFooterMm * m_mm),
                         Qt::AlignLeft | Qt::AlignVCenter, elided(lines[i], m_room.width()));
    }
    m_painter.setPen(Qt::black);
  }
  /// What is left above the line to sign, mm.
  [[nodiscard]] double leftMm() const { return (m_room.bottom() - m_y) / m_mm - kSignatureMm; }

 private:
  void font(double sizePt, bool isBold) {
    QFont font = m_painter.font();
    // In the units of the page: the same on paper and in a picture.
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(sizePt * kMmPerPt * m_mm))));
    font.setBold(isBold);
    m_painter.setFont(font);
  }
  [[nodiscard]] QString elided(const QString& text, double width) const {
    return QFontMetricsF(m_painter.font(), m_painter.device())
        .elidedText(text, Qt::ElideMiddle, width);
  }
  void picture(const Picture& picture, double left, double width, double heightMm) {
    font(kTextPt, false);
    m_painter.setPen(kFaded);
    const QRectF caption(left, m_y, width, kLineMm * m_mm);
    m_painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter, elided(picture.caption, width));
    m_painter.setPen(Qt::black);
    paintPicture(m_painter, QRectF(left, caption.bottom(), width, heightMm * m_mm), m_mm, picture);
  }
  /// Names take what they need, but leave the values room.
  [[nodiscard]] double nameWidth(const Group& group, double width) const {
    const QFontMetricsF metrics(m_painter.font(), m_painter.device());
    double widest = 0.0;
    for (const Fact& fact : group.facts) {
      widest = std::max(widest, metrics.horizontalAdvance(fact.name));
    }
    return std::clamp(widest + 2.5 * m_mm, 0.42 * width, 0.7 * width);
  }
  void group(double left, double width, const Group& group) {
    font(kTextPt + 1.0, true);
    const double line = kLineMm * m_mm;
    m_painter.drawText(QRectF(left, m_y, width, line), Qt::AlignLeft | Qt::AlignVCenter,
                       group.title);
    m_y += line + 0.5 * m_mm;
    font(kTextPt, false);
    const double names = nameWidth(group, width);
    for (const Fact& fact : group.facts) {
      m_painter.setPen(kFaded);
      m_painter.drawText(QRectF(left, m_y, names, line), Qt::AlignLeft | Qt::AlignVCenter,
                         elided(fact.name, names - m_mm));
      m_painter.setPen(Qt::black);
      // A long value begins earlier where its name is short.
      const QFontMetricsF metrics(m_painter.font(), m_painter.device());
      const double own = metrics.horizontalAdvance(fact.name) + 1.5 * m_mm;
      const double at =
          std::min(names, std::max(own, width - metrics.horizontalAdvance(fact.value) - m_mm));
      m_painter.drawText(QRectF(left + at, m_y, width - at, line), Qt::AlignLeft | Qt::AlignVCenter,
                         elided(fact.value, width - at));
      m_y += line;
    }
  }
  void row(const Table& table, const QStringList& cells) {
    const double all = std::accumulate(table.widths.begin(), table.widths.end(), 0.0);
    double x = m_room.left();
    for (std::size_t i = 0; i < table.widths.size(); ++i) {
      const double width = m_room.width() * table.widths[i] / all;
      m_painter.drawText(QRectF(x, m_y, width, kRowMm * m_mm), Qt::AlignLeft | Qt::AlignVCenter,
                         elided(cells.value(static_cast<qsizetype>(i)), width - m_mm));
      x += width;
    }
    m_y += kRowMm * m_mm;
  }

  QPainter& m_painter;
  QRectF m_room;
  double m_mm;
  double m_y;
};

QColor colorOf(Rating rating) {
  return rating == Rating::Good
             ? QColor(0x1b, 0x6e, 0x2f)
             : (rating == Rating::Bad ? QColor(0xb0, 0x2a, 0x1d) : QColor(Qt::black));
}

/// Rows of the table that leave the pictures enough room.
qsizetype rowsThatFit(const Page& page, double leftMm) {
  const double pictures =
      static_cast<double>(pictureRows(page.pictures)) * (kPictureMmWanted + kLineMm + 1.0);
  const double rows = std::floor((leftMm - pictures - kLineMm - 2.0) / kRowMm) - 1.0;
  return std::clamp<qsizetype>(static_cast<qsizetype>(rows), 0, page.table.rows.size());
}

constexpr double kHtmlWidthMm = 180.0;
constexpr double kHtmlPictureMm = 48.0;
/// One sheet of paper, and one column on a narrow screen.
constexpr const char* kStyle =
    "@page{size:A4;margin:12mm 14mm}html{background:#fff}body{font:13px/1.35 "
    "sans-serif;color:#1c2430;"
    "max-width:720px;margin:16px auto;padding:0 8px}h1{font-size:21px;margin:0 0 4px}h2{font-size:"
    "14px;margin:8px 0 3px}p{margin:3px 0}.result{font-weight:bold;font-size:16px;margin:4px 0;"
    "padding-bottom:5px;border-bottom:1px solid #888}.good{color:#1b6e2f}.bad{color:#b02a1d}"
    ".groups{display:grid;grid-template-columns:1fr 1fr;gap:0 22px}dl{display:grid;"
    "grid-template-columns:fit-content(60%) 1fr;align-content:start;gap:0 "
    "14px;margin:0}dt{color:#4d555d}dd{margin:0;overflow-wrap:anywhere}"
    ".row{display:grid;grid-template-columns:38fr 62fr;gap:0 6px;align-items:end}figure{margin:6px "
    "0;break-inside:avoid}svg{width:100%;height:auto;display:block}svg text{"
    "font-family:sans-serif}figcaption{color:#4d555d}table{border-collapse:collapse;width:100%}"
    "td,th{text-align:left;padding:0 10px 0 0;vertical-align:top}th{font-weight:normal;color:"
    "#4d555d}.sign{margin-top:44px;border-top:1px solid #1c2430;width:45%;font-size:11px}footer{"
    "color:#4d555d;font-size:11px;overflow-wrap:anywhere}"
    "@media print{body{font-size:10px;line-height:1.2;margin:0 auto;padding:0}h1{font-size:18px}"
    "h2{font-size:12px}.result{font-size:14px}figure{margin:3px 0}.sign{margin-top:28px}.sign,"
    "footer{font-size:9px}}"
    "@media screen and (max-width:600px){.groups,.row{grid-template-columns:minmax(0,1fr)}"
    "td,th{padding-right:6px}.sign{width:auto}}";

QString cells(const QStringList& texts, const QString& tag) {
  QString out = QStringLiteral("<tr>");
  for (const QString& text : texts) {
    out += QStringLiteral("<%1>%2</%1>").arg(tag, text.toHtmlEscaped());
  }
  return out + QStringLiteral("</tr>\n");
}

}  // namespace

void paintPage(QPainter& painter, const QRectF& room, double millimetre, const Page& page) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::black);
  PagePainter drawn(painter, room, millimetre);
  drawn.heading(page.title, kTitlePt);
  drawn.heading(page.result, kResultPt, colorOf(page.rating));
  for (const QString& sentence : page.sentences) {
    drawn.sentence(sentence);
  }
  drawn.rule();
  drawn.groups(page.groups);
  drawn.rule();
  for (const Section& section : page.sections) {
    drawn.section(section);
  }
  const qsizetype rows = rowsThatFit(page, drawn.leftMm());
  const double tableMm = rows == 0 ? 0.0 : kLineMm + 2.0 + kRowMm * static_cast<double>(rows + 1);
  drawn.pictures(page.pictures,
                 pictureHeightMm(drawn.leftMm() - tableMm, pictureRows(page.pictures)));
  if (rows > 0) {
    drawn.table(page.table, rows);
  }
  drawn.signature(page.signature);
  drawn.footer(page.footer);
}

bool writePdf(const QString& path, const Page& page) {
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) {
    return false;
  }
  {
    QPdfWriter writer(&file);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm),
                          QPageLayout::Millimeter);
    writer.setTitle(page.title);
    constexpr int kDotsPerInch = 600;
    constexpr double kMmPerInch = 25.4;
    writer.setResolution(kDotsPerInch);
    QPainter painter(&writer);
    if (!painter.isActive()) {
      return false;
    }
    paintPage(painter, QRectF(0, 0, writer.width(), writer.height()), kDotsPerInch / kMmPerInch,
              page);
  }
  return file.commit();
}

QString pageHtml(const Page& page) {
  const QString rating = page.rating == Rating::Good  ? QStringLiteral("good")
                         : page.rating == Rating::Bad ? QStringLiteral("bad")
                                                      : QString();
  QString out = QStringLiteral(
                    "<!DOCTYPE html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"><meta "
                    "name=\"viewport\" content=\"width=device-width\"><title>%2</title>"
                    "<style>%3</style></head><body>\n")
                    .arg(page.language, page.title.toHtmlEscaped(), QString::fromLatin1(kStyle));
  out += QStringLiteral("<h1>%1</h1>\n<div class=\"result %2\">%3</div>\n")
             .arg(page.title.toHtmlEscaped(), rating, page.result.toHtmlEscaped());
  for (const QString& sentence : page.sentences) {
    out += QStringLiteral("<p>%1</p>\n").arg(sentence.toHtmlEscaped());
  }
  out += QStringLiteral("<div class=\"groups\">\n");
  for (const Group& group : page.groups) {
    out += QStringLiteral("<section><h2>%1</h2><dl>\n").arg(group.title.toHtmlEscaped());
    for (const Fact& fact : group.facts) {
      out += QStringLiteral("<dt>%1</dt><dd>%2</dd>\n")
                 .arg(fact.name.toHtmlEscaped(), fact.value.toHtmlEscaped());
    }
    out += QStringLiteral("</dl></section>\n");
  }
  out += QStringLiteral("</div>\n");
  for (const Section& section : page.sections) {
    out += QStringLiteral("<h2>%1</h2>\n").arg(section.title.toHtmlEscaped());
    for (const QString& sentence : section.sentences) {
      out += QStringLiteral("<p>%1</p>\n").arg(sentence.toHtmlEscaped());
    }
  }
  const auto figure = [&out](const Picture& picture, double share) {
    const QSizeF millimetres(share * kHtmlWidthMm, kHtmlPictureMm);
    out += QStringLiteral("<figure><figcaption>") + picture.caption.toHtmlEscaped() +
           QStringLiteral("</figcaption>") +
           QString::fromUtf8(pictureSvg(picture, millimetres, false)) +
           QStringLiteral("</figure>\n");
  };
  for (std::size_t i = 0; i < page.pictures.size(); ++i) {
    if (sharesRow(page.pictures, i)) {
      out += QStringLiteral("<div class=\"row\">");
      figure(page.pictures[i], kMapShare);
      figure(page.pictures[++i], 1.0 - kMapShare);
      out += QStringLiteral("</div>\n");
    } else {
      figure(page.pictures[i], 1.0);
    }
  }
  if (!page.table.rows.isEmpty()) {
    out += QStringLiteral("<h2>%1</h2>\n<table>\n").arg(page.table.title.toHtmlEscaped());
    out += cells(page.table.headings, QStringLiteral("th"));
    for (const QStringList& row : page.table.rows) {
      out += cells(row, QStringLiteral("td"));
    }
    out += QStringLiteral("</table>\n");
  }
  out +=
      QStringLiteral("<div class=\"sign\">%1</div>\n<footer>").arg(page.signature.toHtmlEscaped());
  for (const QString& line : page.footer) {
    out += line.toHtmlEscaped() + QStringLiteral("<br>");
  }
  return out + QStringLiteral("</footer>\n</body></html>\n");
}

}  // namespace rivulet::paper
