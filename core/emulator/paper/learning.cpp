// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "emulator/paper/learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "base/contract.h"
#include "base/sha256.h"
#include "base/text.h"
#include "emulator/emulator_error.h"

namespace rivulet::emulator::paper {

namespace {

constexpr std::string_view kHeading = "# rivulet emulator learning 1";
/// The paper asks for p > 0. A parameter is never less than this share of its nominal value: some
/// are divisors.
constexpr double kLeastShare = 1e-3;

/// Digest of what the scores and the drawn numbers depend on.
std::string digestOf(const Course& course, const LearnSettings& settings,
                     const std::vector<int>& varied) {
  std::string text = fmt::format("{} {}", course.stepS, course.firstScored);
  const auto add = [&text](const std::vector<double>& values) {
    fmt::format_to(std::back_inserter(text), "\n{}", fmt::join(values, " "));
  };
  for (std::size_t axis : {kAxisX, kAxisY}) {
    add(course.referenceMm[axis]);
    add(course.observedMm[axis]);
    add(course.observedMmPerS[axis]);
  }
  for (const CoursePoint& point : course.points) {
    fmt::format_to(std::back_inserter(text), " {}", point.atS);
  }
  const PlantSettings& plant = settings.plant;
  add({settings.lambda, plant.speedFeedback, plant.currentFeedback, plant.currentDisturbance,
       plant.powerDelayS, plant.backEmf, plant.electronicsGain, plant.electronicsDecay,
       plant.motorGain, plant.motorDecay, plant.stepS, double(plant.feedbackDelaySteps)});
  const GeneticSettings& genetic = settings.genetic;
  fmt::format_to(std::back_inserter(text), "\n{} {} {} {}\n{}", genetic.populationSize,
                 genetic.eliteShare, genetic.crossoverShare, genetic.seed, fmt::join(varied, " "));
  return base::sha256Hex(text);
}

std::vector<Gene> genesOf(const std::vector<int>& varied) {
  std::vector<Gene> genes;
  for (const int index : varied) {
    const ParameterInfo& info = parameterTable()[static_cast<std::size_t>(index - 1)];
    genes.push_back({kLeastShare * info.nominal, info.startLow, info.startHigh});
  }
  return genes;
}

std::vector<double> pick(const Parameters& values, const std::vector<int>& varied) {
  std::vector<double> picked;
  for (const int index : varied) {
    picked.push_back(parameter(values, index));
  }
  return picked;
}

Parameters merge(Parameters values, const std::vector<int>& varied,
                 const std::vector<double>& genes) {
  for (std::size_t i = 0; i < varied.size(); ++i) {
    values[static_cast<std::size_t>(varied[i] - 1)] = genes[i];
  }
  return values;
}

/// Scores candidates on the executor and keeps each as a trial.
EvaluateAll trialsOn(const Course& course, const LearnSettings& settings, base::Executor& executor,
                     const int& generation, Learning& learning) {
  const Parameters fixed = learning.values;
  return [&course, &settings, &executor, &generation, &learning, fixed](
             std::span<const std::vector<double>> candidates, std::span<double> scores) {
    const std::size_t first = learning.trials.size();
    learning.trials.resize(first + candidates.size());
    executor.forEach(candidates.size(), [&](std::size_t i) {
      const Parameters values = merge(fixed, learning.varied, candidates[i]);
      const Emulation emulation = emulate(course, values, settings.plant);
      scores[i] = misfitOf(course, emulation).objective(settings.lambda);
      learning.trials[first + i] = {generation, scores[i], values};
    });
  };
}

void takeState(const Genetic& genetic, Learning& learning) {
  learning.state = genetic.state();
  learning.values = merge(learning.values, learning.varied, genetic.best().genes);
  learning.bestEach.push_back(genetic.best().score);
}

base::Result<void> requireSpeeds(const Course& course, double lambda) {
  if (lambda > 0.0 &&
      (course.observedMmPerS[kAxisX].empty() || course.observedMmPerS[kAxisY].empty())) {
    return base::fail(EmulatorError::BadNumbers,
                      "This run has no actual speeds of X and Y: learn with lambda 0, or record "
                      "the speeds too.",
                      course.name);
  }
  return {};
}

base::Result<Learning> run(const OnGeneration& onGeneration, Genetic genetic, int& generation,
                           Learning& learning) {
  bool goOn = !onGeneration || onGeneration(learning);
  while (goOn && !genetic.done()) {
    generation = genetic.state().generation + 1;
    genetic.step();
    takeState(genetic, learning);
    goOn = !onGeneration || onGeneration(learning);
  }
  if (genetic.done() && learning.objective() >= kDivergedObjective) {
    return base::fail(EmulatorError::Diverged,
                      fmt::format("Each of {} candidates ran away from the set points: check the "
                                  "settings of the drive, or learn with another seed.",
                                  learning.trials.size()),
                      learning.design);
  }
  return std::move(learning);
}

/// The population of the last generation: its own trials, and the best of all earlier ones.
std::vector<Individual> lastPopulation(const Learning& learning, std::size_t elite) {
  std::vector<const Trial*> earlier;
  std::vector<const Trial*> last;
  for (const Trial& trial : learning.trials) {
    (trial.generation < learning.state.generation ? earlier : last).push_back(&trial);
  }
  std::ranges::stable_sort(earlier, {}, &Trial::objective);
  earlier.resize(std::min(earlier.size(), elite));
  earlier.insert(earlier.end(), last.begin(), last.end());
  std::vector<Individual> population;
  for (const Trial* trial : earlier) {
    population.push_back({pick(trial->values, learning.varied), trial->objective});
  }
  return population;
}

}  // namespace

base::Result<Learning> learn(const Course& course, const LearnSettings& settings,
                             base::Executor& executor, const OnGeneration& onGeneration,
                             std::optional<Learning> from) {
  if (auto speeds = requireSpeeds(course, settings.lambda); !speeds) {
    return base::fail(speeds.error());
  }
  int generation = 0;
  if (from) {
    Learning learning = std::move(*from);
    learning.state.population = lastPopulation(learning, eliteCount(settings.genetic));
    if (learning.course != digestOf(course, settings, learning.varied) ||
        learning.state.population.size() != settings.genetic.populationSize) {
      return base::fail(EmulatorError::BadFile,
                        "The saved learning run belongs to other data or other settings: continue "
                        "it with those, or start a new one.",
                        course.name);
    }
    Genetic genetic(settings.genetic, genesOf(learning.varied),
                    trialsOn(course, settings, executor, generation, learning), learning.state);
    return run(onGeneration, std::move(genetic), generation, learning);
  }
  Learning learning;
  learning.design = course.name;
  learning.varied.resize(kParameterCount);
  std::iota(learning.varied.begin(), learning.varied.end(), 1);
  learning.values = nominalParameters();
  learning.course = digestOf(course, settings, learning.varied);
  const std::vector<Gene> genes = genesOf(learning.varied);
  Genetic genetic(settings.genetic, genes,
                  trialsOn(course, settings, executor, generation, learning),
                  drawPopulation(settings.genetic, genes));
  takeState(genetic, learning);
  return run(onGeneration, std::move(genetic), generation, learning);
}

base::Result<Learning> refine(const Course& course, const LearnSettings& settings,
                              base::Executor& executor, const Learning& learned,
                              std::vector<int> indices, const OnGeneration& onGeneration) {
  if (auto speeds = requireSpeeds(course, settings.lambda); !speeds) {
    return base::fail(speeds.error());
  }
  RIVULET_ASSERT(learned.state.population.size() == settings.genetic.populationSize);
  std::ranges::sort(indices);
  Learning learning;
  learning.design = course.name;
  learning.varied = std::move(indices);
  learning.values = learned.values;
  learning.course = digestOf(course, settings, learning.varied);
  std::vector<std::vector<double>> first;
  for (const Individual& one : learned.state.population) {
    first.push_back(pick(merge(learned.values, learned.varied, one.genes), learning.varied));
  }
  int generation = 0;
  Genetic genetic(settings.genetic, genesOf(learning.varied),
                  trialsOn(course, settings, executor, generation, learning), std::move(first));
  takeState(genetic, learning);
  return run(onGeneration, std::move(genetic), generation, learning);
}

std::string learningText(const Learning& learning) {
  std::string text = fmt::format(
      "{}\n# design = {}\n# course = {}\n# varied = {}\n# step = {}\ngeneration,Q", kHeading,
      learning.design, learning.course, fmt::join(learning.varied, " "), learning.state.stepSize);
  for (const ParameterInfo& info : parameterTable()) {
    fmt::format_to(std::back_inserter(text), ",p{}", info.index);
  }
  text += '\n';
  for (const Trial& trial : learning.trials) {
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", trial.generation, trial.objective,
                   fmt::join(trial.values, ","));
  }
  return text;
}

