#include <burmester/burmester.hpp>
#include <burmester/spherical/dyads.hpp>

#include <cstdio>

// Compiled with -march=native, against a library that is not: public types must have one layout for both.
static_assert(alignof(burmester::Vector<double, 4>) == alignof(double));

int main() {
  const burmester::Registry registry = burmester::built_in_modules();
  for (const burmester::Module* module : registry.modules()) std::printf("%s\n", module->info().name.c_str());

  // A value that crosses from compiled library code: the layout again, at run time.
  const burmester::spherical::RR::Design reach{{0, 0, 1}, {1, 0, 0}, 1.0};
  const burmester::spherical::RR::Design back =
      burmester::spherical::RR::moved(reach, {1, 0, 0, 0}, {0, 0, 0, 1});
  const bool same_layout = back.moving[0] == -1 && back.arc == 1.0;
  return registry.find("planar") && registry.find("spherical") && same_layout ? 0 : 1;
}
