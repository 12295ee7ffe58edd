#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the page and the document of derivations/rigid-bodies.md: pictures.sh RIGOR FOLDER. Needs chromium, pdflatex
# and pdftoppm.
set -eu
rigor=$1
folder=$2
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
mkdir -p "$folder"
rm -f "$folder"/*.png

shoot() { # PAGE PICTURE WIDTH HEIGHT [OPTION]
  timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$made/profile" --window-size="$3,$4" --screenshot="$2" ${5:-} "file://$1" >/dev/null 2>&1
}

# opened PAGE SELECTOR: a copy whose step is open and at the top
opened() {
  sed "s|</body>|<script>{const d=document.querySelector('$2');d.open=true;document.documentElement.style.scrollBehavior='auto';d.closest('article').scrollIntoView();window.scrollBy(0,-70)}</script></body>|" "$1"
}

notes=derivations/rigid-bodies.md
"$rigor" report "$notes" --html "$made/page.html" --latex "$made/notes.tex"
shoot "$made/page.html" "$folder/page.png" 1280 1500
opened "$made/page.html" '.step.refuted details' >"$made/opened.html"
shoot "$made/opened.html" "$folder/refuted.png" 1280 900
opened "$made/page.html" 'article[data-text*="(6)"] details.forms' >"$made/forms.html"
shoot "$made/forms.html" "$folder/forms.png" 1280 1300
shoot "$made/opened.html" "$folder/phone.png" 400 800
shoot "$made/page.html" "$folder/dark.png" 1280 900 --blink-settings=preferredColorScheme=0
(cd "$made" && timeout 100 pdflatex -interaction=nonstopmode -halt-on-error notes.tex >/dev/null)
pdftoppm -r 50 -png "$made/notes.pdf" "$folder/document"
ls -l "$folder"
