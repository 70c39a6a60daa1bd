"""resvg: a template is a page in millimetres, and what it shows has the size of the pot when it is drawn at true scale.

Nothing is read off the file but which element is which: lengths are counted in pixels of the picture that resvg draws
at four pixels a millimetre.
"""

import io
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import resvg_py
from PIL import Image

import specimens
from specimens import Specimen, equal, near

SVG = "{http://www.w3.org/2000/svg}"
MILLIMETRES_PER_INCH = 25.4
PIXELS = 4
"""The same of sheets of paper, of which only their borders are looked at: they are large, and cut out of the page slowly."""
SHEET_PIXELS = 1
"""How far a length may be off that is told by pixels: one at each end is partly covered."""
PIXEL = 2 / PIXELS
"""Half of a line is drawn on each side of what it bounds."""
OUTLINE = 0.25
BAR, INCHES = 100.0, 101.6
"""Of how a length is rounded that is told."""
PLACES = {1.0: 0.06, 10.0: 0.06, MILLIMETRES_PER_INCH: 0.13}
"""Rims whose petals are so deep that the strip laps over itself where it is unrolled, and covers less of the page."""
LAPPING = ("ishak-ali-4-n10-solid", "ishak-ali-4-n15-solid")
SHEETS = {"a4.svg": (210.0, 297.0), "letter.svg": (215.9, 279.4)}


def judge(specimen: Specimen) -> Iterator[str]:
    """Page, layers, bar, sections, heights, strips and sheets."""
    root = ElementTree.parse(specimen.files["svg"]).getroot()
    # As large as it says, one unit a millimetre.
    sides = [re.fullmatch(r"([\d.]+)mm", root.get(side, "")) for side in ("width", "height")]
    yield from equal("sides in millimetres", [bool(side) for side in sides], [True, True])
    if not all(sides):
        return
    yield from equal("viewBox", root.get("viewBox"), " ".join(["0", "0", *(side[1] for side in sides if side)]))
    width, height = (float(side[1]) for side in sides if side)
    page = drawn(specimen.files["svg"].read_text(encoding="utf-8"))
    yield from near("page is wide", page.width / PIXELS, width, PIXEL)
    yield from near("page is high", page.height / PIXELS, height, PIXEL)

    left, upper, right, lower = extent(root, lambda element: element.tag in (f"{SVG}path", f"{SVG}line"))
    yield from equal("all of it is on the page", left > 1 and upper > 1 and right < width - 1 and lower < height - 1, True)
    layers = [element.get("id") for element in root if element.tag == f"{SVG}g"]
    yield from equal("layers", layers, ["grid", "outline", "text"])
    bar = INCHES if specimen.unit == MILLIMETRES_PER_INCH else BAR
    yield from near("bar", wide(extent(root, lambda element: element.get("id") == "bar")), bar, PIXEL)

    strips = [element for element in root.iter() if element.get("id", "").startswith("strip-")]
    tops = iter([text for text in texts(root) if text.endswith(" top")])
    yield from equal("number of strips", len(strips), sum(part.strip is not None for part in specimen.templates))
    for number, part in enumerate(specimen.templates, start=1):
        for section, place in zip(part.sections, ("", "-lowest"), strict=False):
            told = float(next(tops, "nan").split()[0]) * specimen.unit
            yield from near("height told", told, part.height, PLACES[specimen.unit] + 2 * specimen.bound)
            yield from judge_section(specimen, root, f"section-{number}{place}", section)
    yield from equal("number of heights", len(list(tops)), 0)
    for strip, part in zip(strips, (part for part in specimen.templates if part.strip is not None), strict=True):
        # It is drawn with chords.
        within = (0.3 if specimen.name in LAPPING else 2e-3) * part.strip
        yield from near("area of the strip", area(root, strip), part.strip, within)
    for kind, (width, height) in SHEETS.items():
        if kind in specimen.files:
            yield from judge_sheets(specimen.files[kind], width, height)


def judge_section(
    specimen: Specimen, root: ElementTree.Element, name: str, section: tuple[float, float]
) -> Iterator[str]:
    """The drawn profile."""
    box = extent(root, lambda element: element.get("id") == name)
    for what, found, expected in (
        ("width", wide(box) - OUTLINE, section[0]),
        ("height", box[3] - box[1] - OUTLINE, section[1]),
    ):
        yield from near(f"{what} of the section", found, expected, PIXEL + 2 * specimen.bound + 1e-3 * expected)


