#include "burmester/planar/five_pose_certificate.hpp"

#include <optional>

#include "burmester/geometry/conic_count.hpp"
#include "burmester/geometry/interval.hpp"
#include "burmester/geometry/null_space.hpp"
#include "burmester/geometry/rational_interval.hpp"
#include "burmester/planar/five_pose_enclosure.hpp"
#include "burmester/planar/five_pose_oracle.hpp"

namespace burmester::planar {
namespace {

/// The number of real dyads, nothing where T cannot tell: the rank is not proved to be four, the conics have a common
/// point of higher multiplicity, or a sign is not known.
template <class T>
std::optional<int> count_over(FivePoses poses, const Anchor& anchor) {
  const NullSpace<T, 4, 7> null = null_space(anchored_rows<T>(poses, anchor));
  if (anchor.turn == 0 || !(null.smallest_pivot() > 0)) return std::nullopt;
  const std::array<Conic<T>, 2> conics = relation_conics(null.basis, T(anchor.turn));
  return count_common_points(conics[0], conics[1]);
}

/// Disjoint boxes for all roots; false where one cannot be proved.
template <class I>
bool enclose(FivePoses poses, Rung rung, CertifiedRoots& out) {
  const Anchor& anchor = out.roots.anchor;
  const Matrix<I, 4, 7> rows = anchored_rows<I>(poses, anchor);
  std::array<Anchored<I>, 4> found;
  for (std::size_t i = 0; i < static_cast<std::size_t>(out.roots.count); ++i) {
    const auto root =
        detail::enclose_root<I>(out.roots.w[i], rows, anchor, poses[static_cast<std::size_t>(anchor.reference)]);
    if (!root) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (!detail::different(found[j], root->w)) return false;
    found[i] = root->w;
    out.boxes[i] = root->dyad;
    out.boxes[i].rung = rung;
  }
  return true;
}

void take_quad_roots(FivePoses poses, CertifiedRoots& out) {
  const FivePoseRoots<Quad> quad = five_pose_roots_quad(poses);
  if (quad.count != out.count) return;
  out.roots.count = quad.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(quad.count); ++i)
    out.roots.w[i] = quad.w[i].template cast<double>();
}

/// The proved number of real dyads, by intervals or exactly; -1 where there is none.
void prove_count(FivePoses poses, CertifiedRoots& out) {
  out.count = count_by_intervals(poses);
  if (out.count >= 0) {
    out.count_rung = Rung::intervals;
    return;
  }
  out.count = count_exactly(poses);
  if (out.count >= 0) out.count_rung = Rung::exact;
}

bool enclose_with_intervals(FivePoses poses, CertifiedRoots& out) {
  const UpwardRounding upward;
  return enclose<Interval>(poses, Rung::intervals, out);
}

/// Boxes for as many roots as are proved to exist; first those of the fast solver, then those of quad precision.
bool prove_boxes(FivePoses poses, CertifiedRoots& out) {
  if (out.count < 0) return false;
  if (out.roots.count == out.count && enclose_with_intervals(poses, out)) return true;
  take_quad_roots(poses, out);
  if (out.roots.count != out.count) return false;
  return enclose_with_intervals(poses, out) || enclose<RationalInterval>(poses, Rung::exact, out);
}

}  // namespace

CertifiedRoots certified_five_pose_roots(FivePoses poses) {
  CertifiedRoots out;
  out.roots = five_pose_roots(poses);
  if (out.roots.what != FivePoseCase::regular) return out;
  prove_count(poses, out);
  out.complete = prove_boxes(poses, out);
  if (!out.complete) out.boxes = {};
  return out;
}

int count_by_intervals(FivePoses poses) {
  const Anchor anchor = choose_anchor(poses).anchor;
  const UpwardRounding upward;
  return count_over<Interval>(poses, anchor).value_or(-1);
}

int count_exactly(FivePoses poses) {
  return count_over<Rational>(poses, choose_anchor(poses).anchor).value_or(-1);
}

}  // namespace burmester::planar
