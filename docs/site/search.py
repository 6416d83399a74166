# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The search of the site: words that its pages should be found by, and a copy of its index for pages that are opened from disk,
where a browser reads neither JSON nor the program of a worker, but scripts."""
import json
import re

# Words of a question, where the page that answers it has them in its text alone, or does not have them.
KEYWORDS = {
    "docs/install.md": "install installation download clone packages windows macos debian ubuntu requirements compiler spack cuda architecture container header only include headers",
    "docs/start.md": "glossary terms beginner quickstart start started getting tutorial dr meaning first begin output interval",
    "docs/faq.md": "faq questions compile error errors memory slow crash segmentation fault threads openmp fit gravity direction moving wall penetrate leak lost csv export gui water saturated pore undrained",
    "docs/checks.md": "nan inf validity warning checks unstable blow explode lost refused",
    "docs/choosing.md": "choose resolution spacing step cfl stiffness viscosity particle size pressure noise oscillation oscillations sound float double single precision young elastic modulus stiff opening across minimum kernel radius smoothing length",
    "docs/gallery.md": "pictures images films examples screenshots",
    "docs/looking_at_results.md": "paraview vtkhdf film video animation plot python picture print read postprocess save particles output color colour colours map",
    "docs/checkpoint.md": "restart checkpoint resume continue stop interrupt signal run",
    "docs/distributed.md": "mpi gpus ranks multi-gpu nodes cluster",
    "docs/case_programs.md": "toml case options preview example input file parameter study sweep command line change",
    "docs/extending.md": "extend own term inlet drain inflow outflow add remove particles custom rain pour pouring feed velocity observer write callback",
    "docs/comparison.md": "loquat dualsphysics comparison alternatives dem mpm",
    "docs/support.md": "bug report help contact issue question",
    "docs/stability.md": "version compatibility deprecated",
    "docs/theory/setup.md": "mesh stl obj gmsh raster geotiff k0 geostatic initial stress lattice random packing points generate digital elevation model",
    "docs/theory/granular.md": "wall walls boundary dummy adami smooth rough slip conserved conserve volume momentum",
    "docs/theory/laws.md": "law constitutive hypoplastic hypoplasticity elasticity elastoplastic rheology drucker prager mohr coulomb plasticity critical state density modulus inertial dilatancy",
    "docs/theory/segregation.md": "segregation diffusion species",
    "docs/theory/mixing.md": "mixing lacey danckwerts doucet neighbours coarse-graining profile average",
    "docs/theory/verification.md": "verification validation error convergence energy janssen rankine prandtl oedometer heap pile repose retaining bearing",
    "docs/performance.md": "performance scaling strong weak million millions benchmark long take duration estimate cost",
    "api/all_fields.md": "field fields unit units",
    "api/parameters.md": "parameter parameters default defaults range",
    "docs/overview.md": "periodic boundary ghosts images structure architecture probe probes print tensor",
    "CONTRIBUTING.md": "contribute contributing tests developers",
    "examples/silo/README.md": "silo hopper bin discharge outflow flow rate",
    "examples/terrain/README.md": "landslide avalanche debris terrain runout",
    "examples/inclined_flow/README.md": "inclined plane chute slope bagnold",
    "examples/column_collapse/README.md": "column collapse dam break runout",
    "examples/footing_and_wheel/README.md": "footing foundation wheel soil bearing capacity rover",
    "examples/blender/README.md": "blender mixer tumbler",
    "examples/drum/reference/README.md": "dem discrete element grains data csv drum",
    "README.md": "cite citation licence license bibtex",
}
LOCAL = '<script>location.protocol === "file:" && document.write(\'<script src="{}search/local.js"><\\/script>\')</script>'


def with_keywords(index, pages):
    """The index, in which a page has its keywords. `pages` maps Markdown files to the pages made of them."""
    by_page = {pages(source): words.split() for source, words in KEYWORDS.items()}
    there = {entry["location"] for entry in index["docs"]}
    missing = sorted(set(by_page) - there)
    if missing:
        raise KeyError(f"search.py has keywords of pages that do not exist: {', '.join(missing)}")
    for entry in index["docs"]:
        if entry["location"] in by_page:
            entry["tags"] = by_page[entry["location"]]
        if entry["location"].startswith("api/"):  # lists that have all words; names of the library stand nowhere else
            entry["boost"] = 0.5
    return index


def page_of(source):
    page = re.sub(r"(^|/)README\.md$", r"\1index.html", source)
    return re.sub(r"\.md$", ".html", page).removesuffix("index.html") or "index.html"


def finish(folder):
    """Adds keywords to the index of a site, and what lets its pages search where they are opened from disk."""
    path = folder / "search/search_index.json"
    index = json.loads(path.read_text(encoding="utf8"))
    locations = {entry["location"] for entry in index["docs"]}
    with_keywords(index, lambda source: next((each for each in (page_of(source), page_of(source) + "index.html") if each in locations), source))
    text = json.dumps(index, ensure_ascii=False, separators=(",", ":"))
    path.write_text(text, encoding="utf8")
    settings = re.search(r'<script id="__config"[^>]*>(.*?)</script>', (folder / "index.html").read_text(encoding="utf8"), re.DOTALL)[1]
    worker = (folder / json.loads(settings)["search"]).read_text(encoding="utf8")
    worker = re.sub(r"^//# sourceMappingURL=.*$", "", worker, flags=re.MULTILINE)
    # Version 8 of the theme takes the index from __search, version 9 from __index, after loading search_index.js.
    (folder / "search/local.js").write_text(
        f"var __index = {text};\nvar __search = {{index: Promise.resolve(__index)}};\n"
        f"const program = URL.createObjectURL(new Blob([{json.dumps(worker)}], {{type: 'text/javascript'}}));\n"
        "window.Worker = class extends Worker { constructor(url) { super(String(url).includes('/workers/search') ? program : url); } };\n",
        encoding="utf8")
    (folder / "search/search_index.js").write_text("// local.js has the index.\n", encoding="utf8")
    for page in folder.rglob("*.html"):
        html = page.read_text(encoding="utf8")
        up = "../" * (len(page.relative_to(folder).parts) - 1)
        page.write_text(html.replace('<script id="__config"', LOCAL.format(up) + '<script id="__config"', 1), encoding="utf8")
