// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/setup/profile_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "base/units.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

using streaming::AxisProfile;
using streaming::MachineProfile;

namespace {

constexpr double kMost = 1e9;
constexpr int kToolNumberMax = 32'000;
constexpr int kFieldPx = 110;
/// Degrees per second of one revolution per minute.
constexpr double kDegPerSPerRpm = 6.0;

bool isRotary(std::size_t axis) {
  return axis >= base::kAxisCount;
}

QString axisName(std::size_t axis) {
  return QString(QLatin1Char(isRotary(axis) ? base::kRotaryAxisNames[axis - base::kAxisCount]
                                            : base::kAxisNames[axis]));
}

NumberField* makeField(QWidget* parent, double min) {
  auto* field = new NumberField(parent);
  field->setDecimals(3);
  field->setRange(min, kMost);
  field->setMinimumSize(kFieldPx, kTouchHeightPx);
  return field;
}

struct ProfileTexts {
  Q_DECLARE_TR_FUNCTIONS(ProfileTexts)

 public:
  static QString problem(const streaming::ProfileProblem& problem) {
    using What = streaming::ProfileProblem::What;
    const QString axis = axisName(problem.axis);
    switch (problem.what) {
      case What::Travel:
        return tr("Axis %1: the travel must end above its beginning.").arg(axis);
      case What::Speed:
        return tr("Axis %1: the speed must be above zero.").arg(axis);
      case What::Acceleration:
        return tr("Axis %1: the acceleration must be above zero.").arg(axis);
      case What::Jerk:
        return tr("Axis %1: the jerk must be above zero.").arg(axis);
      case What::Rapid:
        return tr("The rapid must be above zero.");
      case What::Silence:
        return tr("Without this computer the axes stand after 0.2 to 60 s; 0: not at all.");
      case What::Stop:
        return tr("Without a passed stop test a window takes at most 0.5 to 600 s.");
      case What::ToolNumber:
        return tr("Tool %1: every tool needs its own number above zero.").arg(problem.tool);
    }
    return {};
  }
};

}  // namespace

QString profileProblemText(const streaming::ProfileProblem& problem) {
  return ProfileTexts::problem(problem);
}

ProfilePage::ProfilePage(QWidget* parent)
    : Page(parent),
      m_rapid(say(makeField(this, 0.0), {.name = QT_TR_NOOP("Rapid, mm/min")})),
      m_spindle(say(makeField(this, 0.0), {.tip = QT_TR_NOOP("0: no spindle"),
                                           .name = QT_TR_NOOP("Spindle up to, 1/min")})),
      m_silence(say(
          makeField(this, 0.0),
          {.tip = QT_TR_NOOP("When nothing has come from this computer for so long, the axes stand "
                             "on the path until it gives a sign again. 0: not at all."),
           .name = QT_TR_NOOP("Without this computer the axes stand after, s")})),
      m_stop(say(makeField(this, 0.0),
                 {.tip = QT_TR_NOOP("Where a stop is sure to act only before the next window, "
                                    "because this control has not passed the stop test, no "
                                    "window of several moves takes longer."),
                  .name = QT_TR_NOOP("Without a passed stop test a window takes at most, s")})),
      m_toolGrid(new QGridLayout) {
  m_rapid->setDecimals(1);
  m_spindle->setDecimals(0);
  m_silence->setDecimals(1);
  m_stop->setDecimals(1);
  auto* head = new QGridLayout;
  head->addWidget(label({.text = QT_TR_NOOP("Name of the machine")}), 0, 0);
  head->addWidget(m_name, 0, 1, 1, 2);
  head->addWidget(label({.text = QT_TR_NOOP("Simulated as")}), 1, 0);
  head->addWidget(m_preset, 1, 1);
  head->addWidget(m_takeOver, 1, 2);
  head->setColumnStretch(1, 1);
  auto* axes = new QGridLayout;
  buildAxes(axes);
  int column = 0;
  for (const char* name : {QT_TR_NOOP("Number"), QT_TR_NOOP("Name"), QT_TR_NOOP("Length, mm"),
                           QT_TR_NOOP("Radius, mm")}) {
    m_toolHeads.push_back(label({.text = name}));
    m_toolGrid->addWidget(m_toolHeads.back(), 0, column++);
  }
  m_toolGrid->setColumnStretch(1, 1);
  inColumn(
      {m_state, inRow({m_save, m_discard, {m_problem, 1}}), head,
       heading({.text = QT_TR_NOOP("Axes")}), axes,
       inRow({label({.text = QT_TR_NOOP("Rapid, mm/min")}), m_rapid, gap(16),
              label({.text = QT_TR_NOOP("Spindle up to, 1/min")}), m_spindle, spring()}),
       inRow({label({.text = QT_TR_NOOP("Without this computer the axes stand after, s")}),
              m_silence, spring()}),
       inRow({label({.text = QT_TR_NOOP("Without a passed stop test a window takes at most, s")}),
              m_stop, spring()}),
       inRow({label({.text = QT_TR_NOOP("M functions of other machines")}), {m_functions, 1}}),
       heading({.text = QT_TR_NOOP("Tools")}), m_toolGrid, inRow({m_addTool, spring()}), spring()},
      this);
  onEdit({m_name, m_functions, m_rapid, m_spindle, m_silence, m_stop}, &ProfilePage::edited);
  connect(m_takeOver, &QPushButton::clicked, this,
          [this] { Q_EMIT presetRequested(m_preset->currentText()); });
  connect(m_addTool, &QPushButton::clicked, this, [this] {
    int number = 0;
    for (const ToolRow& tool : m_tools) {
      number = std::max(number, tool.number->value());
    }
    addTool({number + 1, {}, 0.0, 0.0});
    edited();
  });
  connect(m_save, &QPushButton::clicked, this, [this] {
    const MachineProfile profile = typed();
    const auto functions = typedFunctions();
    if (!(profile == m_asSaved) || !m_isEntered) {
      Q_EMIT saveRequested(profile);
    }
    if (functions && *functions != m_savedFunctions) {
      Q_EMIT functionsSaveRequested(*functions);
    }
  });
  connect(m_discard, &QPushButton::clicked, this, [this] {
    setFunctions(m_savedFunctions);
    takeOver(m_profile);
  });
  orderFocus();
  retranslate();
  restyle();
}

