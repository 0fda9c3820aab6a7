// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The variables of the virtual machine as nodes of an OPC UA server, named as on the control.
/// Browsing shows the first element of each variable; all others exist without being listed.
/// @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include <deque>
#include <string>
#include <string_view>

#include "base/result.h"
#include "machine/front/variable_service.h"

namespace rivulet::machine {

struct VariableRow;  ///< one row of the table of variables

/// Context of a node's callbacks; one per node, at a stable address.
struct VariableNode {
  VariableService* service = nullptr;
  const VariableRow* row = nullptr;  ///< null: an R-parameter
  int index = 0;                     ///< R number, or axis: X Y Z are 0 to 2, A B C 3 to 5
  int count = 0;                     ///< elements of an array of R-parameters; 0: a scalar
};

class AddressSpace {
 public:
  /// @param server,service outlive the address space and everything that calls back
  AddressSpace(UA_Server* server, VariableService& service)
      : m_server(server), m_service(service) {}

  /// Creates everything but the methods. @return SetUpFailed
  [[nodiscard]] base::Result<void> build();

  /// The node of an R-parameter array, created when a client first requests it: there are too many
  /// to create all of them. It is not in any folder. @param store the server's own store
  /// @return null if there is no such array, or too many of them have been asked for
  [[nodiscard]] const UA_Node* arrayNode(UA_Nodestore& store, const UA_NodeId& id);

  /// Index of the namespace of the variables, after `build`.
  [[nodiscard]] UA_UInt16 namespaceIndex() const { return m_namespace; }

  /// Elements of the longest array that a client can address; 0: there are no arrays.
  [[nodiscard]] int arrayLengthMax() const;

 private:
  [[nodiscard]] UA_StatusCode addFolder(std::string_view parent, std::string_view identifier,
                                        std::string_view name, std::string_view description);
  [[nodiscard]] UA_StatusCode addParameters();
  [[nodiscard]] UA_StatusCode addVariable(const VariableRow& row);
  /// @param folder empty: not listed
  [[nodiscard]] UA_StatusCode addNode(std::string_view folder, std::string_view identifier,
                                      std::string_view name, const VariableRow* row, int index);

  /// Unit and range of a variable that has them.
  [[nodiscard]] UA_StatusCode addUnit(std::string_view identifier, const VariableNode& node);

  UA_Server* m_server;
  VariableService& m_service;
  UA_UInt16 m_namespace = 0;
  int m_parameterCount = 0;
  std::deque<VariableNode> m_nodes;
  std::size_t m_arrayCount = 0;
};

}  // namespace rivulet::machine
