// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <QtTest>

#include "base/utc.h"
#include "imported_text.h"
#include "support/test_program.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/import/compression.h"
#include "trace/import/import.h"
#include "trace/import/import_error.h"
#include "trace/import/xml_reader.h"
#include "trace/motion.h"
#include "trace/signal_set.h"
#include "trace/trace.h"

using namespace rivulet;
using namespace rivulet::trace;
using std::chrono::milliseconds;
using tests::imported;
using tests::remarks;
using tests::roles;

namespace {

/// 2026-01-02T03:04:05Z, to which the tests add.
const base::Instant kStart{std::chrono::milliseconds{*base::utcOfText("2026-01-02T03:04:05Z")}};

std::string timeText(int ms) {
  const auto at = std::chrono::duration_cast<milliseconds>(kStart.time_since_epoch()).count() + ms;
  return base::utcText(at);
}

/// Writes the document of an agent, observation after observation.
class Answer {
 public:
  /// @param component  such as "Linear X"
  Answer& component(std::string_view component, std::string_view category = "Samples",
                    std::string_view device = "mill") {
    close();
    const std::size_t blank = component.find(' ');
    m_text += fmt::format(
        "<DeviceStream name=\"{}\" uuid=\"u-{}\"><ComponentStream component=\"{}\" name=\"{}\" "
        "componentId=\"c{}\"><{}>\n",
        device, device, component.substr(0, blank), component.substr(blank + 1), ++m_components,
        category);
    m_end = fmt::format("</{}></ComponentStream></DeviceStream>\n", category);
    return *this;
  }
  /// @param attributes  besides those that all observations have
  Answer& value(std::string_view type, std::string_view id, int ms, std::string_view text,
                std::string_view attributes = {}) {
    m_text += fmt::format("<{} dataItemId=\"{}\" timestamp=\"{}\" sequence=\"{}\" {}>{}</{}>\n",
                          type, id, timeText(ms), ++m_sequence, attributes, text, type);
    return *this;
  }
  [[nodiscard]] std::string text(std::string_view version = "1.7") {
    close();
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<MTConnectStreams "
        "xmlns=\"urn:mtconnect.org:MTConnectStreams:{0}\" "
        "xsi:schemaLocation=\"urn:mtconnect.org:MTConnectStreams:{0} x.xsd\">\n"
        "<Header instanceId=\"1\" sender=\"agent\" bufferSize=\"131072\" firstSequence=\"1\" "
        "lastSequence=\"{1}\" nextSequence=\"{2}\"/>\n<Streams>{3}</Streams></MTConnectStreams>\n",
        version, m_sequence, m_sequence + 1, m_text);
  }

 private:
  void close() {
    m_text += m_end;
    m_end.clear();
  }

  std::string m_text;
  std::string m_end;
  int m_sequence = 0;
  int m_components = 0;
};

bool says(const ImportedTrace& trace, std::string_view words) {
  const bool does = remarks(trace).find(words) != std::string::npos;
  if (!does) {
    qWarning("said instead: %s", remarks(trace).c_str());
  }
  return does;
}

/// "5:1.5 7:- 9:2", ms from the start and values.
std::string valuesOf(const ImportedTrace& trace, std::string_view name) {
  std::string text;
  for (const Signal& signal : trace.trace.signalList) {
    for (std::size_t i = 0; signal.name == name && i < signal.values.size(); ++i) {
      const double ms = base::toMilliseconds(trace.trace.timeBases[signal.timeBase].at[i] - kStart);
      text +=
          fmt::format("{}{:g}:{}", text.empty() ? "" : " ", ms,
                      std::isnan(signal.values[i]) ? "-" : fmt::format("{:g}", signal.values[i]));
    }
  }
  return text;
}

std::string errorOf(std::string_view text, const base::Budget& budget = {}) {
  const auto result = importTrace(text, {}, budget);
  return result ? "" : result.error().message;
}