namespace {

/// Lines of a text, one after another.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : m_rest(text) {}
  [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
  [[nodiscard]] std::string_view next() { return cut('\n', m_rest); }

  static std::string_view cut(char separator, std::string_view& rest) {
    const std::size_t end = rest.find(separator);
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return part;
  }

 private:
  std::string_view m_rest;
};

std::optional<Trial> parseTrial(std::string_view line) {
  Trial trial;
  const auto generation = base::parseInteger(TextLines::cut(',', line));
  const auto objective = base::parseNumber(TextLines::cut(',', line));
  if (!generation || *generation < 0 || !objective) {
    return std::nullopt;
  }
  trial.generation = *generation;
  trial.objective = *objective;
  for (double& value : trial.values) {
    const auto parsed = base::parseNumber(TextLines::cut(',', line));
    if (!parsed) {
      return std::nullopt;
    }
    value = *parsed;
  }
  return line.empty() ? std::optional(trial) : std::nullopt;
}

bool parseVaried(std::string_view text, std::vector<int>& varied) {
  while (!text.empty()) {
    const auto index = base::parseInteger(TextLines::cut(' ', text));
    if (!index || *index <= (varied.empty() ? 0 : varied.back()) ||
        *index > static_cast<int>(kParameterCount)) {
      return false;
    }
    varied.push_back(*index);
  }
  return !varied.empty();
}

/// "# key = value". @return false for a value that cannot be
bool parseEntry(std::string_view line, Learning& learning) {
  const std::string_view key = base::trim(TextLines::cut('=', line)).substr(1);
  const std::string_view value = base::trim(line);
  if (base::trim(key) == "design") {
    learning.design = value;
  } else if (base::trim(key) == "course") {
    learning.course = value;
  } else if (base::trim(key) == "varied") {
    return parseVaried(value, learning.varied);
  } else if (base::trim(key) == "step") {
    const auto step = base::parseNumber(value);
    learning.state.stepSize = step.value_or(0.0);
    return step && *step > 0.0 && *step <= 1.0;
  }
  return true;
}

}  // namespace

