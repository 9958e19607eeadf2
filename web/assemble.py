"""Puts the parts of the page into one file: assemble.py PAGE index.html PART..., where @PART@ stands in index.html."""

import sys
from pathlib import Path

page, template, *parts = map(Path, sys.argv[1:])
text = template.read_text(encoding="utf-8")
for part in parts:
    text = text.replace(f"@{part.name}@", part.read_text(encoding="utf-8").replace("</script", "<\\/script").strip())
page.write_text(text, encoding="utf-8")
