// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "check/frame.h"
#include "check/identity_reading.h"

namespace rigor {

Session::Session(const SourceMap& sources, const Notes& notes, FileReport& report)
    : sources_(sources), notes_(notes), report_(report) {}

void Session::run(const std::function<void(std::size_t, std::size_t)>& progress) {
  sight_all();
  for (std::size_t k = 0; k < notes_.events.size(); ++k) {
    std::visit([this](const auto& event) { follow(event); }, notes_.events[k]);
    if (progress) progress(k + 1, notes_.events.size());
  }
  report_unused();
}

/// How symbols are written anywhere in the file decides what their letters mean everywhere.
void Session::sight_all() {
  std::vector<std::vector<SyntaxId>> statements;
  std::vector<std::string> latin_particles;
  for (const Event& event : notes_.events) {
    const auto take = [&](const std::vector<ParsedChain>& chains) {
      for (const ParsedChain& chain : chains) statements.push_back(chain.sides);
    };
    if (const auto* display = std::get_if<ParsedDisplay>(&event)) take(display->chains);
    if (const auto* placed = std::get_if<PlacedDirective>(&event)) {
      take(placed->directive.chains);
      if (placed->directive.kind == DirectiveKind::particles) {
        for (const SyntaxId symbol : placed->directive.symbols)
          latin_particles.push_back(notes_.syntax.symbol(symbol).letter);
      } else {
        for (const SyntaxId symbol : placed->directive.symbols) statements.push_back({symbol});
      }
    }
  }
  auto& summed = names_.sightings.summed_greek;
  for (const auto& sides : statements) {
    for (const SyntaxId side : sides) sight_sums(notes_.syntax, side, names_.sightings);
  }
  const std::set<std::string> greek_only = summed;
  summed.insert(latin_particles.begin(), latin_particles.end());
  for (const auto& sides : statements) {
    for (const SyntaxId side : sides) sight_faces(notes_.syntax, side, names_);
  }
  for (const auto& sides : statements) sight_indices(notes_.syntax, sides, names_);
  for (const auto& sides : statements) {
    for (const SyntaxId side : sides) sight_changes(notes_.syntax, side, names_);
    sight_diagonals(notes_.syntax, sides, names_.sightings);
  }
  summed = greek_only;
  imply_primed_axes();
}

/// Without a directive, one symbol with mixed indices (`\\lambda_{i'j}`) gives the primed axes.
void Session::imply_primed_axes() {
  const bool told = std::any_of(notes_.events.begin(), notes_.events.end(), [](const Event& event) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    return placed != nullptr && (placed->directive.kind == DirectiveKind::rotation ||
                                 placed->directive.kind == DirectiveKind::basis);
  });
  if (told || names_.sightings.mixed_axes.size() != 1) return;
  const std::string& letter = *names_.sightings.mixed_axes.begin();
  const SymbolId symbol = names_.resolve(tree_, {letter, 2, false}, letter, {});
  tree_.symbols[symbol].rotation = true;
  names_.set_primed_axes(symbol);
}

void Session::follow(const Heading& heading) {
  names_.open_section(heading.level);
  section_ = heading.title;
}

void Session::follow(const PlacedDirective& placed) {
  const Directive& directive = placed.directive;
  directives_.push_back(&directive);
  Context context{.role = Role::claim, .place = placed.place, .directive = directive.number};
  switch (directive.kind) {
    case DirectiveKind::expect:
      expectation_ = &directive;
      return;
    case DirectiveKind::skip:
      skip_ = &directive;
      return;
    case DirectiveKind::first_order:
      first_order_ = &directive;
      return;
    case DirectiveKind::where:
      wheres_.push_back(directive.number);
      context.role = Role::given;
      break;
    case DirectiveKind::claim:
      names_.mark_used(directive.number);
      break;
    case DirectiveKind::given:
      context.role = Role::given;
      break;
    case DirectiveKind::let:
      context.role = Role::let;
      break;
    default:
      declare(directive);
      return;
  }
  if (directive.kind == DirectiveKind::claim) context.first_order = take_first_order();
  for (const ParsedChain& parsed : directive.chains) chain(parsed, context);
  if (directive.kind == DirectiveKind::claim) forget_wheres();
}

