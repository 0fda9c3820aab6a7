// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/emulator_learning.h"

#include <QCoreApplication>
#include <QPointer>
#include <algorithm>
#include <functional>
#include <utility>

#include "base/file.h"
#include "emulator/emulator_error.h"
#include "session/background.h"

namespace rivulet::hmi {

namespace {

using State = widgets::RecordingView::State;

/// As many recordings leave one to test.
constexpr std::size_t kRecordingsToSpare = 3;

std::shared_ptr<const widgets::EmulatorView> viewOf(const learning::Learned& learned) {
  auto view = std::make_shared<widgets::EmulatorView>();
  view->emulator = learned.emulator;
  view->feedMmPerSMax = learned.feedMmPerSMax;
  view->limits = learned.limits;
  for (const learning::RunTest& test : learned.tests) {
    (test.isUnseen ? view->unseen : view->learnedFrom).push_back(test.fit);
  }
  return view;
}

}  // namespace

EmulatorLearning::EmulatorLearning() : m_preset(QLatin1String(machine::kDefaultPreset)) {
}

EmulatorLearning::~EmulatorLearning() {
  cancel();
}

std::vector<widgets::RecordingView> EmulatorLearning::recordings() const {
  std::vector<widgets::RecordingView> views;
  for (const Entry& entry : m_entries) {
    widgets::RecordingView view;
    view.trace = QString::fromStdString(entry.file.trace);
    view.program = QString::fromStdString(entry.file.program);
    view.isForTest = entry.isForTest;
    view.state = entry.state;
    view.lengthS = entry.facts.lengthS;
    view.samplesPerS = entry.facts.samplesPerS;
    view.axes = entry.facts.axes;
    view.feedMmPerSMax = entry.facts.feedMmPerSMax;
    views.push_back(std::move(view));
  }
  return views;
}

EmulatorLearning::Entry* EmulatorLearning::find(int id) {
  const auto found = std::find_if(m_entries.begin(), m_entries.end(),
                                  [id](const Entry& entry) { return entry.id == id; });
  return found == m_entries.end() ? nullptr : &*found;
}

void EmulatorLearning::add(const QStringList& paths) {
  if (isLearning()) {
    return;
  }
  for (const QString& path : paths) {
    const std::string file = path.toStdString();
    const bool isThere =
        std::any_of(m_entries.begin(), m_entries.end(),
                    [&file](const Entry& entry) { return entry.file.trace == file; });
    if (!isThere) {
      Entry& entry = m_entries.emplace_back();
      entry.id = ++m_lastId;
      entry.file.trace = file;
      read(entry, entry.file);
    }
  }
  Q_EMIT recordingsChanged();
}

void EmulatorLearning::read(Entry& entry, const learning::RecordingFile& file) {
  entry.state = State::Reading;
  using Result = base::Result<learning::Recording>;
  struct Read {
    std::shared_ptr<const Result> result;
    learning::RecordingFacts facts;
  };
  auto compute = [file, preset = m_preset.toStdString(), machine = m_machine] {
    std::shared_ptr<const machine::MachineConfig> known = machine;
    std::shared_ptr<const Result> result;
    if (!known) {
      auto loaded = machine::loadPreset(preset);
      if (loaded) {
        known = std::make_shared<const machine::MachineConfig>(std::move(*loaded));
      } else {
        result = std::make_shared<const Result>(base::fail(loaded.error()));
      }
    }
    if (known) {
      result = std::make_shared<const Result>(learning::readRecording(file, *known));
    }
    return Read{result, *result ? learning::factsOf(**result) : learning::RecordingFacts{}};
  };
  session::inBackground(this, std::move(compute),
                        [file, id = entry.id](EmulatorLearning& self, const Read& read) {
                          self.take(id, file, *read.result, read.facts);
                        });
}

void EmulatorLearning::take(int id, const learning::RecordingFile& file,
                            const base::Result<learning::Recording>& result,
                            const learning::RecordingFacts& facts) {
  Entry* entry = find(id);
  if (entry == nullptr) {
    return;  // removed meanwhile
  }
  if (result) {
    entry->file = file;
    entry->recording = std::make_shared<const learning::Recording>(*result);
    entry->facts = facts;
    entry->state = State::Ready;
  } else if (entry->recording) {
    entry->state = State::Ready;  // as it was
  } else if (result.error().code == emulator::EmulatorError::WrongProgram ||
             !file.program.empty()) {
    entry->state = State::NeedsProgram;
  } else {
    m_entries.erase(m_entries.begin() + (entry - m_entries.data()));
  }
  proposeUses();
  Q_EMIT recordingsChanged();
  const bool wantsProgram = !result &&
                            result.error().code == emulator::EmulatorError::WrongProgram &&
                            file.program.empty();
  if (!result && !wantsProgram) {
    Q_EMIT failed(result.error());
  }
}

void EmulatorLearning::proposeUses() {
  const bool isReading = std::any_of(m_entries.begin(), m_entries.end(), [](const Entry& entry) {
    return entry.state == State::Reading;
  });
  if (m_usesAreChosen || isReading) {
    return;
  }
  for (Entry& entry : m_entries) {
    entry.isForTest = m_entries.size() >= kRecordingsToSpare && &entry == &m_entries.back();
  }
}

void EmulatorLearning::remove(int recording) {
  if (!isLearning() && recording >= 0 && recording < static_cast<int>(m_entries.size())) {
    m_entries.erase(m_entries.begin() + recording);
    proposeUses();
    Q_EMIT recordingsChanged();
  }
}

void EmulatorLearning::setProgram(int recording, const QString& path) {
  if (!isLearning() && recording >= 0 && recording < static_cast<int>(m_entries.size())) {
    Entry& entry = m_entries[static_cast<std::size_t>(recording)];
    learning::RecordingFile file = entry.file;
    file.program = path.toStdString();
    read(entry, file);
    Q_EMIT recordingsChanged();
  }
}

void EmulatorLearning::setUse(int recording, bool isForTest) {
  if (!isLearning() && recording >= 0 && recording < static_cast<int>(m_entries.size())) {
    m_usesAreChosen = true;
    m_entries[static_cast<std::size_t>(recording)].isForTest = isForTest;
    Q_EMIT recordingsChanged();
  }
}

void EmulatorLearning::setPreset(const QString& preset) {
  session::inBackground(
      this, [preset] { return machine::loadPreset(preset.toStdString()); },
      [preset, request = ++m_presetRequest](EmulatorLearning& self,
                                            base::Result<machine::MachineConfig> loaded) {
        if (self.m_presetRequest != request || self.isLearning()) {
          return;
        }
        if (!loaded) {
          Q_EMIT self.failed(loaded.error());
          return;
        }
        self.m_preset = preset;
        self.m_machine = std::make_shared<const machine::MachineConfig>(std::move(*loaded));
        for (Entry& entry : self.m_entries) {
          if (!entry.file.program.empty()) {
            self.read(entry, entry.file);
          }
        }
        Q_EMIT self.presetChanged();
        Q_EMIT self.recordingsChanged();
      });
}

void EmulatorLearning::learn() {
  const bool isReady = std::all_of(m_entries.begin(), m_entries.end(),
                                   [](const Entry& entry) { return entry.state == State::Ready; });
  if (isLearning() || !isReady) {
    return;
  }
  learning::LearnRequest request;
  request.preset = m_preset.toStdString();
  for (const Entry& entry : m_entries) {
    (entry.isForTest ? request.testOn : request.learnFrom).push_back(*entry.recording);
  }
  m_cancelled = std::make_shared<std::atomic<bool>>(false);
  auto compute = [guard = QPointer<EmulatorLearning>(this), request = std::move(request),
                  cancelled = m_cancelled]() mutable {
    const auto report = [guard, cancelled](const emulator::LearnProgress& progress) {
      session::callLater(guard, [cancelled, progress](EmulatorLearning& learning) {
        if (learning.m_cancelled == cancelled) {
          Q_EMIT learning.progressed(progress);
        }
      });
      return true;
    };
    return std::make_shared<const base::Result<learning::Learned>>(
        learning::learn(std::move(request), report, [cancelled] { return cancelled->load(); }));
  };
  session::inBackground(this, std::move(compute),
                        [cancelled = m_cancelled](
                            EmulatorLearning& self,
                            const std::shared_ptr<const base::Result<learning::Learned>>& result) {
                          if (self.m_cancelled != cancelled) {
                            return;
                          }
                          self.m_cancelled = nullptr;
                          Q_EMIT self.ended();
                          if (!*result) {
                            Q_EMIT self.failed(result->error());
                            return;
                          }
                          self.m_learned =
                              std::shared_ptr<const learning::Learned>(result, &result->value());
                          Q_EMIT self.learned(viewOf(*self.m_learned));
                        });
  Q_EMIT started();
}

void EmulatorLearning::compare() {
  if (isLearning() || !m_learned) {
    return;
  }
  m_cancelled = std::make_shared<std::atomic<bool>>(false);
  auto compute = [guard = QPointer<EmulatorLearning>(this), learned = m_learned,
                  cancelled = m_cancelled] {
    std::vector<emulator::TrainingRun> runs;
    for (const learning::Recording& recording : learned->recordings) {
      runs.push_back(recording.run);
    }
    const auto report = [guard, cancelled](double share) {
      session::callLater(guard, [cancelled, share](EmulatorLearning& learning) {
        if (learning.m_cancelled == cancelled) {
          Q_EMIT learning.comparing(share);
        }
      });
      return true;
    };
    return emulator::crossTest(
        learned->emulator, runs,
        {.progress = report, .isCancelled = [cancelled] { return cancelled->load(); }});
  };
  session::inBackground(this, std::move(compute),
                        [cancelled = m_cancelled](EmulatorLearning& self, const auto& result) {
                          if (self.m_cancelled != cancelled) {
                            return;
                          }
                          self.m_cancelled = nullptr;
                          Q_EMIT self.ended();
                          if (result) {
                            Q_EMIT self.compared(*result);
                          } else {
                            Q_EMIT self.failed(result.error());
                          }
                        });
  Q_EMIT comparing(0.0);
}

void EmulatorLearning::cancel() {
  if (m_cancelled) {
    m_cancelled->store(true);
  }
}

void EmulatorLearning::save(const QString& path) {
  if (!m_learned) {
    return;
  }
  learning::Learned copy = *m_learned;
  copy.emulator.preset = learning::presetBeside(copy.emulator.preset, path.toStdString());
  if (auto done = base::writeFile(path.toStdString(), learning::presetText(copy)); !done) {
    Q_EMIT failed(done.error());
    return;
  }
  Q_EMIT saved(path);
}

void EmulatorLearning::drawOverlay(int run, const emulator::OverlayNames& names) {
  if (!m_learned || run < 0 || run >= static_cast<int>(m_learned->recordings.size())) {
    return;
  }
  session::inBackground(
      this,
      [learned = m_learned, run, names] {
        return emulator::overlayOf(learned->emulator,
                                   learned->recordings[static_cast<std::size_t>(run)].run, names);
      },
      [request = ++m_overlayRequest](EmulatorLearning& self, const auto& overlay) {
        if (self.m_overlayRequest != request) {
          return;
        }
        if (overlay) {
          Q_EMIT self.overlayDrawn(*overlay);
        } else {
          Q_EMIT self.failed(overlay.error());
        }
      });
}

}  // namespace rivulet::hmi
