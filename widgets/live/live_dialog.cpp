// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/live/live_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "base/units.h"
#include "widgets/common/error_text.h"
#include "widgets/common/number_field.h"
#include "widgets/common/number_format.h"
#include "widgets/common/page.h"
#include "widgets/common/sheet_area.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

constexpr double kPlaceMmMax = 100'000.0;
constexpr double kValueMax = 1e6;
constexpr int kPortMax = 65'535;
constexpr int kPortDefault = 4001;
constexpr int kDialogWidthMinPx = 700;
constexpr double kMsOfSecond = 1000.0;
const QString kServer = QStringLiteral("opcua:");

}  // namespace

LiveDialog::LiveDialog(const live::Setup& setup, bool offersInput,
                       const std::optional<base::Vec3>& toolMm, QWidget* parent)
    : QDialog(parent),
      m_kind(new QComboBox(this)),
      m_port(new WholeNumberField(this)),
      m_path(new QLineEdit(this)),
      m_fileRow(new QWidget(this)),
      m_file(new QLineEdit(m_fileRow)),
      m_answer(new StatusLabel(this)),
      m_toolMm(toolMm),
      m_tool(new StatusLabel(this)) {
  setWindowTitle(tr("Live points"));
  setMinimumWidth(kDialogWidthMinPx);
  auto* what = new QLabel(tr("A program or script computes the path while the machine moves and "
                             "sends its points as lines, such as X1.5 Y2 F500. Nothing moves that "
                             "is outside what is agreed here."),
                          this);
  what->setWordWrap(true);
  m_answer->setWordWrap(true);
  auto* grid = new QGridLayout;
  grid->addWidget(makeSource(offersInput), 0, 0);
  grid->addWidget(makeBox(), 1, 0);
  grid->addWidget(makeAgreed(), 0, 1, 2, 1);
  grid->addWidget(makeSilence(), 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  // Made last: the keyboard comes to them last.
  auto* open = makeTouchButton(this);
  open->setObjectName(QStringLiteral("live-open"));
  open->setText(tr("Open"));
  open->setToolTip(tr("Listens from now on. Nothing moves before the start."));
  open->setDefault(true);
  auto* cancel = makeTouchButton(this);
  cancel->setObjectName(QStringLiteral("live-cancel"));
  cancel->setText(tr("Cancel"));
  cancel->setAutoDefault(false);
  inColumn({what, {grid, 1}, inRow({{m_answer, 1}, cancel, open})}, this);
  m_answer->setVisible(false);

  for (auto* label : findChildren<QLabel*>()) {
    if (label->buddy() != nullptr) {
      label->setMinimumHeight(kTouchHeightPx);  // at the height of its field
    }
  }
  for (auto* field : findChildren<NumberField*>()) {
    field->setMinimumHeight(kTouchHeightPx);
    connect(field, &NumberField::refused, this, [this](const QString& reason) {
      m_answer->setStatus(Status::Attention, reason);
      m_answer->setVisible(true);
    });
  }
  connect(m_kind, &QComboBox::currentIndexChanged, this, &LiveDialog::showKind);
  connect(open, &QPushButton::clicked, this, &LiveDialog::tryOpen);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  showSetup(setup);
  showKind();
  showTool();
  for (NumberField* field : {m_lowest[0], m_lowest[1], m_lowest[2], m_highest[0], m_highest[1],
                             m_highest[2], m_values[First]}) {
    connect(field, &NumberField::valueChanged, this, &LiveDialog::showTool);
  }
}

QGroupBox* LiveDialog::makeSource(bool offersInput) {
  auto* group = new QGroupBox(tr("Source"), this);
  m_sourceForm = new QFormLayout(group);
  m_sourceForm->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_kind->setObjectName(QStringLiteral("live-kind"));
  m_kind->setMinimumHeight(kTouchHeightPx);
  m_kind->addItem(tr("TCP port of this computer"), Tcp);
  m_kind->addItem(tr("UDP port of this computer"), Udp);
  m_kind->addItem(tr("UNIX socket"), Unix);
  m_kind->addItem(tr("Variables of an OPC UA server"), Server);
  if (offersInput) {
    m_kind->addItem(tr("Standard input of this window"), Input);
  }
  m_kind->setToolTip(tr("To ports and sockets, only programs on this computer can send."));
  m_kind->setAccessibleName(tr("Source"));
  m_port->setObjectName(QStringLiteral("live-port"));
  m_port->setRange(0, kPortMax);
  m_port->setMinimumHeight(kTouchHeightPx);
  m_port->setToolTip(tr("0: any that is free"));
  m_port->setAccessibleName(tr("Port"));
  m_path->setObjectName(QStringLiteral("live-path"));
  m_path->setMinimumHeight(kTouchHeightPx);
  m_path->setToolTip(tr("File name of the socket, which only this user can write to"));
  m_path->setAccessibleName(tr("Path"));
  m_file->setObjectName(QStringLiteral("live-file"));
  m_file->setMinimumHeight(kTouchHeightPx);
  m_file->setToolTip(tr("This file names the server and its variables (TOML)."));
  m_file->setAccessibleName(tr("File of the source"));
  auto* choose = makeTouchButton(m_fileRow);
  choose->setObjectName(QStringLiteral("live-choose-file"));
  choose->setText(tr("Choose …"));
  choose->setToolTip(tr("Choose the file of the source"));
  choose->setAutoDefault(false);
  connect(choose, &QPushButton::clicked, this, &LiveDialog::chooseFile);
  inRow({{m_file, 1}, choose}, m_fileRow, QMargins({}));
  m_sourceForm->addRow(m_kind);
  m_sourceForm->addRow(tr("Port"), m_port);
  m_sourceForm->addRow(tr("Path"), m_path);
  m_sourceForm->addRow(tr("File"), m_fileRow);
  return group;
}

QGroupBox* LiveDialog::makeBox() {
  auto* group = new QGroupBox(tr("Box of all points"), this);
  auto* grid = new QGridLayout(group);
  grid->addWidget(new QLabel(tr("from"), group), 0, 1);
  grid->addWidget(new QLabel(tr("to"), group), 0, 2);
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    const QString name{QLatin1Char(base::kAxisNames[axis])};
    const int row = static_cast<int>(axis) + 1;
    grid->addWidget(new QLabel(name, group), row, 0);
    for (const bool isLowest : {true, false}) {
      auto* field = new NumberField(group);
      field->setObjectName(
          QStringLiteral("live-%1-%2")
              .arg(name.toLower(), isLowest ? QStringLiteral("from") : QStringLiteral("to")));
      field->setRange(-kPlaceMmMax, kPlaceMmMax);
      field->setDecimals(3);
      field->setSuffix(QStringLiteral("\u00A0mm"));
      field->setToolTip(isLowest ? tr("Least coordinate, workpiece frame")
                                 : tr("Largest coordinate, workpiece frame"));
      field->setAccessibleName(isLowest ? tr("%1 from").arg(name) : tr("%1 to").arg(name));
      grid->addWidget(field, row, isLowest ? 1 : 2);
      (isLowest ? m_lowest : m_highest)[axis] = field;
    }
  }
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  m_tool->setObjectName(QStringLiteral("live-tool"));
  m_tool->setWordWrap(true);
  auto* around = makeTouchButton(group);
  around->setObjectName(QStringLiteral("live-around"));
  around->setText(tr("Around the tool"));
  around->setToolTip(tr("Puts a box of this size around the place where the tool stands."));
  around->setAutoDefault(false);
  around->setVisible(m_toolMm.has_value());
  connect(around, &QPushButton::clicked, this,
          [this] { showBox(live::around(setup().agreement, *m_toolMm)); });
  constexpr int kBelow = static_cast<int>(base::kAxisCount) + 1;
  grid->addWidget(m_tool, kBelow, 0, 1, 3);
  grid->addWidget(around, kBelow + 1, 1, 1, 2);
  return group;
}