void Session::follow(const ParsedDisplay& display) {
  const Directive* skip = std::exchange(skip_, nullptr);
  if (skip != nullptr) names_.mark_used(skip->number);
  const bool no_relation =
      std::none_of(display.chains.begin(), display.chains.end(),
                   [](const ParsedChain& parsed) { return !parsed.written.relations.empty(); });
  if (display.unread || display.chains.empty() || (skip != nullptr && no_relation)) {
    Step step;
    step.span = step.relation_span = display.span;
    step.section = section_;
    step.source = written(
        {display.span.file, display.span.begin, std::min(display.span.end, display.span.begin + 200)});
    step.verdict = skip != nullptr ? Verdict::skipped : Verdict::not_understood;
    step.diagnostics = display.diagnostics;
    if (skip != nullptr) step.route = skip->text;
    if (step.diagnostics.empty() && skip == nullptr) return;
    add(std::move(step));
    return;
  }
  report_.diagnostics.insert(report_.diagnostics.end(), display.diagnostics.begin(),
                             display.diagnostics.end());
  const std::size_t first_step = report_.steps.size();
  const Context context{.role = Role::display, .first_order = take_first_order()};
  for (const ParsedChain& parsed : display.chains) {
    if (skip == nullptr) {
      chain(parsed, context);
      continue;
    }
    for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) {
      Step skipped = new_step(parsed, k, {});
      skipped.verdict = Verdict::skipped;
      skipped.route = skip->text;
      add(std::move(skipped));
    }
  }
  if (skip == nullptr) heed_conditions(display, first_step);
  forget_wheres();
}

bool Session::take_first_order() {
  const Directive* directive = std::exchange(first_order_, nullptr);
  if (directive != nullptr) names_.mark_used(directive->number);
  return directive != nullptr;
}

void Session::forget_wheres() {
  for (const std::size_t directive : std::exchange(wheres_, {})) names_.forget(directive);
}

/// `(A×B)² = A²B², A·B = 0`: a law beside an equation on its line may be the condition under which it holds.
/// Then what was refuted without it is not understood.
void Session::heed_conditions(const ParsedDisplay& display, std::size_t first_step) {
  const auto chain_of = [&](const Step& step) -> const WrittenChain* {
    for (const ParsedChain& parsed : display.chains) {
      for (const WrittenRelation& relation : parsed.written.relations) {
        if (relation.span == step.relation_span) return &parsed.written;
      }
    }
    return nullptr;
  };
  for (std::size_t law = first_step; law < report_.steps.size(); ++law) {
    const Diagnostics& reasons = report_.steps[law].diagnostics;
    const bool is_law = std::any_of(reasons.begin(), reasons.end(), [](const Diagnostic& reason) {
      return reason.kind == DiagnosticKind::undeclared_symbol;
    });
    if (!is_law) continue;
    for (std::size_t k = first_step; k < report_.steps.size(); ++k) {
      Step& step = report_.steps[k];
      if (step.verdict != Verdict::refuted || step.expected_refuted) continue;
      const WrittenChain* condition = chain_of(report_.steps[law]);
      const WrittenChain* own = chain_of(step);
      const bool beside = condition != nullptr && own != nullptr && condition != own &&
                          condition->statement == own->statement;
      if (!beside) continue;
      --report_.counts[static_cast<std::size_t>(step.verdict)];
      step.verdict = Verdict::not_understood;
      ++report_.counts[static_cast<std::size_t>(step.verdict)];
      step.counterexample.reset();
      step.diagnostics = {{DiagnosticKind::unsupported,
                           step.relation_span,
                           "it does not hold for all values, and what stands beside it may be its condition",
                           {{report_.steps[law].relation_span, "this condition is not read"}}}};
    }
  }
}

void Session::declare(const Directive& directive) {
  for (const SyntaxId id : directive.symbols) {
    switch (directive.kind) {
      case DirectiveKind::particles:
        names_.declare_particles(notes_.syntax.symbol(id).letter, directive.number);
        break;
      case DirectiveKind::constant:
      case DirectiveKind::variable:
      case DirectiveKind::small:
      case DirectiveKind::frame:
        declare_elaborated(directive, id);
        break;
      case DirectiveKind::basis:
        declare_basis(directive, id);
        break;
      default:
        declare_symbol(directive, id);
    }
  }
}

