// SPDX-License-Identifier: GPL-3.0-or-later
// What one section shows of its letters. A letter is known by what it is without subscripts: `r`, `\hat n`.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elaborate/evidence/matrix_shape.h"
#include "expr/tree/symbol.h"
#include "latex/split/split.h"
#include "latex/token/syntax.h"

namespace rigor {

/// A letter that stands alone on one side of an equation, with a matrix on another.
struct MatrixLetter {
  std::set<MatrixShape> shapes;                          // more than one: nothing says which it is
  std::set<std::pair<FileId, std::uint32_t>> set_there;  // where it stands alone
  bool of_itself = false;                                // x of `x = (x, y)`: two letters
  bool written = false;  // equal to a matrix itself, and not only to a product
};

/// What shows that letters are matrices of unknown size, or columns. Names have their labels: `A_{1}`,
/// `\mathbf{x}`.
struct UnsizedMatrices {
  std::set<std::string> matrices;  // when all is seen
  std::set<std::string> columns;   // the same
  std::set<std::string> shown;     // called matrices, or in a transpose, a trace or a determinant
  std::set<std::string> shown_by_transpose;
  std::map<std::string, std::string> rows;                // n of "let $A$ be an $n\times n$ matrix"
  std::set<std::string> called;                           // by words: any matrix is meant, but for `special`
  std::map<std::string, std::set<std::string>> beside;    // B of `AB`, with A
  std::set<std::string> transposed;                       // x of `x^T`
  std::map<std::string, std::set<std::string>> acted_on;  // x of `Ax`, with A; "" stands for a transpose
  std::vector<std::set<std::string>> alike;              // x, x_0 and u of `x = x_0 + Bu`: columns, if one is
  std::set<std::string> numbers;                         // x of `x^2`
  std::map<std::string, std::set<std::string>> made_of;  // P of `P = AB`, with A and B
  std::set<std::string> written;                         // u of `u = (1, 2)`
  std::set<std::string> indexed;                         // A of `A_{ij}`
  std::set<std::string> dotted;                          // in a product with a dot or a cross
  std::set<std::string> sizes;                           // n of "$n\times n$"
  std::string special;             // "symmetric": the first word by which not all matrices are meant
  int units = 0;                   // how often I stands where the unit matrix can: `AB = I`, `\lambda I`
  int no_units = 0;                // and how often elsewhere
  bool speaks_of_square = false;   // "square matrices"
  bool rectangular = false;        // "$n\times m$"
  bool t_is_a_letter = false;      // "the time $T$": then `x^T` may be a power
  bool speaks_of_blocks = false;   // of matrices of matrices
  bool speaks_of_columns = false;  // "vectors"
};

/// How a section says that a letter counts.
struct CountingLetter {
  std::optional<int> first;  // the largest first number that is said
  bool said = false;         // "an integer", `n = 1, 2, \dots`, `E_{n+1}`
  bool some_only = false;    // "for odd $n$", `n = 1.5`
};

/// The rows that tie one letter to another.
struct TyingRows {
  Span first;
  bool several = false;
  bool of_the_letter = false;  // `v = R\omega`; not `\ddot\theta = -\frac gl\sin\theta`
};

/// Letters of a relation that says of none of them alone what it is.
struct TiedTogether {
  std::set<std::string> letters;
  Span row;
};

/// Letters that name what is summed over and is no axis: s of `\sum_s e^{-\beta E_s}`. Of components of a
/// vector nobody takes a function.
struct SummedMembers {
  std::set<std::string> summed;        // Latin, below a sum without limits
  std::set<std::string> in_functions;  // the only subscript in an exponent, or behind `\exp`, `\ln`, `\sin`
  std::set<std::string> otherwise;     // n of `n\epsilon`, i of `\delta_{ij}` and of `Q = T_i\Delta S`
  std::set<std::string> vectors;       // k of `\mathbf k`, whose k_j are components
  std::map<std::string, std::set<std::string>> on;  // E of `E_s`, by s

