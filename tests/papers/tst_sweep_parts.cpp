// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Experiments in parts: what is put together is what one computer makes of it, to the last digit.

#include <QtTest>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/share.h"
#include "papers/catalogue.h"
#include "report/experiments/experiment_report.h"
#include "report/sweep_part.h"
#include "support/test_program.h"

using namespace rivulet;
using base::Share;
using base::ShareError;
using base::ShareExecutor;
using base::ShareNumbers;
using report::SweepPart;
using report::SweepPartError;

namespace {

base::Result<papers::Experiment> run(const std::string& name, base::Executor& executor) {
  return papers::runExperiment(name, {*machine::loadPreset("dmu75"), 1, executor, {}});
}

void square(std::size_t index, std::span<double> results) {
  results[0] = static_cast<double>(index * index);
  results[1] = index == 3 ? std::numeric_limits<double>::infinity() : 1.0 / 3.0;
}

std::vector<ShareNumbers> sharesOf(std::size_t jobs, std::size_t of) {
  std::vector<ShareNumbers> shares;
  for (std::size_t number = 1; number <= of; ++number) {
    base::SerialExecutor serial;
    ShareExecutor executor(serial, {number, of});
    const auto none = executor.numbersOf(jobs, 2, square);
    if (!none && executor.numbers()) {
      shares.push_back(*executor.numbers());
    }
  }
  return shares;
}

SweepPart throughFile(const SweepPart& part) {
  const auto read = report::sweepPartOf(report::sweepPartText(part), "part.json");
  return read ? *read : SweepPart{};
}

}  // namespace

class TestSweepParts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachJobIsInOneShare_data() {
    QTest::addColumn<int>("jobs");
    QTest::addColumn<int>("of");
    QTest::newRow("as many") << 3 << 3;
    QTest::newRow("no even share") << 10 << 4;
    QTest::newRow("more shares than jobs") << 2 << 5;
    QTest::newRow("no job") << 0 << 2;
    QTest::newRow("one share") << 7 << 1;
  }
  void eachJobIsInOneShare() {
    QFETCH(int, jobs);
    QFETCH(int, of);
    base::SerialExecutor serial;
    const auto count = static_cast<std::size_t>(jobs);
    const auto whole = serial.numbersOf(count, 2, square);
    const auto merged = base::merged(sharesOf(count, static_cast<std::size_t>(of)));
    QVERIFY(merged);
    QVERIFY(merged->numbers == *whole);
  }

  void whatDoesNotFitIsNamed() {
    const std::vector<ShareNumbers> shares = sharesOf(10, 3);
    const auto missing = base::merged(std::vector{shares[2], shares[0]});
    QVERIFY(!missing && missing.error().code == ShareError::Missing);
    QVERIFY(missing.error().message.find("Part 2 of 3 is missing") != std::string::npos);
    const auto twice = base::merged(std::vector{shares[0], shares[1], shares[1]});
    QVERIFY(!twice && twice.error().code == ShareError::Missing);
    QVERIFY(twice.error().message.find("twice") != std::string::npos);
    const auto unlike = base::merged(std::vector{shares[0], sharesOf(11, 3)[1], shares[2]});
    QVERIFY(!unlike && unlike.error().code == ShareError::Unlike);
    std::vector<ShareNumbers> cut = shares;
    cut[1].numbers.pop_back();
    QVERIFY(base::merged(cut).error().code == ShareError::Unlike);
    QVERIFY(base::merged({}).error().code == ShareError::Missing);
  }

  void filesKeepEveryDigit() {
    const SweepPart part{{"0.1.0", "delta", 4, "dmu75", ""}, sharesOf(10, 3)[0]};
    const SweepPart read = throughFile(part);
    QVERIFY(read.origin == part.origin);
    QVERIFY(read.numbers.numbers == part.numbers.numbers);
    QCOMPARE(read.numbers.share.number, part.numbers.share.number);
    QCOMPARE(read.numbers.jobs, part.numbers.jobs);
  }

  void damagedFilesAreRefused() {
    const std::string text =
        report::sweepPartText({{"0.1.0", "delta", 4, "dmu75", ""}, sharesOf(10, 3)[0]});
    const auto refuses = [](const std::string& damaged) {
      const auto read = report::sweepPartOf(damaged, "part.json");
      return !read && read.error().code == SweepPartError::Unreadable &&
             read.error().text().starts_with("part.json: ");
    };
    for (std::size_t length = 0; length + 2 < text.size(); ++length) {
      QVERIFY2(refuses(text.substr(0, length)), std::to_string(length).c_str());
    }
    nlohmann::json json = nlohmann::json::parse(text);
    json["numbers"][2] = "many";
    QVERIFY(refuses(json.dump()));
    QVERIFY(refuses("[]"));
  }

  void partsOfOtherOptionsAreRefused() {
    const std::vector<ShareNumbers> shares = sharesOf(10, 2);
    const SweepPart one{{"0.1.0", "delta", 4, "dmu75", ""}, shares[0]};
    SweepPart other{one.origin, shares[1]};
    QVERIFY(report::mergedParts({one, other}));
    other.origin.seeds = 5;
    const auto merged = report::mergedParts({one, other});
    QVERIFY(!merged && merged.error().code == SweepPartError::Unlike);
    QVERIFY(merged.error().message.find("4 and 5 seeds") != std::string::npos);
  }

  void mergedPartsAreTheWhole() {
    base::SerialExecutor serial;
    const auto whole = run("delta", serial);
    QVERIFY(whole);
    std::vector<ShareNumbers> shares;
    for (std::size_t number = 1; number <= 3; ++number) {
      ShareExecutor executor(serial, {number, 3});
      const auto part = run("delta", executor);
      QVERIFY(!part && part.error().code == papers::ExperimentError::OnlyShare);
      shares.push_back(throughFile({{"", "delta", 1, "", ""}, *executor.numbers()}).numbers);
    }
    auto numbers = base::merged(shares);
    QVERIFY(numbers);
    base::MergedExecutor executor(serial, std::move(*numbers));
    const auto merged = run("delta", executor);
    QVERIFY(merged && executor.didFit());
    QCOMPARE(report::experimentText(*merged), report::experimentText(*whole));
    QCOMPARE(report::experimentJson(*merged).dump(), report::experimentJson(*whole).dump());
  }

  /// Every experiment that says so, with jobs that are not done.
  void sharesOfAllEndWithoutAResult() {
    struct Idle final : base::Executor {
      void forEach(std::size_t, const std::function<void(std::size_t)>&) override {}
    };
    for (const std::string& name : papers::shareableExperiments()) {
      Idle idle;
      ShareExecutor executor(idle, {2, 3});
      const auto part = run(name, executor);
      QVERIFY2(!part && part.error().code == papers::ExperimentError::OnlyShare, name.c_str());
      QVERIFY(executor.numbers()->jobs > 10);
    }
  }

  void otherNumbersDoNotFit() {
    base::SerialExecutor serial;
    base::MergedExecutor executor(serial, *base::merged(sharesOf(10, 2)));
    const auto merged = run("delta", executor);
    QVERIFY(!merged && !executor.didFit());
  }
};

RIVULET_TEST(TestSweepParts)
#include "tst_sweep_parts.moc"