/// A symbol, or a component, as it is read in an equation.
void Session::declare_elaborated(const Directive& directive, SyntaxId id) {
  Diagnostics own;
  Elaborator elaborator(notes_.syntax, tree_, names_, read_letters(notes_.syntax, {id}, names_), own);
  std::optional<Typed> typed = elaborator.expression(id);
  if (typed && tree_[typed->id].op == Op::length) {
    typed->id = tree_.children(typed->id)[0];  // a plain letter of a vector is its length
    typed->rank = tree_[typed->id].rank;
  }
  if (typed && directive.kind == DirectiveKind::frame && typed->rank != 1) {
    own.push_back({DiagnosticKind::bad_directive, notes_.syntax[id].span, "an angular velocity is a vector"});
    typed.reset();
  }
  if (typed && directive.kind == DirectiveKind::frame && !names_.frames().empty()) {
    own.push_back({DiagnosticKind::unsupported,
                   directive.span,
                   fmt::format("the frame `{}` is in force here, and components are along its axes",
                               names_.frames().back().rotating),
                   {},
                   {"a new section ends it"}});
    typed.reset();
  }
  if (!typed || tree_[typed->id].op != Op::symbol) {
    report_.diagnostics.insert(report_.diagnostics.end(), own.begin(), own.end());
    if (own.empty())
      report_.diagnostics.push_back(
          {DiagnosticKind::bad_directive, notes_.syntax[id].span, "this is not a symbol"});
    return;
  }
  if (directive.kind == DirectiveKind::frame) {
    declare_frame(tree_, names_, directive.rotating, directive.fixed, typed->id, directive.number);
  } else if (directive.kind == DirectiveKind::constant) {
    declare_constant(directive, *typed);
  } else if (directive.kind == DirectiveKind::variable) {
    constants_.emplace_back(directive.number, tree_[typed->id].symbol);
    names_.declare_variable(tree_[typed->id].symbol);
  } else {
    SmallQuantity small{.quantity = typed->id, .directive = directive.number};
    if (!typed->free.empty()) small.quantity = whole_symbol(*typed);
    for (const FreeParticle& particle : typed->particles) small.particles.push_back(particle.id);
    names_.declare_small(std::move(small));
  }
}

/// `I_i` names the whole I.
ExprId Session::whole_symbol(const Typed& typed) {
  ExprNode node = tree_[typed.id];
  node.rank = static_cast<std::uint8_t>(tree_.symbols[node.symbol].rank);
  return tree_.add(node);
}

/// A symbol is constant as a whole; of a single component the rate is 0.
void Session::declare_constant(const Directive& directive, const Typed& typed) {
  const auto slots = tree_.slots(typed.id);
  const bool component =
      std::any_of(slots.begin(), slots.end(), [](const Slot& slot) { return slot.axis != 0; });
  const SymbolId symbol = tree_[typed.id].symbol;
  constants_.emplace_back(directive.number, symbol);
  if (!component) {
    names_.declare_constant(symbol, directive.number);
    return;
  }
  Equation equation;
  const std::vector<Slot> at(slots.begin(), slots.end());
  equation.left = tree_.add({.op = Op::symbol,
                             .span = tree_[typed.id].span,
                             .symbol = tree_.symbols.derivative(symbol, By::time),
                             .particle = tree_[typed.id].particle},
                            {}, at);
  equation.right = tree_.add_number(tree_[typed.id].span, "0");
  for (const FreeParticle& particle : typed.particles) equation.particles.push_back(particle.id);
  names_.assume({equation, {directive.text, section_, directive.number}, 0});
}

/// `basis \\mathbf{e}_{i'}`: primed axes of any direction.
void Session::declare_basis(const Directive& directive, SyntaxId id) {
  const WrittenSymbol& symbol = notes_.syntax.symbol(id);
  if (symbol.lower.size() != 1 || symbol.lower[0].primes == 0) {
    report_.diagnostics.push_back({DiagnosticKind::bad_directive,
                                   notes_.syntax[id].span,
                                   "a basis has a primed index",
                                   {},
                                   {"e.g. `basis \\mathbf{e}_{i'}`"}});
    return;
  }
  Symbol rotation;
  rotation.name = "\\mathbf{e}'";
  rotation.rotation = true;
  names_.set_primed_axes(
      names_.declare(tree_, {"\\mathbf{e}'", 2, false}, std::move(rotation), directive.number));
  names_.mark_used(directive.number);
}

/// The primed axes are those of the rotation that is written with one primed index, or of the first.
void Session::declare_rotation(const Directive& directive, const NameKey& key, SymbolId symbol) {
  const auto& mixed = names_.sightings.mixed_axes;
  if (!mixed.contains(key.base) && (!mixed.empty() || names_.primed_axes())) return;
  names_.set_primed_axes(symbol);
  if (mixed.contains(key.base)) names_.mark_used(directive.number);
}

