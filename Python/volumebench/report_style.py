"""Style sheet, script and fixed text of the report."""

STYLE = """
:root { color-scheme: light dark; --text: #1f2430; --page: #f3f4f6; --card: #fff; --line: #e2e4e9;
  --soft: #edeff2; --faint: #5b616d; --head: #4a505c; --link: #0072b2; --note: #f8fafc;
  --strong-line: #d5d9e0; --good: #c9ecd6; --bad: #f6d0cb; --open: #f7e6b5; }
@media (prefers-color-scheme: dark) { :root { --text: #e4e6ea; --page: #14171d; --card: #1d2129;
  --line: #333945; --soft: #2a303a; --faint: #a4abb8; --head: #c3c8d2; --link: #6ab8ec; --note: #1a1e26;
  --strong-line: #454d5b; --good: #1f5135; --bad: #6b2a24; --open: #5b4a14; } }
body { font: 15px/1.55 system-ui, "Segoe UI", Roboto, "Helvetica Neue", sans-serif;
  color: var(--text); background: var(--page); margin: 0 auto; max-width: 1120px; padding: 24px; }
header { margin: 8px 0 24px; }
.kicker { text-transform: uppercase; letter-spacing: .14em; font-size: 12px; color: var(--link);
  font-weight: 600; margin: 0; }
h1 { font-size: 32px; line-height: 1.2; margin: 2px 0 8px; }
h2 { font-size: 19px; margin: 0 0 8px; }
h3 { font-size: 14px; margin: 16px 0 4px; }
section { background: var(--card); border: 1px solid var(--line); border-radius: 8px; padding: 20px 24px;
  margin: 0 0 18px; }
section.read { background: var(--note); }
.machine, small, figcaption { color: var(--faint); font-size: 13px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; }
th { text-align: left; font-weight: 600; color: var(--head); white-space: nowrap; }
th, td { padding: 5px 10px 5px 0; border-bottom: 1px solid var(--soft); vertical-align: top; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
table.grouped { font-size: 12.5px; }
table.grouped td, table.grouped th { padding-right: 6px; white-space: nowrap; }
th.group { text-align: center; border-left: 2px solid var(--strong-line); }
th.group:empty { border-left: 0; }
.mark { display: inline-block; white-space: nowrap; border-radius: 4px; padding: 0 7px; font-weight: 600;
  background: var(--soft); }
.mark.holds { background: var(--good); }
.mark.does-not-hold { background: var(--bad); }
.mark.undecided { background: var(--open); }
th.scene { color: var(--text); border-top: 2px solid var(--strong-line); padding-top: 10px; }
img.plot { display: block; background: #fff; border-radius: 4px; max-width: 100%; margin: 12px auto; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(190px, 1fr));
  gap: 14px; margin: 14px 0; align-items: start; }
figure { margin: 0; }
figure img { width: 100%; display: block; border-radius: 4px; background: #000; }
figcaption { margin: 5px 0 10px; line-height: 1.4; }
p.lead { font-size: 19px; line-height: 1.4; font-weight: 600; margin: 0 0 12px; }
ul.headlines { font-size: 16px; padding-left: 20px; }
details { margin-top: 10px; }
summary { cursor: pointer; color: var(--link); }
thead th.sortable { cursor: pointer; }
th[aria-sort=ascending]::after { content: " \\2191"; }
th[aria-sort=descending]::after { content: " \\2193"; }
@media print { body { background: #fff; } section { break-inside: avoid; } }
"""

# A click on the head of a column sorts by it: numbers by value, what is none of them last. Rows stay under
# the row that names their scene.
SCRIPT = """
document.querySelectorAll("table").forEach(table => {
  if (!table.tHead) return;
  const heads = Array.from(table.tHead.rows[table.tHead.rows.length - 1].cells);
  const value = row => column => {
    const text = row.cells[column] ? row.cells[column].textContent.trim() : "";
    const number = parseFloat(text.replace(/^[^-+.0-9]*(?=[-+.0-9])/, ""));
    return {text, number: /[0-9]/.test(text) && !/^[a-z]/i.test(text) ? number : NaN};
  };
  const groups = () => {
    const found = [[null, []]];
    for (const row of table.tBodies[0].rows) {
      if (row.querySelector("th.scene")) found.push([row, []]); else found[found.length - 1][1].push(row);
    }
    return found;
  };
  const sort = (head, column) => {
    const up = head.getAttribute("aria-sort") !== "ascending";
    for (const other of heads) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    const order = (a, b) => {
      const x = value(a)(column), y = value(b)(column);
      if (isNaN(x.number) !== isNaN(y.number)) return isNaN(x.number) ? 1 : -1;
      const less = isNaN(x.number) ? x.text.localeCompare(y.text) : x.number - y.number;
      return up ? less : -less;
    };
    for (const [name, rows] of groups()) {
      if (name) table.tBodies[0].append(name);
      table.tBodies[0].append(...rows.sort(order));
    }
  };
  heads.forEach((head, column) => {
    head.classList.add("sortable");
    head.tabIndex = 0;
    head.addEventListener("click", () => sort(head, column));
    head.addEventListener("keydown", event => { if (event.key === "Enter") sort(head, column); });
  });
});
"""

