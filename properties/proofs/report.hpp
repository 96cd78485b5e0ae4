// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// A statement, the cases that were examined for it, and the first that contradicts it.

#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace osteon::proofs {

class proof {
 public:
  explicit proof(std::string statement) : statement_(std::move(statement)) {}

  /// One more case. `describe` makes the counterexample's text and is called for the first one only.
  template <class Describe>
  void check(bool holds, Describe&& describe) {
    ++cases_;
    if (!holds && !counterexample_) counterexample_ = describe();
  }

  /// What else was found on the way, such as the number of exceptions.
  void note(std::string text) { notes_.push_back(std::move(text)); }

  /// A statement about no case at all counts as not proved.
  bool print(std::ostream& out) const {
    const bool proved = cases_ > 0 && !counterexample_;
    out << (proved ? "PROVED   " : "REFUTED  ") << statement_ << "  (" << cases_ << " cases)\n";
    if (cases_ == 0) out << "         no case was examined\n";
    if (counterexample_) out << "         counterexample: " << *counterexample_ << '\n';
    for (const auto& n : notes_) out << "         - " << n << '\n';
    return proved;
  }

 private:
  std::string statement_;
  long cases_ = 0;
  std::optional<std::string> counterexample_;
  std::vector<std::string> notes_;
};

}  // namespace osteon::proofs