void Session::declare_symbol(const Directive& directive, SyntaxId id) {
  const WrittenSymbol& symbol = notes_.syntax.symbol(id);
  const WrittenName name = take_apart(symbol, Letters{}, names_);
  const bool digits = std::all_of(name.axes.begin(), name.axes.end(),
                                  [](const WrittenIndex& axis) { return axis.form == IndexForm::digit; });
  NameKey key{digits ? with_labels(name.base, name.axes) : name.base, 0, name.per_particle()};
  const int axes = digits ? 0 : static_cast<int>(name.axes.size());
  switch (directive.kind) {
    case DirectiveKind::vector:
      key.rank = 1;
      break;
    case DirectiveKind::tensor:
      key.rank = axes > 0 ? axes : 2;
      break;
    case DirectiveKind::rotation:
      key.rank = 2;
      break;
    default:
      break;
  }
  Symbol declared;
  declared.name = name.axes.empty() && name.particles.empty() ? written(notes_.syntax[id].span) : key.base;
  if (key.rank == 1 && !name.particles.empty()) declared.name = fmt::format("\\mathbf{{{}}}", key.base);
  declared.symmetric = directive.symmetric && key.rank == 2;
  declared.rotation = directive.kind == DirectiveKind::rotation;
  declared.unit = key.rank == 1 && (directive.unit || symbol.accent == Accent::hat);
  declared.first_seen = notes_.syntax[id].span;
  const SymbolId declared_symbol = names_.declare(tree_, key, std::move(declared), directive.number);
  if (directive.kind == DirectiveKind::rotation) declare_rotation(directive, key, declared_symbol);
  const bool whole = symbol.face == Face::plain && symbol.accent == Accent::none && axes == 0;
  if (whole && key.rank > 0) names_.declare_plain(key);
}

void Session::report_unused() {
  for (const auto& [directive, symbol] : constants_) {
    if (names_.seen_in_equation(symbol)) names_.mark_used(directive);
  }
  for (const Directive* directive : directives_) {
    const bool pending = directive == expectation_ || directive == skip_ || directive == first_order_;
    const bool standing = directive->kind != DirectiveKind::expect &&
                          directive->kind != DirectiveKind::skip &&
                          directive->kind != DirectiveKind::first_order;
    if (standing ? names_.is_used(directive->number) : !pending) continue;
    report_.diagnostics.push_back({DiagnosticKind::unused_directive,
                                   directive->span,
                                   fmt::format("nothing uses `{}`", directive->text),
                                   {},
                                   {"take the line away, or move it before what it is for"}});
  }
}

void Session::chain(const ParsedChain& parsed, const Context& context) {
  const Directive* expectation = context.role == Role::display || context.role == Role::claim
                                     ? std::exchange(expectation_, nullptr)
                                     : nullptr;
  const std::size_t first_step = report_.steps.size();
  if (parsed.written.relations.empty() && !reads(parsed)) return;
  if (parsed.written.relations.empty()) {
    report_.diagnostics.push_back({DiagnosticKind::no_relation, parsed.written.span,
                                   "no relation stands here, so there is nothing to decide"});
    return;
  }
  const std::unique_ptr<Attempt> attempt = read(parsed);
  for (const std::string& letter : attempt->reading.unsummed) {
    attempt->sides[0].diagnostics.push_back(
        {DiagnosticKind::unsummed_index,
         parsed.written.span,
         fmt::format(
             "index `{}` stands twice in a term and is read as not summed, since it is free elsewhere",
             letter),
         {},
         {"say `(\\text{no sum})` beside the equation"}});
  }
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k) step(parsed, k, *attempt, context);
  const std::vector<Side>& sides = attempt->sides;
  mark_seen(sides);
  if (expectation == nullptr) return;
  bool any = false;
  for (std::size_t k = first_step; k < report_.steps.size(); ++k) {
    report_.steps[k].expected_refuted = report_.steps[k].verdict == Verdict::refuted;
    any = any || report_.steps[k].expected_refuted;
  }
  if (any) return;
  report_.diagnostics.push_back({DiagnosticKind::unexpected_verdict,
                                 expectation->span,
                                 "the next statement was expected to be refuted and is not",
                                 {{parsed.written.span, "this statement"}}});
}

Session::Attempt::Attempt(Session& session, const ParsedChain& parsed, const Reading& how)
    : reading(how),
      elaborator(session.notes_.syntax, session.tree_, session.names_, session.letters_of(parsed), own, how) {
  for (const SyntaxId id : parsed.sides) {
    Side side;
    side.typed = elaborator.expression(id);
    side.diagnostics = std::exchange(own, {});
    if (sides.empty() && side.typed) elaborator.expect_slots(side.typed->free);
    sides.push_back(std::move(side));
  }
}

