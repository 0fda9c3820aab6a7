// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/position_line.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "base/units.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr double kFontPtMin = 9.0;
constexpr double kFontPtMax = 40.0;
constexpr double kDetailPtMin = 9.0;
constexpr double kDetailPtMax = 13.0;
constexpr double kDetailShare = 0.5;  ///< of the size of the digits
constexpr double kNameShare = 0.6;
constexpr int kHeightPxMin = 56;
constexpr int kHeightPxMax = 88;
/// Digits that would be smaller get a row of their own.
constexpr int kDigitsPxMin = 24;
constexpr int kUpperPx = 48;       ///< of two rows
constexpr int kLowerPx = 40;       ///< the second row
constexpr int kLowWindowPx = 600;  ///< lower windows have lower rows
constexpr int kLowUpperPx = 40;
constexpr int kLowLowerPx = 34;
constexpr double kLowerPtMax = 15.0;   ///< of its values
constexpr double kDigitsShare = 0.58;  ///< of the height of a row
constexpr int kGapPx = 8;              ///< between a name and its value
constexpr int kGroupGapPx = 12;        ///< on both sides of the line between two readouts
constexpr int kMarginPx = 12;
/// The longest values that are to fit.
const QString kLongestAxis = QStringLiteral("\u22120000.000");
const QString kLongestFeed = QStringLiteral("00000 mm/min");
const QString kLongestFeedSet = QStringLiteral("00,000");
const QString kLongestOverride = QStringLiteral("000");
const QString kLongestTool = QStringLiteral("0000");
const QString kLongestSpeed = QStringLiteral("\u21BB 00,000");
/// Beside these, the name of the tool has the room that is left.
const QString kLongestEdge = QStringLiteral("D00 \u00B7 G500");
const QString kUsualName = QStringLiteral(" \u00B7 MILL_10");
const QString kLongestCoolant = QStringLiteral(" \u00B7 M8 M7");
/// Narrower lines have less room between the readouts, and none for the name of the tool.
constexpr int kNarrowPx = 1200;
constexpr int kNarrowGapPx = 6;

void setGap(QWidget* group, int leftPx, int rightPx) {
  group->layout()->setContentsMargins(leftPx, 0, rightPx, 0);
}

QFont sized(QFont font, double pointSize) {
  font.setPointSizeF(pointSize);
  font.setBold(true);
  return font;
}

}  // namespace

