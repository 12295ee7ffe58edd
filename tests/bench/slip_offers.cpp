// SPDX-License-Identifier: GPL-3.0-or-later
#include "slip_offers.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "base/check.h"
#include "check/entry/check.h"
#include "check/question/decision_cache.h"
#include "check/repair/repair.h"
#include "check/repair/sides_near.h"
#include "check/verdict/chain_reading.h"
#include "check/verdict/judge.h"
#include "check/walk/walk.h"
#include "further_slips.h"
#include "latex/parse/parse.h"
#include "source/read_file.h"

namespace rigor::twins {
namespace {

/// The expression as text, with the factors of numbers and the terms of sums in order.
std::string sorted_text(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  std::vector<std::string> parts;
  if (node.op == Op::add || node.op == Op::negate) {
    for (const ExprId child : tree.children(id))
      parts.push_back((node.op == Op::negate ? "-" : "+") + sorted_text(tree, child));
    if (node.op == Op::add) std::sort(parts.begin(), parts.end());
    return fmt::format("({})", fmt::join(parts, ""));
  }
  if (node.count == 0 || node.op == Op::table) return dump(tree, id);
  for (const ExprId child : tree.children(id)) parts.push_back(sorted_text(tree, child));
  if (node.op == Op::multiply || node.op == Op::dot) std::sort(parts.begin(), parts.end());
  std::string own =
      fmt::format("{}.{}.{}", static_cast<int>(node.op), node.exponent, static_cast<int>(node.function));
  if (node.op == Op::index_sum) own += tree.name(node.index);
  for (const Slot& slot : tree.slots(id))
    own += slot.axis != 0 ? std::to_string(slot.axis) : tree.name(slot.variable);
  return fmt::format("[{} {}]", own, fmt::join(parts, " "));
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char each) { return each == ' ' || each == '{' || each == '}'; });
  return text;
}

/// A text as tokens, which are views into it.
struct Written {
  explicit Written(std::string text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    file = sources.add("side", std::move(text));
    tokens = lex(sources, {file, 0, size});
  }
  SourceMap sources;
  FileId file = 0;
  Tokens tokens;
};

class FileOfRows {
 public:
  FileOfRows(const std::string& path, rigor::twins::Asked asked) : path_(path), asked_(asked) {
    auto text = read_file(path);
    RIGOR_CHECK(text.has_value(), path);
    text_ = *text;
    report_.file = sources_.add(path, *std::move(text));
    std::filesystem::path beside(path);
    beside.replace_extension(".rigor");
    std::optional<FileId> sidecar;
    if (auto directives = read_file(beside.string()))
      sidecar = sources_.add(beside.string(), *std::move(directives));
    Diagnostics ignored;
    notes_ = read_notes(sources_, report_.file, sidecar ? &*sidecar : nullptr, ignored);
    ledger_ = walk_through(sources_, notes_, report_, {.repairs = Repairs::none, .cache = &cache_});
    std::error_code ignored_error;
    folder_ = std::filesystem::temp_directory_path() / fmt::format("rigor-slips-{}", ::getpid());
    std::filesystem::remove_all(folder_, ignored_error);
    remembered_ = std::make_unique<DecisionCache>(folder_.string(), path, "slips");
  }
  ~FileOfRows() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  FileOfRows(const FileOfRows&) = delete;
  FileOfRows& operator=(const FileOfRows&) = delete;

  Offers all() {
    for (const LedgerEntry& entry : ledger_.entries) {
      const auto* statement = std::get_if<rigor::Statement>(&entry.what);
      if (statement == nullptr || !is_claimed(statement->role) || statement->chain->image > 0) continue;
      for (std::size_t which = 0; which < statement->step_count; ++which) {
        if (report_.steps[statement->first_step + which].verdict == Verdict::proved)
          spoil({*entry.scope, *statement, which});
      }
    }
    return std::move(result_);
  }

 private:
  struct Row {
    const Names& names;
    const rigor::Statement& statement;
    std::size_t which;
  };

  /// The chain of a row with one side as it is in `written`, and what is read of it.
  struct Reread {
    ExprTree tree;
    Names names;
    SyntaxTree syntax = {};
    ParsedChain chain;
    std::unique_ptr<ChainReading> reading = {};
    std::optional<Claim> claim = {};
  };