NumberField* LiveDialog::addField(QFormLayout* form, Value value, const char* name,
                                  const QString& label, const QString& unit, const QString& hint) {
  auto* field = new NumberField(this);
  field->setObjectName(QStringLiteral("live-") + QLatin1String(name));
  field->setRange(0.0, kValueMax);
  field->setDecimals(value == Feed || value == Full            ? 0
                     : value == HoldAfter || value == EndAfter ? 1
                                                               : 3);
  field->setSuffix(QStringLiteral("\u00A0") + unit);
  field->setToolTip(hint);
  field->setAccessibleName(label);
  form->addRow(label, field);
  m_values[value] = field;
  return field;
}

QGroupBox* LiveDialog::makeAgreed() {
  auto* group = new QGroupBox(tr("Agreed with the source"), this);
  auto* form = new QFormLayout(group);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  const QString mm = QStringLiteral("mm");
  addField(form, First, "first", tr("First point within"), mm,
           tr("Largest distance of the first point from the tool"));
  addField(form, Step, "step", tr("Largest step"), mm, tr("Largest distance of two points"));
  addField(form, Feed, "feed", tr("Largest F"), QStringLiteral("mm/min"),
           tr("It is also the feed of points before the first F."));
  addField(form, Merge, "merge", tr("Merge below"), mm,
           tr("Points that are closer are merged with the one before."));
  addField(form, Turn, "turn", tr("Largest turn"), QStringLiteral("°"),
           tr("Largest turn of a rotary axis between two points"));
  auto* axes = new QHBoxLayout;
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    const QString name{QLatin1Char(base::kRotaryAxisNames[axis])};
    m_rotary[axis] = new QCheckBox(name, group);
    m_rotary[axis]->setObjectName(QStringLiteral("live-axis-") + name.toLower());
    m_rotary[axis]->setMinimumHeight(kTouchHeightPx);
    m_rotary[axis]->setToolTip(tr("Points may turn this axis (method window)."));
    m_rotary[axis]->setAccessibleName(tr("Rotary axis %1").arg(name));
    axes->addWidget(m_rotary[axis]);
  }
  form->addRow(tr("Rotary axes"), axes);
  form->labelForField(axes)->setMinimumHeight(kTouchHeightPx);
  return group;
}

