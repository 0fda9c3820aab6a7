// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// A live source in the variables of another OPC UA server. They are read in one request after the
/// other, as long as points are wanted; a number or text that has changed is news. What is there
/// before the first read of a run is old and is passed over.
/// @threadsafety one object, one thread; `read` and `tell` never wait.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "live/source.h"
#include "opcua/link.h"
#include "sources/server_map.h"

namespace rivulet::sources {

class ServerSource final : public live::Source {
 public:
  /// Connects and reads once. @param path  of the file of the source
  /// @return BadSourceFile, NotOpened, and what `trust::connect` returns
  [[nodiscard]] static base::Result<std::unique_ptr<live::Source>> open(const std::string& path);

  std::string name() const override { return m_name; }
  base::Result<void> prepare() override;
  std::size_t read(std::span<char> into) override;
  bool isClosed() const override { return m_isClosed && m_text.empty(); }
  /// A server that is told what was accepted can keep each point until then.
  bool canWait() const override { return m_map.has(kAcceptedVariable); }
  bool takesReplies() const override {
    return m_map.has(kAcceptedVariable) || m_map.has(kExecutedVariable);
  }
  void tell(const live::Progress& progress) override;

 private:
  ServerSource(std::string name, ServerMap map);
  [[nodiscard]] base::Result<void> connect();
  /// Reads once, waiting. What is there is old.
  [[nodiscard]] base::Result<void> readOld();
  void serve();
  void take(const std::vector<opcua::Reading>& readings);
  [[nodiscard]] std::string lineOf(const std::vector<opcua::Reading>& readings) const;

  std::string m_name;
  ServerMap m_map;
  std::vector<opcua::Variable> m_variables;  ///< that are read; the first one tells what is new
  opcua::Connection m_connection;
  std::optional<base::RequestId> m_asked;
  std::optional<opcua::Reading> m_seen;  ///< of the first variable
  std::string m_text;                    ///< has come and has not been read
  bool m_isClosed = false;
};

}  // namespace rivulet::sources