/// X at 100 Hz over 10 mm, then Y over 10 mm, then both stand for a second, then X again.
std::string corner() {
  Answer answer;
  answer.component("Linear X");
  for (int i = 0; i <= 50; ++i) {
    answer.value("Position", "x", 10 * i, fmt::format("{:g}", 0.2 * i), "subType=\"ACTUAL\"");
  }
  for (int i = 1; i <= 50; ++i) {
    answer.value("Position", "x", 2000 + 10 * i, fmt::format("{:g}", 10 + 0.2 * i),
                 "subType=\"ACTUAL\"");
  }
  answer.component("Linear Y");
  answer.value("Position", "y", 0, "0", "subType=\"ACTUAL\"");
  for (int i = 1; i <= 50; ++i) {
    answer.value("Position", "y", 500 + 10 * i, fmt::format("{:g}", 0.2 * i), "subType=\"ACTUAL\"");
  }
  return answer.text();
}

}  // namespace

class TestMtconnect : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readsXml();
  void readsXmlThatWasCut();
  void readsAnyVersionAndPrefix_data();
  void readsAnyVersionAndPrefix();
  void readsTimesToTheNanosecond_data();
  void readsTimesToTheNanosecond();
  void leavesAGapWhereAnItemIsUnavailable();
  void holdsWhatTheAgentDoesNotRepeat();
  void ordersValuesByTimeAndSequence();
  void spreadsSeries();
  void splitsPlaces();
  void knowsRolesByTheStandard();
  void choosesOneSourceOfPositions();
  void readsTheDescription();
  void obeysTheMapping();
  void carriesStatesAndConditions();
  void saysFromWhenPositionsAreKnown();
  void namesWhatItLeavesOut();
  void readsSeveralDocuments();
  void beginsWithTheStateOfAllItems();
  void refusesOtherDocuments_data();
  void refusesOtherDocuments();
  void isBounded();
};

/// A reader that ends a tag at any ">", or takes what is in comments for elements, finds others.
void TestMtconnect::readsXml() {
  XmlReader reader(
      "<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b \"<c/>\">]><!-- <d/> -->"
      "<p:a x=\"1>2\" y = '&quot;&#xB5;&#109;&b;&amp;' z=\"\"><b/>t&lt;<![CDATA[<&lt;]]></p:a>");
  auto token = reader.next();
  QVERIFY(token && token->kind == XmlKind::Start && token->name == "a" && !token->isEmpty);
  QCOMPARE(xmlAttribute(*token, "x"), std::string("1>2"));
  QCOMPARE(xmlAttribute(*token, "y"), std::string("\"\u00b5m&b;&"));
  QCOMPARE(xmlAttribute(*token, "z"), std::string());
  QCOMPARE(xmlAttribute(*token, "w"), std::string());
  token = reader.next();
  QVERIFY(token && token->name == "b" && token->isEmpty);
  token = reader.next();
  QVERIFY(token && token->kind == XmlKind::Text && !token->isLiteral);
  QCOMPARE(xmlText(token->raw), std::string("t<"));
  token = reader.next();
  QVERIFY(token && token->isLiteral && token->raw == "<&lt;");
  token = reader.next();
  QVERIFY(token && token->kind == XmlKind::End && token->name == "a");
  QVERIFY(!reader.next() && !reader.wasCut());
  QCOMPARE(xmlText("&#0;&#xD800;&#x110000;&;&amp"), std::string("&#0;&#xD800;&#x110000;&;&amp"));
}

void TestMtconnect::readsXmlThatWasCut() {
  for (const char* text : {"<a", "<a b=\"", "<!-- x", "<![CDATA[ x", "<?x", "<!DOCTYPE a [ <"}) {
    XmlReader reader(text);
    QVERIFY2(!reader.next() && reader.wasCut(), text);
  }
}

