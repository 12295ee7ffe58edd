// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk through notes collects for the floating-point side.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "check/event/notes.h"
#include "check/form/forms.h"
#include "check/verdict/chain_reading.h"

namespace rigor {

class FormRecorder {
 public:
  /// Kept by reference; `notes` has the asked expressions read.
  FormRecorder(const FormRequest& request, const Notes& notes, const SourceMap& sources,
               Diagnostics& diagnostics)
      : request_(request), notes_(notes), sources_(sources), diagnostics_(diagnostics) {}

  /// Once the faces of all letters are known: finds what is needed.
  void plan(Names& names);
  /// Are verdicts wanted, and all that follows from them?
  [[nodiscard]] bool decides() const { return !request_.only; }
  /// Is the chain needed? One that is not is counted.
  [[nodiscard]] bool follows(const ParsedChain& chain) {
    const bool needed = decides() || needed_.contains(&chain);
    if (!needed) ++passed_over_;
    return needed;
  }

  void declare_unit(SymbolId symbol, const Dimension& dimension) { forms_.units[symbol] = dimension; }
  /// The walk comes to an event.
  void enter(std::size_t event);
  /// What the exact side was asked about the step at hand, and answered; both are taken.
  void note(Span relation, Judgement& judgement);
  /// The chain at hand is over; `steps` are its own.
  struct Chain {
    const ParsedChain& parsed;
    const ChainReading& reading;
    std::span<const Step> steps;
    bool assumed;
    bool first_order;  // `=` means ≈
  };
  void add(ExprTree& tree, Names& names, const Chain& chain);
  /// Behind the event: what is asked for, if this is its place.
  void ask(std::size_t event, ExprTree& tree, Names& names);
  /// Behind the last event: how the notes write.
  void see(const ExprTree& tree, Names& names);
  /// When nothing more will be read; the tree is gone.
  [[nodiscard]] FormsReading finish(ExprTree&& tree) &&;

 private:
  bool read(SyntaxId id, const std::string& source, ExprTree& tree, Names& names);
  [[nodiscard]] bool is_known(SyntaxId id, const std::string& source, Names& names);

  const FormRequest& request_;
  const Notes& notes_;
  const SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::set<const ParsedChain*> needed_;
  std::vector<const Heading*> sections_;  // that are open, the outermost first
  std::size_t passed_over_ = 0;
  std::size_t asked_behind_ = 0;  // event
  std::set<std::string> known_;
  std::vector<std::pair<Span, WrittenStep>> decided_;  // by relation
  std::vector<WrittenHole> holes_;
  WrittenForms forms_;
};

}  // namespace rigor
