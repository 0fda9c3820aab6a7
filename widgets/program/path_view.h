// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The program's path with the tool on it, from above or isometric.
/// @threadsafety GUI thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gcode/program.h"
#include "widgets/common/page.h"

class QPushButton;

namespace rivulet::widgets {

class PathCanvas;

class PathView final : public Page {
  Q_OBJECT

 public:
  explicit PathView(QWidget* parent = nullptr);

  /// @param program  null: none. Forgets points and progress of the one before.
  void setProgram(std::shared_ptr<const gcode::Program> program);
  /// The points as they are streamed; `setExecuted` counts in this list.
  void setPoints(const std::vector<gcode::StreamPoint>& points);
  void setExecuted(std::size_t count);
  /// @param positionMm  workpiece frame; nothing hides the tool
  void setToolPosition(const std::optional<base::Vec3>& positionMm);
  void setIsometric(bool isometric);
  void fit();

  [[nodiscard]] PathCanvas* canvas() const { return m_canvas; }

 protected:
  void retranslate() override;
  void restyle() override;

 private:
  PathCanvas* m_canvas;
  QPushButton* m_top;
  QPushButton* m_isometric;
  QPushButton* m_fit;
};

}  // namespace rivulet::widgets
