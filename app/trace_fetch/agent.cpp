// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_fetch/agent.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "trace/import/mtconnect.h"

namespace rivulet::trace_fetch {

namespace {

/// An agent that forgets more often than that while it is read is never caught up with.
constexpr int kLostMax = 20;

/// Reads one agent once.
class AgentReader {
 public:
  AgentReader(const AgentAddress& address, HttpReader& http, RecordingTime* time,
              const base::Budget& budget)
      : m_address(address), m_http(http), m_time(time), m_budget(budget) {}

  [[nodiscard]] base::Result<std::string> read();

 private:
  struct Answer {
    std::string text;
    trace::MtconnectHeader header;
    std::string url;
  };

  /// @param query  begins with "?", or is empty
  [[nodiscard]] base::Result<Answer> ask(std::string_view request, const std::string& query);
  /// A refusal is an error. @param document  that is expected
  [[nodiscard]] base::Result<Answer> require(std::string_view request, const std::string& query,
                                             std::string_view document);
  [[nodiscard]] std::string queryOf(const std::string& parameters) const;
  [[nodiscard]] static base::Error refusalOf(const Answer& answer);
  [[nodiscard]] base::Result<void> keep(const Answer& answer);
  [[nodiscard]] base::Result<void> keepState(std::uint64_t at);
  [[nodiscard]] base::Result<void> readPages(const trace::MtconnectHeader& atStart);
  /// The oldest sequence number, after the agent has forgotten `next`.
  [[nodiscard]] base::Result<std::uint64_t> catchUp(const Answer& refusal, std::uint64_t next);