void TestMtconnect::readsAnyVersionAndPrefix_data() {
  QTest::addColumn<QByteArray>("text");
  const std::string plain = corner();
  const auto row = [](const char* name, const std::string& text) {
    QTest::newRow(name) << QByteArray::fromStdString(text);
  };
  const auto replaced = [&plain](const char* from, const char* to) {
    return QString::fromStdString(plain).replace(from, to).toStdString();
  };
  row("1.7", plain);
  row("1.0", replaced(":1.7", ":1.0"));
  row("2.5", replaced(":1.7", ":2.5"));
  row("prefix", QString::fromStdString(plain)
                    .replace(QRegularExpression("<(/?)([A-Z])"), "<\\1m:\\2")
                    .replace("xmlns=", "xmlns:m=")
                    .toStdString());
  row("extension of a type", replaced("<Position", "<x:Position"));
  row("byte order mark", "\xEF\xBB\xBF" + plain);
  row("comment before", "<!-- " + std::string(5000, 'x') + " -->" + plain);
  row("compressed", pack(plain, 3));
  row("blanks around values", replaced("</Position", " \n </Position"));
}

/// A reader that looks for "<Position" or for one namespace finds nothing in some of these.
void TestMtconnect::readsAnyVersionAndPrefix() {
  QFETCH(QByteArray, text);
  if (QTest::currentDataTag() == std::string("extension of a type")) {
    text.replace("</Position", "</x:Position");
  }
  const ImportedTrace trace = imported(text.toStdString());
  QCOMPARE(trace.trace.format, std::string("MTConnect"));
  QCOMPARE(roles(trace), std::string("x_act=x:mm,y_act=y:mm"));
  QVERIFY(valuesOf(trace, "x").starts_with("0:0 10:0.2 20:0.4"));
  QVERIFY(trace.table.columns.empty());  // the window asks nobody what they mean
}

void TestMtconnect::readsTimesToTheNanosecond_data() {
  QTest::addColumn<QByteArray>("time");
  QTest::addColumn<qlonglong>("ns");
  const auto row = [](const char* time, qlonglong ns) {
    QTest::newRow(time) << QByteArray(time) << ns;
  };
  row("2026-01-02T03:04:05Z", 0);
  row("2026-01-02T03:04:05.1Z", 100'000'000);
  row("2026-01-02T03:04:05.1234567Z", 123'456'700);
  row("2026-01-02T03:04:05.000000001Z", 1);
  row("2026-01-02T03:04:05.123456789012345Z", 123'456'789);
  row("2026-01-02T03:04:05.5", 500'000'000);  // UTC
  row("2026-01-02T05:04:05.25+02:00", 250'000'000);
}

/// A reader of milliseconds, or of seconds as a double since 1970, is off by up to 240 ns.
void TestMtconnect::readsTimesToTheNanosecond() {
  QFETCH(QByteArray, time);
  QFETCH(qlonglong, ns);
  std::string text = Answer().component("Linear X").value("Position", "x", 0, "1").text();
  const std::string known = timeText(0);
  text.replace(text.find(known), known.size(), time.toStdString());
  const ImportedTrace trace = imported(text);
  QCOMPARE(trace.trace.timeBases.size(), std::size_t{1});
  QCOMPARE((trace.trace.timeBases[0].at[0] - kStart).count(), ns);
}

/// A reader that takes UNAVAILABLE for 0, or leaves it out, has a position there.
void TestMtconnect::leavesAGapWhereAnItemIsUnavailable() {
  Answer answer;
  answer.component("Linear X");
  for (int i = 0; i < 10; ++i) {
    answer.value("Position", "x", 10 * i, fmt::format("{}", 5 + i));
  }
  answer.value("Position", "x", 100, "UNAVAILABLE");
  for (int i = 0; i < 10; ++i) {
    answer.value("Position", "x", 200 + 10 * i, fmt::format("{}", 50 + i));
  }
  const ImportedTrace trace = imported(answer.text());
  QVERIFY(valuesOf(trace, "x").find("90:14 100:- 200:50") != std::string::npos);
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{20});
  for (const MotionSample& sample : motion.samples) {
    QVERIFY(sample.actualMm.x >= 5.0);
  }
}

