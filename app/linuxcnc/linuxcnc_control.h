// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A LinuxCNC that runs on this computer, as a control that `machine::Server` shows. It talks to
/// the helper, a program of its own that is loaded into LinuxCNC (`rivulet-linuxcnc-helper`), and
/// reads the trace from LinuxCNC's own `halsampler`. What LinuxCNC does not have is not shown.
/// @threadsafety as the server.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/instant.h"
#include "base/result.h"
#include "linuxcnc/child_process.h"
#include "linuxcnc/sampler.h"
#include "machine/front/served_control.h"
#include "trace/control_trace.h"

namespace rivulet::linuxcnc {

/// As the bridge presents itself.
inline constexpr std::string_view kProductName = "Rivulet bridge to LinuxCNC";

enum class LinuxCncError {
  NotRunning = 1,  ///< no LinuxCNC, or not for this user; the message says what to do
  BadProgramName,
  FileNotWritable,
  Refused,  ///< LinuxCNC did not do it; the message has its reason
};

[[nodiscard]] std::error_code make_error_code(LinuxCncError code);

struct LinuxCncOptions {
  std::string helper;                  ///< program
  int cells = 200;                     ///< R0 to R(cells-1), each a pin of the HAL
  std::filesystem::path programs;      ///< folder of the part programs, exists
  bool mayStart = false;               ///< clients may start and end programs
  bool hasSampler = false;             ///< the HAL has a sampler.0 with the pins of sampler.h
  std::string sampler = "halsampler";  ///< program that prints its samples
  /// Longest trace that is kept.
  base::Duration traceMax = std::chrono::hours(2);
};

class LinuxCncControl final : public machine::ServedControl {
 public:
  /// Waits up to ten seconds for the helper. @return NotRunning
  [[nodiscard]] static base::Result<std::unique_ptr<LinuxCncControl>> connect(
      const LinuxCncOptions& options);

  /// Set when the helper or LinuxCNC has ended: nothing works any more.
  [[nodiscard]] const std::optional<base::Error>& failure() const { return m_failure; }
  /// "2.9.0".
  [[nodiscard]] const std::string& version() const { return m_version; }

  [[nodiscard]] const machine::ServedFacts& facts() const override { return m_facts; }
  [[nodiscard]] bool shows(std::string_view folder, std::string_view name) const override;
  void advance(base::Instant until) override;
  [[nodiscard]] base::Instant now() const override { return m_now; }
  [[nodiscard]] machine::MachineState state() const override;
  [[nodiscard]] bool hasRParameter(int index) const override;
  [[nodiscard]] double rParameter(int index) const override;
  void writeRParameter(int index, double value) override;
  void beginRequest(machine::AccessKind, base::Instant) override {}
  [[nodiscard]] base::Instant serveNode(base::Instant at) override { return at; }
  [[nodiscard]] base::Duration programTime(std::size_t) const override { return {}; }
  base::Result<void> storeProgram(const std::string& name, std::string text,
                                  bool overwrite) override;
  /// `LinuxCncProtocol::kMachineFile`: what LinuxCNC says of the machine now.
  [[nodiscard]] base::Result<std::string> programText(const std::string& name) override;
  base::Result<void> selectProgram(const std::string& name) override;
  base::Result<void> cycleStart() override;
  void reset() override;
  /// Waits up to five seconds for samples of a program that has just ended; the trace says if they
  /// did not come.
  [[nodiscard]] std::string traceText() override;

 private:
  LinuxCncControl(const LinuxCncOptions& options, ChildProcess helper,
                  std::optional<ChildProcess> sampler);

  [[nodiscard]] base::Result<void> awaitReady();
  void take(const std::string& line);
  void takeOutputs(std::string_view values);
  void takeActs(double percent);
  void takeFeedCells(int index, double before, double value);
  [[nodiscard]] bool watchesClient() const;
  void beat();
  void readMarks();
  void takeLine(std::size_t line);
  void takeState(std::string_view text);
  void takeWaited(double seconds);
  void endTrace();
  void takeSamples();
  void giveUpTrace();
  void fail(const base::Error& error);
  void tell(std::string_view line);
  void setCell(int index, double value);
  /// Tells the helper and waits for its answer.
  [[nodiscard]] base::Result<void> ask(std::string_view command, std::string_view argument);
  [[nodiscard]] std::filesystem::path pathOf(const std::string& name) const;

  LinuxCncOptions m_options;
  ChildProcess m_helper;
  std::optional<ChildProcess> m_sampler;
  machine::ServedFacts m_facts;
  std::string m_version;
  SampleScale m_scale;
  bool m_isReady = false;
  std::optional<base::Error> m_failure;
  base::Instant m_now{};
  machine::MachineState m_state;  ///< without the alarm
  bool m_isSwitchedOn = true;
  int m_reported = 0;  ///< kind of the error that LinuxCNC reported last
  base::Instant m_reportedUntil{};
  base::Instant m_nextBeat{};    ///< of the bridge itself
  double m_waitedS = 0.0;        ///< for a processor, since LinuxCNC was started
  double m_waitedBeforeS = 0.0;  ///< the present program
  base::Instant m_activeSince{};
  bool m_hasState = false;  ///< LinuxCNC has told its state
  std::vector<double> m_cells;
  std::vector<double> m_outputs;              ///< as last told; empty: not yet
  int m_firstCell = 0;                        ///< of the program on the control
  std::string m_programFile;                  ///< as LinuxCNC has opened it
  std::map<std::size_t, int> m_windowOfLine;  ///< `LinuxCncProtocol::kMotionMark`
  int m_windows = 0;                          ///< in its ring; 0: it has no marks
  int m_question = 0;
  std::optional<std::string> m_answer;  ///< "done 3", "failed 3 why"
  struct Tracing {
    trace::ControlTrace trace;
    bool isOn = false;
    bool isEnding = false;        ///< the program has ended, its last samples are on their way
    long long samplesBehind = 0;  ///< had not been taken from the sampler at the program's end
    bool isSamplerFull = false;   ///< and it could take no more
    long long samplesLeft = 0;    ///< of the program that ended last, still to arrive
    base::Instant end{};          ///< so long they are waited for
  };
  Tracing m_tracing;
};

}  // namespace rivulet::linuxcnc

template <>
struct std::is_error_code_enum<rivulet::linuxcnc::LinuxCncError> : std::true_type {};
