// The dyads of five poses do not depend on frames, unit, order and sign of the data; they follow the
// inversion.
#include <gtest/gtest.h>

#include <limits>

#include "burmester/modules/framework/local.hpp"
#include "burmester/planar/five_pose_solver.hpp"
#include "burmester/planar/tasks.hpp"

namespace burmester::planar {
namespace {

using Design = Dyads::Design;
using Image = Vector<double, 4>;

PlanarReport solve(const FivePoseTask& task) { return FivePoseSolver().solve(task); }

/// How differently two designs judge the poses; infinite for different types.
double difference(const Design& a, const Design& b, std::span<const Pose> probes) {
  return Dyads::visit(a, [&]<class D>(const typename D::Design& d) {
    const auto* other = std::get_if<typename D::Design>(&b);
    return other ? disagreement<D>(d, *other, probes) : std::numeric_limits<double>::infinity();
  });
}

double nearest(const Design& design, const PlanarReport& report, std::span<const Pose> probes) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& found : report.dyads) least = std::min(least, difference(design, found.design, probes));
  return least;
}

double length_of(const Design& design) {
  return Dyads::visit(design,
                      []<class D>(const typename D::Design& d) { return D::record(d).length.value_or(0); });
}

/// Poses of the task's size that are none of the task's.
std::vector<Pose> random_probes(Random& random, double size) {
  std::vector<Pose> probes;
  for (int i = 0; i < 8; ++i) {
    Pose p = Space::random_pose(random);
    p.x *= size, p.y *= size;
    probes.push_back(p);
  }
  return probes;
}

// Transforming a task rounds its poses once more, which moves a dyad by that times its condition; the
// designs' own rounding is relative to their lengths. 512: the solver's own elimination, by up to the inverse
// of its pivots.
double tolerance(const Found<Design>& found, double size, double coordinates) {
  return 512 * unit_roundoff *
         ((1 + found.condition.value_or(0)) * (size + coordinates) + length_of(found.design));
}

/// Solves tasks, transforms them and expects the dyads to follow. `scale`: new length of a unit; `make`:
/// gives what happens to a pose, and to a design.
template <class Make>
void expect_follow(const std::string& stream, double scale, double shift, Make make) {
  for (const char* name : {"generic", "planted_PR", "planted_RP", "planted_four_bar"}) {
    Random random(stream + '.' + name);
    for (int i = 0; i < 100; ++i) {
      const FivePoseTask task = find_task_class(name)->make(random);
      const auto [transform, follow] = make(random);
      FivePoseTask image;
      for (std::size_t j = 0; j < 5; ++j) image[j] = transform(task[j]);
      const PlanarReport before = solve(task), after = solve(image);
      ASSERT_EQ(before.dyads.size(), after.dyads.size()) << stream << '.' << name << ", task " << i;
      const double size = scale * task_size(task);
      const std::vector<Pose> probes = random_probes(random, size);
      for (const auto& found : before.dyads) {
        if (found.condition.value_or(0) > 1e8) continue;
        const double limit = tolerance(found, size, shift) + scale * tolerance(found, task_size(task), shift);
        EXPECT_LT(nearest(follow(found.design), after, probes), limit)
            << stream << '.' << name << ", task " << i << ", condition " << found.condition.value_or(0);
      }
    }
  }
}

auto moved(const Image& g, const Image& h) {
  return [=](const Design& any) {
    return Dyads::visit(any, [&]<class D>(const typename D::Design& d) { return Design(D::moved(d, g, h)); });
  };
}
auto reframe(const Image& g, const Image& h) {
  return [=](const Pose& p) { return Space::pose(reframed<Space>(g, Space::point<double>(p), h)); };
}

TEST(Invariance, UnderChangeOfTheFixedFrame) {
  expect_follow("Invariance.UnderChangeOfTheFixedFrame", 1, 3, [](Random& random) {
    const Image g = Space::point<double>(Space::random_pose(random)), h = Space::point<double>(Pose{});
    return std::pair(reframe(g, h), moved(g, h));
  });
}

TEST(Invariance, UnderChangeOfTheMovingFrame) {
  expect_follow("Invariance.UnderChangeOfTheMovingFrame", 1, 3, [](Random& random) {
    const Image g = Space::point<double>(Pose{}), h = Space::point<double>(Space::random_pose(random));
    return std::pair(reframe(g, h), moved(g, h));
  });
}

