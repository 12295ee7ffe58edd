// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor report --html` as a reader meets it: in a browser that clicks, types and prints.
#include <filesystem>

#include "browser.h"
#include "catch.h"
#include "program.h"

namespace rigor {
namespace {

constexpr const char* hostile_notes = R"(# A slip & more <script>document.title='owned'</script>

## Vectors <img src=x onerror="document.title='owned'"> in 50 % of cases

$$\begin{aligned}
  |\mathbf{A}\times\mathbf{B}|^2
    &= (\varepsilon_{ijk} A_j B_k)(\varepsilon_{ilm} A_l B_m) \\
    &= A_i A_i B_j B_j + A_i B_i A_j B_j
\end{aligned} \tag{<b>6</b>}$$

$$\mathbf{A}\cdot\mathbf{B} = \mathbf{B}\cdot\mathbf{A} \quad\text{</math><script>document.title='owned'</script>}$$

## Wide

$$\mathbf{A}\cdot\mathbf{B} + A_iA_iB_jB_j + A_iA_iB_jB_j + A_iA_iB_jB_j + A_iA_iB_jB_j = \mathbf{B}\cdot\mathbf{A} + 4 A^2B^2 + \mathbf{A}\cdot\mathbf{A} - A^2$$

$$\lim_{x\to 0}\frac{\sin x}{x} = 1 \tag{7}$$
)";

/// Runs in the page: clicks, types, prints, and writes what it sees.
constexpr const char* driver = R"(<script>
window.addEventListener('load', () => {
  const seen = [];
  const say = (name, value) => seen.push(name + '=' + value);
  const all = (selector) => Array.from(document.querySelectorAll(selector));
  const visible = (selector) => all(selector).filter((one) => one.getClientRects().length > 0).length;
  const filter = (kind) => document.querySelector('[data-filter="' + kind + '"]').click();
  const find = (text) => { const field = document.getElementById('find'); field.value = text; field.dispatchEvent(new Event('input')); };
  say('errors', window.seenErrors.length + window.seenErrors.join());
  say('title-is-owned', document.title === 'owned');
  say('requests', performance.getEntriesByType('resource').length);
  say('scripts', all('script').length);
  say('images', all('img').length);
  say('math', all('math').length > 5);
  say('steps', visible('.step'));
  filter('refuted'); say('refuted', visible('.step')); say('refuted-equations', visible('article.eq'));
  say('pressed', all('[aria-pressed="true"]').map((one) => one.dataset.filter).join());
  say('headings-of-refuted', visible('main h2'));
  filter('attention'); say('attention', visible('.step')); say('counted', document.getElementById('shown').textContent);
  filter('all'); find('lim'); say('found', visible('.step'));
  find('nowhere'); say('found-nothing', visible('.step') + ' ' + visible('.none'));
  find('WIDE'); say('found-by-heading', visible('.step'));
  find(''); say('all-again', visible('.step'));
  const proved = document.querySelector('.step.proved details');
  say('closed-at-first', proved.open);
  proved.querySelector('summary').click(); say('open-on-click', proved.open);
  say('shows-route', proved.querySelector('.details').textContent.includes('component normal form'));
  say('summary-has-focus', (proved.querySelector('summary').focus(), document.activeElement === proved.querySelector('summary')));
  for (const one of all('.step > details')) one.open = false;
  window.dispatchEvent(new Event('beforeprint'));
  say('open-in-print', all('.step.attention > details[open]').length + ' ' + all('.step > details[open]').length);
  window.dispatchEvent(new Event('afterprint'));
  say('closed-after-print', all('.step > details[open]').length);
  const phone = document.createElement('iframe');
  phone.style.width = '360px';
  phone.style.height = '800px';
  phone.srcdoc = window.pageText;
  phone.addEventListener('load', () => {
    const root = phone.contentDocument.documentElement;
    say('phone-overflows', root.scrollWidth > root.clientWidth || root.clientWidth > 360);
    const wide = Array.from(phone.contentDocument.querySelectorAll('.display > .shown')).filter((box) => box.scrollWidth > box.clientWidth);
    say('scrolls-inside', wide.length > 0 && wide.every((box) => getComputedStyle(box).overflowX === 'auto' && box.tabIndex === 0));
    const result = document.createElement('pre');
    result.id = 'result';
    result.textContent = seen.join('\n') + '\n';
    document.body.replaceChildren(result);
  });
  document.body.append(phone);
});
</script>
)";

