"""Puts the pages, and every file that a page refers to, into one folder in the places they have in the repository."""

import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)")


def tracked(*patterns):
    """Files of the repository."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns],
        cwd=ROOT, check=True, capture_output=True, text=True,
    )
    return [pathlib.Path(line) for line in listed.stdout.splitlines() if (ROOT / line).exists()]


def referred_to(page):
    """Files that a page links to."""
    for target in LINK.findall((ROOT / page).read_text()):
        if "://" in target or target.startswith("mailto:"):
            continue
        path = (ROOT / page.parent / target).resolve()
        if path.is_relative_to(ROOT) and path.is_file():
            yield path.relative_to(ROOT)


def main():
    staged = pathlib.Path(sys.argv[1])
    shutil.rmtree(staged, ignore_errors=True)
    pages = tracked("*.md")
    files = set(pages)
    for page in pages:
        files.update(referred_to(page))
    for file in files:
        place = staged / file
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / file, place)


main()
