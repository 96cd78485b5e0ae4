// SPDX-License-Identifier: MIT

// The laws of kernel.hpp for a few planes on every kernel, and kernels against each other: an adaptor gives its base's answers (a perturbed
// one where these are not zero), speeds that are rational make the square-root and the rational kernel the same, and floating
// point of 500 digits is right wherever it is certain.

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "check.hpp"
#include "decode.hpp"
#include "osteon/core/error.hpp"
#include "osteon/kernel/double.hpp"
#include "osteon/kernel/filtered.hpp"
#include "osteon/kernel/perturbed.hpp"
#include "osteon/kernel/rational.hpp"
#include "osteon/kernel/sqrt.hpp"

namespace osteon::fuzz {
namespace {

using plane = moving_plane<integer>;
using planes = std::vector<plane>;
using vector = std::array<integer, 3>;

integer dot(const vector& a, const vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// What is asked of each kernel, the same for all.
struct questions {
  std::vector<triple> corners;
  std::vector<quadruple> meetings;                       // ascending, different
  std::vector<std::pair<std::size_t, quadruple>> sides;  // at a meeting: the last plane against the corner of the first three
  std::vector<std::pair<plane_id, plane_id>> edges;
  std::array<std::vector<triple>, 2> trees;
  std::vector<int> grades;
  bool common_point;
};

// ---- decoding

template <std::size_t N>
std::array<plane_id, N> different(decoder& d, plane_id below) {
  std::array<plane_id, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = static_cast<plane_id>(d.between(0, below - 1));
    while (std::find(result.begin(), result.begin() + i, result[i]) != result.begin() + i) result[i] = (result[i] + 1) % below;
  }
  return result;
}

vector quaternion_normal(const integer& a, const integer& b, const integer& c, const integer& e) {
  return {a * a + b * b - c * c - e * e, 2 * (b * c + a * e), 2 * (b * e - a * c)};
}

vector small_vector(decoder& d, long most) {
  const long x = d.between(-most, most);
  const long y = d.between(-most, most);
  return {integer(x), integer(y), integer(d.between(-most, most))};
}

vector decode_normal(decoder& d, const planes& before, bool rational_length) {
  enum kind { small, bytes, quaternion, long_quaternion, symmetric, wide, dependent, nearly_parallel, huge, kinds };
  const auto which = static_cast<kind>(d.between(0, rational_length ? 2 : kinds - 1));
  const auto earlier = [&]() -> const vector& { return before[d.index(before.size())].n; };
  if (rational_length) {
    if (which == small || before.empty()) return quaternion_normal(d.between(-2, 2), d.between(-2, 2), d.between(-2, 2), d.between(-2, 2));
    if (which == bytes) return quaternion_normal(d.wide(3), d.wide(3), d.wide(3), d.wide(3));
  } else {
    if (which == small || (before.empty() && which >= symmetric && which != wide && which != huge)) return small_vector(d, 2);
    if (which == bytes) return small_vector(d, 127);
    if (which == quaternion) return quaternion_normal(d.between(-2, 2), d.between(-2, 2), d.between(-2, 2), d.between(-2, 2));
    if (which == long_quaternion) return quaternion_normal(d.wide(3), d.wide(3), d.wide(3), d.wide(3));
    if (which == wide) return {d.wide(5), d.wide(5), d.wide(5)};
    if (which == huge) {  // beyond the range of doubles
      vector n = small_vector(d, 127);
      for (integer& x : n) x <<= static_cast<unsigned>(d.between(0, 1200));
      return n;
    }
    if (which == dependent) {
      vector n = earlier();
      const vector m = earlier();
      const long a = d.between(-3, 3);
      const long b = d.between(-3, 3);
      const vector nudge = d.flag() ? small_vector(d, 1) : vector{0, 0, 0};
      for (int axis = 0; axis < 3; ++axis) n[axis] = a * n[axis] + b * m[axis] + nudge[axis];
      return n;
    }
    if (which == nearly_parallel) {
      vector n = earlier();
      const auto shift = static_cast<unsigned>(d.between(0, 60));
      const vector nudge = small_vector(d, 127);
      for (int axis = 0; axis < 3; ++axis) n[axis] = (n[axis] << shift) + nudge[axis];
      return n;
    }
  }
  vector n = earlier();
  const auto turn = static_cast<unsigned>(d.byte());
  std::rotate(n.begin(), n.begin() + turn % 3, n.end());
  for (unsigned axis = 0; axis < 3; ++axis)
    if ((turn >> (4 + axis) & 1U) != 0) n[axis] = -n[axis];
  if ((turn >> 7U) != 0) std::swap(n[0], n[1]);
  return n;
}

planes decode_planes(decoder& d, bool rational_lengths, bool common_point, bool weighted) {
  const auto count = static_cast<std::size_t>(d.between(4, 8));
  const vector apex = small_vector(d, 7);
  planes result;
  while (result.size() < count) {
    plane p;
    p.n = decode_normal(d, result, rational_lengths);
    if (dot(p.n, p.n) == 0) p.n[result.size() % 3] = 1;
    p.d = dot(p.n, apex);
    if (!common_point) {
      switch (d.between(0, 3)) {
        case 0:
          p.d = d.between(-8, 8);
          break;
        case 1:
          p.d += d.between(-1, 1);
          break;
        case 2:
          p.d = d.wide(6);
          break;
        default:
          p.d = d.wide(2) << static_cast<unsigned>(d.between(0, 900));
      }
    }
    if (weighted) p.weight = d.one_in(4) ? integer(abs(d.wide(8)) + 1) : integer(d.between(1, 5));
    result.push_back(p);
  }
  return result;
}

std::vector<triple> fan(const std::vector<plane_id>& ring, std::size_t hub) {
  std::vector<triple> result;
  const std::size_t n = ring.size();
  for (std::size_t i = 1; i + 1 < n; ++i) result.push_back({ring[hub], ring[(hub + i) % n], ring[(hub + i + 1) % n]});
  return result;
}

questions decode_questions(decoder& d, plane_id count, bool common_point) {
  questions q;
  q.common_point = common_point;
  for (plane_id a = 0; a < count; ++a)
    for (plane_id b = a + 1; b < count; ++b)
      for (plane_id c = b + 1; c < count; ++c)
        if (q.corners.size() < 20) q.corners.push_back({a, b, c});
  for (auto n = d.between(3, 7); n > 0; --n) {
    auto m = different<4>(d, count);
    std::sort(m.begin(), m.end());
    if (std::find(q.meetings.begin(), q.meetings.end(), m) == q.meetings.end()) q.meetings.push_back(m);
  }
  for (auto n = d.between(2, 8); n > 0; --n) {
    const std::size_t at = d.index(q.meetings.size());
    q.sides.emplace_back(at, d.flag() ? q.meetings[d.index(q.meetings.size())] : different<4>(d, count));
  }
  for (auto n = d.between(2, 5); n > 0; --n) {
    const auto e = different<2>(d, count);
    q.edges.emplace_back(e[0], e[1]);
  }
  std::vector<plane_id> ring;
  for (plane_id p = 0; p < std::min<plane_id>(count, 6); ++p) ring.push_back(p);
  q.trees = {fan(ring, d.index(ring.size())), fan(ring, d.index(ring.size()))};
  for (auto n = d.between(1, 4); n > 0; --n) q.grades.push_back(static_cast<int>(d.between(0, highest_grade)));
  return q;
}

// ---- asking

constexpr signed char not_asked = 3;
using answers = std::vector<signed char>;

template <class K>
inline constexpr bool never_zero = false;
template <class K>
inline constexpr bool never_zero<perturbed<K>> = true;

// Laws hold for exact kernels only; the double kernel has to survive the questions.
template <class K>
void law(bool holds, const char* what) {
  if constexpr (K::exact) require(holds, what);
}

template <class K>
void check_order(const std::vector<std::vector<sign>>& order, const char* antisymmetric, const char* transitive) {
  const std::size_t n = order.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b) {
      law<K>(order[a][b] == -order[b][a], antisymmetric);
      for (std::size_t c = 0; c < n; ++c) {
        if (order[a][b] == sign::zero) law<K>(order[a][c] == order[b][c], transitive);
        if (order[a][b] == sign::negative && order[b][c] == sign::negative) law<K>(order[a][c] == sign::negative, transitive);
      }
    }
}

template <kernel<3> K>
class interview {
 public:
  interview(const K& k, const questions& q) : k_(k), q_(q) {}