/// Straight lines between what an agent reports would show a slow motion where the axes stand, and
/// times of X alone nothing of what Y does meanwhile.
void TestMtconnect::holdsWhatTheAgentDoesNotRepeat() {
  const ImportedTrace trace = imported(corner());
  QVERIFY(says(trace, "reports a value when it changes"));
  const TraceAnalysis analysis = analyseTrace(Trace(trace), {});
  QCOMPARE(analysis.stops.size(), std::size_t{1});
  const Standstill& stop = analysis.stops[0];
  QVERIFY(base::distance(stop.placeMm, {10.0, 10.0, 0.0}) < 1e-6);
  QVERIFY(std::abs(base::toSeconds(stop.duration) - 1.0) < 0.03);
  // The corner belongs to the path: nothing goes straight from (0, 0) to (10, 10).
  for (const MotionSample& sample : analysis.motion.samples) {
    QVERIFY(sample.actualMm.y < 1e-6 || sample.actualMm.x > 10.0 - 1e-6);
  }
}

/// A reader that keeps the order of the file runs backwards; one that keeps the first of equal
/// times has 2 at 20 ms.
void TestMtconnect::ordersValuesByTimeAndSequence() {
  Answer answer;
  answer.component("Linear X")
      .value("Position", "x", 30, "4")
      .value("Position", "x", 10, "1")
      .value("Position", "x", 20, "2")
      .value("Position", "x", 20, "3");
  std::string text = answer.text();
  QCOMPARE(valuesOf(imported(text), "x"), std::string("10:1 20:3 30:4"));
  QVERIFY(says(imported(text), "which counts instead: 1."));
  // The sequence numbers count, not the place in the file: here 2 is later than 3.
  text = QString::fromStdString(text).replace("sequence=\"3\"", "sequence=\"9\"").toStdString();
  QCOMPARE(valuesOf(imported(text), "x"), std::string("10:1 20:2 30:4"));
}

/// The time of a series is that of its last value: who takes it for that of the first one is late
/// by the whole series.
void TestMtconnect::spreadsSeries() {
  const char* const kSeries = "PositionTimeSeries";
  Answer answer;
  answer.component("Linear X")
      .value(kSeries, "x", 30, "1 2\n3  4", "sampleCount=\"4\" sampleRate=\"100\"")
      .value(kSeries, "x", 70, "5 6 7 8", "sampleCount=\"4\" sampleRate=\"100\"")
      .value(kSeries, "x", 100, "8.5 9 10 11", "sampleCount=\"4\" sampleRate=\"100\"")
      .value(kSeries, "x", 200, "UNAVAILABLE", "sampleCount=\"0\"")
      .value("AngleTimeSeries", "a", 20, "1 2 3", "sampleCount=\"3\" duration=\"0.02\"")
      .value("LoadTimeSeries", "l", 20, "1 2 3", "sampleCount=\"3\"")
      .value("LoadTimeSeries", "m", 20, "1 two 3", "sampleCount=\"3\" sampleRate=\"1\"");
  const ImportedTrace trace = imported(answer.text());
  QCOMPARE(valuesOf(trace, "x"),
           std::string("0:1 10:2 20:3 30:4 40:5 50:6 60:7 70:8 80:9 90:10 100:11 200:-"));
  QCOMPARE(valuesOf(trace, "a"), std::string("0:1 10:2 20:3"));
  QCOMPARE(roles(trace), std::string("x_act=x:mm"));
  QVERIFY(says(trace, "without a sample rate"));
  QVERIFY(says(trace, "not known: 1, the first of \"l\""));
  QVERIFY(says(trace, "read and that were left out: 1, the first of \"m\""));
  QVERIFY(says(trace, "runs backwards and that were left out: 1."));
}

