// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/described_machine_box.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>
#include <string>

#include "opcua/machinery.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

namespace {

/// What there is of two texts.
QString joined(const QString& first, const QString& second) {
  return first.isEmpty() || second.isEmpty() ? first + second
                                             : QStringLiteral("%1, %2").arg(first, second);
}

}  // namespace

DescribedMachineBox::DescribedMachineBox(QWidget* parent)
    : Page(parent), m_group(new QGroupBox(this)), m_form(new QFormLayout(m_group)) {
  setObjectName(QStringLiteral("describedMachine"));
  m_form->setLabelAlignment(Qt::AlignLeft);
  m_form->setHorizontalSpacing(16);
  for (int row = 0; row < Rows; ++row) {
    const auto place = static_cast<std::size_t>(row);
    m_titles[place] = new QLabel(m_group);
    m_values[place] = new StatusLabel(m_group);
    m_values[place]->setWordWrap(true);
    m_form->addRow(m_titles[place], m_values[place]);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_group);
  retranslate();
  restyle();
}

void DescribedMachineBox::setMachineState(const MachineView& machine, bool isConnected) {
  m_machine = machine;
  m_isConnected = isConnected;
  showDescription();
}

void DescribedMachineBox::retranslate() {
  m_group->setTitle(tr("Described by the server"));
  m_group->setToolTip(
      tr("What the server says of its machine by OPC 40001-1 (Machinery) and OPC 40501-1 (Machine "
         "Tools). It is read every 10 s, and not while a run is in progress."));
  setAccessibleName(m_group->title());
  m_titles[Name]->setText(tr("Machine"));
  m_titles[Maker]->setText(tr("Manufacturer"));
  m_titles[Model]->setText(tr("Model"));
  m_titles[Serial]->setText(tr("Serial number"));
  m_titles[State]->setText(tr("State"));
  m_titles[Program]->setText(tr("Program"));
  m_titles[Job]->setText(tr("Job"));
  showDescription();
}

void DescribedMachineBox::restyle() {
  for (QLabel* title : m_titles) {
    setMuted(title, palette());
  }
}

void DescribedMachineBox::showRow(Row row, const QString& text, bool isLive) {
  m_values[row]->setStatus(Status::Plain, text);
  m_values[row]->setOutdated(
      isLive && !(m_machine.describedAgeS && *m_machine.describedAgeS <= kDescribedFreshS));
  m_form->setRowVisible(m_titles[row], !text.isEmpty());
}

void DescribedMachineBox::showDescription() {
  const bool isDescribed = m_isConnected && m_machine.described && !m_machine.described->empty();
  setVisible(isDescribed);
  if (!isDescribed) {
    return;
  }
  const opcua::DescribedMachine& machine = m_machine.described->front();
  const auto text = [](const std::string& of) { return QString::fromStdString(of); };
  const std::size_t count = m_machine.described->size();
  showRow(Name,
          count == 1 ? text(machine.name)
                     : tr("%1 (first of %2)").arg(text(machine.name), QString::number(count)),
          false);
  showRow(Maker, text(machine.manufacturer), false);
  showRow(Model, text(machine.model), false);
  showRow(Serial, text(machine.serialNumber), false);
  showRow(State, joined(text(machine.state), text(machine.operationMode)), true);
  showRow(Program, joined(text(machine.program), text(machine.programState)), true);
  QString progress;
  if (machine.runsCompleted && machine.runsPlanned) {
    progress = tr("%1 of %2 runs").arg(*machine.runsCompleted).arg(*machine.runsPlanned);
  } else if (machine.runsCompleted) {
    progress = tr("runs completed: %1").arg(*machine.runsCompleted);
  }
  showRow(Job, joined(joined(text(machine.job), text(machine.jobState)), progress), true);
}

}  // namespace rivulet::widgets
