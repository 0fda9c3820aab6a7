// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/common/note_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <array>

#include "opcua/grouping.h"
#include "widgets/common/number_format.h"
#include "widgets/streaming/report_panel.h"

namespace rivulet::widgets {

namespace {

/// What core writes, with "%1" for a part that varies, and how it is said.
struct NotePattern {
  const char* written;
  const char* said;
};

constexpr std::array<NotePattern, 48> kNotes{{
    {"access form: %1", QT_TRANSLATE_NOOP("NoteTexts", "Form of access: %1.")},
    {"program %1: %2, %3, %4", QT_TRANSLATE_NOOP("NoteTexts", "Program %1: %2, %3, %4.")},
    {"network: nothing has come from the control for %1 s",
     QT_TRANSLATE_NOOP("NoteTexts", "Nothing has come from the control for %1 s.")},
    {"network: the control answers again",
     QT_TRANSLATE_NOOP("NoteTexts", "The control answers again.")},
    {"slowed: The control answered slowly: accesses took up to %1 s, %2 times as long as expected. "
     "Each took at least %3 s: %4",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The control answered slowly: accesses took up to %1 s, %2 times as long as "
                       "expected. Each took at least %3 s: the network is slow, or the server is "
                       "busy with another OPC UA client.")},
    {"slowed: The control answered slowly: accesses took up to %1 s, %2 times as long as expected. "
     "%3",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The control answered slowly: accesses took up to %1 s, %2 times as long as "
                       "expected. Others were fast: another OPC UA client keeps the server busy at "
                       "times, or the network stalls.")},
    {"online correction in mm: X %1 Y %2 Z %3",
     QT_TRANSLATE_NOOP("NoteTexts", "Online correction in mm: X %1 Y %2 Z %3")},
    {"refused: asked again",
     QT_TRANSLATE_NOOP("NoteTexts", "The control has refused a request: asked again.")},
    {"no answer in time: asked again",
     QT_TRANSLATE_NOOP("NoteTexts", "No answer in time: asked again.")},
    {"stream given up: %1", QT_TRANSLATE_NOOP("NoteTexts", "The stream was given up: %1")},
    {"stream abandoned: %1", QT_TRANSLATE_NOOP("NoteTexts", "The stream was given up: %1")},
    {"a signal was out of sequence: a window has been executed again",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "A signal was out of sequence: a window has been executed again.")},
    {"the checkpoint could not be stored, so the run cannot be resumed after a crash of this "
     "program: %1",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The place of the run could not be kept, so it cannot be resumed after a "
                       "crash of this program: %1")},
    {"the reason why the program ended could not be read",
     QT_TRANSLATE_NOOP("NoteTexts", "The reason why the program ended could not be read.")},
    {"the control's trace could not be fetched: %1",
     QT_TRANSLATE_NOOP("NoteTexts", "The trace of the control could not be fetched: %1")},
    {"the control's trace is incomplete: the run is not judged",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The trace of the control is incomplete: the run is not judged.")},
    {"the name of the run could not be stored: %1",
     QT_TRANSLATE_NOOP("NoteTexts", "The name of the run could not be stored: %1")},
    {"feed source: it is followed",
     QT_TRANSLATE_NOOP("NoteTexts", "Adaptive feed: the source is followed.")},
    {"feed source: No factor has come yet: %1",
     QT_TRANSLATE_NOOP("NoteTexts", "Adaptive feed: no factor has come yet: %1")},
    {"feed source: No factor for %1 s: %2",
     QT_TRANSLATE_NOOP("NoteTexts", "Adaptive feed: no factor for %1 s: %2")},
    {"feed source: The factor %1 was not agreed: %2 to %3, where 1 is 100 %: %4",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "Adaptive feed: the factor %1 was not agreed: %2 to %3, where "
                       "1 is 100 %: %4")},
    {"feed source: The line is no factor of the feed, as feed 0.85 would be: %1",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "Adaptive feed: the line is no factor, as feed 0.85 would be: %1")},
    {"feed source: The source has closed: %1",
     QT_TRANSLATE_NOOP("NoteTexts", "Adaptive feed: the source has closed: %1")},
    {"feed source: The operator goes on without the source.",
     QT_TRANSLATE_NOOP("NoteTexts", "Adaptive feed: the operator goes on without the source.")},
    {"feed: hold requested", QT_TRANSLATE_NOOP("NoteTexts", "The axes are told to stand.")},
    {"feed: continue requested, override %1 %",
     QT_TRANSLATE_NOOP("NoteTexts", "The axes are told to go on, override %1 %.")},
    {"feed: override %1 % requested", QT_TRANSLATE_NOOP("NoteTexts", "Override %1 % requested.")},
    {"feed: an override of %1 % is refused: choose %2 to %3 %",
     QT_TRANSLATE_NOOP("NoteTexts", "An override of %1 % is refused: choose %2 to %3 %.")},
    {"feed: another client has set the override to %1 %: it stays until the next order",
     QT_TRANSLATE_NOOP(
         "NoteTexts",
         "Another client has set the override to %1 %: it stays until the next order.")},
    {"feed: another client has written the factor %1: %2 is written again",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "Another client has written the factor %1: %2 is written again.")},
    {"feed: the control does not obey: its override is %1 %",
     QT_TRANSLATE_NOOP("NoteTexts", "The control does not obey: its override is %1 %.")},
    {"feed: the axes stand, %1 s after it was requested",
     QT_TRANSLATE_NOOP("NoteTexts", "The axes stand, %1 s after it was requested.")},
    {"feed: the axes move although the override is 0: what moves now does not obey it. Stop it at "
     "the control.",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The axes move although the override is 0: what moves now does not obey it. "
                       "Stop it at the control.")},
    {"feed: for %1 s no sign of this client has reached the control: the axes have stood meanwhile",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "For %1 s no sign of this computer has reached the control: the axes have "
                       "stood meanwhile.")},
    {"lift of the tool in mm: %1", QT_TRANSLATE_NOOP("NoteTexts", "Lift of the tool in mm: %1")},
    {"stopped: the axes are held, and the program is left",
     QT_TRANSLATE_NOOP("NoteTexts", "Stopped: the axes are held, and the program is left.")},
    {"the program has no feed cell: hold acts before the next window",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "This program has no feed cell: Pause acts before the next window.")},
    {"wrong motion: after point %1 the tool is %2 mm off the path",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "Wrong motion: after point %1 the tool is %2 mm off the path.")},
    {"wrong motion: points were repeated after point %1",
     QT_TRANSLATE_NOOP("NoteTexts", "Wrong motion: points were repeated after point %1.")},
    // Why the axes stood.
    {"the control recorded a dwell of %1 s in line %2",
     QT_TRANSLATE_NOOP("NoteTexts", "The control recorded a dwell of %1 s in line %2.")},
    {"the control recorded an auxiliary function of %1 s in line %2",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The control recorded an auxiliary function of %1 s in line %2.")},
    {"the control recorded M%1 in line %2",
     QT_TRANSLATE_NOOP("NoteTexts", "The control recorded M%1 in line %2.")},
    {"the override was 0 while the axes stood",
     QT_TRANSLATE_NOOP("NoteTexts", "The override was 0 while the axes stood.")},
    {"a write of %1 values was answered %2 ms before the axes moved again",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "A write of %1 values was answered %2 ms before the axes moved again.")},
    {"the program on the control has a STOPRE between line %1 and line %2",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The program on the control has a STOPRE between line %1 and line %2.")},
    {"the program on the control jumps from line %1 back to line %2",
     QT_TRANSLATE_NOOP("NoteTexts",
                       "The program on the control jumps from line %1 back to line %2.")},
    {"the path turns by %1 degrees there",
     QT_TRANSLATE_NOOP("NoteTexts", "The path turns by %1° there.")},
    {"line %1 of the program dwells there",
     QT_TRANSLATE_NOOP("NoteTexts", "Line %1 of the program dwells there.")},
}};

