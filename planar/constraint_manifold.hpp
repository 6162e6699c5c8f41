// The constraint manifold of a dyad as an object: its quadric, type, sections, parametrisation, generators, distances.
//
// In the plane X3 : X4 = t : w of the image space, the poses of one orientation, the coordinates X1, X2 of those that
// meet a dyad fill a curve. With K and (x, y) of the dyad (forms.hpp; RR: centre -(K1, K2), PR and RP: unit normal
// 2 (K1, K2), for RP in E and (x, y) in S):
//   RR  the circle about 1/2 ((x - K1) t + (K2 + y) w, (y - K2) t - (K1 + x) w), of radius 1/2 r sqrt(t^2 + w^2)
//   PR  the line a X1 + b X2 + c = 0, a = K1 t - K2 w, b = K2 t + K1 w,
//   RP  a = K1 t + K2 w, b = K2 t - K1 w,
//       c = 1/4 (K3 - 2 (K1 x + K2 y)) t^2 -+ (K1 y - K2 x) t w + 1/4 (K3 + 2 (K1 x + K2 y)) w^2, upper sign for PR
//   PP  nothing, or in its own orientation everything.
// w = 1 is the chart X4 = 1 of M. J. D. Hayes, ME 401 / MECH 5507 unit 3 (who calls K1, K2 the coordinates of the fixed
// centre: they are its negatives); w = 0 holds the half turns.
//
// Every surface of an RR, PR or RP passes through the points J1, J2 = (1 : +-i : 0 : 0) and is touched by the planes
// V1, V2: X3 +- i X4 = 0 (PR at J1 by V1, RP at J1 by V2, RR elsewhere); PR and RP surfaces hold the line l: X3 = X4
// = 0. That is two linear and two quadratic conditions on the ten coefficients, so five poses fix a surface.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "burmester/geometry/quadric_class.hpp"
#include "burmester/planar/constraint_quadric.hpp"

namespace burmester::planar {

/// A straight line of the image space, by two of its points (as Space::point).
using ImageLine = std::array<Point3<double>, 2>;

/// The poses that put the point p of E on the point P of S: all rotations about it.
ImageLine poses_taking(const Vector2& p, const Vector2& P);
/// The poses of one orientation, shifted along a direction of S. The second point is on l.
ImageLine translations_of(const Pose& pose, const Vector2& direction);

/// The plane X4 = 0 of the half turns: what is at infinity in the chart X4 = 1.
inline const Point3<double> half_turns(1, 0, 0, 0);

/// Affine type in the chart X4 = 1, proved, of the coefficients as they stand. (A PP's double plane is one only if its
/// coefficients are a square without rounding; doubles next to it are two planes, real or complex.)
inline QuadricClass surface_class(const Quadric<double>& surface) { return classify(surface, half_turns); }

/// The lifted form of a quadric through J1 and J2: inverse of constraint_quadric. Empty for other quadrics, by more
/// than 1e-12 of the largest coefficient.
std::optional<Vector<double, 8>> lifted_form(const Quadric<double>& surface);

/// The dyad of a surface; empty where there is none: the conditions above, each to 1e-12 of the coefficients (as
/// Family::decode; for lengths of order 1).
std::optional<Family::Design> design_of(const Quadric<double>& surface);

class ConstraintManifold {
 public:
  explicit ConstraintManifold(Family::Design design);

  const Family::Design& design() const { return design_; }
  const Quadric<double>& quadric() const { return quadric_; }
  /// RR: hyperboloid of one sheet, of length 0: line (the rotations about one point). PR, RP: hyperbolic paraboloid.
  /// PP: coincident planes.
  QuadricType type() const;

  /// The circle or straight line of (X1, X2) in the plane (X3, X4) = (t, w); empty for PP. Precondition: not both zero.
  std::optional<CircleOrLine> section(double t, double w) const;
  /// The parametrised surface, as Space::point. `at`, RR: the angle gamma on the circle, radians. PR, RP: s in
  /// (X1, X2) = (f, g) + s (-b, a), where (f, g) = -c (a, b) / (a^2 + b^2) is the foot of the perpendicular. Empty for
  /// PP.
  std::optional<Point3<double>> point(double t, double w, double at) const;
  /// The straight lines of the surface through a pose of it. RR: the moving pivot stays on its place in S, or the fixed
  /// one on its place in E. PR, RP: a pivot stays so, or the body shifts along the guide. None for PP.
  std::vector<ImageLine> generators(const Pose& pose) const;

  /// The least shift of the body, orientation kept, that makes the pose meet the dyad: length units (PP: the turn, in
  /// radians). The same in all frames.
  double distance(const Pose& pose) const;
  /// The distance of the notes, between the pose's image point and the curve in its plane X3 = const of the chart
  /// X4 = 1: distance(pose) / (2 |cos(angle / 2)|). It depends on the orientation of the frames and is infinite for
  /// half turns; the notes' d is its sum over the poses. Empty for PP.
  std::optional<double> spacing(const Pose& pose) const;

 private:
  Family::Design design_;
  Quadric<double> quadric_;
};

}  // namespace burmester::planar
