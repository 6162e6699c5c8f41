// Four poses by the dyad form: circle points and centre points from the position analysis of a four-bar.
//
// A dyad, two complex vectors: Z1 from the fixed pivot M to the moving pivot K, Z2 from K to the origin P of the moving
// frame, all in pose 1. With d_j = P_j - P_1 and g_j = exp(i gamma_j) - 1, gamma_j the rotation from pose 1 to pose j,
// and phi_j that of the link,
//     (exp(i phi_j) - 1) Z1 + g_j Z2 = d_j,   j = 2, 3, 4.                                        (1)
// Three equations for Z1 and Z2: their determinant must vanish,
//     Delta_1 + Delta_2 exp(i phi_2) + Delta_3 exp(i phi_3) + Delta_4 exp(i phi_4) = 0,           (2)
//     Delta_2 = g_3 d_4 - g_4 d_3,   Delta_3 = g_4 d_2 - g_2 d_4,   Delta_4 = g_2 d_3 - g_3 d_2,
//     Delta_1 = -(Delta_2 + Delta_3 + Delta_4):
// the closure of a four-bar with the frame |Delta_1|, the compatibility linkage. Its free angle phi_2 and assembly mode
// give phi_3 and phi_4, (1) gives Z1 and Z2, and K = P_1 - Z2, M = K - Z1 run through the circle-point and the
// centre-point curve (G. N. Sandor, A. G. Erdman, "Advanced Mechanism Design", vol. 2, 1984, chapter 3; "Theory of
// Mechanisms", lecture 19). Two positions of the compatibility linkage solve (2) whatever the poses are and are no
// dyads: all phi_j = 0, where M runs to infinity (a PR dyad), and phi_j = gamma_j, where K does (an RP dyad).
//
// Doubles, nothing is proved; four_pose_curves.hpp is the other route to the same curves.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "burmester/planar/four_pose_curves.hpp"

namespace burmester::planar {

using Complex = std::complex<double>;

/// A circle point and its centre point.
struct BurmesterPair {
  std::array<double, 3> phi;  ///< phi_2, phi_3, phi_4 in [-pi, pi]
  Complex Z1, Z2;             ///< in S, body in pose 1
  Vector2 moving, fixed;      ///< K in E, M in S
};

/// Values of the free angle for which the compatibility linkage closes: |phi - middle| <= half.
struct FreeRange {
  enum class Limit { stretched, folded };  ///< the two links that close the linkage, in one line
  double middle = 0, half = 0;
  bool full = false;            ///< every angle, no limit: the modes do not meet
  std::array<Limit, 2> ends{};  ///< unless full: at middle - half, middle + half, where the modes meet
};

/// A PR or RP dyad at one of the two positions that are no dyads.
template <class Design>
struct SliderLimit {
  Design design;
  int mode = 1;  ///< of the curve that runs through it
};

/// A stretch of the two curves, point by point, in one assembly mode.
struct DyadFormPiece {
  int mode = 1;
  bool closed = false;        ///< a whole loop; the first point is not repeated
  std::vector<double> angle;  ///< the free angle
  std::vector<Vector2> moving, fixed;
};

class DyadForm {
 public:
  static constexpr const char* name = "four poses, dyad form";
  static constexpr const char* answers =
      "points of the same curves by W and Z and the compatibility linkage, mode by mode: in figures, and as a check";
  explicit DyadForm(FourPoses poses);

  /// What is wrong with the poses, in words; empty where nothing is. The rest has a meaning only then.
  const std::string& degeneracy() const { return degeneracy_; }
  /// Delta_1 .. Delta_4
  const std::array<Complex, 4>& delta() const { return delta_; }
  /// j of the free angle phi_j: 2, unless the links that it leaves to close the linkage could fold into one point, as
  /// those of a kite can: then another.
  int free_pose() const { return static_cast<int>(free_) + 2; }
  /// Whether all links can lie in one line, within rounding: there the curve has a double point.
  bool change_point() const { return change_point_; }
  /// One or two. Each is one loop of the curve, run through once in each mode; a full one is two loops.
  const std::vector<FreeRange>& ranges() const { return ranges_; }

  /// mode 1 or -1: the sign of the angle from the diagonal of the linkage to its next link. Nothing where the linkage
  /// does not close, or a pivot is so far that no digit of it is known.
  std::optional<BurmesterPair> at(double free_angle, int mode) const;
  /// Joints of the compatibility linkage at a pair: 0, then after Delta_1, Delta_2 exp(i phi_2), Delta_3 exp(i phi_3).
  std::array<Complex, 4> joints(const BurmesterPair& pair) const;

  /// At phi = 0 and phi = gamma; nothing where the linkage does not move through there in one way, or the other pivot
  /// is far too.
  std::optional<SliderLimit<PR::Design>> PR_limit() const;
  std::optional<SliderLimit<RP::Design>> RP_limit() const;

  /// Chords no longer than asked for and, in the middle, no farther from the curve; what lies outside the window is
  /// left out. Where two modes meet both pieces end in the same point.
  std::vector<DyadFormPiece> sampled(const CurveOptions& options = {}) const;

 private:
  using Turns = std::array<Complex, 3>;  // exp(i phi_j)
  using Velocities = std::array<double, 3>;
  struct Pair {
    Complex first, second;
  };

  void find_links();
  void find_ranges();
  std::array<std::size_t, 2> others() const { return {free_ == 0 ? 1u : 0u, free_ == 2 ? 1u : 2u}; }
  std::optional<Turns> turns(double free_angle, int mode) const;
  /// Of a_j x + b_j y = d_j, consistent; nothing where x or y is infinite.
  std::optional<Pair> solved(const Turns& a, const Turns& b) const;
  std::optional<Velocities> velocities(const Turns& at) const;
  int mode_at(const Turns& at) const;

  std::array<Pose, 4> poses_;
  double length_;
  Turns d_, g_;
  std::array<Complex, 4> delta_;
  std::size_t free_ = 0;
  bool change_point_ = false;
  std::vector<FreeRange> ranges_;
  std::string degeneracy_;
};

}  // namespace burmester::planar
