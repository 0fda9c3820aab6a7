// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the page of a test of the control says of it. @threadsafety GUI thread.
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "streaming/control/machine_facts.h"

namespace rivulet::widgets {

/// A test that was made, as far as all of them have the same.
struct ShownTest {
  std::string endpoint;
  opcua::ServerIdentity server;
  std::string testedAtUtc;
  streaming::ChecksOfControl result;
  std::function<QString()> figures;  ///< of this kind of test, in the language of the moment
  bool isEnough = false;             ///< what it is for is allowed by it
  std::vector<streaming::TriedBlock> tried{};
};

class ControlTestTexts {
 public:
  virtual ~ControlTestTexts() = default;

  /// R-parameters in a row.
  [[nodiscard]] virtual int cells() const = 0;
  /// An axis may move in it.
  [[nodiscard]] virtual bool mayMove() const { return false; }
  /// It is a whole job: an axis moves, blocks of the control are tried, and Rivulet brings its
  /// programs to the control.
  [[nodiscard]] virtual bool isOfJobs() const { return false; }
  [[nodiscard]] virtual QString what() const = 0;
  [[nodiscard]] virtual QString program(int firstCell,
                                        const std::optional<streaming::AirMove>& move) const = 0;
  [[nodiscard]] virtual QString fileName() const = 0;
  /// What is done while it runs.
  [[nodiscard]] virtual QString lastStep(const std::optional<streaming::AirMove>& move) const = 0;
  [[nodiscard]] virtual QString notTested() const = 0;
  [[nodiscard]] virtual QString enough() const = 0;
  /// It has passed what was tested, but that is not all.
  [[nodiscard]] virtual QString notEnough() const { return enough(); }
  [[nodiscard]] virtual QString failed() const = 0;
  /// What has to be seen, as a sentence; of a check that is not known here, what the test said.
  [[nodiscard]] virtual QString check(const streaming::CommissioningCheck& check) const = 0;
};

[[nodiscard]] std::unique_ptr<ControlTestTexts> creditTestTexts();
[[nodiscard]] std::unique_ptr<ControlTestTexts> feedTestTexts();
[[nodiscard]] std::unique_ptr<ControlTestTexts> jobTestTexts();

[[nodiscard]] ShownTest shownTest(const streaming::CreditTest& test);
[[nodiscard]] ShownTest shownTest(const streaming::FeedTest& test);
[[nodiscard]] ShownTest shownTest(const streaming::JobTest& test);

}  // namespace rivulet::widgets
