// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The parts of the window. Each function makes one part from `widgets` and connects it with the
/// models itself; the window only says where it stands. @threadsafety GUI thread.
#pragma once

#include <span>

#include "hmi/alarms.h"
#include "hmi/audit.h"
#include "hmi/certificates.h"
#include "hmi/credit_commissioning.h"
#include "hmi/document.h"
#include "hmi/emulator_learning.h"
#include "hmi/found_runs.h"
#include "hmi/live_source.h"
#include "hmi/logins.h"
#include "hmi/machine_model.h"
#include "hmi/machine_profiles.h"
#include "hmi/machines.h"
#include "hmi/messages.h"
#include "hmi/net_player.h"
#include "hmi/past_runs.h"
#include "hmi/preflight.h"
#include "hmi/run_controller.h"
#include "hmi/services.h"
#include "hmi/settings.h"
#include "hmi/traces.h"
#include "hmi/users.h"

class QToolButton;
class QWidget;

namespace rivulet::widgets {
class MachinesPage;
class ProgramPage;
}  // namespace rivulet::widgets

namespace rivulet::hmi {

/// What pages connect themselves with. All of it outlives the pages.
struct Models {
  Settings& settings;
  Messages& messages;
  Alarms& alarms;
  Users& users;
  Audit& audit;
  MachineModel& machine;
  Document& document;
  RunController& runs;
  LiveSource& live;
  Preflight& preflight;
  FoundRuns& found;
  PastRuns& pastRuns;
  CreditCommissioning& credit;
  MachineProfiles& profiles;
  Machines& machines;
  Services& services;
  Traces& traces;
  Certificates& certificates;
  Logins& logins;
  EmulatorLearning& learning;
  NetPlayer& player;
};

/// A page of the tab widget.
struct PageEntry {
  const char* title;  ///< to be translated in the context `Pages`
  QWidget* (*make)(const Models& models, QWidget* parent);
  const char* help = "The window";  ///< heading in docs/hmi.md
  bool isInMenu = false;            ///< chosen there, not at the side: no work at a machine
};
/// In the order of the tabs.
[[nodiscard]] std::span<const PageEntry> pageEntries();
[[nodiscard]] QString pageTitle(const PageEntry& entry);

[[nodiscard]] QWidget* makeProgramPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeFeasibilityPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeTracePage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeTemplatePage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeCalibrationPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeCommissioningPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeCertificatesPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeRightsPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeMachinesPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeSetUpPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeRunsPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeAlarmPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeAuditPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeUsersPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeEmulatorPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeParallelPage(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeLogPage(const Models& models, QWidget* parent);

/// The services on the board of machines.
void connectServices(const Models& models, widgets::MachinesPage& page);

/// Beside, above and below the tabs.
[[nodiscard]] QToolButton* makeMachineButton(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeUserButton(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeAlarmLine(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeLoadBar(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeFileBanner(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makePositionLine(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeConnectionPanel(const Models& models);
[[nodiscard]] QWidget* makeCorrectionPanel(const Models& models);
[[nodiscard]] QWidget* makeMethodPanel(const Models& models);
[[nodiscard]] QWidget* makeWrongMotionBar(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeFoundRunBar(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeResumeBar(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makePreflightSheet(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeTrustSheet(const Models& models, QWidget* parent);
[[nodiscard]] QWidget* makeRunPanel(const Models& models, QWidget* parent);

/// The simulation among the findings, as pages show it.
[[nodiscard]] std::optional<widgets::RehearsalView> rehearsalView(const Findings& findings);

/// Brings the page that a widget is, or is on, to the front.
void showPageOf(QWidget* widget);

/// Saves a text to a file and says so.
void saveText(const Models& models, const QString& path, const QString& text);

}  // namespace rivulet::hmi