constexpr const char* watch = R"(<script>
window.seenErrors = [];
window.addEventListener('error', (event) => window.seenErrors.push(event.message), true);
console.error = (...words) => window.seenErrors.push(words.join(' '));
</script>
)";

/// The page with the driver in it; the text of the page itself is kept for the phone.
std::string driven(const std::string& page) {
  std::string text = page;
  std::string literal;
  for (const char each : page) {
    if (each == '`' || each == '\\' || each == '$') literal += '\\';
    literal += each;
    if (each == '<') literal += "${''}";  // no tag of the copy ends the script
  }
  text.insert(text.find("<style>"), watch);
  text.insert(text.rfind("</body>"), "<script>window.pageText = `" + literal + "`;</script>\n" + driver);
  return text;
}

std::string page_of(const Folder& folder, const std::string& name, const std::string& notes) {
  write_file(folder.path(name), notes);
  const Outcome outcome =
      run_program({"report", folder.path(name), "--html", folder.path("page.html"), "--no-forms"});
  INFO(outcome.text);
  REQUIRE(outcome.code <= 2);
  return text_of(folder.path("page.html"));
}

}  // namespace

TEST_CASE("a page asks nothing of the network and holds nothing but its own script") {
  const Folder folder;
  const std::string page = page_of(folder, "a<b>&\"c'%.md", hostile_notes);
  CHECK(page.find("http") == std::string::npos);
  CHECK(page.find("src=\"") == std::string::npos);
  CHECK(page.find("@import") == std::string::npos);
  CHECK(page.find("<script>document.title") == std::string::npos);
  CHECK(page.find("<img") == std::string::npos);
  CHECK(page.find("<b>6</b>") == std::string::npos);
  CHECK(page.find("50 % of cases") != std::string::npos);
  CHECK(page.find("href=\"a%3Cb%3E%26%22c%27%25.md\"") != std::string::npos);
}

TEST_CASE("a display of an included file has its step below it") {
  const Folder folder;
  write_file(folder.path("part.tex"),
             "\\[ \\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A} \\]\n");
  const std::string page = page_of(folder, "n.tex", "\\[ 1 = 1 \\]\n\\input{part}\n\\[ 2 = 2 \\]\n");
  CHECK(page.find("says nothing that can be checked") == std::string::npos);
  CHECK(page.find("class=\"eq said\"") == std::string::npos);
  CHECK(page.find("3 steps, and nothing needs attention.") != std::string::npos);
}

TEST_CASE("a cyclic image is told from its statement and has a proof only where it is proved") {
  const Folder folder;
  const std::string page = page_of(folder, "n.md",
                                   "<!-- rigor: scalar a --><!-- rigor: for all a -->"
                                   "<!-- rigor: let \\mathbf{p} = (a, 0, 0) -->\n\n"
                                   "$$p_y = 0 \\qquad\\text{and cyclic}$$\n");
  const std::size_t first = page.find("cyclic image 1 of <math");
  const std::size_t second = page.find("cyclic image 2 of <math");
  REQUIRE(first != std::string::npos);
  REQUIRE(second != std::string::npos);
  CHECK(page.substr(0, first).find("in small steps") != std::string::npos);
  CHECK(page.substr(first, second - first).find("in small steps") != std::string::npos);
  CHECK(page.substr(first, second - first).find("class=\"step refuted") != std::string::npos);
  CHECK(page.substr(second).find("in small steps") == std::string::npos);
  const std::string document = run_program({"report", folder.path("n.md"), "--latex", "-"}).text;
  CHECK(document.find("cyclic image 1 of ") != std::string::npos);
  CHECK(document.find("cyclic image 2 of ") != std::string::npos);
}

TEST_CASE("page and document show a problem of the file as a whole") {
  const Folder folder;
  const std::string page = page_of(folder, "n.md", "$$1 = 1$$\n\n<!-- rigor: nonsense x -->\n");
  CHECK(page.find("nothing needs attention") == std::string::npos);
  CHECK(page.find("but there is <b>1 problem with the notes as a whole</b>.") != std::string::npos);
  const Outcome document = run_program({"report", folder.path("n.md"), "--latex", "-"});
  CHECK(document.code == 1);
  CHECK(document.text.find("1 problem with the notes as a whole.") != std::string::npos);
  CHECK(document.text.find("error: \\texttt{nonsense} is not a directive") != std::string::npos);
}

