"""Equations and their tags, as the pages write them for a reader of the repository, turned into what the site reads."""

import posixpath
import re

DEFINITION = re.compile(r"\*\*\[eq:([\w-]+)\]\*\*")
CITATION = re.compile(r"(?<![*`\w])\[eq:([\w-]+)\](?![*(`])")
INLINE = re.compile(r"\$`([^`\n]+)`\$")

places = {}


def on_files(files, **_):
    """Remembers the page on which each tag is defined."""
    for file in files.documentation_pages():
        for tag in DEFINITION.findall(file.content_string):
            places[tag] = file.url


def on_page_markdown(markdown, page, **_):
    """Outside of blocks of code, $`...`$ becomes \\(...\\), and a tag leads to its definition."""

    def cite(found):
        tag = found.group(1)
        if tag not in places:
            return found.group(0)
        target = posixpath.relpath(places[tag], posixpath.dirname(page.url) or ".")
        return f'<a href="{target}#eq-{tag}">[eq:{tag}]</a>'

    pieces = re.split(r"(^```.*?^```)", markdown, flags=re.MULTILINE | re.DOTALL)
    for at in range(0, len(pieces), 2):
        text = INLINE.sub(lambda found: rf"\({found.group(1)}\)", pieces[at])
        text = CITATION.sub(cite, text)
        pieces[at] = DEFINITION.sub(r'<strong id="eq-\1">[eq:\1]</strong>', text)
    return "".join(pieces)
