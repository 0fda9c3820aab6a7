// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The parts of the window. Each function makes one part from `widgets` and connects it with the
/// models that it uses; the window only says where it stands. @threadsafety GUI thread.
#pragma once

#include <QString>
#include <optional>

#include "widgets/paper/page.h"

class QToolButton;
class QWidget;

namespace rivulet::widgets {
class MachinesPage;
struct RehearsalView;
}  // namespace rivulet::widgets

namespace rivulet::session {
enum class TestKind;
}

namespace rivulet::hmi {

class Alarms;
class Audit;
class Certificates;
class ControlTests;
class Document;
class EmulatorLearning;
class FoundRuns;
class LiveSource;
class Logins;
class MachineModel;
class MachineProfiles;
class Machines;
class Messages;
class NetPlayer;
class PastRuns;
class Preflight;
class RunController;
class Services;
class Traces;
class Users;
struct Findings;
struct Settings;

/// What a page is for: the three places of the window.
enum class Place : int { Work, Analyse, SetUp };

/// A page of the tab widget.
struct PageEntry {
  const char* title;                ///< to be translated in the context `Pages`
  const char* help = "The window";  ///< heading in docs/hmi.md
  Place place = Place::Work;
};
[[nodiscard]] QString pageTitle(const PageEntry& entry);

/// Pages. The models outlive them.
[[nodiscard]] QWidget* makeProgramPage(Settings* settings, Messages* messages,
                                       MachineModel* machine, Document* document,
                                       RunController* runs, LiveSource* live, FoundRuns* found,
                                       QWidget* parent);
[[nodiscard]] QWidget* makeFeasibilityPage(Messages* messages, Document* document,
                                           RunController* runs, QWidget* parent);
[[nodiscard]] QWidget* makeTracePage(Alarms* alarms, Document* document, RunController* runs,
                                     PastRuns* pastRuns, Traces* traces, QWidget* parent);
[[nodiscard]] QWidget* makeTemplatePage(Messages* messages, Document* document, QWidget* parent);
[[nodiscard]] QWidget* makeCalibrationPage(MachineModel* machine, RunController* runs,
                                           QWidget* parent);
[[nodiscard]] QWidget* makeCommissioningPage(Messages* messages, MachineModel* machine,
                                             ControlTests* tests, session::TestKind kind,
                                             QWidget* parent);
[[nodiscard]] QWidget* makeCertificatesPage(Users* users, MachineModel* machine,
                                            RunController* runs, Certificates* certificates,
                                            QWidget* parent);
[[nodiscard]] QWidget* makeRightsPage(MachineModel* machine, RunController* runs, QWidget* parent);
[[nodiscard]] widgets::MachinesPage* makeMachinesPage(Messages* messages, Alarms* alarms,
                                                      MachineModel* machine, RunController* runs,
                                                      MachineProfiles* profiles, Machines* machines,
                                                      QWidget* parent);
[[nodiscard]] QWidget* makeSetUpPage(Messages* messages, Users* users, MachineModel* machine,
                                     Document* document, RunController* runs, ControlTests* tests,
                                     MachineProfiles* profiles, Certificates* certificates,
                                     Logins* logins, QWidget* parent);
[[nodiscard]] QWidget* makeRunsPage(Messages* messages, RunController* runs, PastRuns* pastRuns,
                                    QWidget* parent);
[[nodiscard]] QWidget* makeAlarmPage(Alarms* alarms, Users* users, QWidget* parent);
[[nodiscard]] QWidget* makeAuditPage(Messages* messages, Audit* audit, QWidget* parent);
[[nodiscard]] QWidget* makeUsersPage(Messages* messages, Users* users, QWidget* parent);
[[nodiscard]] QWidget* makeEmulatorPage(RunController* runs, EmulatorLearning* learning,
                                        QWidget* parent);
[[nodiscard]] QWidget* makeParallelPage(Document* document, RunController* runs, NetPlayer* player,
                                        QWidget* parent);
[[nodiscard]] QWidget* makeLogPage(Messages* messages, QWidget* parent);

/// The services on the board of machines.
void connectServices(Users* users, RunController* runs, Services* services,
                     Certificates* certificates, widgets::MachinesPage& page);

/// Beside, above and below the tabs.
[[nodiscard]] QToolButton* makeMachineButton(MachineModel* machine, QWidget* parent);
[[nodiscard]] QWidget* makeUserButton(Users* users, QWidget* parent);
[[nodiscard]] QWidget* makeAlarmLine(Messages* messages, Alarms* alarms, Users* users,
                                     QWidget* parent);
[[nodiscard]] QWidget* makeLoadBar(Document* document, QWidget* parent);
[[nodiscard]] QWidget* makeFileBanner(Messages* messages, Document* document, RunController* runs,
                                      QWidget* parent);
[[nodiscard]] QWidget* makePositionLine(MachineModel* machine, QWidget* parent);
[[nodiscard]] QWidget* makeConnectionPanel(MachineModel* machine, RunController* runs,
                                           Logins* logins);
[[nodiscard]] QWidget* makeCorrectionPanel(Document* document, RunController* runs);
[[nodiscard]] QWidget* makeFactorPanel(Document* document, RunController* runs);
[[nodiscard]] QWidget* makeMethodPanel(Document* document, RunController* runs);
[[nodiscard]] QWidget* makeWrongMotionBar(Alarms* alarms, RunController* runs, QWidget* parent);
[[nodiscard]] QWidget* makeFoundRunBar(RunController* runs, FoundRuns* found, QWidget* parent);
[[nodiscard]] QWidget* makeResumeBar(RunController* runs, Preflight* preflight, QWidget* parent);
[[nodiscard]] QWidget* makePreflightSheet(RunController* runs, Preflight* preflight,
                                          QWidget* parent);
[[nodiscard]] QWidget* makeTrustSheet(Users* users, MachineModel* machine, RunController* runs,
                                      Certificates* certificates, QWidget* parent);
[[nodiscard]] QWidget* makeRunPanel(Users* users, MachineModel* machine, Document* document,
                                    RunController* runs, Preflight* preflight, FoundRuns* found,
                                    QWidget* parent);

/// The simulation among the findings, as pages show it.
[[nodiscard]] std::optional<widgets::RehearsalView> rehearsalView(const Findings& findings);

/// Brings the page that a widget is, or is on, to the front.
void showPageOf(QWidget* widget);

/// Saves a text to a file and says so.
void saveText(Messages* messages, const QString& path, const QString& text);
/// The same of a page to print: as HTML if the file is called so, else as PDF.
void saveSheet(Messages* messages, const QString& path, const paper::Page& page);

}  // namespace rivulet::hmi
