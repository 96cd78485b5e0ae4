// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What is computed when it is first asked for, and once.

#include <mutex>
#include <optional>
#include <utility>

namespace osteon {

/// A value that the first caller makes. Several threads may ask at once.
template <class Value>
class lazy {
 public:
  /// Returns the value, made by `make()` the first time. Where that throws, the next caller makes
  /// it.
  template <class Make>
  const Value& get(Make make) const {
    std::call_once(made_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  mutable std::once_flag made_;
  mutable std::optional<Value> value_;
};

}  // namespace osteon
