// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <utility>
#include <vector>

#include "base/contract.h"
#include "streaming/methods/position.h"
#include "streaming/methods/signal.h"
#include "streaming/methods/window.h"
#include "templates/method_template.h"

namespace rivulet::streaming {

namespace {

using Row = std::pair<base::MethodKind, const MethodType*>;

std::vector<Row>& rows() {
  using enum base::MethodKind;
  static const PositionMethodType position;
  static const SignalMethodType signal;
  static const WindowMethodType window;
  static const CreditMethodType credit;
  static const FileMethodType file;
  static std::vector<Row> list{{Position, &position},
                               {Signal, &signal},
                               {Window, &window},
                               {Credit, &credit},
                               {File, &file}};
  return list;
}

}  // namespace

const MethodType& methodType(base::MethodKind method) {
  const auto found = std::find_if(rows().begin(), rows().end(),
                                  [method](const Row& row) { return row.first == method; });
  RIVULET_ASSERT(found != rows().end());
  return *found->second;
}

base::MethodKind registerMethod(const base::MethodTraits& traits,
                                const templates::MethodTemplate& program, const MethodType& type) {
  const base::MethodKind method = base::addMethod(traits);
  templates::addTemplate(method, templates::TargetControl::Sinumerik, program);
  rows().emplace_back(method, &type);
  return method;
}

}  // namespace rivulet::streaming