PositionLine::PositionLine(QWidget* parent)
    : Page(parent),
      m_freshness(new StatusLabel(this, StatusLabel::Elided{2})),
      m_upper(new QHBoxLayout),
      m_lower(new QHBoxLayout) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(kMarginPx, 0, kMarginPx, 0);
  rows->setSpacing(0);
  rows->setSizeConstraint(QLayout::SetNoConstraint);  // the digits adapt instead
  rows->addLayout(m_upper, 1);
  rows->addLayout(m_lower);
  for (QHBoxLayout* row : {m_upper, m_lower}) {
    row->setSpacing(0);
  }
  for (std::size_t i = 0; i < m_readouts.size(); ++i) {
    Readout& readout = m_readouts[i];
    readout = {nullptr, new QLabel(this), new QLabel(this), new QLabel(this)};
    if (i < kAxisReadouts) {
      readout.name->setText(QString(
          QLatin1Char(i < base::kAxisCount ? base::kAxisNames[i]
                                           : base::kRotaryAxisNames[i - base::kAxisCount])));
    }
    readout.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    readout.group = new QWidget(this);
    readout.detail->setAlignment(Qt::AlignRight | Qt::AlignTop);
    auto* grid = new QGridLayout(readout.group);
    grid->setContentsMargins(i == 0 ? 0 : kGroupGapPx, 0, kGroupGapPx, 0);
    grid->setHorizontalSpacing(kGapPx);
    grid->setVerticalSpacing(0);
    grid->addWidget(readout.name, 0, 0, Qt::AlignBottom);
    grid->addWidget(readout.value, 0, 1, Qt::AlignBottom);
    grid->addWidget(readout.detail, 1, 0, 1, 2);
    m_upper->addWidget(readout.group);
  }
  for (Equipment* const shown : {&m_tool, &m_spindle}) {
    *shown = {new QWidget(this), new QLabel(this), new QLabel(this), new ElidedLabel(1, this)};
    shown->value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    shown->detail->setAlignment(Qt::AlignRight | Qt::AlignTop);
    auto* grid = new QGridLayout(shown->group);
    grid->setContentsMargins(kGroupGapPx, 0, kGroupGapPx, 0);
    grid->setHorizontalSpacing(kGapPx);
    grid->setVerticalSpacing(0);
    grid->addWidget(shown->name, 0, 0, Qt::AlignBottom);
    grid->addWidget(shown->value, 0, 1, Qt::AlignBottom);
    // As high as the lines of the other readouts, so that all stand on one line.
    shown->detail->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    grid->addWidget(shown->detail, 1, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    m_upper->addWidget(shown->group);
  }
  m_tool.name->setText(QStringLiteral("T"));
  m_spindle.name->setText(QStringLiteral("S"));
  m_tool.group->setObjectName(QStringLiteral("tool"));
  m_tool.value->setObjectName(QStringLiteral("tool-number"));
  m_tool.detail->setObjectName(QStringLiteral("tool-detail"));
  m_spindle.group->setObjectName(QStringLiteral("spindle"));
  m_spindle.value->setObjectName(QStringLiteral("spindle-speed"));
  m_spindle.detail->setObjectName(QStringLiteral("spindle-detail"));
  m_freshness->setContentsMargins(kGroupGapPx, 0, 0, 0);
  m_upper->addWidget(m_freshness, 1);
  setFixedHeight(kHeightPxMin);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  retranslate();
  restyle();
}

QSize PositionLine::minimumSizeHint() const {
  return {0, height()};
}

void PositionLine::setMachineState(const MachineView& machine) {
  const auto shown = [this] {
    return std::pair(m_tool.group->isVisibleTo(this), m_spindle.group->isVisibleTo(this));
  };
  const auto before = shown();
  const bool sameAxes = machine.rotaryAxes == m_machine.rotaryAxes;
  m_machine = machine;
  showAll();
  const bool sameWidth = sameAxes && shown() == before;
  if (!sameWidth) {
    fitFonts();
  }
}

void PositionLine::retranslate() {
  m_readouts[kFeed].name->setText(tr("Feed"));
  showAll();
  fitFonts();
}

void PositionLine::restyle() {
  for (const Readout& readout : m_readouts) {
    setMuted(readout.name, palette());
  }
  setMuted(m_tool.name, palette());
  setMuted(m_spindle.name, palette());
  showAll();
  update();
}

void PositionLine::showValue(QLabel* label, const QString& text, Freshness freshness,
                             const QColor& color) {
  label->setText(text);
  // Set only where something changes: this is called at every reading.
  if (const bool strikeOut = freshness == Freshness::Old && text != noValue();
      label->font().strikeOut() != strikeOut) {
    QFont font = label->font();
    font.setStrikeOut(strikeOut);
    label->setFont(font);
  }
  const QColor& shown = freshness == Freshness::Live ? color : themeColors(palette()).mutedText;
  if (label->palette().color(QPalette::WindowText) != shown) {
    QPalette colors = label->palette();
    colors.setColor(QPalette::WindowText, shown);
    label->setPalette(colors);
  }
}

