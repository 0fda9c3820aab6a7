// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// For how long tests wait for what happens in any case. Nothing is judged by these times: a test
/// goes on as soon as it has what it waits for.
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer) || __has_feature(address_sanitizer)
#define RIVULET_TESTS_SANITIZED
#endif
#elif defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
#define RIVULET_TESTS_SANITIZED
#endif

namespace rivulet::tests {

#ifdef RIVULET_TESTS_SANITIZED
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

/// How much longer programs may take under a sanitizer. CMake reads it here, for the time limits.
inline constexpr int kSanitizedSlowness = 5;

/// For what a program does at once.
inline constexpr int kSoonMs = 60'000 * (kIsSanitized ? kSanitizedSlowness : 1);
/// For the end of a run, or of a program.
inline constexpr int kRunMs = 300'000 * (kIsSanitized ? kSanitizedSlowness : 1);

}  // namespace rivulet::tests
