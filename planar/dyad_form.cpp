#include "burmester/planar/dyad_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "burmester/planar/anchored_basis.hpp"

namespace burmester::planar {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Complex i(0, 1);

Vector2 vector_of(Complex z) { return {z.real(), z.imag()}; }

/// exp(i angle) - 1 of the rotation from one pose to another, without cancellation where it is small.
Complex turn_less_one(const Pose& from, const Pose& to) {
  const auto [s, c] = relative_turn<double>(from, to);
  return 2 * s / (s * s + c * c) * Complex(-s, c);
}

std::string words_for(const std::array<Pose, 4>& poses, const std::array<bool, 4>& gone) {
  std::vector<std::size_t> left;  // the poses whose own determinants vanish are not what is wrong
  for (std::size_t j = 0; j < 4; ++j)
    if (!gone[j]) left.push_back(j);
  const auto parallel = [&] {
    return std::all_of(left.begin(), left.end(),
                       [&](std::size_t j) { return same_orientation(poses[left[0]], poses[j]); });
  };
  if (left.size() == 2) return fmt::format("poses {} and {} are equal", left[0] + 1, left[1] + 1);
  if (left.size() == 3)
    return fmt::format("poses {}, {} and {} are {}", left[0] + 1, left[1] + 1, left[2] + 1,
                       parallel() ? "parallel" : "rotations about one point, their poles coincide");
  left = {0, 1, 2, 3};
  return parallel() ? "all four poses are parallel" : "all four poses are rotations about one point";
}

}  // namespace

DyadForm::DyadForm(FourPoses poses) : length_(power_of_two_below(curve_scale(poses))) {
  std::copy(poses.begin(), poses.end(), poses_.begin());
  for (std::size_t j = 0; j < 3; ++j) {
    d_[j] = {poses[j + 1].x - poses[0].x, poses[j + 1].y - poses[0].y};
    g_[j] = turn_less_one(poses[0], poses[j + 1]);
  }
  find_links();
  if (degeneracy_.empty()) find_ranges();
}

void DyadForm::find_links() {
  std::array<double, 4> noise{};  // each g and d is known to a few unit roundoffs of itself
  delta_[0] = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
    delta_[j + 1] = g_[k] * d_[l] - g_[l] * d_[k];
    noise[j + 1] = 16 * unit_roundoff * (std::abs(g_[k] * d_[l]) + std::abs(g_[l] * d_[k]));
    delta_[0] -= delta_[j + 1], noise[0] += noise[j + 1];
  }
  std::array<bool, 4> gone;
  for (std::size_t j = 0; j < 4; ++j) gone[j] = !(std::abs(delta_[j]) > noise[j]);
  if (std::count(gone.begin(), gone.end(), true) > 0) {
    degeneracy_ = words_for(poses_, gone);
    return;
  }
  // The closing links meet in one point where the diagonal D between them vanishes; its least length is this:
  std::array<double, 3> least;
  double longest = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
    least[j] = std::max(std::abs(std::abs(delta_[0]) - std::abs(delta_[j + 1])),
                        std::abs(std::abs(delta_[k + 1]) - std::abs(delta_[l + 1])));
    longest = std::max(longest, std::abs(delta_[j + 1]));
  }
  if (!(least[0] > 0x1p-10 * longest))
    free_ = static_cast<std::size_t>(std::max_element(least.begin(), least.end()) - least.begin());
  if (!(least[free_] > 2 * noise[0])) degeneracy_ = "the compatibility linkage is a rhombus";
}