QGroupBox* LiveDialog::makeSilence() {
  auto* group = new QGroupBox(tr("When no points come"), this);
  auto* row = new QHBoxLayout(group);
  const auto column = [&](Value value, const char* name, const QString& label, const QString& unit,
                          const QString& hint) {
    auto* form = new QFormLayout;
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    addField(form, value, name, label, unit, hint);
    row->addLayout(form, 1);
  };
  column(Full, "full", tr("Window within"), QStringLiteral("ms"),
         tr("A window that is not full is sent after this time."));
  column(HoldAfter, "hold", tr("Hold after"), QStringLiteral("s"),
         tr("After this much silence the run holds; it goes on with the next point."));
  column(EndAfter, "end", tr("End after"), QStringLiteral("s"),
         tr("After this much silence the run ends with an error."));
  return group;
}

void LiveDialog::showSetup(const live::Setup& setup) {
  const QString address = QString::fromStdString(setup.address);
  const QString rest = address.section(QLatin1Char(':'), 1);
  const Kind kind = address == QStringLiteral("-")                ? Input
                    : address.startsWith(QStringLiteral("unix:")) ? Unix
                    : address.startsWith(QStringLiteral("udp:"))  ? Udp
                    : address.startsWith(kServer)                 ? Server
                                                                  : Tcp;
  m_kind->setCurrentIndex(std::max(0, m_kind->findData(kind)));
  bool isPort = false;
  const int port = rest.toInt(&isPort);
  m_port->setValue(isPort ? port : kPortDefault);
  m_path->setText(kind == Unix ? rest : QDir::temp().filePath(QStringLiteral("rivulet.sock")));
  m_file->setText(kind == Server ? rest : QString());
  showBox(setup.agreement);
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    m_rotary[axis]->setChecked(setup.rotaryAxes[axis]);
  }
  m_values[Step]->setValue(setup.agreement.stepMmMax);
  m_values[Turn]->setValue(setup.agreement.turnDegMax);
  m_values[Feed]->setValue(setup.agreement.feedMmPerMinMax);
  m_values[First]->setValue(setup.agreement.startMmMax);
  m_values[Merge]->setValue(setup.agreement.distanceMmMin);
  m_values[Full]->setValue(base::toMilliseconds(setup.limits.fullWithin));
  m_values[HoldAfter]->setValue(base::toSeconds(setup.limits.holdAfter));
  m_values[EndAfter]->setValue(base::toSeconds(setup.limits.endAfter));
}

