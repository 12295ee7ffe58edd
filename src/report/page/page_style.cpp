// SPDX-License-Identifier: GPL-3.0-or-later
// How the page looks. Colours have a contrast of at least 4.5 : 1 on their ground, in light and in dark; a
// mark is never told by its colour alone.
#include "report/page/page_parts.h"

namespace rigor {

std::string_view page_style() {
  return R"css(:root {
  --ground: #fdfdfb; --card: #ffffff; --ink: #1d2126; --soft: #595f69; --rule: #dfe1e4; --wash: #f2f3f1;
  --link: #0b57a4; --focus: #0b57a4;
  --proved: #1a6b3c; --refuted: #b3261e; --given: #595f69; --definition: #3b5b92; --open: #8a5300;
  --attention-wash: #fdf1ef; --open-wash: #fcf5e8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ground: #14171a; --card: #1b1f23; --ink: #e4e6e8; --soft: #a3aab3; --rule: #343a41; --wash: #22272c;
    --link: #8ab8f0; --focus: #8ab8f0;
    --proved: #7fcf9c; --refuted: #ff9b90; --given: #a3aab3; --definition: #9dbcf2; --open: #ecb765;
    --attention-wash: #2d1d1c; --open-wash: #2a2418;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; scroll-padding-top: 5rem; }
body { margin: 0; background: var(--ground); color: var(--ink);
  font: 1rem/1.55 system-ui, -apple-system, "Segoe UI", "Noto Sans", "DejaVu Sans", sans-serif; overflow-wrap: anywhere; }
math { font-family: "Latin Modern Math", "STIX Two Math", "Cambria Math", math; font-size: 1.12em; }
a { color: var(--link); text-underline-offset: .15em; }
:focus-visible { outline: 3px solid var(--focus); outline-offset: 2px; border-radius: 3px; }
main:focus { outline: none; }
[hidden] { display: none !important; }
code, pre, .path { font-family: ui-monospace, "SF Mono", "DejaVu Sans Mono", monospace; font-size: .85em; }
pre { overflow-x: auto; margin: .3rem 0; }
p { margin: .35rem 0; }
.quiet { color: var(--soft); }
.skip { position: absolute; left: -99rem; }
.skip:focus { left: 1rem; top: 1rem; background: var(--card); padding: .5rem 1rem; z-index: 3; }

.top { max-width: 76rem; margin: 0 auto; padding: 2.5rem 1.5rem 1rem; }
.kicker { margin: 0; color: var(--soft); font-size: .85rem; letter-spacing: .04em; }
h1 { font-size: clamp(1.6rem, 5vw, 2.3rem); line-height: 1.15; margin: .2rem 0 .3rem; letter-spacing: -.01em; font-weight: 650; }
.paths { margin: 0 0 1rem; font-family: ui-monospace, "SF Mono", "DejaVu Sans Mono", monospace; font-size: .85rem; }
.lead { font-size: 1.2rem; }
.lead b { color: var(--refuted); }
.legend { display: grid; grid-template-columns: repeat(auto-fill, minmax(15.5rem, 1fr)); gap: .7rem 1.5rem; margin: 1.4rem 0 0; font-size: .85rem; }
.legend dt { font-weight: 650; }
.legend dd { margin: 0; color: var(--soft); line-height: 1.4; }
.sign { display: inline-block; min-width: 1.25em; font-weight: 700; }
.proved .sign, .proved dt { color: var(--proved); }
.refuted .sign, .refuted dt, button.attention .sign { color: var(--refuted); }
.definition .sign, .definition dt { color: var(--definition); }
.given .sign, .skipped .sign { color: var(--given); }
.undecided .sign, .not-understood .sign, .undecided dt, .not-understood dt, .warning .sign { color: var(--open); }

.controls { position: sticky; top: 0; z-index: 2; background: var(--ground); border-bottom: 1px solid var(--rule);
  padding: .55rem max(1.5rem, calc((100vw - 76rem) / 2 + 1.5rem)); display: flex; flex-wrap: wrap; gap: .5rem 1.25rem; align-items: center; }
.buttons { display: flex; flex-wrap: wrap; gap: .35rem; }
button { font: inherit; font-size: .85rem; line-height: 1.2; color: inherit; background: var(--card); border: 1px solid var(--rule);
  border-radius: 99px; padding: .4rem .75rem; cursor: pointer; min-height: 2rem; }
button:hover { border-color: var(--soft); }
button[aria-pressed="true"] { background: var(--ink); color: var(--ground); border-color: var(--ink); }
button[aria-pressed="true"] .sign { color: inherit; }
.search { display: flex; gap: .5rem; align-items: center; flex: 1 1 16rem; font-size: .85rem; }
input { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--soft); border-radius: 6px; padding: .35rem .6rem; min-width: 0; flex: 1 1 8rem; max-width: 20rem; }
output { color: var(--soft); white-space: nowrap; }

.page { max-width: 76rem; margin: 0 auto; padding: 0 1.5rem 4rem; }
.contents { font-size: .85rem; margin: 1rem 0; }
.contents summary { cursor: pointer; font-weight: 650; padding: .2rem 0; }
.contents ul { list-style: none; margin: .2rem 0 0; padding: 0; }
.contents li { margin: 0; }
.contents a { display: block; padding: .22rem .5rem; color: var(--soft); text-decoration: none; border-left: 2px solid var(--rule); line-height: 1.35; }
.contents a:hover { color: var(--link); border-color: var(--link); }
.contents .l2 a { padding-left: 1rem; } .contents .l3 a { padding-left: 1.75rem; }
@media (min-width: 66rem) {
  .page { display: grid; grid-template-columns: 15rem minmax(0, 1fr); gap: 3rem; align-items: start; }
  .page:not(:has(nav)) { grid-template-columns: minmax(0, 1fr); }
  .contents { position: sticky; top: 4.5rem; max-height: calc(100vh - 6rem); overflow-y: auto; margin-top: 2.2rem; }
}
main { min-width: 0; }
main h2, main h3, main h4, main h5, main h6 { line-height: 1.25; margin: 2.4rem 0 .8rem; font-weight: 650; }
main h2 { font-size: 1.4rem; } main h3 { font-size: 1.15rem; } main h4, main h5, main h6 { font-size: 1rem; }
.whole h3 { margin-top: .2rem; }

.eq { background: var(--card); border: 1px solid var(--rule); border-radius: 8px; margin: 0 0 1rem; overflow: hidden; }
.whole { padding: .6rem 1rem; }
.display { display: flex; align-items: center; gap: .75rem; padding: .85rem 1rem .7rem; }
.shown { overflow-x: auto; overflow-y: hidden; padding: .15rem 0; max-width: 100%; }
.display .shown { flex: 1 1 auto; min-width: 0; }
.shown math[display="block"] { width: max-content; min-width: 100%; }
.details .shown math[display="block"] { width: max-content; min-width: 0; margin: 0; }
.tag { flex: none; color: var(--soft); }
.said { background: var(--ground); border-style: dashed; }
.said + .said { margin-top: -.6rem; }
.said .step > details { border-top: 0; }
.nothing { padding: 0 1rem .3rem; margin: 0; font-size: .8rem; }
.steps { list-style: none; margin: 0; padding: 0; }
.step > details, .forms { border-top: 1px solid var(--rule); }
summary { cursor: pointer; }
.step summary, .forms > summary { display: flex; align-items: baseline; gap: .75rem; padding: .42rem 1rem; list-style: none; font-size: .85rem; }
.step summary::-webkit-details-marker, .forms > summary::-webkit-details-marker { display: none; }
.step summary::after, .forms > summary::after { content: "+"; margin-left: auto; color: var(--soft); flex: none; font-size: 1.1rem; line-height: 1; }
.step details[open] > summary::after, .forms[open] > summary::after { content: "−"; }
.step summary:hover, .forms > summary:hover { background: var(--wash); }
.step summary:focus-visible, .forms > summary:focus-visible { outline-offset: -3px; }
.mark { flex: none; width: 9.5rem; font-weight: 600; }
.step.proved .mark { color: var(--proved); } .step.refuted .mark { color: var(--refuted); } .step.definition .mark { color: var(--definition); }
.step.given .mark, .step.skipped .mark, .forms .mark { color: var(--given); } .step.undecided .mark, .step.not-understood .mark { color: var(--open); }
.step.expected .mark { font-weight: 400; }
.what { min-width: 0; flex: 0 1 auto; overflow-x: auto; overflow-y: hidden; }
.what.math { padding: .1rem 0; }
.what math, dd.math math { font-size: 1.05em; }
.step.attention > details { background: var(--attention-wash); box-shadow: inset 4px 0 0 var(--refuted); }
.step.attention.undecided > details, .step.attention.not-understood > details { background: var(--open-wash); box-shadow: inset 4px 0 0 var(--open); }
.details { padding: .2rem 1rem .9rem; font-size: .9rem; }
.step .reading { margin: .4rem 0 0; border-top: 1px solid var(--rule); }
.step .reading > summary { padding: .3rem 0; color: var(--soft); }
.reading i { font-style: normal; color: var(--soft); }
dl { margin: .3rem 0 0; }
.row { display: grid; grid-template-columns: 8.25rem minmax(0, 1fr); gap: .1rem 2rem; padding: .3rem 0; }
.row + .row { border-top: 1px solid var(--rule); }
.row dt { color: var(--soft); }
.row dd { margin: 0; min-width: 0; overflow-x: auto; overflow-y: hidden; }
.row ul { margin: 0; padding: 0; list-style: none; }
.row p { margin: 0 0 .2rem; }
.values { display: flex; flex-wrap: wrap; gap: .1rem 1.75rem; }
.row ol.small { margin: 0; padding: 0; list-style: none; }
.small li { display: flex; flex-wrap: wrap; align-items: baseline; gap: 0 1.5rem; padding: .15rem 0; }
.small li + li { padding-left: 1.25rem; }
.small .math { overflow-x: auto; overflow-y: hidden; max-width: 100%; padding: .1rem 0; }
.rule { color: var(--soft); font-size: .85rem; margin-left: auto; text-align: right; }
.particle { color: var(--soft); }
.plot { margin: .8rem 0 0; background: #fff; border-radius: 6px; padding: .5rem; overflow-x: auto; }
.plot svg { display: block; max-width: 100%; height: auto; min-width: 26rem; margin: 0 auto; }
.struck { text-decoration: line-through; } .framed { border: 1px solid currentColor; padding: .2em; }
.none { color: var(--soft); padding: 2rem 0; }

@media (max-width: 40rem) {
  .top { padding: 1.5rem 1rem .5rem; } .page { padding: 0 .75rem 3rem; } .controls { position: static; padding: .6rem 1rem; }
  .display { padding: .5rem .75rem; flex-wrap: wrap; gap: 0; } .display .shown { flex-basis: 100%; }
  .tag { order: -1; flex: 1 0 100%; text-align: right; font-size: .85rem; line-height: 1; }
  .step summary, .forms > summary, .details { padding-left: .75rem; padding-right: .75rem; }
  .legend { grid-template-columns: 1fr; gap: .45rem; }
  .step summary { flex-wrap: wrap; gap: .1rem .75rem; position: relative; padding-right: 2.25rem; }
  .step summary::after { position: absolute; right: .75rem; top: .42rem; }
  .mark { width: auto; } .what { flex-basis: 100%; }
  .row { grid-template-columns: 1fr; } button { min-height: 2.5rem; }
}
@media print {
  :root { --ground: #fff; --card: #fff; --ink: #000; --soft: #444; --rule: #bbb; --wash: #fff; --attention-wash: #fff; --open-wash: #fff;
    --proved: #14532d; --refuted: #9b1c15; --given: #444; --definition: #2b4676; --open: #6b4000; --link: #000; }
  body { font-size: 9.5pt; } .top, .page { max-width: none; padding-left: 0; padding-right: 0; }
  .page { display: block; } .controls, .contents, .skip, .forms:not([open]) { display: none !important; }
  .step summary::after, .forms > summary::after { content: none; }
  .display, summary, .row, .small li { break-inside: avoid; } .display, .step details[open] > summary, main h2, main h3, main h4 { break-after: avoid; }
  .eq { overflow: visible; } .shown, .what, .row dd { overflow: visible; }
  .display math { font-size: 10pt; }
}
)css";
}

}  // namespace rigor
