#include "burmester/geometry/integer_polynomial.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace burmester {
namespace {

constexpr std::uint64_t prime = 0x7fffffff;  // 2^31 - 1: products fit into 64 bits

std::uint64_t power(std::uint64_t x, std::uint64_t exponent) {
  std::uint64_t out = 1;
  for (; exponent > 0; exponent /= 2, x = x * x % prime)
    if (exponent % 2 == 1) out = out * x % prime;
  return out;
}

/// Modulo the prime, trimmed.
std::vector<std::uint64_t> residues(const IntegerPolynomial& p) {
  std::vector<std::uint64_t> out;
  for (const Integer& c : p.coefficients()) {
    const auto r = static_cast<std::int64_t>(c % static_cast<std::int64_t>(prime));
    out.push_back(static_cast<std::uint64_t>(r < 0 ? r + static_cast<std::int64_t>(prime) : r));
  }
  while (!out.empty() && out.back() == 0) out.pop_back();
  return out;
}

void reduce(std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  const std::uint64_t inverse = power(b.back(), prime - 2);
  while (a.size() >= b.size()) {
    const std::uint64_t factor = prime - a.back() * inverse % prime;
    for (std::size_t i = 1; i <= b.size(); ++i)
      a[a.size() - i] = (a[a.size() - i] + factor * b[b.size() - i]) % prime;
    while (!a.empty() && a.back() == 0) a.pop_back();
  }
}

/// Whether that is seen modulo the prime. A common divisor keeps its degree there if one leading coefficient is not a
/// multiple of the prime.
bool proved_coprime(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  std::vector<std::uint64_t> a = residues(p), b = residues(q);
  if (a.size() != p.coefficients().size() && b.size() != q.coefficients().size()) return false;
  while (!b.empty()) {
    reduce(a, b);
    std::swap(a, b);
  }
  return a.size() == 1;
}

/// A non-zero multiple of the remainder of a by b.
IntegerPolynomial remainder(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<Integer> r = a.coefficients();
  while (r.size() >= b.coefficients().size()) {
    const Integer top = r.back();
    const std::size_t shift = r.size() - b.coefficients().size();
    for (Integer& c : r) c *= b.leading();
    for (std::size_t i = 0; i < b.coefficients().size(); ++i) r[i + shift] -= top * b.coefficients()[i];
    while (!r.empty() && r.back() == 0) r.pop_back();
  }
  return IntegerPolynomial(std::move(r));
}

/// a / b. Precondition: b divides a, both are primitive; then all coefficients are integers (Gauss's lemma).
IntegerPolynomial quotient(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<Integer> r = a.coefficients(), q(a.coefficients().size() - b.coefficients().size() + 1);
  for (std::size_t k = q.size(); k-- > 0;) {
    q[k] = r[k + b.coefficients().size() - 1] / b.leading();
    for (std::size_t i = 0; i < b.coefficients().size(); ++i) r[k + i] -= q[k] * b.coefficients()[i];
  }
  return IntegerPolynomial(std::move(q));
}

}  // namespace

IntegerPolynomial primitive_part(const IntegerPolynomial& p) {
  Integer content = 0;
  for (const Integer& c : p.coefficients()) {
    content = gcd(content, c);
    if (content == 1) return p;
  }
  std::vector<Integer> out = p.coefficients();
  for (Integer& c : out) c /= content;
  return IntegerPolynomial(std::move(out));
}

IntegerPolynomial integer_multiple(const Polynomial<Rational>& p) {
  Integer common = 1;
  for (const Rational& c : p.coefficients()) common = lcm(common, Integer(denominator(c)));
  std::vector<Integer> out;
  for (const Rational& c : p.coefficients()) out.push_back(Integer(numerator(c)) * (common / Integer(denominator(c))));
  return primitive_part(IntegerPolynomial(std::move(out)));
}

IntegerPolynomial integer_multiple(std::span<const double> coefficients) {
  constexpr int digits = std::numeric_limits<double>::digits;
  int lowest = std::numeric_limits<int>::max();
  for (const double c : coefficients)
    if (c != 0) lowest = std::min(lowest, std::ilogb(c));
  std::vector<Integer> out;
  for (const double c : coefficients) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(c, &exponent), digits));
    out.push_back(c == 0 ? Integer(0) : Integer(Integer(mantissa) << (exponent - 1 - lowest)));
  }
  return IntegerPolynomial(std::move(out));
}

IntegerPolynomial common_divisor(const IntegerPolynomial& p, const IntegerPolynomial& q) {
  if (proved_coprime(p, q)) return IntegerPolynomial({Integer(1)});
  IntegerPolynomial a = primitive_part(p), b = primitive_part(q);
  while (!b.is_zero()) {
    a = primitive_part(remainder(a, b));
    std::swap(a, b);
  }
  return a.leading() > 0 ? a : -a;
}

std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& p) {
  std::vector<IntegerPolynomial> out;
  for (IntegerPolynomial rest = primitive_part(p); rest.degree() > 0;) {
    const IntegerPolynomial repeated = common_divisor(rest, rest.derivative());
    out.push_back(quotient(rest, repeated));
    rest = repeated;
  }
  return out;
}

Integer scaled_value(const IntegerPolynomial& p, const Integer& at, int scale) {
  Integer value = 0;
  for (int k = p.degree(), shift = 0; k >= 0; --k, shift += scale) value = value * at + (p[k] << shift);
  return value;
}

}  // namespace burmester