void PositionLine::showAll() {
  const QColor color = themeColors(palette()).text;
  const bool standsIn = m_machine.standsIn();
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  const std::optional<base::Vec3>& positionMm =
      standsIn ? std::optional(m_machine.executed->positionMm) : m_machine.positionMm;
  const Freshness position = standsIn ? Freshness::Live : m_machine.positionFreshness();
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    showValue(m_readouts[axis].value, numberText(positionMm ? (*positionMm)[axis] : nan, 3),
              position, color);
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const Readout& readout = m_readouts[base::kAxisCount + axis];
    const QString text = numberText(m_machine.rotaryDeg ? (*m_machine.rotaryDeg)[axis] : nan, 3);
    showValue(readout.value, text == noValue() ? text : text + QStringLiteral("°"),
              m_machine.positionFreshness(), color);
    readout.group->setVisible(m_machine.rotaryAxes[axis]);
  }
  showValue(m_readouts[kFeed].value,
            m_machine.feedMmPerS
                ? QStringLiteral("%1\u00A0mm/min")
                      .arg(numberText(base::mmPerMinFromMmPerS(*m_machine.feedMmPerS), 0))
                : noValue(),
            m_machine.feedFreshness(), color);
  showToGo();
  showFeedSet();
  showTool();
  showSpindle();
  showFreshness();
}

void PositionLine::showTool() {
  const streaming::EquipmentSeen seen = m_machine.equipment.value_or(streaming::EquipmentSeen{});
  const bool isServed = seen.tool || seen.toolName || seen.edge;
  m_tool.group->setVisible(isServed);
  if (!isServed) {
    m_tool.value->clear();
    m_tool.detail->clear();
    return;
  }
  const bool hasName = seen.toolName && !seen.toolName->empty();
  const QString name = hasName ? QString::fromStdString(*seen.toolName) : QString();
  const bool isNamedOnly = hasName && seen.tool.value_or(0) == 0;
  // A tool that has only a name: there is no number to show.
  const QString number = seen.tool && !isNamedOnly ? QString::number(*seen.tool) : noValue();
  QStringList parts;
  QStringList words;
  if (seen.tool || hasName) {
    words.append(seen.tool == 0 && !hasName ? tr("No tool in the spindle")
                                            : tr("Tool %1").arg(isNamedOnly ? name : number));
  }
  if (seen.edge) {
    parts.append(QStringLiteral("D%1").arg(*seen.edge));
    words.append(tr("cutting edge D%1").arg(*seen.edge));
  }
  if (seen.workOffset) {
    parts.append(QString::fromStdString(*seen.workOffset));
    words.append(tr("work offset %1").arg(parts.back()));
  }
  if (hasName) {
    parts.append(name);
    if (!isNamedOnly) {
      words.insert(1, name);
    }
  }
  const ThemeColors& colors = themeColors(palette());
  showValue(m_tool.value, number, m_machine.equipmentFreshness(), colors.text);
  showValue(m_tool.detail, parts.join(QStringLiteral(" \u00B7 ")), m_machine.equipmentFreshness(),
            colors.mutedText);
  describe(m_tool, words.join(QStringLiteral(", ")));
}

void PositionLine::showSpindle() {
  using opcua::SpindleTurn;
  const streaming::EquipmentSeen seen = m_machine.equipment.value_or(streaming::EquipmentSeen{});
  const bool isServed = seen.spindlePerMin || seen.spindleSetPerMin || seen.flood || seen.mist;
  m_spindle.group->setVisible(isServed);
  if (!isServed) {
    m_spindle.value->clear();
    m_spindle.detail->clear();
    return;
  }
  const auto speed = [](const std::optional<double>& perMin) {
    return perMin ? numberText(*perMin, 0) : noValue();
  };
  QString value = speed(seen.spindlePerMin);
  QStringList words{
      tr("Spindle: actual %1, commanded %2 1/min").arg(value, speed(seen.spindleSetPerMin))};
  if (seen.turn == SpindleTurn::Clockwise) {
    value.prepend(QStringLiteral("\u21BB "));
    words.append(tr("clockwise (M3)"));
  } else if (seen.turn == SpindleTurn::Counterclockwise) {
    value.prepend(QStringLiteral("\u21BA "));
    words.append(tr("counterclockwise (M4)"));
  } else if (!seen.turn && seen.spindlePerMin.value_or(0.0) > 0.0) {
    words.append(tr("direction not known"));
  }
  QStringList parts{tr("set %1").arg(speed(seen.spindleSetPerMin))};
  QStringList coolant;
  if (seen.flood.value_or(false)) {
    coolant.append(QStringLiteral("M8"));
  }
  if (seen.mist.value_or(false)) {
    coolant.append(QStringLiteral("M7"));
  }
  if (coolant.isEmpty() && seen.flood && seen.mist) {
    coolant.append(QStringLiteral("M9"));
    words.append(tr("coolant off"));
  } else if (!coolant.isEmpty()) {
    words.append(tr("coolant on (%1)").arg(coolant.join(QLatin1Char(' '))));
  } else {
    words.append(tr("coolant not known"));
  }
  parts.append(coolant);
  const ThemeColors& colors = themeColors(palette());
  showValue(m_spindle.value, value, m_machine.equipmentFreshness(), colors.text);
  showValue(m_spindle.detail, parts.join(QStringLiteral(" \u00B7 ")),
            m_machine.equipmentFreshness(), colors.mutedText);
  describe(m_spindle, words.join(QStringLiteral(", ")));
}

