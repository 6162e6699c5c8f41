// A geometry of somebody else, turns about one point, and a dyad type with a lifted form: the body stands at
// one angle.
#include <burmester/modules/framework/conformance.hpp>
#include <burmester/modules/framework/displacement.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

namespace turns {

using burmester::Random;
using burmester::Vector;
constexpr double pi = std::numbers::pi;

/// Points (cos, sin) of the half angle: the basis elements 1 and k of the dual quaternions.
struct Space : burmester::Displacement<std::array{0, 3}, std::array{1, 2}> {
  static constexpr const char* name = "turns";
  static constexpr int dof = 1;
  struct Pose {
    double angle = 0;
  };
  template <class T>
  static Point<T> point(const Pose& p) {
    return {T(std::cos(p.angle / 2)), T(std::sin(p.angle / 2))};
  }
  static Pose pose(const Point<double>& x) { return {2 * std::atan2(x[1], x[0])}; }
  static Pose nudged(const Pose& p, const Vector<double, 1>& u) { return {p.angle + u[0]}; }
  static double distance(const Feature<double>& a, const Feature<double>& b) { return (a - b).norm(); }
  static Pose random_pose(Random& random) { return {random.uniform(-pi, pi)}; }
  static Feature<double> random_feature(Random& random) {
    const double x = random.normal();
    return {x, random.normal()};
  }
};

struct StopDesign {
  double angle = 0;
};

/// norm (cos(turn - angle) - 1) = row . k with k = [cos(angle), sin(angle), -1] on the cone k0^2 + k1^2 =
/// k2^2
struct Family {
  using Space = turns::Space;
  static constexpr int dimension = 3, relation_count = 1;
  template <class T>
  static Vector<T, 3> row(const Space::Pose& pose) {
    const Vector<T, 2> x = Space::point<T>(pose);
    return {x[0] * x[0] - x[1] * x[1], 2 * x[0] * x[1], x[0] * x[0] + x[1] * x[1]};
  }
  template <class T>
  static Vector<T, 1> relations(const Vector<T, 3>& k) {
    return Vector<T, 1>{k[0] * k[0] + k[1] * k[1] - k[2] * k[2]};
  }
  static std::optional<std::variant<StopDesign>> decode(const Vector<double, 3>& k) {
    if (k[2] == 0) return std::nullopt;
    return StopDesign{std::atan2(-k[1] / k[2], -k[0] / k[2])};
  }
};

struct Stop {
  using Space = turns::Space;
  using Family = turns::Family;
  using Inverse = Stop;
  using Design = StopDesign;
  static constexpr const char* name = "stop";
  static constexpr int parameters = 1;
  static double residual(const Design& d, const Space::Pose& x) {
    return std::remainder(x.angle - d.angle, 2 * pi);
  }
  static Design moved(const Design& d, const Space::Point<double>& g, const Space::Point<double>& h) {
    return {d.angle + Space::pose(g).angle - Space::pose(h).angle};
  }
  static Design inverse(const Design& d) { return {-d.angle}; }
  static Design nudged(const Design& d, const Vector<double, 1>& u) { return {d.angle + u[0]}; }
  static Design random_design(Random& random) { return {random.uniform(-pi, pi)}; }
  static Vector<double, 3> encode(const Design& d) { return {std::cos(d.angle), std::sin(d.angle), -1}; }
  static burmester::DyadRecord record(const Design& d) {
    burmester::DyadRecord out;
    out.type = name;
    out.angle = d.angle;
    return out;
  }
};

BURMESTER_SPACE_CONFORMANCE(Space);
BURMESTER_DYAD_CONFORMANCE(burmester::DyadList<Stop>);

struct WrongWayRound : Space {
  static Pose pose(const Point<double>& x) { return {-Space::pose(x).angle}; }
};
TEST(Laws, SeeAMistakeThroughTheInstalledHeaders) {
  EXPECT_TRUE(burmester::laws::space_violations<Space>().empty());
  EXPECT_FALSE(burmester::laws::space_violations<WrongWayRound>().empty());
}

}  // namespace turns
