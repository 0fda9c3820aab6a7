// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/templates/template_sheet.h"

#include <QCoreApplication>
#include <QLocale>
#include <chrono>

#include "opcua/rights.h"
#include "streaming/run/run.h"
#include "templates/cells.h"
#include "widgets/connection/rights_page.h"
#include "widgets/runs/run_texts.h"

namespace rivulet::widgets {

namespace {

using templates::FlexibleProgram;

/// The steps are numbered over all sections, so that they can be named on the phone.
struct TemplateSheetTexts {
  Q_DECLARE_TR_FUNCTIONS(TemplateSheetTexts)

 public:
  static QString title(const QString& name) { return tr("Bring %1 to the control").arg(name); }
  static QString result(int layoutNumber) {
    return tr("Layout number %1: with another one Rivulet moves nothing").arg(layoutNumber);
  }
  static QString purpose() {
    return tr(
        "This program runs on the control and moves the axes to the points that Rivulet "
        "sends in R-parameters. It is valid for the settings on this page only; with others "
        "it has another layout number.");
  }
  static QString program() { return tr("Program"); }
  static QString settings() { return tr("Settings"); }
  static QList<paper::Fact> programLines(const FlexibleProgram& program) {
    return {
        {tr("File on the control"), QString::fromStdString(program.name)},
        {tr("Layout number"), tr("%1 in R%2").arg(program.layoutNumber).arg(program.cells.layout)}};
  }
  static QList<paper::Fact> settingLines(const FlexibleProgram& program) {
    return {{tr("Method"), methodText(program.parameters.method)},
            {tr("Points, axes"),
             QStringLiteral("%1, %2")
                 .arg(program.parameters.pointsPerLoop)
                 .arg(QString::fromStdString(templates::axisLetters(program.parameters)))}};
  }

  static QStringList bring(const FlexibleProgram& program, int minutes) {
    return {
        tr("Make sure that no other program, cycle or client uses R%1 to R%2.")
            .arg(program.parameters.baseCell)
            .arg(program.cells.last()),
        program.parameters.target == templates::TargetControl::Sinumerik
            ? tr("Copy the file to the part programs of the control, by network or USB stick, as "
                 "%1. Change nothing in it: Rivulet relies on every line.")
                  .arg(QString::fromStdString(program.name))
            : tr("Copy the file to the folder of the NC programs of the control as %1. Change "
                 "nothing in it: Rivulet relies on every line.")
                  .arg(QString::fromStdString(program.name)),
        tr("In Rivulet, column Settings, tick “copied by hand” at Template. Look through what "
           "Start shows, then hold Start. From then on Rivulet waits up to %n minutes.",
           nullptr, minutes),
        tr("At the control: select the program in channel 1, close the doors, set the feed "
           "override, press cycle start. No axis moves yet."),
        tr("The program writes its layout number and waits. Only when Rivulet has read the right "
           "number, it sends points and the axes move.")};
  }
  static QStringList seen() {
    return {
        tr("The control shows this program as running from cycle start until its end, also while "
           "the axes stand and it waits for points."),
        tr("Feed override, feed hold, reset and emergency stop of the machine act as in any other "
           "program. Stop and Pause in Rivulet do not replace them."),
        tr("If Rivulet, its computer or the network fails, nothing new is sent: with numbered "
           "windows the axes stand; with methods position and signal they may go to old points "
           "again.")};
  }
  static QStringList takeBack() {
    return {
        tr("End the run in Rivulet. If the program still runs: press reset at the control."),
        tr("Select another program, then delete the file from the part programs of the control."),
        tr("The R-parameters keep their last values. Set to 0 those that other programs read."),
        tr("Take back the rights that were given for it; on a SINUMERIK with DeleteUserAccess. "
           "Remove the certificate of this computer from those that the control trusts if Rivulet "
           "is not to connect again.")};
  }
  static QString rights() { return tr("Rights of the OPC UA user"); }
  static QString right(opcua::RunRight right, bool isMapped) {
    const QString text =
        QStringLiteral("%1: %2. %3")
            .arg(rightText(opcua::rightTitle(right)), rightText(opcua::rightPurpose(right)),
                 rightText(opcua::rightRemedy(right, isMapped)));
    return opcua::isEssential(right)
               ? text
               : text + QLatin1Char(' ') + tr("(Not needed for these steps.)");
  }
  static QString steps() { return tr("Steps"); }
  static QString operatorSees() { return tr("What the operator sees"); }
  static QString back() { return tr("Taking it back"); }
  static QString signature() { return tr("Date, name, signature"); }
};

}  // namespace

paper::Page templatePage(const FlexibleProgram& program, const paper::Table& cells,
                         const QString& appVersion) {
  const QString name = QString::fromStdString(program.name);
  const bool isMapped = program.parameters.target != templates::TargetControl::Sinumerik;
  const auto wait =
      std::chrono::duration_cast<std::chrono::minutes>(streaming::RunSettings{}.startDeadline);
  paper::Page page;
  page.language = QLocale().bcp47Name();
  page.title = TemplateSheetTexts::title(name);
  page.result = TemplateSheetTexts::result(program.layoutNumber);
  page.sentences = {TemplateSheetTexts::purpose()};
  page.groups = {{TemplateSheetTexts::program(), TemplateSheetTexts::programLines(program)},
                 {TemplateSheetTexts::settings(), TemplateSheetTexts::settingLines(program)}};
  QStringList rights;
  for (const auto right : {opcua::RunRight::ReadVariables, opcua::RunRight::WriteParameters,
                           opcua::RunRight::ReadPrograms, opcua::RunRight::WritePrograms,
                           opcua::RunRight::SelectProgram}) {
    rights.append(TemplateSheetTexts::right(right, isMapped));
  }
  page.sections = {{TemplateSheetTexts::steps(),
                    TemplateSheetTexts::bring(program, static_cast<int>(wait.count()))},
                   {TemplateSheetTexts::rights(), rights},
                   {TemplateSheetTexts::operatorSees(), TemplateSheetTexts::seen()},
                   {TemplateSheetTexts::back(), TemplateSheetTexts::takeBack()}};
  int step = 0;
  for (paper::Section& section : page.sections) {
    const bool isDone =
        section.title == TemplateSheetTexts::steps() || section.title == TemplateSheetTexts::back();
    for (QString& sentence : section.sentences) {
      sentence.prepend(isDone ? QStringLiteral("%1. ").arg(++step) : QStringLiteral("– "));
    }
  }
  page.table = cells;
  page.signature = TemplateSheetTexts::signature();
  page.footer = {QStringLiteral("Rivulet ") + appVersion};
  return page;
}

}  // namespace rivulet::widgets
