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
#include <QVBoxLayout>
#include <algorithm>

#include "base/units.h"
#include "widgets/common/icons.h"
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
      m_state(new StatusLabel(this)),
      m_nameLabel(new QLabel(this)),
      m_name(new QLineEdit(this)),
      m_presetLabel(new QLabel(this)),
      m_preset(new QComboBox(this)),
      m_takeOver(makeTouchButton(this)),
      m_axesTitle(makeHeading(this)),
      m_rapidLabel(new QLabel(this)),
      m_rapid(makeField(this, 0.0)),
      m_spindleLabel(new QLabel(this)),
      m_spindle(makeField(this, 0.0)),
      m_functionsLabel(new QLabel(this)),
      m_functions(new QLineEdit(this)),
      m_toolsTitle(makeHeading(this)),
      m_toolGrid(new QGridLayout),
      m_addTool(makeTouchButton(this)),
      m_save(makeTouchButton(this)),
      m_discard(makeTouchButton(this)),
      m_problem(new StatusLabel(this)) {
  m_state->setWordWrap(true);
  m_problem->setWordWrap(true);
  m_rapid->setDecimals(1);
  m_spindle->setDecimals(0);
  m_name->setMinimumHeight(kTouchHeightPx);
  m_preset->setMinimumHeight(kTouchHeightPx);
  auto* head = new QGridLayout;
  head->addWidget(m_nameLabel, 0, 0);
  head->addWidget(m_name, 0, 1, 1, 2);
  head->addWidget(m_presetLabel, 1, 0);
  head->addWidget(m_preset, 1, 1);
  head->addWidget(m_takeOver, 1, 2);
  head->setColumnStretch(1, 1);
  auto* axes = new QGridLayout;
  buildAxes(axes);
  auto* others = new QHBoxLayout;
  others->addWidget(m_rapidLabel);
  others->addWidget(m_rapid);
  others->addSpacing(16);
  others->addWidget(m_spindleLabel);
  others->addWidget(m_spindle);
  others->addStretch();
  for (std::size_t column = 0; column < m_toolHeads.size(); ++column) {
    m_toolHeads[column] = new QLabel(this);
    m_toolGrid->addWidget(m_toolHeads[column], 0, static_cast<int>(column));
  }
  m_toolGrid->setColumnStretch(1, 1);
  auto* addRow = new QHBoxLayout;
  addRow->addWidget(m_addTool);
  addRow->addStretch();
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_save);
  buttons->addWidget(m_discard);
  buttons->addWidget(m_problem, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_state);
  layout->addLayout(buttons);
  layout->addLayout(head);
  layout->addWidget(m_axesTitle);
  layout->addLayout(axes);
  layout->addLayout(others);
  m_functions->setMinimumHeight(kTouchHeightPx);
  auto* functionsRow = new QHBoxLayout;
  functionsRow->addWidget(m_functionsLabel);
  functionsRow->addWidget(m_functions, 1);
  layout->addLayout(functionsRow);
  layout->addWidget(m_toolsTitle);
  layout->addLayout(m_toolGrid);
  layout->addLayout(addRow);
  layout->addStretch();
  connect(m_name, &QLineEdit::textEdited, this, &ProfilePage::edited);
  connect(m_functions, &QLineEdit::textEdited, this, &ProfilePage::edited);
  connect(m_rapid, &NumberField::valueChanged, this, &ProfilePage::edited);
  connect(m_spindle, &NumberField::valueChanged, this, &ProfilePage::edited);
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
  order.insert(order.end(), {m_rapid, m_spindle, m_functions});
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
  m_nameLabel->setText(tr("Name of the machine"));
  m_name->setAccessibleName(m_nameLabel->text());
  m_presetLabel->setText(tr("Simulated as"));
  m_preset->setAccessibleName(m_presetLabel->text());
  m_takeOver->setText(tr("Take over its limits"));
  m_axesTitle->setText(tr("Axes"));
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
  m_rapidLabel->setText(tr("Rapid, mm/min"));
  m_rapid->setAccessibleName(m_rapidLabel->text());
  m_spindleLabel->setText(tr("Spindle up to, 1/min"));
  m_spindle->setAccessibleName(m_spindleLabel->text());
  m_spindle->setToolTip(tr("0: no spindle"));
  m_functionsLabel->setText(tr("M functions of other machines"));
  m_functions->setAccessibleName(m_functionsLabel->text());
  m_functions->setPlaceholderText(QStringLiteral("163=ignore; 11=pass; 51=M8"));
  m_functions->setToolTip(
      tr("What this machine does for the M functions of programs made for another: ignore leaves "
         "the function out, pass gives it to the control, anything else is a line for it."));
  m_toolsTitle->setText(tr("Tools"));
  m_toolHeads[0]->setText(tr("Number"));
  m_toolHeads[1]->setText(tr("Name"));
  m_toolHeads[2]->setText(tr("Length, mm"));
  m_toolHeads[3]->setText(tr("Radius, mm"));
  m_addTool->setText(tr("Add a tool"));
  m_save->setText(tr("Save the limits"));
  m_discard->setText(tr("Discard changes"));
  nameTools();
  showState();
}

}  // namespace rivulet::widgets
