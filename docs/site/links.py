"""links.py <folder>: checks all links of a built site, to files and to anchors, and that its pages load nothing from elsewhere."""

from html import unescape
from pathlib import Path
import re
import sys
from urllib.parse import unquote, urlsplit

LOADED = re.compile(r'<(?:img|script|iframe|source|video|link)\b[^>]*?\s(?:src|href)="([^"]*)"')
LINKED = re.compile(r'\s(?:href|src)="([^"]*)"')
ANCHOR = re.compile(r'\s(?:id|name)="([^"]*)"')
IN_STYLE = re.compile(r"url\(\s*[\"']?([^\"')]+)|@import\s+[\"']([^\"']+)")


def main(root):
    """Returns what is wrong."""
    pages = {page: page.read_text(encoding="utf-8") for page in sorted(root.rglob("*.html")) if page.is_file()}
    anchors = {page: {unescape(name) for name in ANCHOR.findall(text)} for page, text in pages.items()}
    wrong = []
    for page, text in pages.items():
        place = page.relative_to(root)
        wrong += [f"{place}: loads {link}" for link in LOADED.findall(text) if external(link)]
        wrong += [f"{place}: {link}" for link in set(LINKED.findall(text)) if not leads(root, page, unescape(link), anchors)]
    for style in sorted(root.rglob("*.css")):
        loaded = ("".join(names) for names in IN_STYLE.findall(style.read_text(encoding="utf-8")))
        wrong += [f"{style.relative_to(root)}: loads {link}" for link in loaded if external(link) and "w3.org" not in link]
    print(f"{len(pages)} pages, {sum(len(LINKED.findall(text)) for text in pages.values())} links, {len(wrong)} wrong")
    return wrong


def external(link):
    return link.startswith(("http:", "https:", "//"))


def leads(root, page, link, anchors):
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return True
    target = page if not parts.path else (page.parent / unquote(parts.path)).resolve()
    if not target.is_file() or not target.is_relative_to(root):
        return False
    anchor = parts.fragment
    if target == page and "api" in page.relative_to(root).parts:
        # Dokka links to each overload of a function, and gives all of them one anchor
        return True
    return not anchor or target not in anchors or not anchors[target].isdisjoint({anchor, unquote(anchor)})


if __name__ == "__main__":
    found = main(Path(sys.argv[1]).resolve())
    sys.exit("\n".join(found[:20]) if found else 0)
