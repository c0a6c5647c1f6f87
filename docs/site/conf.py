"""Settings of the documentation site. Its root is the root of the project, so that links between pages are as on GitHub."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

project = "Lazy Z"
extensions = ["myst_parser", "navigation", "sources", "reference"]
root_doc = "README"
include_patterns = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/*.md", "docs/**/*.md", "jmh/README.md", "conformance/corpus/README.md", "integrations/mcp/README.md", "examples/README.md", "examples/*/README.md"]
exclude_patterns = ["**/target/**", "**/build/**"]

# Headings have the anchors that they have on GitHub
myst_heading_anchors = 6
suppress_warnings = ["myst.header"]
highlight_language = "text"

html_theme = "furo"
html_title = "Lazy Z"
html_static_path = ["theme"]
html_css_files = ["site.css"]
html_use_index = False
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
# Summaries of results are loaded with fetch, which browsers forbid for file://
html_show_search_summary = False

