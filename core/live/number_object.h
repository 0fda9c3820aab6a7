// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Reads one flat JSON object of numbers, {"x": 0.01}: everything else ends the reading, unless a
/// derived class knows better. Only for sources; it needs nlohmann-json. @threadsafety one object,
/// one thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace rivulet::live {

class NumberObject : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool start_object(std::size_t) final { return !std::exchange(m_isOpen, true); }
  bool end_object() final { return true; }
  bool number_integer(number_integer_t value) final { return take(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) final { return take(static_cast<double>(value)); }
  bool number_float(number_float_t value, const std::string&) final { return take(value); }
  bool null() override { return false; }
  bool boolean(bool) override { return false; }
  bool string(std::string&) override { return false; }
  bool binary(nlohmann::json::binary_t&) final { return false; }
  bool start_array(std::size_t) final { return false; }
  bool end_array() final { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) final {
    return false;
  }

 protected:
  /// Of the key that was told last. @return false: the object is not one of these
  virtual bool take(double value) = 0;

 private:
  bool m_isOpen = false;
};

}  // namespace rivulet::live
