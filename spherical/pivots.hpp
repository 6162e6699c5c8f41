// The sphere's part of two and three orientations and of given axes (modules/framework/given_pivots.hpp has the rest).
//
// The axis of an RR dyad keeps its angle from its partner in every pose (spherical/equal_angles.hpp); a partner at 90
// deg makes a slider. Axes are seen from the fixed frame, the moving ones in pose 1, until they are shown. Given axes
// may have any length but zero.
#pragma once

#include "burmester/modules/framework/given_pivots.hpp"
#include "burmester/spherical/dyads.hpp"
#include "burmester/spherical/equal_angles.hpp"

namespace burmester::spherical {

/// Q_to conj(Q_from): the rotation from one pose to another, seen from the fixed frame; quaternions of any norm.
template <class T>
Space::Point<T> rotation_between(const Space::Point<T>& from, const Space::Point<T>& to) {
  return Space::product<T>(to, Space::conjugate<T>(from));
}

struct Pivots {
  using Space = spherical::Space;
  using Pose = spherical::Pose;
  using Dyads = spherical::Dyads;
  static constexpr const char* pivot = "axis";
  static constexpr const char* pivots = "axes";
  static constexpr const char* pole = "axis of rotation";
  static constexpr const char* locus = "great circle";
  static constexpr const char* bisector = "the great circle between its two places";

  static DataOf<double> data(const Pose& p) {
    const Space::Point<double> q = Space::point<double>(p);
    return {q[0], q[1], q[2], q[3]};
  }
  template <class T>
  static Correlation<T> correlation(const DataOf<T>& from, const DataOf<T>& to) {
    return angle_kept<T>(rotation_between<T>(point(from), point(to)));
  }
  /// A given axis, times any positive number.
  template <class T>
  static Point2<T> seen(Body body, const DataOf<T>& from, const std::vector<T>& p) {
    const Space::Feature<T> axis(p[0], p[1], p[2]);
    return body == Body::fixed ? axis : Space::act<T>(point(from), axis);
  }
  static Found<Dyads::Design> dyad(Body given, const std::vector<double>& axis, const Point2<Rational>& partner,
                                   std::span<const Pose> poses, bool certify);
  static const char* complaint(const std::vector<double>& axis);
  static std::vector<Found<Dyads::Design>> fits(Body given, const std::vector<double>& axis,
                                                std::span<const Pose> poses);
  static double rounding(const std::vector<double>& axis, std::span<const Pose> poses);
  static PartnersRecord partners(Body given, const std::vector<double>& axis, const LinearForm<double>& line,
                                 const Pose& first);
  /// count + 1 axes of the great circle in equal steps, the first as near to the given one as possible.
  static std::vector<Point2<double>> along(const LinearForm<double>& line, const Point2<double>& given, int count);
  /// 36 axes: longitudes every 30 deg, latitudes 15, 45 and 75 deg.
  static std::vector<std::vector<double>> grid(std::span<const Pose> poses);
  static std::optional<PoleRecord> pole_of(const Pose& from, const Pose& to);
  /// "a rotation by 30 deg about the axis (0, 0, 1): "
  static std::string described(const PoleRecord& pole, const Units& units);

 private:
  template <class T>
  static Space::Point<T> point(const DataOf<T>& d) {
    return {d[0], d[1], d[2], d[3]};
  }
};

/// The dyad of two axes (unit vectors), of which that of body `given` is given, as it is listed: a slider or an RR,
/// with residual, condition, and for an RR the slider that it nearly is. Not certified.
Found<Dyads::Design> judged(const Axis& fixed, const Axis& moving, Body given, std::span<const Pose> poses);

/// Two or three orientations, or given axes with any number of orientations. Throws InputError for a given axis that is
/// zero.
Report<Dyads> solve_linear(const Problem& problem, std::span<const Pose> poses);

}  // namespace burmester::spherical
