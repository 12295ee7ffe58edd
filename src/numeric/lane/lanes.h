// SPDX-License-Identifier: GPL-3.0-or-later
// Several doubles at once, as wide as the instruction set has registers. `lane_kernels.cpp` and what it
// includes are compiled once for each instruction set, in a namespace of that name. The results do not depend
// on it: every operation is that of IEEE 754, and products are exact in two parts with or without a fused
// multiply-add. The one exception is `product_plus`, for plain sums over points, which takes it for speed.
//
// Only built-in types here and in the kernels: an inline function of a library, compiled for a wide machine,
// could be what the linker keeps for all.
#pragma once

#include <cstddef>
#include <cstdint>
#ifdef __FMA__
#include <immintrin.h>
#endif

#ifndef RIGOR_INSTRUCTION_SET
#define RIGOR_INSTRUCTION_SET baseline
#define RIGOR_LANES 2
#endif

#define RIGOR_INLINE [[gnu::always_inline]] inline
#define RIGOR_INLINE_LAMBDA __attribute__((always_inline))

namespace rigor::RIGOR_INSTRUCTION_SET {

inline constexpr int lanes = RIGOR_LANES;

using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));
/// All bits of a lane set: true. None: false.
using LaneMask = std::int64_t __attribute__((vector_size(lanes * sizeof(double))));

/// The comparison of two T, which `select` takes.
template <class T>
struct MaskOf;
template <>
struct MaskOf<double> {
  using Type = bool;
};
template <>
struct MaskOf<Lanes> {
  using Type = LaneMask;
};
template <class T>
using Mask = typename MaskOf<T>::Type;

/// The same number in every lane.
template <class T>
RIGOR_INLINE T all(double value) {
  return value - T{};  // x − 0 is x, also for −0
}

RIGOR_INLINE Lanes load(const double* from) {
  Lanes x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}
RIGOR_INLINE void store(double* to, Lanes x) { __builtin_memcpy(to, &x, sizeof x); }

RIGOR_INLINE double root(double x) { return __builtin_sqrt(x); }
RIGOR_INLINE Lanes root(Lanes x) {
  Lanes r;
  for (int i = 0; i < lanes; ++i) r[i] = __builtin_sqrt(x[i]);
  return r;
}

RIGOR_INLINE double absolute(double x) { return __builtin_fabs(x); }
RIGOR_INLINE Lanes absolute(Lanes x) { return (Lanes)((LaneMask)x & INT64_MAX); }

/// The first where both are equal; the second where either is not a number.
RIGOR_INLINE double greater(double a, double b) { return a > b ? a : b; }
RIGOR_INLINE Lanes greater(Lanes a, Lanes b) { return a > b ? a : b; }

RIGOR_INLINE double select(bool mask, double a, double b) { return mask ? a : b; }
RIGOR_INLINE Lanes select(LaneMask mask, Lanes a, Lanes b) { return mask ? a : b; }

RIGOR_INLINE bool any(bool mask) { return mask; }
RIGOR_INLINE bool any(LaneMask mask) {
  std::int64_t bits = 0;
  for (int i = 0; i < lanes; ++i) bits |= mask[i];
  return bits != 0;
}

RIGOR_INLINE bool negation(bool mask) { return !mask; }
RIGOR_INLINE LaneMask negation(LaneMask mask) { return ~mask; }

/// |x| with the sign of `sign`.
RIGOR_INLINE double with_sign(double x, double sign) { return __builtin_copysign(x, sign); }
RIGOR_INLINE Lanes with_sign(Lanes x, Lanes sign) {
  return (Lanes)(((LaneMask)x & INT64_MAX) | ((LaneMask)sign & INT64_MIN));
}

/// The power of two at or below a normal positive number; exact.
RIGOR_INLINE double power_below(double x) {
  std::int64_t bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  bits &= 0x7ff0000000000000;
  __builtin_memcpy(&x, &bits, sizeof x);
  return x;
}
RIGOR_INLINE Lanes power_below(Lanes x) { return (Lanes)((LaneMask)x & 0x7ff0000000000000); }

/// 1 / x for such a power of two, from 2^-1022 to 2^1022; exact.
RIGOR_INLINE double inverse_power(double x) {
  std::int64_t bits;
  __builtin_memcpy(&bits, &x, sizeof bits);
  bits = 0x7fe0000000000000 - bits;
  __builtin_memcpy(&x, &bits, sizeof x);
  return x;
}
RIGOR_INLINE Lanes inverse_power(Lanes x) { return (Lanes)(0x7fe0000000000000 - (LaneMask)x); }

/// Four parts of one problem at once: one register, or two where registers hold two doubles.
#if RIGOR_LANES >= 4

using Quad = double __attribute__((vector_size(32)));
using QuadMask = std::int64_t __attribute__((vector_size(32)));

