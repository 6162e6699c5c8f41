#include "burmester/geometry/root_isolation.hpp"

#include <utility>

namespace burmester::detail {
namespace {

int bits_of(const Integer& x) { return static_cast<int>(msb(abs(x))) + 1; }

/// B with |x| < 2^B for all roots x != 0: Fujiwara's bound 2 max |c[n-k] / c[n]|^(1/k), rounded up.
int root_bound(const IntegerPolynomial& p) {
  const int n = p.degree(), top = bits_of(p.leading());
  std::optional<int> bound;
  for (int k = 1; k <= n; ++k) {
    if (p[n - k] == 0) continue;
    const int excess = bits_of(p[n - k]) - top + 1;
    const int root = 1 + (excess >= 0 ? (excess + k - 1) / k : -(-excess / k));
    bound = bound ? std::max(*bound, root) : root;
  }
  return bound.value_or(0);
}

/// A positive multiple of p(2^exponent x).
IntegerPolynomial stretched(const IntegerPolynomial& p, int exponent) {
  std::vector<Integer> c = p.coefficients();
  for (int k = 0, n = p.degree(); k <= n; ++k)
    c[static_cast<std::size_t>(k)] <<= exponent >= 0 ? exponent * k : -exponent * (n - k);
  return IntegerPolynomial(std::move(c));
}

/// Sign changes of (1 + x)^n q(1 / (1 + x)), counted up to 2: Descartes' bound for the roots between 0 and 1.
int sign_changes(const IntegerPolynomial& q) {
  const IntegerPolynomial positive = q.reversed().shifted(1);
  int changes = 0, last = 0;
  for (const Integer& c : positive.coefficients()) {
    const int sign = c.sign();
    if (sign * last < 0 && ++changes == 2) break;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// Searches cells (at, at + 1) 2^(exponent - depth); q(x), 0 <= x <= 1, is the polynomial there.
class Isolation {
 public:
  explicit Isolation(int exponent) : exponent_(exponent) {}

  void search(const IntegerPolynomial& q, const Integer& at, int depth) {
    const int changes = sign_changes(q);
    if (changes == 0) return;
    if (changes == 1 && q[0] != 0 && q(Integer(1)) != 0) return add(at, 1, depth);
    const IntegerPolynomial left = stretched(q, -1), right = left.shifted(1);
    search(left, 2 * at, depth + 1);
    if (right[0] == 0) add(2 * at + 1, 0, depth + 1);
    search(right, 2 * at + 1, depth + 1);
  }
  /// (at, at + width) 2^(exponent - depth)
  void add(const Integer& at, int width, int depth) {
    const int scale = depth - exponent_, up = std::max(0, -scale);
    found.push_back({at << up, Integer(width) << up, std::max(0, scale)});
  }
  std::vector<DyadicInterval> found;

 private:
  int exponent_;
};

}  // namespace

std::vector<DyadicInterval> isolate_roots(const IntegerPolynomial& p) {
  const int exponent = root_bound(p);
  Isolation isolation(exponent);
  const IntegerPolynomial q = stretched(p, exponent);
  isolation.search(q.shifted(-1), -1, 0);
  if (q[0] == 0) isolation.add(0, 0, 0);
  isolation.search(q, 0, 0);
  return std::move(isolation.found);
}

Refinement::Refinement(const IntegerPolynomial& p, DyadicInterval box) : p_(p), box_(std::move(box)) {
  const Integer high = box_.low + box_.width;
  value_low_ = scaled_value(p_, box_.low, box_.scale), value_high_ = scaled_value(p_, high, box_.scale);
  if (value_high_ == 0) box_.low = high;
  if (value_low_ == 0 || value_high_ == 0) box_.width = 0;
}

void Refinement::step() {
  while (!try_secant()) bits_ = std::max(1, bits_ / 2);
  bits_ *= 2;
}

/// Divides the interval into 2^bits cells and looks at the one where the secant says that the root is, on the nearer
/// side of the grid point closest to the secant's zero. Two cells are always enough for bits = 1.
bool Refinement::try_secant() {
  const Integer cells = Integer(1) << bits_;
  Integer j = ((value_low_ << (bits_ + 1)) / (value_low_ - value_high_) + 1) >> 1;
  j = std::min(std::max(j, Integer(1)), Integer(cells - 1));
  const int scale = box_.scale + bits_, growth = bits_ * p_.degree();
  const Integer origin = box_.low << bits_;
  const auto value_at = [&](const Integer& cell) {
    if (cell == 0) return value_low_ << growth;
    if (cell == cells) return value_high_ << growth;
    return scaled_value(p_, origin + cell * box_.width, scale);
  };
  const Integer value = value_at(j);
  const bool root_is_above = value.sign() == value_low_.sign();
  const Integer other = root_is_above ? j + 1 : j - 1;
  const Integer value_other = value == 0 ? value : value_at(other);
  if (value.sign() * value_other.sign() > 0) return false;
  const Integer cell = value == 0 ? j : value_other == 0 ? other : std::min(j, other);
  box_ = {origin + cell * box_.width, value_other == 0 ? Integer(0) : box_.width, scale};
  value_low_ = root_is_above ? value : value_other, value_high_ = root_is_above ? value_other : value;
  return true;
}

}  // namespace burmester::detail
