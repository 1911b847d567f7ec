# SPDX-License-Identifier: Apache-2.0
"""Opens the pages of `lac run` and of `lac report` in headless Chromium, from their files, without
network: nothing is fetched, nothing complains, figures are drawn, a click sorts, a drag zooms.

  check_pages.py LAC SOURCE_FOLDER
"""

import pathlib
import subprocess
import sys
import tempfile

import chromium

LAC, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])


def lac(*words):
    done = subprocess.run([LAC, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, "lac %s: %s" % (words, done.stderr)
    return done.stdout


def check_clean(page, path):
    """Only the page itself was asked for, and the console is silent."""
    assert page.requests == [path.as_uri()], page.requests
    assert not page.complaints, page.complaints


def column(page, table, cell):
    return page.value("[...(%s).tBodies[0].rows].filter(r => !r.hidden)"
                      ".map(r => plainText(r.cells[%d]))" % (table, cell))


def check_sorting(page, table, cell):
    """The first click sorts upward, the second downward; words do not count as numbers."""
    heading = "(%s).tHead.rows[0].cells[%d]" % (table, cell)
    for word, sign in (("ascending", 1), ("descending", -1)):
        page.click(heading + ".querySelector('button')")
        assert page.value(heading + ".getAttribute('aria-sort')") == word
        numbers = [float(t) for t in column(page, table, cell) if t not in ("", "n/a", "-")]
        assert len(set(numbers)) > 2, numbers
        assert numbers == sorted(numbers, key=lambda x: sign * x), (word, numbers)


def check_drawn(page, canvases, least):
    for canvas in canvases:
        filled, colours = page.colours_in(canvas)
        assert filled > 500 and colours > least, (canvas, filled, colours)


def check_run_page(folder):
    lac("run", SOURCE / "config/step.yaml", "--set", "time.duration_s=80", "--output", folder)
    path = (folder / "step.html").resolve()
    with chromium.Page(path) as page:
        page.settle()
        panels = page.value("document.querySelectorAll('#trace-panels .plot').length")
        assert panels > 3, panels
        check_drawn(page, ["document.querySelectorAll('#trace-panels .plot')[%d].firstChild" % i
                           for i in range(panels)], 5)
        check_sorting(page, "document.querySelector('table.sortable')", 2)
        readout = "document.getElementById('time-readout').textContent"
        before = page.value(readout)
        picture = "document.querySelector('#trace-panels canvas').toDataURL()"
        drawn = page.value(picture)
        plot = "document.querySelector('#trace-panels .plot')"
        page.drag(plot, (0.3, 0.5), (0.6, 0.5))
        page.mouse("mouseMoved", 2, 2)
        page.settle()
        assert page.value(readout) != before, before
        assert page.value(picture) != drawn
        page.click("document.getElementById('reset-zoom')")
        assert page.value(readout) == before
        check_clean(page, path)
    print("page of a run: %d panels, %d bytes" % (panels, path.stat().st_size))


# Names that are markup, a case that failed, a value that is none, three controllers, two classes.
def made_up_table(path):
    names = ["case", "status", "reason", "mean_speed_mps", "seed", "class", "key.of", "controller",
             "del_reference", "del_rainflow", "Load_<b>_del4 [kNm]", "GenPwr_mean [kW]", "Gap_std [m]"]
    rows = [names]
    for speed in (12, 16, 20):
        for seed in (1, 2, 3, 4):
            for kind in ("<i>calm</i>", "rough & \"wild\""):
                for c, controller in enumerate(("</script><b>one", "two", "three")):
                    load = 1000 * speed * (1 - 0.1 * c) + 37 * ((seed * 7 + speed) % 5) + 3 * seed * c
                    rows.append(["%d-%d-%s-%d" % (speed, seed, kind, c), "done", "", speed, seed, kind,
                                 "same", controller, "1hz", "astm", load, 5000 + seed + c,
                                 "" if seed == 2 else "nan" if seed == 3 else 0.1 * seed])
    rows.append(["bad", "failed", "<img src=x onerror=alert(1)> ended", 20, 5, "<i>calm</i>", "same"]
                + [""] * 6)
    quoted = ('"%s"' % str(cell).replace('"', '""') for row in rows for cell in row)
    cells = list(quoted)
    lines = [",".join(cells[i:i + len(names)]) for i in range(0, len(cells), len(names))]
    path.write_text("\n".join(lines) + "\n")


PLOT = "document.querySelectorAll('#campaign-panels .plot')[%d]"
CASES = "document.getElementById('case-table')"


def check_zoom(page, plot):
    axes = plot + ".dataset.x + ' ' + " + plot + ".dataset.y"
    before = page.value(axes)
    page.drag(plot, (0.4, 0.3), (0.7, 0.7))
    low_x, high_x, low_y, high_y = map(float, page.value(axes).split())
    x0, x1, y0, y1 = map(float, before.split())
    assert x0 < low_x < high_x < x1 and y0 < low_y < high_y < y1, (before, page.value(axes))
    page.value(plot + ".focus()")
    page.key("+")
    closer = list(map(float, page.value(axes).split()))
    assert closer[1] - closer[0] < 0.6 * (high_x - low_x), closer
    page.key("Escape")
    assert page.value(axes) == before


def choose(page, which, label):
    page.value("""(() => { const s = document.getElementById("%s");
        s.value = [...s.options].find(o => o.textContent.includes("%s")).value;
        s.dispatchEvent(new Event("change")); })()""" % (which, label))
    page.settle()


def visible_heading(page):
    return page.value("[...document.querySelectorAll('.comparison')].filter(a => a.checkVisibility())"
                      ".map(a => a.querySelector('h3').textContent)")


def check_report_page(folder):
    made_up_table(folder / "made up.csv")
    lac("report", folder / "made up.csv", "--title", "<u>Title</u>", "--quantities",
        "Load_<b>_del4,GenPwr_mean")
    path = (folder / "made up.html").resolve()
    with chromium.Page(path) as page:
        page.settle()
        assert page.value("document.title") == "<u>Title</u>"
        assert page.value("document.querySelectorAll('u, b, i:not([class]), img').length") == 0
        assert "ended" in page.value("document.querySelector('td.words').textContent")
        assert "one cycle per second" in page.value("document.querySelector('dl').textContent")
        marks = [int(page.value(PLOT % i + ".dataset.marks")) for i in range(3)]
        # 72 runs and 9 means; 24 pairs, 3 changes and one of a life; 24 pairs
        assert marks == [81, 28, 24], marks
        check_drawn(page, [PLOT % i + ".firstChild" for i in range(3)], 5)
        for i in range(3):
            check_zoom(page, PLOT % i)

        assert visible_heading(page) == ["From A = </script><b>one to B = two: all runs"]
        choose(page, "against", "three")
        choose(page, "view", "calm")
        assert visible_heading(page) == ["From A = </script><b>one to B = three: class = <i>calm</i>"]
        assert int(page.value(PLOT % 2 + ".dataset.marks")) == 12
        choose(page, "view", "all runs")
        choose(page, "quantity", "Gap_std")
        assert int(page.value(PLOT % 2 + ".dataset.marks")) == 12  # two of four seeds have none

        check_sorting(page, CASES, column_of(page, "Load_<b>_del4 [kNm]"))
        check_filter(page)
        check_copy(page)
        page.click("document.getElementById('all-columns')")
        assert page.value(CASES + ".tHead.rows[0].cells.length") == 13
        check_clean(page, path)
    print("page of a campaign: %d bytes" % path.stat().st_size)


def column_of(page, name):
    names = page.value("[...%s.tHead.rows[0].cells].map(c => c.textContent)" % CASES)
    return names.index(name)


def check_filter(page):
    page.value("""(() => { const s = [...document.querySelectorAll("#filters label")]
        .find(l => l.firstChild.textContent === "seed").querySelector("select");
        s.value = [...s.options].find(o => o.textContent === "4").value;
        s.dispatchEvent(new Event("change")); })()""")
    page.settle()
    assert set(column(page, CASES, column_of(page, "seed"))) == {"4"}
    assert len(column(page, CASES, 0)) == 18
    choose(page, "quantity", "Load")
    assert int(page.value(PLOT % 2 + ".dataset.marks")) == 6


def check_copy(page):
    text = page.value("tabSeparated(%s)" % CASES)
    lines = text.rstrip("\n").split("\n")
    assert len(lines) == 19 and all(line.count("\t") == lines[0].count("\t") for line in lines)
    load = lines[0].split("\t").index("Load_<b>_del4 [kNm]")
    assert all(float(line.split("\t")[load]) > 1000 for line in lines[1:])
    copy = "document.querySelector('#cases .copy')"
    page.click(copy)
    said = "document.querySelector('#cases .table-tools [role=status]').textContent"
    page.until(lambda: page.value(said) != "", "the page says what was copied")
    assert page.value(said) == "copied 18 rows", page.value(said)


# One controller, one run: nothing to compare, and the page still opens.
def check_small_page(folder):
    (folder / "one.csv").write_text("file,RtVAvgxh_mean [m/s],RotSpeed_std [rpm]\na.outb,11.9,0.3\n")
    lac("report", folder / "one.csv", "-o", folder / "small.html")
    path = (folder / "small.html").resolve()
    with chromium.Page(path, 390, 800) as page:
        page.settle()
        assert int(page.value(PLOT % 0 + ".dataset.marks")) == 2
        assert page.value("document.querySelectorAll('#campaign-panels .plot').length") == 1
        assert column(page, CASES, 0) == ["a.outb"]
        widths = page.value("[document.documentElement.scrollWidth, innerWidth]")
        assert widths[0] <= widths[1], widths  # no sideways scrolling
        check_clean(page, path)


chromium.find()
with tempfile.TemporaryDirectory(prefix="lac_pages_") as name:
    check_run_page(pathlib.Path(name) / "run")
    check_report_page(pathlib.Path(name))
    check_small_page(pathlib.Path(name))