  [[nodiscard]] bool has(const std::string& letter) const;
};

/// Tensors of space-time, whose Greek indices are above and below. Letters are as `letter_with_marks` has
/// them.
struct SpaceTime {
  bool shown = false;             // when all is seen: Greek letters above are indices here
  bool curved = false;            // the words speak of another metric than that of special relativity
  bool words = false;             // they speak of four-vectors, of Minkowski, of space-time
  bool unit_speed = false;        // c = 1
  bool formulas = false;          // `F^{\mu\nu}`, `\partial^\mu`, `a_\mu b^\mu`
  std::set<int> signs;            // of η_00: 1 or −1, where the section says which
  std::set<std::string> indices;  // Greek letters that are indices somewhere
  std::map<std::string, std::set<std::size_t>> tensors;  // letters with such indices, and how many they have
  std::set<std::string> on_line;                         // letters that stand on the line, without a power
  std::string metric = "\\eta";                          // or `g`
};

struct Evidence {
  std::set<std::string> vectors;   // bold or under an arrow somewhere
  std::set<std::string> crossed;   // factors of a cross product
  std::set<std::string> numbers;   // divisors, and small Latin letters next to a vector
  std::set<std::string> ordered;   // what may be a matrix or an operator: the order of factors may matter
  std::set<std::string> labelled;  // of those, what has a subscript there: components of a vector of matrices
  std::set<std::string> hatted;    // `\hat x`: a unit vector or an operator
  std::set<std::string> real;      // in an order, in a sine, or said to be real
  std::set<std::string> complex;   // conjugated somewhere: `\bar z`, `\psi^*`
  std::set<std::string> letters;   // all that are in equations, without faces and accents; `i` among them
  std::set<std::string> points;    // of names such as `ABC` in the prose
  std::set<std::string> components;                        // u, v, w of `\mathbf u = (u, v, w)`: no lengths
  std::set<std::string> coefficients;                      // r of `\mathbf r = r\hat r`: it has a sign
  std::set<std::string> units;                             // "the unit matrix $I$": 1 among matrices
  std::set<std::string> functionals;                       // `E[X]`: square brackets stand directly after
  std::map<std::string, std::set<std::string>> functions;  // \omega of `\omega(k) = …`, with k
  std::map<std::string, std::set<std::string>> running;    // of these, k: the other side has it, too
  std::map<std::string, std::set<std::string>> running_primed;  // r of `V'(r) = 2ar`, as `running` has it
  std::map<std::string, std::set<std::vector<std::string>>>
      applied;                                      // `\psi(x, t)`: letters in brackets behind it
  std::map<std::string, std::set<std::string>> by;  // x of `dy/dx`, with y: what is differentiated by
  std::map<std::string, Span> first_by;             // where the first of these derivatives stands
  std::set<std::string> primed;                     // y of `y''` and `y'(x)`: a prime is a derivative
  std::set<std::string> with_primes;    // A of `A'`, which may be a derivative; as `changing` names it
  bool speaks_of_conservation = false;  // "conserved", "constant": then l of `l = mr^2\dot\theta` is held
  bool speaks_of_dependence = false;    // "depends on", "varies", "not constant": of a letter or not
  bool speaks_of_signs = false;         // "negative", "opposite": then a root need not be the positive one
  std::set<std::string> changing;       // letters of which a rate is written, or that have an argument
  std::map<std::string, std::set<std::string>> in_exponents;  // r of `e^{rx}`, with x
  std::map<std::string, std::map<std::string, TyingRows>>
      tied;                                 // m of `m = \mu t`, with what stands on the other sides
  std::vector<TiedTogether> tied_together;  // C, d and A of `Cd = \epsilon A`
  std::set<std::string> said_to_change;     // "$U$ depends on"
  std::set<std::string> may_change;  // these, what is tied to them or to the time, and what has an argument
  std::set<std::string> may_change_in_time;  // the same, but for x, y, z and r that nothing shows to move
  bool d_is_a_letter = false;                // `F = Ed`, "the distance $d$": then `dU` may be a product
  bool speaks_of_change = false;             // "variable mass", "grows": any letter may change
  bool third_axis = false;         // a component along z, or three of them: it is not about the plane alone
  bool operators = false;          // a commutator, a dagger, a bra or ket, `\hat p` or `\hat H`
  bool speaks_of_order = false;    // the words speak of matrices or operators: then capitals may be some
  bool order_in_heading = false;   // a heading does, or words of a group: then small letters may be some, too
  bool speaks_of_numbers = false;  // they say "numbers" and name none
  std::set<std::string> imaginary_units;  // `i`, `j`, `\mathrm{i}`: where they are shown to be the number i
  std::set<std::string> complex_numbers;  // shown to be complex, with labels: z of `z = x + iy`, `\mathbf{E}`
  std::set<std::string> starred;          // may be conjugated: `m^*`
  std::set<std::string> overlined;        // the same with a bar, or under `\Re`
  std::set<std::string> real_parts;       // x and y of `x + iy`: real, though `x = (z + z^*)/2`
  std::set<std::string> no_units;         // i of `i = 5`
  std::set<std::string> declared_real;    // "scalar z"
  std::set<std::string> operator_letters;  // alone in a commutator, under a dagger, or called operators
  std::set<std::string>
      operator_families;  // the same with a subscript that can be an index: L of `[L_i, L_j]`
  std::map<std::string, std::set<std::string>> set_equal;  // a letter, with the names on the other sides
  std::set<std::string> written_out;                       // A of `A = \begin{pmatrix}…`
  std::set<std::string> noncommuting;          // shown to be operators, with labels: `\hat{p}`, `L_{z}`
  std::set<std::string> noncommuting_triples;  // L of the components L_i
  UnsizedMatrices unsized;
  bool speaks_of_operators = false;                      // the words do, or of commutators
  bool speaks_of_poisson = false;                        // of Poisson brackets
  std::map<std::string, std::set<std::string>> made_of;  // z of `z = x + iy`, with x, y and i
  bool says_imaginary = false;                           // "the imaginary unit", "complex numbers"
  bool says_conjugate = false;                           // "the complex conjugate"
  bool speaks_of_complex = false;                        // the words do
  bool complex_vectors = false;   // and so that fields and amplitudes may be complex as well
  std::string other_space;        // words of another number of dimensions, or another metric
  std::string other_metric;       // of another metric
  std::string other_axes;         // words of components that are not Cartesian
  bool hatted_axes = false;       // `\hat x`: beside such words as well, the unit vectors are Cartesian
  std::string other_arithmetic;   // words of sums and products that are not those of real numbers
  std::set<std::string> raised;   // x of `x^\mu`, `x^1 = x`: its upper indices are no powers
  bool speaks_of_raised = false;  // the words do, and name no letter
  SpaceTime space_time;
  std::set<std::string> exponents;  // that are numbers where they stand above: they stand on the line as well
  std::set<std::string> counters;   // n of `x_{n+1}`: in a subscript it counts the members of a sequence
  std::map<std::string, CountingLetter> counting;  // n of "for $n = 1, 2, \dots$"
  std::set<std::string> numbered;                  // n of `n_1`: several quantities of one name
  SummedMembers members;
  bool speaks_of_levels = false;                // "harmonics", "energy levels": then n counts them
  std::set<std::string> quantities_apart;       // `E_{0}` of "the amplitude $E_0$": no member of the E_n
  std::map<std::string, MatrixLetter> triples;  // S of `\mathbf S = \frac\hbar2\boldsymbol\sigma`
  std::set<std::string> many_triples;           // \sigma of `\boldsymbol\sigma_1`, `\sigma_i^z`
  bool speaks_of_pauli = false;
  std::map<std::string, MatrixLetter> matrices;  // A of `A = \begin{pmatrix}…`, as `matrix_name` spells it
  std::set<std::string> entries;                 // letters inside written matrices, spelled so
  std::set<std::string> multiples;  // \lambda of `\lambda I`: numbers, though a determinant is taken of them
  std::set<std::string> plain_numbers;  // letters that are numbers by their use, spelled so
  bool speaks_of_segments = false;      // of triangles and segments: `AB` can be the name of one
  std::set<std::string> averaged;       // x of `\langle x^2\rangle`, alone in the brackets, or called random
  std::set<std::string> beside_averages;  // a of `a\langle x\rangle`, outside of all brackets
  std::set<std::string> daggered;         // a of `a^\dagger`
  bool speaks_of_means = false;           // "average", "expectation value": so a bar can mean
  bool angles_generate = false;           // "the ideal generated by": what angle brackets can be instead
  bool states = false;                    // a ket or a bra is written
  std::set<std::string> state_operators;  // H of `H|n\rangle`, `\langle m|H|n\rangle`
  std::set<std::string> state_labels;     // n of `|n+1\rangle`: it numbers states
  bool sentence_is_open = false;          // while reading: such a sentence goes on with the next display

