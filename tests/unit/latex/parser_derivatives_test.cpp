// SPDX-License-Identifier: GPL-3.0-or-later
// Dots, derivatives, changes and the sign nabla.
#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string parsed(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens side = stretch.side();
  return dump_syntax(tree, parse_side(side, span_of(side), tree));
}

/// The first obstacle in the text.
std::string obstacle(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens side = stretch.side();
  const SyntaxId root = parse_side(side, span_of(side), tree);
  return tree[root].kind == SyntaxKind::opaque ? tree.obstacle(root).message : "";
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

}  // namespace

TEST_CASE("dots over a letter are part of the symbol") {
  CHECK(parsed("\\dot x") == "dot:x");
  CHECK(parsed("\\dddot x+\\ddddot{x}") == "(sum +dddot:x +ddddot:x)");
  CHECK(parsed("\\dot{\\mathbf r}_\\alpha") == "vector:dot:r[\\alpha]");
  CHECK(parsed("\\dot\\mathbf r") == "vector:dot:r");
  CHECK(parsed("\\mathbf{\\dot r}") == "vector:dot:r");
  CHECK(parsed("\\mathbf\\dot r") == "vector:dot:r");
  CHECK(parsed("\\vec{\\dot{r}}_i'") == "vector:dot:r'[i]");
  CHECK(parsed("\\ddot{\\omega}_2") == "ddot:\\omega[2]");
  CHECK(parsed("\\dot{r}_\\alpha^2") == "(power dot:r[\\alpha] 2)");
  CHECK(parsed("\\dot{\\omega_1}\\dot\\omega_2") == "(term dot:\\omega[1] dot:\\omega[2])");
  CHECK(parsed("\\dot{\\hat{\\mathbf n}}") == "vector:hat:dot:n");
  CHECK(parsed("\\dot{\\dot x}") == "ddot:x");
}

TEST_CASE("the span of a dotted symbol has its dot and its scripts") {
  for (const char* text : {"\\dot{\\mathbf r}_{\\alpha}", "\\dot{x}", "\\ddot{x}^{2}"}) {
    Stretch stretch(text);
    SyntaxTree tree;
    CHECK(stretch.written(tree[parse_side(stretch.tokens, {}, tree)].span) == text);
  }
}

TEST_CASE("a dot over an expression is its derivative by the time") {
  CHECK(parsed("\\dot{(\\mathbf A\\times\\mathbf B)}") == "(d/dt (group (term vector:A ×vector:B)))");
  CHECK(parsed("\\ddot{AB}") == "(d/dt^2 (term A B))");
}

TEST_CASE("an accent over a dotted letter is not read: it is not the dot over the accented letter") {
  CHECK(parsed("\\hat{\\dot{\\mathbf r}}") == "<unsupported>");
  CHECK(parsed("\\bar{\\delta x}") == "<unsupported>");
}

TEST_CASE("a derivative is known in every form of the fraction") {
  for (const char* text :
       {"\\frac{d\\mathbf A}{dt}", "\\dfrac{d\\mathbf{A}}{d t}", "\\tfrac{d\\,\\mathbf A}{d\\,t}",
        "\\frac{\\mathrm d\\mathbf A}{\\mathrm d t}", "\\frac{\\text{d}\\mathbf A}{\\text{d}t}",
        "\\frac{\\mathrm{d}\\mathbf A}{dt}", "\\frac{\\dd\\mathbf A}{\\dd t}", "\\dv{\\mathbf A}{t}",
        "\\derivative{\\mathbf A}{t}", "d\\mathbf A/dt", "\\mathrm d\\mathbf A/\\mathrm{d}t",
        "\\frac{d}{dt}\\mathbf A", "\\dv{t}\\mathbf A", "d/dt\\,\\mathbf A"}) {
    INFO(text);
    CHECK(parsed(text) == "(d/dt vector:A)");
  }
  CHECK(parsed("\\frac{dL_j}{dt} + b") == "(sum +(d/dt L[j]) +b)");
  CHECK(parsed("\\frac{df}{dx}\\frac{dA}{d\\theta}") == "(term (d/dx f) (d/d\\theta A))");
  CHECK(parsed("m\\,dx/dt\\,y") == "(term m (d/dt x) y)");
  CHECK(parsed("d(\\mathbf r\\times\\mathbf p)/dt") == "(d/dt (group (term vector:r ×vector:p)))");
  CHECK(parsed("\\frac{df(x)}{dx}") == "(d/dx (term f (group x)))");
  CHECK(parsed("\\frac{dA^2}{dt}") == "(d/dt (power A 2))");
}

