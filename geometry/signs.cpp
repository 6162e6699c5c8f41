#include "burmester/geometry/signs.hpp"

#include "burmester/geometry/predicate.hpp"

namespace burmester {

template Sign sign_beyond_doubles<Determinant<2>>(const std::array<double, 4>&);
template Sign sign_beyond_doubles<Determinant<3>>(const std::array<double, 9>&);
template Sign sign_beyond_doubles<Determinant<4>>(const std::array<double, 16>&);
template Sign sign_beyond_doubles<Orientation2>(const std::array<double, 6>&);
template Sign sign_beyond_doubles<Orientation3>(const std::array<double, 12>&);
template Sign sign_beyond_doubles<InCircle>(const std::array<double, 8>&);
template Sign sign_beyond_doubles<DyadClosure>(const std::array<double, 8>&);

}  // namespace burmester