void TestMtconnect::splitsPlaces() {
  Answer answer;
  answer.component("Path p1")
      .value("PathPosition", "p", 0, "1 2 3", "name=\"Ppos\" subType=\"ACTUAL\"")
      .value("PathPosition", "p", 10, "1.5 2.5 3.5", "subType=\"ACTUAL\"")
      .value("PathPosition", "p", 20, "1 2", "subType=\"ACTUAL\"")
      .value("PathPosition", "p", 30, "1 2 3 4", "subType=\"ACTUAL\"")
      .value("PathPosition", "p", 40, "UNAVAILABLE", "subType=\"ACTUAL\"")
      .value("PathPosition", "s", 0, "7 8 9", "subType=\"COMMANDED\"")
      .value("Orientation", "o", 0, "10 20 30");
  const ImportedTrace trace = imported(answer.text());
  QCOMPARE(valuesOf(trace, "Ppos Z"), std::string("0:3 10:3.5 40:-"));
  QCOMPARE(valuesOf(trace, "o Y"), std::string("0:20 40:20"));  // to the end
  QCOMPARE(roles(trace),
           std::string("x_set=s X:mm,y_set=s Y:mm,z_set=s Z:mm,x_act=Ppos X:mm,y_act=Ppos Y:mm,"
                       "z_act=Ppos Z:mm"));
  QVERIFY(says(trace, "left out: 2, the first of \"Ppos\""));
}

/// Who guesses from names alone takes "Bangle" or a load for a position, and mm/s for mm/min.
void TestMtconnect::knowsRolesByTheStandard() {
  Answer answer;
  answer.component("Linear X")
      .value("Load", "l", 0, "7", "name=\"x_act\"")
      .value("Position", "1", 0, "1", "name=\"a\" subType=\"ACTUAL\"")
      .value("Position", "2", 0, "2", "name=\"b\" subType=\"COMMANDED\"")
      .value("Position", "3", 0, "3", "name=\"c\" subType=\"TARGET\"")
      .value("Position", "4", 0, "4", "name=\"d\" statistic=\"MAXIMUM\" duration=\"60\"")
      .value("AxisFeedrate", "5", 0, "5", "name=\"e\"");
  answer.component("Linear LIN2").value("Position", "6", 0, "6", "name=\"Ypos\"");
  answer.component("Linear LIN3").value("Position", "7", 0, "7", "name=\"Zabs\"");
  answer.component("Rotary X").value("Position", "8", 0, "8", "name=\"f\"");
  answer.component("Rotary B").value("Angle", "9", 0, "9", "name=\"Bangle\"");
  answer.component("Path p")
      .value("PathFeedrate", "10", 0, "60", "name=\"g\" subType=\"ACTUAL\"")
      .value("PathFeedrate", "11", 0, "90", "name=\"h\" subType=\"PROGRAMMED\"");
  answer.component("Path p", "Events")
      .value("Line", "12", 0, "17")
      .value("PathFeedrateOverride", "13", 0, "50", "subType=\"PROGRAMMED\"");
  const ImportedTrace trace = imported(answer.text());
  QCOMPARE(roles(trace),
           std::string("x_set=b:mm,x_act=a:mm,y_act=Ypos:mm,z_act=Zabs:mm,x_speed=e:mm/s,"
                       "path_speed=g:mm/s,programmed_feed=h:mm/s,line=12,override=13:%"));
  const Motion motion = motionOf(trace);
  QCOMPARE(motion.samples.size(), std::size_t{1});
  QCOMPARE(motion.samples[0].pathMmPerS, 60.0);
  QCOMPARE(motion.samples[0].feedMmPerS, 90.0);
  QCOMPARE(motion.samples[0].overrideFactor, 0.5);
  QCOMPARE(motion.samples[0].line, std::uint32_t{17});
}

/// X of the axis with Y and Z of the path would be a motion that no machine made.
void TestMtconnect::choosesOneSourceOfPositions() {
  Answer answer;
  answer.component("Linear X").value("Position", "x", 0, "1");
  answer.component("Path p").value("PathPosition", "p", 0, "4 5 6");
  const ImportedTrace trace = imported(answer.text());
  QCOMPARE(roles(trace), std::string("x_act=p X:mm,y_act=p Y:mm,z_act=p Z:mm"));
  QVERIFY(says(trace, "which is analysed instead: x."));
  Answer two;
  two.component("Linear X", "Samples", "left").value("Position", "x", 0, "1");
  two.component("Linear Y", "Samples", "right").value("Position", "y", 0, "1");
  two.component("Linear X", "Samples", "right").value("Position", "x", 0, "2");
  QCOMPARE(roles(imported(two.text())), std::string("x_act=left/x:mm"));
  QVERIFY(says(imported(two.text()), "instead: right/y, right/x."));
}

