// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "app/run.h"

int main(int argc, char** argv) { return rigor::run(argc, argv, std::cout, std::cerr); }
