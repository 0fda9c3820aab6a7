// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/mtconnect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/median.h"
#include "trace/analysis/standstills.h"
#include "trace/control_trace.h"
#include "trace/import/import_error.h"
#include "trace/import/mtconnect_document.h"
#include "trace/import/xml_reader.h"

namespace rivulet::trace {

namespace {

using mtconnect::Category;
using mtconnect::Content;
using mtconnect::Item;
using mtconnect::Observed;

/// Values that are so many steps apart are not two samples of a motion.
constexpr int kStepsOfGap = 3;
/// A step that fewer values show is not known.
constexpr std::size_t kValuesOfStep = 8;
/// A word or a number of an event holds until just before the next one.
constexpr base::Duration kEventStep = std::chrono::microseconds{1};

/// Values in the order of their time, each time once: of several, the highest sequence number.
/// @return how many had the time of another one
std::size_t sortValues(std::vector<Observed>& values) {
  const auto place = [](const Observed& one) {
    return std::tuple(one.at, one.sequence, one.document);
  };
  std::stable_sort(values.begin(), values.end(),
                   [&place](const Observed& a, const Observed& b) { return place(a) < place(b); });
  std::size_t same = 0;
  std::vector<Observed> kept;
  kept.reserve(values.size());
  for (const Observed& value : values) {
    if (kept.empty() || kept.back().at != value.at) {
      kept.push_back(value);
      continue;
    }
    // Two documents may overlap: the same observation is in both, or its state.
    const bool isSame = kept.back().document != value.document;
    same += isSame ? 0 : 1;
    kept.back() = value;
  }
  values = std::move(kept);
  return same;
}

/// The first of several documents may say how all items stood (/current): what was set long before
/// the others begin still holds there, and the trace begins with them.
void beginWithState(Content& content) {
  std::uint64_t state = std::numeric_limits<std::uint64_t>::max();
  for (const Item& item : content.items) {
    for (const Observed& one : item.values) {
      state = std::min(state, one.document);
    }
  }
  std::optional<base::Instant> begin;
  for (const Item& item : content.items) {
    const auto inState =
        std::count_if(item.values.begin(), item.values.end(),
                      [state](const Observed& one) { return one.document == state; });
    if (inState > 1) {
      return;
    }
    for (const Observed& one : item.values) {
      if (one.document != state) {
        begin = std::min(begin.value_or(one.at), one.at);
      }
    }
  }
  if (!begin) {
    return;
  }
  for (Item& item : content.items) {
    for (Observed& one : item.values) {
      one.at = one.document == state ? std::max(one.at, *begin) : one.at;
    }
  }
  for (SignalEvent& note : content.notes) {
    note.from = note.to = std::max(note.from, *begin);
  }
  for (auto& [at, word] : content.executions) {
    at = std::max(at, *begin);
  }
}

bool hasValue(const Item& item) {
  return std::any_of(item.values.begin(), item.values.end(),
                     [](const Observed& one) { return std::isfinite(one.value); });
}

/// 0, 1, 2: X, Y, Z; nothing: another one, or a rotary axis.
std::optional<std::size_t> axisOf(const Item& item) {
  if (item.coordinate > 0) {
    return item.coordinate - 1;
  }
  if (item.componentType == "Rotary") {
    return std::nullopt;
  }
  const auto positionIn = [](std::string_view name) -> std::optional<std::size_t> {
    const auto role = guessRole(name);
    if (!role || !isPosition(*role)) {
      return std::nullopt;
    }
    const SignalRole ofX = *role <= SignalRole::ZSet ? SignalRole::XSet : SignalRole::XActual;
    return static_cast<std::size_t>(*role) - static_cast<std::size_t>(ofX);
  };
  if (const auto axis = positionIn(item.component)) {
    return axis;
  }
  if (const auto axis = positionIn(item.name)) {
    return axis;
  }
  // "Xabs", "Zcom"
  const std::size_t letter = item.name.empty() ? 3 : std::string_view("XYZ").find(item.name[0]);
  return letter < 3 ? std::optional(letter) : std::nullopt;
}

/// What the item is by the standard. An item without a subtype says what is.
std::optional<SignalRole> roleOf(const Item& item) {
  const bool isActual = item.subType.empty() || item.subType == "ACTUAL";
  const bool isProgrammed = item.subType == "PROGRAMMED";
  if (item.isStatistic) {
    return std::nullopt;
  }
  if (item.type == "Position" || item.type == "PathPosition" || item.type == "AxisFeedrate") {
    const auto axis = axisOf(item);
    const bool isSet = item.subType == "COMMANDED" && item.type != "AxisFeedrate";
    if (!axis || (!isActual && !isSet)) {
      return std::nullopt;
    }
    return roleForAxis(isSet                         ? SignalRole::XSet
                       : item.type == "AxisFeedrate" ? SignalRole::XSpeed
                                                     : SignalRole::XActual,
                       *axis);
  }
  if (item.type == "PathFeedrate") {
    return isActual                     ? std::optional(SignalRole::PathSpeed)
           : isProgrammed               ? std::optional(SignalRole::ProgrammedFeed)
           : item.subType == "OVERRIDE" ? std::optional(SignalRole::Override)
                                        : std::nullopt;
  }
  if (item.type == "PathFeedrateOverride") {
    return isProgrammed || item.subType.empty() ? std::optional(SignalRole::Override)
                                                : std::nullopt;
  }
  const bool isLine = item.type == "Line" || item.type == "LineNumber";
  const bool isOfProgram = item.subType.empty() || item.subType == "ABSOLUTE";
  return isLine && isOfProgram ? std::optional(SignalRole::Line) : std::nullopt;
}

/// An item that has a role, unless another one has it.
struct Candidate {
  std::size_t item = 0;
  SignalRole role = SignalRole::XActual;
  int source = 0;  ///< of positions: 0 in the program's coordinates, 1 of axes, 2 of the path
};

/// Positions that belong together have one source: that with the most axes, of equal ones the
/// first. @param ofX  XSet or XActual
int bestSource(const std::vector<Candidate>& candidates, SignalRole ofX) {
  std::array<std::set<SignalRole>, 3> axes;
  for (const Candidate& one : candidates) {
    if (one.role >= ofX && one.role <= roleForAxis(ofX, 2)) {
      axes[static_cast<std::size_t>(one.source)].insert(one.role);
    }
  }
  const auto most = std::max_element(
      axes.begin(), axes.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return static_cast<int>(most - axes.begin());
}

/// @param without  gets the names of those that could have the role of another one
std::vector<std::optional<SignalRole>> chooseRoles(const Content& content,
                                                   std::vector<std::string>& without) {
  const std::vector<Item>& items = content.items;
  std::vector<Candidate> candidates;
  const Item* first = nullptr;  // of a position, or else of anything
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (const auto role = roleOf(items[i])) {
      const bool isBetter = isPosition(*role) && (first == nullptr || !isPosition(*roleOf(*first)));
      first = first == nullptr || isBetter ? &items[i] : first;
      const auto described = content.described.find(items[i].id);
      const bool isOfWorkpiece =
          described != content.described.end() && described->second.isOfWorkpiece;
      candidates.push_back({i, *role, isOfWorkpiece ? 0 : items[i].coordinate == 0 ? 1 : 2});
    }
  }
  // Two machines are not one motion.
  std::erase_if(candidates, [&](const Candidate& one) {
    const bool isOther = items[one.item].device != first->device;
    if (isOther) {
      without.push_back(items[one.item].name);
    }
    return isOther;
  });
  const int setSource = bestSource(candidates, SignalRole::XSet);
  const int actualSource = bestSource(candidates, SignalRole::XActual);
  std::vector<std::optional<SignalRole>> roles(items.size());
  std::set<SignalRole> taken;
  for (const Candidate& one : candidates) {
    const int wanted = one.role <= SignalRole::ZSet ? setSource : actualSource;
    if ((isPosition(one.role) && one.source != wanted) || !taken.insert(one.role).second) {
      without.push_back(items[one.item].name);
    } else {
      roles[one.item] = one.role;
    }
  }
  return roles;
}

/// Names as the file or the description gives them; of several machines, with that of theirs.
void nameItems(Content& content) {
  std::set<std::string_view> devices;
  for (const Item& item : content.items) {
    devices.insert(item.device);
  }
  const bool areSeveral = devices.size() > 1;
  for (Item& item : content.items) {
    const auto described = content.described.find(item.id);
    if (item.name.empty() && described != content.described.end()) {
      item.name = described->second.name;
    }
    item.name = item.name.empty() ? item.id : item.name;
    if (item.coordinate > 0) {
      item.name += std::string(" ") + "XYZ"[item.coordinate - 1];
    }
    if (areSeveral) {
      item.name = item.device + "/" + item.name;
    }
  }
}

/// An execution state says why the axes stand.
void addStops(const Content& content, SignalTrace& trace) {
  static constexpr std::array<std::pair<std::string_view, StopCause>, 3> kStops{
      {{"FEED_HOLD", StopCause::Hold},
       {"PROGRAM_STOPPED", StopCause::ProgrammedStop},
       {"OPTIONAL_STOP", StopCause::ProgrammedStop}}};
  auto states = content.executions;
  std::stable_sort(states.begin(), states.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < states.size(); ++i) {
    for (const auto& [name, cause] : kStops) {
      if (states[i].second == name && trace.events.size() < 2 * mtconnect::kNotesMax) {
        trace.events.push_back(
            {states[i].first, i + 1 < states.size() ? states[i + 1].first : content.last,
             std::string(stopCauseName(cause)), fmt::format("the agent says {}", name)});
      }
    }
  }
}

void addRemarks(const mtconnect::Findings& found, SignalTrace& trace) {
  const auto add = [&trace](RemarkCode code, const mtconnect::LeftOut& out) {
    if (out.count > 0) {
      trace.remarks.push_back({code, {std::to_string(out.count), out.first}});
    }
  };
  const auto count = [&trace](RemarkCode code, std::size_t values) {
    if (values > 0) {
      trace.remarks.push_back({code, {std::to_string(values)}});
    }
  };
  add(RemarkCode::ItemTables, found.tables);
  add(RemarkCode::SeriesWithoutRate, found.withoutRate);
  add(RemarkCode::UnreadableObservations, found.unreadable);
  count(RemarkCode::NotesLeftOut, found.notes.count);
  count(RemarkCode::ValuesBackwards, found.backwards);
  if (found.missing > 0) {
    trace.remarks.push_back({RemarkCode::ObservationsMissing, {std::to_string(found.missing)}});
  }
  if (found.hasRestarted) {
    trace.remarks.push_back({RemarkCode::AgentRestarted});
  }
  if (!found.refusal.empty()) {
    trace.remarks.push_back({RemarkCode::AgentRefused, {found.refusal}});
  }
  if (found.wasCut) {
    trace.remarks.push_back({RemarkCode::CutFile});
  }
}

/// Nothing was read that could be drawn.
base::Error noValues(const Content& content) {
  return content.found.refusal.empty()
             ? base::makeError(ImportError::NotATable,
                               fmt::format("The {} document holds no values of a machine. Save "
                                           "what the agent answers to /sample or /current.",
                                           content.root))
             : base::makeError(ImportError::AgentRefused,
                               fmt::format("The MTConnect agent refused what it was asked: {}.",
                                           content.found.refusal));
}

/// @param role  that its type has; nothing: none, or another item has it
void addSignal(const Content& content, Item& item, std::optional<SignalRole> role,
               MtconnectTrace& read) {
  const auto described = content.described.find(item.id);
  const bool isDescribed = described != content.described.end() && !described->second.unit.empty();
  Signal signal{
      item.name,
      isDescribed ? described->second.unit : std::string(mtconnect::unitOfType(item.type)),
      read.trace.timeBases.size(),
      {}};
  TimeBase base{"time", {}};
  for (const Observed& one : item.values) {
    base.at.push_back(one.at);
    signal.values.push_back(one.value);
  }
  item.values = {};
  const bool hasUnit = !role || *role == SignalRole::Line || unitFactor(signal.unit, *role);
  if (!hasUnit) {
    read.trace.remarks.push_back({RemarkCode::ItemUnitUnknown, {signal.name, signal.unit}});
  }
  read.kinds.push_back({hasUnit ? role : std::nullopt, item.isSeries ? HeldUntil::NotHeld
                                                       : item.category == Category::Sample
                                                           ? HeldUntil::StepBefore
                                                           : HeldUntil::NextValue});
  read.trace.timeBases.push_back(std::move(base));
  read.trace.signalList.push_back(std::move(signal));
}

base::Result<MtconnectTrace> traceOf(Content content) {
  nameItems(content);
  beginWithState(content);
  mtconnect::LeftOut never;
  std::size_t sameTime = 0;
  for (Item& item : content.items) {
    sameTime += sortValues(item.values);
    if (!hasValue(item) && item.category == Category::Sample) {
      never.add(item.name);
    }
  }
  std::erase_if(content.items, [](const Item& item) { return !hasValue(item); });
  if (content.items.empty()) {
    return base::fail(noValues(content));
  }
  MtconnectTrace read;
  read.last = content.last;
  read.bytes = content.bytes;
  read.trace.format = "MTConnect";
  read.trace.events = std::move(content.notes);
  addStops(content, read.trace);
  std::stable_sort(read.trace.events.begin(), read.trace.events.end(),
                   [](const SignalEvent& a, const SignalEvent& b) { return a.from < b.from; });
  std::vector<std::string> without;
  const auto roles = chooseRoles(content, without);
  for (std::size_t i = 0; i < content.items.size(); ++i) {
    addSignal(content, content.items[i], roles[i], read);
  }
  addRemarks(content.found, read.trace);
  if (sameTime > 0) {
    read.trace.remarks.push_back({RemarkCode::ValuesAtOnce, {std::to_string(sameTime)}});
  }
  if (never.count > 0) {
    read.trace.remarks.push_back(
        {RemarkCode::ItemsUnavailable, {std::to_string(never.count), never.first}});
  }
  if (!without.empty()) {
    constexpr std::size_t kNamed = 6;
    const bool areMore = without.size() > kNamed;
    without.resize(std::min(without.size(), kNamed));
    read.trace.remarks.push_back(
        {RemarkCode::ItemsWithoutRole,
         {fmt::format("{}{}", fmt::join(without, ", "), areMore ? ", ..." : "")}});
  }
  return read;
}

/// The usual step between two values; nothing: too few to tell.
std::optional<base::Duration> stepOf(const PackedTimes& at) {
  std::vector<base::Duration> steps;
  for (std::size_t i = 1; i < at.size(); ++i) {
    steps.push_back(at[i] - at[i - 1]);
  }
  return at.size() < kValuesOfStep ? std::nullopt : std::optional(base::median(std::move(steps)));
}

/// Fills the gaps of one signal.
class GapFiller {
 public:
  GapFiller(TimeBase& base, Signal& signal) : m_base(&base), m_signal(&signal) {}