void DyadForm::find_ranges() {
  const auto link = [&](std::size_t j) { return std::abs(delta_[j]); };
  const double r1 = link(0), r2 = link(free_ + 1), r3 = link((free_ + 1) % 3 + 1), r4 = link((free_ + 2) % 3 + 1);
  const double sum = r1 + r2 + r3 + r4, slack = 16 * unit_roundoff * sum;
  const double a = r1 + r2 - r3 - r4, b = r1 + r3 - r2 - r4, c = r1 + r4 - r2 - r3;  // one zero: all links in one line
  change_point_ = std::min({std::abs(a), std::abs(b), std::abs(c)}) <= slack;
  // The diagonal D has |D|^2 = r1^2 + r2^2 + 2 r1 r2 cos(psi), and |r3 - r4| <= |D| <= r3 + r4. Where |D| = r3 + r4,
  // sin^2 and cos^2 of psi / 2 are to each other as a (sum) and (sum - 2 r1)(sum - 2 r2); where |D| = |r3 - r4|, as
  // (sum - 2 r3)(sum - 2 r4) and -b c.
  const auto angle = [](double sine2, double cosine2) {
    return 2 * std::atan2(std::sqrt(std::max(sine2, 0.0)), std::sqrt(std::max(cosine2, 0.0)));
  };
  const bool stretches = a > slack, folds = std::min(b, c) < -slack && std::max(b, c) > slack;
  const double from = stretches ? angle(a * sum, (sum - 2 * r1) * (sum - 2 * r2)) : 0;
  const double to = folds ? angle((sum - 2 * r3) * (sum - 2 * r4), -b * c) : pi;
  const double zero = std::arg(delta_[0]) - std::arg(delta_[free_ + 1]);  // phi where psi = 0
  using enum FreeRange::Limit;
  if (stretches && folds)
    ranges_ = {{zero + (from + to) / 2, (to - from) / 2, false, {stretched, folded}},
               {zero - (from + to) / 2, (to - from) / 2, false, {folded, stretched}}};
  else if (stretches)
    ranges_ = {{zero + pi, pi - from, false, {stretched, stretched}}};
  else if (folds)
    ranges_ = {{zero, to, false, {folded, folded}}};
  else
    ranges_ = {{zero, pi, true, {}}};
  for (FreeRange& range : ranges_) range.middle = std::remainder(range.middle, 2 * pi);
}

std::optional<DyadForm::Turns> DyadForm::turns(double free_angle, int mode) const {
  const auto [a, b] = others();
  Turns e;
  e[free_] = std::polar(1.0, free_angle);
  const Complex diagonal = delta_[0] + delta_[free_ + 1] * e[free_];
  const double size = std::abs(diagonal), r = std::abs(delta_[a + 1]), q = std::abs(delta_[b + 1]);
  const double slack = 16 * unit_roundoff * (size + r + q + std::abs(delta_[0]) + std::abs(delta_[free_ + 1]));
  std::array<double, 3> gap{q + r - size, q + size - r, size + r - q};  // one zero: a limit
  for (double& x : gap) {
    if (x < -slack) return std::nullopt;
    if (x <= slack) x = 0;
  }
  const double up = gap[0] * gap[1] / (2 * size * r), down = gap[2] * (size + r + q) / (2 * size * r);  // 1 +- cosine
  e[a] = r * diagonal / size * Complex((up - down) / 2, mode * std::sqrt(up * down)) / delta_[a + 1];
  e[b] = -(diagonal + delta_[a + 1] * e[a]) / delta_[b + 1];
  return e;
}

std::optional<DyadForm::Pair> DyadForm::solved(const Turns& a, const Turns& b) const {
  Complex largest = 0;
  std::size_t first = 0, second = 1;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const Complex determinant = a[j] * b[k] - a[k] * b[j];
    if (std::abs(determinant) > std::abs(largest)) largest = determinant, first = j, second = k;
  }
  double size = 0;  // entries below 2 that are known to a few unit roundoffs
  for (std::size_t j = 0; j < 3; ++j) size = std::max({size, std::abs(a[j]), std::abs(b[j])});
  if (!(std::abs(largest) > 64 * unit_roundoff * size)) return std::nullopt;
  return Pair{(d_[first] * b[second] - d_[second] * b[first]) / largest,
              (a[first] * d_[second] - a[second] * d_[first]) / largest};
}

