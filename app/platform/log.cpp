// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "platform/log.h"

#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/dist_sink.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <mutex>
#include <utility>

#include "base/error.h"
#include "platform/user_folders.h"

namespace rivulet::log {

namespace fs = std::filesystem;

namespace {

using Sinks = spdlog::sinks::dist_sink_mt;

struct Log {
  std::shared_ptr<Sinks> sinks = std::make_shared<Sinks>();
  spdlog::logger logger{"rivulet", sinks};

  Log() {
    logger.set_level(spdlog::level::trace);  // each sink has its own
    // A full disk must neither stop a run nor fill standard error.
    logger.set_error_handler([](const std::string&) {});
  }
};

Log& theLog() {
  static Log log;
  return log;
}

class ListenerSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit ListenerSink(std::function<void(const Line&)> heard) : m_heard(std::move(heard)) {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    m_heard(
        {message.time, message.level, std::string(message.payload.data(), message.payload.size())});
  }
  void flush_() override {}

  std::function<void(const Line&)> m_heard;
};

}  // namespace

std::vector<std::string> levelNames() {
  std::vector<std::string> names;
  for (int level = 0; level < spdlog::level::n_levels; ++level) {
    const auto name = spdlog::level::to_string_view(static_cast<spdlog::level::level_enum>(level));
    names.emplace_back(name.data(), name.size());
  }
  return names;
}

fs::path recordingsFolder() {
  const fs::path data = folders::dataHome();
  return data.is_absolute() ? data / "Rivulet" / "Rivulet" / "runs" : fs::path();
}

base::Result<void> setUp(const Settings& settings) {
  const bool isChosen = !settings.level.empty();
  const spdlog::level::level_enum chosen = spdlog::level::from_str(settings.level);
  if (settings.toStandardError) {
    auto errors = std::make_shared<spdlog::sinks::stderr_sink_mt>();
    errors->set_level(isChosen ? chosen : spdlog::level::warn);
    errors->set_pattern(settings.program + ": %v");
    theLog().sinks->add_sink(std::move(errors));
  }
  if (settings.folder.empty() || (isChosen && chosen == spdlog::level::off)) {
    return {};
  }
  const fs::path path = settings.folder / (settings.program + ".log");
  std::error_code status;
  fs::create_directories(settings.folder, status);
  try {
    auto file = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(path.native(), kFileBytesMax,
                                                                       kOlderFiles);
    file->set_level(isChosen ? chosen : spdlog::level::info);
    // With the process: several may write to the same file.
    file->set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %P %l %v");
    theLog().sinks->add_sink(std::move(file));
  } catch (const spdlog::spdlog_ex& error) {
    return base::fail(std::make_error_code(std::errc::io_error),
                      "The log file cannot be written. Check the folder and its permissions.",
                      path.string());
  }
  theLog().logger.flush_on(spdlog::level::info);
  return {};
}

spdlog::logger& logger() {
  return theLog().logger;
}

Listener::Listener(std::function<void(const Line&)> heard)
    : m_sink(std::make_shared<ListenerSink>(std::move(heard))) {
  m_sink->set_level(spdlog::level::info);
  theLog().sinks->add_sink(m_sink);
}

Listener::~Listener() {
  theLog().sinks->remove_sink(m_sink);
}

}  // namespace rivulet::log