/// The units and names of the description count, and positions in the program's coordinates come
/// before those of the machine.
void TestMtconnect::readsTheDescription() {
  const std::string described =
      "<MTConnectDevices "
      "xmlns=\"urn:mtconnect.org:MTConnectDevices:1.7\"><Devices><Device><DataItems>"
      "<DataItem id=\"m\" category=\"SAMPLE\" type=\"POSITION\" units=\"MILLIMETER\" "
      "coordinateSystem=\"MACHINE\" name=\"Xmachine\"/>"
      "<DataItem id=\"w\" category=\"SAMPLE\" type=\"POSITION\" units=\"INCH\" "
      "coordinateSystem=\"WORK\" name=\"Xwork\"/>"
      "<DataItem id=\"y\" category=\"SAMPLE\" type=\"POSITION\" units=\"FURLONG\" "
      "coordinateSystem=\"WORK\" name=\"Ywork\"/>"
      "<DataItem id=\"s\" category=\"SAMPLE\" type=\"TORQUE\" units=\"NEWTON_METER\" "
      "sampleRate=\"100\"/></DataItems></Device></Devices></MTConnectDevices>\n";
  Answer answer;
  answer.component("Linear X").value("Position", "m", 0, "101").value("Position", "w", 0, "1");
  answer.component("Linear Y").value("Position", "y", 0, "7");
  answer.component("Linear Z").value("TorqueTimeSeries", "s", 10, "5 6");
  const ImportedTrace trace = imported(described + answer.text());
  QCOMPARE(roles(trace), std::string("x_act=Xwork:in"));  // what a furlong is, nobody has said
  QCOMPARE(motionOf(trace).samples[0].actualMm.x, 25.4);
  QCOMPARE(valuesOf(trace, "s"), std::string("0:5 10:6"));
  QVERIFY(says(trace, "instead: Xmachine."));
  QVERIFY(says(trace, "The unit \"FURLONG\" of the item \"Ywork\" is not known"));
}

void TestMtconnect::obeysTheMapping() {
  Answer answer;
  answer.component("Linear X").value("Position", "x", 0, "1").value("Position", "other", 0, "2");
  const ImportedTrace trace = imported(answer.text(), *parseTableMapping("x_act=other"));
  QCOMPARE(roles(trace), std::string("x_act=other:mm"));
  QCOMPARE(roles(imported(answer.text(), *parseTableMapping("guess=no"))), std::string());
  const auto missing = importTrace(answer.text(), *parseTableMapping("x_act=z"));
  QVERIFY(!missing && missing.error().code == ImportError::BadMapping);
}

/// The states of the machine say why it stands.
void TestMtconnect::carriesStatesAndConditions() {
  std::string text = corner();
  const std::string more =
      Answer()
          .component("Controller c", "Events")
          .value("Execution", "e", 0, "ACTIVE")
          .value("Execution", "e", 1100, "FEED_HOLD")
          .value("Execution", "e", 1900, "ACTIVE")
          .value("ControllerMode", "mode", 0, "AUTOMATIC")
          .component("Controller c", "Condition")
          .value("Normal", "k", 0, "", "type=\"SYSTEM\"")
          .value("Fault", "k", 1100, "door &amp; lock\nopen", "type=\"SYSTEM\" nativeCode=\"700\"")
          .text();
  const ImportedTrace trace = imported(text + more);
  const TraceAnalysis analysis = analyseTrace(Trace(trace), {});
  QCOMPARE(analysis.stops.size(), std::size_t{1});
  QVERIFY(analysis.stops[0].cause == StopCause::Hold);
  QCOMPARE(analysis.stops[0].evidence, std::string("the agent says FEED_HOLD"));
  std::string notes;
  for (const SignalEvent& event : trace.trace.events) {
    notes += event.kind == "note" ? event.text + "; " : "";
  }
  QCOMPARE(notes, std::string("Execution: ACTIVE; ControllerMode: AUTOMATIC; Execution: FEED_HOLD; "
                              "Fault SYSTEM 700: door & lock open; Execution: ACTIVE; "));
  // All notes of a moment are kept, also beside each other.
  const ShownTrace shown = makeShownTrace(Trace(trace), analysis);
  QCOMPARE(std::count_if(shown.events.begin(), shown.events.end(),
                         [](const SignalEvent& event) { return event.kind == "note"; }),
           5);
}