/// The parts of these numbers, of a and then b, from 0 to 7.
template <int i, int j, int k, int l>
RIGOR_INLINE Quad parts(Quad a, Quad b) {
  return __builtin_shufflevector(a, b, i, j, k, l);
}
#if RIGOR_LANES == 8
RIGOR_INLINE Quad absolute(Quad x) { return (Quad)((QuadMask)x & INT64_MAX); }
#endif
RIGOR_INLINE Quad select(bool mask, Quad a, Quad b) {
  return QuadMask{} - static_cast<std::int64_t>(mask) ? a : b;
}
RIGOR_INLINE bool in_all(QuadMask mask) { return (mask[0] & mask[1] & mask[2] & mask[3]) != 0; }

#else

struct QuadMask {
  LaneMask low;
  LaneMask high;
};
struct Quad {
  Lanes low;
  Lanes high;
  RIGOR_INLINE double operator[](int i) const { return i < 2 ? low[i] : high[i - 2]; }
};

#define RIGOR_QUAD_OPERATOR(sign)                                                                    \
  RIGOR_INLINE Quad operator sign(Quad a, Quad b) { return {a.low sign b.low, a.high sign b.high}; } \
  RIGOR_INLINE Quad operator sign(double a, Quad b) { return {a sign b.low, a sign b.high}; }        \
  RIGOR_INLINE Quad operator sign(Quad a, double b) { return {a.low sign b, a.high sign b}; }
#define RIGOR_QUAD_COMPARISON(sign) \
  RIGOR_INLINE QuadMask operator sign(Quad a, Quad b) { return {a.low sign b.low, a.high sign b.high}; }
RIGOR_QUAD_OPERATOR(+)
RIGOR_QUAD_OPERATOR(-)
RIGOR_QUAD_OPERATOR(*)
RIGOR_QUAD_OPERATOR(/)
RIGOR_QUAD_COMPARISON(==)
RIGOR_QUAD_COMPARISON(<=)
RIGOR_QUAD_COMPARISON(>=)
#undef RIGOR_QUAD_OPERATOR
#undef RIGOR_QUAD_COMPARISON

RIGOR_INLINE Quad operator-(Quad a) { return {-a.low, -a.high}; }
RIGOR_INLINE QuadMask operator&(QuadMask a, QuadMask b) { return {a.low & b.low, a.high & b.high}; }

template <int i, int j, int k, int l>
RIGOR_INLINE Quad parts(Quad a, Quad b) {
  const auto part = [&](int n) RIGOR_INLINE_LAMBDA { return n < 4 ? a[n] : b[n - 4]; };
  return {Lanes{part(i), part(j)}, Lanes{part(k), part(l)}};
}
RIGOR_INLINE Quad absolute(Quad x) { return {absolute(x.low), absolute(x.high)}; }
RIGOR_INLINE Quad select(bool mask, Quad a, Quad b) {
  const LaneMask both = LaneMask{} - static_cast<std::int64_t>(mask);
  return {select(both, a.low, b.low), select(both, a.high, b.high)};
}
RIGOR_INLINE bool in_all(QuadMask mask) {
  const LaneMask both = mask.low & mask.high;
  return (both[0] & both[1]) != 0;
}

#endif

/// Of four numbers.
RIGOR_INLINE Quad quad(double a, double b, double c, double d) {
#if RIGOR_LANES >= 4
  return Quad{a, b, c, d};
#else
  return {Lanes{a, b}, Lanes{c, d}};
#endif
}

#ifdef __FMA__
RIGOR_INLINE double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
/// By the instruction: GCC makes one scalar operation a lane of a loop over `__builtin_fma`.
RIGOR_INLINE Lanes fused(Lanes a, Lanes b, Lanes c) {
#if RIGOR_LANES == 8
  return _mm512_fmadd_pd(a, b, c);
#elif RIGOR_LANES == 4
  return _mm256_fmadd_pd(a, b, c);
#else
  return _mm_fmadd_pd(a, b, c);
#endif
}
#if RIGOR_LANES == 8
RIGOR_INLINE Quad fused(Quad a, Quad b, Quad c) { return _mm256_fmadd_pd(a, b, c); }
#endif
/// a b − p for p = fl(a b): exact unless it underflows.
template <class T>
RIGOR_INLINE T rest_of_product(T a, T b, T p) {
  return fused(a, b, -p);
}
/// a b + c with one rounding, or with two where there is no such instruction: the one operation whose bits
/// depend on the instruction set.
template <class T>
RIGOR_INLINE T product_plus(T a, T b, T c) {
  return fused(a, b, c);
}
#else
template <class T>
RIGOR_INLINE T product_plus(T a, T b, T c) {
  return a * b + c;
}
/// The same without a fused multiply-add: T. J. Dekker, Numer. Math. 18 (1971) 224. |a|, |b| < 2^996.
template <class T>
RIGOR_INLINE T rest_of_product(T a, T b, T p) {
  const T ca = a * 134217729.;  // 2^27 + 1
  const T cb = b * 134217729.;
  const T ah = ca - (ca - a);
  const T bh = cb - (cb - b);
  const T al = a - ah;
  const T bl = b - bh;
  return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}
#endif

}  // namespace rigor::RIGOR_INSTRUCTION_SET
