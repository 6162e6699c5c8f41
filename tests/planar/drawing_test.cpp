#include "burmester/planar/drawing.hpp"

#include <gtest/gtest.h>

#include "burmester/planar/constraint_quadric.hpp"
#include "burmester/planar/drawing/motion.hpp"
#include "burmester/planar/planar.hpp"
#include "burmester/planar/tasks.hpp"
#include "planted_linkage.hpp"

namespace burmester::planar {
namespace {

constexpr double pi = std::numbers::pi;

// ---- Problems and answers from a planted linkage ----

DyadRecord record_of(const Design& design, int id) {
  DyadRecord out = Dyads::visit(design, []<class D>(const typename D::Design& d) { return D::record(d); });
  out.id = id;
  return out;
}
Drawing draw(const Planted& p) {
  Problem problem;
  for (const Pose& x : p.poses) problem.poses.push_back({x.x, x.y, x.X3, x.X4});
  Synthesis answer;
  answer.dyads = {record_of(p.a, 3), record_of(p.b, 7)};
  LinkageRecord linkage;
  linkage.id = 1, linkage.dyads[0] = 3, linkage.dyads[1] = 7;
  answer.linkages = {linkage};
  return draw_synthesis(problem, answer);
}
double residual(const Design& design, const Pose& x) {
  return Dyads::visit(design, [&]<class D>(const typename D::Design& d) { return D::residual(d, x); });
}
// ---- What every drawing must be ----

Vector2 at(const std::array<double, 2>& p) { return {p[0], p[1]}; }
/// The pose that a snapshot's frame shows.
Pose pose_shown(const LinkageDrawing& l, const Snapshot& s) {
  for (std::size_t k = 0; k < l.parts.size(); ++k)
    if (l.parts[k].role == "frame") {
      const Vector2 x = at(s[k][0]) - at(s[k][1]);
      return pose_from_radians(s[k][1][0], s[k][1][1], std::atan2(x[1], x[0]));
    }
  ADD_FAILURE() << "no frame";
  return {};
}
double apart(const Pose& p, const Pose& q) {
  return std::hypot(p.x - q.x, p.y - q.y) + std::abs(std::remainder(angle_of(p) - angle_of(q), 2 * pi));
}
void expect_well_formed(const LinkageDrawing& l, const Snapshot& s) {
  ASSERT_EQ(s.size(), l.parts.size());
  for (std::size_t k = 0; k < s.size(); ++k) {
    EXPECT_FALSE(s[k].empty()) << l.parts[k].role;
    for (const auto& p : s[k]) ASSERT_TRUE(std::isfinite(p[0]) && std::isfinite(p[1])) << l.parts[k].role;
  }
}
void expect_motion(const Planted& p, const LinkageDrawing& l, const MotionDrawing& m, double size) {
  ASSERT_EQ(m.poses.size(), m.pose_frames.size());
  EXPECT_LE(m.frames.size(), static_cast<std::size_t>(most_frames));
  EXPECT_GE(m.frames.size(), 20u);
  for (const Snapshot& s : m.frames) {
    expect_well_formed(l, s);
    const Pose x = pose_shown(l, s);
    EXPECT_LT(std::abs(residual(p.a, x)), 1e-9 * size);
    EXPECT_LT(std::abs(residual(p.b, x)), 1e-9 * size);
  }
  for (std::size_t i = 0; i < m.poses.size(); ++i) {
    EXPECT_GE(m.pose_frames[i], m.pose_frames[i ? i - 1 : 0]);
    ASSERT_LT(static_cast<std::size_t>(m.pose_frames[i]), m.frames.size());
    const Pose x = pose_shown(l, m.frames[m.pose_frames[i]]);
    EXPECT_LT(apart(x, p.poses[m.poses[i] - 1]), 1e-9 * size) << "pose " << m.poses[i];
  }
}
/// Every pose on exactly one motion, all of it on the linkage; the drawing for further looks.
LinkageDrawing expect_drawn(const Planted& p, double size = 1) {
  const Drawing drawing = draw(p);
  EXPECT_EQ(drawing.poses.size(), p.poses.size());
  EXPECT_EQ(drawing.linkages.size(), 1u);
  if (drawing.linkages.empty()) return {};
  const LinkageDrawing& l = drawing.linkages[0];
  EXPECT_EQ(l.at_pose.size(), p.poses.size());
  for (std::size_t j = 0; j < p.poses.size(); ++j) {
    expect_well_formed(l, l.at_pose[j]);
    EXPECT_LT(apart(pose_shown(l, l.at_pose[j]), p.poses[j]), 1e-9 * size);
  }
  std::vector<int> times(p.poses.size(), 0);
  for (const MotionDrawing& m : l.motions) {
    expect_motion(p, l, m, size);
    for (const int j : m.poses) ++times[j - 1];
  }
  for (std::size_t j = 0; j < times.size(); ++j) EXPECT_EQ(times[j], 1) << "pose " << j + 1;
  EXPECT_LT(l.window[0], l.window[2]);
  EXPECT_LT(l.window[1], l.window[3]);
  return l;
}
std::vector<std::string> roles_of(const LinkageDrawing& l, int dyad) {
  std::vector<std::string> out;
  for (const Part& part : l.parts)
    if (part.dyad == dyad) out.push_back(part.role + part.label);
  return out;
}

// ---- Four-bars ----

const RR::Design crank{{0, 0}, {-1, -0.5}, 1};           // ground 4, crank 1, coupler 3.2, rocker 3
const RR::Design rocker{{4, 0}, {2.2, -0.5}, 3};
/// The crank-rocker's pose at a crank angle, on the given side.
Pose crank_pose(double angle, std::size_t side) {
  const Vector2 a(std::cos(angle), std::sin(angle)), d = rocker.fixed - a;
  const double g = d.norm(), turn = std::acos((g * g + 3.2 * 3.2 - 9) / (2 * g * 3.2));
  const double coupler = std::atan2(d[1], d[0]) + (side ? turn : -turn);
  const Vector2 origin = a - rotated(pose_from_radians(0, 0, coupler), crank.moving);
  return pose_from_radians(origin[0], origin[1], coupler);
}
Planted crank_rocker(std::initializer_list<double> angles, std::size_t side = 1) {
  Planted out{crank, rocker, {}};
  for (const double angle : angles) out.poses.push_back(crank_pose(angle, side));
  return out;
}

TEST(DrawSynthesis, ACrankRockerTurnsForEver) {
  const LinkageDrawing l = expect_drawn(crank_rocker({0.1, 1, 2, 3.5, 5}));
  ASSERT_EQ(l.motions.size(), 1u);
  EXPECT_TRUE(l.motions[0].closed);
  EXPECT_EQ(l.motions[0].pose_frames[0], 0);
  EXPECT_EQ(l.motions[0].poses[0], 1);
  EXPECT_EQ(roles_of(l, 3), (std::vector<std::string>{"link", "fixed_pivotA0", "moving_pivotA"}));
  EXPECT_EQ(roles_of(l, 7), (std::vector<std::string>{"link", "fixed_pivotB0", "moving_pivotB"}));
  EXPECT_LT(l.window[0], -1);
  EXPECT_GT(l.window[2], 4);
  EXPECT_LT(l.window[2] - l.window[0], 12);
}

TEST(DrawSynthesis, FramesAreEvenlySpacedForTheEye) {
  const LinkageDrawing l = expect_drawn(crank_rocker({0.1, 2, 4}));
  const auto& frames = l.motions[0].frames;
  double smallest = 1e9, largest = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    double moved = 0;
    for (std::size_t k = 0; k < l.parts.size(); ++k)
      if (l.parts[k].role == "moving_pivot" || l.parts[k].role == "frame")
        for (std::size_t j = 0; j < frames[i][k].size(); ++j)
          moved = std::max(moved, (at(frames[i][k][j]) - at(frames[i + 1][k][j])).norm());
    smallest = std::min(smallest, moved), largest = std::max(largest, moved);
  }
  EXPECT_LT(largest, 1.6 * smallest);
}

TEST(DrawSynthesis, PosesOnTwoCircuitsGiveTwoMotions) {
  Planted p = crank_rocker({0.1, 2, 4});
  for (const double angle : {1.0, 3.0}) p.poses.push_back(crank_pose(angle, 0));
  const LinkageDrawing l = expect_drawn(p);
  ASSERT_EQ(l.motions.size(), 2u);
  EXPECT_EQ(l.motions[0].poses.size(), 3u);
  EXPECT_EQ(l.motions[1].poses.size(), 2u);
  EXPECT_EQ(l.motions[1].poses[0], 4);
}

TEST(DrawSynthesis, FarOriginsDrawAsNearOnes) {
  Planted p = crank_rocker({0.1, 1, 2, 3.5, 5});
  const Vector<double, 4> far = Space::point<double>({1e6, -2e6, 0, 1}), none(1, 0, 0, 0);
  const LinkageDrawing near = expect_drawn(p);
  p.a = RR::moved(crank, far, none), p.b = RR::moved(rocker, far, none);
  for (Pose& x : p.poses) x.x += 1e6, x.y -= 2e6;
  const LinkageDrawing l = expect_drawn(p, 10);
  ASSERT_EQ(l.motions.size(), 1u);
  EXPECT_TRUE(l.motions[0].closed);
  EXPECT_NEAR(l.window[2] - l.window[0], near.window[2] - near.window[0], 1e-3);
  EXPECT_NEAR(static_cast<double>(l.motions[0].frames.size()), static_cast<double>(near.motions[0].frames.size()), 1);
}

TEST(DrawSynthesis, RandomFourBars) {
  Random random("DrawSynthesis.RandomFourBars");
  int two_motions = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Planted p = plant<RR, RR>(random);
    const LinkageDrawing l = expect_drawn(p, 10);
    EXPECT_LE(l.motions.size(), 2u);
    two_motions += l.motions.size() == 2;
    for (const MotionDrawing& m : l.motions) EXPECT_TRUE(m.closed);
  }
  EXPECT_GT(two_motions, 0);
}

