// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hmi/releases.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/audit.h"
#include "journal/line_file.h"
#include "utc/now.h"
#include "widgets/common/error_text.h"

namespace rivulet::hmi {

using nlohmann::ordered_json;
using permission::Act;
using permission::Release;

namespace {

std::string textOf(const Audit::Details& details) {
  std::string text;
  for (const auto& [name, value] : details) {
    text += (text.empty() ? "" : ";") + name + "=" + value;
  }
  return text;
}

Audit::Details detailsOf(const std::string& text) {
  Audit::Details details;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    const std::size_t sign = item.find('=');
    if (sign != std::string::npos) {
      details.emplace_back(item.substr(0, sign), item.substr(sign + 1));
    }
    begin = end + 1;
  }
  return details;
}

std::string member(const ordered_json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<Release> releaseOfLine(const std::string& line) {
  const ordered_json json = ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  const auto at = base::utcOfText(member(json, "at"));
  Release release{{member(json, "hash"), member(json, "settings"), member(json, "calibration")},
                  member(json, "program"),
                  member(json, "by"),
                  at.value_or(0),
                  json.contains("taken_back")};
  return at && !release.job.programHash.empty() ? std::optional(release) : std::nullopt;
}

std::string lineOf(const Release& release) {
  ordered_json json{{"at", base::utcText(release.at)},  {"by", release.by},
                    {"program", release.programName},   {"hash", release.job.programHash},
                    {"settings", release.job.settings}, {"calibration", release.job.calibration}};
  if (release.isTakenBack) {
    json["taken_back"] = true;
  }
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

Releases::Releases(const std::filesystem::path& folder, Users& users, Document& document,
                   MachineModel& machine, Messages& messages)
    : m_path(folder.empty() ? folder : folder / "releases.jsonl"),
      m_users(users),
      m_document(document),
      m_machine(machine),
      m_messages(messages) {
  if (!m_path.empty()) {
    load(m_path);
  }
  connect(&m_document, &Document::programLoaded, this, &Releases::takeSettings);
  connect(&m_users, &Users::changed, this, &Releases::takeSettings);
  connect(&m_document, &Document::judged, this, &Releases::changed);
}

void Releases::load(const std::filesystem::path& path) {
  const auto lines = journal::readLines(path);
  if (!lines) {
    m_messages.log(gcode::Severity::Warning, Messages::Source::Computer,
                   [error = lines.error()] { return widgets::errorText(error); });
    return;
  }
  for (const std::string& line : lines->lines) {
    if (auto release = releaseOfLine(line)) {
      m_releases.push_back(std::move(*release));
    }
  }
}

std::optional<permission::Job> Releases::job() const {
  const auto program = m_document.program();
  if (!program) {
    return std::nullopt;
  }
  const widgets::AccessSource& source = m_document.findings().source;
  return permission::Job{
      program->hash, textOf(settingsFacts(m_document.settings())),
      source.isUsed() ? source.record->endpoint + " " + source.record->measuredAtUtc : ""};
}

const Release* Releases::release() const {
  const auto present = job();
  return present ? permission::releaseOf(m_releases, *present) : nullptr;
}

void Releases::give() {
  const auto present = job();
  if (!present || m_users.refusal(Act::Release)) {
    return;
  }
  append({*present, m_document.program()->name, m_users.name().toStdString(), utc::now(), false});
  m_messages.didAct(Act::Release, {{"program", m_document.program()->name},
                                   {"hash", present->programHash},
                                   {"settings", present->settings},
                                   {"calibration", present->calibration}});
}

void Releases::takeBack() {
  const Release* present = release();
  if (present == nullptr || m_users.refusal(Act::TakeBackRelease)) {
    return;
  }
  Release back = *present;
  back.by = m_users.name().toStdString();
  back.at = utc::now();
  back.isTakenBack = true;
  m_messages.didAct(Act::TakeBackRelease,
                    {{"program", back.programName}, {"hash", back.job.programHash}});
  append(std::move(back));
}

void Releases::append(Release release) {
  if (!m_path.empty()) {
    const auto written =
        journal::appendLine(m_path, [&release](std::string_view) { return lineOf(release); });
    if (!written) {
      m_messages.show(gcode::Severity::Error,
                      [error = written.error()] { return widgets::errorText(error); });
      return;
    }
  }
  m_releases.push_back(std::move(release));
  Q_EMIT changed();
}

void Releases::takeSettings() {
  const auto present = job();
  if (present && m_users.standing().role == permission::Role::Operator && !isReleased()) {
    if (const Release* last = permission::lastReleaseOf(m_releases, present->programHash)) {
      widgets::StreamSettings settings = m_document.settings();
      applySettings(settings, detailsOf(last->job.settings));
      m_document.setSettings(settings);
    }
  }
  Q_EMIT changed();
}

}  // namespace rivulet::hmi
