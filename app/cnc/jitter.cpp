// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cnc/jitter.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numeric>

#include "base/file.h"
#include "base/text.h"

extern char** environ;

namespace rivulet::cnc {

namespace {

constexpr double kNsPerUs = 1000.0;
/// Wake-ups that are later than this are counted by cyclictest, but not by their time, us.
constexpr int kHistogramUs = 20'000;

/// Circles without end; the run is ended by its time.
constexpr const char* kCircles =
    "G90 G64\nG1 X100 Y100 F6000\nLOOP\nG2 X100 Y100 I20 J0\nG1 X140\nG1 X100\nENDLOOP\n";

/// Another program that runs meanwhile; its standard output is kept.
class Companion {
 public:
  explicit Companion(std::vector<std::string> words) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      return;
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<char*> arguments;
    for (std::string& word : words) {
      arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    if (::posix_spawnp(&m_process, arguments[0], &actions, nullptr, arguments.data(), environ) !=
        0) {
      m_process = 0;
    }
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    m_output = ends[0];
  }
  ~Companion() { static_cast<void>(finish()); }
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;

  [[nodiscard]] bool isThere() const { return m_process > 0; }

  /// Waits for its end. @return what it has written; nothing if it has failed
  [[nodiscard]] std::optional<std::string> finish() {
    std::string text;
    if (m_output >= 0) {
      std::array<char, 4096> buffer{};
      for (ssize_t bytes = 0; (bytes = ::read(m_output, buffer.data(), buffer.size())) > 0;) {
        text.append(buffer.data(), static_cast<std::size_t>(bytes));
      }
      ::close(m_output);
      m_output = -1;
    }
    int status = -1;
    if (m_process > 0) {
      ::waitpid(m_process, &status, 0);
      m_process = 0;
    }
    return status == 0 ? std::optional(text) : std::nullopt;
  }

 private:
  pid_t m_process = 0;
  int m_output = -1;
};

Distribution distributionOf(const std::map<double, std::uint64_t>& counts) {
  Distribution result;
  double sum = 0.0;
  for (const auto& [time, count] : counts) {
    result.count += count;
    sum += time * static_cast<double>(count);
  }
  if (result.count == 0) {
    return result;
  }
  result.min = counts.begin()->first;
  result.max = counts.rbegin()->first;
  result.mean = sum / static_cast<double>(result.count);
  const auto quantile = [&](double share) {
    const double wanted = share * static_cast<double>(result.count);
    double seen = 0.0;
    for (const auto& [time, count] : counts) {
      seen += static_cast<double>(count);
      if (seen >= wanted) {
        return time;
      }
    }
    return result.max;
  };
  result.p50 = quantile(0.5);
  result.p99 = quantile(0.99);
  result.p999 = quantile(0.999);
  return result;
}

/// The histogram of cyclictest, and its greatest time, which may lie beyond it.
std::optional<Distribution> readCyclictest(std::string_view text) {
  std::map<double, std::uint64_t> counts;
  double largest = 0.0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), end + 1));
    constexpr std::string_view kMax = "# Max Latencies: ";
    if (line.substr(0, kMax.size()) == kMax) {
      largest =
          base::parseNumber(line.substr(kMax.size(), line.find(' ', kMax.size()) - kMax.size()))
              .value_or(0.0);
    }
    const std::size_t gap = line.find_first_of(" \t");
    if (line.empty() || line[0] == '#' || gap == std::string_view::npos) {
      continue;
    }
    const auto time = base::parseNumber(line.substr(0, gap));
    const auto count = base::parseInteger(line.substr(gap + 1));
    if (time && count && *count > 0) {
      counts[*time] = static_cast<std::uint64_t>(*count);
    }
  }
  if (counts.empty()) {
    return std::nullopt;
  }
  Distribution result = distributionOf(counts);
  result.max = std::max(result.max, largest);
  return result;
}

/// A file that is removed at the end.
struct TemporaryFile {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("rivulet-cnc-{}.mpf", ::getpid());
  TemporaryFile() = default;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code status;
    std::filesystem::remove(path, status);
  }
};

}  // namespace

Distribution distributionOf(std::vector<base::Duration> times) {
  std::map<double, std::uint64_t> counts;
  for (const base::Duration time : times) {
    ++counts[static_cast<double>(time.count()) / kNsPerUs];
  }
  return distributionOf(counts);
}

base::Result<Jitter> measureJitter(const JitterOptions& options, const std::atomic<bool>& stop) {
  Jitter jitter;
  const TemporaryFile program;
  if (auto written = base::writeFile(program.path, kCircles); !written) {
    return base::fail(written.error());
  }
  RunOptions run = options.run;
  run.program = program.path.string();
  run.until = options.duration;
  const auto seconds = static_cast<long>(std::ceil(base::toSeconds(options.duration)));
  const long cycleUs = static_cast<long>(run.dispatch.positionCycle / std::chrono::microseconds{1});
  std::optional<Companion> load;
  if (options.withLoad) {
    load.emplace(std::vector<std::string>{"stress-ng", "--cpu", "0", "--io", "1", "--timeout",
                                          fmt::format("{}s", seconds + 1)});
    if (!load->isThere()) {
      jitter.remarks.emplace_back("There is no load: stress-ng is not installed.");
    }
  }
  const bool isFifo = run.priority > 0;
  std::vector<std::string> words{"cyclictest",
                                 "--mlockall",
                                 "--quiet",
                                 fmt::format("--interval={}", cycleUs),
                                 fmt::format("--duration={}s", seconds),
                                 fmt::format("--histogram={}", kHistogramUs),
                                 isFifo ? std::string("--policy=fifo") : "--policy=other"};
  if (isFifo) {
    words.push_back(fmt::format("--priority={}", run.priority));
  }
  Companion cyclictest(std::move(words));
  auto done = runCnc(run, stop);
  const auto text = cyclictest.isThere() ? cyclictest.finish() : std::nullopt;
  if (text) {
    jitter.cyclictest = readCyclictest(*text);
  }
  if (!jitter.cyclictest) {
    jitter.remarks.emplace_back(
        "There is nothing to compare with: cyclictest (package rt-tests) is not installed, or the "
        "system refused it.");
  }
  if (!done) {
    return base::fail(done.error());
  }
  jitter.run = std::move(*done);
  jitter.wakeUp = distributionOf(jitter.run.wakeUps);
  std::vector<base::Duration> deviations = jitter.run.cycles;
  for (base::Duration& cycle : deviations) {
    cycle -= run.dispatch.positionCycle;
    jitter.missed += cycle >= run.dispatch.positionCycle ? 1U : 0U;
  }
  jitter.cycle = distributionOf(std::move(deviations));
  return jitter;
}

}  // namespace rivulet::cnc
