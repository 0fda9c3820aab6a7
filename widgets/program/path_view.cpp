// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/program/path_view.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/number_format.h"
#include "widgets/common/ramp.h"
#include "widgets/common/theme.h"
#include "widgets/plots/legend_strip.h"

namespace rivulet::widgets {

namespace {

constexpr double kStepsPerS = 1000.0;  // of the slider, by time

/// What decides the classes.
struct Wanted {
  std::shared_ptr<const overview::ProgramView> program;
  std::shared_ptr<const overview::ProgramTimes> times;
  std::shared_ptr<const overview::PauseMap> pauses;
  feasibility::OperatingPoint point;
  feasibility::AccessModel access;
  bool ownFeeds = false;
  overview::PathColouring colouring = overview::PathColouring::Kind;
};

overview::PathClasses classesOf(const Wanted& wanted) {
  const overview::ProgramView& program = *wanted.program;
  switch (wanted.colouring) {
    case overview::PathColouring::Feed:
      return overview::classesByFeed(program);
    case overview::PathColouring::Margin:
      return overview::classesByMargin(program, wanted.point, wanted.access, wanted.ownFeeds);
    case overview::PathColouring::Pauses:
      return overview::classesByPauses(program, wanted.pauses.get());
    case overview::PathColouring::Time:
      // Until the times are known the path is shown as one class.
      return overview::classesByTime(
          wanted.times ? wanted.times->atS : std::vector<float>(program.points.points.size()));
    case overview::PathColouring::Kind:
      break;
  }
  return overview::classesByKind(program);
}

}  // namespace

PathView::PathView(QWidget* parent)
    : Page(parent),
      m_canvas(new PathCanvas(this)),
      m_tools(new QBoxLayout(QBoxLayout::TopToBottom)),
      m_legend(new LegendStrip(this)),
      m_slider(
          say(new QSlider(Qt::Horizontal, this), {.hint = QT_TR_NOOP("Walk along the path")})) {
  auto* group = new QButtonGroup(this);
  int id = 0;
  for (QPushButton* button : views()) {
    button->setCheckable(true);
    group->addButton(button, id++);
  }
  m_showPauses->setCheckable(true);
  m_showPauses->setChecked(true);
  m_scale->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // the language may change
  m_slider->setMinimumHeight(32);
  auto* scrub = inRow({{m_slider, 1}, m_scale});
  m_tools->addLayout(inRow({{m_space, 1}, {m_top, 1}, {m_front, 1}, {m_side, 1}, m_fit}), 1);
  m_tools->addLayout(inRow({{m_colour, 1}, m_showPauses}), 1);
  inColumn({m_tools, m_legend, {m_canvas, 1}, scrub, m_place}, this);
  setTabOrder(m_showPauses, m_canvas);
  setTabOrder(m_canvas, m_slider);
  setTabOrder(m_slider, m_scale);
  connect(group, &QButtonGroup::idClicked, this,
          [this](int view) { setView(static_cast<PathCanvas::View>(view)); });
  setView(PathCanvas::View::Space);
  connect(m_colour, &QComboBox::activated, this,
          [this](int index) { setColouring(static_cast<overview::PathColouring>(index)); });
  connect(m_showPauses, &QPushButton::toggled, this, &PathView::showPauses);
  connect(m_scale, &QComboBox::currentIndexChanged, this, &PathView::setScale);
  connect(m_slider, &QSlider::valueChanged, this, &PathView::scrub);
  connect(m_canvas, &PathCanvas::pointClicked, this, [this](std::size_t point) {
    m_canvas->setSelected({static_cast<std::uint32_t>(point)});
    m_marked = point;
    m_canvas->setMarked(point);
    moveSlider();
    showPlace();
    Q_EMIT pointChosen(point);
  });
  retranslate();
  onTheme(&PathView::showClasses);
}

void PathView::setProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_program = std::move(view);
  m_times.reset();
  m_pauses.reset();
  m_marked.reset();
  m_canvas->setProgram(m_program);
  recolour();
  setScale();
}

void PathView::replaceProgram(std::shared_ptr<const overview::ProgramView> view) {
  m_program = std::move(view);
  if (m_times && m_times->atS.size() != pointCount()) {
    m_times.reset();
  }
  m_pauses.reset();  // they lie at points of the list before
  m_canvas->replaceProgram(m_program);
  if (m_marked && *m_marked >= pointCount()) {
    m_marked.reset();
  }
  recolour();
  setScale();
}

void PathView::setTimes(std::shared_ptr<const overview::ProgramTimes> times) {
  m_times = std::move(times);
  if (m_times && m_times->atS.size() != pointCount()) {
    m_times.reset();  // of a program that is gone
  }
  if (m_colouring == overview::PathColouring::Time) {
    recolour();
  }
  setScale();
}

