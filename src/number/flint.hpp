#pragma once

#include <mpfr.h>
// Only after it FLINT 3 has what turns its numbers into MPFR's.
#include <flint/flint.h>
#include <flint/fmpz.h>
// All that is used of Arb: a part of FLINT 3, where its headers include less of one another.
#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/acb_elliptic.h>
#include <flint/arb.h>
#include <flint/arb_poly.h>
#include <flint/arf.h>
#else
#include <acb_calc.h>
#include <acb_elliptic.h>
#include <arb_poly.h>
#endif
