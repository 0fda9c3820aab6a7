// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/ring.h"

#include <fmt/format.h>

namespace rivulet::pipeline {

base::Error ringError(PipelineError code, std::string_view ring, const std::string& what) {
  return base::makeError(
      code, fmt::format("Ring buffer {} is refused: {}. End all tasks of the pipeline and start it "
                        "again with one version of the program.",
                        ring, what));
}

}  // namespace rivulet::pipeline