TEST_CASE("the order of a derivative stands above and below") {
  CHECK(parsed("\\frac{d^2 x}{dt^2}") == "(d/dt^2 x)");
  CHECK(parsed("\\frac{d^{2}\\mathbf{r}_\\alpha}{dt^{2}}") == "(d/dt^2 vector:r[\\alpha])");
  CHECK(parsed("\\frac{d^2}{dt^2}\\mathbf r") == "(d/dt^2 vector:r)");
  CHECK(parsed("\\dv[2]{x}{t}") == "(d/dt^2 x)");
  CHECK(parsed("d^2x/dt^2") == "(d/dt^2 x)");
  CHECK(parsed("\\frac{d^2x}{dt}") == "<bad-syntax>");
  CHECK(parsed("\\frac{d^n x}{dt^n}") == "<unsupported>");
}

TEST_CASE("an operator acts on the rest of its term") {
  CHECK(parsed("\\frac{d}{dt}\\mathbf r\\times\\mathbf p + c") ==
        "(sum +(d/dt (term vector:r ×vector:p)) +c)");
  CHECK(parsed("\\frac{d}{dt}\\left(\\frac12 m v^2\\right)") ==
        "(d/dt (group (term (fraction 1 2) m (power v 2))))");
  CHECK(parsed("\\frac{d}{dt}\\sum_\\alpha m_\\alpha\\mathbf r_\\alpha - b") ==
        "(sum +(d/dt (sum over [\\alpha] (term m[\\alpha] vector:r[\\alpha]))) -b)");
  CHECK(parsed("2\\frac{\\partial}{\\partial t}(a+b)") == "(term 2 (∂/∂t (group (sum +a +b))))");
  CHECK(parsed("\\frac{d}{dt}\\frac{d}{dt}x") == "(d/dt (d/dt x))");
}

TEST_CASE("an operator without anything to act on is not read") {
  CHECK(parsed("\\frac{d}{dt}") == "<unsupported>");
  CHECK(parsed("\\frac{d}{dt} + a") == "(sum +<unsupported> +a)");
  CHECK(parsed("\\frac{d}{dt}\\cdot a") == "(term <unsupported> ·a)");
}

TEST_CASE("where it is not clear how much is differentiated nothing is read") {
  CHECK(parsed("\\frac{d\\mathbf r\\cdot\\mathbf F}{dt}") == "<ambiguous-reading>");
  CHECK(parsed("\\frac{\\partial A_iB_j}{\\partial t}") == "<ambiguous-reading>");
  CHECK(parsed("\\frac{d}{dt}(a+b)c") == "<ambiguous-reading>");
  CHECK(parsed("\\partial_i\\frac{a}{2}v^2") == "(term <ambiguous-reading> (power v 2))");
  CHECK(parsed("\\partial_i A_j B_k") == "(term <ambiguous-reading> B[k])");
}

TEST_CASE("a fraction of letters d is a derivative only with more below") {
  CHECK(parsed("\\frac{d}{d}") == "(fraction d d)");
  CHECK(parsed("\\frac{D}{d^2}") == "(fraction D (power d 2))");
  CHECK(parsed("\\frac{d_1}{d_2}") == "(fraction d[1] d[2])");
  CHECK(parsed("\\frac{d+a}{dt}") == "(fraction (sum +d +a) (term d t))");
  CHECK(parsed("d_1/d_2") == "(term d[1] /d[2])");
}

