#include <iostream>

#include "burmester/burmester.hpp"
#include "program/application.hpp"
#include "research/planar_limit/command.hpp"

int main(int argc, char** argv) {
  burmester::prepare_standard_streams();
  burmester::Console console{std::cin, std::cout, std::cerr};
  return burmester::run_planar_limit({argv + 1, argv + argc}, burmester::built_in_modules(), console);
}