  answers run() {
    ask_corners();
    ask_meetings();
    ask_sides();
    ask_edges();
    ask_volumes();
    if constexpr (graded_kernel<K>) ask_grades();
    return std::move(said_);
  }

 private:
  sign note(sign s) {
    said_.push_back(static_cast<signed char>(s));
    return s;
  }

  // K1
  void ask_corners() {
    for (const auto& [a, b, c] : q_.corners) {
      const sign s = note(k_.orientation(a, b, c));
      law<K>(k_.orientation(b, c, a) == s && k_.orientation(c, a, b) == s, "K1: orientation is cyclic");
      law<K>(k_.orientation(b, a, c) == -s && k_.orientation(a, c, b) == -s && k_.orientation(c, b, a) == -s, "K1: orientation is alternating");
      law<K>(s != sign::zero || !never_zero<K>, "a perturbed orientation is never zero");
      note(signed_if(k_.transversal(a, b, c)));
    }
  }

  // K2, K3
  void ask_meetings() {
    for (const auto& q : q_.meetings) {
      meetings_.push_back(k_.meet(q));
      const auto& m = meetings_.back();
      law<K>(m.has_value() || !never_zero<K>, "perturbed planes meet");
      const auto n = k_.meet({q[2], q[0], q[3], q[1]});
      law<K>(m.has_value() == n.has_value(), "K2: meet forgets the order");
      note(m ? k_.closing(*m) : sign::zero);
      if (!m || !n) continue;
      law<K>(quadruple(k_.planes(*m)) == q && quadruple(k_.planes(*n)) == q, "planes of a meeting ascend");
      law<K>(k_.closing(*m) != sign::zero && k_.closing(*m) == k_.closing(*n), "K2: closing forgets the order");
      law<K>(k_.compare(*m, *n) == sign::zero, "K3: a meeting is simultaneous with itself");
    }
    auto all = meetings_;
    all.push_back(k_.start());
    std::vector<std::vector<sign>> order;
    std::vector<typename K::meeting> there;
    for (const auto& m : all) {
      for (const auto& n : all) {
        if (!m || !n) {
          said_.push_back(not_asked);
          continue;
        }
        const sign s = note(k_.compare(*m, *n));
        if (never_zero<K> && quadruple(k_.planes(*m)) != quadruple(k_.planes(*n))) law<K>(s != sign::zero, "perturbed moments differ");
      }
      if (m) there.push_back(*m);
    }
    for (const auto& m : there) {
      auto& row = order.emplace_back();
      for (const auto& n : there) row.push_back(k_.compare(m, n));
    }
    check_order<K>(order, "K3: compare is antisymmetric", "K3: compare is transitive");
  }

