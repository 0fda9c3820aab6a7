// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pipeline/error.h"

namespace rivulet::pipeline {

std::error_code make_error_code(PipelineError code) {
  static const base::NamedCategory category("pipeline");
  return {static_cast<int>(code), category};
}

}  // namespace rivulet::pipeline
