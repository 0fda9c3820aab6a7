// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a server says of its machines by the companion specifications OPC 40001-1 (Machinery) and
/// OPC 40501-1 (Machine Tools): who made it, its state, its program and job. For a person only;
/// nothing is controlled by it, and nothing is written. @threadsafety as the link.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace rivulet::opcua {

class NodeBrowser;

/// Texts are as the server gives them, cut at 60 characters; empty: it does not say.
struct DescribedMachine {
  std::string name;  ///< browse name

  std::string manufacturer;
  std::string model;
  std::string serialNumber;
  std::string softwareRevision;
  std::string yearOfConstruction;
  std::string location;
  std::string productInstanceUri;

  std::string state;          ///< of the item: "Executing"
  std::string operationMode;  ///< "Processing", or of older machine tools "Automatic"

  std::string program;  ///< that is active
  std::string programState;
  std::string job;  ///< the active program belongs to it
  std::string jobState;
  std::optional<int> runsCompleted;
  std::optional<int> runsPlanned;

  friend bool operator==(const DescribedMachine&, const DescribedMachine&) = default;
};

/// The machines of the server's folder Machines. About twenty requests if there is one, otherwise
/// one at most. What this user may not read is left out.
/// @return empty: the server describes none. ConnectionLost, DeadlineExceeded
[[nodiscard]] base::Result<std::vector<DescribedMachine>> readMachines(NodeBrowser& browser);

}  // namespace rivulet::opcua