TEST(Invariance, UnderInversion) {  // fixed and moving exchanged, PR and RP too
  expect_follow("Invariance.UnderInversion", 1, 3, [](Random&) {
    const auto inverse = [](const Pose& p) {
      return Space::pose(Space::conjugate<double>(Space::point<double>(p)));
    };
    const auto follow = [](const Design& any) {
      return Dyads::visit(any, [&]<class D>(const typename D::Design& d) { return Design(D::inverse(d)); });
    };
    return std::pair(inverse, follow);
  });
}

/// The design in a unit of length 1 / factor.
Design scaled(const Design& any, double factor) {
  Design out = any;
  if (auto* rr = std::get_if<RR::Design>(&out))
    rr->fixed *= factor, rr->moving *= factor, rr->length *= factor;
  if (auto* pr = std::get_if<PR::Design>(&out)) pr->moving *= factor, pr->line.offset *= factor;
  if (auto* rp = std::get_if<RP::Design>(&out)) rp->fixed *= factor, rp->line.offset *= factor;
  return out;
}

TEST(Invariance, UnderChangeOfUnit) {
  for (const double factor : {3.7, 1e-3, 25.4})
    expect_follow("Invariance.UnderChangeOfUnit." + std::to_string(factor), factor, 0, [factor](Random&) {
      return std::pair(
          [=](const Pose& p) {
            return Pose{factor * p.x, factor * p.y, p.X3, p.X4};
          },
          [=](const Design& d) { return scaled(d, factor); });
    });
}

TEST(Invariance, ToTheLastBitUnderPowersOfTwo) {
  Random random("Invariance.ToTheLastBitUnderPowersOfTwo");
  for (int i = 0; i < 300; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    const double factor = std::ldexp(1.0, random.below(81) - 40);
    FivePoseTask image = task;
    for (Pose& p : image) p.x *= factor, p.y *= factor;
    const PlanarReport before = solve(task), after = solve(image);
    ASSERT_EQ(before.dyads.size(), after.dyads.size()) << "task " << i;
    for (std::size_t k = 0; k < before.dyads.size(); ++k) {
      const auto* a = std::get_if<RR::Design>(&before.dyads[k].design);
      const auto* b = std::get_if<RR::Design>(&after.dyads[k].design);
      ASSERT_TRUE(a && b) << "task " << i;
      EXPECT_EQ(a->fixed * factor, b->fixed) << "task " << i;
      EXPECT_EQ(a->moving * factor, b->moving) << "task " << i;
      EXPECT_EQ(a->length * factor, b->length) << "task " << i;
    }
  }
}

TEST(Invariance, UnderReordering) {
  Random random("Invariance.UnderReordering");
  for (int i = 0; i < 300; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    FivePoseTask shuffled = task;
    for (int k = 4; k > 0; --k) std::swap(shuffled[k], shuffled[random.below(k + 1)]);
    const PlanarReport before = solve(task), after = solve(shuffled);
    ASSERT_EQ(before.dyads.size(), after.dyads.size()) << "task " << i;
    const std::vector<Pose> probes = random_probes(random, task_size(task));
    for (const auto& found : before.dyads)
      if (!(found.condition.value_or(0) > 1e8)) {
        EXPECT_LT(nearest(found.design, after, probes), 2 * tolerance(found, task_size(task), 0))
            << "task " << i;
      }
  }
}

TEST(Invariance, UnderTheSignOfTheHalfAngle) {
  Random random("Invariance.UnderTheSignOfTheHalfAngle");
  for (int i = 0; i < 300; ++i) {
    const FivePoseTask task = find_task_class("generic")->make(random);
    FivePoseTask image = task;
    for (Pose& p : image)
      if (random.below(2)) p.X3 = -p.X3, p.X4 = -p.X4;
    const PlanarReport before = solve(task), after = solve(image);
    ASSERT_EQ(before.dyads.size(), after.dyads.size()) << "task " << i;
    for (std::size_t k = 0; k < before.dyads.size(); ++k)
      EXPECT_EQ(difference(before.dyads[k].design, after.dyads[k].design, task), 0) << "task " << i;
  }
}

}  // namespace
}  // namespace burmester::planar