  // K2; and L(t) = D - t S changes its sign at the meeting.
  void ask_sides() {
    for (const auto& [at, q] : q_.sides) {
      const auto& m = meetings_[at];
      const auto& [a, b, c, d] = q;
      const sign corner = k_.orientation(a, b, c);
      if (!m || corner == sign::zero) {
        said_.push_back(not_asked);
        said_.push_back(not_asked);
        continue;
      }
      const sign s = note(k_.side(d, a, b, c, *m));
      law<K>(k_.side(d, b, a, c, *m) == s && k_.side(d, c, a, b, *m) == s, "K2: side forgets the order");
      const auto tau = k_.meet(q);
      // lambda of the last plane is the corner's orientation, up to the parity of sorting, which closing has too.
      const sign last = corner * parity(q);
      if (tau) law<K>(s == -k_.compare(*m, *tau) * k_.closing(*tau) * last, "a vertex changes its side at the meeting");
      if (!q_.common_point) {
        said_.push_back(not_asked);
        continue;
      }
      const sign start = note(k_.side(d, a, b, c, k_.start()));
      law<K>(start != sign::zero || !never_zero<K>, "a perturbed side at the start is never zero");
      if (tau) law<K>(start == -k_.compare(k_.start(), *tau) * k_.closing(*tau) * last, "at the start of a corner only speeds count");
    }
  }

