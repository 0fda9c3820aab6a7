// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/method_kind.h"

#include <algorithm>
#include <deque>

namespace rivulet::base {

namespace {

std::deque<MethodTraits>& added() {
  static std::deque<MethodTraits> list;
  return list;
}

template <class Is>
const MethodTraits* findAdded(Is is) {
  const auto found = std::find_if(added().begin(), added().end(), is);
  return found == added().end() ? nullptr : &*found;
}

}  // namespace

MethodKind addMethod(MethodTraits traits) {
  traits.kind = static_cast<MethodKind>(kMethods.size() + added().size());
  return added().emplace_back(traits).kind;
}

const MethodTraits* addedMethod(MethodKind method) {
  return findAdded([method](const MethodTraits& traits) { return traits.kind == method; });
}

const MethodTraits* addedMethod(std::string_view name) {
  return findAdded([name](const MethodTraits& traits) { return traits.name == name; });
}

}  // namespace rivulet::base
