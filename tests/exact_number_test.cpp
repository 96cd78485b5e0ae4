// SPDX-License-Identifier: MIT
#include "osteon/input/exact_number.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "osteon/kernel/integer.hpp"

namespace osteon {
namespace {

rational value(const exact_number<integer>& x) {
  rational v(x.mantissa);
  for (int i = 0; i < x.ten; ++i) v *= 10;
  for (int i = 0; i > x.ten; --i) v /= 10;
  for (int i = 0; i < x.two; ++i) v *= 2;
  for (int i = 0; i > x.two; --i) v /= 2;
  return v;
}

rational read(const std::string& text) {
  exact_number<integer> x;
  EXPECT_EQ(read_decimal(text, x), number_fault::none) << text;
  return value(x);
}

number_fault fault(const std::string& text) {
  exact_number<integer> x;
  return read_decimal(text, x);
}

TEST(ExactNumber, ReadsDecimals) {
  EXPECT_EQ(read("0"), 0);
  EXPECT_EQ(read("-0.000e7"), 0);
  EXPECT_EQ(read("0e999999"), 0);
  EXPECT_EQ(read("+12"), 12);
  EXPECT_EQ(read("-1.25"), rational(-5, 4));
  EXPECT_EQ(read(".5"), rational(1, 2));
  EXPECT_EQ(read("5."), 5);
  EXPECT_EQ(read("007.50"), rational(15, 2));
  EXPECT_EQ(read("1200"), 1200);
  EXPECT_EQ(read("12.5E+2"), 1250);
  EXPECT_EQ(read("1e-3"), rational(1, 1000));
  EXPECT_EQ(read("0.1"), rational(1, 10)) << "not the double next to it";
  EXPECT_EQ(read("100000000000000000000.00000000000000000001"),
            rational(integer("10000000000000000000000000000000000000001")) / rational(integer("100000000000000000000")));
  EXPECT_EQ(read("-123456789012345678901234567890"), rational(integer("-123456789012345678901234567890")));
}

TEST(ExactNumber, RefusesEverythingElse) {
  for (const char* text :
       {"", "-", "+", ".", "-.", "e1", "1e", "1e+", "1e-", "nan", "inf", "0x10", "1,5", "1.2.3", "--1", "1-", "1e5e", "1e1.5", " 1", "1 ", "1f"})
    EXPECT_EQ(fault(text), number_fault::malformed) << text;
}

TEST(ExactNumber, LimitsAreWhatTheySay) {
  EXPECT_EQ(fault(std::string(1000, '7') + "e-700"), number_fault::none);
  EXPECT_EQ(fault(std::string(1001, '7') + "e-700"), number_fault::too_long);
  EXPECT_EQ(fault("1" + std::string(999, '0') + "1e-700"), number_fault::too_long) << "zeros within count";
  EXPECT_EQ(fault("0." + std::string(300, '0') + "1" + std::string(3000, '0')), number_fault::none) << "zeros at the ends do not";
  EXPECT_EQ(fault(std::string(5000, '0') + "1"), number_fault::none);
  EXPECT_EQ(fault("9.99e399"), number_fault::none);
  EXPECT_EQ(fault("1e400"), number_fault::too_long);
  EXPECT_EQ(fault("1e-400"), number_fault::none);
  EXPECT_EQ(fault("9.99e-401"), number_fault::too_long);
  for (const char* text : {"1e999999", "1e-999999", "1e99999999999999999999999", "-1e-99999999999999999999999"})
    EXPECT_EQ(fault(text), number_fault::too_long);
}

TEST(ExactNumber, LongZerosCancelTheExponent) {
  const auto x = read("0." + std::string(1'000'000, '0') + "25e1000000");
  EXPECT_EQ(x, rational(1, 4));
}

TEST(ExactNumber, TakesDoublesExactly) {
  for (const double x :
       {0.0, -0.0, 1.0, -3.0, 0.1, 1e300, 4.9e-324, -2.2250738585072014e-308, std::numeric_limits<double>::max(), 6755399441055744.0}) {
    const auto e = from_double<integer>(x);
    ASSERT_TRUE(e.has_value());
    EXPECT_EQ(value(*e), rational(x)) << x;
  }
  EXPECT_NE(value(*from_double<integer>(0.1)), rational(1, 10));
  EXPECT_FALSE(from_double<integer>(std::numeric_limits<double>::quiet_NaN()).has_value());
  EXPECT_FALSE(from_double<integer>(-std::numeric_limits<double>::infinity()).has_value());
}

}  // namespace
}  // namespace osteon
