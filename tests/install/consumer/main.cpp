#include <burmester/geometry/vector.hpp>

#include <cstdio>

// Compiled with -march=native, against a library that is not: public types must have one layout for both.
static_assert(alignof(burmester::Vector<double, 4>) == alignof(double));

int main() {
  const burmester::Vector<double, 4> ones = burmester::Vector<double, 4>::Ones();
  std::printf("%g\n", ones.sum());
  return ones.sum() == 4 ? 0 : 1;
}
