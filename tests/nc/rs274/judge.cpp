// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nc/rs274/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "nc/rs274/program_drawer.h"
#include "nc/rs274/rivulet_reading.h"
#include "nc/rs274/rs274.h"

namespace rivulet::tests {

namespace {

class Judge {
 public:
  explicit Judge(const JudgeOptions& options)
      : m_options(options), m_next(options.first), m_end(options.first + options.count) {}

  Judgement run() {
    std::vector<std::thread> threads;
    for (int i = 0; i < m_options.threads; ++i) {
      threads.emplace_back([this, i] { work(m_options.folder / fmt::format("{}", i)); });
    }
    for (std::thread& each : threads) {
      each.join();
    }
    std::sort(m_judgement.examples.begin(), m_judgement.examples.end(),
              [](const Difference& a, const Difference& b) { return a.number < b.number; });
    return std::move(m_judgement);
  }

 private:
  void work(const std::filesystem::path& folder) {
    Rs274 rs274(folder);
    for (std::uint64_t number = m_next++; number < m_end; number = m_next++) {
      const std::string program = drawProgram(m_options.seed, number);
      const Comparison comparison = compared(rs274.read(program), readAsRivulet(program));
      if (count(comparison)) {
        Difference small = made(rs274, program, comparison);
        small.number = number;
        const std::lock_guard lock(m_mutex);
        m_judgement.examples.push_back(std::move(small));
      }
    }
  }

  /// @return true if the program is to be made small
  bool count(const Comparison& comparison) {
    const std::lock_guard lock(m_mutex);
    switch (comparison.agreement) {
      case Agreement::Equal:
        ++m_judgement.equal;
        return false;
      case Agreement::BothRefuse:
        ++m_judgement.bothRefuse[comparison.kind];
        return false;
      case Agreement::NotSupported:
        return ++m_judgement.notSupported[comparison.kind] <=
               static_cast<std::uint64_t>(m_options.refusedPerWord);
      case Agreement::Different:
        break;
    }
    return ++m_judgement.different[comparison.kind] <=
           static_cast<std::uint64_t>(m_options.shrunkPerKind);
  }

  static Difference made(Rs274& rs274, const std::string& program, const Comparison& judged) {
    Difference difference;
    difference.kind = judged.kind;
    difference.program = shrunk(program, [&](const std::string& smaller) {
      const Comparison comparison = compared(rs274.read(smaller), readAsRivulet(smaller));
      return comparison.agreement == judged.agreement && comparison.kind == judged.kind;
    });
    difference.linuxCnc = rs274.read(difference.program);
    difference.rivulet = readAsRivulet(difference.program);
    return difference;
  }

  const JudgeOptions& m_options;
  std::atomic<std::uint64_t> m_next;
  const std::uint64_t m_end;
  std::mutex m_mutex;
  Judgement m_judgement;
};

void describe(std::string& text, std::string_view name, const PathReading& reading) {
  text += fmt::format("  {}{}\n", name, reading.accepted ? "" : " refuses: " + reading.refusal);
  for (const ReadMove& move : reading.moves) {
    text += fmt::format("    {}\n", describe(move));
  }
}

}  // namespace

Judgement judge(const JudgeOptions& options) {
  return Judge(options).run();
}

Difference judgeProgram(const std::string& text, const std::filesystem::path& folder) {
  Difference difference;
  difference.program = text;
  difference.linuxCnc = Rs274(folder).read(text);
  difference.rivulet = readAsRivulet(text);
  const Comparison comparison = compared(difference.linuxCnc, difference.rivulet);
  difference.kind = comparison.agreement == Agreement::NotSupported
                        ? "not supported: " + comparison.kind
                        : comparison.kind;
  return difference;
}

std::string describe(const Difference& difference) {
  std::string text = difference.program;
  text += text.empty() || text.back() != '\n' ? "\n" : "";
  describe(text, "LinuxCNC", difference.linuxCnc);
  describe(text, "Rivulet", difference.rivulet);
  return text;
}

}  // namespace rivulet::tests
