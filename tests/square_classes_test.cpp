// SPDX-License-Identifier: MIT
#include "osteon/kernel/square_classes.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <cstdint>
#include <random>
#include <vector>

#include "osteon/core/sign.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {
namespace {

constexpr std::uint64_t seed = 20250118;

// An independent judge: 1500 decimal digits, far more than the forms here can cancel.
using real = boost::multiprecision::number<boost::multiprecision::gmp_float<1500>, boost::multiprecision::et_off>;

struct term {
  int plane;  // the root's number
  integer coefficient;
};

// A linear form that is written down twice: for the classes and for the judge.
class form {
 public:
  explicit form(square_classes& roots) : roots_(roots) {}

  void add(const integer& coefficient, const integer& radicand, const integer& weight = 1) {
    terms_.push_back({roots_.add(radicand, weight), coefficient});
    value_ += real(coefficient) * real(weight) * sqrt(real(radicand));
  }
  sign answer() const { return roots_.sign_of_form(terms_, static_cast<int>(terms_.size())); }
  sign negated() const {
    std::vector<term> t = terms_;
    for (term& x : t) x.coefficient = -x.coefficient;
    return roots_.sign_of_form(t, static_cast<int>(t.size()));
  }
  sign truth() const {
    if (abs(value_) < real("1e-1000")) return sign::zero;
    return value_ < 0 ? sign::negative : sign::positive;
  }

 private:
  square_classes& roots_;
  std::vector<term> terms_;
  real value_ = 0;
};

integer power(unsigned base, unsigned exponent) { return boost::multiprecision::pow(integer(base), exponent); }

integer random_integer(std::mt19937_64& engine, unsigned bits) {
  integer x = 0;
  for (unsigned done = 0; done < bits; done += 64) x = (x << 64) + integer(engine());
  return x % (integer(1) << bits) + 1;
}

// The moduli of the signature as they are documented there: 2^64 - k and 2^32 - k.
std::vector<integer> moduli() {
  std::vector<integer> result;
  for (const unsigned k : {59U, 83U, 95U, 179U, 189U, 257U, 279U, 323U, 353U, 363U}) result.push_back((integer(1) << 64) - k);
  for (const unsigned k : {5U, 17U, 65U, 99U, 107U, 135U, 153U, 185U, 209U, 267U}) result.push_back((integer(1) << 32) - k);
  return result;
}

TEST(SquareClasses, EmptyAndTrivialForms) {
  square_classes roots;
  EXPECT_EQ(form(roots).answer(), sign::zero);
  form zero(roots);
  zero.add(integer(0), integer(7));
  EXPECT_EQ(zero.answer(), sign::zero);
  form one(roots);
  one.add(integer(-3), integer(1));
  EXPECT_EQ(one.answer(), sign::negative);
  EXPECT_TRUE(roots.is_integer(1));
  EXPECT_FALSE(roots.is_integer(0));
  EXPECT_EQ(roots.scaled(0, 10), integer(2709)) << "floor(1024 sqrt 7)";
}

TEST(SquareClasses, RootOfTwoPlusRootOfEightIsRootOfEighteen) {
  square_classes roots;
  form f(roots);
  f.add(integer(1), integer(2));
  f.add(integer(1), integer(8));
  f.add(integer(-1), integer(18));
  EXPECT_EQ(f.answer(), sign::zero);
  f.add(integer(1), integer(3));
  EXPECT_EQ(f.answer(), sign::positive);
  f.add(integer(-1), integer(1), integer(1));
  f.add(integer(-1), integer(3));
  EXPECT_EQ(f.answer(), sign::negative);
  f.add(integer(1), integer(1));
  EXPECT_EQ(f.answer(), sign::zero);
  // Weights are factors outside the root.
  form g(roots);
  g.add(integer(2), integer(5), integer(3));
  g.add(integer(-1), integer(180));
  EXPECT_EQ(g.answer(), sign::zero);
}

// Relations among many classes: each class's terms sum to zero, or all but one do.
TEST(SquareClasses, RandomRelations) {
  std::mt19937_64 engine(seed);
  const std::vector<integer> bases = {integer(1),  integer(2),  integer(3),  integer(5),   integer(6),
                                      integer(7),  integer(10), integer(11), integer(13),  integer(30),
                                      integer(42), integer(77), integer(91), integer(101), (integer(1) << 89) - 1};
  square_classes roots;
  int zeros = 0;
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    form f(roots);
    const bool broken = round % 3 == 0;
    const int classes = 1 + static_cast<int>(engine() % 6);
    for (int c = 0; c < classes; ++c) {
      const integer& base = bases[engine() % bases.size()];
      integer sum = 0;
      for (int t = 0; t < 3; ++t) {
        const integer multiple = random_integer(engine, t == 0 ? 4 : 60);
        const integer coefficient = random_integer(engine, 40) * (engine() % 2 == 0 ? 1 : -1);
        f.add(coefficient, base * multiple * multiple);
        sum += coefficient * multiple;
      }
      if (broken && c == 0) sum += engine() % 2 == 0 ? 1 : -1;
      f.add(-sum, base);
    }
    EXPECT_EQ(f.answer(), f.truth());
    EXPECT_EQ(f.negated(), -f.truth());
    if (!broken) {
      EXPECT_EQ(f.answer(), sign::zero);
      ++zeros;
    }
  }
  EXPECT_EQ(zeros, 200);
}