/// Before its first value nothing is known of an axis: to hold that one backwards would draw a
/// path that was not moved.
void TestMtconnect::saysFromWhenPositionsAreKnown() {
  Answer answer;
  answer.component("Linear X");
  for (int i = 0; i < 20; ++i) {
    answer.value("Position", "x", 10 * i, fmt::format("{}", i));
  }
  answer.component("Linear Y").value("Position", "y", 100, "3");
  const ImportedTrace trace = imported(answer.text());
  QVERIFY(says(trace, "known from 0.100 s on"));
  QCOMPARE(motionOf(trace).samples.front().at, kStart + milliseconds(100));
  QCOMPARE(motionOf(trace).samples.back().at, kStart + milliseconds(190));
}

void TestMtconnect::namesWhatItLeavesOut() {
  Answer answer;
  answer.component("Linear X")
      .value("Position", "x", 0, "1")
      .value("Position", "x", 10, "far")
      .value("Load", "never", 0, "UNAVAILABLE");
  answer.component("Controller c", "Events")
      .value("VariableDataSet", "v", 0, "<Entry key=\"R1\">5</Entry>", "count=\"1\"");
  std::string text = answer.text();
  ImportedTrace trace = imported(text);
  QCOMPARE(trace.trace.signalList.size(), std::size_t{1});
  QVERIFY(says(trace, "left out: 1, the first of \"x\""));
  QVERIFY(says(trace, "without any value that were left out: 1, the first \"never\""));
  QVERIFY(says(trace, "sets of values and were left out: 1, the first of \"v\""));
  text.resize(text.find("</Streams>"));
  QVERIFY(says(imported(text), "The file was cut off"));
  Answer many;
  many.component("Linear X").value("Position", "x", 0, "1").component("Controller c", "Events");
  for (int i = 0; i < 2500; ++i) {
    many.value("Block", "b", i, fmt::format("G1 X{}", i));
  }
  trace = imported(many.text());
  QCOMPARE(trace.trace.events.size(), std::size_t{2000});
  QVERIFY(says(trace, "too many and were left out: 500."));
}

/// Pages of an agent that overlap are one trace.
void TestMtconnect::readsSeveralDocuments() {
  const auto page = [](int from, int count) {
    Answer answer;
    answer.component("Linear X");
    for (int i = from; i < from + count; ++i) {
      answer.value("Position", "x", 10 * i, fmt::format("{}", i));
    }
    return answer.text();
  };
  const ImportedTrace trace = imported(page(0, 3) + page(3, 3));
  QCOMPARE(valuesOf(trace, "x"), std::string("0:0 10:1 20:2 30:3 40:4 50:5"));
  const std::string text = page(0, 3);
  QCOMPARE(valuesOf(imported(text + text), "x"), std::string("0:0 10:1 20:2"));
  QCOMPARE(remarks(imported(text + text)), std::string());
}