// ---- Change points and dead positions ----

TEST(DrawSynthesis, AParallelogramKeepsItsOrientation) {
  Planted p{RR::Design{{0, 0}, {0, 0}, 1}, RR::Design{{2, 0}, {2, 0}, 1}, {}};
  for (const double angle : {0.4, 1.5, 3.0, 4.5}) p.poses.push_back({std::cos(angle), std::sin(angle), 0, 1});
  const LinkageDrawing l = expect_drawn(p);
  ASSERT_EQ(l.motions.size(), 1u);
  EXPECT_TRUE(l.motions[0].closed);
  for (const Snapshot& s : l.motions[0].frames) EXPECT_NEAR(angle_of(pose_shown(l, s)), 0, 1e-9);
}

TEST(DrawSynthesis, APoseOfAParallelogramAtItsChangePoint) {
  Planted p{RR::Design{{0, 0}, {0, 0}, 1}, RR::Design{{2, 0}, {2, 0}, 1}, {}};
  for (const double angle : {0.0, 1.5, 3.0, 4.5}) p.poses.push_back({std::cos(angle), std::sin(angle), 0, 1});
  const LinkageDrawing l = expect_drawn(p);
  ASSERT_EQ(l.motions.size(), 1u);
}

TEST(DrawSynthesis, AnotherChangePointLinkage) {  // 1 + 4 = 2 + 3
  Planted p{RR::Design{{0, 0}, {0, 0}, 1}, RR::Design{{4, 0}, {2, 0}, 3}, {}};
  for (const double angle : {-0.9, -0.3, 0.2, 0.6, 0.8})
    for (const Pose& x : poses_at(p.a, p.b, angle)) p.poses.push_back(x);
  ASSERT_GT(p.poses.size(), 3u);
  const LinkageDrawing l = expect_drawn(p);
  for (const MotionDrawing& m : l.motions) EXPECT_TRUE(m.closed);
}