TEST_CASE("how a row was read is folded away below it, in the words of `rigor read`") {
  const Folder folder;
  const std::string page = page_of(
      folder, "n.md",
      "<!-- rigor: vector \\mathbf{L} -->\n\n$$p = L_i L_i$$\n\nHence $$2p = 2L^2$$\n\n$$3 \\odot p = 1$$\n");
  CHECK(page.find("<details class=\"reading\" open") == std::string::npos);
  const std::string read = run_program({"read", folder.path("n.md")}).text;
  for (const char* words : {"definition of its left side", "summed since it stands twice in a term",
                            "identity: to be proved for all values of its letters; announced by ",
                            "vector \\mathbf{L}", "in line 1"}) {
    INFO(words);
    CHECK(read.find(words) != std::string::npos);
    CHECK(page.find(words, page.find("class=\"reading\"")) != std::string::npos);
  }
  std::size_t readings = 0;
  for (std::size_t at = page.find("class=\"reading\""); at != std::string::npos;
       at = page.find("class=\"reading\"", at + 1))
    ++readings;
  CHECK(readings == 3);
  CHECK(page.find("<dt>rests on</dt><dd><p>definition <math>") != std::string::npos);
}

TEST_CASE("the same notes make the same page") {
  const Folder folder;
  const std::string first = page_of(folder, "n.md", hostile_notes);
  CHECK(first == page_of(folder, "n.md", hostile_notes));
}

TEST_CASE("in a browser the page filters, opens, prints and fits a phone") {
  if (!is_there("chromium")) return;
  const Folder folder;
  const std::string page = page_of(folder, "n.md", hostile_notes);
  write_file(folder.path("driven.html"), driven(page));
  const std::string dom =
      chromium("--virtual-time-budget=8000 --window-size=1280,1000 --dump-dom", folder.path("driven.html"));
  const std::size_t begin = dom.find("<pre id=\"result\">");
  INFO(dom.substr(0, 2000));
  REQUIRE(begin != std::string::npos);
  const std::string result = "\n" + dom.substr(begin + 17, dom.find("</pre>") - begin - 17);
  INFO(result);
  for (const char* line : {"errors=0",
                           "title-is-owned=false",
                           "requests=0",
                           "images=0",
                           "math=true",
                           "steps=5",
                           "refuted=1",
                           "refuted-equations=1",
                           "pressed=refuted",
                           "headings-of-refuted=1",
                           "attention=3",
                           "counted=3 of 5 steps",
                           "found=1",
                           "found-nothing=0 1",
                           "found-by-heading=2",
                           "all-again=5",
                           "closed-at-first=false",
                           "open-on-click=true",
                           "shows-route=true",
                           "summary-has-focus=true",
                           "open-in-print=3 3",
                           "closed-after-print=0",
                           "phone-overflows=false",
                           "scrolls-inside=true"}) {
    INFO(line);
    CHECK(result.find("\n" + std::string(line) + "\n") != std::string::npos);
  }
}

TEST_CASE("a printed page has the sample of what is refuted and no buttons") {
  if (!is_there("chromium") || !is_there("pdftotext")) return;
  const Folder folder;
  static_cast<void>(page_of(folder, "n.md", hostile_notes));
  static_cast<void>(chromium("--no-pdf-header-footer --print-to-pdf='" + folder.path("page.pdf") + "'",
                             folder.path("page.html")));
  const std::string text = printed_by("pdftotext -layout '" + folder.path("page.pdf") + "' -");
  CHECK(text.find("left is 0, right is 2") != std::string::npos);
  CHECK(text.find("needs attention 3") == std::string::npos);
  CHECK(text.find("3 need attention") != std::string::npos);
}

TEST_CASE("a printed equation with more steps than a page holds begins below what stands before it") {
  if (!is_there("chromium") || !is_there("pdftotext")) return;
  const Folder folder;
  std::string notes = "# Long\n\n$$60";
  for (int k = 59; k > 0; --k) notes += " = " + std::to_string(k) + " + " + std::to_string(60 - k);
  static_cast<void>(page_of(folder, "n.md", notes + "$$\n"));
  static_cast<void>(chromium("--no-pdf-header-footer --print-to-pdf='" + folder.path("page.pdf") + "'",
                             folder.path("page.html")));
  const std::string first =
      printed_by("pdftotext -f 1 -l 1 -raw '" + folder.path("page.pdf") + "' - | grep -c proved");
  CHECK(std::stoi(first) > 5);
  CHECK(std::stoi(first) < 59);
}

