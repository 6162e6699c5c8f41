// The curves of four poses do not depend on frames, unit and order of the poses; they follow the inversion.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "burmester/modules/framework/local.hpp"
#include "burmester/planar/four_pose_curves.hpp"
#include "four_poses.hpp"

namespace burmester::planar {
namespace {

using Design = Dyads::Design;
using Image = Vector<double, 4>;

/// What happens to a task, and with it to a dyad.
struct Change {
  std::function<FourPoseTask(const FourPoseTask&)> task;
  std::function<Design(const Design&)> dyad;
};

/// The one pivot of a PR or RP dyad.
Vector2 pivot_of(const Design& design) {
  const auto* pr = std::get_if<PR::Design>(&design);
  return pr ? pr->moving : std::get<RP::Design>(design).fixed;
}

/// Pairs of one task's curves, carried over, are on the exact cubics of the other; sliders and topology follow. Forming
/// the other task rounds its poses once more: its curves are off by that, amplified near double points and by far
/// pivots as in docs/dyad_form.md; 1e-10 and, for sliders, which may lie far away, 1e-8 leave room for both.
template <class Make>
void expect_follow(const std::string& seed, Make make) {
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const FourPoseTask before = random_four_poses(random);
    const Change change = make(random);
    const FourPoseTask after = change.task(before);
    const PlanarReport was = FourPoseSolver().solve(before), is = FourPoseSolver().solve(after);
    const CurveTopology t = four_pose_curves(before).topology, u = four_pose_curves(after).topology;
    EXPECT_EQ(t.components, u.components) << seed << " " << i;
    EXPECT_EQ(t.ovals, u.ovals) << seed << " " << i;

    const ExactCubics cubics(after);
    for (const CurveRecord& piece : was.curves)
      for (std::size_t k = 0; k < piece.moving.size(); k += 9) {
        const Vector2 m(piece.moving[k][0], piece.moving[k][1]), c(piece.fixed[k][0], piece.fixed[k][1]);
        const Design design = change.dyad(RR::Design{c, m, (to_fixed(before[0], m) - c).norm()});
        const auto& rr = std::get<RR::Design>(design);
        EXPECT_LT(cubics.distance_of_moving(rr.moving), 1e-10) << seed << " " << i;
        EXPECT_LT(cubics.distance_of_fixed(rr.fixed), 1e-10) << seed << " " << i;
        EXPECT_LT(concyclicity(after, rr.moving, rr.fixed), 1e-10) << seed << " " << i;
      }

    ASSERT_EQ(was.dyads.size(), is.dyads.size()) << seed << " " << i;
    for (const auto& found : was.dyads) {
      const Design design = change.dyad(found.design);
      int same = 0;
      for (const auto& other : is.dyads)
        if (other.design.index() == design.index()) {
          ++same;
          const Vector2 pivot = pivot_of(design);
          EXPECT_LT((pivot - pivot_of(other.design)).norm(), 1e-8 * (task_size(after) + pivot.norm()))
              << seed << " " << i;
        }
      EXPECT_EQ(same, 1) << seed << " " << i;
    }
  }
}

Change reframing(const Image& g, const Image& h) {
  return {[=](FourPoseTask task) {
            for (Pose& p : task) p = Space::pose(reframed<Space>(g, Space::point<double>(p), h));
            return task;
          },
          [=](const Design& any) {
            return Dyads::visit(any, [&]<class D>(const typename D::Design& d) { return Design(D::moved(d, g, h)); });
          }};
}

TEST(FourPoseInvariance, UnderChangeOfTheFixedFrame) {
  expect_follow("FourPoseInvariance.UnderChangeOfTheFixedFrame", [](Random& random) {
    return reframing(Space::point<double>(Space::random_pose(random)), Space::point<double>(Pose{}));
  });
}

TEST(FourPoseInvariance, UnderChangeOfTheMovingFrame) {
  expect_follow("FourPoseInvariance.UnderChangeOfTheMovingFrame", [](Random& random) {
    return reframing(Space::point<double>(Pose{}), Space::point<double>(Space::random_pose(random)));
  });
}

TEST(FourPoseInvariance, UnderInversion) {  // fixed and moving exchanged, PR and RP too
  expect_follow("FourPoseInvariance.UnderInversion", [](Random&) {
    return Change{[](FourPoseTask task) {
                    for (Pose& p : task) p = Space::pose(Space::conjugate<double>(Space::point<double>(p)));
                    return task;
                  },
                  [](const Design& any) {
                    return Dyads::visit(any,
                                        []<class D>(const typename D::Design& d) { return Design(D::inverse(d)); });
                  }};
  });
}

TEST(FourPoseInvariance, UnderChangeOfUnit) {
  for (const double factor : {3.7, 1e-3, 25.4})
    expect_follow("FourPoseInvariance.UnderChangeOfUnit." + std::to_string(factor), [factor](Random&) {
      return Change{[=](FourPoseTask task) {
                      for (Pose& p : task) p.x *= factor, p.y *= factor;
                      return task;
                    },
                    [=](Design any) {
                      if (auto* rr = std::get_if<RR::Design>(&any))
                        rr->fixed *= factor, rr->moving *= factor, rr->length *= factor;
                      if (auto* pr = std::get_if<PR::Design>(&any)) pr->moving *= factor, pr->line.offset *= factor;
                      if (auto* rp = std::get_if<RP::Design>(&any)) rp->fixed *= factor, rp->line.offset *= factor;
                      return any;
                    }};
    });
}

TEST(FourPoseInvariance, UnderTheOrderOfThePoses) {
  for (const std::array<std::size_t, 4>& order : {std::array<std::size_t, 4>{0, 3, 2, 1}, {1, 0, 2, 3}, {3, 2, 0, 1}})
    expect_follow("FourPoseInvariance.UnderTheOrderOfThePoses." + std::to_string(order[0]), [order](Random&) {
      return Change{[=](const FourPoseTask& task) {
                      return FourPoseTask{task[order[0]], task[order[1]], task[order[2]], task[order[3]]};
                    },
                    [](const Design& any) { return any; }};
    });
}

}  // namespace
}  // namespace burmester::planar
