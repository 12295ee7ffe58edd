// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <iostream>

#include "app/command/run.h"

namespace {

/// A file that is opened later would take the number of a closed standard stream, and be written into. What
/// is opened here instead cannot be written.
void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1) static_cast<void>(open("/dev/null", O_RDONLY));
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  return rigor::run(argc, argv, std::cout, std::cerr);
}