TEST_CASE("a subscript on a bracket or on a bar names the frame of a derivative") {
  const std::string expected = "(component[\"in\"] (group (d/dt vector:A)))";
  CHECK(parsed("\\left(\\frac{d\\mathbf A}{dt}\\right)_{\\text{in}}") == expected);
  for (const char* fraction : {"frac", "dfrac", "tfrac", "cfrac", "nicefrac", "sfrac"}) {
    INFO(fraction);
    CHECK(parsed(std::string("\\left(\\") + fraction + "{d}{dt}\\right)_{\\text{in}}\\mathbf A") == expected);
  }
  CHECK(parsed("\\left.\\frac{d\\mathbf A}{dt}\\right|_{\\text{in}}") == expected);
  CHECK(parsed("\\frac{d\\mathbf A}{dt}\\bigg|_{\\text{in}}") == expected);
  CHECK(parsed("\\frac{d\\mathbf A}{dt}\\Biggr\\vert_\\mathrm{in}") == expected);
  CHECK(parsed("d\\mathbf A/dt|_{\\rm in}") == expected);
  CHECK(parsed("\\frac{d}{dt}\\Big|_{\\text{in}}\\mathbf A") == expected);
  CHECK(parsed("\\left(\\frac{d}{dt}\\right)_{\\text{in}}\\mathbf A") == expected);
  CHECK(parsed("\\left.\\frac{d\\mathbf A}{dt}\\right|_S+b") ==
        "(sum +(component[S] (group (d/dt vector:A))) +b)");
}

TEST_CASE("any other evaluation bar is not read") {
  CHECK(parsed("\\frac{dA}{dt}\\bigg|_{t=0}") == "<unsupported>");
  CHECK(parsed("\\left.\\frac{dA}{dt}\\right|_0") == "<unsupported>");
  CHECK(parsed("\\left.a+\\frac{dA}{dt}\\right|_S") == "<unsupported>");
  CHECK(parsed("\\frac{\\partial f}{\\partial x}\\bigg|_y") == "<unsupported>");
  CHECK(parsed("x|_{x=0}") == "<unsupported>");
}

TEST_CASE("partial derivatives are known as fractions and as in the physics package") {
  CHECK(parsed("\\frac{\\partial f}{\\partial x}") == "(∂/∂x f)");
  CHECK(parsed("\\frac{\\partial f}{\\partial x_i}") == "(∂/∂x[i] f)");
  CHECK(parsed("\\frac{\\partial^2 f}{\\partial x^2}") == "(∂/∂x^2 f)");
  CHECK(parsed("\\frac{\\partial^2 f}{\\partial x\\,\\partial y}") == "(∂/∂x∂y f)");
  CHECK(parsed("\\frac{\\partial^2 f}{\\partial x_i\\partial x_j}") == "(∂/∂x[i]∂x[j] f)");
  CHECK(parsed("\\frac{\\partial L}{\\partial\\dot q}") == "(∂/∂dot:q L)");
  CHECK(parsed("\\pdv{f}{x}") == "(∂/∂x f)");
  CHECK(parsed("\\pdv[2]{f}{x}") == "(∂/∂x^2 f)");
  CHECK(parsed("\\pdv{f}{x}{y}") == "(∂/∂x∂y f)");
  CHECK(parsed("\\frac{\\partial f}{dt}") == "<unsupported>");
}

TEST_CASE("a derivative with an index acts on the next factor") {
  CHECK(parsed("\\partial_i f") == "(∂/∂x[i] f)");
  CHECK(parsed("\\partial_t f + a") == "(sum +(∂/∂t f) +a)");
  CHECK(parsed("\\partial_x f\\,\\partial_\\theta g") == "(term (∂/∂x f) (∂/∂\\theta g))");
  CHECK(parsed("\\partial_i A_j\\cdot B_k") == "(term (∂/∂x[i] A[j]) ·B[k])");
  CHECK(parsed("\\partial_i\\frac12 v^2") == "(∂/∂x[i] (term (fraction 1 2) (power v 2)))");
  CHECK(parsed("\\partial_i\\epsilon_{jkl}A_l") == "(∂/∂x[i] (term \\epsilon[j,k,l] A[l]))");
  CHECK(parsed("\\partial_i\\partial_j f") == "(∂/∂x[i] (∂/∂x[j] f))");
  CHECK(parsed("\\partial_i(A_jB_j)") == "(∂/∂x[i] (group (term A[j] B[j])))");
  CHECK(parsed("\\epsilon_{ijk}\\partial_jA_k") == "(term \\epsilon[i,j,k] (∂/∂x[j] A[k]))");
  CHECK(parsed("\\partial_{x_i}f") == "(∂/∂x[i] f)");
  CHECK(parsed("∂_i f") == "(∂/∂x[i] f)");
}

