#include "burmester/planar/merge_distance.hpp"

#include "burmester/geometry/jet.hpp"
#include "burmester/geometry/quad.hpp"
#include "burmester/planar/orientations.hpp"

namespace burmester::planar {
namespace {

using Value = Jet<Quad, 20>;

struct VariablePose {
  Value x, y, X3, X4;
};
using VariablePoses = std::array<VariablePose, 5>;

/// Every datum a variable whose unit is the scale of the datum.
VariablePoses variables(FivePoses poses) {
  double reach = 0;
  for (const Pose& p : poses) reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
  VariablePoses out;
  for (int j = 0; j < 5; ++j) {
    const Pose& p = poses[j];
    const double norm = std::hypot(p.X3, p.X4);
    out[j] = {Value::variable(p.x, 4 * j, reach), Value::variable(p.y, 4 * j + 1, reach),
              Value::variable(p.X3, 4 * j + 2, norm), Value::variable(p.X4, 4 * j + 3, norm)};
  }
  return out;
}

/// At its double root a cubic has the square of that root as its Hessian; (s, t).
std::array<double, 2> double_root(const std::array<Value, 4>& f) {
  const Quad a = f[0].value, b = f[1].value, c = f[2].value, d = f[3].value;
  const Quad ss = b * b - 3 * a * c, st = b * c - 9 * a * d, tt = c * c - 3 * b * d;
  const bool by_s = abs(ss) > abs(tt);
  const double s = approximate(by_s ? Quad(-st) : Quad(2 * tt)), t = approximate(by_s ? Quad(2 * ss) : Quad(-st));
  return {s, t};
}

/// The pair of lines of the double root joins the place of merging with the other two common points: it is real where
/// those are.
bool others_are_real(const std::array<Conic<Value>, 2>& conics, const std::array<Value, 4>& cubic) {
  const auto as_quad = [](const Conic<Value>& c) {
    Conic<Quad> out;
    for (std::size_t i = 0; i < 6; ++i) out.q[i] = c.q[i].value;
    return out;
  };
  const auto [s, t] = double_root(cubic);
  return PencilSeparation<Quad>(as_quad(conics[0]), as_quad(conics[1]))(Quad(s), Quad(t)) > 0;
}

Value cross(const VariablePose& a, const VariablePose& b, const VariablePose& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
Value square(const VariablePose& a, const VariablePose& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

Value circle_discriminant(const VariablePoses& x, const TripleAndPair& at) {
  const auto& [a, b, c] = at.triple;
  const Value area = cross(x[a], x[b], x[c]);
  return square(x[a], x[b]) * square(x[a], x[c]) * square(x[b], x[c]) -
         square(x[at.pair[0]], x[at.pair[1]]) * area * area;
}

std::optional<MergeDistance> distance_of(const Value& discriminant, bool appear) {
  const Quad most = discriminant.slope.cwiseAbs().sum();
  if (!(most > 0)) return std::nullopt;
  return MergeDistance{approximate(Quad(abs(discriminant.value) / most)), appear};
}

}  // namespace

std::optional<MergeDistance> merge_distance(FivePoseCase what, FivePoses poses, const Anchor& anchor, int count) {
  const VariablePoses x = variables(poses);
  if (what == FivePoseCase::two_orientations) {
    const auto at = triple_and_pair(poses, same_orientation);
    return at ? distance_of(circle_discriminant(x, *at), count == 0) : std::nullopt;
  }
  const auto conics = relation_conics(null_space(anchored_rows<Value>(x, anchor)).basis, Value(anchor.turn));
  const std::array<Value, 4> cubic = pencil_determinant(conics[0], conics[1]);
  return distance_of(relative_discriminant(cubic), count == 0 || (count == 2 && others_are_real(conics, cubic)));
}

bool degenerate_within_rounding(FivePoseCase what, FivePoses poses, const Anchor& anchor) {
  if (what < FivePoseCase::rotation) return true;  // told by equal orientations, not by size
  const auto merging = merge_distance(FivePoseCase::regular, poses, anchor, 0);
  return !merging || merging->distance < largest_degenerate;
}

}  // namespace burmester::planar
