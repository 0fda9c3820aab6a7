// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace/motion_samples.h"

#include <algorithm>
#include <bit>

#include "base/contract.h"

namespace rivulet::trace {

namespace {

using MotionValues = std::array<double, kMotionColumns>;

MotionValues valuesOf(const MotionSample& sample) {
  return {sample.setMm.x,        sample.setMm.y,
          sample.setMm.z,        sample.actualMm.x,
          sample.actualMm.y,     sample.actualMm.z,
          sample.pathMmPerS,     sample.feedMmPerS,
          sample.overrideFactor, static_cast<double>(sample.line)};
}

/// @param action  gets a function that sets the value of the column in a sample
template <class Action>
void withSetter(std::size_t column, const Action& action) {
  switch (static_cast<MotionColumn>(column)) {
    case MotionColumn::SetX:
      action([](MotionSample& sample, double value) { sample.setMm.x = value; });
      break;
    case MotionColumn::SetY:
      action([](MotionSample& sample, double value) { sample.setMm.y = value; });
      break;
    case MotionColumn::SetZ:
      action([](MotionSample& sample, double value) { sample.setMm.z = value; });
      break;
    case MotionColumn::ActualX:
      action([](MotionSample& sample, double value) { sample.actualMm.x = value; });
      break;
    case MotionColumn::ActualY:
      action([](MotionSample& sample, double value) { sample.actualMm.y = value; });
      break;
    case MotionColumn::ActualZ:
      action([](MotionSample& sample, double value) { sample.actualMm.z = value; });
      break;
    case MotionColumn::Speed:
      action([](MotionSample& sample, double value) { sample.pathMmPerS = value; });
      break;
    case MotionColumn::Feed:
      action([](MotionSample& sample, double value) { sample.feedMmPerS = value; });
      break;
    case MotionColumn::Override:
      action([](MotionSample& sample, double value) { sample.overrideFactor = value; });
      break;
    case MotionColumn::Line:
      action([](MotionSample& sample, double value) {
        sample.line = static_cast<std::uint32_t>(value);
      });
      break;
  }
}

void setValue(MotionSample& sample, std::size_t column, double value) {
  withSetter(column, [&sample, value](const auto& set) { set(sample, value); });
}

bool isSameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

PackedValues repeated(double value, std::size_t count) {
  PackedValues values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(value);
  }
  return values;
}

}  // namespace

MotionSamples::MotionSamples(const std::vector<MotionSample>& samples) {
  for (const MotionSample& sample : samples) {
    push_back(sample);
  }
}

MotionSamples::MotionSamples(PackedTimes at, Columns columns)
    : m_at(std::move(at)), m_columns(std::move(columns)) {
  RIVULET_ASSERT(std::all_of(m_columns.begin(), m_columns.end(), [this](const Column& column) {
    return column.values.empty() || column.values.size() == m_at.size();
  }));
}

void MotionSamples::push_back(const MotionSample& sample) {
  const MotionValues values = trace::valuesOf(sample);
  const std::size_t before = size();
  m_at.push_back(sample.at);
  for (std::size_t i = 0; i < kMotionColumns; ++i) {
    Column& column = m_columns[i];
    if (before == 0) {
      column.constant = values[i];
      continue;
    }
    if (column.values.empty() && !isSameBits(values[i], column.constant)) {
      column.values = repeated(column.constant, before);
    }
    if (!column.values.empty()) {
      column.values.push_back(values[i]);
    }
  }
}

MotionSample MotionSamples::constants() const {
  MotionSample sample;
  for (std::size_t i = 0; i < kMotionColumns; ++i) {
    setValue(sample, i, m_columns[i].constant);
  }
  return sample;
}

MotionSample MotionSamples::operator[](std::size_t index) const {
  MotionSample sample;
  sample.at = m_at[index];
  for (std::size_t i = 0; i < kMotionColumns; ++i) {
    const Column& column = m_columns[i];
    setValue(sample, i, column.values.empty() ? column.constant : column.values[index]);
  }
  return sample;
}

void MotionSamples::unpack(std::size_t block, Block& items) const {
  const std::size_t count = std::min(kPackedBlockSize, size() - block * kPackedBlockSize);
  TimePacking::Items at;
  m_at.unpack(block, at);
  for (std::size_t i = 0; i < count; ++i) {
    items[i].at = at[i];
  }
  ValuePacking::Items values;
  for (std::size_t column = 0; column < kMotionColumns; ++column) {
    if (m_columns[column].values.empty()) {
      continue;
    }
    m_columns[column].values.unpack(block, values);
    withSetter(column, [&](const auto& set) {
      for (std::size_t i = 0; i < count; ++i) {
        set(items[i], values[i]);
      }
    });
  }
}

PackedValues MotionSamples::valuesOf(MotionColumn column) const {
  const Column& wanted = m_columns[static_cast<std::size_t>(column)];
  return wanted.values.empty() ? repeated(wanted.constant, size()) : wanted.values;
}

std::size_t MotionSamples::indexAt(base::Instant at) const {
  return static_cast<std::size_t>(std::lower_bound(m_at.begin(), m_at.end(), at) - m_at.begin());
}

MotionReader::MotionReader(const MotionSamples& samples) : m_samples(&samples) {
  const MotionSample constants = samples.constants();
  for (MotionSamples::Block& items : m_items) {
    items.fill(constants);
  }
}

void MotionReader::load(std::size_t block) {
  RIVULET_ASSERT(block * kPackedBlockSize < size());
  m_samples->unpack(block, m_items[block % kSlots]);
  m_blocks[block % kSlots] = block;
}

}  // namespace rivulet::trace
