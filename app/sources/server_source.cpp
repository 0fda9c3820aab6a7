// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources/server_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "live/error.h"
#include "opcua/await.h"
#include "trust/connect.h"
#include "trust/password.h"

namespace rivulet::sources {

namespace {

using base::Result;

constexpr std::chrono::seconds kAnswerMax{2};

/// As the lines of a source name them.
struct Word {
  char letter;
  opcua::Variable variable;
};
constexpr std::array<Word, 7> kWords{{{'X', axisVariable(0)},
                                      {'Y', axisVariable(1)},
                                      {'Z', axisVariable(2)},
                                      {'A', axisVariable(3)},
                                      {'B', axisVariable(4)},
                                      {'C', axisVariable(5)},
                                      {'F', kFeedVariable}}};

/// Of words: the one of the number, and what it is.
std::string wordOf(char letter, const opcua::Reading& reading) {
  // What cannot be read is no number, and the line is refused for it.
  return reading.status ? fmt::format("{}nan ", letter)
                        : fmt::format("{}{} ", letter, reading.number);
}

bool isSame(const opcua::Reading& one, const opcua::Reading& other) {
  return one.status == other.status && one.number == other.number && one.text == other.text;
}

}  // namespace

ServerSource::ServerSource(std::string name, ServerMap map)
    : m_name(std::move(name)), m_map(std::move(map)) {
  m_variables.push_back(m_map.has(kLineVariable) ? kLineVariable : kNumberVariable);
  for (const Word& word : kWords) {
    if (m_map.has(word.variable)) {
      m_variables.push_back(word.variable);
    }
  }
}

Result<std::unique_ptr<live::Source>> ServerSource::open(const std::string& path) {
  auto map = readServerMap(path);
  if (!map) {
    return base::fail(map.error());
  }
  if (!map->request.user.empty()) {
    auto password = trust::givenPassword(map->passwordFile);
    if (!password) {
      return base::fail(password.error());
    }
    map->request.password = password->value_or(std::string());
  }
  std::unique_ptr<ServerSource> source(new ServerSource("opcua:" + path, std::move(*map)));
  if (Result<void> connected = source->connect(); !connected) {
    return base::fail(connected.error());
  }
  return std::unique_ptr<live::Source>(std::move(source));
}

Result<void> ServerSource::connect() {
  m_connection = {};
  opcua::Attempt attempt = trust::connect(m_map.request);
  if (!attempt.connection) {
    base::Error error = attempt.connection.error();
    if (error.code == opcua::LinkError::CertificateUnknown) {
      error.message += " To accept it, write its fingerprint into the file of the source.";
    }
    return tl::unexpected(std::move(error));
  }
  m_connection = std::move(*attempt.connection);
  return readOld();
}

Result<void> ServerSource::readOld() {
  auto readings = opcua::readNow(*m_connection.link, m_variables, kAnswerMax);
  if (!readings) {
    return base::fail(readings.error());
  }
  for (std::size_t i = 0; i < readings->size(); ++i) {
    // A number that has not been set yet is no reason to refuse the source.
    if (const std::error_code& status = (*readings)[i].status;
        status && status != opcua::LinkError::BadValue) {
      return base::fail(live::LiveError::NotOpened,
                        fmt::format("The server cannot read {}: {} Check the address of the node.",
                                    m_map.request.nodes.at(m_variables[i]), status.message()),
                        m_name);
    }
  }
  m_seen = std::move(readings->front());
  return {};
}

/// The server may have ended a session that nobody used between two runs.
Result<void> ServerSource::prepare() {
  m_asked.reset();
  m_text.clear();
  m_isClosed = false;
  return m_connection && readOld() ? Result<void>() : connect();
}

std::size_t ServerSource::read(std::span<char> into) {
  if (m_text.empty() && !m_isClosed) {
    serve();
  }
  const std::size_t count = std::min(into.size(), m_text.size());
  std::copy_n(m_text.begin(), count, into.begin());
  m_text.erase(0, count);
  return count;
}

void ServerSource::serve() {
  opcua::Link& link = *m_connection.link;
  while (const auto event = link.wait(link.now())) {
    if (event->kind == opcua::EventKind::ConnectionLost) {
      m_isClosed = true;
      return;
    }
    if (event->request == m_asked) {
      m_asked.reset();
      if (event->kind == opcua::EventKind::ReadDone) {
        take(event->readings);
      }
    }
  }
  if (!m_asked && m_text.empty()) {
    m_asked = link.read(m_variables, kAnswerMax, opcua::Grouping::List);
  }
}

void ServerSource::take(const std::vector<opcua::Reading>& readings) {
  if (m_seen && isSame(*m_seen, readings.front())) {
    return;
  }
  m_seen = readings.front();
  m_text = lineOf(readings) + "\n";
}

std::string ServerSource::lineOf(const std::vector<opcua::Reading>& readings) const {
  const opcua::Reading& news = readings.front();
  if (m_map.has(kLineVariable)) {
    return news.status ? news.status.message() : news.text;
  }
  if (!news.status && news.number < 0.0) {
    return "end";
  }
  std::string line = wordOf('N', news);
  std::size_t next = 1;
  for (const Word& word : kWords) {
    if (m_map.has(word.variable)) {
      line += wordOf(word.letter, readings[next++]);
    }
  }
  return line;
}

void ServerSource::tell(const live::Progress& progress) {
  std::vector<opcua::Assignment> values;
  if (m_map.has(kAcceptedVariable)) {
    values.push_back({kAcceptedVariable, static_cast<double>(progress.accepted + progress.merged)});
  }
  if (m_map.has(kExecutedVariable)) {
    values.push_back({kExecutedVariable, static_cast<double>(progress.executed)});
  }
  if (!values.empty() && !m_isClosed) {
    m_connection.link->write(values, kAnswerMax, opcua::Grouping::List);
  }
}

}  // namespace rivulet::sources