void ProfilePage::buildAxes(QGridLayout* grid) {
  for (std::size_t limit = 0; limit < LimitCount; ++limit) {
    m_heads[limit] = new QLabel(this);
    grid->addWidget(m_heads[limit], 0, static_cast<int>(limit) + 1);
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const int row = static_cast<int>(axis) + 1;
    if (isRotary(axis)) {
      auto* box = new QCheckBox(axisName(axis), this);
      box->setMinimumHeight(kTouchHeightPx);
      m_rotary[axis - base::kAxisCount] = box;
      grid->addWidget(box, row, 0);
      connect(box, &QCheckBox::toggled, this, &ProfilePage::edited);
    } else {
      m_linear[axis] = new QLabel(axisName(axis), this);
      grid->addWidget(m_linear[axis], row, 0);
    }
    for (std::size_t limit = 0; limit < LimitCount; ++limit) {
      NumberField* field = makeField(this, limit <= To ? -kMost : 0.0);
      field->setDecimals(limit <= To ? 3 : 1);
      m_limits[axis][limit] = field;
      grid->addWidget(field, row, static_cast<int>(limit) + 1);
      connect(field, &NumberField::valueChanged, this, &ProfilePage::edited);
    }
  }
}

void ProfilePage::setPresets(const QStringList& names) {
  m_preset->clear();
  m_preset->addItems(names);
}

void ProfilePage::setProfile(const MachineProfile& profile, bool isEntered) {
  m_profile = profile;
  m_isEntered = isEntered;
  takeOver(profile);
  m_asSaved = typed();
  showState();
}

void ProfilePage::setFunctions(const job::Functions& functions) {
  m_savedFunctions = functions;
  m_functions->setText(QString::fromStdString(job::textOf(functions)));
  showState();
}

base::Result<job::Functions> ProfilePage::typedFunctions() const {
  return job::functionsOfText(m_functions->text().toStdString());
}

void ProfilePage::takeOver(const MachineProfile& profile) {
  m_isFilling = true;
  if (!profile.name.empty() || profile.endpoint == m_profile.endpoint) {
    m_name->setText(QString::fromStdString(profile.name));
  }
  m_preset->setCurrentText(QString::fromStdString(profile.preset));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!isRotary(axis)) {
      showAxis(axis, profile.axes[axis]);
      continue;
    }
    const auto& rotary = profile.rotaryAxes[axis - base::kAxisCount];
    m_rotary[axis - base::kAxisCount]->setChecked(rotary.has_value());
    showAxis(axis, rotary.value_or(AxisProfile{}));
  }
  m_rapid->setValue(base::mmPerMinFromMmPerS(profile.rapidMmPerS));
  m_spindle->setValue(profile.spindlePerMinMax);
  m_silence->setValue(profile.silenceLimitS);
  m_stop->setValue(profile.stopLimitS);
  while (!m_tools.empty()) {
    removeTool(m_tools.back().remove);
  }
  for (const streaming::ToolProfile& tool : profile.tools) {
    addTool(tool);
  }
  m_isFilling = false;
  edited();
}

