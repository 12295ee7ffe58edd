// SPDX-License-Identifier: GPL-3.0-or-later
// What `elaborate` knows of notations: one function for each, in the file of its kind.
#pragma once

#include "elaborate/notation/elaborate.h"

namespace rigor {

using ReadPart = MaybeTyped(Reading& reading, SyntaxId id, const Around& around);

ReadPart elaborate_transpose, elaborate_adjoint;                    // adjoint.cpp
ReadPart elaborate_bars, elaborate_component;                       // bracket.cpp
ReadPart elaborate_cases;                                           // cases.cpp
ReadPart elaborate_part, elaborate_average;                         // complex.cpp
ReadPart elaborate_derivative;                                      // derivative.cpp
ReadPart elaborate_function, elaborate_integral;                    // function.cpp
ReadPart elaborate_line_integral, elaborate_between;                // integral.cpp
ReadPart elaborate_tuple, elaborate_matrix, elaborate_determinant;  // matrix.cpp
ReadPart elaborate_diagonal;                                        // matrix.cpp
ReadPart elaborate_pair;                                            // operators.cpp
ReadPart elaborate_power, elaborate_root;                           // power.cpp
ReadPart elaborate_sum, elaborate_big_sum;                          // sum.cpp
ReadPart elaborate_counted_sum;                                     // integral.cpp
ReadPart elaborate_term;                                            // term.cpp
ReadPart elaborate_unit;                                            // unit.cpp

/// A ket or a bra, by its name.
[[nodiscard]] MaybeTyped elaborate_state(Reading& reading, SyntaxId id);  // operators.cpp
/// A star, a bar over an expression, `\Re` or `\Im`.
[[nodiscard]] bool is_part_of_complex(std::string_view function);
/// r of `U(r) = …`, where that stands above, maybe in another section; primes and dots are passed over.
[[nodiscard]] std::vector<std::string> variables_of_definition(const Names& names, WrittenSymbol function);
/// The number that is written, also with a minus before it.
[[nodiscard]] std::optional<int> whole_number(const SyntaxTree& syntax, SyntaxId id);
/// `sin`, `tanh`, `exp`…, as quotients of sines, cosines and exponentials.
[[nodiscard]] MaybeTyped elementary_function(Reading& reading, const std::string& name, const Typed& argument,
                                             Span span);

}  // namespace rigor
