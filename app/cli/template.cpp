// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/file.h"
#include "cli/commands.h"
#include "machine/config.h"
#include "platform/log.h"
#include "streaming/simulation/template_proof.h"
#include "templates/flexible_program.h"
#include "templates/lint/lint.h"

namespace rivulet::cli {

namespace {

using streaming::ProofCase;
using streaming::TemplateProof;
using templates::LintFinding;
using templates::LintSeverity;

std::string_view severityOf(const LintFinding& finding) {
  return finding.severity == LintSeverity::Error ? "error" : "warning";
}

nlohmann::ordered_json jsonOf(const TemplateProof& proof, bool verified) {
  auto findings = nlohmann::ordered_json::array();
  for (const LintFinding& finding : proof.findings) {
    findings.push_back({{"severity", severityOf(finding)},
                        {"line", finding.line.value},
                        {"code", templates::lintRuleName(finding.rule)},
                        {"message", finding.message}});
  }
  nlohmann::ordered_json json{{"findings", findings}};
  if (verified) {
    auto cases = nlohmann::ordered_json::array();
    for (const ProofCase& one : proof.cases) {
      cases.push_back({{"name", one.name},
                       {"required", one.isRequired},
                       {"runs", one.runs},
                       {"failures", one.failures},
                       {"message", one.message}});
    }
    json["cases"] = cases;
  }
  return json;
}

/// For people; on standard error if standard output holds the program.
void print(std::FILE* out, const TemplateProof& proof, bool verified, bool sound) {
  for (const LintFinding& finding : proof.findings) {
    fmt::print(out, "line {}: {}: {} [{}]\n", finding.line.value, severityOf(finding),
               finding.message, templates::lintRuleName(finding.rule));
  }
  for (const ProofCase& one : proof.cases) {
    const char* verdict = one.holds() ? "holds" : one.isRequired ? "FAILS" : "not promised";
    fmt::print(out, "{}: {}, {} of {} runs right{}{}\n", one.name, verdict, one.runs - one.failures,
               one.runs, one.message.empty() ? "" : ": ", one.message);
  }
  const char* good = verified ? "The program passes." : "No errors found.";
  fmt::print(out, "{}\n", sound ? good : "The program must not be run.");
}

/// The lint alone, or together with the runs of the proof.
base::Result<TemplateProof> lookAt(const std::string& text, const templates::FlexibleProgram& meant,
                                   const TemplateOptions& options) {
  if (options.verify) {
    const auto machine = machine::loadPreset(options.preset);
    if (!machine) {
      return base::fail(machine.error());
    }
    return streaming::proveTemplate(text, meant, *machine);
  }
  return TemplateProof{templates::lintProgram(text, meant), {}};
}

bool isSound(const TemplateProof& proof, bool verified) {
  return verified ? proof.holds() : templates::firstError(proof.findings) == nullptr;
}

/// A program from a file, maybe written by hand.
Exit lintFile(const templates::FlexibleProgram& meant, const TemplateOptions& options) {
  const base::Result<std::string> text = base::readFile(options.lint, memoryBudget());
  if (!text) {
    return reportError(text.error(), options.json);
  }
  const base::Result<TemplateProof> proof = lookAt(*text, meant, options);
  if (!proof) {
    return reportError(proof.error(), options.json);
  }
  const bool sound = isSound(*proof, options.verify);
  if (options.json) {
    nlohmann::ordered_json json{{"file", options.lint}, {"sound", sound}};
    json.update(jsonOf(*proof, options.verify));
    printJson(json);
  } else {
    print(stdout, *proof, options.verify, sound);
  }
  return sound ? Exit::Done : Exit::Wrong;
}

nlohmann::ordered_json jsonOf(const templates::CellMap& cells, base::MethodKind method) {
  nlohmann::ordered_json numbers;
  if (base::hasWindows(method)) {
    numbers = {{"run", cells.run},
               {"delivered", cells.delivered},
               {"latched", cells.latched},
               {"executed", cells.executed},
               {"layout", cells.layout},
               {"state", cells.state},
               {"client", cells.client},
               {"owner", cells.owner},
               {"heartbeat", cells.heartbeat},
               {"windows", cells.windows}};
    if (cells.hasFeedCell()) {
      numbers["override"] = cells.overrideWanted;
      numbers["override_acts"] = cells.overrideActs;
      numbers["silence_limit_s"] = cells.silenceLimitS;
    }
    if (cells.hasFactor()) {
      numbers["factor"] = cells.factor;
    }
    if (cells.files > 0) {
      numbers["asked"] = cells.asked;
    } else {
      numbers["first_window"] = cells.windowCount(0);
      numbers["window_stride"] = cells.windowStride;
      numbers["slot_stride"] = cells.slotStride;
      numbers["packed"] = cells.packed;
    }
    if (cells.corrects()) {
      numbers["correction"] = cells.correction;
    }
  } else {
    numbers = {{"signal", cells.signal},
               {"run", cells.run},
               {"stop", cells.stop},
               {"feed", cells.feed},
               {"layout", cells.layout},
               {"first_slot", cells.firstSlot},
               {"slot_stride", cells.slotStride}};
  }
  return numbers;
}

}  // namespace

Exit makeTemplate(const TemplateOptions& options) {
  templates::TemplateParameters parameters = options.point.parameters();
  parameters.rParameterCount = options.rParameterCount;
  const auto program = templates::makeProgram(parameters);
  if (!program) {
    return reportError(program.error(), options.json);
  }
  if (!options.lint.empty()) {
    return lintFile(*program, options);
  }
  const templates::CellMap& cells = program->cells;
  std::optional<TemplateProof> proof;
  if (options.verify) {
    base::Result<TemplateProof> seen = lookAt(program->text, *program, options);
    if (!seen) {
      return reportError(seen.error(), options.json);
    }
    proof = std::move(*seen);
  }
  const bool sound = !proof || isSound(*proof, true);
  if (!options.output.empty() && sound) {
    if (const auto written = base::writeFile(options.output, program->text); !written) {
      return reportError(written.error(), options.json);
    }
  }
  if (options.json) {
    nlohmann::ordered_json json{{"name", program->name},
                                {"layout_number", program->layoutNumber},
                                {"r_parameters", cells.last() + 1},
                                {"cells", jsonOf(cells, parameters.method)},
                                {"file", options.output},
                                {"text", program->text}};
    if (proof) {
      json["sound"] = sound;
      json["verdict"] = jsonOf(*proof, true);
    }
    printJson(json);
  } else if (options.output.empty()) {
    fmt::print("{}", program->text);
  }
  if (proof && !options.json) {
    print(options.output.empty() ? stderr : stdout, *proof, true, sound);
  }
  return sound ? Exit::Done : Exit::Wrong;
}

}  // namespace rivulet::cli
