// A law that cannot fail proves nothing: each of these mistakes is planted in a geometry that is right but
// for it.
#include <gtest/gtest.h>

#include "caught.hpp"
#include "toy_geometry.hpp"

namespace burmester {
namespace {

using toy::Circle;
using toy::Plane;
using toy::Stop;
using toy::Turns;
using Image = Plane::Point<double>;
using Place = Plane::Feature<double>;

template <class S>
testing::AssertionResult space_caught(std::string_view law) {
  return caught(laws::space_violations<S>(), law);
}
template <class D>
testing::AssertionResult dyad_caught(std::string_view law) {
  return caught(laws::dyad_violations<D>(), law);
}

TEST(SpaceLaws, AcceptWhatIsRight) {
  EXPECT_TRUE(laws::space_violations<Plane>().empty());
  EXPECT_TRUE(laws::space_violations<Turns>().empty());
}

struct DroppedSign : Plane {
  template <class T>
  static Image product(const Image& x, const Image& y) {
    Image out = Plane::product<T>(x, y);
    out[1] = x[0] * y[1] - x[1] * y[0];
    return out;
  }
};
TEST(SpaceLaws, CatchADroppedSignInTheProduct) {
  EXPECT_TRUE(space_caught<DroppedSign>("product_is_associative"));
}

struct WrongOrder : Plane {
  template <class T>
  static Image product(const Image& x, const Image& y) {
    return Plane::product<T>(y, x);
  }
};
TEST(SpaceLaws, CatchFactorsInTheWrongOrder) { EXPECT_TRUE(space_caught<WrongOrder>("acts_from_the_left")); }

struct WrongConjugate : Plane {
  template <class T>
  static Image conjugate(const Image& x) {
    return {x[0], -x[1], x[2], x[3]};
  }
};
TEST(SpaceLaws, CatchAWrongConjugate) { EXPECT_TRUE(space_caught<WrongConjugate>("conjugate_is_inverse")); }

struct WrongNorm : Plane {
  template <class T>
  static double norm(const Image& x) {
    return x.squaredNorm();
  }
};
TEST(SpaceLaws, CatchAWrongNorm) { EXPECT_TRUE(space_caught<WrongNorm>("norm_is_multiplicative")); }

struct ActThatDivides : Plane {
  template <class T>
  static Place act(const Image& x, const Place& a) {
    return Plane::act<T>(x, a) / Plane::norm<T>(x);
  }
};
TEST(SpaceLaws, CatchAnActThatDivides) { EXPECT_TRUE(space_caught<ActThatDivides>("acts_from_the_left")); }

struct ActWithoutShift : Plane {
  template <class T>
  static Place act(const Image& x, const Place& a) {
    return Plane::act<T>(Image{x[0], x[1], 0, 0}, a);
  }
};
TEST(SpaceLaws, CatchAnActThatForgetsTheShift) {
  EXPECT_TRUE(space_caught<ActWithoutShift>("different_displacements_differ"));
}

struct ActInTheMovingFrame : Plane {
  template <class T>
  static Place act(const Image& x, const Place& a) {
    return Plane::act<T>(Plane::conjugate<T>(x), a);
  }
};
TEST(SpaceLaws, CatchTheInverseAction) {
  EXPECT_TRUE(space_caught<ActInTheMovingFrame>("acts_from_the_left"));
}

struct WrongDistance : Plane {
  static double distance(const Place& a, const Place& b) { return (a - b).lpNorm<1>(); }
};
TEST(SpaceLaws, CatchADistanceThatDependsOnTheFrame) {
  EXPECT_TRUE(space_caught<WrongDistance>("displacements_are_isometries"));
}

struct SignedGap : Plane {
  static double gap(const Image& x, const Image& y) { return (x.normalized() - y.normalized()).norm() / 2; }
};
TEST(SpaceLaws, CatchAGapThatSeesTheSign) { EXPECT_TRUE(space_caught<SignedGap>("gap_tells_points_apart")); }

struct CoarseGap : Plane {
  static double gap(const Image& x, const Image& y) {
    return std::sqrt(std::max(0.0, 1 - std::pow(x.normalized().dot(y.normalized()), 2)));
  }
};
TEST(SpaceLaws, CatchAGapBlindBelowTheRootOfRounding) {
  EXPECT_TRUE(space_caught<CoarseGap>("gap_tells_points_apart"));
}

struct WrongPose : Plane {
  static Pose pose(const Image& x) {
    const Pose p = Plane::pose(x);
    return {p.x, p.y, -p.angle};
  }
};
TEST(SpaceLaws, CatchAPoseTurnedBackwards) { EXPECT_TRUE(space_caught<WrongPose>("poses_are_points")); }

struct ShiftedIdentity : Plane {
  template <class T>
  static Image point(const Pose& p) {
    return Plane::point<T>({p.x + 1, p.y, p.angle});
  }
  static Pose pose(const Image& x) {
    const Pose p = Plane::pose(x);
    return {p.x - 1, p.y, p.angle};
  }
};
TEST(SpaceLaws, CatchAnIdentityThatIsNone) {
  EXPECT_TRUE(space_caught<ShiftedIdentity>("product_is_associative"));
}

struct IdleNudge : Plane {
  static Pose nudged(const Pose& p, const Vector<double, 3>& u) {
    return {p.x + u[0], p.y + u[0], p.angle + u[2]};
  }
};
TEST(SpaceLaws, CatchDependentLocalCoordinates) {
  EXPECT_TRUE(space_caught<IdleNudge>("nudges_are_local_coordinates"));
}

struct NudgeInDegrees : Plane {
  static Pose nudged(const Pose& p, const Vector<double, 3>& u) {
    return {p.x + u[0], p.y + u[1], p.angle + u[2] / 57};
  }
};
TEST(SpaceLaws, CatchLocalCoordinatesInDegrees) {
  EXPECT_TRUE(space_caught<NudgeInDegrees>("nudges_are_local_coordinates"));
}

TEST(DyadLaws, AcceptWhatIsRight) {
  EXPECT_TRUE(laws::dyad_violations<Circle>().empty());
  EXPECT_TRUE(laws::dyad_violations<Stop>().empty());
}

template <class Self, class D = Circle>
struct Mutant : D {
  using Inverse = Self;
};

struct UnmovedBody : Mutant<UnmovedBody> {
  static Design moved(const Design& d, const Image& g, const Image&) {
    return {placed(g, d.fixed), d.moving, d.length};
  }
};
TEST(DyadLaws, CatchAFrameChangeForgotten) { EXPECT_TRUE(dyad_caught<UnmovedBody>("residual_is_covariant")); }

struct WrongBody : Mutant<WrongBody> {
  static double residual(const Design& d, const Plane::Pose& x) {
    return Circle::residual({d.moving, d.fixed, d.length}, x);
  }
};
TEST(DyadLaws, CatchBodiesMixedUpInTheResidual) {
  EXPECT_TRUE(dyad_caught<WrongBody>("residual_is_covariant"));
}

struct NotSwapped : Mutant<NotSwapped> {
  static Design inverse(const Design& d) { return d; }
};
TEST(DyadLaws, CatchAnInverseThatDoesNotSwap) {
  EXPECT_TRUE(dyad_caught<NotSwapped>("inverse_exchanges_the_bodies"));
}

struct AlwaysMet : Mutant<AlwaysMet> {
  static double residual(const Design&, const Plane::Pose&) { return 0; }
};
TEST(DyadLaws, CatchAConstraintThatConstrainsNothing) {
  EXPECT_TRUE(dyad_caught<AlwaysMet>("design_constrains_poses"));
}

struct NeverMet : Mutant<NeverMet> {
  static double residual(const Design& d, const Plane::Pose& x) {
    return std::abs(Circle::residual(d, x)) + 1;
  }
};
TEST(DyadLaws, CatchAConstraintThatNothingMeets) {
  EXPECT_TRUE(dyad_caught<NeverMet>("design_constrains_poses"));
}

struct IdleParameter : Mutant<IdleParameter> {
  static Design nudged(const Design& d, Vector<double, 5> u) {
    u[3] = u[2];
    return Circle::nudged(d, u);
  }
};
TEST(DyadLaws, CatchAnIdleParameter) {
  EXPECT_TRUE(dyad_caught<IdleParameter>("parameters_are_independent"));
}

struct WrongName : Mutant<WrongName> {
  static constexpr const char* name = "RP";
};
TEST(DyadLaws, CatchARecordOfAnotherType) { EXPECT_TRUE(dyad_caught<WrongName>("record_shows_the_design")); }

TEST(LiftedLaws, CatchEveryWrongRowAndFormEntry) { expect_flips_caught<Stop>(); }

template <class NewFamily>
struct StopIn : Mutant<StopIn<NewFamily>, Stop> {
  using Family = NewFamily;
};

struct WrongRelation : toy::StopFamily {
  template <class T>
  static Vector<T, 1> relations(const Vector<T, 3>& k) {
    return Vector<T, 1>{T(k[0] * k[0] + k[1] * k[1] + k[2] * k[2])};
  }
};
TEST(LiftedLaws, CatchAWrongRelation) {
  EXPECT_TRUE(dyad_caught<StopIn<WrongRelation>>("encoded_designs_keep_the_relations"));
}

struct EmptyRelation : toy::StopFamily {
  template <class T>
  static Vector<T, 1> relations(const Vector<T, 3>&) {
    return Vector<T, 1>{T(0)};
  }
};
TEST(LiftedLaws, CatchARelationThatSaysNothing) {
  EXPECT_TRUE(dyad_caught<StopIn<EmptyRelation>>("encoded_designs_keep_the_relations"));
}

struct SignedDecode : toy::StopFamily {
  static std::optional<std::variant<toy::StopDesign>> decode(const Vector<double, 3>& k) {
    if (k[2] == 0) return std::nullopt;
    return toy::StopDesign{std::atan2(k[1], k[0])};
  }
};
TEST(LiftedLaws, CatchADecodeThatSeesTheScale) {
  EXPECT_TRUE(dyad_caught<StopIn<SignedDecode>>("decode_undoes_encode"));
}

struct DependentRows : toy::StopFamily {
  template <class T>
  static Vector<T, 3> row(const Turns::Pose& pose) {
    Vector<T, 3> out = StopFamily::row<T>(pose);
    out[2] = out[0];
    return out;
  }
};
TEST(LiftedLaws, CatchADimensionTooLarge) {
  EXPECT_TRUE(dyad_caught<StopIn<DependentRows>>("rows_span_the_family"));
}

}  // namespace
}  // namespace burmester