/// An answer to /current has the time at which each value was set, which may be long ago: the state
/// is that of the moment at which the others begin. Alone, it is one place.
void TestMtconnect::beginsWithTheStateOfAllItems() {
  Answer state;
  state.component("Linear X").value("Position", "x", -5'000'000, "1");
  state.component("Linear Y").value("Position", "y", -3'000'000, "2");
  state.component("Controller c", "Events").value("Execution", "e", -4'000'000, "READY");
  const ImportedTrace alone = imported(state.text());
  const Motion standing = motionOf(alone);
  QVERIFY(!standing.samples.empty());
  QVERIFY(base::distance(standing.samples.back().actualMm, {1.0, 2.0, 0.0}) < 1e-9);
  Answer answer;
  answer.component("Linear X");
  for (int i = 1; i <= 20; ++i) {
    answer.value("Position", "x", 10 * i, fmt::format("{}", 1 + i));
  }
  const ImportedTrace trace = imported(state.text() + answer.text());
  QVERIFY(valuesOf(trace, "x").starts_with("10:2 20:3 30:4"));
  QVERIFY(valuesOf(trace, "y").starts_with("10:2 20:2"));
  QCOMPARE(motionOf(trace).samples.size(), std::size_t{20});
  QCOMPARE(trace.trace.events.at(0).from, kStart + milliseconds(10));
  QCOMPARE(remarks(trace).find("known from"), std::string::npos);
}

void TestMtconnect::refusesOtherDocuments_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("message");
  const auto row = [](const char* name, const char* text, const char* message) {
    QTest::newRow(name) << QByteArray(text) << QByteArray(message);
  };
  row("refusal",
      "<MTConnectError xmlns=\"urn:mtconnect.org:MTConnectError:1.3\"><Header/><Errors>"
      "<Error errorCode=\"OUT_OF_RANGE\">'from' must be\n &lt; 7</Error></Errors></MTConnectError>",
      "The MTConnect agent refused what it was asked: 'from' must be  < 7 (OUT_OF_RANGE).");
  row("refusal of 2.6",
      "<MTConnectError><Errors><OutOfRange errorCode=\"OUT_OF_RANGE\">"
      "<ErrorMessage>too early</ErrorMessage></OutOfRange></Errors></MTConnectError>",
      "The MTConnect agent refused what it was asked: too early (OUT_OF_RANGE).");
  row("refusal without words", "<MTConnectError><Error errorCode=\"NO_DEVICE\"/></MTConnectError>",
      "The MTConnect agent refused what it was asked: NO_DEVICE.");
  row("description", "<MTConnectDevices><Devices/></MTConnectDevices>",
      "The MTConnectDevices document holds no values of a machine. Save what the agent answers to "
      "/sample or /current.");
  row("nothing", "<MTConnectStreams><Header/><Streams/></MTConnectStreams>",
      "The MTConnectStreams document holds no values of a machine. Save what the agent answers to "
      "/sample or /current.");
}

void TestMtconnect::refusesOtherDocuments() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, message);
  QCOMPARE(errorOf(text.toStdString()), message.toStdString());
}

/// What a stranger sends takes no more time and memory than it is long.
void TestMtconnect::isBounded() {
  std::string bomb = "<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\">";
  for (char c = 'b'; c < 'k'; ++c) {
    const char before = static_cast<char>(c - 1);
    bomb += fmt::format("<!ENTITY {0} \"&{1};&{1};&{1};&{1};&{1};&{1};&{1};&{1};\">", c, before);
  }
  Answer answer;
  answer.component("Linear X").value("Position", "x", 0, "1").value("Position", "x", 10, "&j;");
  const std::string text = answer.text();
  const std::size_t root = text.find("<MTConnectStreams");
  QVERIFY(says(imported(bomb + "]>" + text.substr(root)), "left out: 1, the first of \"x\""));
  // Depth: no call per level.
  std::string deep = "<MTConnectStreams>";
  for (int i = 0; i < 500'000; ++i) {
    deep += "<a>";
  }
  QVERIFY(errorOf(deep).find("holds no values") != std::string::npos);
  // Memory: a few bytes per item and value are many in a trace.
  const std::string large = corner();
  QVERIFY(!errorOf(large, base::Budget(30'000)).empty());
  QVERIFY(!errorOf(large, base::Budget(100'000)).empty());  // what is added where axes stand
  QVERIFY(errorOf(large, base::Budget(100'000'000)).empty());
  // Cut anywhere, it is read up to there.
  for (std::size_t size = 0; size < text.size(); ++size) {
    const auto result = importTrace(text.substr(0, size));
    QVERIFY(result || !result.error().message.empty());
  }
}

RIVULET_TEST(TestMtconnect)
#include "tst_mtconnect.moc"