std::optional<BurmesterPair> DyadForm::at(double free_angle, int mode) const {
  const auto e = turns(free_angle, mode);
  if (!e) return std::nullopt;
  const auto z = solved({(*e)[0] - 1.0, (*e)[1] - 1.0, (*e)[2] - 1.0}, g_);
  if (!z) return std::nullopt;
  const Complex K = Complex(poses_[0].x, poses_[0].y) - z->second;
  return BurmesterPair{{std::arg((*e)[0]), std::arg((*e)[1]), std::arg((*e)[2])},
                       z->first,
                       z->second,
                       to_moving({0, 0, poses_[0].X3, poses_[0].X4}, vector_of(-z->second)),
                       vector_of(K - z->first)};
}

std::array<Complex, 4> DyadForm::joints(const BurmesterPair& pair) const {
  std::array<Complex, 4> out{0, delta_[0]};
  for (std::size_t j = 0; j < 2; ++j) out[j + 2] = out[j + 1] + delta_[j + 1] * std::polar(1.0, pair.phi[j]);
  return out;
}

/// d phi_j / dt of the motion through a position, largest 1.
std::optional<DyadForm::Velocities> DyadForm::velocities(const Turns& at) const {
  Turns link;
  double size = 0;
  for (std::size_t j = 0; j < 3; ++j) link[j] = delta_[j + 1] * at[j], size = std::max(size, std::abs(link[j]));
  Velocities out;
  double largest = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    out[j] = (std::conj(link[(j + 1) % 3]) * link[(j + 2) % 3]).imag();
    largest = std::max(largest, std::abs(out[j]));
  }
  if (!(largest > 64 * unit_roundoff * size * size)) return std::nullopt;
  for (double& v : out) v /= largest;
  return out;
}

int DyadForm::mode_at(const Turns& at) const {
  const std::size_t a = others()[0];
  const Complex diagonal = delta_[0] + delta_[free_ + 1] * at[free_];
  return (std::conj(diagonal) * delta_[a + 1] * at[a]).imag() < 0 ? -1 : 1;
}

std::optional<SliderLimit<PR::Design>> DyadForm::PR_limit() const {
  const Turns at{1, 1, 1};
  const auto v = velocities(at);
  if (!v) return std::nullopt;
  const auto z = solved({(*v)[0], (*v)[1], (*v)[2]}, g_);  // v_j W + g_j Z2 = d_j, W = i t Z1: K moves along W
  if (!z) return std::nullopt;
  const Vector2 normal = vector_of(i * z->first / std::abs(z->first));
  const double offset = normal.dot(vector_of(Complex(poses_[0].x, poses_[0].y) - z->second));
  return SliderLimit<PR::Design>{
      {to_moving({0, 0, poses_[0].X3, poses_[0].X4}, vector_of(-z->second)), {normal, offset}}, mode_at(at)};
}

std::optional<SliderLimit<RP::Design>> DyadForm::RP_limit() const {
  const Turns at{1.0 + g_[0], 1.0 + g_[1], 1.0 + g_[2]};
  const auto v = velocities(at);
  if (!v) return std::nullopt;
  const auto z = solved({i * at[0] * (*v)[0], i * at[1] * (*v)[1], i * at[2] * (*v)[2]}, g_);
  if (!z) return std::nullopt;  // y = Z1 + Z2 = P_1 - M, and seen from the body M moves along i x
  const Pose back{0, 0, -poses_[0].X3, poses_[0].X4};
  const Vector2 normal = rotated(back, vector_of(z->first / std::abs(z->first)));
  return SliderLimit<RP::Design>{{Vector2(poses_[0].x, poses_[0].y) - vector_of(z->second),
                                  {normal, normal.dot(rotated(back, vector_of(-z->second)))}},
                                 mode_at(at)};
}

namespace {

/// Samples one mode over a range, or all of a full one.
class Sampler {
 public:
  struct Sample {
    double t = 0, angle = 0;
    std::optional<BurmesterPair> pair;
    bool inside = false;
  };

  Sampler(const DyadForm& form, const FreeRange& range, int mode, const CurveOptions& options, double length)
      : form_(form), range_(range), mode_(mode), options_(options), length_(length) {}

