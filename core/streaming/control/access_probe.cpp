// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "streaming/control/access_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "opcua/await.h"
#include "streaming/run/run.h"

namespace rivulet::streaming {

namespace {

using base::Duration;
using base::Result;
using opcua::Grouping;
using opcua::LinkError;

/// Forms in the order of preference.
constexpr std::array kPreferred{Grouping::ArrayCount, Grouping::ArrayRange, Grouping::List,
                                Grouping::Single};

/// Single access costs one round trip per cell: over a slow network fewer cells are tried.
constexpr Duration kSlowRoundTrip = std::chrono::milliseconds{50};
constexpr std::size_t kSlowCells = 8;

/// The deadline of a request with this many items. @param access  duration of a single one
Duration deadlineOf(Duration deadline, std::size_t items, Duration access) {
  constexpr Duration kPerItem = std::chrono::milliseconds{20};
  return deadline + std::max(kPerItem, 3 * access) * static_cast<Duration::rep>(items);
}

class Probe {
 public:
  Probe(opcua::Link& link, const ScratchCells& cells, Duration deadline)
      : m_link(link), m_deadline(deadline) {
    for (int cell = cells.first; cell <= cells.last; ++cell) {
      m_cells.push_back(opcua::rParameter(cell));
    }
  }

  Result<AccessForms> run() {
    if (Result<void> done = begin(); !done) {
      return base::fail(done.error());
    }
    AccessForms forms;
    Result<void> result = proveSingle();
    for (const Grouping form : kPreferred) {
      FormProof proof{form, true, true, {}};
      if (result && form != Grouping::Single) {
        result = prove(proof);
      }
      forms.proofs.push_back(std::move(proof));
    }
    const Result<void> restored = restore();
    if (!result) {
      base::Error error = result.error();
      if (!restored) {
        error.message += kNotRestored;
      }
      return base::fail(std::move(error));
    }
    if (!restored) {
      base::Error error = restored.error();
      error.message += kNotRestored;
      return base::fail(std::move(error));
    }
    return forms;
  }

 private:
  static constexpr const char* kNotRestored =
      " The scratch cells could not be restored: they hold test values.";

  [[nodiscard]] std::span<const opcua::Variable> inner() const {
    return std::span(m_cells).subspan(1, m_cells.size() - 2);
  }

  /// Some servers do not answer arrays at all. What the run cannot do without gets more time: the
  /// network may stall.
  [[nodiscard]] Duration deadlineFor(Grouping form) const {
    return opcua::isArray(form) ? m_deadline : std::max(m_deadline, kSetupDeadline);
  }
  Result<opcua::Event> ask(std::span<const opcua::Variable> cells, Grouping form) {
    const Duration deadline = deadlineFor(form);
    return opcua::awaitAnswer(m_link, m_link.read(cells, deadline, form), deadline);
  }
  Result<opcua::Event> bring(std::span<const opcua::Assignment> items, Grouping form) {
    const Duration deadline = deadlineFor(form);
    return opcua::awaitAnswer(m_link, m_link.write(items, deadline, form), deadline);
  }

  /// Checks whether the cells may be used, and keeps their values.
  Result<void> begin() {
    const std::array<opcua::Variable, 1> channel{{{opcua::VariableKind::ChannelStatus, 0}}};
    const base::Instant asked = m_link.now();
    const auto status = opcua::readNow(m_link, channel, std::max(m_deadline, kSetupDeadline));
    if (!status) {
      return base::fail(status.error());
    }
    const Duration access = m_link.now() - asked;
    if (access > kSlowRoundTrip) {
      m_cells.resize(std::min(m_cells.size(), kSlowCells));
    }
    m_deadline = deadlineOf(m_deadline, m_cells.size(), access);
    if ((*status)[0].status || (*status)[0].number != opcua::kChannelReset) {
      return base::fail(StreamError::ChannelBusy,
                        "A program is running on the control. Wait until it has ended, or reset "
                        "the control, before the forms of access are tested.");
    }
    const Result<opcua::Event> before = ask(m_cells, Grouping::Single);
    if (!before) {
      return base::fail(before.error());
    }
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
      const opcua::Reading& reading = before->readings[i];
      if (reading.status) {
        return base::fail(reading.status,
                          fmt::format("R{} cannot be read. Choose cells that exist (MD28050).",
                                      m_cells[i].index));
      }
      m_before.push_back({m_cells[i], reading.number});
    }
    return {};
  }

  /// Numbers that differ from those of all other rounds and cells.
  [[nodiscard]] std::vector<opcua::Assignment> pattern() {
    constexpr double kRound = 100'000.0;
    ++m_round;
    std::vector<opcua::Assignment> items;
    for (const opcua::Variable& cell : inner()) {
      items.push_back({cell, kRound * m_round + cell.index + 0.5});
    }
    return items;
  }

  /// The reference for all others.
  Result<void> proveSingle() {
    const std::vector<opcua::Assignment> items = pattern();
    const Result<opcua::Event> written = bring(items, Grouping::Single);
    if (!written) {
      return base::fail(written.error());
    }
    for (const std::error_code& status : written->statuses) {
      if (status) {
        return base::fail(status,
                          "An R-parameter cannot be written. Check the access rights (MD51051).");
      }
    }
    const Result<std::string> problem = standsThere(items, Grouping::Single);
    if (!problem) {
      return base::fail(problem.error());
    }
    if (!problem->empty()) {
      return base::fail(LinkError::BadValue,
                        "An R-parameter does not have the value that was written: another client "
                        "writes the scratch cells. Choose other cells.");
    }
    return {};
  }

