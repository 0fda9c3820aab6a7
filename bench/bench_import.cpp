// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a trace takes from its file to its figures: a table of 10,000,000 rows and five columns, as
// CSV and as HDF5. Beside it, what any reader of the same text takes at least: a pass over the
// mapped file that finds its line ends, and one that makes a double of every cell and keeps none.
// In turns; medians. The work is done by as many threads as there are cores, the passes by one.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/median.h"
#include "measuring.h"
#include "report/trace_source.h"
#include "trace/analysis/trace_analysis.h"
#include "trace/signal_file.h"
#include "trace/signal_set.h"

namespace {

using namespace rivulet;

constexpr int kRows = 10'000'000;
constexpr int kRepetitions = 3;
/// Of what is resident of the program.
constexpr std::uint64_t kMemoryLimit = 4'000'000'000;

/// Two axes on a contour, 0.1 µm, each millisecond.
void writeTable(const std::filesystem::path& path) {
  std::ofstream out(path, std::ios::binary);
  std::string text = "t_s,x_set_mm,y_set_mm,x_act_mm,y_act_mm\n";
  for (int i = 0; i < kRows; ++i) {
    const double at = 0.001 * i;
    const double x = 80.0 * std::sin(0.31 * at) + 6.0 * std::sin(5.3 * at);
    const double y = 80.0 * std::cos(0.31 * at) + 6.0 * std::cos(4.1 * at);
    text += fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", at, x, y,
                        x + 0.002 * std::sin(157.0 * at), y + 0.003 * std::cos(131.0 * at));
    if (text.size() > 1 << 20) {
      out << text;
      text.clear();
    }
  }
  out << text;
}

/// A file in the memory of the system.
class Mapped {
 public:
  explicit Mapped(const std::filesystem::path& path)
      : m_size(std::filesystem::file_size(path)), m_file(open(path.c_str(), O_RDONLY)) {
    m_at = mmap(nullptr, m_size, PROT_READ, MAP_PRIVATE, m_file, 0);
  }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;
  ~Mapped() {
    munmap(m_at, m_size);
    close(m_file);
  }
  [[nodiscard]] std::string_view text() const { return {static_cast<const char*>(m_at), m_size}; }

 private:
  std::size_t m_size;
  int m_file;
  void* m_at = nullptr;
};

double countLines(const std::filesystem::path& path) {
  const Mapped file(path);
  std::string_view rest = file.text();
  double lines = 0.0;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    rest.remove_prefix(end + 1);
    ++lines;
  }
  return lines;
}

double sumCells(const std::filesystem::path& path) {
  const Mapped file(path);
  const std::string_view text = file.text();
  const char* at = text.data() + text.find('\n') + 1;
  const char* const end = text.data() + text.size();
  double sum = 0.0;
  while (at < end) {
    double value = 0.0;
    at = std::from_chars(at, end, value).ptr + 1;
    sum += value;
  }
  return sum;
}

double shown(const std::filesystem::path& path) {
  const trace::Trace trace =
      bench::required(report::openTrace(path, {}, 0.0, base::Budget(kMemoryLimit)));
  return static_cast<double>(trace::makeShownTrace(trace).signalSet.channels().size());
}

double analysed(const std::filesystem::path& path) {
  const trace::Trace trace =
      bench::required(report::openTrace(path, {}, 0.0, base::Budget(kMemoryLimit)));
  return static_cast<double>(trace::analyseTrace(trace).stops.size());
}

/// The most that was resident since the last call.
double peakMb() {
  std::ifstream status("/proc/self/status");
  long kilobytes = 0;
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      status >> kilobytes;
    }
  }
  std::ofstream("/proc/self/clear_refs") << "5";
  return 1024.0 * static_cast<double>(kilobytes) / 1e6;
}

struct Row {
  const char* name;
  std::function<double()> work;
  std::vector<double> elapsedS{};
  std::vector<double> processorS{};
  double peakMb = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder =
      argc > 1 ? argv[1] : std::filesystem::temp_directory_path() / "rivulet-bench";
  std::filesystem::create_directories(folder);
  const std::filesystem::path table = folder / "table.csv";
  const std::filesystem::path packed = folder / "table.h5";
  writeTable(table);
  std::vector<Row> rows{{"mmap, line ends", [&] { return countLines(table); }},
                        {"mmap, from_chars", [&] { return sumCells(table); }},
                        {"CSV, ready to draw", [&] { return shown(table); }},
                        {"CSV, analysed", [&] { return analysed(table); }}};
  {
    const trace::Trace trace =
        bench::required(report::openTrace(table, {}, 0.0, base::Budget(kMemoryLimit)));
    trace::SignalFile file = trace::signalFileOf(trace::makeShownTrace(trace));
    std::erase_if(file.exported, [](const trace::ExportedSignal& one) {
      return one.name.find("_mm") == std::string::npos;
    });
    if (trace::saveSignals(packed, file)) {
      rows.push_back({"HDF5, ready to draw", [&] { return shown(packed); }});
      rows.push_back({"HDF5, analysed", [&] { return analysed(packed); }});
    }
  }
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    for (Row& row : rows) {
      peakMb();
      const double before = bench::processorS();
      row.elapsedS.push_back(1e-6 * bench::microseconds([&row] {
                               if (row.work() < 0.0) {
                                 fmt::print("\n");  // the result is wanted
                               }
                             }));
      row.processorS.push_back(bench::processorS() - before);
      row.peakMb = std::max(row.peakMb, peakMb());
    }
  }
  fmt::print("{} rows, {:.0f} MB as CSV\n{:20} {:>10} {:>12} {:>8}\n", kRows,
             static_cast<double>(std::filesystem::file_size(table)) / 1e6, "", "elapsed s",
             "processor s", "peak MB");
  for (const Row& row : rows) {
    fmt::print("{:20} {:10.2f} {:12.2f} {:8.0f}\n", row.name, base::median(row.elapsedS),
               base::median(row.processorS), row.peakMb);
  }
  return 0;
}
