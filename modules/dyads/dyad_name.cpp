#include "burmester/modules/dyads/dyad_name.hpp"

#include <algorithm>
#include <cassert>

namespace burmester {
namespace {

constexpr int unknown = static_cast<int>(dyad_names.size());

}  // namespace

int type_rank(std::string_view type) {
  return static_cast<int>(std::find(dyad_names.begin(), dyad_names.end(), type) - dyad_names.begin());
}

Joint fixed_joint(std::string_view type) {
  assert(type_rank(type) < unknown);
  return static_cast<Joint>(type[0]);
}

Joint moving_joint(std::string_view type) {
  assert(type_rank(type) < unknown);
  return static_cast<Joint>(type[1]);
}

std::string inverse_type(std::string_view type) { return {type.rbegin(), type.rend()}; }

bool pairs(std::string_view first, std::string_view second) {
  return type_rank(first) < unknown && type_rank(second) < unknown && !(first == "PP" && second == "PP");
}

std::string linkage_type(std::string_view first, std::string_view second) {
  assert(pairs(first, second));
  if (type_rank(second) < type_rank(first)) std::swap(first, second);
  return std::string(first) + inverse_type(second);
}

}  // namespace burmester
