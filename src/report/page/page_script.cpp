// SPDX-License-Identifier: GPL-3.0-or-later
// What the page does: filters, and what is opened for print. Without it everything is shown.
#include "report/page/page_parts.h"

namespace rigor {

std::string_view page_script() {
  return R"js((() => {
  'use strict';
  const all = (selector) => Array.from(document.querySelectorAll(selector));
  const buttons = all('[data-filter]');
  const field = document.getElementById('find');
  const output = document.getElementById('shown');
  const blocks = all('#equations > *');
  const equations = all('article.eq');
  const none = document.querySelector('.none');
  const total = all('.step').length;
  let kind = 'all';

  const showHeadings = () => {
    // a heading stays if something below it does, up to the next heading that is not deeper
    const deeper = [];
    for (let k = blocks.length - 1; k >= 0; --k) {
      const block = blocks[k];
      if (block.matches('.eq') && !block.hidden) deeper.length = 0, deeper.push(Infinity);
      if (block.dataset.level === undefined) continue;
      const level = Number(block.dataset.level);
      const used = deeper.some((below) => below > level);
      block.hidden = kind !== 'all' || field.value.trim() !== '' ? !used : false;
      deeper.length = 0;
      if (used) deeper.push(level);
    }
  };

  const apply = () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const equation of equations) {
      const fits = words.every((word) => equation.dataset.text.includes(word));
      const steps = Array.from(equation.querySelectorAll('.step'));
      let any = kind === 'all';
      for (const step of steps) {
        const wanted = kind === 'all' || step.dataset.kinds.split(' ').includes(kind);
        step.hidden = !wanted;
        any = any || wanted;
        if (wanted && fits) ++shown;
      }
      equation.hidden = !fits || !any;
    }
    for (const whole of all('.whole')) whole.hidden = words.length > 0 || !['all', 'attention', 'warning'].includes(kind);
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.dataset.filter === kind));
    showHeadings();
    output.textContent = `${shown} of ${total} steps`;
    none.hidden = equations.some((equation) => !equation.hidden);
  };

  for (const button of buttons) button.addEventListener('click', () => { kind = button.dataset.filter; apply(); });
  field.addEventListener('input', apply);
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === '/' && document.activeElement !== field) { event.preventDefault(); field.focus(); }
    if (event.key === 'Escape' && document.activeElement === field) { field.value = ''; apply(); }
  });

  // what scrolls can be reached by the keyboard
  const reach = () => {
    for (const box of all('.display > .shown, .details .shown')) {
      if (box.scrollWidth > box.clientWidth + 1) { box.tabIndex = 0; box.setAttribute('role', 'region'); box.setAttribute('aria-label', 'equation'); }
      else { box.removeAttribute('tabindex'); box.removeAttribute('role'); box.removeAttribute('aria-label'); }
    }
  };
  reach();
  window.addEventListener('resize', reach);

  if (window.matchMedia('(max-width: 66rem)').matches) for (const list of all('.contents > details')) list.open = false;

  let opened = [];
  window.addEventListener('beforeprint', () => {
    opened = all('.step.attention > details:not([open])');
    for (const details of opened) details.open = true;
  });
  window.addEventListener('afterprint', () => { for (const details of opened) details.open = false; });

  document.querySelector('.controls').hidden = false;
  apply();
})();
)js";
}

}  // namespace rigor