void LiveDialog::showBox(const live::Agreement& agreed) {
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    m_lowest[axis]->setValue(agreed.lowestMm[axis]);
    m_highest[axis]->setValue(agreed.highestMm[axis]);
  }
}

void LiveDialog::showTool() {
  if (!m_toolMm) {
    m_tool->setStatus(Status::Unknown, tr("Where the tool stands is not known."));
    return;
  }
  const QString place =
      QStringLiteral("X\u00A0%1 Y\u00A0%2 Z\u00A0%3")
          .arg(numberText(m_toolMm->x, 3), numberText(m_toolMm->y, 3), numberText(m_toolMm->z, 3));
  if (live::reaches(setup().agreement, *m_toolMm)) {
    m_tool->setStatus(Status::Plain, tr("The tool stands at %1.").arg(place));
  } else {
    m_tool->setStatus(Status::Attention,
                      tr("The tool stands at %1, so far outside that no first point can be in "
                         "the box.")
                          .arg(place));
  }
}

void LiveDialog::showKind() {
  const int kind = m_kind->currentData().toInt();
  m_sourceForm->setRowVisible(m_port, kind == Tcp || kind == Udp);
  m_sourceForm->setRowVisible(m_path, kind == Unix);
  m_sourceForm->setRowVisible(m_fileRow, kind == Server);
}

void LiveDialog::chooseFile() {
  askForFile(this,
             {tr("File of the source"), m_file->text(), tr("Sources (*.toml);;All files (*)")},
             [this](const QString& file) { m_file->setText(file); });
}

live::Setup LiveDialog::setup() const {
  live::Setup setup;
  switch (m_kind->currentData().toInt()) {
    case Udp:
      setup.address = "udp:" + std::to_string(m_port->value());
      break;
    case Unix:
      setup.address = "unix:" + m_path->text().trimmed().toStdString();
      break;
    case Server:
      setup.address = (kServer + m_file->text().trimmed()).toStdString();
      break;
    case Input:
      setup.address = "-";
      break;
    default:
      setup.address = "tcp:" + std::to_string(m_port->value());
  }
  for (std::size_t axis = 0; axis < base::kAxisCount; ++axis) {
    setup.agreement.lowestMm.set(axis, m_lowest[axis]->value());
    setup.agreement.highestMm.set(axis, m_highest[axis]->value());
  }
  for (std::size_t axis = 0; axis < base::kRotaryAxisCount; ++axis) {
    setup.rotaryAxes[axis] = m_rotary[axis]->isChecked();
  }
  setup.agreement.stepMmMax = m_values[Step]->value();
  setup.agreement.turnDegMax = m_values[Turn]->value();
  setup.agreement.feedMmPerMinMax = m_values[Feed]->value();
  setup.agreement.startMmMax = m_values[First]->value();
  setup.agreement.distanceMmMin = m_values[Merge]->value();
  setup.limits.fullWithin = base::fromSeconds(m_values[Full]->value() / kMsOfSecond);
  setup.limits.holdAfter = base::fromSeconds(m_values[HoldAfter]->value());
  setup.limits.endAfter = base::fromSeconds(m_values[EndAfter]->value());
  return setup;
}

void LiveDialog::tryOpen() {
  if (m_kind->currentData().toInt() == Server && m_file->text().trimmed().isEmpty()) {
    m_answer->setStatus(Status::Attention, tr("Choose the file of the source"));
    m_answer->setVisible(true);
    return;
  }
  const live::Setup wanted = setup();
  if (const base::Result<void> sound = live::requireSound(wanted); !sound) {
    m_answer->setStatus(Status::Fault, errorText(sound.error()));
    m_answer->setVisible(true);
    return;
  }
  Q_EMIT openRequested(wanted);
  accept();
}

}  // namespace rivulet::widgets
