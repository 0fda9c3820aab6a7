// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Live sources over UNIX and TCP sockets (one sender; it is told how far the run is) and UDP.
/// @threadsafety one object, one thread; nothing waits.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "base/result.h"
#include "live/source.h"
#include "sources/descriptor.h"

namespace rivulet::sources {

/// A socket that listens for one sender. Others are told that it is taken.
class StreamSocketSource final : public live::Source {
 public:
  /// @param path  is made, readable by this user only, and removed at the end
  [[nodiscard]] static base::Result<std::unique_ptr<live::Source>> listenUnix(
      const std::string& path);
  /// On 127.0.0.1. @param port  0: any that is free; the name says which
  [[nodiscard]] static base::Result<std::unique_ptr<live::Source>> listenTcp(int port);
  ~StreamSocketSource() override;

  std::string name() const override { return m_name; }
  std::size_t read(std::span<char> into) override;
  bool isClosed() const override { return m_isClosed; }
  bool takesReplies() const override { return m_sender.isOpen() && !m_isDeaf; }
  void tell(const live::Progress& progress) override;

 private:
  StreamSocketSource(std::string name, Descriptor listener, std::string path)
      : m_name(std::move(name)), m_listener(std::move(listener)), m_path(std::move(path)) {}
  void accept();
  void sayGoodbye();

  std::string m_name;
  Descriptor m_listener;
  std::string m_path;  ///< to be removed; empty: none
  Descriptor m_sender;
  bool m_isDeaf = false;  ///< it takes no more replies
  bool m_isClosed = false;
};

/// Datagrams to a port of 127.0.0.1; each holds whole lines. One that is lost shows in the numbers
/// of the points. The first program of this user that sends has the source; others are told that it
/// is taken, and those of other users get no answer.
class DatagramSource final : public live::Source {
 public:
  [[nodiscard]] static base::Result<std::unique_ptr<live::Source>> listen(int port);
  std::string name() const override { return m_name; }
  std::size_t read(std::span<char> into) override;
  bool isClosed() const override { return false; }
  bool canWait() const override { return false; }

 private:
  DatagramSource(std::string name, Descriptor socket)
      : m_name(std::move(name)), m_socket(std::move(socket)) {}
  std::string m_name;
  Descriptor m_socket;
  /// @return whether its datagrams are taken
  bool isSender(std::uint16_t port);

  std::string m_rest;           ///< of a datagram
  std::uint16_t m_sender = 0;   ///< its port; 0: nobody has sent yet
  std::uint16_t m_refused = 0;  ///< port of the last one that was told
};

}  // namespace rivulet::sources
