// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef RIVULET_TEST_HDF5
#include <hdf5.h>
#endif

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "base/budget.h"
#include "base/file.h"
#include "base/random.h"
#include "support/test_program.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/hdf5.h"
#include "trace/import/import.h"
#include "trace/import/import_error.h"
#include "trace/signal_file.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

const base::Instant kStart = base::Instant::min();
const base::Instant kEnd = base::Instant::max() - base::Duration{1};

base::Instant at(double seconds) {
  return base::Instant{base::fromSeconds(seconds)};
}

std::shared_ptr<const Envelope> samples(int count, double stepS, double (*value)(int)) {
  auto envelope = std::make_shared<Envelope>();
  for (int i = 0; i < count; ++i) {
    envelope->append(at(stepS * i), i == 3 ? std::nan("") : value(i));
  }
  return envelope;
}

bool isSame(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

const std::vector<ExportedSignal>& exported() {
  static const std::vector<ExportedSignal> kExported{
      {"x_act", "mm", samples(40000, 0.004, [](int i) { return std::sin(0.01 * i) / 3.0; })},
      {"load/1", "%", samples(900, 0.02, [](int i) { return 1e-7 * i; })},
      {"y_act", "µm", samples(40000, 0.004, [](int i) { return 2.0 * i; })}};
  return kExported;
}

const std::vector<SignalEvent>& events() {
  static const std::vector<SignalEvent> kEvents{{at(0.5), at(0.75), "hold", "the override was 0"},
                                                {at(1.0), at(1.0), "note", "Größe „1“"},
                                                {at(500.0), at(501.0), "note", "after the end"}};
  return kEvents;
}

std::string printed() {
  return *printHdf5(exported(), events(), at(0.0), at(200.0), "t", "s");
}

const Hdf5Row* rowOf(const Hdf5Content& content, std::string_view path) {
  const auto found = std::find_if(content.rows.begin(), content.rows.end(),
                                  [path](const Hdf5Row& row) { return row.path() == path; });
  return found == content.rows.end() ? nullptr : &*found;
}

std::string remarks(const std::vector<Remark>& list) {
  std::string text;
  for (const Remark& remark : list) {
    text += (text.empty() ? "" : "\n") + remarkText(remark);
  }
  return text;
}

/// "t[s] x[mm] | t2[ms] load": each time base with its signals.
std::string structureOf(const SignalTrace& trace) {
  std::string text;
  for (std::size_t base = 0; base < trace.timeBases.size(); ++base) {
    text += (base == 0 ? "" : " | ") + trace.timeBases[base].name;
    for (const Signal& signal : trace.signalList) {
      if (signal.timeBase == base) {
        text += " " + signal.name + (signal.unit.empty() ? "" : "[" + signal.unit + "]");
      }
    }
  }
  return text;
}

#ifdef RIVULET_TEST_HDF5

/// A file as other programs write it: with the library itself, plainly.
class OtherFile {
 public:
  explicit OtherFile(hsize_t userBlock = 0) {
    const hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(creation, userBlock);
    m_path = m_folder.filePath(QStringLiteral("other.h5")).toStdString();
    m_file = H5Fcreate(m_path.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT);
    H5Pclose(creation);
  }
  void group(const char* path) { H5Gclose(H5Gcreate2(m_file, path, 0, 0, 0)); }
  template <class Value>
  void row(const char* path, hid_t type, const std::vector<Value>& values, const char* unit = "",
           std::vector<hsize_t> sizes = {}, hsize_t chunk = 0) {
    sizes = sizes.empty() ? std::vector<hsize_t>{values.size()} : sizes;
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    if (chunk > 0) {
      H5Pset_chunk(creation, 1, &chunk);
    }
    const hid_t dataset = H5Dcreate2(m_file, path, type, space, 0, creation, 0);
    H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, 0, values.data());
    if (*unit != '\0') {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, std::strlen(unit));
      H5Tset_strpad(text, H5T_STR_NULLPAD);
      const hid_t scalar = H5Screate(H5S_SCALAR);
      const hid_t attribute = H5Acreate2(dataset, "units", text, scalar, 0, 0);
      H5Awrite(attribute, text, unit);
      H5Aclose(attribute);
      H5Sclose(scalar);
      H5Tclose(text);
    }
    H5Dclose(dataset);
    H5Pclose(creation);
    H5Sclose(space);
  }
  void emptyRow(const char* path, hsize_t size) {
    const hid_t space = H5Screate_simple(1, &size, nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_alloc_time(creation, H5D_ALLOC_TIME_LATE);
    H5Dclose(H5Dcreate2(m_file, path, H5T_IEEE_F64LE, space, 0, creation, 0));
    H5Pclose(creation);
    H5Sclose(space);
  }
  void linkOut(const char* path, const char* file) {
    H5Lcreate_external(file, "/t", m_file, path, 0, 0);
  }
  void linkHard(const char* from, const char* to) {
    H5Lcreate_hard(m_file, from, m_file, to, 0, 0);
  }
  [[nodiscard]] std::string bytes() {
    if (m_file >= 0) {
      H5Fclose(m_file);
      m_file = -1;
    }
    return *base::readFile(m_path);
  }
  [[nodiscard]] QString folder() const { return m_folder.path(); }

 private:
  QTemporaryDir m_folder;
  std::string m_path;
  hid_t m_file = -1;
};