void PositionLine::describe(const Equipment& shown, const QString& text) {
  const QString age = m_machine.equipmentAgeS ? ageText(*m_machine.equipmentAgeS) : noValue();
  const QString tip = m_machine.equipmentFreshness() == Freshness::Live
                          ? tr("%1. The control reports it, about once a second.").arg(text)
                          : tr("%1. Read %2 ago: it may have changed since.").arg(text, age);
  shown.group->setToolTip(tip);
  shown.detail->setToolTip(tip);
  shown.group->setAccessibleName(text);
}

void PositionLine::showToGo() {
  // It belongs to the position that was read, not to a point that stands in for it.
  const bool isKnown = m_machine.toGo && !m_machine.standsIn();
  const QString hint = toGoHint();
  for (std::size_t i = 0; i < kAxisReadouts; ++i) {
    const bool isRotary = i >= base::kAxisCount;
    QString text = noValue();
    if (isKnown) {
      text = isRotary
                 ? numberText(m_machine.toGo->deg[i - base::kAxisCount], 3) + QStringLiteral("°")
                 : numberText(m_machine.toGo->mm[i], 3);
    }
    const Readout& readout = m_readouts[i];
    showValue(readout.detail, m_hasWords ? tr("to go %1").arg(text) : text,
              isKnown ? m_machine.positionFreshness() : Freshness::Live,
              themeColors(palette()).mutedText);
    readout.group->setToolTip(hint);
  }
}

QString PositionLine::toGoHint() const {
  if (m_machine.standsIn()) {
    return tr("Distance to go: not known, because the stream leaves no time to read the axes.");
  }
  if (!m_machine.toGo) {
    return m_machine.feedSetMmPerS
               ? tr("Distance to go: not known. The axes are not on the path of the program, or it "
                    "is being corrected.")
               : tr("Distance to go: the control does not report it.");
  }
  return m_machine.toGo->isComputed
             ? tr("Distance to go to the end of the move in progress, from the position that was "
                  "read and the path of the program")
             : tr("Distance to go to the end of the block, as the control reports it");
}

void PositionLine::showFeedSet() {
  const Readout& readout = m_readouts[kFeed];
  const bool isRun = m_machine.feedSetMmPerS.has_value();
  const QString feed =
      isRun ? numberText(base::mmPerMinFromMmPerS(*m_machine.feedSetMmPerS), 0) : noValue();
  constexpr double kPercent = 100.0;
  QString text = tr("set %1").arg(feed);
  if (m_machine.overrideFactor) {
    text += QStringLiteral(" · %1\u00A0%").arg(numberText(*m_machine.overrideFactor * kPercent, 0));
  }
  showValue(readout.detail, text, Freshness::Live, themeColors(palette()).mutedText);
  const QString dial = tr("The feed override at the control is not read; it acts in addition.");
  QString hint = tr("Commanded feed: not known, because no run of this window is in progress.");
  if (m_machine.overrideFactor) {
    hint = tr("Feed of the program, scaled by the override of the run. %1").arg(dial);
  } else if (isRun) {
    hint = tr("One feed for all moves, without an override. %1").arg(dial);
  }
  readout.group->setToolTip(hint);
}

