// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/methods/window.h"
#include "templates/flexible_program.h"

namespace rivulet::streaming {

Action FileMethod::bring(std::size_t window, std::size_t points) {
  const std::size_t begin = windowBegin(window);
  templates::WindowFile file;
  file.run = m_plan.settings().runNumber;
  file.number = window + 1;
  file.isLast = begin + points == m_plan.pointCount();
  for (std::size_t point = begin; point < begin + points; ++point) {
    m_plan.forEachCoordinate(point, [&](double value) { file.coordinates.push_back(value); });
    // G0 is not scaled by the feeds of the run: a slower rapid is a G1.
    const auto& feeds = m_plan.settings().programFeeds;
    const bool isRapid = feeds && m_plan.point(point).kind == gcode::MoveKind::Rapid &&
                         m_plan.point(point).feedMmPerS >= feeds->rapidMmPerS;
    file.motions.push_back({m_plan.feedMmPerMin(point), isRapid});
  }
  m_name = templates::windowFileName(static_cast<int>(window % m_slots));
  m_text = templates::windowFileText(m_plan.cells(), file);
  return {Action::Kind::Store, {}, {}, points, m_name, m_text};
}

std::unique_ptr<Method> FileMethodType::make(MethodSetup setup) const {
  return std::make_unique<FileMethod>(std::move(setup));
}

}  // namespace rivulet::streaming