base::Result<Learning> parseLearning(std::string_view text) {
  TextLines lines(text);
  if (lines.next() != kHeading) {
    return base::fail(
        EmulatorError::BadFile,
        fmt::format("This is no saved learning run: its first line is not \"{}\".", kHeading));
  }
  Learning learning;
  int number = 1;
  while (!lines.atEnd()) {
    const std::string_view line = lines.next();
    ++number;
    if (line.starts_with("generation,")) {
      continue;
    }
    bool good = false;
    if (line.starts_with('#')) {
      good = parseEntry(line, learning);
    } else if (const auto trial = parseTrial(line)) {
      const int last = learning.trials.empty() ? 0 : learning.trials.back().generation;
      good = trial->generation == last || trial->generation == last + 1;
      learning.trials.push_back(*trial);
    }
    if (!good) {
      return base::fail(EmulatorError::BadFile,
                        fmt::format("Line {} of the saved learning run cannot be read: take an "
                                    "earlier copy, or start again.",
                                    number));
    }
  }
  if (learning.trials.empty() || learning.varied.empty()) {
    return base::fail(EmulatorError::BadFile,
                      "The saved learning run is not complete: take an earlier copy, or start "
                      "again.");
  }
  learning.state.generation = learning.trials.back().generation;
  const Trial* best = &learning.trials.front();
  for (const Trial& trial : learning.trials) {
    if (trial.objective < best->objective) {
      best = &trial;
    }
    learning.bestEach.resize(static_cast<std::size_t>(trial.generation) + 1, best->objective);
    learning.bestEach.back() = best->objective;
  }
  learning.values = best->values;
  return learning;
}

}  // namespace rivulet::emulator::paper
