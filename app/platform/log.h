// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The log of the programs, made with spdlog: what went wrong goes to standard error, more of it to
/// a rotating file beside the recordings, and all of it to whoever listens (the log page of the
/// HMI). Only `app` logs; core returns values. @threadsafety any thread, after `setUp`.
#pragma once

#include <spdlog/logger.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace rivulet::log {

/// Files of at most this size are kept, the newest and two older ones.
inline constexpr std::size_t kFileBytesMax = std::size_t{1} << 20U;
inline constexpr std::size_t kOlderFiles = 2;

struct Settings {
  std::string program;  ///< in front of what goes to standard error, and name of the file
  /// One of `levelNames`. Empty: `info` for the file and `warning` for standard error.
  std::string level;
  /// Of the file, made if it does not exist. Empty: no file.
  std::filesystem::path folder;
  bool toStandardError = true;
};

/// "trace" to "critical", and "off".
[[nodiscard]] std::vector<std::string> levelNames();

/// Where the HMI keeps its recordings: below $XDG_DATA_HOME (or ~/.local/share). Empty without a
/// home.
[[nodiscard]] std::filesystem::path recordingsFolder();

/// To be called once, before other threads log. @return why there is no file; the rest of the log
/// works nevertheless
base::Result<void> setUp(const Settings& settings);

/// The one logger. Before `setUp` only listeners hear of it.
[[nodiscard]] spdlog::logger& logger();

struct Line {
  std::chrono::system_clock::time_point at;
  spdlog::level::level_enum level = spdlog::level::info;
  std::string text;
};

/// Hears every line from `info` on for as long as it lives.
class Listener {
 public:
  /// @param heard  called on the thread that logs; must not log itself
  explicit Listener(std::function<void(const Line&)> heard);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

 private:
  std::shared_ptr<spdlog::sinks::sink> m_sink;
};

}  // namespace rivulet::log
