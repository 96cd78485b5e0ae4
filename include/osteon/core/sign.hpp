// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The answer to every geometric question the library asks.

namespace osteon {

/// The sign of a real number. `zero` means exactly zero, never "too close to tell": a kernel that
/// cannot tell says so with an empty `std::optional<sign>` (filters) or by throwing
/// `undecided_error`.
enum class sign : signed char { negative = -1, zero = 0, positive = 1 };

/// Returns the sign of -x. Constant time.
constexpr sign operator-(sign s) noexcept { return static_cast<sign>(-static_cast<int>(s)); }

/// Returns the sign of a product. Constant time.
constexpr sign operator*(sign a, sign b) noexcept { return static_cast<sign>(static_cast<int>(a) * static_cast<int>(b)); }

/// Returns the sign of a number of any type that compares with 0 (for floating point: of the
/// rounded value; NaN gives zero).
template <class Number>
constexpr sign sign_of(const Number& x) {
  return x < 0 ? sign::negative : (x > 0 ? sign::positive : sign::zero);
}

/// Returns `positive` for true, `negative` for false.
constexpr sign signed_if(bool b) noexcept { return b ? sign::positive : sign::negative; }

}  // namespace osteon
