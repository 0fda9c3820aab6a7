// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/net_player.h"

#include <algorithm>
#include <utility>

#include "base/contract.h"

namespace rivulet::hmi {

namespace {

constexpr int kTurnMs = 33;
/// Of a turn, for the net: the window needs the rest.
constexpr qint64 kWorkMs = 12;
constexpr auto kEnd = static_cast<petri::Word>(pipeline::kFigure13S * pipeline::kNetUnitsPerS);

}  // namespace

NetPlayer::NetPlayer() {
  m_timer.setInterval(kTurnMs);
  connect(&m_timer, &QTimer::timeout, this, &NetPlayer::play);
  restart();
}

NetPlayer::~NetPlayer() = default;

void NetPlayer::choose(const widgets::NetChoice& choice) {
  m_choice = choice;
  m_net.reset();
  restart();
}

void NetPlayer::restart() {
  m_timer.stop();
  m_simulator.reset();
  if (!m_net) {
    auto net =
        petri::loadNet("p3", pipeline::figure13Parameters(m_choice.cycleMs, m_choice.policy));
    RIVULET_ASSERT(net.has_value());  // it comes with Rivulet, and so do its parameters
    m_net = std::make_shared<const petri::Net>(std::move(*net));
    m_reader.emplace(*m_net);
  }
  m_state = {};
  m_state.net = m_net;
  for (auto& levels : m_state.levels) {
    levels.assign(2, QPointF());
  }
  m_simulator = std::make_unique<petri::Simulator>(*m_net);
  m_simulator->setRecorder([this](const petri::Recorded& recorded) { record(recorded); });
  m_simulator->setWatcher(
      [this](std::size_t transition, petri::Word /*time*/) { m_state.fired = transition; });
  publish();
}

void NetPlayer::record(const petri::Recorded& recorded) {
  if (const auto level = m_reader->read(recorded)) {
    // The last point is where the line has got to.
    auto& levels = m_state.levels[level->buffer];
    levels.back().setX(level->timeS);
    levels.emplace_back(level->timeS, level->level);
    levels.emplace_back(level->timeS, level->level);
  }
}

bool NetPlayer::fireOne() {
  return m_simulator && m_simulator->step(kEnd);
}

void NetPlayer::step() {
  if (fireOne()) {
    publish();
  }
}

void NetPlayer::setPlaying(bool plays) {
  if (!m_simulator || plays == m_timer.isActive()) {
    return;
  }
  if (plays) {
    m_due = 0.0;
    m_sinceTurn.start();
    m_timer.start();
  } else {
    m_timer.stop();
  }
  publish();
}

void NetPlayer::setSpeed(double firingsPerS) {
  m_firingsPerS = firingsPerS;
}

void NetPlayer::play() {
  m_due += m_firingsPerS * static_cast<double>(m_sinceTurn.restart()) / 1e3;
  QElapsedTimer work;
  work.start();
  bool hasFired = false;
  while (m_due >= 1.0 && work.elapsed() < kWorkMs) {
    m_due -= 1.0;
    if (!fireOne()) {
      m_timer.stop();
      break;
    }
    hasFired = true;
  }
  m_due = std::min(m_due, m_firingsPerS * kTurnMs / 1e3 + 1.0);  // a slow computer plays slowly
  if (hasFired || !m_timer.isActive()) {
    publish();
  }
}

void NetPlayer::publish() {
  m_state.next = m_simulator->next(kEnd);
  m_state.now = m_simulator->now();
  m_state.firings = m_simulator->firings();
  m_state.marking = m_simulator->marking();
  m_state.enabled.assign(m_net->transitions.size(), false);
  for (std::size_t i = 0; m_state.next && i < m_net->transitions.size(); ++i) {
    m_state.enabled[i] = m_simulator->isEnabled(i, m_state.now);
  }
  for (auto& levels : m_state.levels) {
    levels.back().setX(static_cast<double>(m_state.now) / pipeline::kNetUnitsPerS);
  }
  if (!m_state.next) {
    m_timer.stop();
  }
  m_state.isPlaying = m_timer.isActive();
  Q_EMIT changed();
}

}  // namespace rivulet::hmi