  const AgentAddress& m_address;
  HttpReader& m_http;
  RecordingTime* m_time;
  const base::Budget& m_budget;
  std::string m_text;
  int m_lost = 0;
};

std::string AgentReader::queryOf(const std::string& parameters) const {
  const std::string path = m_address.path.empty() ? "" : "path=" + m_address.path;
  const std::string both = path + (path.empty() || parameters.empty() ? "" : "&") + parameters;
  return both.empty() ? "" : "?" + both;
}

base::Result<AgentReader::Answer> AgentReader::ask(std::string_view request,
                                                   const std::string& query) {
  Answer answer;
  answer.url = fmt::format("{}/{}{}", m_address.base, request, query);
  auto text = m_http.get(answer.url);
  if (!text) {
    return base::fail(text.error());
  }
  auto header = trace::readMtconnectHeader(*text);
  if (!header) {
    return base::fail(FetchError::WrongAnswer,
                      "What answers there is no MTConnect agent. Check address and port.",
                      answer.url);
  }
  answer.text = std::move(*text);
  answer.header = std::move(*header);
  return answer;
}

base::Error AgentReader::refusalOf(const Answer& answer) {
  const auto read = trace::readMtconnect(answer.text, base::Budget());
  return read ? base::makeError(FetchError::WrongAnswer, "The agent refuses without an error.",
                                answer.url)
              : base::makeError(read.error().code, read.error().message, answer.url);
}

base::Result<AgentReader::Answer> AgentReader::require(std::string_view request,
                                                       const std::string& query,
                                                       std::string_view document) {
  auto answer = ask(request, query);
  if (!answer || answer->header.document == document) {
    return answer;
  }
  if (answer->header.document == "MTConnectError") {
    return base::fail(refusalOf(*answer));
  }
  return base::fail(FetchError::WrongAnswer,
                    fmt::format("The agent answers with {} instead of {}. Check the address.",
                                answer->header.document, document),
                    answer->url);
}

base::Result<void> AgentReader::keep(const Answer& answer) {
  if (auto fits = m_budget.require(2.0 * static_cast<double>(m_text.size() + answer.text.size()),
                                   "What the agent has kept");
      !fits) {
    return base::fail(fits.error().code,
                      fits.error().message + " Ask for less with from=SEQUENCE or path=XPATH.",
                      answer.url);
  }
  m_text += answer.text;
  m_text += '\n';
  return {};
}

/// How the items stood when an observation was made. An agent that does not know is no obstacle:
/// each item begins with its first value then.
base::Result<void> AgentReader::keepState(std::uint64_t at) {
  auto state = ask("current", queryOf(fmt::format("at={}", at)));
  if (!state) {
    return base::fail(state.error());
  }
  return state->header.document == "MTConnectStreams" ? keep(*state) : base::Result<void>();
}

base::Result<std::uint64_t> AgentReader::catchUp(const Answer& refusal, std::uint64_t next) {
  const auto now = require("current", queryOf({}), "MTConnectStreams");
  if (!now) {
    return base::fail(now.error());
  }
  const std::uint64_t oldest = now->header.firstSequence;
  const bool isForgotten = oldest > next && ++m_lost <= kLostMax;
  if (isForgotten) {
    if (auto done = keepState(oldest); !done) {
      return base::fail(done.error());
    }
    return oldest;
  }
  return base::fail(m_lost > kLostMax
                        ? base::makeError(FetchError::WrongAnswer,
                                          "The agent forgets faster than it can be read. Ask for "
                                          "less with path=XPATH, or give it a larger buffer.",
                                          refusal.url)
                        : refusalOf(refusal));
}

base::Result<void> AgentReader::readPages(const trace::MtconnectHeader& atStart) {
  std::uint64_t next = m_address.from.value_or(atStart.firstSequence);
  const std::uint64_t buffer = atStart.bufferSize;
  const std::uint64_t count = buffer > 0 ? std::min(m_address.count, buffer) : m_address.count;
  for (bool isFirst = true;; isFirst = false) {
    const auto page = ask("sample", queryOf(fmt::format("from={}&count={}", next, count)));
    if (!page) {
      return base::fail(page.error());
    }
    if (page->header.document != "MTConnectStreams") {
      if (isFirst && m_address.from) {
        return base::fail(refusalOf(*page));
      }
      const auto oldest = catchUp(*page, next);
      if (!oldest) {
        return base::fail(oldest.error());
      }
      next = *oldest;
      continue;
    }
    if (auto done = keep(*page); !done) {
      return base::fail(done.error());
    }
    const std::uint64_t after = page->header.nextSequence;
    if (after == 0) {
      return base::fail(FetchError::WrongAnswer,
                        "The agent does not say the nextSequence of a page.", page->url);
    }
    if (page->header.instanceId != atStart.instanceId) {
      return {};  // it was started again, and counts from the beginning
    }
    const bool isRecording = m_time != nullptr && !m_time->isOver();
    if (!isRecording && (after <= next || after > atStart.lastSequence)) {
      return {};
    }
    if (after <= next || after > page->header.lastSequence) {
      m_time->wait();
    }
    next = std::max(next, after);
  }
}

base::Result<std::string> AgentReader::read() {
  const auto described = require("probe", {}, "MTConnectDevices");
  if (!described) {
    return base::fail(described.error());
  }
  if (auto done = keep(*described); !done) {
    return base::fail(done.error());
  }
  const auto now = require("current", queryOf({}), "MTConnectStreams");
  if (!now) {
    return base::fail(now.error());
  }
  if (auto done = keepState(m_address.from.value_or(now->header.firstSequence)); !done) {
    return base::fail(done.error());
  }
  if (auto done = readPages(now->header); !done) {
    return base::fail(done.error());
  }
  return std::move(m_text);
}

}  // namespace

bool isAgentAddress(std::string_view text) {
  return text.starts_with("http://") || text.starts_with("https://");
}

base::Result<AgentAddress> parseAgentAddress(std::string_view text) {
  const auto wrong = [text](std::string message) {
    return base::fail(FetchError::BadAddress, std::move(message), std::string(text));
  };
  AgentAddress address;
  text = text.substr(0, text.find('#'));
  const std::size_t question = std::min(text.find('?'), text.size());
  std::string_view base = text.substr(0, question);
  const std::size_t host = base.find("//") + 2;
  const std::string_view authority = base.substr(host, base.find('/', host) - host);
  if (authority.empty()) {
    return wrong("The address names no host. Write http://HOST:PORT.");
  }
  if (authority.find('@') != std::string_view::npos) {
    return wrong("A user or password in an address stays in lists and logs: it is not used.");
  }
  while (base.ends_with('/')) {
    base.remove_suffix(1);
  }
  for (const std::string_view request : {"/probe", "/current", "/sample"}) {
    if (base.size() > host + request.size() && base.ends_with(request)) {
      base.remove_suffix(request.size());
      break;
    }
  }
  address.base = base;
  std::string_view query = text.substr(std::min(question + 1, text.size()));
  while (!query.empty()) {
    const std::string_view item = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(item.size() + 1, query.size()));
    const std::size_t equal = std::min(item.find('='), item.size());
    const std::string_view name = item.substr(0, equal);
    const std::string_view value = item.substr(std::min(equal + 1, item.size()));
    const auto number = trace::mtconnectNumber(value);
    if (name == "path" && !value.empty()) {
      address.path = value;
    } else if (name == "from" && number) {
      address.from = *number;
    } else if (name == "count" && number && *number > 0) {
      address.count = *number;
    } else {
      return wrong(
          fmt::format("\"{}\" is no parameter that is used: they are path=XPATH, "
                      "from=SEQUENCE and count=OBSERVATIONS of a page.",
                      item));
    }
  }
  return address;
}

base::Result<std::string> fetchFromAgent(const AgentAddress& address, HttpReader& http,
                                         RecordingTime* time, const base::Budget& budget) {
  return AgentReader(address, http, time, budget).read();
}

}  // namespace rivulet::trace_fetch
