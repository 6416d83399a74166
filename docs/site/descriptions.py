# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The description of a page, which search engines and previews of links show: its title and its first paragraph."""
import html
import re

LONGEST = 200  # characters


def text_of(code):
    return " ".join(html.unescape(re.sub(r'<a class="headerlink".*?</a>|<[^>]*>', "", code, flags=re.DOTALL)).split())


def of(page):
    """The description of a page in HTML; none where it has no title."""
    article = re.search(r"<article.*?</article>", page, re.DOTALL)
    title = article and re.search(r"<h1.*?</h1>", article[0], re.DOTALL)
    if not title:
        return ""
    paragraphs = (text_of(each) for each in re.findall(r"<p>.*?</p>", article[0], re.DOTALL) if "katex" not in each)
    text = ": ".join(filter(None, (text_of(title[0]), next((each for each in paragraphs if each), ""))))
    return text if len(text) <= LONGEST else text[:LONGEST].rsplit(" ", 1)[0] + " ..."


def put_into(folder):
    """Gives each page of a site its description, and the page for addresses that do not exist a sentence."""
    for path in folder.rglob("*.html"):
        page = path.read_text(encoding="utf8")
        if path.name == "404.html":
            page = re.sub(r"(<h1>404.*?</h1>)", r"\1\n<p>There is no page at this address. The menu and the search lead to all pages.</p>", page)
        if text := of(page):
            page = re.sub(r'<meta name="description" content="[^"]*">', lambda _: f'<meta name="description" content="{html.escape(text)}">', page, count=1)
        path.write_text(page, encoding="utf8")
