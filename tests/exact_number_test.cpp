// SPDX-License-Identifier: MIT
#include "osteon/input/exact_number.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <sstream>
#include <string>

#include "osteon/input/common_scale.hpp"
#include "osteon/input/geometry.hpp"
#include "osteon/input/write_number.hpp"
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
  EXPECT_EQ(fault(std::string("1") + std::string(999, '0') + "1e-700"), number_fault::too_long) << "zeros within count";
  EXPECT_EQ(fault(std::string("0.") + std::string(300, '0') + "1" + std::string(3000, '0')), number_fault::none) << "zeros at the ends do not";
  EXPECT_EQ(fault(std::string(5000, '0') + "1"), number_fault::none);
  EXPECT_EQ(fault("9.99e399"), number_fault::none);
  EXPECT_EQ(fault("1e400"), number_fault::too_long);
  EXPECT_EQ(fault("1e-400"), number_fault::none);
  EXPECT_EQ(fault("9.99e-401"), number_fault::too_long);
  for (const char* text : {"1e999999", "1e-999999", "1e99999999999999999999999", "-1e-99999999999999999999999"})
    EXPECT_EQ(fault(text), number_fault::too_long);
}

TEST(ExactNumber, LongZerosCancelTheExponent) {
  const auto x = read(std::string("0.") + std::string(1'000'000, '0') + "25e1000000");
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

TEST(ExactNumber, IsWrittenAsItIsRead) {
  const auto written = [](const auto& x) {
    std::ostringstream out;
    write_number(out, x);
    return out.str();
  };
  for (const char* text : {"0", "-1.25", "1200", "12345678901234567890.5", "1e-3", "9.99e399", "1e-400"}) {
    exact_number<integer> x;
    ASSERT_EQ(read_decimal(text, x), number_fault::none);
    EXPECT_EQ(read(written(x)), value(x)) << text << " as " << written(x);
  }
  for (const double x : {0.0, 0.1, -3.5, 1e20, 1e300, 0x1p-300, 123456789.0, 0x1.fffffffffffffp+10}) {
    EXPECT_EQ(read(written(*from_double<integer>(x))), rational(x)) << x;
    EXPECT_EQ(std::stod(written(x)), x);
  }
  EXPECT_EQ(written(exact_number<integer>{7, 3, 2}), "28e3");
  EXPECT_EQ(written(exact_number<integer>{7, 0, -2}), "175e-2");
  EXPECT_EQ(written(exact_number<integer>{0, 5, -2}), "0");
  EXPECT_EQ(written(integer(-12)), "-12");
  EXPECT_EQ(written(0.1), "0.1");
}

TEST(CommonScale, IsThatOfTheFinestNumber) {
  std::vector<exact_number<integer>> numbers;
  for (const char* text : {"0.5", "-20", "0", "1e3", "0.125"}) ASSERT_EQ(read_decimal(text, numbers.emplace_back()), number_fault::none);
  for (const double x : {0.75, 1.5}) numbers.push_back(*from_double<integer>(x));
  common_scale<integer> scale;
  for (const auto& x : numbers) scale.add(x);
  EXPECT_EQ(scale.ten(), -3);
  EXPECT_EQ(scale.two(), -2);
  EXPECT_EQ(scale.count(), 7U);
  EXPECT_EQ(scale.finest(), 5U);
  EXPECT_FALSE(scale.is_absurd());
  for (const auto& x : numbers) EXPECT_EQ(rational(scale.scaled(x)) / 4000, value(x));
  EXPECT_EQ(scale.scaled(std::move(numbers[3])), 4'000'000);
}

TEST(CommonScale, LimitsAreWhatTheySay) {
  const auto is_absurd = [](const exact_number<integer>& finest, std::size_t others) {
    common_scale<integer> scale;
    scale.add(finest);
    for (std::size_t i = 0; i < others; ++i) scale.add({1, 0, 0});
    return scale.is_absurd();
  };
  EXPECT_FALSE(is_absurd({1, 0, -100'000}, 1));
  EXPECT_TRUE(is_absurd({1, 0, -100'001}, 1));
  EXPECT_FALSE(is_absurd({1, -30'000, 0}, 1));
  EXPECT_TRUE(is_absurd({1, -30'031, 0}, 1));
  EXPECT_FALSE(is_absurd({1, 0, -40'000}, 99'999));
  EXPECT_TRUE(is_absurd({1, 0, -40'000}, 100'000)) << "half a gigabyte";
  EXPECT_TRUE(is_absurd({1, -2'000'000'000, -2'000'000'000}, 1));
  EXPECT_TRUE(is_absurd({1, 2'000'000'000, 0}, 1)) << "all others are too fine";
  EXPECT_FALSE(is_absurd({0, 2'000'000'000, 0}, 1)) << "zero is zero in any scale";
}

TEST(Geometry, TurnsAreThoseOfAreas) {
  using small = std::array<long, 2>;
  using big = std::array<integer, 2>;
  EXPECT_EQ(turn(small{0, 0}, small{4, 0}, small{4, 3}), sign::positive);
  EXPECT_EQ(turn(small{4, 3}, small{4, 0}, small{0, 0}), sign::negative);
  EXPECT_EQ(turn(small{-1, -1}, small{2, 2}, small{5, 5}), sign::zero);
  EXPECT_EQ(twice_area(small{0, 0}, small{4, 0}, small{4, 3}), 12);
  const integer far = integer(1) << 200;
  EXPECT_EQ(turn(big{0, 0}, big{far, far}, big{far + 1, far}), sign::negative);
  EXPECT_EQ(turn(big{0, 0}, big{far, far}, big{3 * far, 3 * far}), sign::zero);
  // The same in space, projected: along the axis of the largest component of the normal, counter-clockwise stays counter-clockwise.
  for (const vec<integer>& normal : {vec<integer>{5, 1, -2}, {-5, 1, 2}, {0, 3, 1}, {1, -3, 1}, {0, 0, 1}, {0, 1, -1}}) {
    const auto axes = projection(normal);
    const vec<integer> a = {1, 2, 3};
    const vec<integer> b = a - cross(normal, vec<integer>{1, 1, 2});
    const vec<integer> c = a - cross(normal, b - a);  // to the right of the way from a to b, seen from where the normal points
    EXPECT_EQ(turn(a, b, projected(c, axes), axes), sign::negative);
    EXPECT_EQ(turn(a, c, projected(b, axes), axes), sign::positive);
  }
}

}  // namespace
}  // namespace osteon
