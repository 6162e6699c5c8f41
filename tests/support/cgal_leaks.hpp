// To be included by one file of each test program that analyses curves with CGAL.
//
// CGAL 5.5's status lines and curves hold each other by reference counts: what they cache is never freed. Of numbers
// that GMP and MPFR have allocated for it (and for MPFR's cache of constants in each thread)
// the stack often shows GMP alone.
#pragma once

#ifdef __SANITIZE_ADDRESS__
extern "C" const char* __lsan_default_suppressions() { return "leak:CGAL::\nleak:__gmp_default_"; }
#endif