std::vector<double> ramp(std::size_t count, double step) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(step * static_cast<double>(i));
  }
  return values;
}

#endif

}  // namespace

class TestHdf5 : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void saysThatItIsMissing() {
    if (hasHdf5()) {
      QSKIP("built with HDF5");
    }
    std::string bytes("\x89HDF\r\n\x1a\n", 8);
    const auto imported = importTrace(bytes + std::string(600, '\0'));
    QVERIFY(!imported);
    QVERIFY(imported.error().code == ImportError::NoHdf5);
    const auto written = printHdf5(exported(), events(), kStart, kEnd, "t", "s");
    QVERIFY(!written && written.error().code == ImportError::NoHdf5);
  }

#ifdef RIVULET_TEST_HDF5
  /// Without loss: values, gaps, times, units, names with signs that HDF5 does not allow, events.
  void isReadBack() {
    const std::string bytes = printed();
    QVERIFY(isHdf5(bytes));
    QVERIFY2(bytes.size() < 8 * (2 * 40000 + 900) * 3 / 4,
             qPrintable(QString::number(bytes.size())));
    const auto content = readHdf5(bytes);
    QVERIFY(content);
    QVERIFY2(content->remarks.empty(), remarks(content->remarks).c_str());
    QVERIFY(content->events == std::vector<SignalEvent>(events().begin(), events().begin() + 2));
    const auto imported = importTrace(bytes);
    QVERIFY(imported);
    QCOMPARE(imported->trace.format, std::string("HDF5"));
    QCOMPARE(structureOf(imported->trace),
             std::string("signals_1/t load/1[%] | signals_2/t x_act[mm] y_act[µm]"));
    QCOMPARE(printColumnRoles(imported->columns),
             std::string("time=signals_1/t:s,time=signals_2/t:s,x_act=x_act:mm,y_act=y_act:µm"));
    QCOMPARE(imported->trace.events.size(), std::size_t{2});
    for (const ExportedSignal& one : exported()) {
      const auto found =
          std::find_if(imported->trace.signalList.begin(), imported->trace.signalList.end(),
                       [&](const Signal& signal) { return signal.name == one.name; });
      QVERIFY2(found != imported->trace.signalList.end(), one.name.c_str());
      QCOMPARE(found->values.size(), one.samples->size());
      for (std::size_t i = 0; i < found->values.size(); ++i) {
        QVERIFY(isSame(found->values[i], one.samples->valueAt(i)));
        QCOMPARE(imported->trace.timeBases[found->timeBase].at[i], one.samples->timeAt(i));
      }
    }
  }

  void writesWhatIsBetween() {
    const auto content = readHdf5(*printHdf5(exported(), events(), at(0.4), at(0.6), "t", "s"));
    QVERIFY(content);
    const Hdf5Row* time = rowOf(*content, "signals_2/t");
    QVERIFY(time != nullptr && time->values.size() == 51);
    QVERIFY(std::abs(time->values.front() - 0.4) < 1e-12);
    QVERIFY(std::abs(time->values.back() - 0.6) < 1e-12);
    QCOMPARE(content->events.size(), std::size_t{1});
  }

  /// A stop whose cause the samples do not show has it again.
  void keepsCausesOfStops() {
    auto x = std::make_shared<Envelope>();
    double mm = 0.0;
    for (int i = 0; i < 100; ++i) {
      mm += i >= 40 && i < 60 ? 0.0 : 0.04;
      x->append(at(0.004 * i), mm);
    }
    const std::vector<SignalEvent> said{{at(0.16), at(0.24), "preprocessor stop", "line 7 has one"},
                                        {at(0.3), at(0.3), "note", "the end is near"}};
    const auto imported =
        importTrace(*printHdf5({{"x_set", "mm", x}}, said, kStart, kEnd, "t", "s"));
    QVERIFY(imported);
    const Trace trace(*imported);
    const TraceAnalysis analysis = analyseTrace(trace);
    QCOMPARE(analysis.stops.size(), std::size_t{1});
    QCOMPARE(stopCauseName(analysis.stops[0].cause), std::string_view("preprocessor stop"));
    QCOMPARE(analysis.stops[0].evidence, std::string("line 7 has one"));
    const ShownTrace shown = makeShownTrace(trace, analysis);
    QCOMPARE(shown.events.size(), std::size_t{2});
    QCOMPARE(shown.events[1].text, std::string("the end is near"));
  }

  /// Samples that do not move have no line of the program: that signal has fewer samples, and so
  /// comes first in the file.
  void keepsTheLineOnTheControl() {
    auto x = std::make_shared<Envelope>();
    auto onControl = std::make_shared<Envelope>();
    auto ofProgram = std::make_shared<Envelope>();
    for (int i = 0; i < 100; ++i) {
      x->append(at(0.004 * i), 0.04 * i);
      onControl->append(at(0.004 * i), 20.0 + i % 5);
      if (i > 10) {
        ofProgram->append(at(0.004 * i), 3.0);
      }
    }
    const auto imported = importTrace(
        *printHdf5({{"x_set", "mm", x}, {"program_line", "", ofProgram}, {"line", "", onControl}},
                   {}, kStart, kEnd, "t", "s"));
    QVERIFY(imported);
    const Trace trace(*imported);
    const TraceAnalysis analysis = analyseTrace(trace);
    QVERIFY(analysis.motion.hasLine);
    QCOMPARE(analysis.motion.samples[53].line, 23U);
    const ShownTrace shown = makeShownTrace(trace, analysis);
    QCOMPARE(valueAt(*shown.signalSet.find("line")->samples, at(0.004 * 53)), 23.0);
    QCOMPARE(valueAt(*shown.signalSet.find("program_line")->samples, at(0.004 * 53)), 3.0);
  }

  void readsOtherPeoplesFiles() {
    OtherFile file;
    file.group("/axes");
    file.group("/axes/x");
    file.group("/slow");
    std::vector<std::int64_t> counts;
    for (int i = 0; i < 500; ++i) {
      counts.push_back(4 * i);
    }
    file.row("/Zeitstempel", H5T_NATIVE_INT64, counts, "ms");
    file.row("/axes/x/actual", H5T_NATIVE_FLOAT, std::vector<float>(500, 1.5F), "mm");
    file.row("/axes/x/set", H5T_NATIVE_DOUBLE, ramp(500, 0.25), "mm", {500, 1});
    file.row("/power", H5T_NATIVE_INT16, std::vector<std::int16_t>(500, -7));
    file.row("/slow/time_s", H5T_NATIVE_DOUBLE, ramp(20, 0.1));
    file.row("/slow/temperature", H5T_NATIVE_DOUBLE, ramp(20, 0.5), "°C");
    file.row("/picture", H5T_NATIVE_DOUBLE, std::vector<double>(600, 1.0), "", {20, 30});
    file.row("/odd", H5T_NATIVE_DOUBLE, ramp(7, 1.0));
    file.linkOut("/elsewhere", "/nowhere/other.h5");
    const auto imported = importTrace(file.bytes());
    QVERIFY(imported);
    const SignalTrace& trace = imported->trace;
    QCOMPARE(structureOf(trace),
             std::string("Zeitstempel power actual[mm] set[mm] | time_s temperature[°C]"));
    QCOMPARE(remarks(trace.remarks),
             std::string("Datasets that are no row of numbers and were left out: 1, the first "
                         "\"picture\".\nDatasets to whose length no time belongs and that were "
                         "left out: 1, the first \"odd\".\nThe file has 2 columns of time; each "
                         "belongs to the columns after it."));
    QCOMPARE(trace.timeBases[0].at[499] - trace.timeBases[0].at[0],
             base::Duration{std::chrono::milliseconds{1996}});
    QCOMPARE(trace.signalList[0].values[499], -7.0);
    QCOMPARE(trace.signalList[1].values[499], 1.5);
    QCOMPARE(trace.signalList[2].values[499], 124.75);
    // What it means can be said, as of a table.
    const auto mapped =
        importTrace(file.bytes(), *parseTableMapping("x_act=actual,x_set=set,guess=no"));
    QVERIFY(mapped);
    QCOMPARE(motionOf(*mapped).samples.size(), std::size_t{500});
    QVERIFY(motionOf(*mapped).hasSet);
  }

  /// MATLAB puts a block of its own before the file.
  void readsBehindAUserBlock() {
    OtherFile file(512);
    file.row("/t", H5T_NATIVE_DOUBLE, ramp(100, 0.001));
    file.row("/x_act", H5T_NATIVE_DOUBLE, ramp(100, 1.0), "", {1, 100});
    const auto imported = importTrace(file.bytes());
    QVERIFY(imported);
    QCOMPARE(structureOf(imported->trace), std::string("t x_act"));
    QCOMPARE(imported->trace.signalList[0].values[99], 99.0);
  }

  void takesARateWithoutTime() {
    OtherFile file;
    file.row("/x_act", H5T_NATIVE_DOUBLE, ramp(100, 1.0));
    file.row("/y_act", H5T_NATIVE_DOUBLE, ramp(90, 1.0));
    const auto imported = importTrace(file.bytes(), *parseTableMapping("rate=500"));
    QVERIFY(imported);
    QCOMPARE(imported->trace.timeBases[0].at[50], at(0.1));
    QCOMPARE(imported->trace.signalList[1].values[89], 89.0);
    QVERIFY(std::isnan(imported->trace.signalList[1].values[90]));
  }

  /// Of a file that was cut off, values are right or missing, never wrong. A plain file loses what
  /// lies behind the cut, no more.
  void readsWhatIsLeft_data() {
    QTest::addColumn<QString>("kind");
    for (const char* kind : {"ours", "plain", "chunks"}) {
      QTest::newRow(kind) << QString(kind);
    }
  }
  void readsWhatIsLeft() {
    QFETCH(QString, kind);
    std::string bytes;
    if (kind == QStringLiteral("ours")) {
      bytes = printed();
    } else {
      OtherFile file;
      const hsize_t chunk = kind == QStringLiteral("chunks") ? 1000 : 0;
      for (const char* path : {"/t", "/x_act", "/y_act"}) {
        file.row(path, H5T_NATIVE_DOUBLE, ramp(20000, 0.5), "", {}, chunk);
      }
      bytes = file.bytes();
    }
    const auto whole = readHdf5(bytes);
    QVERIFY(whole);
    std::size_t read = 0;
    std::size_t refused = 0;
    std::size_t kept = 0;
    for (std::size_t part = 1; part < 40; ++part) {
      const auto content = readHdf5(std::string_view(bytes).substr(0, bytes.size() * part / 40));
      if (!content) {
        ++refused;
        QVERIFY(content.error().code == ImportError::NotATable);
        QVERIFY(content.error().message.find("cut off") != std::string::npos);
        continue;
      }
      ++read;
      QVERIFY(remarks(content->remarks).find("cut off") != std::string::npos);
      for (const Hdf5Row& row : content->rows) {
        const Hdf5Row* all = rowOf(*whole, row.path());
        QVERIFY2(all != nullptr, row.path().c_str());
        QVERIFY(row.values.size() <= all->values.size());
        for (std::size_t i = 0; i < row.values.size(); ++i) {
          QVERIFY(std::isnan(row.values[i]) || row.values[i] == all->values[i]);
          kept += static_cast<std::size_t>(!std::isnan(row.values[i]));
        }
      }
    }
    qInfo("%s: %zu bytes, cut at 39 places: %zu read, %zu refused, %zu values", qPrintable(kind),
          bytes.size(), read, refused, kept);
    if (kind == QStringLiteral("plain")) {
      QVERIFY(read > 35);
    }
  }

  /// Damaged in single bytes: read, or refused with a sentence. Checksums find damaged values of
  /// our own files.
  void survivesDamage() {
    const std::string bytes = *printHdf5(exported(), events(), at(0.0), at(16.0), "t", "s");
    const auto whole = readHdf5(bytes);
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
      base::Random random(seed);
      std::string damaged = bytes;
      for (std::uint64_t flips = 1 + random.below(8); flips > 0; --flips) {
        damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      }
      const auto content = readHdf5(damaged);
      if (!content) {
        QVERIFY(content.error().code == ImportError::NotATable);
        continue;
      }
      for (const Hdf5Row& row : content->rows) {
        const Hdf5Row* all = rowOf(*whole, row.path());
        std::size_t wrong = 0;
        for (std::size_t i = 0; all != nullptr && i < row.values.size(); ++i) {
          wrong += static_cast<std::size_t>(!std::isnan(row.values[i]) &&
                                            row.values[i] != all->values[i]);
        }
        QVERIFY2(wrong == 0, qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(wrong)));
      }
    }
  }

  /// Rubbish after the signature, links in a circle, more values than any memory holds.
  void refusesNonsense() {
    std::string rubbish("\x89HDF\r\n\x1a\n", 8);
    base::Random random(1);
    for (int i = 0; i < 5000; ++i) {
      rubbish += static_cast<char>(random.below(256));
    }
    QVERIFY(!importTrace(rubbish));
    QVERIFY(!importTrace(rubbish.substr(0, 8)));
    OtherFile file;
    file.group("/a");
    file.linkHard("/a", "/a/again");
    file.row("/t", H5T_NATIVE_DOUBLE, ramp(100, 0.001));
    file.row("/x_act", H5T_NATIVE_DOUBLE, ramp(100, 1.0));
    const auto imported = importTrace(file.bytes());
    QVERIFY(imported);
    QCOMPARE(structureOf(imported->trace), std::string("t x_act"));
    OtherFile large;
    large.row("/t", H5T_NATIVE_DOUBLE, ramp(100, 0.001));
    large.emptyRow("/huge", hsize_t{1} << 50U);
    const auto huge = importTrace(large.bytes());
    QVERIFY(!huge);
    QVERIFY2(huge.error().code == base::BudgetError::Exceeded, huge.error().text().c_str());
    OtherFile empty;
    const auto none = importTrace(empty.bytes());
    QVERIFY(!none && none.error().code == ImportError::NotATable);
  }
#endif
};

RIVULET_TEST(TestHdf5)
#include "tst_hdf5.moc"
