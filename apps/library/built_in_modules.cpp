#include "burmester/burmester.hpp"
#include "burmester/planar/planar.hpp"
#include "burmester/spherical/spherical.hpp"

namespace burmester {

Registry built_in_modules() {
  Registry registry;
  registry.add(planar::make_module());
  registry.add(spherical::make_module());
  return registry;
}

}  // namespace burmester