TEST(DrawSynthesis, PosesAtDeadPositions) {  // crank and coupler in line: the rocker is dead there
  Planted p = crank_rocker({0.1, 2, 4});
  for (const double reach : {3.2 + 1, 3.2 - 1}) {
    const double at_A0 = std::acos((16 + reach * reach - 9) / (8 * reach));
    p.poses.push_back(crank_pose(reach > 3.2 ? at_A0 : at_A0 + pi, 1));
    p.poses.push_back(crank_pose(reach > 3.2 ? -at_A0 : pi - at_A0, 0));
  }
  const LinkageDrawing l = expect_drawn(p);
  EXPECT_EQ(l.motions.size(), 2u);
}

// ---- Sliders ----

template <class A, class B>
void expect_sliders_drawn(const char* name, bool closed) {
  Random random(std::string("DrawSynthesis.Sliders.") + name);
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE(std::string(name) + " " + std::to_string(i));
    const Planted p = plant<A, B>(random);
    const LinkageDrawing l = expect_drawn(p, 10);
    EXPECT_LE(l.motions.size(), 4u);
    for (const MotionDrawing& m : l.motions)
      EXPECT_TRUE(m.closed || !closed);
  }
}
TEST(DrawSynthesis, RRRP) { expect_sliders_drawn<RR, PR>("RRRP", true); }
TEST(DrawSynthesis, RRPR) { expect_sliders_drawn<RR, RP>("RRPR", true); }
TEST(DrawSynthesis, PRRP) { expect_sliders_drawn<PR, PR>("PRRP", false); }
TEST(DrawSynthesis, PRPR) { expect_sliders_drawn<PR, RP>("PRPR", false); }
TEST(DrawSynthesis, RPPR) { expect_sliders_drawn<RP, RP>("RPPR", false); }

