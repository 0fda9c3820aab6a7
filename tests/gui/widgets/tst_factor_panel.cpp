// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Adaptive feed as it is agreed before a run, and what is said of its source during one.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "gui/widgets/page_test.h"
#include "support/test_program.h"
#include "widgets/common/note_text.h"
#include "widgets/common/status_label.h"
#include "widgets/common/theme.h"
#include "widgets/streaming/factor_panel.h"

using namespace rivulet;
using namespace rivulet::widgets;
using namespace std::chrono_literals;

Q_DECLARE_METATYPE(rivulet::widgets::FactorChoice)

namespace {

const FactorChoice kChoice{{"udp:5005", 2500ms, false}, 0.3, 1.1};

template <class Widget>
Widget* part(const FactorPanel& panel, const char* id) {
  return panel.findChild<Widget*>(QString::fromLatin1(id));
}

QString statusOf(const FactorPanel& panel) {
  return part<StatusLabel>(panel, "factor-status")->text().replace(QChar::Nbsp, QLatin1Char(' '));
}

streaming::FeedSeen seen(const live::FactorSeen& source) {
  streaming::FeedSeen feed;
  feed.source = source;
  return feed;
}

}  // namespace

class TestFactorPanel : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    test::failOnWarnings();
    applyTheme(Theme::Light);
  }

  void isAgreedByHand() {
    FactorPanel panel;
    QSignalSpy changed(&panel, &FactorPanel::choiceChanged);
    panel.setChoice({});
    QVERIFY(changed.isEmpty());
    QVERIFY(part<QSpinBox>(panel, "factor-port")->isHidden());
    part<QComboBox>(panel, "factor-source")->setCurrentIndex(1);
    QCOMPARE(changed.size(), 1);
    const auto chosen = changed.takeLast().front().value<FactorChoice>();
    QCOMPARE(chosen.source.address, std::string("tcp:4002"));
    QCOMPARE(chosen.least, live::FactorAgreement{}.least);
    QCOMPARE(chosen.most, live::FactorAgreement{}.most);
    QVERIFY(chosen.source.holdsInSilence);
    QVERIFY(!part<QSpinBox>(panel, "factor-port")->isHidden());
    part<QDoubleSpinBox>(panel, "factor-least")->setValue(50.0);
    QCOMPARE(changed.takeLast().front().value<FactorChoice>().least, 0.5);
    part<QComboBox>(panel, "factor-without")->setCurrentIndex(1);
    QVERIFY(!changed.takeLast().front().value<FactorChoice>().source.holdsInSilence);
    // Without a source nothing of it is agreed; the fields keep what was typed.
    part<QComboBox>(panel, "factor-source")->setCurrentIndex(0);
    QCOMPARE(changed.takeLast().front().value<FactorChoice>(), FactorChoice{});
    part<QComboBox>(panel, "factor-source")->setCurrentIndex(2);
    const auto again = changed.takeLast().front().value<FactorChoice>();
    QCOMPARE(again.source.address, std::string("udp:4002"));
    QCOMPARE(again.least, 0.5);
  }

  void showsWhatWasAgreed() {
    FactorPanel panel;
    QSignalSpy changed(&panel, &FactorPanel::choiceChanged);
    panel.setChoice(kChoice);
    QVERIFY(changed.isEmpty());
    QCOMPARE(part<QComboBox>(panel, "factor-source")->currentIndex(), 2);
    QCOMPARE(part<QSpinBox>(panel, "factor-port")->value(), 5005);
    QCOMPARE(part<QDoubleSpinBox>(panel, "factor-least")->value(), 30.0);
    QCOMPARE(part<QDoubleSpinBox>(panel, "factor-most")->value(), 110.0);
    QCOMPARE(part<QDoubleSpinBox>(panel, "factor-silence")->value(), 2.5);
    QCOMPARE(part<QComboBox>(panel, "factor-without")->currentIndex(), 1);
    // Of a run that was started on the command line.
    FactorChoice other = kChoice;
    other.source.address = "unix:/run/user/sensor";
    panel.setChoice(other);
    QCOMPARE(part<QComboBox>(panel, "factor-source")->currentText(),
             QStringLiteral("unix:/run/user/sensor"));
    QVERIFY(part<QSpinBox>(panel, "factor-port")->isHidden());
    part<QDoubleSpinBox>(panel, "factor-least")->setValue(40.0);
    QCOMPARE(changed.takeLast().front().value<FactorChoice>().source.address, other.source.address);
    panel.setEditable(false);
    QVERIFY(!part<QComboBox>(panel, "factor-source")->isEnabled());
  }

  void saysWhatBecomesOfIt_data() {
    QTest::addColumn<int>("state");
    QTest::addColumn<double>("factor");
    QTest::addColumn<double>("refused");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, live::FactorState state, double factor, double refused,
                        const char* says) {
      QTest::newRow(name) << static_cast<int>(state) << factor << refused
                          << QString::fromLatin1(says);
    };
    using live::FactorState;
    row("follows", FactorState::Follows, 0.85, 0.0, "85 % of your override, from udp:5005");
    row("waits", FactorState::Waiting, 0.0, 0.0,
        "the axes are held. udp:5005: no factor has come yet");
    row("silent", FactorState::Silent, 1.0, 0.0,
        "your override acts alone. udp:5005: no factor has come in time");
    row("refused", FactorState::Refused, 0.0, 250.0,
        "the axes are held. udp:5005: 25,000 % was not agreed");
    row("rubbish", FactorState::Refused, 1.0, 0.0,
        "your override acts alone. udp:5005: its last line is no factor");
    row("closed", FactorState::Closed, 0.0, 0.0, "the axes are held. udp:5005: it has closed");
    row("released", FactorState::Released, 1.0, 0.0, "without udp:5005, until its next factor");
  }

  void saysWhatBecomesOfIt() {
    QFETCH(int, state);
    QFETCH(double, factor);
    QFETCH(double, refused);
    QFETCH(QString, says);
    FactorPanel panel;
    panel.setChoice(kChoice);
    const QString before = statusOf(panel);
    live::FactorSeen source{
        static_cast<live::FactorState>(state), factor, {}, {}, "udp:5005", std::nullopt};
    source.why = source.state == live::FactorState::Follows ? "" : "Something.";
    if (refused > 0.0) {
      source.refused = refused;
    }
    panel.setFeed(seen(source));
    QVERIFY2(statusOf(panel).contains(says), qPrintable(statusOf(panel)));
    test::Language language;
    language.german();
    QVERIFY2(!statusOf(panel).contains(says), qPrintable(statusOf(panel)));
    language.english();
    panel.setFeed(std::nullopt);
    QCOMPARE(statusOf(panel), before);
  }

  /// What core writes of a source, in the list of messages.
  void itsSentencesAreTranslated() {
    test::Language language;
    for (const bool holds : {true, false}) {
      live::FeedFactor factor("udp:5005", {0.2, 1.2, 1s, holds});
      base::Instant now{1h};
      std::vector<std::string> sentences{"it is followed", factor.seen(now).why};
      const auto add = [&] { sentences.push_back(factor.seen(now).why); };
      factor.take(250.0, now);
      add();
      factor.take(1.0, now);
      now += 2s;
      add();
      factor.refuse("The line is no factor of the feed, as feed 0.85 would be", now);
      add();
      factor.close(now);
      add();
      factor.release(now);
      add();
      for (const std::string& sentence : sentences) {
        const QString note = QString::fromStdString("feed source: " + sentence);
        QVERIFY2(noteText(note).startsWith(QStringLiteral("Adaptive feed: ")), qPrintable(note));
        language.german();
        const QString german = noteText(note);
        language.english();
        QVERIFY2(german.startsWith(QStringLiteral("Adaptiver Vorschub: ")), qPrintable(german));
        QVERIFY2(
            !german.contains(QStringLiteral("held")) && !german.contains(QStringLiteral("alone")),
            qPrintable(german));
      }
    }
  }

  void everyTextFits() {
    test::Language language;
    FactorPanel panel;
    panel.setChoice(kChoice);
    for (const bool isGerman : {false, true}) {
      isGerman ? language.german() : language.english();
      test::keep(test::picture(panel, {340, 460}),
                 isGerman ? QStringLiteral("factor-de") : QStringLiteral("factor-en"));
      QCOMPARE(test::cutTexts(panel), QStringList());
    }
  }
};

RIVULET_TEST(TestFactorPanel)
#include "tst_factor_panel.moc"
