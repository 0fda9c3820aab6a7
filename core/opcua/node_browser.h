// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What a server has, for a person who makes a map of it: nodes below a node, and facts about
/// variables. Nothing is written. @threadsafety as the link.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "base/result.h"

namespace rivulet::opcua {

/// The folder Objects.
inline constexpr const char* kObjectsFolder = "i=85";

enum class NodeKind { Object, Variable, Method, Other };

struct BrowsedNode {
  /// By the URI of its namespace, as an address of a `ControlMap`.
  std::string address;
  int nameSpace = 0;  ///< index of the namespace of `name` on this server
  std::string name;   ///< browse name
  NodeKind kind = NodeKind::Other;
  std::string nameUri = {};  ///< of the namespace of `name`
};

/// Value and rights of a variable, as read now.
struct NodeFacts {
  std::error_code status;  ///< clear: the value is good
  std::string type;        ///< "Double"; empty: none of the standard's built-in types
  bool isNumber = false;   ///< the value; booleans are none
  bool isBoolean = false;
  bool isText = false;
  bool isArray = false;
  std::size_t length = 1;  ///< of an array
  std::string value;       ///< for a person, of at most 60 characters; of an array its beginning
  bool mayRead = false;    ///< this user
  bool mayWrite = false;
};

class NodeBrowser {
 public:
  virtual ~NodeBrowser() = default;
  /// What the node consists of: by forward hierarchical references, in the order of the server.
  /// @param address  node id in text form
  /// @return the error of the request; TooManyItems if there are more than it is sensible to list
  [[nodiscard]] virtual base::Result<std::vector<BrowsedNode>> children(
      const std::string& address) = 0;
  /// One per address, in order. @return the error of a request
  [[nodiscard]] virtual base::Result<std::vector<NodeFacts>> examine(
      std::span<const std::string> addresses) = 0;
};

}  // namespace rivulet::opcua
