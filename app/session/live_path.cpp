// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session/live_path.h"

#include <QElapsedTimer>
#include <algorithm>

#include "session/background.h"

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
  struct Made {
    std::shared_ptr<const overview::ProgramView> view;
    std::size_t points = 0;
    qint64 ms = 0;
  };
  inBackground(
      this,
      [points = m_points, name = m_name, hash = m_hash] {
        QElapsedTimer took;
        took.start();
        const base::Vec3 startMm = points.empty() ? base::Vec3{} : points.front().positionMm;
        auto view =
            overview::makeProgramView(liveProgram(name, hash, points), startMm, kPointsPerLoop);
        return Made{std::move(view), points.size(), took.elapsed()};
      },
      [path = m_path](LivePath& self, const Made& made) {
        self.m_isBusy = false;
        if (path == self.m_path) {
          self.m_shown = made.points;
          Q_EMIT self.grown(made.view);
        }
        if (self.m_shown < self.m_points.size()) {
          self.m_timer.start(static_cast<int>(std::max<qint64>(kIntervalMs, kShare * made.ms)));
        }
      });
}

}  // namespace rivulet::session
