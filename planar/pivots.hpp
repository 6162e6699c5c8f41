// The plane's part of two and three poses and of given pivots (modules/framework/given_pivots.hpp has the rest).
//
// The pivot of an RR dyad is at the same distance from its partner in every pose (planar/equidistance.hpp). A partner
// at infinity makes a slider: PR for a given moving pivot, RP for a given fixed one. Everything is seen from pose 1's
// origin in directions of S until it is shown.
#pragma once

#include "burmester/modules/framework/given_pivots.hpp"
#include "burmester/planar/equidistance.hpp"
#include "burmester/planar/five_pose_solver.hpp"

namespace burmester::planar {

struct Pivots {
  using Space = planar::Space;
  using Pose = planar::Pose;
  using Dyads = planar::Dyads;
  static constexpr const char* pivot = "pivot";
  static constexpr const char* pivots = "pivots";
  static constexpr const char* pole = "pole";
  static constexpr const char* locus = "line";
  static constexpr const char* bisector = "the perpendicular bisector of its two places";

  static DataOf<double> data(const Pose& p) { return {p.x, p.y, p.X3, p.X4}; }
  template <class T>
  static Correlation<T> correlation(const DataOf<T>& from, const DataOf<T>& to) {
    return equidistance<T>(PoseOver<T>(from), PoseOver<T>(to), 1);
  }
  /// Homogeneous coordinates of a given pivot from the pose's origin, in directions of S.
  template <class T>
  static Point2<T> seen(Body body, const DataOf<T>& from, const std::vector<T>& p) {
    if (body == Body::fixed) return {T(p[0] - from[0]), T(p[1] - from[1]), T(1)};
    const T cosine = from[3] * from[3] - from[2] * from[2], sine = T(2) * from[2] * from[3];
    return {T(cosine * p[0] - sine * p[1]), T(sine * p[0] + cosine * p[1]), T(from[2] * from[2] + from[3] * from[3])};
  }
  static Found<Dyads::Design> dyad(Body given, const std::vector<double>& pivot, const Point2<Rational>& partner,
                                   std::span<const Pose> poses, bool certify);
  static const char* complaint(const std::vector<double>& pivot);
  static std::vector<Found<Dyads::Design>> fits(Body given, const std::vector<double>& pivot,
                                                std::span<const Pose> poses);
  static double rounding(const std::vector<double>& pivot, std::span<const Pose> poses);
  static PartnersRecord partners(Body given, const std::vector<double>& pivot, const LinearForm<double>& line,
                                 const Pose& first);
  /// `count` finite points, in steps of the distance of the given one from the line, and the point at infinity.
  static std::vector<Point2<double>> along(const LinearForm<double>& line, const Point2<double>& given, int count);
  /// 7 x 7 points over the origins of the poses and half a task size around them.
  static std::vector<std::vector<double>> grid(std::span<const Pose> poses);
  static std::optional<PoleRecord> pole_of(const Pose& from, const Pose& to);
  /// "a rotation by 30 deg about the pole (1, 2): "
  static std::string described(const PoleRecord& pole, const Units& units);

 private:
  template <class T>
  struct PoseOver {
    T x, y, X3, X4;
    explicit PoseOver(const DataOf<T>& d) : x(d[0]), y(d[1]), X3(d[2]), X4(d[3]) {}
  };
};

/// All dyads that meet two or three poses: poles, and members of the family over a grid of fixed pivots.
struct FamilySolver {
  using Pose = planar::Pose;
  using Dyads = planar::Dyads;
  static constexpr const char* name = "two and three poses, linear";
  static constexpr const char* answers =
      "the family of dyads with its poles; the dyad, or the best fits to more poses, for given fixed and moving pivots";
  Units units = {};  ///< of the angles in the message
  /// Two or three poses.
  PlanarReport solve(std::span<const Pose> poses) const;
};

}  // namespace burmester::planar
