// SPDX-License-Identifier: GPL-3.0-or-later
// A decorated letter: which symbol it is, and whether it is meant whole, as a component, or as a length.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/elaborator.h"
#include "source/suggest.h"

namespace rigor {
namespace {

std::string bold(const std::string& base) {
  const auto tail = base.find_first_of("_'");
  const std::string letter = base.substr(0, tail);
  const std::string rest = tail == std::string::npos ? "" : base.substr(tail);
  if (letter.starts_with("\\hat")) return base;
  return fmt::format("\\{}{{{}}}{}", letter.starts_with("\\") ? "boldsymbol" : "mathbf", letter, rest);
}

bool all_of_form(const std::vector<WrittenIndex>& axes, IndexForm form) {
  return std::all_of(axes.begin(), axes.end(), [&](const WrittenIndex& axis) { return axis.form == form; });
}

bool is_axis_letter(const WrittenIndex& axis) {
  return axis.form == IndexForm::letter && axis_of_letter(axis.text) != 0;
}

/// Index variables only: no digits, no x, y, z.
bool all_variables(const std::vector<WrittenIndex>& axes) {
  return std::all_of(axes.begin(), axes.end(), [](const WrittenIndex& axis) {
    return axis.form == IndexForm::letter && axis_of_letter(axis.text) == 0;
  });
}

std::uint8_t hatted_axis(const WrittenSymbol& written, const Sightings& sightings) {
  if (written.accent != Accent::hat || !written.lower.empty() || written.primes > 0) return 0;
  if (const std::uint8_t axis = axis_of_letter(written.letter)) return axis;
  if (!sightings.hatted_ij) return 0;
  if (written.letter == "i" || written.letter == "\\imath") return 1;
  if (written.letter == "j" || written.letter == "\\jmath") return 2;
  return written.letter == "k" ? 3 : 0;
}

}  // namespace

std::optional<Typed> Elaborator::symbol(const WrittenSymbol& written, Span span) {
  if (written.letter == hole_letter) return hole(written, span);
  if (written.dots > 0) return rate(written, span);
  if (written.letter == "\\nabla") return unsupported(span, "`\\nabla` has nothing to act on here");
  bool handled = false;
  Maybe special = special_symbol(written, span, handled);
  if (handled) return special;
  WrittenName name = take_apart(written, letters_, names_);
  if (hides_small_factor(written, name)) {
    return fail(
        DiagnosticKind::ambiguous_reading, span,
        fmt::format("`{}` is one symbol, a change, and `{}` is small by itself", name.base, written.change),
        {fmt::format("for the product write `{}` behind the other factors", written.change)});
  }
  const auto greek_label = [](const WrittenIndex& index) { return index.form == IndexForm::greek; };
  if (std::count_if(written.lower.begin(), written.lower.end(), greek_label) > 1) {
    return unsupported(span, "two Greek subscripts, as of space-time, are not decided");
  }
  const bool capital = written.letter.size() == 1 && written.letter[0] >= 'A' && written.letter[0] <= 'Z';
  if (written.accent == Accent::hat && written.face == Face::plain && capital &&
      !names_.is_declared({name.base, 1, false})) {
    return fail(DiagnosticKind::ambiguous_reading, span,
                fmt::format("`{}` can be a unit vector or an operator", name.base),
                {fmt::format("`rigor: vector {}` or a bold letter says that it is a vector; with operators "
                             "nothing is decided",
                             name.base)});
  }
  if (name.particles.size() > 1) return unsupported(span, "a quantity of two particles is not decided yet");
  if (written.face != Face::plain || written.accent == Accent::hat)
    return vector_symbol(written, std::move(name), span);
  return plain_symbol(written, std::move(name), span);
}

/// δ, ε, basis vectors, and letters that stand for a change rather than a quantity.
std::optional<Typed> Elaborator::special_symbol(const WrittenSymbol& written, Span span, bool& handled) {
  handled = true;
  if (is_kronecker(written) || is_levi_civita(written)) return unit_tensor(written, span);
  const bool e_declared = names_.is_declared({"e", 1, false}) || names_.is_declared({"\\hat{e}", 1, false});
  if (is_basis_family(written) && !e_declared) {
    std::vector<Slot> slots;
    Typed typed;
    if (any_primed(written.lower)) return primed_basis_vector(written.lower[0], span);
    if (read_slots(written.lower, slots, typed.free))
      return basis_vector(span, slots[0], std::move(typed.free));
  }
  const NameKey hatted{"\\hat{" + written.letter + "}", 1, false};
  if (const std::uint8_t axis = hatted_axis(written, names_.sightings);
      axis != 0 && !names_.is_declared(hatted)) {
    return basis_vector(span, Slot{axis, {}}, {});
  }
  if (written.letter.starts_with("\\mathbb") && !is_declared_letter(written)) {
    return unsupported(
        span,
        fmt::format("`{}` can be an average, a probability, a set or a unit, which are not decided with",
                    written.letter),
        {fmt::format("`rigor: scalar {}` makes it a quantity", written.letter)});
  }
  if (written.lower.empty() && written.face == Face::plain && written.accent == Accent::none &&
      written.change.empty() && !names_.is_declared({written.letter, 0, false})) {
    if (written.letter == "\\delta" || written.letter == "\\Delta" || written.letter == "\\mathrm{d}") {
      return unsupported(span,
                         fmt::format("`{}` without indices reads as a small change, which is not decided yet",
                                     written.letter));
    }
    if ((written.letter == "i" || written.letter == "j") && written.primes == 0) {
      return unsupported(
          span, fmt::format("`{}` without a subscript can be the imaginary unit, which is not decided with",
                            written.letter));
    }
    if (written.letter == "\\pi")
      guess_ = Obstacle{DiagnosticKind::unsupported, "`\\pi` was taken as any number", {}};
  }
  handled = false;
  return std::nullopt;
}

/// δ or ε. Between primed and unprimed axes, δ is the direction cosine.
std::optional<Typed> Elaborator::unit_tensor(const WrittenSymbol& written, Span span) {
  const auto primed = static_cast<std::size_t>(std::count_if(
      written.lower.begin(), written.lower.end(), [](const auto& axis) { return axis.primes > 0; }));
  std::vector<Slot> slots;
  Typed typed;
  if (!read_slots(written.lower, slots, typed.free))
    return unsupported(span, "this subscript is not one of index letters or axes");
  if (primed == 0 || primed == written.lower.size()) {
    typed.id = tree_.add({.op = is_kronecker(written) ? Op::delta : Op::epsilon, .span = span}, {}, slots);
    return contract(std::move(typed));
  }
  const auto rotation = primed_axes(span);
  if (!rotation) return std::nullopt;
  if (!is_kronecker(written))
    return unsupported(span, "an ε between primed and unprimed axes is not decided");
  if (written.lower[1].primes > 0) std::swap(slots[0], slots[1]);
  typed.id = tree_.add({.op = Op::symbol, .span = span, .symbol = *rotation}, {}, slots);
  return contract(std::move(typed));
}

std::optional<Typed> Elaborator::basis_vector(Span span, Slot slot, std::vector<FreeIndex> free) {
  note("`\\hat{x}`, `\\mathbf{e}_i` and their like are the right-handed orthonormal basis");
  Typed typed;
  typed.rank = 1;
  typed.free = std::move(free);
  typed.id = tree_.add({.op = Op::basis, .rank = 1, .span = span}, {}, std::span(&slot, 1));
  return typed;
}

std::optional<Typed> Elaborator::vector_symbol(const WrittenSymbol& written, WrittenName name, Span span) {
  const bool tensor = written.face == Face::tensor;
  const bool particle = name.per_particle();
  if (name.axes.empty()) {
    const bool declared_vector = names_.is_declared({name.base, 1, particle});
    const bool declared_tensor = names_.is_declared({name.base, 2, particle});
    if (!tensor && !declared_vector && !declared_tensor &&
        names_.sightings.indexed.contains({name.base, 2, particle}) &&
        !names_.sightings.crossed.contains(name.base) &&
        !names_.sightings.indexed.contains({name.base, 1, particle})) {
      return fail(DiagnosticKind::ambiguous_reading, span,
                  fmt::format("`{}` can be a vector, or the tensor with components `{}_{{ij}}`",
                              bold(name.base), name.base),
                  {fmt::format("`rigor: tensor {}` or `rigor: vector {}` settles it", bold(name.base),
                               bold(name.base))});
    }
    return make_symbol(written, name.base, tensor || (declared_tensor && !declared_vector) ? 2 : 1, name, {},
                       span);
  }
  if (tensor)
    return make_symbol(written, name.base, static_cast<int>(name.axes.size()), name, name.axes, span);
  if (all_of_form(name.axes, IndexForm::digit)) {
    return make_symbol(written, with_labels(name.base, name.axes), 1, name, {}, span);
  }
  const bool hatted = written.accent == Accent::hat && written.face == Face::plain;
  const bool whole_vector_known =
      names_.is_declared({name.base, 1, particle}) || names_.sightings.bold.contains({name.base, particle});
  const int rank = static_cast<int>(name.axes.size());
  const bool tensor_component = rank > 1 && names_.is_declared({name.base, rank, particle});
  if (tensor_component ||
      (rank == 1 && (whole_vector_known || hatted) && !is_bound_letter(name.axes[0].text))) {
    if (!hatted) warn_of_bold_index(name, bold(name.base), span);
    return make_symbol(written, name.base, rank, name, name.axes, span);
  }
  return fail(DiagnosticKind::ambiguous_reading, span,
              fmt::format("the index on `{}` can name a particle, a component or a label", bold(name.base)),
              {fmt::format("`rigor: particles {}` makes it a particle; a component is written `{}_{}`",
                           name.axes[0].text, name.base, name.axes[0].text)});
}

std::optional<Typed> Elaborator::plain_symbol(const WrittenSymbol& written, WrittenName name, Span span) {
  if (name.axes.empty()) return length_or_scalar(written, name, span);
  const bool particle = name.per_particle();
  if (name.axes.size() == 2 && name.axes[0].form == IndexForm::digit &&
      name.axes[1].form == IndexForm::letter &&
      names_.sightings.bold.contains(
          {with_labels(name.base, {name.axes[0]}), particle})) {  // p_{1x} of \mathbf{p}_1
    name.base = with_labels(name.base, {name.axes[0]});
    name.axes.erase(name.axes.begin());
  }
  const int rank = static_cast<int>(name.axes.size());
  if (all_variables(name.axes)) return make_symbol(written, name.base, rank, name, name.axes, span);
  const bool known = is_known(name.base, rank, particle);
  const std::string labelled = with_labels(name.base, name.axes);
  const bool labelled_known =
      names_.sightings.bold.contains({labelled, particle}) || names_.is_declared({labelled, 0, particle});
  if (known && labelled_known && rank == 1 && !names_.is_declared({labelled, 0, particle})) {
    return fail(DiagnosticKind::ambiguous_reading, span,
                fmt::format("`{}` can be a component of `{}` or the length of `{}`", labelled,
                            bold(name.base), bold(labelled)),
                {fmt::format("write `|{}|` for the length", bold(labelled))});
  }
  const bool mixed = !all_of_form(name.axes, IndexForm::digit) &&
                     !std::all_of(name.axes.begin(), name.axes.end(), is_axis_letter);
  if (known && !labelled_known && rank == 1) guess_vector(name, false);
  if ((known && !labelled_known) || mixed)
    return make_symbol(written, name.base, rank, name, name.axes, span);
  name.base = labelled;
  name.axes.clear();
  return length_or_scalar(written, name, span);
}

std::optional<Typed> Elaborator::length_or_scalar(const WrittenSymbol& written, const WrittenName& name,
                                                  Span span) {
  const bool particle = name.per_particle();
  const NameKey scalar{name.base, 0, particle};
  const bool defined = names_.find(scalar) && names_.definition_of(*names_.find(scalar)) != nullptr;
  for (const int rank : {1, 2}) {
    if (names_.is_plain({name.base, rank, particle}))
      return make_symbol(written, name.base, rank, name, {}, span);
  }
  const bool component = names_.evidence.components.contains(name.base);
  if (!names_.is_declared(scalar) && !defined && !component) {
    // A letter that is bold in another section only is another one here, where it stands at all.
    const Evidence& here = names_.evidence;
    const bool bold_here = name.base == "r" || !here.letters.contains(written.letter) ||
                           here.vectors.contains(letter_with_marks(written));
    const bool bold_seen = (bold_here && names_.sightings.bold.contains({name.base, particle})) ||
                           names_.is_declared({name.base, 1, particle});
    const bool by_company = !bold_seen && written.lower.size() == name.particles.size() &&
                            letters_.indexed_vectors.contains(name.base);
    if (bold_seen || by_company) {
      Maybe vector = make_symbol(written, name.base, 1, name, {}, span);
      if (!vector) return vector;
      note(fmt::format("`{}` is the length of `{}`", name.base, bold(name.base)));
      if (bold_seen) guess_vector(name, true);
      if (by_company) {
        guess_ = Obstacle{
            DiagnosticKind::ambiguous_reading,
            fmt::format("`{}` can be the length of the vector with components `{}_i`, or a symbol of its own",
                        name.base, name.base),
            {fmt::format("`rigor: vector {}` or `rigor: scalar {}` settles it", bold(name.base), name.base)}};
      }
      Typed length = make(Op::length, span, 0, {&*vector});
      return length;
    }
  }
  return make_symbol(written, name.base, 0, name, {}, span);
}

std::optional<Typed> Elaborator::make_symbol(const WrittenSymbol& written, const std::string& base, int rank,
                                             const WrittenName& name, const std::vector<WrittenIndex>& axes,
                                             Span span) {
  bool known = true;
  const bool in_body = !name.per_particle() && body_point_ && is_varying_in_body(name, rank, span, known);
  if (!known) return std::nullopt;
  const NameKey key{base, rank, name.per_particle() || in_body};
  const bool fresh = !names_.find(key).has_value();
  const bool vector_position = rank == 1 && (base == "r" || base == "x");
  const bool coordinate = rank == 0 && axis_of_letter(base) != 0;
  const bool vector_face =
      rank == 1 && (written.face == Face::vector || names_.sightings.bold.contains({base, key.per_particle}));
  const SymbolId symbol = names_.resolve(tree_, key, vector_face ? bold(base) : base, span);
  if (fresh && written.accent == Accent::hat && rank == 1) tree_.symbols[symbol].unit = true;
  const bool position = (vector_position || coordinate) && !key.per_particle;
  if (position && names_.dependence(tree_, symbol, By::space).kind == Dependence::Kind::variable)
    positions_.insert(position_name(symbol));
  Typed typed;
  std::vector<Slot> slots;
  if (!read_slots(axes, slots, typed.free))
    return unsupported(span, "this subscript is not one of index letters or axes");
  ExprNode node{.op = Op::symbol,
                .rank = static_cast<std::uint8_t>(axes.empty() ? rank : 0),
                .span = span,
                .symbol = symbol};
  if (in_body) {
    node.particle = *body_point_;
  } else if (key.per_particle) {
    node.particle = particle(name.particles[0].text);
    if (!bound_particles_.contains(name.particles[0].text)) {
      typed.particles.push_back({name.particles[0].text, node.particle, name.particles[0].span});
    }
  }
  if (rank > 4) return unsupported(span, "tensors of rank above 4 are not decided");
  typed.rank = node.rank;
  if (tree_.symbols[symbol].rotation && names_.primed_axes() == symbol && axes.size() == 2)
    return direction_cosine(node, axes, std::move(typed), span);
  if (any_primed(axes)) {
    node.rank = static_cast<std::uint8_t>(rank);
    typed.free.clear();
    typed.id = tree_.add(node);
    typed.rank = rank;
    return along_axes(std::move(typed), axes, span);
  }
  const bool principal = rank == 1 && axes.size() == 1 && names_.sightings.diagonal.contains(base);
  for (FreeIndex& free : typed.free) free.rides = principal;
  typed.id = tree_.add(node, {}, slots);
  return contract(std::move(typed));
}

/// Index letters with their primes are letters of their own, unless a prime only names the axes.
std::string Elaborator::letter_key(const WrittenIndex& axis) const {
  return reading_.primes_on_axes ? axis.text : axis.text + std::string(axis.primes, '\'');
}

/// In an integral over the body: does a quantity belong to the point, as `\mathbf r` and the density do?
bool Elaborator::is_varying_in_body(const WrittenName& name, int rank, Span span, bool& known) {
  static const std::set<std::string> of_a_point{"r", "x", "y", "z", "\\rho"};
  const auto is_defined = [&](bool per_particle) {
    const auto symbol = names_.find({name.base, rank, per_particle});
    return symbol && names_.definition_of(*symbol) != nullptr;
  };
  const bool one = names_.is_declared({name.base, rank, false}) || is_defined(false);
  const bool each = names_.sightings.bold.contains({name.base, true}) ||
                    names_.sightings.indexed.contains({name.base, rank, true}) ||
                    names_.is_declared({name.base, rank, true}) || is_defined(true);
  const bool of_point = of_a_point.contains(name.base);
  if (one && !of_point) return false;
  if (!one && (each || of_point)) return true;
  if (one) {
    fail(
        DiagnosticKind::ambiguous_reading, span,
        fmt::format("`{0}` is declared as one quantity, and inside an integral over a body it belongs to the "
                    "point",
                    name.base),
        {"give one of them another name, or drop the declaration"});
    known = false;
    return false;
  }
  fail(DiagnosticKind::ambiguous_reading, span,
       fmt::format("`{}` can be one number for the body, or differ from point to point", name.base),
       {fmt::format("`rigor: scalar {0}` or `rigor: vector {0}` makes it one for the body", name.base)});
  known = false;
  return false;
}

bool Elaborator::read_slots(const std::vector<WrittenIndex>& axes, std::vector<Slot>& slots,
                            std::vector<FreeIndex>& free) {
  for (const WrittenIndex& axis : axes) {
    if (axis.form == IndexForm::digit) {
      if (axis.text < "1" || axis.text > "3") return false;
      slots.push_back({static_cast<std::uint8_t>(axis.text[0] - '0'), {}});
      continue;
    }
    if (axis.form != IndexForm::letter) return false;
    if (axis_of_letter(axis.text) != 0) {
      slots.push_back({axis_of_letter(axis.text), {}});
      continue;
    }
    const std::string key = letter_key(axis);
    if (const auto fixed = fixed_axes_.find(key); fixed != fixed_axes_.end()) {
      slots.push_back({fixed->second, {}});
      continue;
    }
    const IndexId id = index(key);
    slots.push_back({0, id});
    if (!is_bound_letter(key)) free.push_back({key, id, axis.span});
  }
  return true;
}

/// Bold somewhere else in the notes makes a letter a vector, yet nothing in the statement says so: `R_1` may
/// be a resistance. A length is settled by the vector's use in this section.
void Elaborator::guess_vector(const WrittenName& name, bool as_length) {
  const NameKey key{name.base, 1, name.per_particle()};
  const auto symbol = names_.find(key);
  const bool settled =
      name.per_particle() || names_.is_declared(key) || letters_.bold_vectors.contains(name.base) ||
      letters_.indexed_vectors.contains(name.base) || (symbol && names_.definition_of(*symbol) != nullptr) ||
      (symbol && as_length && names_.seen_in_equation(*symbol));
  if (settled) return;
  guess_ = Obstacle{DiagnosticKind::ambiguous_reading,
                    fmt::format("`{}` can belong to the vector `{}`, or be a symbol of its own", name.base,
                                bold(name.base)),
                    {fmt::format("`rigor: vector {}` or `rigor: scalar …` settles it", bold(name.base))}};
}

bool Elaborator::is_known(const std::string& base, int rank, bool per_particle) const {
  if (names_.is_declared({base, rank, per_particle})) return true;
  if (rank == 1 && names_.sightings.bold.contains({base, per_particle})) return true;
  return names_.sightings.indexed.contains({base, rank, per_particle});
}

std::optional<Typed> Elaborator::contract(Typed typed) {
  std::vector<Typed> factors{std::move(typed)};
  std::vector<FreeIndex> to_sum;
  std::vector<FreeIndex> free;
  std::vector<FreeIndex> bound;
  if (!sum_repeated(factors, to_sum, free, bound)) return std::nullopt;
  factors[0].free = std::move(free);
  return sum_over(std::move(factors[0]), to_sum);
}

IndexId Elaborator::index(const std::string& letter) {
  const auto bound = bound_indices_.find(letter);
  if (bound != bound_indices_.end()) return bound->second.back();
  const auto found = free_indices_.find(letter);
  if (found != free_indices_.end()) return found->second;
  return free_indices_[letter] = tree_.add_index(letter);
}

ParticleId Elaborator::particle(const std::string& letter) {
  const auto bound = bound_particles_.find(letter);
  if (bound != bound_particles_.end()) return bound->second.back();
  const auto found = free_particles_.find(letter);
  if (found != free_particles_.end()) return found->second;
  return free_particles_[letter] = tree_.add_particle(letter);
}

}  // namespace rigor