HOW_TO_READ = """
<p>Every technique draws the same scene from the same camera. Its <b>error</b> is the distance of
its picture to an exact reference in double precision: RMSE, and the difference that 99.9 % of all
values stay below, on linear premultiplied float RGBA between 0 and 1, over the pixels that either
picture covers. 1e-3 is about a quarter of one grey level of an 8-bit screen; the dotted line marks
what rounding to 8 bits alone costs. The <b>mean error</b> keeps its sign: picture less reference.
<b>SSIM</b> (1: alike), the share of pixels with <b>&Delta;E</b> (CIEDE2000) above 1, and
<b>FLIP</b> (0: alike; mean and 99 % of the covered pixels, at 67 pixels per degree) say how far
the pictures look apart: they are of 8-bit pictures over black. The <b>time</b> is the median of whole frames.</p>
<p>In the error plots, lower and further left is better. A curve joins the steps of one technique,
from coarse to fine; the star is what ParaView or VTK draws by default, where no such choice is
offered. Read off the time at the height of the star to compare at equal error. Errors inside the
shaded band are below the uncertainty of the reference: they are small, but their size is not
known.</p>
<p><b>Msamples</b> are the samples that one frame takes of the volume, in millions, counted at the
first error view; over the time of a frame they give the rate. Stages and samples are taken in
frames of their own, since counting and timing slow a frame down.</p>
<p>Each path answers a question of its own. <b>engine</b>: how fast is the rendering alone?
<b>view</b>: how long does ParaView take to show a finished picture, its own overhead included?
<b>interactive</b>: the same while the mouse drags, when ParaView's own volume rendering lowers its
quality to stay fluid; compare the errors as well as the speeds there.
<b>remote</b>: how long until a finished picture that a server draws is on the client's screen?
In a view the techniques
take turns in random order, so that a busy machine slows all of them alike.</p>
"""

HOW_SWEEPS_ARE_READ = """
<p><small>Each scene is drawn along x, along z and obliquely; the error is that of the three pictures
together, the time the median of their frames. ParaView's Volume is compared with our representations
in the same render view, VTK's mapper with our techniques in the filter's own window. Times at an
error are read off the Pareto front, straight between two measured runs in log-log and nowhere beyond
them: "not reached" says whose runs do not get there, "at least" that our fastest run is already more
accurate. ParaView's Volume has no setting for its step, so that it is one point. Samples are those of
a frame, counted on the device; for VTK's mapper by its own shader.</small></p>
"""

HOW_SPEED_IS_READ = """
<p><small>ParaView's Volume and our representations draw the same data in the same render view, in
turns, along x, along z and obliquely; the error is that of the three pictures together, the time the
median of their frames. ParaView's Volume has no setting for its step, so that it is one point. Our
time at its error is read off the curve of one variant (technique, integrator and settings), straight
in log-log between two measured steps and nowhere beyond them; the fastest variant counts. "At least"
says that the coarsest step measured is already more accurate. Samples are counted on the device, for
ParaView's Volume by its own shader. The interval is that of two medians, each &plusmn; 1.57 quartile
ranges over the square root of the frames; these quartiles also hold the difference between the three
views, so that it is wide.</small></p>
<p><small>A first picture is timed from the moment that the volume is in memory: its display is made
(which is when ParaView finds the ranges of the data, whoever draws them), the data are uploaded, kernels are compiled, one still frame is drawn, each time in a new view on a new
copy of the data. An edit makes all opacities a tenth lower, or as they were. Upload, tables, grid and
compile are what our mapper says of that frame; of ParaView's it is not known.</small></p>
"""

HOW_PAPERS_ARE_READ = """
<p><small>Times of other hardware are not a target: what is tested is who wins, by which factor, and where
techniques cross. A conclusion rests on the ratio of frame times of rows that differ in nothing else
(of several variants the fastest), as the geometric mean over all such pairs; the interval is a 95 %
bootstrap over the frames. It <b>holds</b> where the whole interval meets the paper's claim, <b>does not
hold</b> where the whole interval contradicts it, is <b>undecided</b> in between, and <b>not run</b> where this
machine or this cut of the study lacks the rows. Generated volumes stand in for those that are not
public, and are named as such. In the tables, "left out" is what this cut of the study does not have; the RMSE
is that of the row whose time stands beside it.</small></p>
"""

HOW_SCALING_IS_READ = """
<p><small>A quantity y over a factor x is fitted by y = a x<sup>b</sup>, least squares in log-log; the
exponent b stands with its 95 % interval (Student's t), without one where there are two points only.
Series at equal error read each time off the curve of one variant, as the error-time figures have it,
and leave out volumes in which no two runs bracket that error. Set-up is upload, tables and grid; the
kernels' compilation does not depend on the data.</small></p>
"""

HOW_EQUAL_ERROR_IS_READ = """
<p><small>The time of a technique at an error is read off the curve of its fastest variant (integrator
and settings), straight in log-log between two measured steps, never beyond them; errors that single pass
was not measured on both sides of are left out. "At least": the other technique's fastest run is more
accurate than that. The 95 % interval joins those of both medians. Rows with skipping off are
controls. The picture is timed at one size and its error measured at another.</small></p>
"""

HOW_CEILINGS_ARE_READ = """
<p><small>The ceiling is the highest rate of trilinear fetches that volumebench-run --calibrate measured on this
machine in the same kind of shader or OpenCL kernel and the same format of voxels, over volumes of 16 to 256
voxels an edge, along an axis, obliquely and as rays of a perspective camera. The native ceiling is that of
the processor's own instructions on all its cores, by gathers or by loads of two neighbours, whichever is
faster; it stands where the technique runs on the processor. Samples a second are those of whole frames: a
sample also looks up tables and, with lighting, fetches six neighbours, which are not counted; what of a
frame is neither is all else: tables, blending, skipping, making the rays and the view.</small></p>
"""
