// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nets as text: what is understood, and the one sentence for what is not.

#include <QtTest>

#include "petri/net_file.h"
#include "support/test_program.h"

using namespace rivulet;

namespace {

/// A net of one page with these places and one transition "t".
std::string netText(const std::string& places, const std::string& transition) {
  return "name = \"n\"\ntime_unit = \"ms\"\ntop = \"Top\"\n[colours]\n"
         "PART = \"record number:INT name:STRING\"\nPARTS = \"list PART\"\n"
         "[pages.Top.places]\n" +
         places + "\n[pages.Top.transitions.t]\n" + transition;
}

}  // namespace

class TestPetriNet : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pagesBecomeOneNet() {
    const auto net = petri::loadNet("p3");
    QVERIFY2(net.has_value(), net ? "" : net.error().text().c_str());
    QVERIFY(net->placeOf("Top.SCHED.TaskQueue") < net->places.size());
    QVERIFY(net->transitionOf("Top.CNC.FineInterpolation.start") < net->transitions.size());
    QCOMPARE(net->transitions.size(), std::size_t(3 + 4 * 3 + 4 + 5));
    // A buffer is one place for its two tasks and for the scheduler.
    QVERIFY(net->placeOf("B3") < net->places.size());
    QCOMPARE(net->placeOf("Top.SCHED.B3"), net->places.size());
    QCOMPARE(net->places[net->placeOf("Top.SCHED.Idle")].initial.size(), std::size_t(6));
  }

  void parametersCanBeChanged() {
    const auto net = petri::loadNet("p3", {{"processors", 2}});
    QVERIFY(net.has_value());
    QCOMPARE(net->places[net->placeOf("Top.SCHED.Idle")].initial.size(), std::size_t(2));
    QCOMPARE(net->parameters.at("processors"), petri::Word(2));
  }

  void badInput_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("sentence");
    const auto add = [](const char* name, const std::string& text, petri::PetriError code,
                        const char* sentence) {
      QTest::newRow(name) << QString::fromStdString(text) << static_cast<int>(code)
                          << QString::fromUtf8(sentence);
    };
    using Error = petri::PetriError;
    add("not TOML", "name = ", Error::NotANet, "Line 1 is not TOML");
    add("unknown place", netText("a = { colour = \"INT\" }", "in = { b = \"n\" }"), Error::Unknown,
        "Top.t: place \"b\" is not known.");
    add("unknown colour set", netText("a = { colour = \"WORD\" }", "in = { a = \"n\" }"),
        Error::Unknown, "Top.a: colour set \"WORD\" is not known.");
    add("arc of another colour set",
        netText("a = { colour = \"INT\" }\nb = { colour = \"PART\" }",
                "in = { a = \"n\" }\nout = { b = \"n + 1\" }"),
        Error::WrongColour, "Top.t: \"n + 1\" is a value of INT, but place Top.b holds PART.");
    add("token of another colour set",
        netText("a = { colour = \"PARTS\", initial = \"5\" }", "in = { a = \"n\" }"),
        Error::WrongColour, "Top.a: \"5\" is a value of INT, but place Top.a holds PARTS.");
    add("field that does not exist",
        netText("a = { colour = \"PART\" }", "in = { a = \"p\" }\nguard = \"p.size > 1\""),
        Error::Unknown, "PART has no field \"size\"");
    add("record without a field",
        netText("a = { colour = \"PART\", initial = 'PART{number = 1}' }", "in = { a = \"p\" }"),
        Error::WrongColour, "field \"name\" of PART has no value");
    add("guard that is no condition",
        netText("a = { colour = \"INT\" }", "in = { a = \"n\" }\nguard = \"n + 1\""),
        Error::WrongColour, "Top.t: guard \"n + 1\" is not a condition.");
    add("variable that nothing binds",
        netText("a = { colour = \"INT\" }", "in = { a = \"n\" }\nout = { a = \"m\" }"),
        Error::Unknown, "\"m\" is not known");
    add("transition that fires for ever",
        netText("a = { colour = \"INT\" }", "out = { a = \"1\" }"), Error::NotANet,
        "without an input it could fire for ever");
    add("unclosed parenthesis",
        netText("a = { colour = \"INT\" }", "in = { a = \"n\" }\nout = { a = \"(n + 1\" }"),
        Error::NotANet, "\")\" is expected at the end");
    add("key without a meaning", netText("a = { color = \"INT\" }", "in = { a = \"n\" }"),
        Error::NotANet, "\"color\" has no meaning");
  }

  void badInput() {
    QFETCH(const QString, text);
    QFETCH(const int, code);
    QFETCH(const QString, sentence);
    const auto net = petri::parseNet(text.toStdString(), "test");
    QVERIFY(!net.has_value());
    const QString message = QString::fromStdString(net.error().message);
    QVERIFY2(message.contains(sentence), qPrintable(message));
    QCOMPARE(net.error().code, make_error_code(static_cast<petri::PetriError>(code)));
  }

  void unknownParameterAndNet() {
    const auto net = petri::loadNet("p3", {{"cores", 2}});
    QVERIFY(!net.has_value());
    QVERIFY(net.error().message.find("There is no parameter \"cores\"") == 0);
    const auto other = petri::loadNet("p4");
    QVERIFY(!other.has_value());
    QVERIFY(other.error().message.find("There is no net \"p4\"") == 0);
  }
};

RIVULET_TEST(TestPetriNet)
#include "tst_petri_net.moc"
