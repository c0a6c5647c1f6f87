"""Navigation: the lists of links in pages/ are the sections of the site, and the front page has all sections."""

from pathlib import PurePosixPath
import re

# The sections, in their order
SECTIONS = ["start", "library", "strategies", "contract", "reference", "performance", "project"]
FOLDER = PurePosixPath("docs/site/pages")


def add(app, document, source):
    """Appends to the front page the sections, and to a section the pages which its list links to."""
    page = PurePosixPath(document)
    if document == app.config.root_doc:
        entries = [f"/{FOLDER / section}" for section in SECTIONS]
    elif page.parent == FOLDER:
        entries = re.findall(r"^- \[[^\]]*\]\((.*)\.md\)", source[0], re.MULTILINE)
    else:
        return
    if entries:
        source[0] += "\n".join(["", "", "```{toctree}", ":hidden:", "", *entries, "```", ""])


def setup(app):
    app.connect("source-read", add)
    return {"parallel_read_safe": True}