void PositionLine::showFreshness() {
  if (!m_machine.positionMm && !m_machine.executed) {
    m_freshness->setStatus(Status::Unknown, tr("No data"));
    return;
  }
  const QString age = m_machine.positionAgeS ? ageText(*m_machine.positionAgeS) : noValue();
  const bool isEquipmentOld =
      (m_tool.group->isVisibleTo(this) || m_spindle.group->isVisibleTo(this)) &&
      m_machine.equipmentFreshness() == Freshness::Old;
  if (m_machine.positionFreshness() == Freshness::Live && isEquipmentOld) {
    m_freshness->setStatus(
        Status::Busy,
        tr("Live, but tool and spindle: read %1 ago").arg(ageText(*m_machine.equipmentAgeS)));
  } else if (m_machine.positionFreshness() == Freshness::Live) {
    m_freshness->setStatus(Status::Good, tr("Live"));
  } else if (m_machine.positionFreshness() == Freshness::Planned) {
    m_freshness->setStatus(Status::Busy, m_machine.isPreparing
                                             ? tr("Read %1 ago: the run is being prepared").arg(age)
                                             : tr("Up to 1 s old: no time to read more often"));
  } else if (m_machine.standsIn()) {
    m_freshness->setStatus(Status::Busy, tr("Last executed point, %1. The axes were read %2 ago.")
                                             .arg(countText(m_machine.executed->number), age));
  } else {
    m_freshness->setStatus(Status::Attention, tr("Old: read %1 ago").arg(age));
  }
}

bool PositionLine::isShown(std::size_t readout) const {
  return readout < base::kAxisCount || readout == kFeed ||
         m_machine.rotaryAxes[readout - base::kAxisCount];
}

int PositionLine::edgePx(const QFont& detail) const {
  const QFontMetrics lines(detail);
  return lines.horizontalAdvance(kLongestEdge) +
         (width() < kNarrowPx ? 0 : lines.horizontalAdvance(kUsualName));
}

int PositionLine::setPx(const QFont& detail) const {
  return QFontMetrics(detail).horizontalAdvance(tr("set %1").arg(kLongestFeedSet) +
                                                kLongestCoolant);
}

int PositionLine::feedSetPx(const QFont& detail) {
  return QFontMetrics(detail).horizontalAdvance(tr("set %1").arg(kLongestFeedSet) +
                                                QStringLiteral(" \u00B7 ") + kLongestOverride +
                                                QStringLiteral(" %"));
}