/// Words that stand in the place of a variable part.
constexpr std::array<NotePattern, 8> kWords{{
    {"written", QT_TRANSLATE_NOOP("NoteTexts", "written")},
    {"already there", QT_TRANSLATE_NOOP("NoteTexts", "already there")},
    {"compared", QT_TRANSLATE_NOOP("NoteTexts", "compared")},
    {"not compared", QT_TRANSLATE_NOOP("NoteTexts", "not compared")},
    {"selected", QT_TRANSLATE_NOOP("NoteTexts", "selected")},
    {"to be selected", QT_TRANSLATE_NOOP("NoteTexts", "to be selected")},
    {"the axes are held.", QT_TRANSLATE_NOOP("NoteTexts", "the axes are held.")},
    {"the override of the operator acts alone.",
     QT_TRANSLATE_NOOP("NoteTexts", "the override of the operator acts alone.")},
}};

QRegularExpression expressionOf(const char* written) {
  QString pattern = QRegularExpression::escape(QString::fromUtf8(written));
  static const QRegularExpression place(QStringLiteral("\\\\%[1-9]"));
  pattern.replace(place, QStringLiteral("(.*?)"));
  return QRegularExpression(QRegularExpression::anchoredPattern(pattern),
                            QRegularExpression::DotMatchesEverythingOption);
}

QString wordText(const QString& word) {
  // A number with a point gets the mark of the language.
  static const QRegularExpression number(
      QRegularExpression::anchoredPattern(QStringLiteral("-?[0-9]+\\.[0-9]+")));
  if (number.match(word).hasMatch()) {
    const qsizetype decimals = word.size() - word.indexOf(QLatin1Char('.')) - 1;
    return numberText(word.toDouble(), static_cast<int>(decimals));
  }
  for (const NotePattern& known : kWords) {
    if (word == QLatin1String(known.written)) {
      return QCoreApplication::translate("NoteTexts", known.said);
    }
  }
  const auto grouping = opcua::groupingFromName(word.toStdString());
  return grouping ? groupingText(*grouping) : word;
}

}  // namespace

QString noteText(const QString& note) {
  for (const NotePattern& known : kNotes) {
    const QRegularExpressionMatch match = expressionOf(known.written).match(note);
    if (!match.hasMatch()) {
      continue;
    }
    QString text = QCoreApplication::translate("NoteTexts", known.said);
    for (int part = match.lastCapturedIndex(); part > 0; --part) {
      text.replace(QStringLiteral("%%1").arg(part), wordText(match.captured(part)));
    }
    return text;
  }
  return note;
}

}  // namespace rivulet::widgets
