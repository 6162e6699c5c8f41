// The page's toolkit: making elements, showing numbers, copying, and figures that pan and zoom.
const tools = (() => {
  "use strict";
  const $ = id => document.getElementById(id);
  function make(ns, tag, attrs, kids) {
    const e = ns ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
    for (const [k, v] of Object.entries(attrs || {}))
      if (k.startsWith("on")) e.addEventListener(k.slice(2), v);
      else if (v !== null && v !== undefined && v !== false) e.setAttribute(k, v);
    e.append(...kids.flat(Infinity).filter(k => k !== null && k !== undefined));
    return e;
  }
  const h = (tag, attrs, ...kids) => make(false, tag, attrs, kids);
  const s = (tag, attrs, ...kids) => make(true, tag, attrs, kids);
  const clamp = (v, lo, hi) => Math.min(hi, Math.max(lo, v));
  const add = (p, q, f = 1) => [p[0] + f * q[0], p[1] + f * q[1]];
  const isNumber = v => typeof v === "number" && Number.isFinite(v);
  const plural = (n, one, many) => `${n === 0 ? "no" : n} ${n === 1 ? one : many || one + "s"}`;

  function format(v, digits = 6) {
    if (!isNumber(v)) return v === null || v === undefined ? "–" : String(v);
    let [m, e] = (v === 0 ? "0" : v.toPrecision(digits)).split("e");
    const size = Math.abs(v);
    if (!e && size !== 0 && size < 1e-4) [m, e] = v.toExponential(digits - 1).split("e");
    if (m.includes(".")) m = m.replace(/\.?0+$/, "");
    const raised = c => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]),
      power = e ? "×10" + [...String(+e)].map(raised).join("") : "";
    return m.replace("-", "−") + power;
  }
  const number = (v, digits, after = "") =>
    h("span", { class: "num", title: isNumber(v) ? String(v) : null }, format(v, digits) + (isNumber(v) ? after : ""));
  const rounded = (p, zero) => p.map(v => (Math.abs(v) < zero ? 0 : v)); // coordinates that count as 0
  const point = (p, zero = 0) =>
    Array.isArray(p)
      ? h("span", { class: "num", title: `(${p.join(", ")})` }, `(${rounded(p, zero).map(v => format(v)).join(", ")})`)
      : null;

  function say(text) {
    $("said").textContent = text;
    $("said").classList.add("on");
    clearTimeout(say.timer);
    say.timer = setTimeout(() => $("said").classList.remove("on"), 1600);
  }
  async function copy(value, what) {
    const text = JSON.stringify(value, null, 2);
    try {
      await navigator.clipboard.writeText(text);
    } catch (e) {
      const area = document.body.appendChild(h("textarea", {}));
      area.value = text;
      area.select();
      document.execCommand("copy");
      area.remove();
    }
    say(`${what} copied`);
  }
  function boxOf(points, pad = 0) {
    const ok = points.filter(p => p && isNumber(p[0]) && isNumber(p[1]));
    if (!ok.length) return [-1, -1, 1, 1];
    const xs = ok.map(p => p[0]),
      ys = ok.map(p => p[1]);
    const b = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
    const grow = pad * Math.max(b[2] - b[0], b[3] - b[1]) || (b[2] - b[0] + b[3] - b[1] > 0 ? 0 : 1);
    return [b[0] - grow, b[1] - grow, b[2] + grow, b[3] + grow];
  }
  const col = (head, cell, r) => ({ head, cell, r });
  function table(host, title, columns, rows, attrs) {
    // a column without any entry is left out
    if (!rows.length) return;
    const cells = rows.map(r => columns.map(c => c.cell(r)));
    const used = [...columns.keys()].filter(k => cells.some(r => r[k] !== null && r[k] !== undefined));
    const head = used.map(k => h("th", { class: columns[k].r && "r", scope: "col" }, columns[k].head));
    const body = rows.map((r, i) =>
      h(
        "tr",
        attrs(r),
        used.map(k => h("td", { class: columns[k].r && "r" }, cells[i][k] ?? "–")),
      ),
    );
    $(host).append(
      h("h3", {}, title),
      h("div", { class: "scroll" }, h("table", {}, h("thead", {}, h("tr", {}, head)), h("tbody", {}, body))),
    );
  }

  // ---- points, boxes, views
  const fix = v => Math.round(clamp(v, -1e7, 1e7) * 100) / 100;
  const pathOf = (pts, closed) =>
    pts.map((p, i) => (i ? "L" : "M") + fix(p[0]) + " " + fix(p[1])).join("") + (closed ? "Z" : "");
  function unit(a, b) {
    const d = [b[0] - a[0], b[1] - a[1]],
      n = Math.hypot(...d) || 1;
    return [d[0] / n, d[1] / n];
  }
  function clip(view, a, b) {
    // the part of segment ab inside the figure, with some room around it
    let lo = 0,
      hi = 1;
    for (const [k, size] of [
      [0, view.w],
      [1, view.h],
    ]) {
      const d = b[k] - a[k],
        t = [(-30 - a[k]) / d, (size + 30 - a[k]) / d];
      if (Math.abs(d) < 1e-12) {
        if (a[k] < -30 || a[k] > size + 30) return null;
      } else {
        lo = Math.max(lo, Math.min(...t));
        hi = Math.min(hi, Math.max(...t));
      }
    }
    return lo < hi ? [add(a, add(b, a, -1), lo), add(a, add(b, a, -1), hi)] : null;
  }
  function resized(pts, lo, hi) {
    // a closed symbol kept between lo and hi pixels of half diagonal
    const c = pts.reduce((a, p) => add(a, p, 1 / pts.length), [0, 0]),
      r = Math.max(...pts.map(p => Math.hypot(...add(p, c, -1)))) || 1;
    return pts.map(p => add(c, add(p, c, -1), clamp(r, lo, hi) / r));
  }

  class View {
    // pan and zoom of one figure; y points up
    constructor(svg, draw, fits, margin) {
      Object.assign(this, {
        svg,
        draw,
        fits,
        margin,
        w: 0,
        h: 0,
        scale: 1,
        centre: [0, 0],
        touched: false,
        box: null,
        fingers: new Map(),
      });
      new ResizeObserver(() => this.resize()).observe(svg);
      svg.addEventListener("wheel", e => this.wheel(e), { passive: false });
      svg.addEventListener("pointerdown", e => {
        this.fingers.set(e.pointerId, [e.clientX, e.clientY]);
        svg.setPointerCapture(e.pointerId);
      });
      svg.addEventListener("pointermove", e => this.drag(e));
      for (const name of ["pointerup", "pointercancel"])
        svg.addEventListener(name, e => this.fingers.delete(e.pointerId));
      svg.addEventListener("keydown", e => this.key(e));
    }
    px(p) {
      return [this.w / 2 + (p[0] - this.centre[0]) * this.scale, this.h / 2 - (p[1] - this.centre[1]) * this.scale];
    }
    resize() {
      const r = this.svg.getBoundingClientRect();
      if (!r.width || !r.height) return;
      const before = this.w;
      this.w = r.width;
      this.h = r.height;
      this.svg.setAttribute("viewBox", `0 0 ${this.w} ${this.h}`);
      if (this.touched && before) {
        this.scale *= this.w / before;
        this.draw();
      } else this.fit(this.box);
    }
    fit(box) {
      this.box = box || this.fits.fit();
      this.touched = false;
      if (!this.w) return;
      const b = this.box,
        m = Math.min(this.margin, this.w / 8);
      this.centre = [(b[0] + b[2]) / 2, (b[1] + b[3]) / 2];
      this.scale = Math.min(
        (this.w - 2 * m) / Math.max(b[2] - b[0], 1e-12),
        (this.h - 2 * m) / Math.max(b[3] - b[1], 1e-12),
      );
      this.draw();
    }
    zoom(factor, at = [this.w / 2, this.h / 2]) {
      const d = [(at[0] - this.w / 2) / this.scale, (this.h / 2 - at[1]) / this.scale];
      const f = clamp(this.scale * factor, 1e-9, 1e12) / this.scale;
      this.centre = add(this.centre, d, 1 - 1 / f);
      this.scale *= f;
      this.touched = true;
      this.draw();
    }
    pan(dx, dy) {
      this.centre = add(this.centre, [-dx / this.scale, dy / this.scale]);
      this.touched = true;
      this.draw();
    }
    place(x, y) {
      const r = this.svg.getBoundingClientRect();
      return [x - r.left, y - r.top];
    }
    wheel(e) {
      // a page being scrolled past the figure keeps scrolling; a fresh turn of the wheel zooms
      if (performance.now() - View.scrolled < 250 && !e.ctrlKey) return;
      e.preventDefault();
      this.zoom(Math.exp(-clamp(e.deltaY * (e.deltaMode ? 30 : 1), -300, 300) / 500), this.place(e.clientX, e.clientY));
    }
    drag(e) {
      // one finger or the mouse pans, two fingers pinch
      const old = this.fingers.get(e.pointerId),
        now = [e.clientX, e.clientY];
      if (!old) return;
      const other = [...this.fingers].find(([id]) => id !== e.pointerId);
      this.fingers.set(e.pointerId, now);
      if (!other) return this.pan(now[0] - old[0], now[1] - old[1]);
      const q = other[1],
        d = p => Math.hypot(p[0] - q[0], p[1] - q[1]) || 1;
      this.zoom(d(now) / d(old), this.place((now[0] + q[0]) / 2, (now[1] + q[1]) / 2));
    }
    key(e) {
      const move = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] }[e.key];
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      if (move) this.pan(...move);
      else if (e.key === "+" || e.key === "=") this.zoom(1.25);
      else if (e.key === "-") this.zoom(0.8);
      else if (e.key === "0") this.fit();
      else return;
      e.preventDefault();
    }
    act(name) {
      if (name === "in") this.zoom(1.3);
      else if (name === "out") this.zoom(1 / 1.3);
      else this.fit(this.fits[name]());
    }
  }
  View.scrolled = -1e9;
  addEventListener(
    "scroll",
    () => {
      View.scrolled = performance.now();
    },
    { passive: true },
  );
  return {
    $,
    h,
    s,
    clamp,
    add,
    unit,
    fix,
    pathOf,
    clip,
    resized,
    isNumber,
    plural,
    format,
    number,
    rounded,
    point,
    copy,
    col,
    table,
    boxOf,
    View,
  };
})();
