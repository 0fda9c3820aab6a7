// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// Small inputs that stand for much more memory than a computer has. Each is refused with one
/// sentence that names the option, before it takes a fifth more than it may. What a program takes
/// is what was resident of it at most, as the system counts it.

#include <fmt/format.h>

#ifdef RIVULET_TEST_HDF5
#include <hdf5.h>
#endif

#include <QDeadlineTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "base/budget.h"
#include "base/file.h"
#include "support/patience.h"
#include "support/test_program.h"
#include "trace/frames.h"
#include "trace/import/compression.h"

using namespace rivulet;

namespace {

constexpr std::size_t kLimit = 400'000'000;

std::string repeated(std::string_view text, std::size_t count) {
  std::string all;
  all.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) {
    all += text;
  }
  return all;
}

/// A gigabyte and a half of this text, in as many frames; each is packed once.
std::string archive(std::string_view head, std::string_view line) {
  constexpr std::size_t kFrame = 16'000'000;
  constexpr std::size_t kFrames = 96;
  const std::string frame = trace::pack(repeated(line, kFrame / line.size()), 3);
  return (head.empty() ? std::string() : trace::pack(head, 3)) + repeated(frame, kFrames);
}

std::string recording(std::string_view line) {
  return archive("rivulet-recording 1\nrun method=\"window\"\n", line);
}

#ifdef RIVULET_TEST_HDF5
/// A gigabyte and a half of zeros, each chunk packed alike. @return the file, which is not there
/// any more
std::string packedHdf5() {
  constexpr hsize_t kChunk = 1'000'000;
  constexpr hsize_t kChunks = 190;
  const QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("a.h5")).toStdString();
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t made = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(made, 1, &kChunk);
  H5Pset_deflate(made, 9);
  const hsize_t size = kChunk * kChunks;
  const hid_t space = H5Screate_simple(1, &size, nullptr);
  const hid_t set =
      H5Dcreate2(file, "x_act", H5T_IEEE_F64LE, space, H5P_DEFAULT, made, H5P_DEFAULT);
  const hsize_t begin = 0;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &begin, nullptr, &kChunk, nullptr);
  const hid_t memory = H5Screate_simple(1, &kChunk, nullptr);
  const std::vector<double> zeros(kChunk);
  bool isMade = H5Dwrite(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, zeros.data()) >= 0;
  hsize_t bytes = 0;
  isMade = isMade && H5Dget_chunk_storage_size(set, &begin, &bytes) >= 0;
  std::vector<char> packed(bytes);
  std::uint32_t filters = 0;
  isMade = isMade && H5Dread_chunk(set, H5P_DEFAULT, &begin, &filters, packed.data()) >= 0;
  for (hsize_t chunk = 1; isMade && chunk < kChunks; ++chunk) {
    const hsize_t at = chunk * kChunk;
    isMade = H5Dwrite_chunk(set, H5P_DEFAULT, filters, &at, packed.size(), packed.data()) >= 0;
  }
  H5Sclose(memory);
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(made);
  H5Fclose(file);
  const auto text = base::readFile(path);
  if (!isMade || !text) {
    qFatal("the HDF5 file cannot be made");
  }
  return *text;
}
#endif

/// The text is small, and stands for a million times as much.
struct Input {
  const char* name;
  const char* file;
  QStringList arguments;  ///< "FILE" is the file
  std::function<std::string()> text;
  const char* what;  ///< begins the sentence
};

QStringList words(const char* text) {
  return QString::fromUtf8(text).split(QLatin1Char(' '));
}