PositionLine::Fit PositionLine::fitIn(bool inTwoRows) const {
  // Measured at one size and scaled: each size that is measured is a font to be loaded.
  constexpr double kProbePt = 10.0;
  const QFontMetrics metrics(sized(font(), kProbePt));
  const QFontMetrics names(sized(font(), kProbePt * kNameShare));
  QFont detail = font();
  detail.setPointSizeF(kProbePt);
  const bool hasTool = m_tool.group->isVisibleTo(this);
  const bool hasSpindle = m_spindle.group->isVisibleTo(this);
  Fit fit;
  fit.gapPx =
      width() < kNarrowPx && (hasTool || hasSpindle || inTwoRows) ? kNarrowGapPx : kGroupGapPx;
  struct Group {
    double valuePx;   ///< with its name
    double detailPx;  ///< the line below
  };
  std::vector<Group> groups;
  const auto add = [&](const QLabel* name, const QString& longest, int detailPx) {
    groups.push_back({static_cast<double>(names.horizontalAdvance(name->text()) +
                                          metrics.horizontalAdvance(longest)),
                      static_cast<double>(detailPx)});
  };
  for (std::size_t i = 0; i < m_readouts.size(); ++i) {
    if (isShown(i) && !(inTwoRows && i == kFeed)) {
      add(m_readouts[i].name, i == kFeed ? kLongestFeed : kLongestAxis,
          i == kFeed ? feedSetPx(detail) : 0);
    }
  }
  if (hasTool && !inTwoRows) {
    add(m_tool.name, kLongestTool, edgePx(detail));
  }
  if (hasSpindle && !inTwoRows) {
    add(m_spindle.name, kLongestSpeed, setPx(detail));
  }
  const auto detailPt = [inTwoRows](double digitsPt) {
    return std::clamp(kDetailShare * digitsPt, kDetailPtMin,
                      inTwoRows ? kDetailPtMin : kDetailPtMax);
  };
  const auto rowPx = [&](double digitsPt) {
    double sumPx = 2.0 * kMarginPx;
    for (const Group& group : groups) {
      sumPx += 2.0 * fit.gapPx + std::max(kGapPx + group.valuePx * digitsPt / kProbePt,
                                          group.detailPx * detailPt(digitsPt) / kProbePt);
    }
    return sumPx;
  };
  // The rest of the line says how old it is.
  const double roomPx = (inTwoRows ? 1.0 : hasTool || hasSpindle ? 0.9 : 0.8) * width();
  const double byHeight = kProbePt * kDigitsShare * heights(inTwoRows).upperPx / metrics.height();
  fit.digitsPt = std::clamp(byHeight, kFontPtMin, kFontPtMax);
  constexpr double kStepPt = 0.25;
  while (fit.digitsPt > kFontPtMin && rowPx(fit.digitsPt) > roomPx) {
    fit.digitsPt = std::max(fit.digitsPt - kStepPt, kFontPtMin);
  }
  QFont small = font();
  small.setPointSizeF(kDetailPtMin);
  const double belowPx = heights(inTwoRows).lowerPx - QFontMetrics(small).height();
  fit.othersPt = inTwoRows
                     ? std::min({fit.digitsPt, kLowerPtMax, kProbePt * belowPx / metrics.height()})
                     : fit.digitsPt;
  fit.detailPt = detailPt(fit.digitsPt);
  return fit;
}

void PositionLine::setRows(bool areTwo) {
  if (areTwo == m_isInTwoRows) {
    return;
  }
  m_isInTwoRows = areTwo;
  QHBoxLayout* const from = areTwo ? m_upper : m_lower;
  QHBoxLayout* const to = areTwo ? m_lower : m_upper;
  for (QWidget* each : {m_readouts[kFeed].group, m_tool.group, m_spindle.group}) {
    from->removeWidget(each);
    to->addWidget(each);
  }
  from->removeWidget(m_freshness);
  to->addWidget(m_freshness, 1);
  if (areTwo) {
    m_upper->addStretch();
  } else {
    delete m_upper->takeAt(static_cast<int>(kAxisReadouts));
  }
}

