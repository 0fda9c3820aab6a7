// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The virtual machine that the window itself starts: the program `rivulet-machine`, on a free port
/// of this computer. It ends with the window, also when the window is killed.
/// @threadsafety GUI thread.
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>

namespace rivulet::hmi {

/// The sample that comes with Rivulet. @return empty: it is not there
[[nodiscard]] QString sampleFile();

class VirtualMachine final : public QObject {
  Q_OBJECT

 public:
  explicit VirtualMachine(QObject* parent = nullptr);
  ~VirtualMachine() override;

  /// Tells where it listens, or why it does not.
  void start();
  [[nodiscard]] bool isOn() const { return m_process.state() != QProcess::NotRunning; }

 Q_SIGNALS:
  void listens(const QString& endpoint);
  void failed(const QString& reason);

 private:
  void read();

  QProcess m_process;
  QByteArray m_line;
  bool m_hasListened = false;
};

}  // namespace rivulet::hmi
