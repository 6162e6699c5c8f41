#include "burmester/geometry/grassmann.hpp"

#include <algorithm>
#include <cmath>

#include "burmester/geometry/null_space.hpp"

namespace burmester {
namespace {

/// The null vector of an N x (N + 1) matrix of rank N; nothing for lower ranks. Gauss-Jordan elimination.
template <int N>
std::optional<Vector<Rational, N + 1>> exact_null_vector(Matrix<Rational, N, N + 1> m) {
  int free = N;
  for (int c = 0, row = 0; c <= N; ++c) {
    int p = row;
    while (p < N && m(p, c) == 0) ++p;
    if (p == N) {
      if (row < c) return std::nullopt;  // a second column without a pivot
      free = c;
      continue;
    }
    m.row(row).swap(m.row(p));
    const Rational inverse = 1 / m(row, c);
    for (int j = c; j <= N; ++j) m(row, j) *= inverse;
    for (int r = 0; r < N; ++r) {
      const Rational factor = m(r, c);
      if (r == row || factor == 0) continue;
      for (int j = c; j <= N; ++j) m(r, j) -= factor * m(row, j);
    }
    ++row;
  }
  Vector<Rational, N + 1> out;
  for (int c = 0; c <= N; ++c) out[c] = c == free ? Rational(1) : Rational(-m(c < free ? c : c - 1, free));
  return out;
}

/// In N <= 9 rows with complete pivoting (multipliers up to 1, growth below 20) roundings act like changes of
/// the matrix by 2^-44 of its largest entry, and move the last pivot by up to 4^8 times as much. A last pivot
/// above 2^-28 of the first therefore proves full rank; the larger bound keeps digits too.
constexpr double clear_pivot = 0x1p-20;

template <class T, int Size, std::size_t Count, class Row>
auto rows_of(const std::array<Vector<T, Size>, Count>& points, const Row& row) {
  constexpr int N = static_cast<int>(Count);
  Matrix<T, N, N + 1> m;
  for (int i = 0; i < N; ++i) m.row(i) = row(points[static_cast<std::size_t>(i)]).transpose();
  return m;
}

template <int Size, std::size_t Count, class Row>
auto null_vector(const std::array<Vector<Rational, Size>, Count>& points, const Row& row) {
  return exact_null_vector<static_cast<int>(Count)>(rows_of(points, row));
}

template <int Size, std::size_t Count, class Row>
auto null_vector(const std::array<Vector<double, Size>, Count>& points, const Row& row) {
  using Result = Vector<double, static_cast<int>(Count) + 1>;
  std::array<Vector<double, Size>, Count> unit = points;
  for (auto& p : unit) {
    int exponent = 0;
    std::frexp(p.cwiseAbs().maxCoeff(), &exponent);
    for (double& x : p) x = std::ldexp(x, -exponent);
  }
  const auto space = null_space(rows_of(unit, row));
  if (space.smallest_pivot() > clear_pivot) {
    const Result out = space.basis.col(0);
    return std::optional<Result>(out / out.cwiseAbs().maxCoeff());
  }
  std::array<Vector<Rational, Size>, Count> exact;
  for (std::size_t i = 0; i < Count; ++i)
    for (int k = 0; k < Size; ++k) exact[i][k] = Rational(points[i][k]);
  const auto found = null_vector(exact, row);
  if (!found) return std::optional<Result>();
  Rational size = 0;
  for (const Rational& x : *found) size = std::max(size, Rational(abs(x)));
  Result out;
  for (int i = 0; i < Result::SizeAtCompileTime; ++i)
    out[i] = static_cast<double>(Rational((*found)[i] / size));
  return std::optional<Result>(out);
}

constexpr auto same = [](const auto& p) { return p; };

constexpr auto circle_row = []<class T>(const Point2<T>& p) {
  return Vector<T, 4>(p[0] * p[0] + p[1] * p[1], 2 * p[0] * p[2], 2 * p[1] * p[2], p[2] * p[2]);
};

/// The monomials in the order of a form's coefficients q: squares first.
constexpr auto conic_row = []<class T>(const Point2<T>& p) {
  return Vector<T, 6>{{p[0] * p[0], p[1] * p[1], p[2] * p[2], p[1] * p[2], p[0] * p[2], p[0] * p[1]}};
};
constexpr auto quadric_row = []<class T>(const Point3<T>& p) {
  return Vector<T, 10>{{p[0] * p[0], p[1] * p[1], p[2] * p[2], p[3] * p[3], p[0] * p[1], p[0] * p[2],
                        p[0] * p[3], p[1] * p[2], p[1] * p[3], p[2] * p[3]}};
};

template <class Form, class Coefficients>
std::optional<Form> form_of(const std::optional<Coefficients>& found) {
  if (!found) return std::nullopt;
  Form out;
  std::copy(found->begin(), found->end(), out.q.begin());
  return out;
}

}  // namespace

template <class T>
std::optional<LinearForm<T>> line_through(const std::array<Point2<T>, 2>& points) {
  return null_vector(points, same);
}
template <class T>
std::optional<Vector<T, 4>> circle_through(const std::array<Point2<T>, 3>& points) {
  return null_vector(points, circle_row);
}
template <class T>
std::optional<Conic<T>> conic_through(const std::array<Point2<T>, 5>& points) {
  return form_of<Conic<T>>(null_vector(points, conic_row));
}
template <class T>
std::optional<Point3<T>> plane_through(const std::array<Point3<T>, 3>& points) {
  return null_vector(points, same);
}
template <class T>
std::optional<Quadric<T>> quadric_through(const std::array<Point3<T>, 9>& points) {
  return form_of<Quadric<T>>(null_vector(points, quadric_row));
}

template std::optional<LinearForm<double>> line_through(const std::array<Point2<double>, 2>&);
template std::optional<LinearForm<Rational>> line_through(const std::array<Point2<Rational>, 2>&);
template std::optional<Vector<double, 4>> circle_through(const std::array<Point2<double>, 3>&);
template std::optional<Vector<Rational, 4>> circle_through(const std::array<Point2<Rational>, 3>&);
template std::optional<Conic<double>> conic_through(const std::array<Point2<double>, 5>&);
template std::optional<Conic<Rational>> conic_through(const std::array<Point2<Rational>, 5>&);
template std::optional<Point3<double>> plane_through(const std::array<Point3<double>, 3>&);
template std::optional<Point3<Rational>> plane_through(const std::array<Point3<Rational>, 3>&);
template std::optional<Quadric<double>> quadric_through(const std::array<Point3<double>, 9>&);
template std::optional<Quadric<Rational>> quadric_through(const std::array<Point3<Rational>, 9>&);

}  // namespace burmester
