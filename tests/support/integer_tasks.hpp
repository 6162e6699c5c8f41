// Five poses that meet a planted dyad exactly: all coordinates are integers, X3 and X4 small ones of any
// norm, lengths multiples of the norms so that turned vectors are integers too.
#pragma once

#include <numeric>
#include <vector>

#include "burmester/geometry/rational.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar {

using Place = Vector<Rational, 2>;

/// a + i b times c + i d
inline Place times(const Place& p, const Place& q) {
  return {Rational(p[0] * q[0] - p[1] * q[1]), Rational(p[0] * q[1] + p[1] * q[0])};
}
inline Place conjugate(const Place& p) { return {p[0], Rational(-p[1])}; }

/// Rotation of a pose, as a complex number.
inline Place rotation(const Pose& pose) {
  const Rational s(pose.X3), c(pose.X4), n = s * s + c * c;
  return {Rational((c * c - s * s) / n), Rational(2 * s * c / n)};
}
inline Place origin(const Pose& pose) { return {Rational(pose.x), Rational(pose.y)}; }

struct IntegerTask {
  FivePoseTask poses;
  Place fixed, moving;   ///< RR: both pivots. PR: moving; RP: fixed
  Place normal, offset;  ///< of the line, not of unit length; offset[0] = normal . point
};

namespace detail {

inline Place random_place(Random& random, int size) {
  const int x = random.below(2 * size + 1) - size;
  return {Rational(x), Rational(random.below(2 * size + 1) - size)};
}

/// Five turned poses without origins, and the common multiple of their norms.
inline int random_turns(Random& random, FivePoseTask& poses) {
  int multiple = 1;
  for (Pose& pose : poses) {
    const int s = random.below(7) - 3, c = 1 + random.below(4);
    pose = {0, 0, static_cast<double>(s), static_cast<double>(c)};
    multiple = std::lcm(multiple, s * s + c * c);
  }
  return multiple;
}

inline void put(Pose& pose, const Place& at) { pose.x = approximate(at[0]), pose.y = approximate(at[1]); }

/// A point with integer coordinates on the circle of radius 1105 = 5 * 13 * 17 about the origin.
inline Place on_circle(Random& random) {
  static const std::vector<Place> points = [] {
    std::vector<Place> out;
    for (int a = -1105; a <= 1105; ++a)
      for (int b = -1105; b <= 1105; ++b)
        if (a * a + b * b == 1105 * 1105) out.push_back({Rational(a), Rational(b)});
    return out;
  }();
  return points[static_cast<std::size_t>(random.below(static_cast<int>(points.size())))];
}

}  // namespace detail

/// The circle has radius 1105.
inline IntegerTask integer_RR_task(Random& random) {
  IntegerTask t;
  const Rational multiple = detail::random_turns(random, t.poses);
  t.moving = multiple * detail::random_place(random, 20), t.fixed = detail::random_place(random, 1000);
  for (Pose& p : t.poses) detail::put(p, t.fixed + detail::on_circle(random) - times(rotation(p), t.moving));
  return t;
}

inline IntegerTask integer_PR_task(Random& random) {
  IntegerTask t;
  const Rational multiple = detail::random_turns(random, t.poses);
  const Place point = detail::random_place(random, 1000), along{Rational(3), Rational(1 + random.below(20))};
  t.moving = multiple * detail::random_place(random, 20);
  t.normal = {Rational(-along[1]), along[0]}, t.offset = {Rational(t.normal.dot(point)), Rational(0)};
  for (Pose& p : t.poses)
    detail::put(p, point + Rational(random.below(400) - 200) * along - times(rotation(p), t.moving));
  return t;
}

inline IntegerTask integer_RP_task(Random& random) {
  IntegerTask t;
  const Rational multiple = detail::random_turns(random, t.poses);
  const Place point = multiple * detail::random_place(random, 20),
              along{Rational(3), Rational(1 + random.below(20))};
  t.fixed = detail::random_place(random, 1000);
  t.normal = {Rational(-along[1]), along[0]}, t.offset = {Rational(t.normal.dot(point)), Rational(0)};
  for (Pose& p : t.poses) {
    const Place on_line = point + multiple * Rational(random.below(40) - 20) * along;
    detail::put(p, t.fixed - times(rotation(p), on_line));
  }
  return t;
}

}  // namespace burmester::planar
