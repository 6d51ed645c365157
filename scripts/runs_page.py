"""The page on which scripts/try_on and scripts/try_imports show their runs."""
import html
import pathlib
from dataclasses import dataclass

STYLE = """body{font:14px/1.4 sans-serif;margin:2rem;background:#f6f5f2;color:#222}
section{display:grid;grid-template-columns:repeat(auto-fill,minmax(24rem,1fr));gap:1rem}
figure{margin:0;background:#fff;padding:.5rem;border:1px solid #ddd}
img{max-width:100%;max-height:30rem}.pair img{width:50%}.failed{border-color:#b00}"""


@dataclass
class Run:
    name: str
    status: int  # of the program's exit
    images: list[str]  # files in the folder of the page
    lines: list[str]  # what the program said


def write_page(out: pathlib.Path, runs: list[Run]) -> None:
    """Writes out/index.html, and says how many runs have no fault."""
    figures = []
    for run in runs:
        kinds = ["pair"] * (len(run.images) == 2) + ["failed"] * (run.status != 0)
        images = "".join(f'<img src="{html.escape(image)}" loading="lazy" alt="">' for image in run.images)
        caption = "<br>".join(html.escape(line) for line in run.lines)
        figures.append(f'<figure class="{" ".join(kinds)}">{images}<figcaption><b>{html.escape(run.name)}</b>: '
                       f'exit {run.status}<br><small>{caption}</small></figcaption></figure>')
    sound = sum(run.status == 0 for run in runs)
    title = f"{sound} of {len(runs)} runs without a fault"
    (out / "index.html").write_text(
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>Selvedge: {title}</title><style>{STYLE}</style>'
        f"<h1>{title}</h1><section>{''.join(figures)}</section>\n")
    print(f"{title}. Written: {out}/index.html")
