// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "support/test_program.h"
#include "trace/spectrum.h"

using namespace rivulet;
using namespace rivulet::trace;

namespace {

double sine(double hz, double seconds) {
  return std::sin(2.0 * std::numbers::pi * hz * seconds);
}

Spectrum whole(const Envelope& samples) {
  const auto spectrum = spectrumOf(samples, base::Instant::min(), base::Instant::max());
  return spectrum ? *spectrum : Spectrum{};
}

}  // namespace

class TestSpectrum : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Two vibrations on a slope: both are found, with their amplitudes, and the slope is not.
  void namesThePeaks_data() {
    QTest::addColumn<int>("count");
    for (const int count : {1000, 1024, 3001, 200'000}) {
      QTest::addRow("%d samples", count) << count;
    }
  }
  void namesThePeaks() {
    QFETCH(int, count);
    Envelope samples;
    for (int i = 0; i < count; ++i) {
      const double seconds = 0.001 * i;
      samples.append(base::Instant{base::fromSeconds(seconds)},
                     5.0 + 7.0 * seconds + 0.4 * sine(37.3, seconds) + 0.1 * sine(120.0, seconds));
    }
    const Spectrum spectrum = whole(samples);
    QVERIFY(!spectrum.isResampled);
    QVERIFY(std::abs(spectrum.rateHz - 1000.0) < 1e-6);
    QCOMPARE(spectrum.count, static_cast<std::size_t>(count));
    QCOMPARE(spectrum.peaks.size(), std::size_t{2});
    // The parabola is not exactly the top of the window: 2 % of a step of 1 Hz, 1 % of the height.
    QVERIFY(std::abs(spectrum.peaks[0].hz - 37.3) < 0.05);
    QVERIFY(std::abs(spectrum.peaks[0].amplitude - 0.4) < 0.01);
    QVERIFY(std::abs(spectrum.peaks[1].hz - 120.0) < 0.05);
    QVERIFY(std::abs(spectrum.peaks[1].amplitude - 0.1) < 0.005);
  }

  /// Samples that are lost or late are filled in, and the spectrum says so.
  void resamplesIrregularSamples() {
    base::Random random(7);
    Envelope samples;
    for (int i = 0; i < 8000; ++i) {
      const double seconds = 0.001 * i + 0.0004 * random.uniform();
      if (random.uniform() < 0.9) {
        samples.append(base::Instant{base::fromSeconds(seconds)}, sine(25.0, seconds));
      }
    }
    const Spectrum spectrum = whole(samples);
    QVERIFY(spectrum.isResampled);
    QVERIFY(!spectrum.peaks.empty());
    QVERIFY(std::abs(spectrum.peaks[0].hz - 25.0) < 0.05);
    QVERIFY(std::abs(spectrum.peaks[0].amplitude - 1.0) < 0.02);
  }

  /// The same frequency as on the clean samples, although a part is missing.
  void aGapIsFilledIn() {
    Envelope samples;
    for (int i = 0; i < 2000; ++i) {
      const double seconds = 0.004 * i;
      samples.append(base::Instant{base::fromSeconds(seconds)},
                     i == 1000 ? std::nan("") : sine(10.0, seconds));
    }
    const Spectrum spectrum = whole(samples);
    QVERIFY(spectrum.isResampled);
    QVERIFY(std::abs(spectrum.peaks.at(0).hz - 10.0) < 0.02);
  }

  void looksBetweenTwoInstants() {
    Envelope samples;
    for (int i = 0; i < 4000; ++i) {
      const double seconds = 0.001 * i;
      samples.append(base::Instant{base::fromSeconds(seconds)},
                     sine(i < 2000 ? 20.0 : 80.0, seconds));
    }
    const auto second = spectrumOf(samples, base::Instant{std::chrono::seconds{2}},
                                   base::Instant{std::chrono::seconds{4}});
    QVERIFY(second);
    QVERIFY(std::abs(second->peaks.at(0).hz - 80.0) < 0.05);
    QCOMPARE(second->peaks.size(), std::size_t{1});
    const auto few = spectrumOf(samples, base::Instant{std::chrono::milliseconds{10}},
                                base::Instant{std::chrono::milliseconds{20}});
    QVERIFY(!few && few.error().code == SpectrumError::TooFewSamples);
  }

  void aConstantHasNoPeak() {
    Envelope samples;
    for (int i = 0; i < 100; ++i) {
      samples.append(base::Instant{std::chrono::milliseconds{i}}, 3.0);
    }
    QVERIFY(whole(samples).peaks.empty());
  }
};

RIVULET_TEST(TestSpectrum)
#include "tst_spectrum.moc"
