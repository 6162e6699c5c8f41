// The example of docs/add_a_dyad.md, compiled from that page: its laws hold, and search finds a planted design.
#include <stock_bar.hpp>

#include "burmester/modules/framework/conformance.hpp"
#include "burmester/modules/framework/search.hpp"
#include "burmester/planar/dyads.hpp"

using StockBarAlone = burmester::DyadList<burmester::planar::StockBar>;
BURMESTER_DYAD_CONFORMANCE(StockBarAlone);

namespace burmester::planar {
namespace {

static_assert(DyadType<StockBar> && !LiftedDyadType<StockBar>);

TEST(StockBar, SearchFindsAPlantedOne) {
  Random random("StockBar.SearchFindsAPlantedOne");
  const StockBar::Design planted{{0.5, -0.3}, {0.2, 0.7}};
  std::array<Pose, 4> poses;
  for (Pose& p : poses) {
    p = Space::random_pose(random);
    const Vector2 at = to_fixed(p, planted.moving), along = (at - planted.fixed).normalized();
    const Vector2 shift = planted.fixed + StockBar::length * along - at;
    p.x += shift[0], p.y += shift[1];
  }
  bool found = false;
  for (const auto& f : search<StockBar>(poses)) {
    EXPECT_LT(f.residual, 1e-8);
    found = found || (f.design.fixed - planted.fixed).norm() + (f.design.moving - planted.moving).norm() < 1e-6;
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace burmester::planar