void ProfilePage::showAxis(std::size_t index, const AxisProfile& axis) {
  const auto& fields = m_limits[index];
  fields[From]->setValue(axis.positionMin);
  fields[To]->setValue(axis.positionMax);
  fields[Speed]->setValue(isRotary(index) ? axis.speedPerSMax / kDegPerSPerRpm
                                          : base::mmPerMinFromMmPerS(axis.speedPerSMax));
  fields[Acceleration]->setValue(axis.accelerationPerS2Max);
  fields[Jerk]->setValue(axis.jerkPerS3Max);
}

AxisProfile ProfilePage::axis(std::size_t index) const {
  const auto& fields = m_limits[index];
  return {fields[From]->value(), fields[To]->value(),
          isRotary(index) ? fields[Speed]->value() * kDegPerSPerRpm
                          : base::mmPerSFromMmPerMin(fields[Speed]->value()),
          fields[Acceleration]->value(), fields[Jerk]->value()};
}

MachineProfile ProfilePage::typed() const {
  MachineProfile profile = m_profile;
  profile.name = m_name->text().trimmed().toStdString();
  profile.preset = m_preset->currentText().toStdString();
  for (std::size_t index = 0; index < kAxes; ++index) {
    if (!isRotary(index)) {
      profile.axes[index] = axis(index);
      continue;
    }
    const std::size_t rotary = index - base::kAxisCount;
    profile.rotaryAxes[rotary] =
        m_rotary[rotary]->isChecked() ? std::optional(axis(index)) : std::nullopt;
  }
  profile.rapidMmPerS = base::mmPerSFromMmPerMin(m_rapid->value());
  profile.spindlePerMinMax = m_spindle->value();
  profile.silenceLimitS = m_silence->value();
  profile.stopLimitS = m_stop->value();
  profile.tools.clear();
  for (const ToolRow& tool : m_tools) {
    profile.tools.push_back({tool.number->value(), tool.name->text().trimmed().toStdString(),
                             tool.length->value(), tool.radius->value()});
  }
  return profile;
}

void ProfilePage::addTool(const streaming::ToolProfile& tool) {
  ToolRow row;
  row.number = new WholeNumberField(this);
  row.number->setRange(0, kToolNumberMax);
  row.number->setMinimumSize(kFieldPx, kTouchHeightPx);
  row.number->setValue(tool.number);
  row.name = new QLineEdit(QString::fromStdString(tool.name), this);
  row.name->setMinimumHeight(kTouchHeightPx);
  row.length = makeField(this, -kMost);
  row.length->setValue(tool.lengthMm);
  row.radius = makeField(this, -kMost);
  row.radius->setValue(tool.radiusMm);
  row.remove = makeTouchButton(this);
  const int at = m_toolGrid->rowCount();
  m_toolGrid->addWidget(row.number, at, 0);
  m_toolGrid->addWidget(row.name, at, 1);
  m_toolGrid->addWidget(row.length, at, 2);
  m_toolGrid->addWidget(row.radius, at, 3);
  m_toolGrid->addWidget(row.remove, at, 4);
  connect(row.number, &WholeNumberField::valueChanged, this, &ProfilePage::edited);
  connect(row.name, &QLineEdit::textEdited, this, &ProfilePage::edited);
  connect(row.length, &NumberField::valueChanged, this, &ProfilePage::edited);
  connect(row.radius, &NumberField::valueChanged, this, &ProfilePage::edited);
  connect(row.remove, &QPushButton::clicked, this, [this, button = row.remove] {
    removeTool(button);
    edited();
  });
  m_tools.push_back(row);
  nameTools();
  orderFocus();
}

void ProfilePage::orderFocus() {
  std::vector<QWidget*> order{m_save, m_discard, m_name, m_preset, m_takeOver};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (isRotary(axis)) {
      order.push_back(m_rotary[axis - base::kAxisCount]);
    }
    order.insert(order.end(), m_limits[axis].begin(), m_limits[axis].end());
  }
  order.insert(order.end(), {m_rapid, m_spindle, m_silence, m_stop, m_functions});
  for (const ToolRow& tool : m_tools) {
    order.insert(order.end(), {tool.number, tool.name, tool.length, tool.radius, tool.remove});
  }
  order.push_back(m_addTool);
  for (std::size_t i = 1; i < order.size(); ++i) {
    setTabOrder(order[i - 1], order[i]);
  }
}

