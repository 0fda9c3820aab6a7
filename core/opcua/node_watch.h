// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Variables of a server that is no control: it tells when they change (a subscription), so nothing
/// is asked again and again; and its methods. @threadsafety as the link.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/instant.h"
#include "base/result.h"

namespace rivulet::opcua {

/// Nothing in it: the server has no good value, or one of another type. Numbers of any type are
/// doubles.
using NodeValue = std::variant<std::monostate, bool, double, std::string, std::vector<double>>;

struct NodeChange {
  std::size_t index = 0;  ///< of the node among those that are watched
  NodeValue value;
};

class NodeWatch {
 public:
  virtual ~NodeWatch() = default;

  /// From now on the server tells the values of these nodes: at first all, then what changes. It is
  /// heard in `Link::wait`; while nothing changes, it is heard once a second, so `Link::silence`
  /// is the age of what is known. Once per connection.
  /// @param addresses  node ids in text form  @param interval  how often the server looks, > 0
  /// @return VariableMissing for a node that it does not have; the error of the request
  [[nodiscard]] virtual base::Result<void> watch(std::span<const std::string> addresses,
                                                 base::Duration interval) = 0;
  /// What has been told since the last call, in its order.
  [[nodiscard]] virtual std::vector<NodeChange> takeChanges() = 0;
  /// Calls a method whose inputs are texts, and waits for its answer.
  /// @param object, method  node ids in text form
  /// @return its outputs; MethodMissing; the error of the request
  [[nodiscard]] virtual base::Result<std::vector<NodeValue>> callMethod(
      const std::string& object, const std::string& method,
      std::span<const std::string> inputs) = 0;
};

}  // namespace rivulet::opcua
