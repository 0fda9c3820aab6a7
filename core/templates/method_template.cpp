// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "templates/method_template.h"

#include <algorithm>
#include <vector>

#include "base/contract.h"
#include "templates/methods/linuxcnc.h"
#include "templates/methods/loop.h"
#include "templates/methods/window.h"

namespace rivulet::templates {

namespace {

struct Row {
  base::MethodKind method;
  TargetControl target;
  const MethodTemplate* program;
};

std::vector<Row>& rows() {
  using enum base::MethodKind;
  using enum TargetControl;
  static const PositionTemplate position;
  static const SignalTemplate signal;
  static const WindowTemplate window;
  static const CreditTemplate credit;
  static const FileTemplate file;
  static const LinuxCncWindowTemplate linuxCncWindow;
  static const LinuxCncCreditTemplate linuxCncCredit;
  static std::vector<Row> list{
      {Position, Sinumerik, &position},
      {Signal, Sinumerik, &signal},
      {Window, Sinumerik, &window},
      {Credit, Sinumerik, &credit},
      {File, Sinumerik, &file},
      {Window, LinuxCnc, &linuxCncWindow},
      {Credit, LinuxCnc, &linuxCncCredit},
  };
  return list;
}

const MethodTemplate* find(base::MethodKind method, TargetControl target) {
  const auto found = std::find_if(rows().begin(), rows().end(), [&](const Row& row) {
    return row.method == method && row.target == target;
  });
  return found == rows().end() ? nullptr : found->program;
}

}  // namespace

const MethodTemplate& methodTemplate(const TemplateParameters& parameters) {
  const MethodTemplate* const own = find(parameters.method, parameters.target);
  const MethodTemplate* const other = find(parameters.method, TargetControl::Sinumerik);
  RIVULET_ASSERT(own != nullptr || other != nullptr);
  return own != nullptr ? *own : *other;
}

bool hasTemplate(const TemplateParameters& parameters) {
  return find(parameters.method, parameters.target) != nullptr;
}

void addTemplate(base::MethodKind method, TargetControl target, const MethodTemplate& added) {
  rows().push_back({method, target, &added});
}

}  // namespace rivulet::templates
