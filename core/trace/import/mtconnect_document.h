// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// What stands in the documents of an MTConnect agent, before it becomes a trace. @threadsafety
/// pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/budget.h"
#include "base/instant.h"
#include "base/result.h"
#include "trace/import/mtconnect.h"
#include "trace/import/xml_reader.h"
#include "trace/signals.h"

namespace rivulet::trace::mtconnect {

/// So many words of events and conditions are kept: each is compared with all others.
inline constexpr std::size_t kNotesMax = 2000;
/// What a value takes, as it is read and as a signal with its time, in lists that grow, bytes.
inline constexpr std::size_t kObservedBytes = 2 * (32 + sizeof(double) + sizeof(base::Instant));

enum class Category : std::uint8_t { None, Sample, Event, Condition };

/// What the description of the machine says of an item.
struct Described {
  std::string name;
  std::string unit;            ///< as we write it, or else as it stands
  std::string sampleRate;      ///< Hz, as it stands
  bool isOfWorkpiece = false;  ///< its coordinates are those of the program
};

struct Observed {
  base::Instant at{};
  std::uint64_t document = 0;  ///< several may follow each other
  std::uint64_t sequence = 0;
  double value = kNoValue;
};

/// An item of a device with its observations.
struct Item {
  std::string device;
  std::string componentType;
  std::string component;
  std::string id;
  std::string name;
  std::string type;  ///< "Position": without what says how its values are written
  std::string subType;
  Category category = Category::None;
  std::size_t coordinate = 0;  ///< of a place in space: 1, 2, 3; 0: it is one number
  bool isSeries = false;
  bool isStatistic = false;
  std::optional<base::Instant> seriesEnd{};
  std::vector<Observed> values{};
};

/// How often something was left out, and where first.
struct LeftOut {
  std::size_t count = 0;
  std::string first;

  void add(std::string_view what) {
    first = count == 0 ? std::string(what) : first;
    ++count;
  }
};

/// What was not kept.
struct Findings {
  LeftOut tables;
  LeftOut withoutRate;
  LeftOut unreadable;
  LeftOut notes;
  std::size_t backwards = 0;  ///< values of series
  std::string refusal;        ///< of an MTConnectError; empty: there is none
  std::uint64_t missing = 0;  ///< observations between two documents
  bool hasRestarted = false;  ///< the agent, between two documents
  bool wasCut = false;
};

/// Of several documents: all that was read.
struct Content {
  std::string root;  ///< of the last document
  std::vector<Item> items;
  std::map<std::string, Described, std::less<>> described;  ///< by the id of the item
  std::vector<SignalEvent> notes;                           ///< words, as they come
  std::vector<std::pair<base::Instant, std::string>> executions;
  base::Instant last{};   ///< of all observations
  std::size_t bytes = 0;  ///< what the trace of them takes, with its analysis
  Findings found;
};

/// @param budget  without the text
/// @return error BudgetError::Exceeded
[[nodiscard]] base::Result<Content> readDocuments(std::string_view text,
                                                  const base::Budget& budget);

/// @param tag  "Header"
[[nodiscard]] MtconnectHeader headerOf(const XmlToken& tag);

/// The unit that the standard prescribes for a type, such as mm of "Position"; empty: not known.
[[nodiscard]] std::string_view unitOfType(std::string_view type);

}  // namespace rivulet::trace::mtconnect
