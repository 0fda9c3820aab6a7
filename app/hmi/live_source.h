// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The source of live points that the operator has opened: it listens from then on, through all
/// runs, until a program or another source is opened. @threadsafety GUI thread; the source itself
/// belongs to the streaming thread.
#pragma once

#include <QObject>
#include <optional>

#include "hmi/document.h"
#include "hmi/messages.h"
#include "hmi/run_controller.h"
#include "session/stream_session.h"

namespace rivulet::hmi {

class LiveSource final : public QObject {
  Q_OBJECT

 public:
  LiveSource(session::StreamSession& session, Document& document, RunController& runs,
             Messages& messages);

  /// Takes the place of the program if it can be opened; else says why not.
  void open(const live::Setup& setup);
  /// What was agreed last; the defaults at first.
  [[nodiscard]] const live::Setup& setup() const { return m_setup; }
  /// The same to begin with: a box that nobody has chosen yet is put around the tool.
  /// @param toolMm  nothing: not known
  [[nodiscard]] live::Setup proposal(const std::optional<base::Vec3>& toolMm) const;
  void setSetup(const live::Setup& setup) { m_setup = setup; }

 Q_SIGNALS:
  /// `setup` has been opened.
  void opened();

 private:
  void takeOpened(const session::SourceOpened& opened);

  session::StreamSession& m_session;
  Document& m_document;
  RunController& m_runs;
  Messages& m_messages;
  live::Setup m_setup;
  std::optional<live::Setup> m_asked;  ///< until the answer is there
};

}  // namespace rivulet::hmi