TEST(SquareClasses, ManyClassesAndTwinsWithoutACommonBase) {
  // Twins: a b^2 and a c^2 for huge a, of which neither is a multiple of the other.
  std::mt19937_64 engine(seed + 1);
  square_classes roots;
  for (int i = 0; i < 400; ++i) {
    const integer a = random_integer(engine, 100 + static_cast<unsigned>(engine() % 200));
    const integer b = random_integer(engine, 70);
    const integer c = random_integer(engine, 70);
    form f(roots);
    f.add(c, a * b * b);
    f.add(-b, a * c * c);
    EXPECT_EQ(f.answer(), sign::zero);
    f.add(integer(-1), integer(2 * i + 1));
    EXPECT_EQ(f.answer(), sign::negative);
  }
}

TEST(SquareClasses, AlmostZero) {
  std::mt19937_64 engine(seed + 2);
  for (const unsigned e : {5U, 10U, 20U, 40U, 100U, 400U}) {
    SCOPED_TRACE(e);
    const integer n = power(10, e);
    square_classes roots;
    for (int i = 0; i < 20; ++i) {
      const integer c = random_integer(engine, 1 + static_cast<unsigned>(i) * 10);
      form above(roots);  // c (sqrt(n^2 + 1) - n)
      above.add(c, n * n + 1);
      above.add(-c * n, integer(1));
      EXPECT_EQ(above.answer(), sign::positive);
      EXPECT_EQ(above.negated(), sign::negative);
      form below(roots);
      below.add(c, n * n - 1);
      below.add(-c, n * n);
      EXPECT_EQ(below.answer(), sign::negative);
      // sqrt(n^2 + 1) - n - 1 / (2n) < 0, with the denominator multiplied out
      form second(roots);
      second.add(2 * n * c, n * n + 1);
      second.add(-c * (2 * n * n + 1), integer(1));
      EXPECT_EQ(second.answer(), sign::negative);
      // The same, its terms hidden in other members of their classes.
      form hidden(roots);
      hidden.add(2 * n * c, (n * n + 1) * 49);
      hidden.add(-7 * c, (2 * n * n + 1) * (2 * n * n + 1));
      EXPECT_EQ(hidden.answer(), sign::negative);
    }
  }
}

// The k-th difference of the root at n is about n^(1/2 - k), of sign (-1)^(k-1): eight roots nearly cancel.
TEST(SquareClasses, DifferencesOfHighOrder) {
  for (const unsigned digits : {2U, 10U, 30U, 60U}) {
    square_classes roots;
    integer n = power(10, digits) + 7;
    for (int order = 1; order <= 7; ++order) {
      form f(roots);
      integer binomial = 1;
      for (int i = 0; i <= order; ++i) {
        f.add((order - i) % 2 == 0 ? binomial : integer(-binomial), n + i);
        binomial = binomial * (order - i) / (i + 1);
      }
      EXPECT_EQ(f.answer(), signed_if(order % 2 == 1)) << digits << ' ' << order;
      EXPECT_EQ(f.answer(), f.truth());
    }
  }
}

TEST(SquareClasses, LargeRadicands) {
  std::mt19937_64 engine(seed + 3);
  square_classes roots;
  for (int i = 0; i < 30; ++i) {
    const integer s = random_integer(engine, 3000);
    const integer m = random_integer(engine, 1500);
    form f(roots);
    f.add(m, s);
    f.add(integer(-1), s * m * m);
    EXPECT_EQ(f.answer(), sign::zero);
    f.add(integer(1), s * m * m + 1);
    f.add(integer(-1), s * m * m);
    EXPECT_EQ(f.answer(), sign::positive) << "sqrt(x + 1) - sqrt(x) for x of 6000 bits";
  }
}

// Numbers that share a factor with a modulus of the signature have no signature and are compared with all classes. They
// must find their class whether it was made by a number with or without a signature, in either order.
TEST(SquareClasses, RadicandsDivisibleByTheModuli) {
  const std::vector<integer> wild = moduli();
  for (const bool tame_first : {true, false}) {
    square_classes roots;
    for (const integer& base :
         {integer(1), integer(2), integer(3), integer(35), integer(1009), wild[0], wild[10], integer(wild[0] * wild[1]), integer(6 * wild[3])}) {
      for (const integer& p : wild) {
        form f(roots);
        if (tame_first) f.add(p, base);
        f.add(integer(-1), base * p * p);
        if (!tame_first) f.add(p, base);
        EXPECT_EQ(f.answer(), sign::zero);
        f.add(integer(1), base * p * p * wild[2] * wild[2]);
        f.add(-p, base * wild[2] * wild[2]);
        EXPECT_EQ(f.answer(), sign::zero);
        f.add(integer(1), integer(base * p * p + 1));
        f.add(-p, base);
        EXPECT_EQ(f.answer(), sign::positive);
      }
    }
    // Different wild numbers are different classes.
    for (std::size_t i = 0; i + 1 < wild.size(); ++i) {
      form f(roots);
      f.add(integer(1), wild[i] * wild[i + 1]);
      f.add(integer(-1), wild[i] * wild[i + 1] * 4);
      EXPECT_EQ(f.answer(), sign::negative);
      f.add(integer(1), wild[i] * wild[i + 1]);
      EXPECT_EQ(f.answer(), sign::zero);
      f.add(integer(1), wild[i]);
      f.add(integer(-1), wild[i + 1]);
      EXPECT_EQ(f.answer(), f.truth());
      EXPECT_NE(f.answer(), sign::zero);
    }
  }
}

}  // namespace
}  // namespace osteon