const std::vector<Input>& inputs() {
  static const std::vector<Input> kInputs{
      {"table in an archive", "a.csv.zst", words("analyse FILE"),
       [] { return archive({}, "0,1\n"); }, "The unpacked archive"},
      {"table of one column", "b.csv.zst", words("analyse FILE --map x_act=#1"),
       [] { return trace::pack(repeated("1\n", 10'000'000), 3); }, "The table"},
      {"row without an end", "c.csv.zst", words("analyse FILE"),
       [] { return trace::pack("1,2\n" + std::string(50'000'000, ','), 3); }, "A row of the table"},
      {"trace of a SINUMERIK", "d.xml.zst", words("analyse FILE"),
       [] {
         return trace::pack("<traceSession><dataSignal id=\"f1\"/><dataFrame>" +
                                repeated("<dataSignal/>", 1'000'000),
                            3);
       },
       "The trace"},
      {"recording", "e.rivrec", words("analyse FILE"), [] { return recording("n 1 \"\"\n"); },
       "The text of the recording"},
      {"records of a recording", "f.rivrec", words("analyse FILE"),
       [] {
         return "rivulet-recording 1\nrun method=\"window\"\n" + repeated("l 1 - -\n", 5'000'000);
       },
       "The recording"},
      {"overview of a recording", "g.rivrec", words("analyse --overview FILE"),
       [] {
         return trace::pack("rivulet-recording 1\nrun method=\"window\"\n", 3) +
                trace::pack(repeated("n 1 \"\"\n", 60'000'000), 3);
       },
       "The text of the recording"},
      {"trace of a control", "h.txt", words("analyse FILE"),
       [] {
         return "rivulet-control-trace 3 cycle_ns=4000000\n" +
                repeated("b 1 2 3 0 0 0 0\n", 6'000'000);
       },
       "The trace of the control"},
      {"loop", "i.mpf", words("check --dialect sinumerik FILE"),
       [] { return "R1=0\nNEXT:\nR1=R1+1\n" + repeated("M3 ", 100) + "\nGOTOB NEXT\n"; },
       "The program"},
      {"loop of a job", "j.mpf", words("check --job --dialect sinumerik FILE"),
       [] { return "R1=0\nNEXT:\nR1=R1+1\n" + repeated("M3 ", 100) + "\nGOTOB NEXT\n"; },
       "The program"},
      {"blocks of a job", "p.mpf", words("job --simulate --dialect sinumerik FILE"),
       [] { return "G0 X0 Y0 Z0\n" + repeated("M8\n", 4'000'000) + "M30\n"; }, "The program"},
#ifdef RIVULET_TEST_HDF5
      {"HDF5", "q.h5", words("analyse FILE"), packedHdf5,
       "The HDF5 file, unpacked and with its analysis,"},
#endif
      {"tree", "k.mpf", words("check --dialect sinumerik FILE"),
       [] { return "GOTOF DONE\n" + repeated("X1\n", 4'000'000) + "DONE:\nM30\n"; }, "The program"},
      {"divided moves", "m.mpf", words("points --split 1e-6 --dialect sinumerik FILE"),
       [] { return std::string("G0 X0 Y0 Z0\nG1 X1000 F1000\nM30\n"); }, "A path of"},
      {"tokens", "n.toml", words("petri simulate FILE"),
       [] {
         return std::string(
             "name = \"n\"\ntime_unit = \"ms\"\ntop = \"Top\"\n[pages.Top.places]\n"
             "A = { colour = \"INT\", initial = \"1000000000`1\" }\n");
       },
       "The net"},
      {"parts of an experiment", "o.json", words("merge FILE"),
       [] { return "[" + repeated("0,", 20'000'000) + "0]"; }, "The JSON text"},
  };
  return kInputs;
}

}  // namespace

class TestMemory : public QObject {
  Q_OBJECT

  /// The most that was resident of a program, as the system shows it while it runs: what is told of
  /// it when it has ended also counts the program that started it.
  static double bytesUntilItEnds(QProcess& process) {
    constexpr int kLookMs = 5;
    double bytes = 0.0;
    QFile status(QStringLiteral("/proc/%1/status").arg(process.processId()));
    const QDeadlineTimer deadline(tests::kRunMs);
    do {
      if (status.open(QIODevice::ReadOnly)) {
        const QByteArray text = status.readAll();
        const qsizetype at = text.indexOf("VmHWM:");
        if (at >= 0) {
          bytes =
              std::max(bytes, 1024.0 * text.mid(at + 6).trimmed().split(' ').first().toDouble());
        }
        status.close();
      }
    } while (!process.waitForFinished(kLookMs) && process.state() != QProcess::NotRunning &&
             !deadline.hasExpired());
    return bytes;
  }

