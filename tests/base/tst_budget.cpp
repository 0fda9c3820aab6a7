// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <filesystem>
#include <limits>

#include "base/budget.h"
#include "base/file.h"
#include "support/test_program.h"

using rivulet::base::Budget;
using rivulet::base::BudgetError;

class TestBudget : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsHeldIsNotLeft() {
    const Budget budget(1000);
    QCOMPARE(budget.without(400).left(), std::uint64_t{600});
    QCOMPARE(budget.without(400).without(400).left(), std::uint64_t{200});
    QCOMPARE(budget.without(1001).left(), std::uint64_t{0});
    QCOMPARE(budget.left(), std::uint64_t{1000});
    QCOMPARE(budget.items(300), std::size_t{3});
    QCOMPARE(Budget().left(), Budget::kUsualBytes);
  }

  /// Any amount can be asked for, also one that no integer holds.
  void moreThanThereIsIsRefused() {
    const Budget budget(1000);
    QVERIFY(budget.require(1000.0, "A list").has_value());
    for (const double bytes : {1001.0, 1e300, std::numeric_limits<double>::infinity()}) {
      const auto refused = budget.require(bytes, "A list");
      QVERIFY(!refused && refused.error().code == BudgetError::Exceeded);
    }
  }

  /// A list that is full is there twice while it moves.
  void aListThatGrowsIsCountedTwice() {
    std::vector<int> list;
    list.reserve(4);
    list.assign(1, 1);
    QCOMPARE(Budget::bytesOf(list), 2 * sizeof(int));  // what is reserved is not there yet
    list.assign(3, 1);
    QCOMPARE(Budget::bytesOf(list), 4 * sizeof(int));
    QCOMPARE(Budget::bytesOf(list, 2), 6 * sizeof(int));
    list.assign(4, 1);
    QCOMPARE(Budget::bytesOf(list), 8 * sizeof(int));
  }

  /// One sentence: what, how much, and what to do.
  void theSentenceNamesTheOption() {
    const Budget budget = Budget(2'000'000'000).without(1'000'000'000);
    QCOMPARE(budget.require(12.3e9, "A table").error().message,
             std::string("A table would take 12.3 GB of memory, and 2 GB may be taken. Give a "
                         "smaller one, or allow more with rivulet-cli --memory-limit."));
    QCOMPARE(budget.exceeded("The net").message,
             std::string("The net would take more than 2 GB of memory. Give a smaller one, or "
                         "allow more with rivulet-cli --memory-limit."));
    // It is not larger than the whole, but than what is left.
    QVERIFY(budget.require(1.5e9, "A table").error().message.find("more than 2 GB") !=
            std::string::npos);
  }

  void aFileIsReadWithinIt() {
    using rivulet::base::readFile;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "rivulet-tst-budget";
    QVERIFY(rivulet::base::writeFile(file, std::string(1000, ' ')).has_value());
    QVERIFY(readFile(file, Budget(1000)).has_value());
    const auto refused = readFile(file, Budget(999));
    std::filesystem::remove(file);
    QVERIFY(!refused && refused.error().code == BudgetError::Exceeded);
    QCOMPARE(refused.error().context, file.string());
    // A device has no size and no end.
    const auto endless = readFile("/dev/zero", Budget(1'000'000));
    QVERIFY(!endless && endless.error().code == BudgetError::Exceeded);
  }
};

RIVULET_TEST(TestBudget)

#include "tst_budget.moc"
