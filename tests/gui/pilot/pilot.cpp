// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Presses the buttons of the released program from within, as its operator would: Qt loads this
/// plugin if the environment names it (QT_QPA_GENERIC_PLUGINS=rivulet-pilot). It reads commands
/// from standard input, one a line, and answers each with one line. A button is given by its object
/// name.
///
///   await BUTTON…  "BUTTON", the first of these that can be pressed
///   press BUTTON   "pressed", once it could be pressed
///   hold BUTTON    "held", once it could be pressed, and could not any more while it was held
///   try BUTTON     "pressed", or "grey" if it cannot be pressed now
///   type KEYS      "typed": a key with its modifiers, such as Alt+2
///   read WIDGET    what is written there
///
/// Beside that each new state of the run is a line: "state: Running". @threadsafety GUI thread.

#include <fcntl.h>
#include <unistd.h>

#include <QApplication>
#include <QGenericPlugin>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSocketNotifier>
#include <QTimer>
#include <QtTest>
#include <cstdio>

namespace {

constexpr int kStepMs = 20;

QWidget* find(const QByteArray& name) {
  for (const QWidget* window : QApplication::topLevelWidgets()) {
    if (auto* widget = window->findChild<QWidget*>(QString::fromUtf8(name))) {
      return widget;
    }
  }
  return nullptr;
}

/// No dialog keeps its mouse away, either.
bool canBePressed(const QWidget* button) {
  const QWidget* modal = QApplication::activeModalWidget();
  return button != nullptr && button->isVisible() && button->isEnabled() &&
         (modal == nullptr || modal->isAncestorOf(button));
}

void send(QWidget* button, QEvent::Type type) {
  const QPointF middle = button->rect().center();
  QMouseEvent event(type, middle, button->mapToGlobal(middle), Qt::LeftButton,
                    type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton,
                    Qt::NoModifier);
  QApplication::sendEvent(button, &event);
}

void say(const QByteArray& line) {
  std::printf("%s\n", line.constData());
  std::fflush(stdout);
}

QByteArray textOf(const QWidget* widget) {
  QStringList texts;
  for (const auto* label : widget->findChildren<QLabel*>()) {
    if (label->isVisible() && !label->text().isEmpty()) {
      texts << label->text();
    }
  }
  return texts.join(QLatin1Char(' ')).simplified().toUtf8();
}

class Pilot final : public QObject {
  Q_OBJECT

 public:
  Pilot() {
    ::fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
    auto* input = new QSocketNotifier(STDIN_FILENO, QSocketNotifier::Read, this);
    connect(input, &QSocketNotifier::activated, this, [this, input] {
      char bytes[256];
      const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof bytes);
      if (count <= 0) {
        input->setEnabled(false);
        return;
      }
      m_input.append(bytes, static_cast<qsizetype>(count));
    });
    connect(&m_timer, &QTimer::timeout, this, &Pilot::step);
    m_timer.start(kStepMs);
  }

 private:
  void step() {
    if (const QWidget* state = find("state");
        state != nullptr && state->accessibleName() != m_state) {
      m_state = state->accessibleName();
      say("state: " + m_state.toUtf8());
    }
    if (m_words.isEmpty() && m_input.contains('\n')) {
      m_words = m_input.left(m_input.indexOf('\n')).split(' ');
      m_input.remove(0, m_input.indexOf('\n') + 1);
    }
    if (!m_words.isEmpty() && isDone()) {
      m_words.clear();
    }
  }

  /// The command, as far as it can be done by now.
  bool isDone() {
    const QByteArray& verb = m_words[0];
    QWidget* first = find(m_words[1]);
    if (verb == "await") {
      for (const QByteArray& name : m_words.mid(1)) {
        if (canBePressed(find(name))) {
          say(name);
          return true;
        }
      }
      return false;
    }
    if (verb == "read") {
      say(first == nullptr ? QByteArray("nothing") : textOf(first));
      return true;
    }
    if (verb == "hold" && m_isHeld) {
      if (canBePressed(first)) {
        return false;
      }
      m_isHeld = false;
      send(first, QEvent::MouseButtonRelease);
      say("held");
      return true;
    }
    if (verb == "type") {
      QWidget* window = QApplication::activeWindow();
      if (window != nullptr) {
        QTest::keySequence(window, QKeySequence(QString::fromLatin1(m_words[1])));
      }
      say(window != nullptr ? "typed" : "no window");
      return true;
    }
    if (!canBePressed(first)) {
      if (verb == "try") {
        say("grey");
      }
      return verb == "try";
    }
    send(first, QEvent::MouseButtonPress);
    m_isHeld = verb == "hold";
    if (!m_isHeld) {
      send(first, QEvent::MouseButtonRelease);
      say("pressed");
    }
    return !m_isHeld;
  }

  QByteArray m_input;
  QList<QByteArray> m_words;  ///< of the command that is being done
  bool m_isHeld = false;
  QString m_state;
  QTimer m_timer;
};

}  // namespace

class PilotPlugin final : public QGenericPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "pilot.json")

 public:
  QObject* create(const QString& /*name*/, const QString& /*specification*/) override {
    return new Pilot;
  }
};

#include "pilot.moc"
