// SPDX-License-Identifier: MIT

#include "decimals.hpp"

namespace osteon {

bool decimal::is_less(const decimal& a, const decimal& b) { return rational_value(a, "the number") < rational_value(b, "the number"); }

}  // namespace osteon