  /// May the letter be a matrix or an operator?
  [[nodiscard]] bool is_ordered(const std::string& letter) const;
};

/// Adds what the faces, products and fractions below `root` show.
void see_kinds(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence);

/// Adds what equations between a vector and its components show.
void see_components(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);

/// Adds the letters that count the members of a sequence in a subscript.
void see_subscripts(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence);
/// The letters of a subscript that is a formula: n of `n+1`. Empty for all others.
[[nodiscard]] std::vector<std::string> counters_in(const WrittenIndex& index);

// --- seen_subscripts.cpp: Letters that count: n of `E_n = n^2E_1` and of "for $n = 1, 2, \dots$".

/// What one chain shows; `sides` are its sides as they were parsed.
void see_families(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);
/// What one chain shows of the letters below its sums.
void see_summed_members(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, SummedMembers& members);
/// The text of a display, or `prose` with its formulas.
void see_counting(std::string_view text, bool prose, Evidence& evidence);
/// n of "for $n = 1, 2, \dots$": can such a letter count?
[[nodiscard]] bool may_count_members(std::string_view letter);

/// `\hat n` for `\hat n_i`: letter, accent, change and primes.
[[nodiscard]] std::string letter_with_marks(const WrittenSymbol& symbol);
/// `m_{1}`, `v_{x}`: a name where the subscripts are labels.
[[nodiscard]] std::string with_labels(const std::string& base, const std::vector<WrittenIndex>& labels);

// --- complex_letters.cpp: Evidence that a letter is the number i, and that letters are complex: `e^{i\omega
// t}`, `z = x + iy`, a number times its conjugate, and words. All that is not shown to be complex is real.

/// What one chain shows; `sides` are its sides as they were parsed.
void see_complex(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);
/// "The imaginary unit $j$", "a complex amplitude $A$", "where $z$ is complex".
void see_said_complex(std::string_view text, Evidence& evidence);
/// A directive says that it is complex, or a scalar, which is real.
void see_declared_complex(const WrittenSymbol& symbol, bool complex, Evidence& evidence);
/// When all is seen: what is made of complex numbers is one.
void settle_complex(Evidence& evidence);

/// `i`, `j`, `\mathrm{i}`, `\imath`, without anything on it.
[[nodiscard]] bool may_be_imaginary_unit(const WrittenSymbol& symbol);
/// How `complex_numbers` names a symbol: `\psi_{0}`, `\mathbf{E}`.
[[nodiscard]] std::string complex_name(const WrittenSymbol& symbol);
[[nodiscard]] std::string complex_name(const std::string& base, int rank);

// --- ordered_letters.cpp: Evidence that letters are matrices or operators, whose products keep their
// order: a displayed matrix, a commutator, a dagger, a transpose, a trace, a ket, hats where operators are
// about, and words.

/// What one chain shows; `sides` are its sides as they were parsed.
void see_order(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
               Evidence& evidence);

/// "The operators $x$ and $p$": the words of a section, with what is set in the line. Capitals of a section
/// that speaks of matrices or operators are counted in, and so is what its sentence displays.
void see_words(std::string_view text, Evidence& evidence);

/// "Heisenberg picture", "Quaternions": in such a section any letter may be one.
void see_heading(std::string_view title, Evidence& evidence);

/// When all is seen: hatted letters are operators where operators are about, else unit vectors.
void settle_order(Evidence& evidence);

// --- averaged_letters.cpp: Letters inside the brackets of averages, and words of averages.

/// What one chain shows; `sides` are its sides as they were parsed.
void see_averages(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);
/// \pi, \hbar, k_B: on any page. The name is one as `complex_name` has it.
[[nodiscard]] bool is_same_for_all_outcomes(std::string_view name);
/// "The mean value", "the random variables $X$ and $Y$", "the ideal generated by".
void see_said_averages(std::string_view text, Evidence& evidence);

// --- matrix_letters.cpp: Letters that are set equal to a written matrix or column, or to what is made of
// such letters: their shape is known.

/// Adds the letters of one chain, and the shapes that its other sides have.
void see_matrices(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                  Evidence& evidence);
/// Is the letter one, and neither perhaps the length of a bold one nor an entry of its own matrix?
[[nodiscard]] bool is_matrix_letter(const WrittenSymbol& symbol, const Evidence& evidence);
/// Does such a letter, or a written matrix, stand in it?
[[nodiscard]] bool holds_matrix_letter(const SyntaxTree& syntax, SyntaxId id, const Evidence& evidence);
/// The shape of what is written in rows and columns; none for anything else.
[[nodiscard]] MatrixShape written_shape(const SyntaxTree& syntax, SyntaxId id);
/// Can a letter that nothing explains be a matrix, a column or a map, where it stands beside a matrix?
[[nodiscard]] bool may_be_a_matrix(const std::string& letter, const Evidence& evidence);
/// The letter with face, marks and subscripts: \mathbf{A} is another matrix than A.
[[nodiscard]] std::string matrix_name(const WrittenSymbol& symbol);

// --- matrix_triples.cpp: Three matrices of one size, σ_x, σ_y and σ_z, are the components of a vector of
// matrices: `\sigma_i` and `\boldsymbol\sigma` are about all three.

/// What a letter without its subscripts stands for, where it stands for three matrices.
struct MatrixTriple {
  MatrixShape shape = {};
  std::array<std::string, 3> members = {};  // as `matrix_name` spells them; empty: the vector alone is known
  bool usual = false;                       // the Pauli matrices, of which only the words speak
};
[[nodiscard]] std::optional<MatrixTriple> triple_of(const Evidence& evidence, const std::string& letter);
/// `\boldsymbol\sigma`
[[nodiscard]] std::optional<MatrixTriple> whole_triple(const Evidence& evidence, const WrittenSymbol& symbol);
/// `\sigma_i`, where i can only be an index, or an axis.
[[nodiscard]] std::optional<MatrixTriple> triple_of_member(const Evidence& evidence,
                                                           const WrittenSymbol& symbol);
/// Notes vectors of matrices that a chain sets equal to a multiple of another, and letters with two labels.
void see_triples(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                 Evidence& evidence);

// --- operator_letters.cpp: Evidence that letters are operators: for these, unlike those that only may be
// some, products keep their order.

/// What one chain shows; `sides` are its sides as they were parsed.
void see_operators(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);
/// "The operators $A$ and $B$", "commutator", "Poisson bracket".
void see_said_operators(std::string_view text, Evidence& evidence);
/// When all is seen: what is in brackets is an operator where the words or a hat or dagger show that the
/// brackets are commutators. What is written out as a matrix is none.
void settle_operators(Evidence& evidence);
/// Do the letters stand for an operator, or for the components of three? `base` has its labels.
[[nodiscard]] bool is_operator(const Evidence& evidence, const std::string& base, int rank);
[[nodiscard]] bool is_operator(const Evidence& evidence, const WrittenSymbol& symbol);

// --- unsized_matrices.cpp: Letters that are matrices of unknown size, or columns.

/// What one chain shows; `sides` are its sides as they were parsed.
void see_unsized_matrices(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);
/// "Let $A$ and $B$ be $n\times n$ matrices", "the matrix $A$".
void see_said_unsized_matrices(std::string_view text, Evidence& evidence);
/// When all is seen; before `settle_operators`.
void settle_unsized_matrices(Evidence& evidence);
/// `base` has its labels.
[[nodiscard]] Unsized unsized_letter(const Evidence& evidence, const std::string& base);

// --- space_time.cpp: Greek indices above and below: `F^{\mu\nu}`, `a_\mu b^\mu`, "four-vectors".

/// What one chain shows; `sides` are its sides as they were parsed.
void see_space_time(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, SpaceTime& seen);
/// The text of a display, or prose with its formulas: the signs of the metric, c = 1, and words.
void see_said_space_time(std::string_view text, SpaceTime& seen);
/// When all is seen of the section: `file` is what the whole file shows of signs and words.
void settle_space_time(const SpaceTime& file, Evidence& evidence);
/// The letters and digits above a letter, where they can be indices of space-time; empty where they cannot.
[[nodiscard]] std::vector<WrittenIndex> indices_above(const SyntaxTree& syntax, SyntaxId exponent);
/// Is the Greek letter an index here?
[[nodiscard]] bool is_space_time_index(const Evidence& evidence, const WrittenIndex& index);

// --- raised_indices.cpp: Upper indices: where `x^\mu` or `x^1` stands, `x^2` need not be a square.

/// `x^1`, `x^0`, `x^\mu`, `g^{ij}`, and `a^kb_k` in the sides of one chain.
void see_raised(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);

/// "The coordinates $x^i$", "upper indices", "superscripts label …".
void see_said_raised(std::string_view text, Evidence& evidence);

/// `x^{-n}`, `V^{\gamma - 1}`, `T^{n/2}`: no index is written so.
[[nodiscard]] bool is_reckoned(const SyntaxTree& syntax, SyntaxId exponent);

/// Can the number above the symbol be an index?
[[nodiscard]] bool may_be_raised(const WrittenSymbol& symbol, const Evidence& evidence);

// --- said_order.cpp: Words that say how letters are multiplied: "do not commute", "let $G$ be a group",
// "$a$ and $b$ are matrices", "in floating-point arithmetic".

/// Adds what the words of a section say. Where they say that something does not commute, or speak of a group,
/// any letter may be an element of it; where they name another arithmetic, nothing counts as proved for it.
void see_said_order(std::string_view text, Evidence& evidence);

// --- seen_differentials.cpp: Differentials by themselves, `dU = T\,dS - p\,dV`.

/// Notes the letters of differentials, and a `d` that is none.
void see_differentials(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence);
/// `\mathrm dU`
[[nodiscard]] bool is_lone_differential(const SyntaxTree& syntax, SyntaxId id);
/// `dU`, where nothing says whether that is a product.
[[nodiscard]] bool is_sign_of_differential(const SyntaxTree& syntax, std::span<const SyntaxChild> factors,
                                           std::size_t at);
/// `\delta Q`, the same.
[[nodiscard]] bool is_sign_of_form(const SyntaxTree& syntax, std::span<const SyntaxChild> factors,
                                   std::size_t at);
/// Has each term of each side, but for a written 0, one differential or form as a factor?
[[nodiscard]] bool relates_differentials(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides);

// --- seen_functions.cpp: Letters that are written with their argument: functions before other brackets as
// well. Letters that change.

/// Letters with letters in brackets behind them, and letters with a dot or under d/dt.
void see_changing(const SyntaxTree& syntax, SyntaxId root, Evidence& evidence);
/// What a letter alone is set equal to.
void see_ties(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);
/// "The mass grows", "an inhomogeneous medium".
void see_said_changes(std::string_view text, Evidence& evidence);
/// When all is seen: what may change because something else does.
void settle_changes(Evidence& evidence);

/// `\omega`, `E_n`: without primes and powers, which a function can have as well.
[[nodiscard]] std::string function_name(const WrittenSymbol& symbol);
/// `(x, t)`, but no column: nobody writes arguments so.
[[nodiscard]] bool may_hold_arguments(const SyntaxTree& syntax, SyntaxId bracket);
/// Does a row above the first derivative by the variable say that it is made of the letter? R of `v =
/// R\omega` beside `dE/dv`. What stands below may be where an extremum is: `h = \sqrt{3u/M}` behind `dE/dh`.
[[nodiscard]] bool is_made_of(const Evidence& evidence, const std::string& variable,
                              const std::string& letter);
/// m, c, \hbar: nobody lets them change with what is made of them, p of `p = mv`.
[[nodiscard]] bool is_mass_or_constant(std::string_view name);
/// `x_0`, `t'`: a value of what the function depends on.
[[nodiscard]] bool is_marked(std::string_view letter);
/// `\omega`, `k`: the letter that begins at `at`, which moves after it.
[[nodiscard]] std::string take_letter(std::string_view text, std::size_t& at);

/// How `Evidence::changing`, `may_change`, `tied` and `by` name a symbol: `x`; `x_#` for `x_i` and `x_1`,
/// which change together; `\omega_p`, `V_eff` and `x_0` with their labels. None of these says anything of
/// another.
[[nodiscard]] std::string changing_name(const WrittenSymbol& symbol);
[[nodiscard]] std::string changing_name(std::string_view name);
/// `\dot q`: how `Evidence::by` names a variable that is a rate.
[[nodiscard]] std::string dotted(std::string_view letter, int dots);
/// Does the section write the letter with plain letters in brackets behind it?
[[nodiscard]] bool is_applied(const Evidence& evidence, std::string_view name);
/// Does the section differentiate something of this name by the variable, or apply it to that?
[[nodiscard]] bool is_function_of(const Evidence& evidence, std::string_view name, std::string_view variable);
/// Is a derivative by it one by a letter of its own? By x, y and z it is one by place, unless the section
/// shows that one of the others is a function of it: `dy/dx`, `y(x)`.
[[nodiscard]] bool is_own_variable(const Evidence& evidence, std::string_view letter);
/// y of `dy/dx`, `y(x)`: a coordinate that the section makes a function of another one is no place.
[[nodiscard]] bool is_function_of_a_coordinate(const Evidence& evidence, std::string_view name);
/// What the primes on `y''` and `V'(r)` differentiate by; nothing where a prime may name another quantity.
[[nodiscard]] std::optional<std::string> variable_of_primes(const WrittenSymbol& symbol,
                                                            const Evidence& evidence);

/// `\omega(k) = ck`: the first side of a chain.
void see_functions(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence);

/// "where $n(E)$ is the density of states", "with $f(x) = x^2$".
void see_inline_functions(std::string_view text, Evidence& evidence);

/// Can the symbol, which `functions` has with its arguments, be applied to this bracket? Not to one that it
/// is in itself, `n(n + 1)`, and a vector only to its own arguments.
[[nodiscard]] const std::set<std::string>* arguments_of(const SyntaxTree& syntax, SyntaxId symbol,
                                                        SyntaxId bracket, const Evidence& evidence);

/// Is it, or the letter that it is with labels and accents, among those that change?
[[nodiscard]] bool is_changing(const Evidence& evidence, std::string_view name);
/// Can it change, as far as the section shows?
[[nodiscard]] bool may_be_changing(const Evidence& evidence, std::string_view name);
/// With the time: r of `\dot N = rN` is no place.
[[nodiscard]] bool may_be_changing_in_time(const Evidence& evidence, std::string_view name);

/// Does the section write the symbol as a function: `V(r)`, `\omega(k) = \dots`? Its variables, of which
/// the letters in other brackets, `V(r_0)`, are values; nothing where several could be that.
[[nodiscard]] std::optional<std::vector<std::string>> variables_of(const WrittenSymbol& symbol,
                                                                   const Evidence& evidence);
/// Letters that are no functions, whatever stands behind them: π, i, orders, differentials, changes.
[[nodiscard]] bool is_never_applied(const WrittenSymbol& symbol);

/// Does the bracket only show what the symbol depends on, so that `x(t)` is x? It is so if the section
/// applies the symbol to no other letters, and nobody would write such a product: several letters, a letter
/// that the symbol is defined with, or a usual coordinate behind what is no usual coefficient.
[[nodiscard]] bool is_argument(const SyntaxTree& syntax, SyntaxId symbol, SyntaxId bracket,
                               const Evidence& evidence);

/// What is differentiated or applied, through brackets, derivatives and arguments: `\psi` of
/// `\partial_x\psi(x, t)`.
[[nodiscard]] SyntaxId without_derivatives(const SyntaxTree& syntax, SyntaxId id);

// --- seen_letters.cpp: Evidence that letters are real, complex, functionals or the ends of a segment: an
// order, a conjugate, square brackets, and words.

/// What one chain shows; `sides` are its sides as they were parsed.
void see_letters(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                 Evidence& evidence);

/// "where $a$, $b$ are real numbers", "for $x > 0$", "complex amplitudes", "in the triangle $ABC$".
void see_said(std::string_view text, Evidence& evidence);

// --- spaces.cpp: "In two dimensions", "four-vectors", "curvilinear coordinates": the words speak of
// another space than that of three dimensions with its Cartesian axes.

/// Notes the first such words. `text`: prose with its formulas.
void see_spaces(std::string_view text, Evidence& evidence);

// --- unit_matrices.cpp: "the unit matrix $I$", "$E$ is the identity operator": a letter that is 1 among
// matrices or operators.

/// Adds the letters that the words call the unit matrix or the identity to `units`, and to what may not
/// commute with numbers in between. `text`: prose with its formulas.
void see_unit_matrices(std::string_view text, Evidence& evidence);

}  // namespace rigor