void PathView::setPauses(std::shared_ptr<const overview::PauseMap> pauses) {
  m_pauses = std::move(pauses);
  if (m_colouring == overview::PathColouring::Pauses) {
    recolour();
  }
  showPauses();
}

void PathView::setPausesShown(bool shown) {
  m_showPauses->setChecked(shown);
}

void PathView::showPauses() {
  m_canvas->setPauses(m_showPauses->isChecked() ? m_pauses : nullptr);
  showLegend();
  showPlace();
}

void PathView::setOperatingPoint(const feasibility::OperatingPoint& point,
                                 const feasibility::AccessModel& access, bool ownFeeds) {
  const bool same = ownFeeds == m_ownFeeds && point.turn() == m_point.turn() &&
                    point.feedMmPerS == m_point.feedMmPerS &&
                    access.timePerNode(point.turn()) == m_access.timePerNode(point.turn());
  m_point = point;
  m_access = access;
  m_ownFeeds = ownFeeds;
  if (!same && m_colouring == overview::PathColouring::Margin) {
    recolour();
  }
}

void PathView::setRunBegin(std::size_t point) {
  m_canvas->setRunBegin(point);
}

void PathView::setExecuted(std::size_t count) {
  m_canvas->setExecuted(count);
}

void PathView::setToolPosition(const std::optional<base::Vec3>& positionMm) {
  m_canvas->setToolPosition(positionMm);
}

void PathView::setBox(const std::optional<live::Agreement>& agreed) {
  m_canvas->setBox(agreed ? std::optional(PathCanvas::Box{agreed->lowestMm, agreed->highestMm})
                          : std::nullopt);
}

void PathView::setView(PathCanvas::View view) {
  views().at(static_cast<std::size_t>(view))->setChecked(true);
  m_canvas->setView(view);
}

std::array<QPushButton*, 4> PathView::views() const {
  return {m_space, m_top, m_front, m_side};
}

void PathView::setColouring(overview::PathColouring colouring) {
  m_colouring = colouring;
  m_colour->setCurrentIndex(static_cast<int>(colouring));
  recolour();
}

void PathView::markPoint(std::size_t point) {
  if (point >= pointCount()) {
    return;
  }
  m_marked = point;
  m_canvas->setMarked(point);
  m_canvas->reveal(point);
  moveSlider();
  showPlace();
}

void PathView::selectPoints(const std::vector<std::uint32_t>& points) {
  m_canvas->setSelected(points);
  if (!points.empty()) {
    markPoint(points.front());
  }
}

void PathView::fit() {
  m_canvas->fit();
}

PathCanvas::Texts PathView::canvasTexts() {
  return {tr("No program is loaded"),
          tr("The points appear here as they come"),
          tr("Start"),
          tr("Tool"),
          tr("Pause off the cut, after point %1, line %2"),
          tr("Pause in the cut, after point %1, line %2"),
          tr("Grid %1")};
}

void PathView::retranslate() {
  m_canvas->setTexts(canvasTexts());
  showLegend();
  showPlace();
}

std::size_t PathView::pointCount() const {
  return m_program ? m_program->points.points.size() : 0;
}

bool PathView::scrubsByTime() const {
  return m_scale->currentIndex() == 1 && m_times;
}

void PathView::recolour() {
  const unsigned order = ++*m_ordered;
  if (!m_program || m_colouring == overview::PathColouring::Kind) {
    m_shown = m_program ? m_program->kinds : std::make_shared<const overview::DrawnClasses>();
    showClasses();
    return;
  }
  auto find = [ordered = m_ordered, order, path = QPointer<PathView>(this),
               wanted = Wanted{m_program, m_times, m_pauses, m_point, m_access, m_ownFeeds,
                               m_colouring}]() -> std::function<void()> {
    if (*ordered != order) {
      return [] {};
    }
    return [ordered, order, path, classes = drawnClasses(classesOf(wanted), *wanted.program)] {
      if (path && *ordered == order) {
        path->m_shown = classes;
        path->showClasses();
      }
    };
  };
  if (!m_elsewhere || pointCount() <= overview::kPointsAtOnce) {
    find()();
    return;
  }
  if (!m_canvas->hasClasses()) {
    m_shown = m_program->kinds;  // meanwhile
    showClasses();
  }
  m_elsewhere(std::move(find));
}

void PathView::showClasses() {
  m_canvas->setStyle({m_program ? m_shown : nullptr, pens()});
  showLegend();
}

