// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What the file of a survey begins with: `rivulet-cli survey` writes it, `rivulet-machine --from`
/// reads it. @threadsafety constants.
#pragma once

namespace rivulet::opcua {

inline constexpr const char* kSurveyKey = "rivulet_survey";
inline constexpr int kSurveyFormat = 1;
/// More R-parameters than a survey looks for.
inline constexpr int kSurveyedParametersMax = 100'000;

}  // namespace rivulet::opcua