  /// @param step    that the value holds before the next one
  /// @param others  times at which it is wanted in its gaps, ascending
  void fill(base::Duration gapMin, base::Duration step, base::Instant last,
            const std::vector<base::Instant>& others) {
    const PackedTimes at = std::move(m_base->at);
    const PackedValues values = std::move(m_signal->values);
    m_base->at.clear();
    m_signal->values.clear();
    for (std::size_t i = 0; i < at.size(); ++i) {
      add(at[i], values[i]);
      const bool isLast = i + 1 == at.size();
      const base::Instant end = isLast ? last : at[i + 1] - step;
      if (!std::isfinite(values[i]) || end <= at[i] || (!isLast && at[i + 1] - at[i] <= gapMin)) {
        continue;
      }
      for (auto other = std::upper_bound(others.begin(), others.end(), at[i]);
           other != others.end() && *other < end; ++other) {
        add(*other, values[i]);
      }
      add(end, values[i]);
    }
  }

 private:
  void add(base::Instant at, double value) {
    m_base->at.push_back(at);
    m_signal->values.push_back(value);
  }

  TimeBase* m_base;
  Signal* m_signal;
};

}  // namespace

bool isMtconnect(std::string_view text) {
  const std::string_view root = xmlRoot(text);
  return root == "MTConnectStreams" || root == "MTConnectDevices" || root == "MTConnectError" ||
         root == "MTConnectAssets";
}

std::optional<std::uint64_t> mtconnectNumber(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isWhole = error == std::errc() && end == text.data() + text.size();
  return isWhole ? std::optional(number) : std::nullopt;
}

std::optional<MtconnectHeader> readMtconnectHeader(std::string_view text) {
  if (!isMtconnect(text)) {
    return std::nullopt;
  }
  MtconnectHeader header;
  XmlReader reader(text);
  while (const auto token = reader.next()) {
    if (token->kind == XmlKind::Start && token->name == "Header") {
      header = mtconnect::headerOf(*token);
      break;
    }
  }
  header.document = xmlRoot(text);
  return header;
}

base::Result<MtconnectTrace> readMtconnect(std::string_view text, const base::Budget& budget) {
  auto content = mtconnect::readDocuments(text, budget);
  if (!content) {
    return base::fail(content.error());
  }
  return traceOf(std::move(*content));
}

base::Result<void> addHeldValues(MtconnectTrace& read, const std::vector<bool>& isPosition,
                                 const base::Budget& budget) {
  std::vector<base::Instant> others;
  std::optional<base::Duration> motionStep;
  std::size_t positions = 0;
  for (std::size_t i = 0; i < read.kinds.size(); ++i) {
    const PackedTimes& at = read.trace.timeBases[read.trace.signalList[i].timeBase].at;
    if (isPosition[i]) {
      ++positions;
      others.insert(others.end(), at.begin(), at.end());
      const auto step = stepOf(at);
      motionStep = step && (!motionStep || *step < *motionStep) ? step : motionStep;
    }
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  const double added = static_cast<double>(positions) * static_cast<double>(others.size());
  if (auto fits = budget.without(read.bytes)
                      .require(added * (mtconnect::kObservedBytes + kAnalysedSampleBytes),
                               "The trace with its analysis");
      !fits) {
    return base::fail(fits.error());
  }
  bool isAny = false;
  for (std::size_t i = 0; i < read.kinds.size(); ++i) {
    Signal& signal = read.trace.signalList[i];
    TimeBase& base = read.trace.timeBases[signal.timeBase];
    const std::size_t before = base.at.size();
    const auto own = stepOf(base.at);
    const auto step = isPosition[i] && motionStep ? motionStep : own;
    if (read.kinds[i].held == HeldUntil::NextValue) {
      GapFiller(base, signal).fill(kEventStep, kEventStep, read.last, {});
    } else if (read.kinds[i].held == HeldUntil::StepBefore) {
      // Where the step is not known, only the last value is held.
      GapFiller(base, signal)
          .fill(step ? kStepsOfGap * *step : base::Duration::max(), step.value_or(base::Duration{}),
                read.last, isPosition[i] ? others : std::vector<base::Instant>());
    }
    isAny = isAny || base.at.size() > before;
  }
  if (isAny) {
    read.trace.remarks.push_back({RemarkCode::HeldValues});
  }
  return {};
}

}  // namespace rivulet::trace
