// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "journal/alarm_history.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "journal/line_file.h"

namespace rivulet::journal {

using alarm::Alarm;
using alarm::Transition;
using nlohmann::ordered_json;

namespace {

ordered_json jsonOf(const Transition& transition) {
  const Alarm& alarm = transition.alarm;
  ordered_json json{{"at", base::utcText(transition.at)},
                    {"event", alarm::eventName(transition.event)},
                    {"state", alarm::stateName(alarm.state())},
                    {"alarm", alarm::factsOf(alarm.code).name},
                    {"arguments", alarm.arguments},
                    {"raised_at", base::utcText(alarm.raisedAt)}};
  if (!transition.by.empty()) {
    json["by"] = transition.by;
  }
  if (alarm.error.code) {
    json["error"] = {{"kind", alarm.error.code.category().name()},
                     {"code", alarm.error.code.value()},
                     {"message", alarm.error.message},
                     {"context", alarm.error.context}};
  }
  if (alarm.shelving) {
    json["shelved_until"] = base::utcText(alarm.shelving->until);
  }
  // For people who read the file; programs take code and arguments.
  json["text"] = alarm::describe(alarm);
  return json;
}

std::optional<Transition> transitionOf(const std::string& line,
                                       const AlarmHistory::CodeOf& codeOf) {
  const ordered_json json = ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) {
    return std::nullopt;
  }
  const auto at = base::utcOfText(textOf(json, "at"));
  const auto raisedAt = base::utcOfText(textOf(json, "raised_at"));
  const auto event = alarm::eventOfName(textOf(json, "event"));
  const auto state = alarm::stateOfName(textOf(json, "state"));
  const auto code = alarm::codeOfName(textOf(json, "alarm"));
  if (!at || !raisedAt || !event || !state || !code) {
    return std::nullopt;
  }
  Transition transition{*at, *event, {}, textOf(json, "by")};
  Alarm& alarm = transition.alarm;
  alarm.code = *code;
  alarm.raisedAt = *raisedAt;
  const auto arguments = json.find("arguments");
  for (const ordered_json& argument :
       arguments == json.end() ? ordered_json::array() : *arguments) {
    alarm.arguments.push_back(argument.is_string() ? argument.get<std::string>() : "");
  }
  alarm.isActive = *state == alarm::State::Unacknowledged || *state == alarm::State::Acknowledged;
  alarm.isAcknowledged = *state == alarm::State::Normal || *state == alarm::State::Acknowledged;
  if (const auto until = base::utcOfText(textOf(json, "shelved_until"))) {
    alarm.shelving = alarm::Shelving{*until, transition.by};
  }
  if (const auto error = json.find("error"); error != json.end() && error->is_object()) {
    const ordered_json value = error->value("code", ordered_json());
    alarm.error = base::makeError(codeOf && value.is_number_integer()
                                      ? codeOf(textOf(*error, "kind"), value.get<int>())
                                      : std::error_code(),
                                  textOf(*error, "message"), textOf(*error, "context"));
  }
  return transition;
}

}  // namespace

AlarmHistory::AlarmHistory(std::filesystem::path folder)
    : m_path(folder.empty() ? std::move(folder) : folder / "alarms.jsonl") {
}

base::Result<void> AlarmHistory::append(const Transition& transition) const {
  // Names of files may hold bytes that are not UTF-8.
  const std::string line =
      jsonOf(transition).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return appendLine(
      m_path, [&line](std::string_view) { return line; }, kFileBytesMax);
}

base::Result<AlarmHistory::Content> AlarmHistory::read(const CodeOf& codeOf) const {
  Content content;
  std::filesystem::path older = m_path;
  older += ".1";
  for (const std::filesystem::path& path : {older, m_path}) {
    const base::Result<Lines> lines = readLines(path);
    if (!lines) {
      return base::fail(lines.error());
    }
    content.dropped += lines->isCut ? 1 : 0;
    for (const std::string& line : lines->lines) {
      if (auto transition = transitionOf(line, codeOf)) {
        content.transitions.push_back(std::move(*transition));
      } else {
        ++content.dropped;
      }
    }
  }
  return content;
}

std::vector<Alarm> unacknowledged(const std::vector<Transition>& transitions) {
  std::map<std::pair<alarm::Code, std::string>, const Transition*> last;
  for (const Transition& transition : transitions) {
    last[{transition.alarm.code, transition.alarm.subject()}] = &transition;
  }
  std::vector<Alarm> alarms;
  for (const auto& [key, transition] : last) {
    if (!transition->alarm.isAcknowledged) {
      alarms.push_back(transition->alarm);
    }
  }
  std::sort(alarms.begin(), alarms.end(),
            [](const Alarm& a, const Alarm& b) { return a.raisedAt < b.raisedAt; });
  return alarms;
}

}  // namespace rivulet::journal
