// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/import/mtconnect_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "trace/control_trace.h"
#include "trace/import/clock_text.h"
#include "trace/import/xml_reader.h"

namespace rivulet::trace::mtconnect {

namespace {

constexpr std::string_view kUnavailable = "UNAVAILABLE";
constexpr std::size_t kItemBytes = 2000;  // beside its values: names, role, remarks
constexpr std::size_t kNoteCharactersMax = 200;

struct Named {
  std::string_view name;
  std::string_view unit;
};

/// The units that the standard prescribes, by the type of the item: an answer of an agent does not
/// repeat them.
constexpr std::array<Named, 32> kUnitsOfTypes{{{"Acceleration", "mm/s^2"},
                                               {"AccumulatedTime", "s"},
                                               {"Amperage", "A"},
                                               {"AmperageAC", "A"},
                                               {"AmperageDC", "A"},
                                               {"Angle", "deg"},
                                               {"AngularAcceleration", "deg/s^2"},
                                               {"AngularVelocity", "deg/s"},
                                               {"AxisFeedrate", "mm/s"},
                                               {"AxisFeedrateOverride", "%"},
                                               {"CuttingSpeed", "mm/s"},
                                               {"Displacement", "mm"},
                                               {"EquipmentTimer", "s"},
                                               {"Frequency", "Hz"},
                                               {"Length", "mm"},
                                               {"LinearForce", "N"},
                                               {"Load", "%"},
                                               {"PathFeedrate", "mm/s"},
                                               {"PathFeedrateOverride", "%"},
                                               {"PathPosition", "mm"},
                                               {"Position", "mm"},
                                               {"Pressure", "Pa"},
                                               {"ProcessTimer", "s"},
                                               {"RotaryVelocity", "rpm"},
                                               {"RotaryVelocityOverride", "%"},
                                               {"SpindleSpeed", "rpm"},
                                               {"Temperature", "°C"},
                                               {"Torque", "Nm"},
                                               {"Velocity", "mm/s"},
                                               {"Voltage", "V"},
                                               {"VoltageDC", "V"},
                                               {"Wattage", "W"}}};

/// How the standard writes units, and how we do.
constexpr std::array<Named, 16> kUnitNames{{{"MILLIMETER", "mm"},
                                            {"MILLIMETER_3D", "mm"},
                                            {"MILLIMETER/SECOND", "mm/s"},
                                            {"MILLIMETER/SECOND^2", "mm/s^2"},
                                            {"INCH", "in"},
                                            {"DEGREE", "deg"},
                                            {"DEGREE_3D", "deg"},
                                            {"DEGREE/SECOND", "deg/s"},
                                            {"REVOLUTION/MINUTE", "rpm"},
                                            {"PERCENT", "%"},
                                            {"AMPERE", "A"},
                                            {"VOLT", "V"},
                                            {"WATT", "W"},
                                            {"SECOND", "s"},
                                            {"NEWTON_METER", "Nm"},
                                            {"CELSIUS", "°C"}}};

template <std::size_t N>
std::string_view unitIn(const std::array<Named, N>& units, std::string_view name) {
  const auto found = std::find_if(units.begin(), units.end(),
                                  [name](const Named& unit) { return unit.name == name; });
  return found == units.end() ? std::string_view() : found->unit;
}

/// Seconds of a date of any length, to the nanosecond. Without an offset it is UTC.
std::optional<base::Instant> instantOf(std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  std::size_t end = std::min(point + 1, text.size());
  while (end < text.size() && base::isDigit(text[end])) {
    ++end;
  }
  const auto whole = parseClock(std::string(text.substr(0, point)) + std::string(text.substr(end)),
                                DateOrder::DayFirst);
  if (!whole || whole->kind != ClockKind::Timestamp || std::abs(whole->seconds) > kSecondsMax) {
    return std::nullopt;
  }
  std::int64_t nanoseconds = 0;
  for (std::size_t i = 1; i <= 9; ++i) {
    nanoseconds = 10 * nanoseconds + (point + i < end ? text[point + i] - '0' : 0);
  }
  return base::Instant{base::fromSeconds(whole->seconds) + base::Duration{nanoseconds}};
}

std::optional<double> finiteNumber(std::string_view text) {
  const auto number = base::parseNumber(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Words from outside, in one line that is not too long.
std::string plainText(std::string_view text) {
  std::string plain;
  for (const char c : base::trim(text).substr(0, kNoteCharactersMax)) {
    plain += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return plain;
}

bool takeSuffix(std::string_view& name, std::string_view suffix) {
  const bool has = name.size() > suffix.size() && name.ends_with(suffix);
  name.remove_suffix(has ? suffix.size() : 0);
  return has;
}

/// What the start tag of an observation says.
struct Opened {
  std::string_view name;  ///< of the element
  std::string device;
  std::string id;
  std::string itemName;
  std::string timestamp;
  std::string subType;
  std::string sequence;
  std::string sampleRate;
  std::string duration;
  std::string conditionType;
  std::string nativeCode;
  bool isStatistic = false;
};

/// Reads documents one after another.
class DocumentReader {
 public:
  DocumentReader(std::string_view text, const base::Budget& budget)
      : m_reader(text), m_budget(budget) {}

  /// Once. @return error BudgetError::Exceeded
  [[nodiscard]] base::Result<Content> read();

 private:
  void start(const XmlToken& tag);
  void startContainer(const XmlToken& tag);
  void describe(const XmlToken& tag);
  void open(const XmlToken& tag);
  void end(const XmlToken& tag);
  void take();
  void takeNumbers(Item& item, base::Instant at, const std::string& text);
  void takeSeries(Item& item, base::Instant at, const std::string& text);
  void takeWords(base::Instant at, const std::string& words);
  /// @param coordinate  as in `Item`
  Item& itemOf(std::string_view type, std::size_t coordinate);
  void add(Item& item, base::Instant at, double value);

  XmlReader m_reader;
  const base::Budget& m_budget;
  std::string_view m_root;
  bool m_isClosed = true;  ///< the last document has ended
  std::uint64_t m_documents = 0;
  std::optional<MtconnectHeader> m_header;  ///< of the last document with observations
  Category m_category = Category::None;
  std::string m_device;
  std::string m_componentType;
  std::string m_component;
  std::optional<Opened> m_opened;
  bool m_hasChildren = false;
  std::size_t m_depth = 0;  ///< of elements in the observation
  std::string m_text;       ///< of the observation
  std::map<std::string, std::size_t, std::less<>> m_itemOf;
  Content m_content;
};

base::Result<Content> DocumentReader::read() {
  while (const auto token = m_reader.next()) {
    if (m_content.bytes > m_budget.left()) {
      return base::fail(m_budget.exceeded("The trace with its analysis"));
    }
    if (token->kind == XmlKind::Start) {
      start(*token);
    } else if (token->kind == XmlKind::End) {
      end(*token);
    } else if (m_opened) {
      m_text += token->isLiteral ? std::string(token->raw) : xmlText(token->raw);
    }
  }
  m_content.root = m_root;
  m_content.found.wasCut = m_reader.wasCut() || !m_isClosed;
  return std::move(m_content);
}

void DocumentReader::start(const XmlToken& tag) {
  if (m_opened) {
    m_hasChildren = true;
    m_depth += tag.isEmpty ? 0 : 1;
  } else if (m_category != Category::None ||
             (m_root == "MTConnectError" && !xmlAttribute(tag, "errorCode").empty())) {
    open(tag);
  } else if (tag.name == "DataItem") {
    describe(tag);
  } else {
    startContainer(tag);
  }
}

void DocumentReader::startContainer(const XmlToken& tag) {
  if (tag.name.starts_with("MTConnect")) {
    m_root = tag.name;
    m_isClosed = tag.isEmpty;
    ++m_documents;
  } else if (tag.name == "Header" && m_root == "MTConnectStreams") {
    const MtconnectHeader header = headerOf(tag);
    const bool isKnown = m_header && m_header->instanceId == header.instanceId;
    m_content.found.hasRestarted = m_content.found.hasRestarted || (m_header && !isKnown);
    if (isKnown && m_header->nextSequence > 0 && header.firstSequence > m_header->nextSequence) {
      m_content.found.missing += header.firstSequence - m_header->nextSequence;
    }
    m_header = header;
  } else if (tag.name == "DeviceStream") {
    m_device = xmlAttribute(tag, "name");
    m_device = m_device.empty() ? xmlAttribute(tag, "uuid") : m_device;
  } else if (tag.name == "ComponentStream") {
    m_componentType = xmlAttribute(tag, "component");
    m_component = xmlAttribute(tag, "name");
    m_component = m_component.empty() ? xmlAttribute(tag, "nativeName") : m_component;
    m_component = m_component.empty() ? xmlAttribute(tag, "componentId") : m_component;
  } else if (m_root == "MTConnectStreams" && !tag.isEmpty) {
    m_category = tag.name == "Samples"     ? Category::Sample
                 : tag.name == "Events"    ? Category::Event
                 : tag.name == "Condition" ? Category::Condition
                                           : Category::None;
  }
}

void DocumentReader::describe(const XmlToken& tag) {
  const std::string units = xmlAttribute(tag, "units");
  const std::string_view known = unitIn(kUnitNames, units);
  m_content.bytes += kItemBytes + 4 * tag.raw.size();
  m_content.described[xmlAttribute(tag, "id")] = {
      xmlAttribute(tag, "name"), known.empty() ? units : std::string(known),
      xmlAttribute(tag, "sampleRate"), xmlAttribute(tag, "coordinateSystem") == "WORK"};
}

void DocumentReader::open(const XmlToken& tag) {
  Opened opened;
  opened.name = tag.name;
  opened.device = m_device;
  std::string_view raw = tag.raw;
  while (const auto attribute = takeXmlAttribute(raw)) {
    const std::array<std::pair<std::string_view, std::string*>, 9> known{
        {{"dataItemId", &opened.id},
         {"name", &opened.itemName},
         {"timestamp", &opened.timestamp},
         {"subType", &opened.subType},
         {"sequence", &opened.sequence},
         {"sampleRate", &opened.sampleRate},
         {"duration", &opened.duration},
         {"type", &opened.conditionType},
         {m_root == "MTConnectError" ? "errorCode" : "nativeCode", &opened.nativeCode}}};
    for (const auto& [name, value] : known) {
      if (attribute->name == name) {
        *value = xmlText(attribute->value);
      }
    }
    opened.isStatistic = opened.isStatistic || attribute->name == "statistic";
  }
  m_opened = std::move(opened);
  m_text.clear();
  m_depth = 0;
  m_hasChildren = false;
  if (tag.isEmpty) {
    take();
  }
}

void DocumentReader::end(const XmlToken& tag) {
  if (m_opened && m_depth > 0) {
    --m_depth;
  } else if (m_opened) {
    take();
  } else if (tag.name == "Samples" || tag.name == "Events" || tag.name == "Condition") {
    m_category = Category::None;
  } else if (tag.name == m_root) {
    m_isClosed = true;
  }
}

/// The observation has ended.
void DocumentReader::take() {
  const Opened& opened = *m_opened;
  const std::string text(base::trim(m_text));
  if (m_root == "MTConnectError") {
    if (m_content.found.refusal.empty()) {
      m_content.found.refusal =
          text.empty() ? opened.nativeCode : plainText(text) + " (" + opened.nativeCode + ")";
    }
    m_opened.reset();
    return;
  }
  const auto at = instantOf(opened.timestamp);
  std::string_view type = opened.name;
  const std::string_view called = opened.itemName.empty() ? opened.id : opened.itemName;
  if (!at || opened.id.empty()) {
    m_content.found.unreadable.add(called.empty() ? type : called);
  } else if (m_category == Category::Condition) {
    m_content.last = std::max(m_content.last, *at);
    if (opened.name != "Normal" && opened.name != "Unavailable") {
      takeWords(*at, fmt::format("{} {} {}: {}", opened.name, opened.conditionType,
                                 opened.nativeCode, text));
    }
  } else if (m_hasChildren || takeSuffix(type, "DataSet") || takeSuffix(type, "Table")) {
    m_content.found.tables.add(called);
  } else {
    m_content.last = std::max(m_content.last, *at);
    const bool isSeries = takeSuffix(type, "TimeSeries");
    takeSuffix(type, "Discrete");
    const bool isPlace = type == "PathPosition" || type == "Orientation";
    if (isPlace && !isSeries) {
      takeNumbers(itemOf(type, 1), *at, text);
    } else if (Item& item = itemOf(type, 0); isSeries) {
      takeSeries(item, *at, text);
    } else {
      takeNumbers(item, *at, text);
    }
  }
  m_opened.reset();
}

Item& DocumentReader::itemOf(std::string_view type, std::size_t coordinate) {
  const Opened& opened = *m_opened;
  const std::string key = fmt::format("{}\n{}\n{}", m_device, opened.id, coordinate);
  const auto [found, isNew] = m_itemOf.try_emplace(key, m_content.items.size());
  if (isNew) {
    m_content.bytes += kItemBytes + 4 * (key.size() + m_component.size() + opened.itemName.size());
    Item item;
    item.device = m_device;
    item.componentType = m_componentType;
    item.component = m_component;
    item.id = opened.id;
    item.name = opened.itemName;
    item.type = type;
    item.subType = opened.subType;
    item.category = m_category;
    item.coordinate = coordinate;
    item.isStatistic = opened.isStatistic;
    m_content.items.push_back(std::move(item));
  }
  return m_content.items[found->second];
}

void DocumentReader::add(Item& item, base::Instant at, double value) {
  m_content.bytes += kObservedBytes + kAnalysedSampleBytes;
  item.values.push_back({at, m_documents, mtconnectNumber(m_opened->sequence).value_or(0), value});
}

/// Numbers of one item, three of a place; words of an event.
void DocumentReader::takeNumbers(Item& first, base::Instant at, const std::string& text) {
  if (first.coordinate == 0) {
    const auto number = finiteNumber(text);
    if (number || text == kUnavailable) {
      add(first, at, number.value_or(kNoValue));
    } else if (first.category == Category::Event) {
      takeWords(at, fmt::format("{}: {}", first.type, text));
      if (first.type == "Execution") {
        m_content.executions.emplace_back(at, text);
      }
    } else {
      m_content.found.unreadable.add(first.name.empty() ? first.id : first.name);
    }
    return;
  }
  std::array<double, 3> place{kNoValue, kNoValue, kNoValue};
  std::string_view rest = text;
  bool isWhole = true;
  for (double& value : place) {
    rest = base::trim(rest);
    const std::size_t length = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    const auto number = finiteNumber(rest.substr(0, length));
    isWhole = isWhole && number;
    value = number.value_or(kNoValue);
    rest.remove_prefix(length);
  }
  if (text != kUnavailable && (!isWhole || !base::trim(rest).empty())) {
    m_content.found.unreadable.add(first.name.empty() ? first.id : first.name);
    return;
  }
  const std::string type = first.type;
  for (std::size_t i = 0; i < place.size(); ++i) {
    add(itemOf(type, i + 1), at, place[i]);
  }
}

/// Values at equal steps, the last one at the time of the observation.
void DocumentReader::takeSeries(Item& item, base::Instant at, const std::string& text) {
  item.isSeries = true;
  if (text == kUnavailable) {
    add(item, at, kNoValue);
    return;
  }
  std::vector<double> values;
  std::string_view rest = base::trim(text);
  bool isWhole = true;
  while (!rest.empty()) {
    const std::size_t length = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    const auto number = finiteNumber(rest.substr(0, length));
    isWhole = isWhole && number;
    values.push_back(number.value_or(kNoValue));
    rest = base::trim(rest.substr(length));
  }
  const std::string called = item.name.empty() ? item.id : item.name;
  if (values.empty() || !isWhole) {
    m_content.found.unreadable.add(called);
    return;
  }
  const auto described = m_content.described.find(item.id);
  const auto rateHz =
      finiteNumber(!m_opened->sampleRate.empty() || described == m_content.described.end()
                       ? m_opened->sampleRate
                       : described->second.sampleRate);
  const auto duration = finiteNumber(m_opened->duration);
  const auto steps = static_cast<double>(values.size() - 1);
  const double stepS = rateHz && *rateHz > 0.0       ? 1.0 / *rateHz
                       : duration && *duration > 0.0 ? *duration / std::max(steps, 1.0)
                                                     : 0.0;
  if (values.size() > 1 && (stepS <= 0.0 || stepS * steps > kSecondsMax)) {
    m_content.found.withoutRate.add(called);
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double before = stepS * static_cast<double>(values.size() - 1 - i);
    const base::Instant here{at - base::fromSeconds(before)};
    // The clocks of machine and agent differ a little: a series begins before the last one ends.
    if (item.seriesEnd && here <= *item.seriesEnd) {
      ++m_content.found.backwards;
    } else {
      add(item, here, values[i]);
    }
  }
  item.seriesEnd = std::max(item.seriesEnd.value_or(at), at);
}

void DocumentReader::takeWords(base::Instant at, const std::string& words) {
  if (m_content.notes.size() >= kNotesMax) {
    m_content.found.notes.add(words);
    return;
  }
  m_content.notes.push_back({at, at, "note", plainText(words)});
}

}  // namespace

base::Result<Content> readDocuments(std::string_view text, const base::Budget& budget) {
  DocumentReader reader(text, budget);
  return reader.read();
}

MtconnectHeader headerOf(const XmlToken& tag) {
  const auto number = [&tag](std::string_view name) {
    return mtconnectNumber(xmlAttribute(tag, name)).value_or(0);
  };
  return {{},
          number("instanceId"),
          number("bufferSize"),
          number("firstSequence"),
          number("lastSequence"),
          number("nextSequence")};
}

std::string_view unitOfType(std::string_view type) {
  return unitIn(kUnitsOfTypes, type);
}

}  // namespace rivulet::trace::mtconnect