  // K3
  void ask_edges() {
    std::vector<std::vector<sign>> order;
    for (const auto& e : q_.edges) {
      auto& row = order.emplace_back();
      for (const auto& f : q_.edges) {
        row.push_back(note(k_.compare(k_.bisector(e.first, e.second), k_.bisector(f.first, f.second))));
        law<K>(k_.compare(k_.bisector(e.second, e.first), k_.bisector(f.first, f.second)) == row.back(), "K2: an edge forgets the order");
      }
    }
    check_order<K>(order, "K3: angles are antisymmetric", "K3: angles are transitive");
  }

  void ask_volumes() {
    const auto& [s, t] = q_.trees;
    try {
      const sign order = note(k_.compare_volume(s, t));
      law<K>(k_.compare_volume(t, s) == -order, "volumes are antisymmetric");
      law<K>(k_.compare_volume(s, s) == sign::zero, "a volume equals itself");
    } catch (const degenerate_error&) {
      said_.push_back(not_asked);
    } catch (const undecided_error&) {
      if (K::exact) throw;
      said_.push_back(not_asked);
    }
  }

  void ask_grades() requires graded_kernel<K> {
    for (const int g : q_.grades) {
      for (std::size_t i = 0; i < std::min<std::size_t>(q_.corners.size(), 3); ++i) note(k_.orientation_at(g, q_.corners[i]));
      for (std::size_t i = 0; i < q_.meetings.size(); ++i) {
        note(k_.offset_at(g, q_.meetings[i]));
        note(k_.closing_at(g, q_.meetings[i]));
        note(k_.cross_at(g, q_.meetings[i], q_.meetings[(i + 1) % q_.meetings.size()]));
      }
    }
  }

  const K& k_;
  const questions& q_;
  answers said_;
  std::vector<std::optional<typename K::meeting>> meetings_;
};

template <kernel<3> K>
answers ask(const K& k, const questions& q) {
  return interview<K>(k, q).run();
}

// Wherever the unperturbed kernel said something but zero; it may have been asked more at the end (grades).
void require_agreement(const answers& unperturbed, const answers& other, const char* law) {
  for (std::size_t i = 0; i < std::min(unperturbed.size(), other.size()); ++i)
    if (unperturbed[i] == 1 || unperturbed[i] == -1) require_equal(static_cast<sign>(other[i]), static_cast<sign>(unperturbed[i]), law);
}

// ---- what is true, by floating point of 500 digits

class reference {
 public:
  explicit reference(const planes& p) : p_(p) {}

  // Nothing where it is not certain.
  std::optional<sign> closing(const quadruple& q) const { return certain(terms(q, &reference::speed)); }

  std::optional<sign> compare(const quadruple& q, const quadruple& r) const {
    const auto s = closing(q);
    const auto t = closing(r);
    if (!s || !t) return std::nullopt;
    const auto [dq, dq_size] = terms(q, &reference::offset);
    const auto [sq, sq_size] = terms(q, &reference::speed);
    const auto [dr, dr_size] = terms(r, &reference::offset);
    const auto [sr, sr_size] = terms(r, &reference::speed);
    const auto cross = certain({dq * sr - dr * sq, dq_size * sr_size + dr_size * sq_size});
    return cross ? std::optional(*cross * *s * *t) : std::nullopt;
  }

 private:
  using real = boost::multiprecision::number<boost::multiprecision::gmp_float<500>, boost::multiprecision::et_off>;
  struct sum {
    real value;
    real size;  // of its terms
  };

  real offset(plane_id i) const { return real(p_[i].d); }
  real speed(plane_id i) const { return sqrt(real(dot(p_[i].n, p_[i].n))) * real(p_[i].weight); }