  std::unique_ptr<Reread> reread(const Row& row, std::size_t side, const Tokens& tokens) const {
    auto read = std::make_unique<Reread>(Reread{ledger_.tree, row.names, {}, *row.statement.chain});
    read->chain.written.sides[row.which + side].tokens = tokens;
    for (std::size_t k = 0; k < read->chain.sides.size(); ++k) {
      const WrittenSide& each = read->chain.written.sides[k];
      read->chain.sides[k] = parse_side(each.tokens, each.span, read->syntax);
    }
    read->reading = read_chain(read->syntax, read->tree, read->names, read->chain, row.statement.rules);
    const auto& sides = read->reading->sides;
    Diagnostics mismatches;
    if (sides[row.which].typed && sides[row.which + 1].typed)
      read->claim = read->reading->claim(read->chain, row.which, row.statement.first_order, mismatches);
    if (!mismatches.empty()) read->claim.reset();
    return read;
  }

  Answer answer_to(Reread& row) {
    if (!row.claim) return Answer::unread;
    cache_.begin(default_effort);
    Limits limits = limits_of_candidates;
    limits.only_proofs = false;
    const Judgement judgement = judge(row.tree, row.names, *row.claim, limits, &cache_);
    switch (judgement.verdict) {
      case Verdict::proved:
        return Answer::proved;
      case Verdict::refuted:
        return Answer::refuted;
      case Verdict::law:
        return Answer::law;
      default:
        return Answer::open;
    }
  }

  std::string sorted_side(const Row& row, std::size_t side, const Tokens& tokens) const {
    const auto read = reread(row, side, tokens);
    const auto& typed = read->reading->sides[row.which + side].typed;
    return typed ? sorted_text(read->tree, typed->id) : "not read";
  }

  // --- the whole page

  [[nodiscard]] const Step& step_of(const Row& row) const {
    return report_.steps[row.statement.first_step + row.which];
  }

  /// Does it rest on a definition or a law, and not on conventions alone?
  static bool rests_on_page(const Step& step) {
    return std::ranges::any_of(step.uses,
                               [](const std::string& use) { return !use.starts_with("convention"); });
  }

  static bool is_found_wrong(const Step& step) {
    return step.verdict == Verdict::refuted || step.verdict == Verdict::suspect;
  }

  static Answer answer_of(const Step& step) {
    switch (step.verdict) {
      case Verdict::proved:
        return Answer::proved;
      case Verdict::refuted:
        return Answer::refuted;
      case Verdict::suspect:
        return Answer::suspect;
      case Verdict::law:
      case Verdict::definition:
      case Verdict::given:
        return Answer::law;
      case Verdict::not_understood:
        return Answer::unread;
      default:
        return Answer::open;
    }
  }

  /// The page up to the end of the row's display, without the displays above it of which nothing is used:
  /// what is not decided proves nothing. Nothing moves.
  [[nodiscard]] std::string page_up_to(const Row& row) const {
    const std::size_t own = row.statement.chain->written.relations[row.which].span.begin;
    std::string page = text_;
    for (const Span display : report_.displays) {
      if (display.begin <= own && own < display.end) page.resize(display.end);
      const bool used = std::ranges::any_of(report_.steps, [&](const Step& step) {
        const bool inside =
            step.relation_span.begin >= display.begin && step.relation_span.begin < display.end;
        return inside && (step.verdict == Verdict::proved || step.verdict == Verdict::definition ||
                          step.verdict == Verdict::law || step.verdict == Verdict::given);
      });
      if (!used && display.end <= own)
        page.replace(display.begin, display.end - display.begin, display.end - display.begin, ' ');
    }
    return page;
  }

  /// The page, or its part above the row, where that proves the row as well.
  void choose_page(const Row& row) {
    shown_ = page_up_to(row);
    SourceMap sources;
    const FileReport page =
        check_text(sources, path_, shown_, {.repairs = Repairs::none, .cache = remembered_.get()});
    const std::size_t relation = row.statement.chain->written.relations[row.which].span.begin;
    const auto same =
        std::ranges::find(page.steps, relation, [](const Step& step) { return step.relation_span.begin; });
    const bool enough = same != page.steps.end() && same->verdict == Verdict::proved &&
                        same->uses.size() == step_of(row).uses.size();
    if (!enough) shown_ = text_;
  }

