#include "burmester/geometry/affine_inertia.hpp"

#include "burmester/geometry/interval.hpp"

namespace burmester {
namespace {

template <class T, int N>
int largest_entry(const Vector<T, N>& v) {
  using std::abs;
  int k = 0;
  for (int i = 1; i < N; ++i)
    if (abs(v[i]) > abs(v[k])) k = i;
  return k;
}

/// The form on the hyperplane l, in the basis l[k] e_i - l[i] e_k, i != k. Precondition: l[k] is not zero.
template <class T, int N>
Matrix<T, N - 1, N - 1> restricted(const Matrix<T, N, N>& m, const Vector<T, N>& l, int k) {
  Matrix<T, N - 1, N - 1> out;
  for (int r = 0; r < N - 1; ++r)
    for (int c = 0; c < N - 1; ++c) {
      const int i = r < k ? r : r + 1, j = c < k ? c : c + 1;
      out(r, c) = l[k] * (l[k] * m(i, j) - l[i] * m(k, j) - l[j] * m(i, k)) + l[i] * l[j] * m(k, k);
    }
  return out;
}

template <class T, class S, int N>
std::optional<AffineInertia> attempt(const Matrix<S, N, N>& m, const Vector<S, N>& infinity, Rung rung) {
  Matrix<T, N, N> form;
  Vector<T, N> l;
  for (int i = 0; i < N * N; ++i) form(i) = T(m(i));
  for (int i = 0; i < N; ++i) l[i] = T(infinity[i]);
  const std::optional<Inertia> whole = inertia(form);
  if (!whole) return std::nullopt;
  const std::optional<Inertia> at_infinity = inertia(restricted(form, l, largest_entry(infinity)));
  if (!at_infinity) return std::nullopt;
  return AffineInertia{*whole, *at_infinity, rung};
}

template <int N>
std::optional<AffineInertia> by_intervals(const Matrix<double, N, N>& m, const Vector<double, N>& infinity) {
  const UpwardRounding upward;
  return attempt<Interval>(m, infinity, Rung::intervals);
}

}  // namespace

template <class T, int N>
AffineInertia affine_inertia(const Matrix<T, N, N>& m, const Vector<T, N>& infinity) {
  if constexpr (std::is_same_v<T, double>)
    if (const auto proved = by_intervals(m, infinity)) return *proved;
  return *attempt<Rational>(m, infinity, Rung::exact);
}

template AffineInertia affine_inertia(const Matrix<double, 3, 3>&, const Vector<double, 3>&);
template AffineInertia affine_inertia(const Matrix<double, 4, 4>&, const Vector<double, 4>&);
template AffineInertia affine_inertia(const Matrix<Rational, 3, 3>&, const Vector<Rational, 3>&);
template AffineInertia affine_inertia(const Matrix<Rational, 4, 4>&, const Vector<Rational, 4>&);

}  // namespace burmester