/// The plain reading, unless the indices of the sides only fit in another one: a letter that is free on one
/// side is not summed on another, or a prime does not make another letter of it.
std::unique_ptr<Session::Attempt> Session::read(const ParsedChain& parsed) {
  const Reading plain{.no_sum = parsed.written.no_sum};
  auto first = std::make_unique<Attempt>(*this, parsed, plain);
  if (parsed.sides.size() < 2 || is_balanced(first->sides)) return first;
  Reading unsummed = plain;
  const bool all_read = std::all_of(first->sides.begin(), first->sides.end(),
                                    [](const Side& side) { return side.typed.has_value(); });
  for (const Side& side : first->sides) {
    if (!all_read) break;
    for (const FreeIndex& free : side.typed->free) {
      if (first->elaborator.summed_letters().contains(free.letter)) unsummed.unsummed.insert(free.letter);
    }
  }
  Reading primes = plain;
  primes.primes_on_axes = true;
  for (const Reading& other : {unsummed, primes}) {
    const bool differs = !other.unsummed.empty() || other.primes_on_axes;
    if (!differs) continue;
    auto attempt = std::make_unique<Attempt>(*this, parsed, other);
    if (is_balanced(attempt->sides)) return attempt;
  }
  return first;
}

/// All sides are read, and have the same free letters (a number has none and fits all).
bool Session::is_balanced(const std::vector<Side>& sides) const {
  std::optional<std::set<std::string>> first;
  for (const Side& side : sides) {
    if (!side.typed) return false;
    std::set<std::string> own;
    for (const FreeIndex& free : side.typed->free) own.insert(free.letter);
    if (is_literal_zero(tree_, *side.typed)) continue;
    if (first && *first != own) return false;
    first = own;
  }
  return true;
}

/// An expression without a relation is passed over with a warning, unless it cannot even be read: then it is
/// a step not understood.
bool Session::reads(const ParsedChain& parsed) {
  Step step;
  step.span = step.relation_span = parsed.written.span;
  step.tag = parsed.written.tag;
  step.label = parsed.written.label;
  step.section = section_;
  step.source = written(parsed.written.span);
  std::vector<SyntaxId> pending = parsed.sides;
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    for (const SyntaxChild& child : notes_.syntax.children(id)) pending.push_back(child.id);
    if (notes_.syntax[id].kind != SyntaxKind::opaque) continue;
    const Obstacle& obstacle = notes_.syntax.obstacle(id);
    step.diagnostics.push_back({obstacle.kind, notes_.syntax[id].span, obstacle.message, {}, obstacle.help});
  }
  if (step.diagnostics.empty()) return true;
  add(std::move(step));
  return false;
}

void Session::mark_seen(const std::vector<Side>& sides) {
  for (const Side& side : sides) {
    if (!side.typed) continue;
    for (const SymbolId symbol : symbols_in(tree_, side.typed->id)) names_.mark_seen(symbol);
  }
}

Step Session::new_step(const ParsedChain& parsed, std::size_t which, const Context& context) const {
  const WrittenChain& chain = parsed.written;
  Step step;
  step.relation_span = chain.relations[which].span;
  step.span = cover(cover(chain.sides[which].span, step.relation_span), chain.sides[which + 1].span);
  step.tag = chain.tag;
  step.label = chain.label;
  step.section = section_;
  step.left = written(chain.sides[which].span);
  step.relation = chain.relations[which].text;
  step.right = written(chain.sides[which + 1].span);
  step.source = fmt::format("{} {} {}", step.left, step.relation, step.right);
  if (context.place) step.span = *context.place;
  if (parsed.image > 0) step.source += fmt::format(" (cyclic image {})", parsed.image);
  return step;
}

void Session::add(Step step) {
  const auto same = [](const Diagnostic& a, const Diagnostic& b) {
    return a.kind == b.kind && a.span == b.span && a.message == b.message;
  };
  Diagnostics once;
  for (Diagnostic& diagnostic : step.diagnostics) {
    const bool known =
        std::any_of(once.begin(), once.end(), [&](const Diagnostic& old) { return same(old, diagnostic); });
    if (!known) once.push_back(std::move(diagnostic));
  }
  step.diagnostics = std::move(once);
  ++report_.counts[static_cast<std::size_t>(step.verdict)];
  report_.steps.push_back(std::move(step));
}

std::string Session::written(Span span) const {
  std::string text;
  for (const char c : sources_.text(span)) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      text += c;
    } else if (!text.empty() && text.back() != ' ') {
      text += ' ';
    }
  }
  return text;
}

std::string Session::place_name(const ParsedChain& parsed) const {
  if (!parsed.written.tag.empty()) return parsed.written.tag;
  return fmt::format("in line {}",
                     sources_.line_column(parsed.written.span.file, parsed.written.span.begin).line);
}

}  // namespace rigor
