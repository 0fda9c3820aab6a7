// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/control_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/theme.h"

namespace rivulet::widgets {

ControlFields::ControlFields(QWidget* parent)
    : Page(parent),
      m_isMapped(new QCheckBox(this)),
      m_mapRow(new QWidget(this)),
      m_mapFile(new QLineEdit(m_mapRow)),
      m_choose(makeTouchButton(m_mapRow)),
      m_linkLabel(new QLabel(this)),
      m_link(new QComboBox(this)) {
  m_isMapped->setObjectName(QStringLiteral("mapped"));
  m_mapFile->setObjectName(QStringLiteral("map-file"));
  m_choose->setObjectName(QStringLiteral("map-choose"));
  m_link->setObjectName(QStringLiteral("link"));
  m_link->addItem(QStringLiteral("open62541"), static_cast<int>(opcua::LinkKind::Open62541));
  m_link->addItem(QStringLiteral("Qt OPC UA"), static_cast<int>(opcua::LinkKind::QtOpcUa));
  m_linkLabel->setBuddy(m_link);
  for (QWidget* field : std::initializer_list<QWidget*>{m_isMapped, m_mapFile, m_link}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  auto* row = new QHBoxLayout(m_mapRow);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_mapFile, 1);
  row->addWidget(m_choose);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_isMapped);
  layout->addWidget(m_mapRow);
  layout->addWidget(m_linkLabel);
  layout->addWidget(m_link);
  connect(m_isMapped, &QCheckBox::toggled, this, &ControlFields::showState);
  connect(m_mapFile, &QLineEdit::returnPressed, this, &ControlFields::submitted);
  connect(m_choose, &QPushButton::clicked, this, &ControlFields::chooseFile);
  retranslate();
  restyle();
}

void ControlFields::setChoice(const ControlChoice& choice) {
  m_isMapped->setChecked(!choice.mapFile.isEmpty());
  m_mapFile->setText(choice.mapFile);
  m_link->setCurrentIndex(m_link->findData(static_cast<int>(choice.link)));
  showState();
}

ControlChoice ControlFields::choice() const {
  ControlChoice choice;
  if (m_isMapped->isChecked()) {
    choice.mapFile = m_mapFile->text().trimmed();
  }
  if (m_hasQtOpcUa) {
    choice.link = static_cast<opcua::LinkKind>(m_link->currentData().toInt());
  }
  return choice;
}

bool ControlFields::askForMap() {
  if (m_isMapped->isChecked() && choice().mapFile.isEmpty()) {
    chooseFile();
  }
  return !m_isMapped->isChecked() || !choice().mapFile.isEmpty();
}

void ControlFields::setHasQtOpcUa(bool hasQtOpcUa) {
  m_hasQtOpcUa = hasQtOpcUa;
  showState();
}

void ControlFields::chooseFile() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Map of the control"),
                                                    m_mapFile->text(), tr("Maps (*.toml)"));
  if (!file.isEmpty()) {
    m_mapFile->setText(file);
  }
}

void ControlFields::showState() {
  m_mapRow->setVisible(m_isMapped->isChecked());
  m_linkLabel->setVisible(m_hasQtOpcUa);
  m_link->setVisible(m_hasQtOpcUa);
}

void ControlFields::retranslate() {
  m_isMapped->setText(tr("The control is no SINUMERIK"));
  m_isMapped->setToolTip(
      tr("A map says under which names this control has its cells, axes and states. rivulet-cli map "
         "proposes one."));
  m_mapFile->setAccessibleName(tr("Map of the control"));
  m_mapFile->setPlaceholderText(tr("Map of the control"));
  m_mapFile->setToolTip(tr("File with the map (.toml). It is remembered for this machine."));
  m_choose->setText(tr("Choose…"));
  m_choose->setToolTip(tr("Choose the file of the map."));
  m_linkLabel->setText(tr("Library"));
  m_link->setAccessibleName(tr("Library"));
  m_link->setToolTip(
      tr("Which library connects with the machine. Qt OPC UA is slower, does not encrypt, and takes "
         "no map and no user."));
  showState();
}

void ControlFields::restyle() {
  setMuted(m_linkLabel, palette());
}

}  // namespace rivulet::widgets
