// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <curl/curl.h>
#include <fmt/format.h>

#include "trace_fetch/http.h"

namespace rivulet::trace_fetch {

namespace {

struct Cleanup {
  void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
};

/// What has come of an answer.
struct Body {
  std::string bytes;
  std::uint64_t bytesMax = 0;
  bool isTooLarge = false;
};

// Called by C: nothing may be thrown through it.
std::size_t append(const char* data, std::size_t size, std::size_t count, void* body) noexcept {
  auto& to = *static_cast<Body*>(body);
  if (to.bytes.size() + size * count > to.bytesMax) {
    to.isTooLarge = true;
    return 0;
  }
  to.bytes.append(data, size * count);
  return size * count;
}

class CurlReader final : public HttpReader {
 public:
  explicit CurlReader(const HttpLimits& limits) : m_limits(limits), m_handle(curl_easy_init()) {}

  [[nodiscard]] base::Result<std::string> get(const std::string& url) override;

 private:
  [[nodiscard]] base::Error errorOf(CURLcode code, const Body& body, const std::string& url) const;

  HttpLimits m_limits;
  std::unique_ptr<CURL, Cleanup> m_handle;
};

long secondsOf(base::Duration duration) {
  return static_cast<long>(std::chrono::ceil<std::chrono::seconds>(duration).count());
}

base::Result<std::string> CurlReader::get(const std::string& url) {
  Body body;
  body.bytesMax = m_limits.bytesMax;
  CURL* handle = m_handle.get();
  if (handle == nullptr) {
    return base::fail(FetchError::NoHttp, "The library for HTTP cannot be started.", url);
  }
  const auto connectMs = std::chrono::ceil<std::chrono::milliseconds>(m_limits.connectMax).count();
  const auto answerMs = std::chrono::ceil<std::chrono::milliseconds>(m_limits.answerMax).count();
  curl_easy_setopt(handle, CURLOPT_URL, url.c_str());
  curl_easy_setopt(handle, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(handle, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(handle, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(handle, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(connectMs));
  curl_easy_setopt(handle, CURLOPT_TIMEOUT_MS, static_cast<long>(answerMs));
  curl_easy_setopt(handle, CURLOPT_LOW_SPEED_LIMIT, 100L);
  curl_easy_setopt(handle, CURLOPT_LOW_SPEED_TIME, secondsOf(m_limits.silenceMax));
  curl_easy_setopt(handle, CURLOPT_USERAGENT, "rivulet");
  curl_easy_setopt(handle, CURLOPT_WRITEFUNCTION, &append);
  curl_easy_setopt(handle, CURLOPT_WRITEDATA, &body);
  const CURLcode code = curl_easy_perform(handle);
  if (code != CURLE_OK) {
    return base::fail(errorOf(code, body, url));
  }
  long status = 0;
  curl_easy_getinfo(handle, CURLINFO_RESPONSE_CODE, &status);
  // An agent refuses with a status of 400 or more and an XML that says why.
  const bool isXml = body.bytes.find("<MTConnect") != std::string::npos ||
                     body.bytes.find(":MTConnect") != std::string::npos;
  if (status != 200 && !isXml) {
    return base::fail(FetchError::WrongAnswer,
                      fmt::format("The server answers with HTTP status {} instead of a document. "
                                  "Check the address.",
                                  status),
                      url);
  }
  return std::move(body.bytes);
}

base::Error CurlReader::errorOf(CURLcode code, const Body& body, const std::string& url) const {
  if (body.isTooLarge) {
    return base::makeError(FetchError::TooLarge,
                           fmt::format("The answer has more than {} MB and was not read to its "
                                       "end. Ask for less with count=NUMBER or path=XPATH.",
                                       m_limits.bytesMax / 1'000'000),
                           url);
  }
  switch (code) {
    case CURLE_COULDNT_RESOLVE_HOST:
      return base::makeError(FetchError::NotReachable,
                             "There is no host of this name. Check the address.", url);
    case CURLE_COULDNT_CONNECT:
      return base::makeError(
          FetchError::NotReachable,
          "Nothing answers there. Check address and port, and that the agent runs.", url);
    case CURLE_OPERATION_TIMEDOUT:
      return base::makeError(FetchError::TimedOut,
                             "The server does not answer in time. Check that the agent runs.", url);
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_URL_MALFORMAT:
      return base::makeError(FetchError::BadAddress,
                             "This is no address of an agent. Write http://HOST:PORT.", url);
    default:
      return base::makeError(
          FetchError::WrongAnswer,
          fmt::format("The answer cannot be read: {}.", curl_easy_strerror(code)), url);
  }
}

}  // namespace

base::Result<std::unique_ptr<HttpReader>> makeHttpReader(const HttpLimits& limits) {
  static const CURLcode started = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (started != CURLE_OK) {
    return base::fail(FetchError::NoHttp, "The library for HTTP cannot be started.");
  }
  return std::make_unique<CurlReader>(limits);
}

}  // namespace rivulet::trace_fetch
