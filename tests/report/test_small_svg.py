"""The SVG that is kept says what Matplotlib's says."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

from report.small_svg import small_svg

SVG = b"""<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
 <defs><style type="text/css">*{stroke-linejoin: round}</style></defs>
 <g id="patch_1"><path d="M 1.23456 2
L 3 4.5678
" style="fill: #fefefe"/></g>
 <g id="empty_1"/>
 <!-- 12 -->
 <g id="text_1"><text style="font: 9px 'DejaVu Sans'" x="1.005" y="2">0.12345 s</text></g>
 <use transform="scale(0.000123)" style="fill: #fefefe"/>
</svg>"""

NAMESPACE = "{http://www.w3.org/2000/svg}"


def test_places_are_rounded_and_words_and_scales_are_not():
    root = ElementTree.fromstring(small_svg(SVG))
    assert root.find(f".//{NAMESPACE}path").get("d") == "M 1.2 2 L 3 4.6"
    assert root.find(f".//{NAMESPACE}text").text == "0.12345 s"
    assert root.find(f".//{NAMESPACE}use").get("transform") == "scale(0.000123)"


def test_equal_looks_share_a_class_that_the_sheet_defines():
    root = ElementTree.fromstring(small_svg(SVG))
    name = root.find(f".//{NAMESPACE}path").get("class")
    assert root.find(f".//{NAMESPACE}use").get("class") == name
    assert f".{name}{{fill: #fefefe}}" in root.find(f".//{NAMESPACE}style").text


def test_letters_have_a_font_to_fall_back_on():
    assert b"'DejaVu Sans', Verdana, sans-serif" in small_svg(SVG)


def test_empty_groups_names_and_comments_go():
    small = small_svg(SVG)
    assert b"<g/>" not in small and b"patch_1" not in small and b"12 -->" not in small


def test_hover_names_of_groups_become_titles_and_stay_escaped():
    svg = b'<svg><g id="hover: 3 &lt; 4, &quot;x&quot;"><path d="M 1 2"/></g><g id="a"><path/></g></svg>'
    root = ElementTree.fromstring(small_svg(svg))
    assert [title.text for title in root.iter("title")] == ['3 < 4, "x"']
    assert root.find("g/title/../path") is not None
