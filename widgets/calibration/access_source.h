// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The source of the access figures that the equations use, in the operator's words.
/// @threadsafety GUI thread.
#pragma once

#include <QString>
#include <memory>

#include "streaming/setup/calibration_record.h"
#include "widgets/common/status_label.h"

namespace rivulet::widgets {

struct AccessSource {
  std::shared_ptr<const streaming::CalibrationRecord> record;  ///< null: never calibrated
  bool isOutdated = false;  ///< made with another version of the server: shown, not used
  opcua::Grouping form = opcua::Grouping::List;  ///< the form the run will use
  int cellsMax = 1;                              ///< of the longest request of the method

  [[nodiscard]] bool isUsed() const { return record && !isOutdated; }
};

struct AccessSourceText {
  Status status = Status::Plain;
  QString text;
};

/// "Calibrated on 4.5.2026 …: t = 0.32 ms …" or "Assumed [P1]: 4.3 ms per cell".
/// @param accessTime  t as used in the equations
[[nodiscard]] AccessSourceText accessSourceText(const AccessSource& source,
                                                base::Duration accessTime);

/// "one by one", "list", …
[[nodiscard]] QString formText(opcua::Grouping form);
/// "Rivulet virtual machine 0.1.0 dmu75".
[[nodiscard]] QString serverText(const opcua::ServerIdentity& server);
/// A date of a file in the language and the time zone of the operator; unchanged if it is not a
/// date.
[[nodiscard]] QString dateText(const std::string& utc);

}  // namespace rivulet::widgets