  std::vector<DyadFormPiece> run() {
    Sample last = at(0);
    const Sample first = last;
    for (int k = 1; k <= first_chords; ++k) {
      const Sample next = range_.full && k == first_chords ? closing(first) : at(pi * k / first_chords);
      follow(last, next, 0);
      last = next;
    }
    if (range_.full) close();
    return std::move(pieces_);
  }

 private:
  static constexpr int first_chords = 32, deepest = 24;

  /// t from 0 to pi. At a limit the square root of the distance from it is smooth.
  Sample at(double t) const {
    Sample out;
    out.t = t, out.angle = range_.middle + (range_.full ? 2 * t - pi : -range_.half * std::cos(t));
    out.pair = form_.at(out.angle, mode_);
    out.inside = out.pair && within(out.pair->Z2) && within(out.pair->Z1 + out.pair->Z2);
    return out;
  }
  static Sample closing(Sample first) {
    first.t = pi;
    return first;
  }
  bool within(Complex z) const { return std::max(std::abs(z.real()), std::abs(z.imag())) <= options_.window * length_; }

  /// Longest chord and largest deviation of the curve's middle from the chord's, in what is allowed.
  double excess(const Sample& x, const Sample& m, const Sample& y) const {
    const auto of = [&](const Vector2& a, const Vector2& b, const Vector2& c) {
      const Vector2 chord = c - a, off = b - a;
      const double size = std::max(chord.norm(), off.norm());
      const double across =
          chord.norm() > 0 ? std::abs(chord[0] * off[1] - chord[1] * off[0]) / chord.norm() : off.norm();
      return std::max(size / (options_.longest * length_), across / (options_.tolerance * length_));
    };
    return std::max(of(x.pair->moving, m.pair->moving, y.pair->moving),
                    of(x.pair->fixed, m.pair->fixed, y.pair->fixed));
  }

  void follow(const Sample& x, const Sample& y, int depth) {
    const Sample m = at((x.t + y.t) / 2);
    if (x.inside && m.inside && y.inside && excess(x, m, y) <= 1) return append(x, y);
    if (depth == deepest || (depth > 4 && !x.inside && !m.inside && !y.inside)) {
      connected_ = false;
      return;
    }
    follow(x, m, depth + 1);
    follow(m, y, depth + 1);
  }

  void append(const Sample& x, const Sample& y) {
    if (!connected_) {
      pieces_.push_back({mode_, false, {}, {}, {}});
      add(x);
    }
    connected_ = true;
    add(y);
  }
  void add(const Sample& x) {
    DyadFormPiece& piece = pieces_.back();
    piece.angle.push_back(x.angle);
    piece.moving.push_back(x.pair->moving);
    piece.fixed.push_back(x.pair->fixed);
  }

  /// Joins the end of a full loop to its beginning.
  void close() {
    if (pieces_.empty() || !connected_) return;
    DyadFormPiece &begin = pieces_.front(), &end = pieces_.back();
    if (begin.moving.front() != end.moving.back()) return;
    end.angle.pop_back(), end.moving.pop_back(), end.fixed.pop_back();
    if (pieces_.size() == 1) {
      end.closed = true;
      return;
    }
    end.angle.insert(end.angle.end(), begin.angle.begin(), begin.angle.end());
    end.moving.insert(end.moving.end(), begin.moving.begin(), begin.moving.end());
    end.fixed.insert(end.fixed.end(), begin.fixed.begin(), begin.fixed.end());
    pieces_.erase(pieces_.begin());
  }

  const DyadForm& form_;
  FreeRange range_;
  int mode_;
  CurveOptions options_;
  double length_;
  std::vector<DyadFormPiece> pieces_;
  bool connected_ = false;
};

}  // namespace

std::vector<DyadFormPiece> DyadForm::sampled(const CurveOptions& options) const {
  std::vector<DyadFormPiece> out;
  for (const FreeRange& range : ranges_)
    for (const int mode : {1, -1})
      for (DyadFormPiece& piece : Sampler(*this, range, mode, options, length_).run()) out.push_back(std::move(piece));
  return out;
}

}  // namespace burmester::planar
