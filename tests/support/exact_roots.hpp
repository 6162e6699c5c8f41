// Real roots of polynomials and binary forms, exactly: Sturm's theorem on primitive integer polynomials. An
// oracle, slow and obvious. (J. C. F. Sturm, 1829; W. S. Brown, "The subresultant PRS algorithm", 1978, for
// primitive chains.)
#pragma once

#include <algorithm>
#include <vector>

#include "burmester/geometry/rational.hpp"

namespace burmester::exact {

/// c[0] + c[1] x + c[2] x^2 + ..; the last coefficient is not zero, the zero polynomial is empty.
using Polynomial = std::vector<Integer>;

inline int sign(const auto& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Divided by a positive number so that the coefficients have no common factor.
inline void make_primitive(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  Integer content = 0;
  for (const Integer& c : p) content = gcd(content, c);
  if (content > 1)
    for (Integer& c : p) c /= content;
}

/// A positive multiple of the polynomial with these coefficients, constant term first.
inline Polynomial polynomial(const std::vector<Rational>& c) {
  Integer common = 1;
  for (const Rational& x : c) common = lcm(common, Integer(denominator(x)));
  Polynomial p;
  for (const Rational& x : c) p.push_back(Integer(numerator(x)) * (common / Integer(denominator(x))));
  make_primitive(p);
  return p;
}

inline Polynomial derivative(const Polynomial& p) {
  Polynomial out;
  for (std::size_t i = 1; i < p.size(); ++i) out.push_back(p[i] * static_cast<int>(i));
  make_primitive(out);
  return out;
}

/// A negative multiple of the remainder of a by b.
inline Polynomial negated_remainder(Polynomial a, const Polynomial& b) {
  while (a.size() >= b.size()) {
    const Integer factor = abs(b.back()), take = a.back() * sign(b.back());
    const std::size_t shift = a.size() - b.size();
    for (Integer& c : a) c *= factor;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= take * b[i];
    a.pop_back();
    make_primitive(a);
  }
  for (Integer& c : a) c = -c;
  return a;
}

/// p, p', and negated remainders; the last one is the greatest common divisor of p and p'.
inline std::vector<Polynomial> sturm_chain(const Polynomial& p) {
  std::vector<Polynomial> chain{p};
  for (Polynomial next = derivative(p); !next.empty();) {
    chain.push_back(next);
    next = negated_remainder(chain[chain.size() - 2], chain.back());
  }
  return chain;
}

inline int sign_changes(const std::vector<int>& signs) {
  int changes = 0, last = 0;
  for (const int s : signs) {
    if (s * last < 0) ++changes;
    if (s != 0) last = s;
  }
  return changes;
}

inline int sign_at(const Polynomial& p, const Rational& x) {
  Rational value = 0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + Rational(p[i]);
  return sign(value);
}

inline int changes_at(const std::vector<Polynomial>& chain, const Rational& x) {
  std::vector<int> signs;
  for (const Polynomial& p : chain) signs.push_back(sign_at(p, x));
  return sign_changes(signs);
}

inline int changes_at_infinity(const std::vector<Polynomial>& chain, int side) {
  std::vector<int> signs;
  for (const Polynomial& p : chain)
    signs.push_back(p.size() % 2 == 0 && side < 0 ? -sign(p.back()) : sign(p.back()));
  return sign_changes(signs);
}

struct RootCount {
  int distinct = 0, counted = 0;  ///< without and with multiplicities
  bool operator==(const RootCount&) const = default;
};

/// Real roots of a polynomial that is not zero. A root of multiplicity m stays in m - 1 repeated gcds with
/// p'.
inline RootCount count_real_roots(Polynomial p) {
  RootCount out;
  for (bool first = true; p.size() > 1; first = false) {
    const std::vector<Polynomial> chain = sturm_chain(p);
    const int distinct = changes_at_infinity(chain, -1) - changes_at_infinity(chain, +1);
    if (first) out.distinct = distinct;
    out.counted += distinct;
    p = chain.back();
  }
  return out;
}

/// Real roots (s : t) of a binary form c[0] s^n + c[1] s^(n-1) t + .. that is not zero; (1 : 0) is one of
/// them.
inline RootCount count_real_roots_of_form(std::vector<Rational> c) {
  const auto leading = std::find_if(c.begin(), c.end(), [](const Rational& x) { return x != 0; });
  const int infinite = static_cast<int>(leading - c.begin());
  std::reverse(c.begin(), c.end());
  RootCount out = count_real_roots(polynomial(c));
  out.distinct += infinite > 0, out.counted += infinite;
  return out;
}

namespace detail {

inline Rational bisected(const Polynomial& p, Rational low, Rational high, const Rational& precision) {
  const int above = sign_at(p, high);
  while (above != 0 && high - low > precision * abs(high)) {
    const Rational middle = (low + high) / 2;
    const int here = sign_at(p, middle);
    if (here == 0) return middle;
    (here == above ? high : low) = middle;
  }
  return high;
}

inline void isolate(const std::vector<Polynomial>& chain, const Rational& low, int changes_low,
                    const Rational& high, int changes_high, const Rational& precision,
                    std::vector<Rational>& out) {
  if (changes_low == changes_high) return;
  if (changes_low - changes_high == 1 && sign_at(chain[0], low) != 0) {
    out.push_back(bisected(chain[0], low, high, precision));
    return;
  }
  const Rational middle = (low + high) / 2;
  const int changes = changes_at(chain, middle);
  isolate(chain, low, changes_low, middle, changes, precision, out);
  isolate(chain, middle, changes, high, changes_high, precision, out);
}

}  // namespace detail

/// The real roots of a square-free polynomial, ascending, each with a relative error below 2^-bits.
/// Precondition: 0 is not a root.
inline std::vector<Rational> real_roots(const Polynomial& p, int bits) {
  Integer largest = 0;
  for (const Integer& c : p) largest = std::max(largest, Integer(abs(c)));
  const Rational bound = 1 + Rational(largest) / Rational(Integer(abs(p.back())));  // Cauchy's
  const std::vector<Polynomial> chain = sturm_chain(p);
  std::vector<Rational> out;
  detail::isolate(chain, -bound, changes_at(chain, -bound), bound, changes_at(chain, bound),
                  Rational(1) / Rational(Integer(1) << bits), out);
  return out;
}

}  // namespace burmester::exact