TEST(DrawSynthesis, PartsOfSliders) {
  Random random("DrawSynthesis.PartsOfSliders");
  const Planted p = plant<PR, RP>(random);
  const LinkageDrawing l = expect_drawn(p, 10);
  EXPECT_EQ(roles_of(l, 3), (std::vector<std::string>{"guide", "block", "moving_pivotA"}));
  EXPECT_EQ(roles_of(l, 7), (std::vector<std::string>{"guide", "block", "fixed_pivotB0"}));
  for (const Snapshot& s : l.at_pose)  // blocks sit on their guides
    for (const std::size_t k : {1u, 4u}) {
      ASSERT_EQ(l.parts[k].role, "block");
      const Vector2 centre = (at(s[k][0]) + at(s[k][2])) / 2, from = at(s[k - 1][0]), to = at(s[k - 1][1]);
      EXPECT_NEAR((centre - from).norm() + (centre - to).norm(), (to - from).norm(), 1e-9);
    }
}

TEST(DrawSynthesis, TheDoubleSliderWithACrank) {
  Planted p{PP::Design{0.7}, RR::Design{{0.3, -1.1}, {0.5, 0.25}, 2}, {}};
  for (const double angle : {0.4, 1.5, 3.0, 4.5}) {
    const Vector2 t = Vector2(0.3, -1.1) + 2 * Vector2(std::cos(angle), std::sin(angle)) -
                      rotated(pose_from_radians(0, 0, 0.7), {0.5, 0.25});
    p.poses.push_back(pose_from_radians(t[0], t[1], 0.7));
  }
  const LinkageDrawing l = expect_drawn(p, 2);
  ASSERT_EQ(l.motions.size(), 1u);
  EXPECT_TRUE(l.motions[0].closed);
  EXPECT_EQ(roles_of(l, 3), (std::vector<std::string>{"guide", "guide", "block", "block"}));
}

TEST(DrawSynthesis, TheDoubleSliderWithAnotherSlider) {  // a straight translation
  const Vector2 along(0.8, -0.6), offset = 0.2 * Vector2(0.6, 0.8);
  const Pose turned = pose_from_radians(0, 0, 0.7);
  Planted p{PP::Design{0.7}, PR::Design{{1, 0.3}, {{0.6, 0.8}, 0.2}}, {}};
  Planted q{PP::Design{0.7}, RP::Design{{1, 0.3}, {rotated({0, 0, -turned.X3, turned.X4}, {0.6, 0.8}), 0.2}}, {}};
  for (const double way : {-1.0, 0.0, 0.5, 2.0}) {
    const Vector2 s = offset + way * along - rotated(turned, {1, 0.3}), t = Vector2(1, 0.3) - offset + way * along;
    p.poses.push_back(pose_from_radians(s[0], s[1], 0.7));
    q.poses.push_back(pose_from_radians(t[0], t[1], 0.7));
  }
  for (const Planted& one : {p, q}) {
    const LinkageDrawing l = expect_drawn(one, 3);
    ASSERT_EQ(l.motions.size(), 1u);
    EXPECT_FALSE(l.motions[0].closed);
  }
}

TEST(DrawSynthesis, MotionsToInfinityEndAtTheHorizon) {
  Planted p{PR::Design{{0, 0}, {{0, 1}, 0}}, RP::Design{{0, 1}, {{0, 1}, 0.5}}, {}};
  for (const double angle : {-0.8, -0.3, 0.1, 0.4, 0.9}) p.poses.push_back(poses_at(p.a, p.b, angle)[0]);
  const LinkageDrawing l = expect_drawn(p, 2);
  for (const MotionDrawing& m : l.motions) {
    EXPECT_FALSE(m.closed);
    for (const Snapshot& s : m.frames) EXPECT_LT(std::abs(pose_shown(l, s).x), 20);
  }
}

// ---- Far pivots, poor answers ----

