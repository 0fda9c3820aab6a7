// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/control_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "widgets/common/file_field.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

ControlFields::ControlFields(QWidget* parent)
    : Page(parent),
      m_isMapped(new QCheckBox(this)),
      m_mapFile(new FileField(QStringLiteral("map-file"), this)),
      m_linkLabel(new QLabel(this)),
      m_link(new QComboBox(this)) {
  m_isMapped->setObjectName(QStringLiteral("mapped"));
  m_link->setObjectName(QStringLiteral("link"));
  m_link->addItem(QStringLiteral("open62541"), static_cast<int>(opcua::LinkKind::Open62541));
  m_link->addItem(QStringLiteral("Qt OPC UA"), static_cast<int>(opcua::LinkKind::QtOpcUa));
  m_linkLabel->setBuddy(m_link);
  for (QWidget* field : std::initializer_list<QWidget*>{m_isMapped, m_link}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_isMapped);
  layout->addWidget(m_mapFile);
  layout->addWidget(m_linkLabel);
  layout->addWidget(m_link);
  connect(m_isMapped, &QCheckBox::toggled, this, &ControlFields::showState);
  connect(m_mapFile, &FileField::submitted, this, &ControlFields::submitted);
  retranslate();
  restyle();
}

void ControlFields::setChoice(const ControlChoice& choice) {
  m_isMapped->setChecked(!choice.mapFile.isEmpty());
  m_mapFile->setFile(choice.mapFile);
  m_link->setCurrentIndex(m_link->findData(static_cast<int>(choice.link)));
  showState();
}

ControlChoice ControlFields::choice() const {
  ControlChoice choice;
  if (m_isMapped->isChecked()) {
    choice.mapFile = m_mapFile->file();
  }
  if (m_hasQtOpcUa) {
    choice.link = static_cast<opcua::LinkKind>(m_link->currentData().toInt());
  }
  return choice;
}

bool ControlFields::askForMap() {
  if (m_isMapped->isChecked() && choice().mapFile.isEmpty()) {
    m_mapFile->choose();
  }
  return !m_isMapped->isChecked() || !choice().mapFile.isEmpty();
}

void ControlFields::setHasQtOpcUa(bool hasQtOpcUa) {
  m_hasQtOpcUa = hasQtOpcUa;
  showState();
}

void ControlFields::showState() {
  m_mapFile->setVisible(m_isMapped->isChecked());
  m_linkLabel->setVisible(m_hasQtOpcUa);
  m_link->setVisible(m_hasQtOpcUa);
}

void ControlFields::retranslate() {
  m_isMapped->setText(tr("The control is no SINUMERIK"));
  m_isMapped->setToolTip(
      tr("A map says under which names this control has its cells, axes and states. rivulet-cli map "
         "proposes one."));
  m_mapFile->setTexts(tr("Map of the control"),
                      tr("File with the map (.toml). It is remembered for this machine."),
                      tr("Maps (*.toml)"));
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
