// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the sanitizers, linked into every program of the `dev` preset: they hold however it is started.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_options();
extern "C" const char* __ubsan_default_options();

// CLN allocates a few bytes once, when it is loaded, and never frees them; so does GiNaC for a product that
// it combines.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libcln\nleak:GiNaC::mul::combine_ex_with_coeff_to_pair\n";
}

extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }

extern "C" const char* __ubsan_default_options() { return "print_stacktrace=1"; }