void ProfilePage::removeTool(const QPushButton* button) {
  const auto found = std::find_if(m_tools.begin(), m_tools.end(),
                                  [&](const ToolRow& row) { return row.remove == button; });
  for (QWidget* part : std::initializer_list<QWidget*>{found->number, found->name, found->length,
                                                       found->radius, found->remove}) {
    m_toolGrid->removeWidget(part);
    part->hide();
    part->deleteLater();
  }
  m_tools.erase(found);
  nameTools();
}

void ProfilePage::nameTools() {
  for (QLabel* head : m_toolHeads) {
    head->setVisible(!m_tools.empty());
  }
  for (const ToolRow& row : m_tools) {
    row.remove->setText(tr("Remove"));
    const QString tool = tr("Tool %1").arg(row.number->value());
    row.number->setAccessibleName(tr("Number of the tool"));
    row.name->setAccessibleName(tool + QLatin1Char(' ') + m_toolHeads[1]->text());
    row.length->setAccessibleName(tool + QLatin1Char(' ') + m_toolHeads[2]->text());
    row.radius->setAccessibleName(tool + QLatin1Char(' ') + m_toolHeads[3]->text());
    row.remove->setAccessibleName(tool + QLatin1Char(' ') + row.remove->text());
  }
}

void ProfilePage::setBlocked(const QString& why) {
  m_blocked = why;
  edited();
}

void ProfilePage::edited() {
  if (m_isFilling) {
    return;
  }
  for (std::size_t axis = base::kAxisCount; axis < kAxes; ++axis) {
    for (NumberField* field : m_limits[axis]) {
      field->setEnabled(m_rotary[axis - base::kAxisCount]->isChecked());
    }
  }
  nameTools();
  showState();
}

void ProfilePage::showState() {
  if (m_isEntered) {
    m_state->setStatus(Status::Good,
                       tr("Entered by %1 on %2.")
                           .arg(QString::fromStdString(m_profile.enteredBy),
                                QString::fromStdString(m_profile.enteredAtUtc).left(10)));
  } else {
    m_state->setStatus(
        Status::Attention,
        tr("Nobody has entered the limits of this machine. Feeds and simulations take those of "
           "the machine in the paper: %1.")
            .arg(QString::fromStdString(m_profile.preset)));
  }
  const MachineProfile now = typed();
  const auto problem = streaming::problemOf(now);
  const auto functions = typedFunctions();
  const bool isChanged = !(now == m_asSaved) || !functions || *functions != m_savedFunctions;
  m_discard->setEnabled(isChanged);
  m_save->setEnabled(m_blocked.isEmpty() && !problem && functions && (isChanged || !m_isEntered));
  if (!m_blocked.isEmpty()) {
    m_problem->setStatus(Status::Unknown, m_blocked);
  } else if (problem) {
    m_problem->setStatus(Status::Fault, profileProblemText(*problem));
  } else if (!functions) {
    m_problem->setStatus(Status::Fault,
                         tr("M functions: write the number, an equals sign, and ignore, pass or a "
                            "line for the control. Separate entries with semicolons."));
  } else if (isChanged) {
    m_problem->setStatus(Status::Attention, tr("Not saved yet."));
  } else {
    m_problem->setStatus(Status::Plain, {});
  }
}

void ProfilePage::retranslate() {
  m_heads[From]->setText(tr("Travel from") + QStringLiteral("\nmm, °"));
  m_heads[To]->setText(tr("Travel to") + QStringLiteral("\nmm, °"));
  m_heads[Speed]->setText(tr("Speed") + QStringLiteral("\nmm/min, 1/min"));
  m_heads[Acceleration]->setText(tr("Acceleration") + QStringLiteral("\nmm/s², °/s²"));
  m_heads[Jerk]->setText(tr("Jerk") + QStringLiteral("\nmm/s³, °/s³"));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::size_t limit = 0; limit < LimitCount; ++limit) {
      m_limits[axis][limit]->setAccessibleName(
          axisName(axis) + QLatin1Char(' ') +
          m_heads[limit]->text().section(QLatin1Char('\n'), 0, 0));
    }
  }
  m_functions->setPlaceholderText(QStringLiteral("163=ignore; 11=pass; 51=M8"));
  nameTools();
  showState();
}

}  // namespace rivulet::widgets
