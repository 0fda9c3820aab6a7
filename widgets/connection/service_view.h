// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A service (`rivulet-service`) as the HMI shows it. What was told before a connection was lost is
/// not in it: nobody knows whether it is still true. @threadsafety plain values, GUI thread.
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <vector>

#include "opcua/connection.h"
#include "streaming/run/run.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

enum class ServiceLink {
  Connecting,
  Connected,
  Silent,  ///< connected, but for some time nothing has been heard
  Gone,    ///< not reachable, or lost; it is tried again
  Asked,   ///< a person has to decide: `question`
};

struct ServiceView {
  QString endpoint;
  QString name;  ///< of its machine, as this computer knows it; may be empty
  ServiceLink link = ServiceLink::Connecting;
  QString problem;  ///< why Gone or Asked, or why a login was refused; may be empty
  QString user;     ///< as whom it is connected, or was to be; empty: nobody has logged in
  std::shared_ptr<const opcua::TrustQuestion> question;
  bool canRemove = true;

  // As the service has told; empty unless `Connected`. Texts of the service are English.
  QString machine;  ///< address
  QString model;
  QString state;  ///< Monitoring/State of docs/service.md; of a run: streaming::runStateName
  QString waitingFor;
  QStringList programs;  ///< files that it offers; empty: it names none
  QString program;
  QString alarm;
  QString message;
  QString leftRun;  ///< a run that can be resumed; empty: none
  bool isRunning = false;
  std::size_t pointsDone = 0;
  std::size_t points = 0;
  double progress = 0.0;    ///< 0 to 1
  double timeLeftS = -1.0;  ///< < 0: not known
  std::size_t lateWindows = 0;
  std::vector<double> positionMm;

  [[nodiscard]] bool isIn(streaming::RunState run) const;
  [[nodiscard]] bool isKnown() const { return link == ServiceLink::Connected; }
  [[nodiscard]] QString title() const { return name.isEmpty() ? machineOrEndpoint() : name; }

 private:
  [[nodiscard]] QString machineOrEndpoint() const { return machine.isEmpty() ? endpoint : machine; }
};

struct ServiceStateText {
  Status status = Status::Unknown;
  QString text;
};
/// State of the connection or, if there is one, of the machine: shape, word and colour.
[[nodiscard]] ServiceStateText serviceStateText(const ServiceView& view);
/// "12 of 49 points, 1:20 min left".
[[nodiscard]] QString servicePointsText(const ServiceView& view);

}  // namespace rivulet::widgets
