// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The control at the other end: connection, what it was seen to do last, and what its accesses
/// cost. @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "hmi/logins.h"
#include "hmi/messages.h"
#include "report/machine_store.h"
#include "session/stream_session.h"
#include "widgets/connection/machine_view.h"

namespace rivulet::hmi {

class MachineModel final : public QObject {
  Q_OBJECT

 public:
  /// Seconds on a clock that never goes back.
  using Clock = std::function<double()>;
  MachineModel(session::StreamSession& session, report::MachineStore store, Messages& messages,
               Clock clock = steadySeconds);
  [[nodiscard]] static double steadySeconds();

  void setEndpoint(const QString& endpoint);
  [[nodiscard]] const QString& endpoint() const { return m_endpoint; }
  /// Map and library, as chosen for the latest attempt to connect, or as remembered.
  [[nodiscard]] const widgets::ControlChoice& control() const { return m_control; }
  /// As whom machines are connected; without, everywhere anonymous. Outlives this.
  void setLogins(Logins& logins) { m_logins = &logins; }
  /// As whom it was connected last.
  void connectTo(const QString& endpoint);
  /// A password that was not typed is looked for in the keyring.
  /// @param control  its map is read now
  void connectAs(const QString& endpoint, const widgets::Login& login,
                 const widgets::ControlChoice& control);
  void disconnectFrom();
  /// Asks for the rights of the user of this connection; answered by `rightsSeen`.
  void examineRights() { m_session.examineRights(); }
  /// How the connection is protected; nothing: there is none, or no network between.
  [[nodiscard]] std::optional<opcua::Protection> protection() const;
  /// What has to be decided before the machine can be connected; null: nothing.
  [[nodiscard]] const opcua::TrustQuestion* question() const { return m_link.question.get(); }
  /// These answer the question. The first two connect again: with the certificate that was shown,
  /// or as it is allowed by name.
  void acceptCertificate();
  void allow(const opcua::SecurityChoice& choice);
  void dropQuestion();

  [[nodiscard]] const session::LinkChanged& link() const { return m_link; }
  [[nodiscard]] widgets::ConnectionState connectionState() const;
  [[nodiscard]] bool isConnected() const { return m_link.state == session::LinkState::Connected; }
  [[nodiscard]] const widgets::MachineView& view() const { return m_view; }
  /// The channel was not in reset when it was seen last: whoever started it, and also after the
  /// connection was lost, something may move.
  [[nodiscard]] bool mayMove() const { return m_mayMove; }
  /// The position, if it was read just now.
  [[nodiscard]] std::optional<base::Vec3> positionNowMm() const;

  /// During a run the stream leaves no time to look at the control; these are what it knows.
  void showRunning(const QString& programName);
  /// The stream has reported; this is the last point that it knows to be executed.
  /// @param number  1: the first of the program; 0: none yet
  /// @param overrideFactor  nothing: one feed for all moves
  void showExecuted(std::size_t number, const base::Vec3& positionMm, double feedSetMmPerS,
                    std::optional<double> overrideFactor);
  /// No run is in progress any more: no point stands in for the position, and nothing is commanded.
  void forgetExecuted();
  /// A run of this window is prepared, or not any more: see `widgets::MachineView::isPreparing`.
  void showPreparing(bool isPreparing) { m_view.isPreparing = isPreparing; }
  /// @param toGo  from the position of the sample; nothing: not known
  void showSample(const trace::LiveSample& sample,
                  const std::optional<widgets::MachineView::ToGo>& toGo);

  /// Tool, spindle, coolant and work offset, just read.
  void showEquipment(const streaming::EquipmentSeen& equipment);

  /// Null: this machine was never calibrated.
  [[nodiscard]] const std::shared_ptr<const streaming::CalibrationRecord>& calibration() const {
    return m_calibration;
  }
  /// The calibration was made with another version of the server.
  [[nodiscard]] bool isCalibrationOutdated() const { return m_isOutdated; }

 Q_SIGNALS:
  void endpointChanged();
  void linkChanged();
  void viewChanged();
  void rightsSeen(const rivulet::session::RightsSeen& seen);
  /// The control was looked at between runs.
  /// @param isNews  it says something else than before, or said nothing for a while
  void seen(bool isNews);
  void calibrationChanged();
  /// A calibration has ended, with a new record or without.
  void calibrationEnded();

 private:
  void takeLink(const session::LinkChanged& change);
  [[nodiscard]] widgets::ControlChoice rememberedControl(const QString& endpoint) const;
  void showEndpoint(const QString& endpoint);
  /// @return whether there is nothing to read, or it was read
  [[nodiscard]] bool readMap(const QString& file);
  /// The same for the certificate of a user.
  [[nodiscard]] bool readCertificate(const widgets::LoginName& name);
  /// An attempt to connect has ended before it began.
  void refuse(const base::Error& error);
  void connectAgain();
  /// Says what has become of the connection.
  void sayLink();
  void takeSeen(const session::MachineSeen& seen);
  void takeCalibration(const session::CalibrationFinished& finished);
  void loadCalibration();
  /// Ages of what is shown, at the present time.
  void showAges();

  session::StreamSession& m_session;
  report::MachineStore m_store;
  Messages& m_messages;
  QString m_endpoint;
  Logins* m_logins = nullptr;
  widgets::Login m_login;            ///< of `m_request`
  widgets::ControlChoice m_control;  ///< of `m_request`
  opcua::ConnectRequest m_request;   ///< of the attempt in progress, or that is asked about
  session::LinkChanged m_link;
  bool m_mayMove = false;
  widgets::MachineView m_view;
  std::shared_ptr<const streaming::CalibrationRecord> m_calibration;
  bool m_isOutdated = false;
  /// When a group of values was read.
  class ReadTimes {
   public:
    /// @param duringRun  how far apart reads are says something only then
    void take(double nowS, bool duringRun);
    [[nodiscard]] std::optional<double> ageS(double nowS) const;
    /// See `MachineView::isPositionRare`.
    [[nodiscard]] bool isRare(double nowS) const;

   private:
    std::optional<double> m_atS;
    std::optional<double> m_rareAtS;  ///< the latest read that came long after the one before it
  };

  Clock m_clock;
  QTimer m_ageTimer;
  ReadTimes m_positionRead;
  ReadTimes m_feedRead;
  std::optional<double> m_equipmentAtS;
  std::optional<double> m_describedAtS;
  std::optional<double> m_stateAtS;
  double m_executedAtS = 0.0;
};

}  // namespace rivulet::hmi
