#include <fcntl.h>
#include <unistd.h>
#include <csignal>
#include <iostream>

#include "burmester/burmester.hpp"
#include "program/commands.hpp"

namespace {

/// A closed standard stream would lend its number to the next file that is opened: output would end up in
/// that file.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1)
      _exit(3);
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);  // writing reports it
  std::ios::sync_with_stdio(false);
  std::cin.tie(nullptr);
  burmester::Console console{std::cin, std::cout, std::cerr};
  const burmester::Registry registry = burmester::built_in_modules();
  return burmester::run_program({argv + 1, argv + argc}, registry, console);
}
