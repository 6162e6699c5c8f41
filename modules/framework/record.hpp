// What crosses the face of a module: plain data that files, tables and pages are written from.
// Lengths are in the problem's unit, angles in radians (writers convert), points are as long as the geometry says.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "burmester/modules/framework/certificate.hpp"

namespace burmester {

/// A line of a plane: `angle` is its direction in [0, pi), `point` the foot of the perpendicular from the origin of
/// the frame that carries it.
struct LineRecord {
  std::vector<double> point;
  double angle = 0;
};

/// The slider that an RR dyad nearly is.
struct SliderRecord {
  std::string type;
  std::optional<LineRecord> line;  ///< none on the sphere, where the axes say it all
  double departure = 0;
};

struct DyadRecord {
  int id = 0;
  std::string type;
  std::vector<double> fixed, moving;  ///< pivots (axes on the sphere); empty where the type has none
  std::optional<LineRecord> line;     ///< fixed line of PR, moving line of RP
  std::optional<double> length, arc, angle;
  double residual = 0;                ///< largest distance over the poses from being met
  std::optional<double> condition;    ///< change of the dyad per change of the poses (docs/concepts.md), if counted
  std::optional<double> departure;    ///< slider: how far the circle that was solved for leaves the line
  std::optional<SliderRecord> slider;
  Certificate certificate;
};

struct LinkageRecord {
  int id = 0;
  int dyads[2] = {0, 0};
  std::string type;
  std::optional<std::string> motion_class;  ///< crank-rocker, ..
  std::optional<double> ground, input, coupler, output;
  std::optional<double> offset, coupler_offset;  ///< of a pivot from a guide on the same link; the second: PRPR's other
};

/// A point of a curve: two coordinates in the plane, three on the sphere. A curve has thousands; they share one block.
class PointRecord {
 public:
  using value_type = double;
  PointRecord(double x, double y) : values_{x, y, 0}, size_(2) {}
  PointRecord(double x, double y, double z) : values_{x, y, z}, size_(3) {}
  std::size_t size() const { return size_; }
  double operator[](std::size_t k) const { return values_[k]; }
  const double* begin() const { return values_.data(); }
  const double* end() const { return begin() + size_; }

 private:
  std::array<double, 3> values_;
  std::size_t size_;
};

/// A part of a curve of dyads: polylines of paired pivots.
struct CurveRecord {
  int component = 0;    ///< pieces of one component share the number, from 0
  bool closed = false;  ///< a whole closed component; the first point is not repeated
  double max_error = 0;  ///< distance between the polylines and the true curves, at most
  std::vector<PointRecord> moving, fixed;
};

/// Where a displacement from one pose to another leaves the body's points: the pole, on the sphere the axis of
/// rotation.
struct PoleRecord {
  int poses[2] = {0, 0};          ///< counted from 1
  double angle = 0;               ///< of the rotation, radians
  std::vector<double> fixed;      ///< the pole in the fixed frame; empty for a translation
  std::vector<double> moving;     ///< the point of the body that is there in both poses
  std::optional<LineRecord> far;  ///< translation: the pole is the point at infinity of this line
};

/// All partners of a given pivot where they fill a line: a straight line of the other plane, or on the sphere the great
/// circle perpendicular to `normal`.
struct PartnersRecord {
  std::vector<double> fixed, moving;  ///< the given pivot is one of them, the other is empty
  std::optional<LineRecord> line;
  std::vector<double> normal;
};

/// What tells a family of dyads that is no curve: members, and what all members have in common.
struct FamilyRecord {
  std::vector<PoleRecord> poles;
  std::vector<PartnersRecord> partners;
  std::vector<DyadRecord> samples;  ///< of the family, without numbers: id 0
};

/// One of the many linkages that a curve of dyads allows. Its dyads are not among those of the answer.
struct CandidateRecord {
  std::array<DyadRecord, 2> dyads;
  LinkageRecord linkage;    ///< of dyads 1 and 2
  double link_ratio = 1;    ///< longest to shortest link
  bool one_branch = false;  ///< passes through the poses in one circuit and branch, driven at the first dyad
};

enum class Status { exact, approximate, family, none, degenerate };

/// "exact", "approximate", ...
std::string_view name_of(Status status);

struct SolutionCounts {
  std::optional<int> dimension;  ///< of the set of dyads; none where it is degenerate and unknown
  std::optional<int> complex;    ///< over the complex numbers with multiplicity; none: infinite or not counted
  std::optional<int> real;
  bool certified = false;
  /// Least change of the poses, relative to their size, that makes two dyads coincide (docs/concepts.md); only where
  /// that is near.
  std::optional<double> merge_distance = std::nullopt;
};

/// The answer to a synthesis problem.
struct Synthesis {
  Status status = Status::none;
  std::string message;  ///< one sentence for people: what was found, or why nothing is there
  SolutionCounts counts;
  std::vector<DyadRecord> dyads;
  std::vector<LinkageRecord> linkages;
  std::vector<std::string> warnings;
  std::vector<CurveRecord> curves = {};
  FamilyRecord family = {};
  std::optional<std::vector<CandidateRecord>> candidates = {};  ///< best first; nothing where none are looked for
};

}  // namespace burmester
