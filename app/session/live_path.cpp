// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/live_path.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QPointer>
#include <QThreadPool>
#include <algorithm>

namespace rivulet::session {

namespace {

/// A path grows visibly at this pace.
constexpr int kIntervalMs = 200;
/// Of the time, at most one part in so many is spent on views: the processors are the run's.
constexpr qint64 kShare = 10;
constexpr int kPointsPerLoop = 2;

}  // namespace

std::shared_ptr<const gcode::Program> liveProgram(std::string name, std::string hash,
                                                  const std::vector<gcode::StreamPoint>& points) {
  auto program = std::make_shared<gcode::Program>();
  program->name = std::move(name);
  program->hash = std::move(hash);
  const bool turns = std::any_of(points.begin(), points.end(), [&points](const auto& point) {
    return point.rotaryDeg != points.front().rotaryDeg;
  });
  gcode::Trajectory& path = program->trajectory;
  path.points.reserve(points.size());
  for (const gcode::StreamPoint& point : points) {
    path.points.push_back({point.positionMm, point.feedMmPerS, point.line, point.kind});
    if (turns) {
      path.rotary.push_back({point.rotaryDeg});
    }
  }
  return program;
}

LivePath::LivePath(QObject* parent) : QObject(parent) {
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, &LivePath::make);
}

void LivePath::begin(std::string name, std::string hash) {
  ++m_path;
  m_name = std::move(name);
  m_hash = std::move(hash);
  m_points.clear();
  m_shown = 0;
}

void LivePath::append(const LivePoints& more) {
  if (more.first == m_points.size()) {  // else of a path that has been forgotten
    m_points.insert(m_points.end(), more.points->begin(), more.points->end());
  }
  if (!m_isBusy && !m_timer.isActive()) {
    m_timer.start(kIntervalMs);
  }
}

void LivePath::make() {
  if (m_isBusy || m_shown == m_points.size()) {
    return;
  }
  m_isBusy = true;
  QThreadPool::globalInstance()->start([self = QPointer<LivePath>(this), path = m_path,
                                        points = m_points, name = m_name, hash = m_hash] {
    QElapsedTimer took;
    took.start();
    const base::Vec3 startMm = points.empty() ? base::Vec3{} : points.front().positionMm;
    const auto view =
        widgets::makeProgramView(liveProgram(name, hash, points), startMm, kPointsPerLoop);
    // The context of the call is the application: `self` is only touched on its own thread.
    QMetaObject::invokeMethod(
        qApp,
        [self, path, view, count = points.size(), ms = took.elapsed()] {
          if (!self) {
            return;
          }
          self->m_isBusy = false;
          if (path == self->m_path) {
            self->m_shown = count;
            Q_EMIT self->grown(view);
          }
          if (self->m_shown < self->m_points.size()) {
            self->m_timer.start(static_cast<int>(std::max<qint64>(kIntervalMs, kShare * ms)));
          }
        },
        Qt::QueuedConnection);
  });
}

}  // namespace rivulet::session