std::vector<QPen> PathView::pens() const {
  std::vector<QPen> pens;
  for (std::size_t one = 0; one < classes().count; ++one) {
    pens.push_back(penOf(one));
  }
  return pens;
}

std::size_t PathView::pathClasses() const {
  return classes().count - (classes().hasGaps ? 1 : 0);
}

QPen PathView::penOf(std::size_t one) const {
  if (one == pathClasses()) {
    return Qt::NoPen;  // the canvas draws what is known of it on top
  }
  const ThemeColors& colors = themeColors(palette());
  QPen rapid(colors.rapid, 1.2);
  rapid.setDashPattern({5.0, 4.0});
  const auto share = [&](std::size_t of, std::size_t count) {
    return count < 2 ? 0.0 : static_cast<double>(of) / static_cast<double>(count - 1);
  };
  switch (classes().colouring) {
    case overview::PathColouring::Kind: {
      switch (static_cast<overview::KindClass>(one)) {
        case overview::KindClass::Rapid:
          return rapid;
        case overview::KindClass::Line:
          break;
        case overview::KindClass::Arc:
          return {colors.equations[2], 1.4};
        case overview::KindClass::Spline:
          return {colors.equations[3], 1.4};
      }
      return {colors.path, 1.4};
    }
    case overview::PathColouring::Feed:
      return one == 0 ? rapid : QPen(rampColor(share(one - 1, pathClasses() - 1), colors), 1.6);
    case overview::PathColouring::Margin: {
      const std::array<QColor, overview::kMarginClasses> shown{colors.path, colors.equations[2],
                                                               colors.attention, colors.fault};
      return {shown.at(one), one < 2 ? 1.4 : 2.2};
    }
    case overview::PathColouring::Pauses:
      return one == 0 ? QPen(colors.path, 1.4)
                      : QPen(rampColor(share(one - 1, pathClasses() - 1), colors), 2.0);
    case overview::PathColouring::Time:
      break;
  }
  return m_times ? QPen(rampColor(share(one, pathClasses()), colors), 1.6) : QPen(colors.path, 1.4);
}

QString PathView::nameOf(std::size_t one) const {
  const std::vector<double>& borders = classes().borders;
  const auto range = [](const QString& from, const QString& to) {
    return QStringLiteral("%1 \u2026 %2").arg(from, to);
  };
  switch (classes().colouring) {
    case overview::PathColouring::Kind:
      switch (static_cast<overview::KindClass>(one)) {
        case overview::KindClass::Rapid:
          return tr("Rapid");
        case overview::KindClass::Line:
          return tr("Line");
        case overview::KindClass::Arc:
          return tr("Arc");
        case overview::KindClass::Spline:
          return tr("Spline");
      }
      return {};
    case overview::PathColouring::Feed:
      if (one == 0) {
        return tr("Rapid");
      }
      if (classes().eachFeedItsOwn) {
        return borders[one - 1] > 0.0 ? feedText(borders[one - 1]) : tr("no feed given");
      }
      return range(feedText(borders[one - 1]).section(QChar(0x00A0), 0, 0), feedText(borders[one]));
    case overview::PathColouring::Margin: {
      const std::array<QString, overview::kMarginClasses> names{
          tr("margin over %1").arg(factorText(overview::kMarginAmple)),
          range(factorText(overview::kMarginFair), factorText(overview::kMarginAmple)),
          range(factorText(overview::kMarginNone), factorText(overview::kMarginFair)),
          tr("not kept (below %1)").arg(factorText(overview::kMarginNone))};
      return names.at(one);
    }
    case overview::PathColouring::Pauses:
      if (one == 0 || borders.empty()) {
        return m_pauses ? tr("no pause") : tr("computing …");
      }
      return tr("a pause every %1")
          .arg(range(numberText(borders[one], borders[one] < 10.0 ? 2 : 0),
                     lengthText(borders[one - 1], borders[one - 1] < 10.0 ? 2 : 0)));
    case overview::PathColouring::Time:
      return tr("to %1").arg(durationText(borders[one + 1]));
  }
  return {};
}

