// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/live_source.h"

#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using gcode::Severity;

LiveSource::LiveSource(session::StreamSession& session, Document& document, RunController& runs,
                       Messages& messages)
    : m_session(session), m_document(document), m_runs(runs), m_messages(messages) {
  connect(&m_session, &session::StreamSession::sourceOpened, this, &LiveSource::takeOpened);
  connect(&m_document, &Document::programLoaded, this, [this] {
    if (!m_document.live()) {
      m_asked.reset();
      m_session.listen({});
    }
  });
}

void LiveSource::open(const live::Setup& setup) {
  if (m_runs.isRunning()) {
    m_messages.show(Severity::Warning, [] {
      return tr("A run is in progress. Open a live source after it has ended.");
    });
    return;
  }
  if (const base::Result<void> sound = live::requireSound(setup); !sound) {
    m_messages.show(Severity::Warning,
                    [error = sound.error()] { return widgets::errorText(error); });
    return;
  }
  m_asked = setup;
  m_session.listen(QString::fromStdString(setup.address));
}

live::Setup LiveSource::proposal(const std::optional<base::Vec3>& toolMm) const {
  live::Setup setup = m_setup;
  const live::Agreement usual;
  if (toolMm && setup.agreement.lowestMm == usual.lowestMm &&
      setup.agreement.highestMm == usual.highestMm) {
    setup.agreement = live::around(setup.agreement, *toolMm);
  }
  return setup;
}

void LiveSource::takeOpened(const session::SourceOpened& opened) {
  const std::optional<base::Error> obstacle =
      opened.error.code ? std::optional(opened.error) : std::nullopt;
  if (!m_asked || m_asked->address != opened.address) {
    m_document.setLiveObstacle(obstacle);  // open again after a run
    return;
  }
  const live::Setup setup = *m_asked;
  m_asked.reset();
  if (obstacle) {
    m_messages.show(Severity::Error, [error = *obstacle] { return widgets::errorText(error); });
    m_document.setLiveObstacle(obstacle);  // the source before has been closed for it
    return;
  }
  m_setup = setup;
  m_messages.clear();
  m_document.openLive(setup, opened.name);
  m_messages.didAct(permission::Act::OpenProgram,
                    {{"program", opened.name}, {"agreed", live::textOf(setup)}});
  m_messages.log(Severity::Note, Messages::Source::Program,
                 [name = QString::fromStdString(opened.name)] {
                   return tr("Listening for live points on %1.").arg(name);
                 });
  Q_EMIT this->opened();
}

}  // namespace rivulet::hmi
