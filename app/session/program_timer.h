// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Computes outside the GUI thread where a run will pause and how long a machine takes for a
/// program: with the feeds of the program, and as a method streams it. @threadsafety GUI thread;
/// the work itself runs in the pool (`session/background.h`).
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "base/method_kind.h"
#include "gcode/feeds.h"
#include "machine/config.h"
#include "overview/program_view.h"

namespace rivulet::session {

/// The settings of a run that determine its time.
struct TimeSettings {
  base::MethodKind method = base::kDefaultMethod;
  int pointsPerLoop = 2;
  double feedMmPerS = 0.0;                            ///< > 0
  std::optional<gcode::ProgramFeeds> programFeeds{};  ///< instead of it
  bool feedPerPoint = false;                          ///< see `streaming::WindowCut`
  /// The machine of the times; null: that of the paper.
  std::shared_ptr<const machine::MachineConfig> machine{};
  friend bool operator==(const TimeSettings&, const TimeSettings&) = default;
};

class ProgramTimer final : public QObject {
  Q_OBJECT

 public:
  explicit ProgramTimer(QObject* parent = nullptr) : QObject(parent) {}
  ~ProgramTimer() override;

  /// Begins; work in progress is dropped. What does not depend on the settings is computed once per
  /// program.
  void start(std::shared_ptr<const overview::ProgramView> view, const TimeSettings& settings);
  void cancel();
  [[nodiscard]] bool isBusy() const { return m_stop != nullptr; }

 Q_SIGNALS:
  /// Reported first: it takes only a moment.
  void planned(const std::shared_ptr<const rivulet::overview::PauseMap>& pauses,
               const std::shared_ptr<const rivulet::overview::ProgramView>& view);
  /// Reported as soon as the time of the program itself is known, and again with that of the run.
  void estimated(const std::shared_ptr<const rivulet::overview::ProgramTimes>& times,
                 const std::shared_ptr<const rivulet::overview::ProgramView>& view);

 private:
  std::shared_ptr<std::atomic<bool>> m_stop;  ///< of the work in progress; null: none
  std::shared_ptr<const gcode::Program> m_program;
  std::shared_ptr<const machine::MachineConfig> m_machine;  ///< of `m_times`
  std::shared_ptr<const overview::ProgramTimes> m_times;    ///< of that program
  /// Time without pauses, at the feed of a run, from a position of the tool.
  struct Unpaused {
    double feedMmPerS = 0.0;
    std::optional<gcode::ProgramFeeds> programFeeds;
    base::Vec3 startMm;
    double totalS = 0.0;
  };
  std::optional<Unpaused> m_unpaused;
};

}  // namespace rivulet::session