void PathView::showLegend() {
  std::vector<LegendEntry> entries;
  if (m_program) {
    if (classes().colouring == overview::PathColouring::Time && !m_times) {
      entries.push_back({LegendEntry::Symbol::Line, penOf(0), {}, tr("computing …")});
    } else {
      for (std::size_t one = 0; one < pathClasses(); ++one) {
        if (m_shown->present[one]) {
          entries.push_back({LegendEntry::Symbol::Line, penOf(one), {}, nameOf(one)});
        }
      }
    }
    entries.push_back(
        {LegendEntry::Symbol::Line, QPen(themeColors(palette()).accent, 3.0), {}, tr("Executed")});
    showJobLegend(entries);
    if (m_pauses && m_showPauses->isChecked()) {
      const ThemeColors& colors = themeColors(palette());
      entries.push_back(
          {LegendEntry::Symbol::Square, QPen(colors.text, 1.4), colors.surface,
           tr("%Ln pauses off the cut", nullptr, static_cast<int>(m_pauses->offCut.size()))});
      entries.push_back({LegendEntry::Symbol::Triangle, QPen(colors.surface, 1.2), colors.attention,
                         tr("%1 in the cut").arg(countText(m_pauses->inCut.size()))});
    }
  }
  m_legend->setEntries(std::move(entries));
}

void PathView::showJobLegend(std::vector<LegendEntry>& entries) const {
  const ThemeColors& colors = themeColors(palette());
  const auto& gaps = m_program->gaps;
  if (std::any_of(gaps.begin(), gaps.end(), [](const auto& gap) { return gap.isKnown(); })) {
    QPen native(colors.native, 2.0);
    native.setDashPattern({1.5, 2.0});
    entries.push_back({LegendEntry::Symbol::Line, native, {}, tr("By the control")});
  }
  if (!m_program->toolChanges.empty()) {
    entries.push_back({LegendEntry::Symbol::Diamond, QPen(colors.native, 1.6), colors.surface,
                       tr("Tool change")});
  }
}

void PathView::setScale() {
  auto* items = qobject_cast<QStandardItemModel*>(m_scale->model());
  items->item(1)->setEnabled(m_times != nullptr);
  {
    const QSignalBlocker quiet(m_slider);
    const std::size_t count = pointCount();
    m_slider->setEnabled(count > 1);
    m_slider->setMinimum(0);
    m_slider->setMaximum(scrubsByTime()
                             ? static_cast<int>(std::lround(m_times->atS.back() * kStepsPerS))
                             : static_cast<int>(count > 0 ? count - 1 : 0));
    m_slider->setPageStep(std::max(1, m_slider->maximum() / 20));
  }
  moveSlider();
  showPlace();
}

void PathView::moveSlider() {
  const QSignalBlocker quiet(m_slider);
  const std::size_t point = m_marked.value_or(0);
  m_slider->setValue(scrubsByTime()
                         ? static_cast<int>(std::lround(m_times->atS[point] * kStepsPerS))
                         : static_cast<int>(point));
}

void PathView::scrub() {
  if (pointCount() == 0) {
    return;
  }
  auto point = static_cast<std::size_t>(m_slider->value());
  if (scrubsByTime()) {
    // The point that the tool is moving to.
    const std::vector<float>& atS = m_times->atS;
    const auto at = static_cast<float>(m_slider->value() / kStepsPerS);
    point = static_cast<std::size_t>(std::lower_bound(atS.begin(), atS.end(), at) - atS.begin());
  }
  m_marked = std::min(point, pointCount() - 1);
  m_canvas->setSelected({static_cast<std::uint32_t>(*m_marked)});
  m_canvas->setMarked(m_marked);
  m_canvas->reveal(*m_marked);
  showPlace();
  Q_EMIT pointChosen(*m_marked);
}

void PathView::showPlace() {
  if (!m_marked || *m_marked >= pointCount()) {
    m_place->setText(m_program ? tr("Click on the path or move the slider.") : QString());
    return;
  }
  const gcode::StreamPoint& point = m_program->points.points[*m_marked];
  QString text =
      tr("Point %1 of %2, line %3")
          .arg(countText(*m_marked + 1), countText(pointCount()), countText(point.line.value));
  if (m_times) {
    text += QStringLiteral(", ") + durationText(m_times->atS[*m_marked]);
  }
  if (m_pauses) {
    const auto isIn = [this](const std::vector<std::uint32_t>& list) {
      return std::binary_search(list.begin(), list.end(), static_cast<std::uint32_t>(*m_marked));
    };
    if (isIn(m_pauses->inCut)) {
      text += QStringLiteral(", ") + tr("then a pause in the cut");
    } else if (isIn(m_pauses->offCut)) {
      text += QStringLiteral(", ") + tr("then a pause off the cut");
    }
  }
  m_place->setText(text + QStringLiteral("\nX %1 Y %2 Z %3")
                              .arg(numberText(point.positionMm.x, 3),
                                   numberText(point.positionMm.y, 3),
                                   lengthText(point.positionMm.z, 3)));
}

void PathView::resizeEvent(QResizeEvent* event) {
  constexpr int kOneRowPx = 620;
  Page::resizeEvent(event);
  m_tools->setDirection(width() < kOneRowPx ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}  // namespace rivulet::widgets
