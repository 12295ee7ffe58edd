// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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
  summed = greek_only;
}

void Session::follow(const Heading& heading) {
  names_.open_section(heading.level);
  section_ = heading.title;
}

void Session::follow(const PlacedDirective& placed) {
  const Directive& directive = placed.directive;
  directives_.push_back(&directive);
  Context context{Role::claim, placed.place, directive.number};
  switch (directive.kind) {
    case DirectiveKind::expect:
      expectation_ = &directive;
      return;
    case DirectiveKind::skip:
      skip_ = &directive;
      return;
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
  for (const ParsedChain& parsed : directive.chains) chain(parsed, context);
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
  for (const ParsedChain& parsed : display.chains) {
    if (skip == nullptr) {
      chain(parsed, {});
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
    if (directive.kind == DirectiveKind::particles) {
      names_.declare_particles(notes_.syntax.symbol(id).letter, directive.number);
    } else {
      declare_symbol(directive, id);
    }
  }
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
    case DirectiveKind::constant:
      key.rank = symbol.face == Face::vector || symbol.accent == Accent::hat ? 1 : axes;
      break;
    default:
      break;
  }
  if (directive.kind == DirectiveKind::constant) {
    constants_.emplace_back(
        directive.number,
        names_.resolve(tree_, key, std::string(written(notes_.syntax[id].span)), notes_.syntax[id].span));
    return;
  }
  Symbol declared;
  declared.name = name.axes.empty() && name.particles.empty() ? written(notes_.syntax[id].span) : key.base;
  if (key.rank == 1 && !name.particles.empty()) declared.name = fmt::format("\\mathbf{{{}}}", key.base);
  declared.symmetric = directive.symmetric && key.rank == 2;
  declared.unit = key.rank == 1 && (directive.unit || symbol.accent == Accent::hat);
  declared.first_seen = notes_.syntax[id].span;
  names_.declare(tree_, key, std::move(declared), directive.number);
  const bool whole = symbol.face == Face::plain && symbol.accent == Accent::none && axes == 0;
  if (whole && key.rank > 0) names_.declare_plain(key);
}

void Session::report_unused() {
  for (const auto& [directive, symbol] : constants_) {
    if (names_.seen_in_equation(symbol)) names_.mark_used(directive);
  }
  for (const Directive* directive : directives_) {
    const bool pending = directive == expectation_ || directive == skip_;
    const bool standing = directive->kind != DirectiveKind::expect && directive->kind != DirectiveKind::skip;
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
  Diagnostics own;
  Elaborator elaborator(notes_.syntax, tree_, names_, read_letters(notes_.syntax, parsed.sides, names_), own);
  std::vector<Side> sides = elaborate_sides(parsed, elaborator, own);
  for (std::size_t k = 0; k < parsed.written.relations.size(); ++k)
    step(parsed, k, sides, elaborator, context);
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

std::vector<Session::Side> Session::elaborate_sides(const ParsedChain& parsed, Elaborator& elaborator,
                                                    Diagnostics& own) {
  std::vector<Side> sides;
  for (const SyntaxId id : parsed.sides) {
    Side side;
    side.typed = elaborator.expression(id);
    side.diagnostics = std::exchange(own, {});
    if (sides.empty() && side.typed) elaborator.expect_slots(side.typed->free);
    sides.push_back(std::move(side));
  }
  return sides;
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
