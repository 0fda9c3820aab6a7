// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/connection/control_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

#include "widgets/common/file_field.h"
#include "widgets/common/theme.h"

namespace rivulet::widgets {

ControlFields::ControlFields(QWidget* parent)
    : Page(parent), m_mapFile(new FileField(QStringLiteral("map-file"), this)) {
  m_link->addItem(QStringLiteral("open62541"), static_cast<int>(opcua::LinkKind::Open62541));
  m_link->addItem(QStringLiteral("Qt OPC UA"), static_cast<int>(opcua::LinkKind::QtOpcUa));
  m_linkLabel->setBuddy(m_link);
  for (QWidget* field : std::initializer_list<QWidget*>{m_isMapped, m_link}) {
    field->setMinimumHeight(kTouchHeightPx);
  }
  auto* layout = inColumn({m_isMapped, m_mapFile, m_linkLabel, m_link}, this, QMargins(0, 0, 0, 0));
  layout->setSpacing(2);
  connect(m_isMapped, &QCheckBox::toggled, this, &ControlFields::showState);
  connect(m_mapFile, &FileField::submitted, this, &ControlFields::submitted);
  retranslate();
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
  m_mapFile->setTexts(tr("Map of the control"),
                      tr("File with the map (.toml). It is remembered for this machine."),
                      tr("Maps (*.toml)"));
  showState();
}

}  // namespace rivulet::widgets
