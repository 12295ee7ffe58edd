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

# opened PAGE SELECTOR: a copy whose step is open, and the first thing below the filters
opened() {
  sed "s|</body>|<script>{const d=document.querySelector('$2');d.open=true;let b=d.closest('article').previousElementSibling;while(b){const o=b;b=b.previousElementSibling;o.remove()}}</script></body>|" "$1"
}

# bare PAGE: a copy without its head and contents
bare() {
  sed 's|</style>|.top,nav{display:none}.page.page{display:block;padding-top:1rem}</style>|' "$1"
}

notes=derivations/rigid-bodies.md
"$rigor" report "$notes" --html "$made/page.html" --latex "$made/notes.tex"
shoot "$made/page.html" "$folder/page.png" 1280 1500
opened "$made/page.html" '.step.refuted details' >"$made/opened.html"
bare "$made/opened.html" >"$made/refuted.html"
shoot "$made/refuted.html" "$folder/refuted.png" 1100 640
opened "$made/page.html" 'article[data-text*="(6)"] details.forms' >"$made/forms.html"
bare "$made/forms.html" >"$made/bare.html"
shoot "$made/bare.html" "$folder/forms.png" 1100 1500
shoot "$made/opened.html" "$folder/phone.png" 400 1500
shoot "$made/page.html" "$folder/dark.png" 1280 900 --blink-settings=preferredColorScheme=0
(cd "$made" && timeout 100 pdflatex -interaction=nonstopmode -halt-on-error notes.tex >/dev/null)
pdftoppm -r 50 -png -singlefile -f 2 -l 2 "$made/notes.pdf" "$folder/document"
ls -l "$folder"
