// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/package_macros.h"

#include <string>
#include <unordered_map>

#include "latex/token/words.h"

namespace rigor {
namespace {

constexpr std::size_t longest_call = 2'000;  // tokens

/// What a package's macro takes: `*` a star or none, `+` a star, `o` something in `[…]`, `m` a group in
/// braces,
/// `(`, `[`, `|` something between such signs, `s` a group of scripts, `!` no group. The first row whose
/// arguments are there counts. `)` and `]`: what is between such a bracket and the bar that closes it.
struct PackageMacro {
  std::string_view names;
  std::string_view takes;
  std::string_view body;
};

constexpr PackageMacro package_macros[] = {
    // physics, physics2: brackets that grow
    {"qty quantity ab", "*(", R"(\left(#1\right))"},
    {"qty quantity ab", "*[!", R"(\left[#1\right])"},
    {"qty quantity ab", "*|", R"(\left|#1\right|)"},
    {"pqty pab", "*m", R"(\left(#1\right))"},
    {"bqty bab", "*m", R"(\left[#1\right])"},
    {"Bqty Bab ab", "*m", R"(\left\{#1\right\})"},
    {"vqty vab", "*m", R"(\left|#1\right|)"},
    {"abs absolutevalue", "om", R"(\abs{#2})"},
    {"norm", "om", R"(\norm{#2})"},
    // physics, physics2, mathtools: matrices
    {"mqty matrixquantity smqty smallmatrixquantity", "*(", R"(\begin{pmatrix}#1\end{pmatrix})"},
    {"mqty matrixquantity smqty smallmatrixquantity", "*[", R"(\begin{bmatrix}#1\end{bmatrix})"},
    {"mqty matrixquantity smqty smallmatrixquantity", "*|", R"(\begin{vmatrix}#1\end{vmatrix})"},
    {"mqty matrixquantity smqty smallmatrixquantity", "m", R"(\begin{matrix}#1\end{matrix})"},
    {"mqty matrixquantity smqty smallmatrixquantity", "+m", R"(\begin{pmatrix}#1\end{pmatrix})"},
    {"pmqty Pmqty spmqty sPmqty", "m", R"(\begin{pmatrix}#1\end{pmatrix})"},
    {"bmqty sbmqty", "m", R"(\begin{bmatrix}#1\end{bmatrix})"},
    {"vmqty svmqty mdet matrixdeterminant smdet smallmatrixdeterminant", "m",
     R"(\begin{vmatrix}#1\end{vmatrix})"},
    // tensor
    {"indices", "*s", "#1"},
    {"tensor", "*ms", "{#1}#2"},
    // physics: a value at a place
    {"eval evaluated", "*m", R"(\left.#1\right|)"},
    {"eval evaluated", "*)", R"(\left.#1\right|)"},
    {"eval evaluated", "*]", R"(\left.#1\right|)"},
    // physics: functions by their whole names
    {"asin asine arcsine", "", R"(\arcsin)"},
    {"acos acosine arccosine", "", R"(\arccos)"},
    {"atan atangent arctangent", "", R"(\arctan)"},
    {"sine", "", R"(\sin)"},
    {"cosine", "", R"(\cos)"},
    {"tangent", "", R"(\tan)"},
    {"hypsine", "", R"(\sinh)"},
    {"hypcosine", "", R"(\cosh)"},
    {"hyptangent", "", R"(\tanh)"},
    {"exponential", "", R"(\exp)"},
    {"naturallogarithm", "", R"(\ln)"},
    // physics, derivative
    {"flatfrac", "mm", R"(\frac{#1}{#2})"},
    {"odv ordinaryderivative", "", R"(\dv)"},
    {"pderivative", "", R"(\pdv)"},
    {"odif", "*m", R"(\dd{#1})"},
    {"vnabla", "", R"(\nabla)"},
    // diffcoeff
    {"diff", "*omm", R"(\dv[#1]{#2}{#3})"},
    {"diff", "*mm", R"(\dv{#1}{#2})"},
    {"diffp", "*omm", R"(\pdv[#1]{#2}{#3})"},
    {"diffp", "*mm", R"(\pdv{#1}{#2})"},
    // physics: words between equations
    {"qcomma", "", R"(,\quad )"},
    {"qcc", "*", R"(\quad\text{c.c.}\quad )"},
    {"qif", "*", R"(\quad\text{if}\quad )"},
    {"qthen", "*", R"(\quad\text{then}\quad )"},
    {"qelse", "*", R"(\quad\text{else}\quad )"},
    {"qotherwise", "*", R"(\quad\text{otherwise}\quad )"},
    {"qunless", "*", R"(\quad\text{unless}\quad )"},
    {"qgiven", "*", R"(\quad\text{given}\quad )"},
    {"qusing", "*", R"(\quad\text{using}\quad )"},
    {"qassume", "*", R"(\quad\text{assume}\quad )"},
    {"qsince", "*", R"(\quad\text{since}\quad )"},
    {"qlet", "*", R"(\quad\text{let}\quad )"},
    {"qfor", "*", R"(\quad\text{for}\quad )"},
    {"qall", "*", R"(\quad\text{all}\quad )"},
    {"qeven", "*", R"(\quad\text{even}\quad )"},
    {"qodd", "*", R"(\quad\text{odd}\quad )"},
    {"qinteger", "*", R"(\quad\text{integer}\quad )"},
    {"qand", "*", R"(\quad\text{and}\quad )"},
    {"qor", "*", R"(\quad\text{or}\quad )"},
    {"qas", "*", R"(\quad\text{as}\quad )"},
    {"qin", "*", R"(\quad\text{in}\quad )"},
    // mathtools
    {"mathllap mathrlap mathclap cramped", "m", R"({#1})"},
    {"underbracket", "m", R"(\underbrace{#1})"},
    {"overbracket", "m", R"(\overbrace{#1})"},
};

/// `^\mu_\nu` becomes `^\mu{}_\nu`: each script has a column of its own. False for what is no row of scripts.
bool set_apart(Tokens& scripts) {
  Tokens apart;
  for (std::size_t at = skip_blank(scripts, 0); at < scripts.size();) {
    const TokenKind kind = scripts[at].kind;
    if (kind != TokenKind::subscript && kind != TokenKind::superscript) return false;
    const std::size_t next = script_argument_at(scripts, at + 1).next;
    if (!apart.empty()) {
      apart.push_back({TokenKind::begin_group, "{", scripts[at].span});
      apart.push_back({TokenKind::end_group, "}", scripts[at].span});
    }
    apart.insert(apart.end(), scripts.begin() + static_cast<std::ptrdiff_t>(at),
                 scripts.begin() + static_cast<std::ptrdiff_t>(next));
    at = skip_blank(scripts, next);
  }
  scripts = std::move(apart);
  return !scripts.empty();
}

struct Row {
  std::string_view takes;
  Tokens body;
};

const std::unordered_map<std::string_view, std::vector<Row>>& rows_by_name() {
  static const auto table = [] {
    std::unordered_map<std::string_view, std::vector<Row>> rows;
    for (const PackageMacro& macro : package_macros) {
      for (const std::string_view name : words_in(macro.names))
        rows[name].push_back({macro.takes, lex_text(macro.body)});
    }
    return rows;
  }();
  return table;
}

/// Reads ahead of a stream without taking anything.
class CallReader {
 public:
  explicit CallReader(const MacroStream& stream) : stream_(stream) {}

