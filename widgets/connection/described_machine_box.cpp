// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/described_machine_box.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QVBoxLayout>
#include <string>

#include "opcua/machinery.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

namespace {

/// What there is of two texts.
QString joined(const QString& first, const QString& second) {
  return first.isEmpty() || second.isEmpty() ? first + second
                                             : QStringLiteral("%1, %2").arg(first, second);
}

}  // namespace

DescribedMachineBox::DescribedMachineBox(QWidget* parent)
    : Page(parent), m_form(new QFormLayout(m_group)) {
  setObjectName(QStringLiteral("describedMachine"));
  m_form->setLabelAlignment(Qt::AlignLeft);
  m_form->setHorizontalSpacing(16);
  std::size_t row = 0;
  for (const char* title : {QT_TR_NOOP("Machine"), QT_TR_NOOP("Manufacturer"), QT_TR_NOOP("Model"),
                            QT_TR_NOOP("Serial number"), QT_TR_NOOP("State"), QT_TR_NOOP("Program"),
                            QT_TR_NOOP("Job")}) {
    m_values[row] = status({.wraps = true});
    m_form->addRow(label({.text = title, .isMuted = true}), m_values[row++]);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_group);
  retranslate();
}

void DescribedMachineBox::setMachineState(const MachineView& machine, bool isConnected) {
  m_machine = machine;
  m_isConnected = isConnected;
  showDescription();
}

void DescribedMachineBox::retranslate() {
  setAccessibleName(m_group->title());
  showDescription();
}

void DescribedMachineBox::showRow(Row row, const QString& text, bool isLive) {
  m_values[row]->setStatus(Status::Plain, text);
  m_values[row]->setOutdated(
      isLive && !(m_machine.describedAgeS && *m_machine.describedAgeS <= kDescribedFreshS));
  m_form->setRowVisible(m_values[row], !text.isEmpty());
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