TEST_CASE("wrong use of report says what is wrong") {
  const Folder folder;
  write_file(folder.path("n.md"), "$$1 = 1$$\n");
  CHECK(run_program({"report", folder.path("n.md")}).code == 64);
  CHECK(run_program({"report", "--html", "x.html"}).code == 64);
  CHECK(run_program({"report", folder.path("n.md"), "--html", "x", "--latex", "x"}).code == 64);
  CHECK(run_program({"report", folder.path("none.md"), "--html", folder.path("p.html")}).code == 66);
  CHECK_FALSE(std::filesystem::exists(folder.path("p.html")));
  const Outcome unwritable = run_program({"report", folder.path("n.md"), "--html", folder.path("no/p.html")});
  CHECK(unwritable.code == 66);
  CHECK(unwritable.text.find("cannot be written: no such file or directory") != std::string::npos);
}

TEST_CASE("no output takes the place of notes or of the other output") {
  const Folder folder;
  const std::string notes = "\\[ 1 = 1 \\]\n\\input{part}\n";
  const std::string path = folder.path("n.tex");
  write_file(path, notes);
  write_file(folder.path("part.tex"), "\\[ 2 = 2 \\]\n");
  write_file(folder.path("n.rigor"), "claim 3 = 3\n");
  std::filesystem::create_symlink(path, folder.path("link"));
  for (const std::string& output :
       {path, folder.path("./n.tex"), folder.path("link"), folder.path("part.tex"), folder.path("n.rigor")}) {
    for (const char* option : {"--html", "--latex"}) {
      const Outcome outcome = run_program({"report", path, option, output, "--no-forms"});
      INFO(output << outcome.text);
      CHECK(outcome.code == 64);
      CHECK(outcome.text.find("would overwrite") != std::string::npos);
    }
  }
  CHECK(text_of(path) == notes);
  CHECK(text_of(folder.path("part.tex")) == "\\[ 2 = 2 \\]\n");
  CHECK(text_of(folder.path("n.rigor")) == "claim 3 = 3\n");
  const Outcome twice =
      run_program({"report", path, "--html", folder.path("x.out"), "--latex", folder.path("./x.out")});
  CHECK(twice.code == 64);
  CHECK(twice.text.find("are one file") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.path("x.out")));
  CHECK(run_program({"report", path, "--html", "/dev/null", "--latex", "/./dev/null", "--no-forms"}).code ==
        0);
}

TEST_CASE("a missing file does not keep the others from the page") {
  const Folder folder;
  write_file(folder.path("n.md"), "$$1 = 1$$\n");
  const Outcome outcome = run_program({"report", folder.path("n.md"), folder.path("none.md"), "--html",
                                       folder.path("p.html"), "--latex", folder.path("d.tex"), "--no-forms"});
  CHECK(outcome.code == 66);
  CHECK(outcome.text.find("none.md") != std::string::npos);
  const std::string page = text_of(folder.path("p.html"));
  CHECK(page.find("1 step: none needs attention, but there is <b>1 problem") != std::string::npos);
  CHECK(page.find("no such file") != std::string::npos);
  CHECK(text_of(folder.path("d.tex")).find("no such file") != std::string::npos);
}

TEST_CASE("notes without an equation make a page that says so") {
  const Folder folder;
  const std::string page = page_of(folder, "n.md", "Only words.\n");
  CHECK(page.find("There is no step to check; 1 warning about the notes as a whole.") != std::string::npos);
  CHECK(page.find("no displayed equation was found") != std::string::npos);
}

TEST_CASE("the page can go to the output") {
  const Folder folder;
  write_file(folder.path("n.md"), "$$\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{B}\\cdot\\mathbf{A}$$\n");
  const Outcome outcome = run_program({"report", folder.path("n.md"), "--html", "-", "--no-forms"});
  CHECK(outcome.code == 0);
  CHECK(outcome.text.starts_with("<!DOCTYPE html>"));
  CHECK(outcome.text.ends_with("</html>\n"));
}

TEST_CASE("forms are drawn on the page with their advice") {
  const Folder folder;
  write_file(folder.path("n.md"),
             "$$|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2 B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2$$\n");
  const Outcome outcome = run_program({"report", folder.path("n.md"), "--html", "-"});
  CHECK(outcome.code == 0);
  CHECK(outcome.text.find("Compute A") != std::string::npos);
  CHECK(outcome.text.find("<svg") != std::string::npos);
  CHECK(outcome.text.find("http") == std::string::npos);
}

}  // namespace rigor
