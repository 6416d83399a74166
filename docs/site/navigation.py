# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What is in the site, and where."""


def sources(root):
    """Markdown files and pictures of the repository."""
    found = [root / f"{name}.md" for name in ("README", "CHANGELOG", "CONTRIBUTING", "CODE_OF_CONDUCT", "SECURITY")]
    for folder in ("docs", "examples", "benchmarks"):
        for kind in ("md", "png", "svg", "webp"):
            found += sorted((root / folder).rglob(f"*.{kind}"))
    return [path for path in found if path.exists()]


def applications(root):
    """The pages of the programs with case files."""
    return [str(path.relative_to(root)) for path in sorted((root / "examples").glob("*/README.md"))
            if list(path.parent.glob("*.toml"))]


def tree(root, tutorials, api_pages):
    """The menu, in the form that MkDocs has it. A page that exists and is not listed comes under Further."""
    menu = [
        {"Home": "README.md"},
        {"Start here": ["docs/start.md", "docs/gallery.md", "docs/install.md"]},
        {"Tutorials": ["examples/course/README.md", *({title: page} for title, page in tutorials),
                       "docs/looking_at_results.md"]},
        {"How to": ["docs/choosing.md", "docs/extending.md", "docs/roles.md", "docs/case_programs.md", "docs/checkpoint.md",
                    "docs/checks.md"]},
        {"Concepts": ["docs/overview.md", "docs/neighbour_lists.md", "docs/distributed.md"]},
        {"Theory": [f"docs/theory/{name}.md" for name in ("granular", "laws", "setup", "segregation", "mixing", "surface",
                                                          "reference_solutions")] + ["docs/differences_from_paper.md"]},
        {"Applications": [{"Overview": "examples/README.md"}, *applications(root)]},
        {"Verification": ["docs/theory/verification.md", "examples/drum/reference/README.md", "docs/reliability.md",
                          "docs/fuzzing.md"]},
        {"Performance": ["docs/performance.md", "benchmarks/README.md",
                         *(f"benchmarks/results/{name}.md" for name in ("h200", "shear_box_h200", "shear_box_h200_rows"))]},
        {"API": api_pages},
        {"FAQ": ["docs/faq.md"]},
        {"Project": ["docs/comparison.md", "docs/stability.md", "docs/support.md", "CHANGELOG.md", "CONTRIBUTING.md", "docs/style.md", "docs/release.md", "CODE_OF_CONDUCT.md", "SECURITY.md"]},
    ]
    listed = {page if isinstance(page, str) else next(iter(page.values())) for section in menu
              for entry in section.values() for page in ([entry] if isinstance(entry, str) else entry)}
    further = [str(path.relative_to(root)) for path in sources(root) if path.suffix == ".md"]
    further = [page for page in further if page not in listed]
    return menu + ([{"Further": further}] if further else [])
