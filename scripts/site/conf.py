"""Sphinx's settings for the site and the manual; scripts/site/build.py lays out the pages and runs it."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

project = "fabricsh"
version = release = os.environ["FABRICSH_SITE_VERSION"]
copyright = "the fabricsh authors"
extensions = ["myst_parser", "pages"]
source_suffix = {".md": "markdown"}
exclude_patterns = []
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
html_math_renderer = "katex"
html_theme = "furo"
html_title = f"fabricsh {release}"
html_static_path = ["static", os.environ["FABRICSH_SITE_STATIC"]]
html_show_sphinx = False
html_show_sourcelink = False
html_copy_source = False
html_css_files = ["katex/katex.min.css", "site.css"]
html_js_files = ["katex/katex.min.js", "site.js"]
templates_path = ["templates"]
html_sidebars = {"**": ["sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/navigation.html",
                        "sidebar/scroll-end.html", "versions.html"]}
html_theme_options = {"navigation_with_keys": True, "light_css_variables": {"color-brand-primary": "#1b5e8a", "color-brand-content": "#1b5e8a"}}
highlight_language = "none"
if os.environ.get("FABRICSH_SITE_MANUAL"):  # one page, for paper
    html_theme = "basic"
    html_theme_options = {"nosidebar": True}
    html_css_files = ["katex/katex.min.css", "manual.css"]
    html_sidebars = {}
    html_permalinks = False
