// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Plays the net of [P3] for the page CNC tasks: step by step or so many transitions a second,
/// for the time of Figure 13. @threadsafety GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "petri/simulator.h"
#include "pipeline/figure13.h"
#include "widgets/pipeline/net_state.h"

namespace rivulet::hmi {

class NetPlayer final : public QObject {
  Q_OBJECT

 public:
  NetPlayer();
  ~NetPlayer() override;

  /// Begins anew with other settings.
  void choose(const widgets::NetChoice& choice);
  /// Begins anew.
  void restart();
  /// Fires one transition.
  void step();
  void setPlaying(bool plays);
  /// @param firingsPerS > 0
  void setSpeed(double firingsPerS);

  [[nodiscard]] const widgets::NetState& state() const { return m_state; }

 Q_SIGNALS:
  void changed();

 private:
  void play();
  /// @return whether a transition has fired
  bool fireOne();
  void record(const petri::Recorded& recorded);
  /// Shows what the simulator holds now.
  void publish();

  widgets::NetChoice m_choice;
  std::shared_ptr<const petri::Net> m_net;
  std::unique_ptr<petri::Simulator> m_simulator;  ///< of `m_net`
  std::optional<pipeline::LevelReader> m_reader;
  widgets::NetState m_state;
  QTimer m_timer;
  QElapsedTimer m_sinceTurn;
  double m_firingsPerS = 25.0;
  double m_due = 0.0;  ///< transitions that should have fired by now
};

}  // namespace rivulet::hmi
