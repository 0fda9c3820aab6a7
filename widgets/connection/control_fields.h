// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What kind of server a machine has: a SINUMERIK, or one whose variables a map names; and which
/// library connects with it. @threadsafety GUI thread.
#pragma once

#include <QString>

#include "opcua/connection.h"
#include "widgets/common/page.h"

class QCheckBox;
class QComboBox;

namespace rivulet::widgets {

class FileField;

/// As it was chosen.
struct ControlChoice {
  QString mapFile;  ///< empty: it is a SINUMERIK
  opcua::LinkKind link = opcua::LinkKind::Open62541;
  friend bool operator==(const ControlChoice&, const ControlChoice&) = default;
};

class ControlFields final : public Page {
  Q_OBJECT

 public:
  explicit ControlFields(QWidget* parent = nullptr);

  /// Shows what was chosen for another machine.
  void setChoice(const ControlChoice& choice);
  [[nodiscard]] ControlChoice choice() const;
  /// Asks for the file if there is to be a map and none is named. @return false: still none
  [[nodiscard]] bool askForMap();
  /// Without it there is one library only, and nothing to choose.
  void setHasQtOpcUa(bool hasQtOpcUa);

 Q_SIGNALS:
  /// Return was pressed in the field of the map.
  void submitted();

 protected:
  void retranslate() override;

 private:
  void showState();

  bool m_hasQtOpcUa = false;
  QCheckBox* m_isMapped =
      checkBox({.text = QT_TR_NOOP("The control is no SINUMERIK"),
                .tip = QT_TR_NOOP("A map says under which names this control has its memory, axes "
                                  "and states. rivulet-cli map proposes one."),
                .id = "mapped"});
  FileField* m_mapFile;
  QLabel* m_linkLabel = label({.text = QT_TR_NOOP("Library"), .isMuted = true});
  QComboBox* m_link =
      list({.tip = QT_TR_NOOP("Which library connects with the machine. Qt OPC UA is slower, does "
                              "not encrypt, and takes no map and no user."),
            .name = QT_TR_NOOP("Library"),
            .id = "link"});
};

}  // namespace rivulet::widgets