  QTemporaryDir m_folder;

 private Q_SLOTS:
  void isRefusedInTime_data() {
    QTest::addColumn<std::size_t>("input");
    for (std::size_t i = 0; i < inputs().size(); ++i) {
      QTest::newRow(inputs()[i].name) << i;
    }
  }

  void isRefusedInTime() {
    QFETCH(std::size_t, input);
    const Input& one = inputs()[input];
    const QString path = m_folder.filePath(QString::fromUtf8(one.file));
    QVERIFY(base::writeFile(path.toStdString(), one.text()).has_value());
    QStringList arguments{QStringLiteral("--memory-limit"), QString::number(kLimit)};
    arguments += one.arguments;
    arguments.replaceInStrings(QStringLiteral("FILE"), path);
    QProcess process;
    process.start(QStringLiteral(RIVULET_CLI), arguments);
    QVERIFY(process.waitForStarted(tests::kRunMs));
    const double bytes = bytesUntilItEnds(process);
    QVERIFY(process.state() == QProcess::NotRunning);
    QFile::remove(path);
    const QByteArray errors = process.readAllStandardError();
    QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 2,
             errors.constData());
    QVERIFY2(errors.contains(one.what) && errors.contains("--memory-limit"), errors.constData());
    if (!tests::kIsSanitized) {
      QVERIFY2(bytes < 1.2 * kLimit, qPrintable(QString::number(bytes)));
    }
  }

  /// Neither its text nor its numbers are held as they are: a million rows of five columns.
  void aTableNeedsLittle() {
    constexpr double kBytesMax = 100e6;
    const QString path = m_folder.filePath(QStringLiteral("large.csv"));
    std::string table = "t_s,x_set,y_set,x_act,y_act\n";
    for (int i = 0; i < 1'000'000; ++i) {
      const double at = 0.001 * i;
      table +=
          fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", at, 50.0 * std::sin(at),
                      50.0 * std::cos(at), 50.0 * std::sin(at - 0.01), 50.0 * std::cos(at - 0.01));
    }
    QVERIFY(base::writeFile(path.toStdString(), table).has_value());
    QProcess process;
    process.start(QStringLiteral(RIVULET_CLI),
                  {QStringLiteral("analyse"), path, QStringLiteral("--json")});
    QVERIFY(process.waitForStarted(tests::kRunMs));
    const double bytes = bytesUntilItEnds(process);
    QCOMPARE(process.exitCode(), 0);
    if (!tests::kIsSanitized) {
      QVERIFY2(bytes < kBytesMax, qPrintable(QString::number(bytes)));
    }
    QFile::remove(path);
  }

  /// It is a limit of one file, and who has more memory can say so.
  void theOptionAllowsMore() {
    const QString path = m_folder.filePath(QStringLiteral("table.csv"));
    std::string table = "t;x_act\n";
    for (int i = 0; i < 50'000; ++i) {
      table += std::to_string(0.001 * i) + ";1\n";
    }
    QVERIFY(base::writeFile(path.toStdString(), table).has_value());
    const auto exitWith = [&](const char* limit) {
      return QProcess::execute(QStringLiteral(RIVULET_CLI),
                               {QStringLiteral("--memory-limit"), QString::fromUtf8(limit),
                                QStringLiteral("analyse"), path, QStringLiteral("--json")});
    };
    QCOMPARE(exitWith("1MB"), 2);
    QCOMPARE(exitWith("100MB"), 0);
    QCOMPARE(exitWith("1kB"), 2);
    QCOMPARE(exitWith("much"), 2);
  }
};

RIVULET_TEST(TestMemory)

#include "tst_memory.moc"
