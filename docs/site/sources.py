"""Links that leave the documentation: to a source file or a folder of the project, whose content becomes a page of the site."""

from base64 import b64encode
from pathlib import Path
import subprocess

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound
from sphinx import addnodes
from sphinx.errors import ExtensionError
from sphinx.transforms import SphinxTransform

LINKS = (addnodes.download_reference, addnodes.pending_xref)
PICTURES = {".png", ".jpg", ".gif"}
# Too much to read: the site has them as files
DATA = PICTURES | {".json"}


class SourceLinks(SphinxTransform):
    """Turns links to files and folders of the project into links to their pages."""

    default_priority = 10

    def apply(self, **_):
        for node in list(self.document.findall(lambda it: isinstance(it, LINKS))):
            path = target(self.app, self.env.docname, node)
            if path is None:
                continue
            up = "../" * self.env.docname.count("/")
            link = nodes.reference("", "", *node.children, refuri=f"{up}source/{path}.html", internal=True)
            node.replace_self(link)
            linked(self.env).setdefault(self.env.docname, set()).add(path)


def target(app, document, node):
    """Returns the path, from the root, of the file or folder that a link leads to; None if it is no text of the project."""
    root = Path(app.srcdir)
    path = root.joinpath(document).parent.joinpath(node["reftarget"]).resolve()
    if isinstance(node, addnodes.pending_xref) and not path.is_dir():
        return None
    if not path.is_relative_to(root) or path.suffix in DATA:
        return None
    return path.relative_to(root).as_posix()


def linked(environment):
    """Returns, by page, the paths that it links to."""
    if not hasattr(environment, "linked_sources"):
        environment.linked_sources = {}
    return environment.linked_sources


def forget(_, environment, document):
    linked(environment).pop(document, None)


def pages(app):
    """Yields a page for each linked file and folder, and for the files of linked folders."""
    todo = sorted(set().union(*linked(app.env).values()))
    done = set()
    while todo:
        path = todo.pop(0)
        if path in done:
            continue
        done.add(path)
        file = Path(app.srcdir, path)
        if file.is_dir():
            files = tracked(app.srcdir, path)
            todo += files
            body = listing(path, files)
        elif file.suffix in PICTURES:
            body = f'<img src="data:image/{file.suffix[1:]};base64,{b64encode(file.read_bytes()).decode()}" alt="{path}">'
        else:
            body = highlighted(file)
        yield f"source/{path}", {"title": path, "body": f"<h1>{path}</h1>{body}"}, "page.html"


def tracked(root, folder):
    """Returns the files of a folder that belong to the project."""
    command = ["git", "ls-files", "--", folder]
    run = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    if not run.stdout:
        raise ExtensionError(f"{' '.join(command)} in {root}: {run.stderr or 'no files'}")
    return run.stdout.splitlines()


def listing(folder, files):
    up = "../" * folder.count("/")
    items = (f'<li><a href="{up}{file}.html">{file[len(folder) + 1:]}</a></li>' for file in files)
    return f"<ul>{''.join(items)}</ul>"


def highlighted(file):
    try:
        lexer = get_lexer_for_filename(file.name)
    except ClassNotFound:
        lexer = TextLexer()
    return highlight(file.read_text(encoding="utf-8"), lexer, HtmlFormatter())


def setup(app):
    app.add_transform(SourceLinks)
    app.connect("env-purge-doc", forget)
    app.connect("html-collect-pages", pages)
    return {"parallel_read_safe": False}
