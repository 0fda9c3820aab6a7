// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Adaptive feed: a sensor or script sends a factor of the operator's override, as `feed 0.85`.
/// What it may be, and what holds without it, is agreed before the run. A value that is no number
/// or was not agreed, a line that is no factor, silence and a source that has closed all act alike:
/// as agreed for silence, until the next value.
/// @threadsafety one object, on the thread of the run.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/instant.h"
#include "base/result.h"
#include "live/line_reader.h"
#include "live/source.h"

namespace rivulet::live {

struct FactorAgreement {
  double least = 0.2;                                ///< > 0, at most 1
  double most = 1.2;                                 ///< at least 1
  base::Duration silence = std::chrono::seconds{1};  ///< without a factor, > 0
  /// Without one the axes are held; else they go on with the operator's override alone.
  bool holdsInSilence = true;

  friend bool operator==(const FactorAgreement&, const FactorAgreement&) = default;
};

/// Where factors come from, and what is agreed with that source beside the bounds, which are those
/// of the program on the control.
struct FactorSource {
  std::string address;  ///< see `sources::openSource`; empty: there is none
  base::Duration silence = FactorAgreement{}.silence;
  bool holdsInSilence = FactorAgreement{}.holdsInSilence;

  friend bool operator==(const FactorSource&, const FactorSource&) = default;
};

/// @return NotAgreed: a time that nobody can keep. The bounds are those of the program on the
/// control, which looks at them.
[[nodiscard]] base::Result<void> requireSound(const FactorAgreement& agreement);

/// "factor 0.2 to 1.2; without one for 1 s the axes are held".
[[nodiscard]] std::string textOf(const FactorAgreement& agreement);

enum class FactorState : unsigned char {
  Waiting,  ///< no factor has come yet
  Follows,
  Silent,    ///< for longer than agreed
  Refused,   ///< the last line was no factor that was agreed
  Closed,    ///< nothing can come any more
  Released,  ///< the operator goes on without it, until its next factor
};

/// What acts now.
struct FactorSeen {
  FactorState state = FactorState::Waiting;
  double factor = 1.0;            ///< of the operator's override; 0: the axes are held
  base::Instant since{};          ///< this value was read, or what acts in its place began to
  std::string why;                ///< one sentence about what is not `Follows`; English
  std::string source;             ///< its name
  std::optional<double> refused;  ///< a factor that was not agreed; nothing: no factor was sent

  [[nodiscard]] bool holds() const { return factor == 0.0; }
  /// The same can be said of both, whatever the factors are.
  [[nodiscard]] bool isSaidLike(const FactorSeen& other) const {
    return state == other.state && why == other.why;
  }
  friend bool operator==(const FactorSeen&, const FactorSeen&) = default;
};

/// What has come of a source of factors.
struct FactorCount {
  std::string source;
  std::size_t values = 0;    ///< as agreed
  std::size_t refused = 0;   ///< lines that were not
  std::size_t silences = 0;  ///< after which none acted
};

class FeedFactor {
 public:
  /// @param source  its name
  FeedFactor(std::string source, const FactorAgreement& agreement);

  void take(double factor, base::Instant now);
  /// A line that is no factor. @param why  a sentence
  void refuse(std::string why, base::Instant now);
  void close(base::Instant now);
  /// The operator goes on although the source holds: without it, until it sends its next factor.
  void release(base::Instant now);

  /// @param now  not before any earlier one
  [[nodiscard]] const FactorSeen& seen(base::Instant now);
  [[nodiscard]] const FactorCount& count() const { return m_count; }

 private:
  /// The agreement for silence acts.
  void fallBack(FactorState state, std::string why, base::Instant now);

  FactorAgreement m_agreement;
  FactorCount m_count;
  FactorSeen m_seen;
  base::Instant m_heardAt{};
};

/// Reads a source that sends factors and nothing else, beside a program or beside points.
class FactorReader {
 public:
  /// @param source, factor  outlive this object
  FactorReader(Source& source, FeedFactor& factor) : m_source(source), m_factor(factor) {}

  /// Reads what has come; never waits. What was there before the first call is old, and is passed
  /// over.
  void turn(base::Instant now);

 private:
  void takeLine(std::string_view text, base::Instant now);

  Source& m_source;
  FeedFactor& m_factor;
  LineReader m_reader;
  bool m_hasBegun = false;
  bool m_isOver = false;
};

}  // namespace rivulet::live
