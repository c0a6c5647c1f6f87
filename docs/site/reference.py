"""API reference: lists packages and their types with links to Dokka's pages, so that the search of the site finds them."""

from base64 import b64encode
import json
from pathlib import Path
import re

from bs4 import BeautifulSoup
from docutils import nodes
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

# What Dokka's pages load with fetch. Browsers forbid this for file://, so that a script has the same content
FETCHED = ["navigation.html", "scripts/pages.json"]

# Browsers forbid these for file:// too, where they are masks
PICTURE = re.compile(r"""url\(["']?(\.\./[^"')]+\.svg)["']?\)""")

# Runs before Dokka's own scripts
OFFLINE = """
(() => {
  const waiting = {};
  window.offline = (name, text) => waiting[name](new Response(text));
  const fetched = window.fetch;
  window.fetch = (url, options) => {
    const name = %s.find((file) => String(url).endsWith(file));
    if (!name) return fetched(url, options);
    return new Promise((resolve, reject) => {
      waiting[name] = resolve;
      const script = document.createElement("script");
      script.src = pathToRoot + name + ".js";
      script.onerror = reject;
      document.head.append(script);
    });
  };
})();
"""


def open_without_server(app):
    """Changes the pages of Dokka so that their navigation, search and icons work when they are opened as files."""
    for folder in sorted(Path(app.outdir, "api").iterdir()):
        for name in FETCHED:
            text = folder.joinpath(name).read_text(encoding="utf-8")
            script = f"offline({json.dumps(name)}, {json.dumps(text)});\n"
            folder.joinpath(name + ".js").write_text(script, encoding="utf-8")
        for style in folder.rglob("*.css"):
            style.write_text(PICTURE.sub(lambda found: inline(style, found), style.read_text(encoding="utf-8")), encoding="utf-8")
        first = folder / "scripts/safe-local-storage_blocking.js"
        with first.open("a", encoding="utf-8") as file:
            file.write(OFFLINE % json.dumps(FETCHED))


def inline(style, found):
    """Returns the picture that a style refers to as part of the style."""
    picture = style.parent.joinpath(found[1])
    return f"url(data:image/svg+xml;base64,{b64encode(picture.read_bytes()).decode()})"


class Api(SphinxDirective):
    """`{api} core` lists what the packages of a module declare."""

    required_arguments = 1

    def run(self):
        root = Path(self.env.app.outdir)
        module = root / "api" / self.arguments[0]
        packages = sorted(module.glob("*/*/index.html"))
        if not packages:
            raise ExtensionError(f"no packages in {module}")
        up = "../" * self.env.docname.count("/")
        found = []
        for file in packages:
            page = BeautifulSoup(file.read_text(encoding="utf-8"), "html.parser")
            url = up + file.relative_to(root).as_posix()
            found.append(package(file.parent.name, url, page))
        return found


def package(name, url, page):
    """Returns a section: the package's name, its description, and what it declares."""
    section = nodes.section("", nodes.title("", "", link(name, url)), ids=[name.replace(".", "-")], names=[name])
    section += [nodes.paragraph("", text(part)) for part in page.select(".cover .paragraph")]
    declared = nodes.definition_list(classes=["api"])
    for row in page.select(".table-row_content .main-subrow"):
        anchor, brief = row.find("a"), row.select_one(".brief")
        target = url.rsplit("/", 1)[0] + "/" + anchor["href"]
        term = nodes.term("", "", link(text(anchor), target, literal=True))
        meaning = nodes.definition("", nodes.paragraph("", text(brief) if brief else ""))
        declared += nodes.definition_list_item("", term, meaning)
    if declared.children:
        section += declared
    return section


def link(title, url, literal=False):
    label = nodes.literal("", title) if literal else nodes.Text(title)
    return nodes.reference("", "", label, refuri=url, internal=True)


def text(tag):
    return " ".join(tag.get_text().split())


def setup(app):
    app.connect("builder-inited", open_without_server)
    app.add_directive("api", Api)
    return {"parallel_read_safe": True}