  std::optional<std::vector<TakenArgument>> arguments(std::string_view takes) {
    for (const char type : takes) {
      if (!one(type)) return std::nullopt;
    }
    return std::move(arguments_);
  }
  [[nodiscard]] std::size_t length() const { return at_; }

 private:
  bool one(char type) {
    const std::size_t next = behind_spaces();
    const auto token = stream_.peek(next);
    const bool star = token && is_sign(*token, "*");
    if (type == '*' || type == '+') {
      if (star) at_ = next + 1;
      return star || type == '*';
    }
    if (type == '!') return !token || token->kind != TokenKind::begin_group;
    if (!token) return false;
    if (type == 's') {
      return token->kind == TokenKind::begin_group && between(next, "}") &&
             set_apart(arguments_.back().tokens);
    }
    if (type == 'm') return token->kind == TokenKind::begin_group && between(next, "}");
    if (type == '(') return is_sign(*token, "(") && between(next, ")");
    if (type == ')') return is_sign(*token, "(") && between(next, "|");
    if (type == ']') return is_sign(*token, "[") && between(next, "|");
    if (type == '[' || type == 'o') return is_sign(*token, "[") && between(next, "]");
    return is_sign(*token, "|") && between(next, "|");
  }

  [[nodiscard]] std::size_t behind_spaces() const {
    std::size_t next = at_;
    for (auto token = stream_.peek(next); token && token->kind == TokenKind::space;)
      token = stream_.peek(++next);
    return next;
  }

  /// From the opening sign at `open` to the `close` of its depth.
  bool between(std::size_t open, std::string_view close) {
    TakenArgument argument{{}, stream_.peek(open)->span};
    int braces = 0;
    int brackets = 0;
    for (std::size_t at = open + 1; at < open + longest_call; ++at) {
      const auto token = stream_.peek(at);
      if (!token || token->kind == TokenKind::paragraph) return false;
      const bool closes =
          token->text == close && (token->kind == TokenKind::other || token->kind == TokenKind::end_group);
      if (closes && braces == 0 && brackets == 0) {
        argument.span = cover(argument.span, token->span);
        at_ = at + 1;
        arguments_.push_back(std::move(argument));
        return true;
      }
      if (token->kind == TokenKind::begin_group) ++braces;
      if (token->kind == TokenKind::end_group && --braces < 0) return false;
      if (braces == 0 && close != "}" && is_sign_of(*token, "([")) ++brackets;
      if (braces == 0 && close != "}" && is_sign_of(*token, ")]") && --brackets < 0) return false;
      argument.tokens.push_back(*token);
    }
    return false;
  }

  const MacroStream& stream_;
  std::size_t at_ = 0;
  std::vector<TakenArgument> arguments_;
};

}  // namespace

std::optional<PackageCall> package_call(std::string_view control, MacroStream& stream) {
  const auto rows = rows_by_name().find(control);
  if (rows == rows_by_name().end()) return std::nullopt;
  for (const Row& row : rows->second) {
    CallReader reader(stream);
    auto arguments = reader.arguments(row.takes);
    if (!arguments) continue;
    for (std::size_t k = 0; k < reader.length(); ++k) stream.take();
    return PackageCall{row.body, std::move(*arguments)};
  }
  return std::nullopt;
}

}  // namespace rigor