  /// An error only if nothing more can be tried.
  Result<void> prove(FormProof& proof) {
    const std::vector<opcua::Assignment> items = pattern();
    const Result<opcua::Event> written = bring(items, proof.form);
    proof.writes = false;
    if (!written) {
      if (isFinal(written.error(), proof.form)) {
        return base::fail(written.error());
      }
      proof.why = written.error().text();
    } else if (const auto refused = std::find_if(written->statuses.begin(), written->statuses.end(),
                                                 [](const auto& status) { return !!status; });
               refused != written->statuses.end()) {
      proof.why = "write refused: " + nameOf(*refused);
    } else {
      Result<std::string> problem = standsThere(items, Grouping::Single);
      if (!problem) {
        return base::fail(problem.error());
      }
      proof.writes = problem->empty();
      proof.why = std::move(*problem);
    }
    // Reading is tried on numbers that are certainly there.
    if (!proof.writes) {
      // Wherever the form wrote to: afterwards both sides of the array have their old values.
      if (Result<void> again = restore(); !again) {
        return again;
      }
      if (Result<void> again = proveSingle(); !again) {
        return again;
      }
      m_expected = last();
    } else {
      m_expected = items;
    }
    Result<std::string> problem = standsThere(m_expected, proof.form);
    if (!problem) {
      if (isFinal(problem.error(), proof.form)) {
        return base::fail(problem.error());
      }
      problem = problem.error().text();
    }
    proof.reads = problem->empty();
    if (proof.why.empty()) {
      proof.why = std::move(*problem);
    }
    return {};
  }

  /// The pattern of the previous round, written by single access.
  [[nodiscard]] std::vector<opcua::Assignment> last() {
    --m_round;
    return pattern();
  }

  static std::string nameOf(const std::error_code& status) {
    if (status == LinkError::VariableMissing) {
      return "no such variable";
    }
    return status == LinkError::NotWritable ? "not writable" : "rejected";
  }

  /// A late request may still be carried out at any time: these cells can no longer be relied on.
  /// What is tried after an array that was not answered shows whether the connection goes on.
  static bool isFinal(const base::Error& error, Grouping form) {
    return error.code == LinkError::ConnectionLost || error.code == LinkError::NotReachable ||
           (error.code == LinkError::DeadlineExceeded && !opcua::isArray(form));
  }

  /// Whether the numbers can be read in that form, and the cells on both sides are unchanged.
  /// @return the problem; empty if there is none
  Result<std::string> standsThere(const std::vector<opcua::Assignment>& items, Grouping form) {
    std::string problem;
    for (int attempt = 0; attempt < kReadBackTries; ++attempt) {
      // The guard cells are always read one by one.
      const bool isSingle = form == Grouping::Single;
      const std::span<const opcua::Variable> asked =
          isSingle ? std::span<const opcua::Variable>(m_cells) : inner();
      const Result<opcua::Event> answer = ask(asked, form);
      if (!answer) {
        return base::fail(answer.error());
      }
      const std::span<const opcua::Reading> readings(answer->readings);
      problem.clear();
      for (const opcua::Reading& reading : readings) {
        if (reading.status) {
          return "read refused: " + nameOf(reading.status);
        }
      }
      const std::span<const opcua::Reading> values =
          isSingle ? readings.subspan(1, items.size()) : readings;
      for (std::size_t i = 0; i < items.size(); ++i) {
        if (values[i].number != items[i].value && problem.empty()) {
          problem = fmt::format("R{} does not have the value written", items[i].variable.index);
        }
      }
      if (isSingle && problem.empty() &&
          (readings.front().number != m_before.front().value ||
           readings.back().number != m_before.back().value)) {
        problem = "a cell beside the array was changed";
      }
      if (problem.empty()) {
        break;
      }
    }
    return problem;
  }

  Result<void> restore() {
    const Result<opcua::Event> written = bring(m_before, Grouping::Single);
    if (!written) {
      return base::fail(written.error());
    }
    for (const std::error_code& status : written->statuses) {
      if (status) {
        return base::fail(status, "An R-parameter cannot be written any more.");
      }
    }
    return {};
  }

  opcua::Link& m_link;
  Duration m_deadline;
  std::vector<opcua::Variable> m_cells;
  std::vector<opcua::Assignment> m_before;
  std::vector<opcua::Assignment> m_expected;
  int m_round = 0;
};

}  // namespace

Grouping AccessForms::best() const {
  const auto found =
      std::find_if(proofs.begin(), proofs.end(), [](const FormProof& p) { return p.works(); });
  return found == proofs.end() ? Grouping::Single : found->form;
}

std::optional<Grouping> AccessForms::array() const {
  const Grouping form = best();
  return opcua::isArray(form) ? std::optional(form) : std::nullopt;
}

Result<AccessForms> probeAccess(opcua::Link& link, const ScratchCells& cells, Duration deadline) {
  if (cells.first < 0 || cells.last - cells.first + 1 < ScratchCells::kCountMin) {
    return base::fail(LinkError::VariableMissing,
                      fmt::format("Name at least {} R-parameters in a row that nobody uses.",
                                  ScratchCells::kCountMin));
  }
  return Probe(link, cells, deadline).run();
}

}  // namespace rivulet::streaming