TEST(DrawSynthesis, FarPivotsGiveFiniteDrawings) {
  for (const double far : {1e3, 1e5, 1e8}) {
    SCOPED_TRACE(far);
    Planted p = crank_rocker({0.1, 1, 2, 3.5, 5});
    const double length = (to_fixed(p.poses[0], rocker.moving) - Vector2(4, -far)).norm();
    p.b = RR::Design{{4, -far}, rocker.moving, length};
    const Pose first = p.poses[0];
    p.poses = {first};
    for (const double turn : {-0.1, -0.05, 0.05, 0.1})
      for (const Pose& x : poses_at(p.a, p.b, angle_of(first) + turn)) p.poses.push_back(x);
    ASSERT_GT(p.poses.size(), 3u);
    const Drawing drawing = draw(p);
    ASSERT_EQ(drawing.linkages.size(), 1u);
    const LinkageDrawing& l = drawing.linkages[0];
    EXPECT_LT(l.window[2] - l.window[0], 20);
    EXPECT_FALSE(l.motions.empty());
    for (const Snapshot& s : l.at_pose) expect_well_formed(l, s);
    for (const MotionDrawing& m : l.motions)
      for (const Snapshot& s : m.frames) expect_well_formed(l, s);
  }
}

/// Pivots 1 / turn away, links of length 1: the motion is as large as ever, turned through 1e-6.
TEST(DrawSynthesis, SmallTurnsAboutFarPivots) {
  for (const double turn : {1e-2, 1e-4, 1e-6}) {
    SCOPED_TRACE(turn);
    const RR::Design a{{1, 1 / turn}, {0, 1 / turn}, 1.2}, b{{-0.6 / turn, 1.3}, {-0.6 / turn, 0.2}, 1};
    Planted p{a, b, {}};
    for (const double angle : {-0.3, 0.0, 0.2, 0.4})
      for (const Pose& x : poses_at(a, b, turn * angle)) p.poses.push_back(x);
    ASSERT_GT(p.poses.size(), 4u);
    const LinkageDrawing l = expect_drawn(p, 10);
    EXPECT_LE(l.motions.size(), 2u);
    for (const MotionDrawing& m : l.motions) EXPECT_TRUE(m.closed);
  }
}

TEST(DrawSynthesis, APoseThatIsMissedIsShownWhereTheLinkageComesNearest) {
  Planted p = crank_rocker({0.1, 1, 2, 3.5, 5});
  p.poses[2].x += 0.01;
  const LinkageDrawing l = draw(p).linkages.at(0);
  ASSERT_EQ(l.motions.size(), 1u);
  EXPECT_EQ(l.motions[0].poses.size(), 5u);
  const Pose shown = pose_shown(l, l.at_pose[2]);
  EXPECT_LT(apart(shown, p.poses[2]), 0.02);
  EXPECT_LT(std::abs(residual(p.a, shown)), 1e-9);
}

/// Every answer of the solvers draws: finite, every pose on exactly one motion.
TEST(DrawSynthesis, AnswersToEveryKindOfTask) {
  const auto module = make_module();
  for (const TaskClass& task : random_task_classes()) {
    Random random("DrawSynthesis.AnswersToEveryKindOfTask." + std::string(task.name));
    for (int i = 0; i < 10; ++i) {
      SCOPED_TRACE(std::string(task.name) + " " + std::to_string(i));
      Problem problem;
      for (const Pose& x : task.make(random)) problem.poses.push_back({x.x, x.y, x.X3, x.X4});
      const Synthesis answer = module->synthesize(problem);
      const Drawing drawing = draw_synthesis(problem, answer);
      ASSERT_EQ(drawing.linkages.size(), answer.linkages.size());
      for (const LinkageDrawing& l : drawing.linkages) {
        std::vector<int> times(problem.poses.size(), 0);
        for (const MotionDrawing& m : l.motions) {
          for (const Snapshot& s : m.frames) expect_well_formed(l, s);
          for (const int j : m.poses) ++times[j - 1];
        }
        EXPECT_EQ(times, std::vector<int>(problem.poses.size(), 1)) << "linkage " << l.id;
      }
    }
  }
}

TEST(DrawSynthesis, EmptyAnswersShowThePoses) {
  Problem problem;
  problem.poses = {{1, 2, 0, 1}, {3, 4, 1, 0}};
  const Drawing d = draw_synthesis(problem, {});
  ASSERT_EQ(d.poses.size(), 2u);
  EXPECT_TRUE(d.linkages.empty());
  EXPECT_EQ(d.poses[1].label, "2");
  EXPECT_EQ(d.poses[1].origin, (std::array{3.0, 4.0}));
  EXPECT_EQ(d.poses[1].x_axis[0], -1);
  EXPECT_TRUE(draw_synthesis({}, {}).poses.empty());
}

}  // namespace
}  // namespace burmester::planar