  sum terms(const quadruple& q, real (reference::*last)(plane_id) const) const {
    sum result{0, 0};
    for (int r = 0; r < 4; ++r) {
      std::array<const vector*, 3> n{};
      for (int s = 0, i = 0; s < 4; ++s)
        if (s != r) n[i++] = &p_[q[s]].n;
      const auto& [a, b, c] = n;
      const integer det = (*a)[0] * ((*b)[1] * (*c)[2] - (*b)[2] * (*c)[1]) - (*a)[1] * ((*b)[0] * (*c)[2] - (*b)[2] * (*c)[0]) +
                          (*a)[2] * ((*b)[0] * (*c)[1] - (*b)[1] * (*c)[0]);
      const real term = real(r % 2 == 0 ? integer(-det) : det) * (this->*last)(q[r]);
      result.value += term;
      result.size += abs(term);
    }
    return result;
  }

  static std::optional<sign> certain(const sum& s) {
    if (abs(s.value) <= s.size * real("1e-480")) return std::nullopt;
    return sign_of(s.value);
  }

  const planes& p_;
};

void check_truth(const planes& p, const questions& q, const sqrt_kernel& k) {
  const reference truth(p);
  for (const auto& m : q.meetings) {
    const auto met = k.meet(m);
    const auto s = truth.closing(m);
    if (s) require_equal(met ? k.closing(*met) : sign::zero, *s, "closing is true");
    for (const auto& n : q.meetings) {
      const auto other = k.meet(n);
      const auto order = met && other ? truth.compare(m, n) : std::nullopt;
      if (order) require_equal(k.compare(*met, *other), *order, "compare is true");
    }
  }
}

// ---- all kernels

template <class Make>
answers check_family(const planes& p, const planes& multiples, const questions& q, Make make) {
  const auto base = make(p);
  const answers truth = ask(base, q);
  const filtered fast(std::span<const plane>(p), make(p));
  require(ask(fast, q) == truth, "filtered answers as its base");
  const answers ties_broken = ask(perturbed(make(p)), q);
  require_agreement(truth, ties_broken, "perturbed answers as its base where that is not zero");
  require(ask(perturbed(fast), q) == ties_broken, "perturbed answers alike over a filter");
  require_agreement(truth, ask(perturbed(fast, true), q), "mirrored perturbation answers as its base where that is not zero");

  const filtered scaled(std::span<const plane>(multiples), make(multiples));
  answers of_multiples = ask(scaled, q);
  answers expected = truth;
  // Above grade 0 a multiple of an equation is perturbed otherwise.
  const std::size_t ungraded = ties_broken.size();
  of_multiples.resize(ungraded);
  expected.resize(ungraded);
  require(of_multiples == expected, "K4: multiples of an equation are the same plane");
  require_agreement(expected, ask(perturbed(scaled), q), "K4: perturbed multiples are the same plane where there is no tie");
  return truth;
}

void run(decoder d) {
  const unsigned mode = d.byte();
  const bool rational_lengths = (mode & 3U) == 1;
  const bool common_point = (mode & 12U) == 4;
  const bool weighted = (mode & 48U) == 16;
  const planes p = decode_planes(d, rational_lengths, common_point, weighted);
  const questions q = decode_questions(d, static_cast<plane_id>(p.size()), common_point);
  planes multiples = p;
  for (plane& one : multiples) {
    integer factor = d.between(1, 7);
    if (d.one_in(4)) factor = abs(d.wide(9)) + 1;
    for (integer& x : one.n) x *= factor;
    one.d *= factor;
  }

  const answers roots = check_family(p, multiples, q, [](const planes& of) { return make_sqrt_kernel(of); });
  const answers rationals = check_family(p, multiples, q, [](const planes& of) { return make_rational_kernel(of); });
  if (rational_lengths) require(roots == rationals, "rational lengths make both exact kernels the same");
  check_truth(p, q, make_sqrt_kernel(p));
  try {
    ask(make_double_kernel(p), q);
  } catch (const undecided_error&) {
  }
  bool tie = false;
  for (std::size_t i = 0; i < q.corners.size(); ++i) tie = tie || roots[2 * i] == 0;
  tally::add(tie ? "with dependent normals" : "without dependent normals");
}

}  // namespace
}  // namespace osteon::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  osteon::fuzz::run(osteon::fuzz::decoder({data, size}));
  return 0;
}
