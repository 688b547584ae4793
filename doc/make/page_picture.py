"""The beginning of a report as a picture, by Chromium (Debian package chromium), with the
words that it shows kept in the file."""

import html
import re
import shutil
import subprocess
import tempfile

import numpy as np
from PIL import Image, PngImagePlugin

SIZE = (880, 904)
BROWSER = shutil.which("chromium")


def browse(page, *options):
    """What Chromium says of a page."""
    return subprocess.run(
        [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
         "--virtual-time-budget=5000", *options, f"file://{page}"],
        check=True, capture_output=True, text=True).stdout


def words(page):
    """Of the headline and the first section, but for seconds and round-off, which differ."""
    shown = re.search(r"<h1>.*?</section>", browse(page, "--dump-dom"), re.S)[0]
    text = html.unescape(re.sub(r"<[^>]*>", " ", re.sub(r"<script.*?</script>", "", shown,
                                                        flags=re.S)))
    text = re.sub(r"\d+(\.\d+)? s\b", "some s", " ".join(text.split()))
    return re.sub(r"[\d.]+e-1\d", "round-off", text)


def picture(page):
    """The picture, and its words."""
    with tempfile.NamedTemporaryFile(suffix=".png") as file:
        browse(page, f"--window-size={SIZE[0]},{SIZE[1]}", f"--screenshot={file.name}")
        return Image.open(file.name).convert("RGB"), words(page)


def write(path, page):
    """Writes it, unless there is no browser."""
    if BROWSER is None:
        return
    image, text = picture(page)
    info = PngImagePlugin.PngInfo()
    info.add_text("Description", text)
    image.save(path, pnginfo=info, optimize=True)


def difference(path, page):
    """What differs between a picture and its page; empty where nothing does, or no browser
    is there to tell."""
    if BROWSER is None:
        return ""
    old = Image.open(path)
    new, text = picture(page)
    if old.text.get("Description") != text:
        return f"{path} says\n  {old.text.get('Description')}\nand its page\n  {text}\n"
    # fonts and smoothing may differ, a missing plot may not
    blocks = [np.asarray(image.convert("L").resize((44, 45)), float) for image in (old, new)]
    far = np.mean(abs(blocks[0] - blocks[1]) > 40)
    return f"{path} does not look like its page\n" if far > 0.05 else ""