TEST_CASE("`\\partial` is taken as often as a number on its subscript says") {
  CHECK(parsed("\\partial_x^2 f") == "(∂/∂x^2 f)");
  CHECK(parsed("\\partial^2_x f") == "(∂/∂x^2 f)");
  CHECK(parsed("\\partial_t^{2}f + a") == "(sum +(∂/∂t^2 f) +a)");
  CHECK(parsed("\\partial_x^n f") == "(term <unsupported> f)");
  CHECK(parsed("\\partial_{xy}^2 f") == "(term <unsupported> f)");
}

TEST_CASE("`\\partial` acts on a function with its arguments") {
  CHECK(parsed("\\partial_tu(x, t)") == "(∂/∂t (term u (tuple x t)))");
  CHECK(parsed("\\partial_xf(x)") == "(∂/∂x (term f (group x)))");
  CHECK(parsed("\\partial_xf(y)") == "(term <ambiguous-reading> (group y))");
}

TEST_CASE("what `\\partial` cannot be read for is said") {
  CHECK(parsed("\\partial_i^2 f") == "(term <unsupported> f)");
  CHECK(parsed("\\partial V") == "(term <unsupported> V)");
  CHECK(parsed("\\partial_i + a") == "(sum +<unsupported> +a)");
  CHECK(parsed("\\partial_r f") == "(term <ambiguous-reading> f)");
}

TEST_CASE("nabla is a vector among the factors") {
  for (const char* text :
       {"\\nabla", "\\mathbf\\nabla", "\\boldsymbol{\\nabla}", "\\vec\\nabla", "\\vec{\\nabla}", "∇"}) {
    INFO(text);
    CHECK(parsed(text) == "vector:\\nabla");
  }
  CHECK(parsed("\\nabla\\cdot\\mathbf A") == "(term vector:\\nabla ·vector:A)");
  CHECK(parsed("\\nabla^2f") == "(term (power vector:\\nabla 2) f)");
  CHECK(parsed("\\nabla f\\times\\nabla g") == "(term vector:\\nabla f ×vector:\\nabla g)");
}

TEST_CASE("a change of a quantity is one symbol") {
  CHECK(parsed("\\delta\\mathbf A") == "\\delta.vector:A");
  CHECK(parsed("\\delta\\theta\\,\\delta t") == "(term \\delta.\\theta \\delta.t)");
  CHECK(parsed("\\Delta\\mathbf{p}_i^2") == "(power \\Delta.vector:p[i] 2)");
  CHECK(parsed("\\delta\\boldsymbol{\\theta}\\times\\mathbf A") == "(term \\delta.vector:\\theta ×vector:A)");
  CHECK(parsed("\\delta{\\mathbf r}_i") == "\\delta.vector:r[i]");
  CHECK(parsed("\\delta\\dot x") == "\\delta.dot:x");
  CHECK(parsed("\\frac{\\Delta x}{\\Delta t}") == "(fraction \\Delta.x \\Delta.t)");
}

TEST_CASE("a delta with a script or before anything but a letter is a letter") {
  CHECK(parsed("\\delta_{ij}A_j") == "(term \\delta[i,j] A[j])");
  CHECK(parsed("\\delta_2 x") == "(term \\delta[2] x)");
  CHECK(parsed("\\delta(x)") == "(term \\delta (group x))");
  CHECK(parsed("\\Delta + \\delta\\cdot a") == "(sum +\\Delta +(term \\delta ·a))");
  CHECK(parsed("\\delta\\delta x") == "<unsupported>");
}

TEST_CASE("derivatives nested without end are refused without a crash") {
  for (const char* text : {"\\dot", "\\dot{", "\\delta", "\\frac{d}{dt}", "\\partial_i", "d(", "\\dv{t}",
                           "\\left(\\frac{d}{dt}\\right)_S"}) {
    INFO(text);
    CHECK_FALSE(parsed(repeated(text, 20000) + "x").empty());
  }
  CHECK(obstacle("\\dot{" + repeated("\\ddddot{", 60) + "x" + repeated("}", 61)) ==
        "so many dots over a letter are not read");
}
