// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine/front/array_store.h"

#include "base/contract.h"

namespace rivulet::machine {

void ArrayStore::install(UA_ServerConfig& config) {
  RIVULET_ASSERT(config.nodestore.context != nullptr);
  m_inner = config.nodestore;
  UA_Nodestore& store = config.nodestore;
  store.context = this;
  store.getNode = &ArrayStore::onGetNode;
  // Everything else is passed on unchanged.
  store.clear = [](void* context) noexcept {
    UA_Nodestore& inner = self(context).m_inner;
    inner.clear(inner.context);
  };
  store.newNode = [](void* context, UA_NodeClass nodeClass) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.newNode(inner.context, nodeClass);
  };
  store.deleteNode = [](void* context, UA_Node* node) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    inner.deleteNode(inner.context, node);
  };
  store.getNodeFromPtr = [](void* context, UA_NodePointer pointer, UA_UInt32 attributes,
                            UA_ReferenceTypeSet references,
                            UA_BrowseDirection directions) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.getNodeFromPtr(inner.context, pointer, attributes, references, directions);
  };
  store.releaseNode = [](void* context, const UA_Node* node) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    inner.releaseNode(inner.context, node);
  };
  store.getNodeCopy = [](void* context, const UA_NodeId* id, UA_Node** copy) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.getNodeCopy(inner.context, id, copy);
  };
  store.insertNode = [](void* context, UA_Node* node, UA_NodeId* id) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.insertNode(inner.context, node, id);
  };
  store.replaceNode = [](void* context, UA_Node* node) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.replaceNode(inner.context, node);
  };
  store.removeNode = [](void* context, const UA_NodeId* id) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.removeNode(inner.context, id);
  };
  store.getReferenceTypeId = [](void* context, UA_Byte index) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    return inner.getReferenceTypeId(inner.context, index);
  };
  store.iterate = [](void* context, UA_NodestoreVisitor visitor, void* visitorContext) noexcept {
    const UA_Nodestore& inner = self(context).m_inner;
    inner.iterate(inner.context, visitor, visitorContext);
  };
}

const UA_Node* ArrayStore::onGetNode(void* context, const UA_NodeId* id, UA_UInt32 attributes,
                                     UA_ReferenceTypeSet references,
                                     UA_BrowseDirection directions) noexcept {
  ArrayStore& store = self(context);
  const UA_Node* node =
      store.m_inner.getNode(store.m_inner.context, id, attributes, references, directions);
  return node == nullptr && store.m_space != nullptr ? store.m_space->arrayNode(store.m_inner, *id)
                                                     : node;
}

}  // namespace rivulet::machine