  /// The steps of the page whose side is another one.
  FileReport page_with(const Row& row, std::size_t side, const std::string& text, Repairs repairs) {
    const Span span = row.statement.chain->written.sides[row.which + side].span;
    std::string page = shown_;
    page.replace(span.begin, span.end - span.begin, text);
    SourceMap sources;
    return check_text(sources, path_, std::move(page),
                      {.repairs = repairs,
                       .near_at = row.statement.chain->written.span.begin,
                       .cache = remembered_.get(),
                       .effort = asked_.effort});
  }

  std::optional<std::size_t> place_on_page(const FileReport& page, const Row& row, std::size_t side,
                                           std::size_t length) const {
    const WrittenChain& written = row.statement.chain->written;
    const Span span = written.sides[row.which + side].span;
    const std::size_t longer = length - (span.end - span.begin);
    const std::size_t relation = written.relations[row.which].span.begin + (side == 0 ? longer : 0);
    for (std::size_t k = 0; k < page.steps.size(); ++k) {
      if (page.steps[k].relation_span.begin == relation) return k;
    }
    return std::nullopt;
  }

  /// As its author would ask: what is suspected above proves nothing.
  bool is_proved_on_whole_page(const Row& row, std::size_t side, const std::string& text) {
    const std::string shown = std::exchange(shown_, text_);
    const std::uint64_t effort = std::exchange(asked_.effort, default_effort);
    const FileReport page = page_with(row, side, text, Repairs::of_unexpected);
    shown_ = shown;
    asked_.effort = effort;
    const auto at = place_on_page(page, row, side, text.size());
    return at && page.steps[*at].verdict == Verdict::proved;
  }

  /// The row's answer on the page, and which statement that is offered there is the original.
  void ask_page(const Row& row, std::size_t side, const std::string& original, const std::string& sorted,
                const std::string& text, Offer& offer) {
    const auto start = std::chrono::steady_clock::now();
    const FileReport page =
        page_with(row, side, text, asked_.offers && offer.on_page ? Repairs::and_of_laws : Repairs::none);
    offer.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    offer.answer = Answer::unread;
    const auto at = place_on_page(page, row, side, text.size());
    if (!at) return;
    const Step& own = page.steps[*at];
    offer.answer = answer_of(own);
    offer.said = fmt::format("{} {}", rigor::name_of(own.verdict), fmt::join(own.uses, "; "));
    for (const Diagnostic& diagnostic : own.diagnostics) offer.said += " | " + diagnostic.message;
    const std::size_t first = *at - row.which;
    for (std::size_t k = 0; k < page.steps.size(); ++k) {
      const bool of_chain = k >= first && k < first + row.statement.step_count;
      const bool was_wrong = page.steps.size() == report_.steps.size() && is_found_wrong(report_.steps[k]);
      if (!of_chain && is_found_wrong(page.steps[k]) && !was_wrong) ++offer.others;
    }
    for (const std::size_t k :
         {*at, side == 0 ? *at - 1 : *at + 1}) {  // the side is one of its neighbour, too
      if (k < first || k >= first + row.statement.step_count) continue;
      const bool of_left = (k == *at) == (side == 0);
      take_offers(row, side, of_left, page.steps[k].repairs, original, sorted, offer);
    }
  }

  void take_offers(const Row& row, std::size_t side, bool of_left, const std::vector<Repair>& repairs,
                   const std::string& original, const std::string& sorted, Offer& offer) const {
    for (std::size_t k = 0; k < repairs.size(); ++k) {
      offer.offered.push_back(repairs[k].statement);
      if (repairs[k].on_left != of_left) continue;
      if (offer.equal == 0) offer.equal = k + 1;
      const Written repaired(repairs[k].replacement);
      const bool is_same = without_blanks(repairs[k].replacement) == without_blanks(original) ||
                           sorted_side(row, side, repaired.tokens) == sorted;
      if (is_same && offer.same == 0) offer.same = k + 1;
    }
  }

  // --- slips

