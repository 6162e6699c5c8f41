#include <iostream>

#include "burmester/burmester.hpp"
#include "program/application.hpp"
#include "program/commands.hpp"

int main(int argc, char** argv) {
  burmester::prepare_standard_streams();
  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);
  burmester::Console console{std::cin, std::cout, std::cerr};
  const burmester::Registry registry = burmester::built_in_modules();
  return burmester::run_program({argv + 1, argv + argc}, registry, console);
}
