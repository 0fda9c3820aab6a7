// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The node store of the server, a wrapper of the library's own: if that has no such node, the
/// address space may create one. So all array nodes of a control can be used without being created
/// in advance. @threadsafety as the server.
#pragma once

#include <open62541/server.h>

#include "machine/front/address_space.h"

namespace rivulet::machine {

class ArrayStore {
 public:
  /// Replaces the configuration's store, which must be set, and keeps it. The server clears both
  /// together.
  void install(UA_ServerConfig& config);

  /// From now on, nodes are created. @param space outlives the server's last answer
  void setAddressSpace(AddressSpace* space) { m_space = space; }

 private:
  [[nodiscard]] static ArrayStore& self(void* context) {
    return *static_cast<ArrayStore*>(context);
  }
  static const UA_Node* onGetNode(void* context, const UA_NodeId* id, UA_UInt32 attributes,
                                  UA_ReferenceTypeSet references,
                                  UA_BrowseDirection directions) noexcept;

  UA_Nodestore m_inner{};
  AddressSpace* m_space = nullptr;
};

}  // namespace rivulet::machine