  void spoil(const Row& row) {
    ++result_.rows;
    const std::vector<WrittenSide>& sides = row.statement.chain->written.sides;
    const Written left(text_of(without_layout(sides[row.which].tokens)));
    const Written right(text_of(without_layout(sides[row.which + 1].tokens)));
    const auto same = reread(row, 0, left.tokens);
    const bool on_page = answer_to(*same) != Answer::proved;
    const bool result = rests_on_page(step_of(row));
    result_.on_page += on_page ? 1 : 0;
    result_.results += result ? 1 : 0;
    if (on_page && !asked_.pages) return;
    if (!asked_.offers && !result) return;
    if (on_page || result) choose_page(row);
    const std::vector<TokenView> statement{left.tokens, right.tokens};
    for (const std::size_t side : {0u, 1u}) {
      const Written& own = side == 0 ? left : right;
      if (on_page || result) {
        const std::string text(own.sources.text(span_of(own.tokens)));
        const FileReport page = page_with(row, side, text, Repairs::none);
        const auto at = place_on_page(page, row, side, text.size());
        if (!at || page.steps[*at].verdict != Verdict::proved) {
          result_.lost.push_back(step_of(row).source);
          continue;
        }
      }
      std::vector<Edit> edits = slips_of(own.sources, own.tokens, statement);
      for (Edit& edit : further_slips_of(own.sources, own.tokens, statement))
        edits.push_back(std::move(edit));
      const std::string original(own.sources.text(span_of(own.tokens)));
      const std::string sorted = sorted_side(row, side, own.tokens);
      for (const Edit& edit : edits)
        spoil(row, {side, original, sorted, on_page, result}, edit.slip,
              with_edit(own.sources.text(
                            {own.file, 0, static_cast<std::uint32_t>(own.sources.text(own.file).size())}),
                        0, edit));
    }
  }

  struct Own {
    std::size_t side;
    const std::string& original;
    const std::string& sorted;
    bool on_page;
    bool result;
  };

  void spoil(const Row& row, const Own& own, Slip slip, std::string text) {
    if (count_++ % asked_.every != 0) return;
    const Span relation = row.statement.chain->written.relations[row.which].span;
    const std::string other = text_of(row.statement.chain->written.sides[row.which + 1 - own.side].tokens);
    Offer offer{.slip = slip,
                .place = fmt::format("{}:{}", std::filesystem::path(path_).filename().string(),
                                     sources_.line_column(relation.file, relation.begin).line),
                .original = fmt::format("{}  [other side] {}", own.original, other),
                .twin = text,
                .on_page = own.on_page};
    if (own.result && asked_.twins) {
      ++result_.twins;
      ask_page(row, own.side, own.original, own.sorted, text, offer);
      if (offer.answer == Answer::proved && sorted_side(row, own.side, Written(text).tokens) != own.sorted &&
          is_proved_on_whole_page(row, own.side, text))
        result_.proved.push_back(offer);
    } else if (own.on_page) {
      ask_page(row, own.side, own.original, own.sorted, text, offer);
    }
    if (!asked_.offers) return;
    if (!own.on_page) ask_here(row, own, std::move(text), offer);
    if (offer.answer != Answer::proved) result_.offers.push_back(std::move(offer));
  }

  /// The search for statements that are true, without the page.
  void ask_here(const Row& row, const Own& own, std::string text, Offer& offer) {
    const Written spoilt(std::move(text));
    const auto read = reread(row, own.side, spoilt.tokens);
    offer.answer = answer_to(*read);
    if (offer.answer == Answer::proved) return;
    ParsedChain chain = *row.statement.chain;
    chain.written.sides[row.which + own.side].tokens = spoilt.tokens;
    const WrongStep wrong{.parsed = chain,
                          .which = row.which,
                          .first_order = row.statement.first_order,
                          .rules = row.statement.rules,
                          .near = sides_near(notes_, *row.statement.chain)};
    cache_.begin(default_effort);
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Repair> repairs = nearest_true_statements(ledger_.tree, row.names, wrong, &cache_);
    offer.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    take_offers(row, own.side, own.side == 0, repairs, own.original, own.sorted, offer);
  }

  std::string path_;
  rigor::twins::Asked asked_;
  std::string text_;
  std::string shown_ = {};  // what is checked of it
  std::size_t count_ = 0;   // of slips
  std::filesystem::path folder_;
  std::unique_ptr<DecisionCache> remembered_;
  SourceMap sources_;
  DecisionCache cache_;
  FileReport report_;
  Notes notes_;
  Ledger ledger_;
  Offers result_;
};

}  // namespace

Offers offers_of(const std::string& path, Asked asked) { return FileOfRows(path, asked).all(); }

}  // namespace rigor::twins