void PositionLine::fitFonts() {
  Fit fit = fitIn(false);
  setRows(QFontInfo(sized(font(), fit.digitsPt)).pixelSize() < kDigitsPxMin);
  if (m_isInTwoRows) {
    fit = fitIn(true);
  }
  const Heights rows = heights(m_isInTwoRows);
  setFixedHeight(rows.upperPx + rows.lowerPx);
  const QFont digits = sized(font(), fit.digitsPt);
  const QFont others = sized(font(), fit.othersPt);
  QFont small = font();
  small.setPointSizeF(fit.detailPt);
  const QFontMetrics details(small);
  const auto setFont = [](QLabel* label, QFont next) {
    next.setStrikeOut(label->font().strikeOut());
    label->setFont(next);
  };
  const auto setFonts = [&](const auto& readout, const QFont& value) {
    setFont(readout.value, value);
    setFont(readout.detail, small);
    readout.name->setFont(sized(font(), value.pointSizeF() * kNameShare));
  };
  const auto withName = [](const QLabel* name, const QFont& font, const QString& longest) {
    return QFontMetrics(name->font()).horizontalAdvance(name->text()) + kGapPx +
           QFontMetrics(font).horizontalAdvance(longest);
  };
  std::vector<std::pair<QWidget*, int>> widths;  // of the groups
  for (std::size_t i = 0; i < m_readouts.size(); ++i) {
    const Readout& readout = m_readouts[i];
    const QFont& value = i == kFeed ? others : digits;
    setFonts(readout, value);
    const int leftPx = i == 0 || (m_isInTwoRows && i == kFeed) ? 0 : fit.gapPx;
    setGap(readout.group, leftPx, fit.gapPx);
    // The same width whatever the value is: digits that move cannot be read.
    const int valuePx =
        QFontMetrics(value).horizontalAdvance(i == kFeed ? kLongestFeed : kLongestAxis) + 2;
    readout.value->setFixedWidth(valuePx);
    const int contentPx = std::max(readout.name->sizeHint().width() + kGapPx + valuePx,
                                   i == kFeed ? feedSetPx(small) + 2 : 0);
    widths.emplace_back(readout.group, leftPx + contentPx + fit.gapPx);
  }
  m_hasWords = details.horizontalAdvance(tr("to go %1").arg(kLongestAxis)) <=
               withName(m_readouts.front().name, digits, kLongestAxis);
  const auto setWidth = [&](const Equipment& shown, const QString& longest, int detailPx) {
    setFonts(shown, others);
    setGap(shown.group, fit.gapPx, fit.gapPx);
    widths.emplace_back(
        shown.group, std::max(withName(shown.name, others, longest), detailPx) + 2 * fit.gapPx + 2);
  };
  setWidth(m_tool, kLongestTool, edgePx(small));
  setWidth(m_spindle, kLongestSpeed, setPx(small));
  fixGroups(widths, rows);
  showAll();
}

void PositionLine::fixGroups(const std::vector<std::pair<QWidget*, int>>& widths, Heights rows) {
  const auto isInLower = [this](QWidget* group) { return m_lower->indexOf(group) >= 0; };
  int lowerPx = rows.lowerPx;
  for (const auto& [group, widthPx] : widths) {
    if (isInLower(group)) {
      lowerPx = std::max(lowerPx, group->layout()->totalMinimumSize().height());
    }
  }
  const int upperPx = rows.upperPx + rows.lowerPx - lowerPx;
  // No value changes the size of a group, so none lays out the window.
  for (const auto& [group, widthPx] : widths) {
    group->setFixedSize(widthPx, isInLower(group) ? lowerPx : upperPx);
  }
}

PositionLine::Heights PositionLine::heights(bool inTwoRows) const {
  constexpr int kWidthPerHeight = 22;
  constexpr int kWindowPerHeight = 10;
  if (inTwoRows) {
    return window()->height() < kLowWindowPx ? Heights{kLowUpperPx, kLowLowerPx}
                                             : Heights{kUpperPx, kLowerPx};
  }
  return {std::clamp(std::min(width() / kWidthPerHeight, window()->height() / kWindowPerHeight),
                     kHeightPxMin, kHeightPxMax),
          0};
}

void PositionLine::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  fitFonts();
}

void PositionLine::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const ThemeColors& colors = themeColors(palette());
  painter.fillRect(rect(), colors.surface);
  painter.setPen(colors.line);
  painter.drawLine(0, height() - 1, width(), height() - 1);
  const auto drawEdge = [&](const QWidget* group) {
    if (group->isVisible()) {
      const QRect row = group->geometry();
      painter.drawLine(row.right(), row.top() + row.height() / 4, row.right(),
                       row.bottom() - row.height() / 4);
    }
  };
  for (const Readout& readout : m_readouts) {
    drawEdge(readout.group);
  }
  drawEdge(m_tool.group);
  drawEdge(m_spindle.group);
}

}  // namespace rivulet::widgets