def judge_sheets(path: Path, width: float, height: float) -> Iterator[str]:
    """Sheets of paper one below the other, of whose edges nothing is too near."""
    root = ElementTree.parse(path).getroot()
    pages = [element for element in root.iter() if element.tag.endswith("}page")]
    page = drawn(path.read_text(encoding="utf-8"), SHEET_PIXELS).convert("L")
    # A thin line is a light pixel.
    page = page.point(lambda grey: 255 if grey < 250 else 0)
    yield from near("sheets are wide", page.width / SHEET_PIXELS, width, 1)
    for sheet in pages:
        top = float(sheet.get("y", "nan"))
        ink = page.crop(tuple(round(SHEET_PIXELS * side) for side in (0, top, width, top + height))).getbbox()
        left, upper, right, lower = (side / SHEET_PIXELS for side in ink or (0, 0, 0, 0))
        inside = left > 8 and upper > 8 and right < width - 8 and lower < height - 4
        yield from equal(f"{sheet.get('id')} is within its border", inside, True)


def area(root: ElementTree.Element, element: ElementTree.Element) -> float:
    """What a closed line encloses."""
    page = ElementTree.Element(root.tag, root.attrib)
    page.append(ElementTree.Element(element.tag, {**element.attrib, "fill": "#000", "stroke": "none"}))
    shades = drawn(ElementTree.tostring(page, encoding="unicode")).getchannel("A").histogram()
    return sum(shade * count for shade, count in enumerate(shades)) / 255 / PIXELS**2


def wide(box: tuple[float, float, float, float]) -> float:
    """From left to right."""
    return box[2] - box[0]


def texts(root: ElementTree.Element) -> list[str]:
    """All that is written, in order."""
    return [element.text or "" for element in root.iter(f"{SVG}text")]


def extent(
    root: ElementTree.Element, kept: Callable[[ElementTree.Element], bool]
) -> tuple[float, float, float, float]:
    """Where on the page some of its elements are seen: left, upper, right, lower."""
    page = ElementTree.Element(root.tag, root.attrib)
    page.extend(element for element in root.iter() if kept(element))
    box = drawn(ElementTree.tostring(page, encoding="unicode")).getchannel("A").getbbox()
    if box is None:
        raise ValueError("nothing is seen")
    return tuple(side / PIXELS for side in box)


def drawn(text: str, pixels: int = PIXELS) -> Image.Image:
    """The page at so many pixels a millimetre."""
    data = resvg_py.svg_to_bytes(svg_string=text, dpi=pixels * MILLIMETRES_PER_INCH, skip_system_fonts=True)
    Image.MAX_IMAGE_PIXELS = None
    return Image.open(io.BytesIO(data))


def in_pixels(specimen: Specimen, folder: Path) -> Specimen:
    """The right numbers without their unit."""
    return edited(specimen, folder, r'(width|height)="([\d.]+)mm"', r'\1="\2"', "in pixels")


def a_hundredth_too_large(specimen: Specimen, folder: Path) -> Specimen:
    """A page that is not true to scale."""
    return edited(specimen, folder, r'(width|height)="([\d.]+)mm"', larger, "a hundredth too large")


def larger(side: re.Match[str]) -> str:
    """One side of the page."""
    return f'{side[1]}="{1.01 * float(side[2]):.3f}mm"'


def with_a_short_rim(specimen: Specimen, folder: Path) -> Specimen:
    """A strip that does not reach round the pot."""
    return edited(specimen, folder, r'(<path id="strip-1" )', r'\1transform="scale(0.99 1)" ', "with a short rim")


def with_a_low_section(specimen: Specimen, folder: Path) -> Specimen:
    """A section that is not as high as the pot."""
    return edited(specimen, folder, r'(<path id="section-1" )', r'\1transform="scale(1 0.99)" ', "with a low section")


def edited(
    specimen: Specimen, folder: Path, pattern: str, by: str | Callable[[re.Match[str]], str], damage: str
) -> Specimen:
    """A specimen whose SVG has another text wherever it matches."""
    text, changes = re.subn(pattern, by, specimen.files["svg"].read_text(encoding="utf-8"), flags=re.DOTALL)
    if changes == 0:
        raise ValueError(f"the file has no {pattern}")
    path = folder / f"{damage.replace(' ', '-')}.svg"
    path.write_text(text, encoding="utf-8")
    return specimen.with_file("svg", path, damage)


if __name__ == "__main__":
    specimens.main(
        "resvg",
        judge,
        {
            in_pixels: "sides in millimetres is",
            a_hundredth_too_large: "viewBox is",
            with_a_short_rim: "area of the strip is",
            with_a_low_section: "height of the section is",
        },
        wanted=lambda specimen: "svg" in specimen.files,
    )
