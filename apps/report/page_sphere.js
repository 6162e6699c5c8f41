// Drawings on the sphere, seen orthographically; dragging turns them. A Globe is a View that turns where others pan.
const sphereTools = (() => {
  "use strict";
  const { s, fix, pathOf, add, View } = tools;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const mix = (a, f, b, g) => a.map((v, i) => f * v + g * b[i]);
  const unit3 = a => mix(a, 1 / Math.hypot(...a), a, 0);
  const degree = Math.PI / 180;
  const onGlobe = (l, b) => [
    Math.cos(b * degree) * Math.cos(l * degree),
    Math.cos(b * degree) * Math.sin(l * degree),
    Math.sin(b * degree),
  ];
  const steps = (from, to, f) => Array.from({ length: (to - from) / 3 + 1 }, (_, i) => f(from + 3 * i));
  const GRATICULE = [
    ...Array.from({ length: 12 }, (_, i) => steps(-90, 90, b => onGlobe(30 * i, b))),
    ...[-60, -30, 0, 30, 60].map(b => steps(0, 360, l => onGlobe(l, b))),
  ];
  const LINES = ["moving_curve", "fixed_curve", "guide", "ground", "path", "coupler", "link", "block"];

  class Globe extends View {
    constructor(svg, draw) {
      super(svg, draw, { fit: () => [-1.12, -1.12, 1.12, 1.12] }, 10);
      this.aim({ right: [0, 1, 0], up: [0, 0, 1], towards: [1, 0, 0] });
    }
    aim(view) {
      Object.assign(this, { right: view.right, up: view.up, towards: view.towards });
    }
    near(p) {
      return dot(this.towards, p) >= 0;
    }
    flat(p) {
      return [dot(this.right, p), dot(this.up, p)];
    }
    seen(p) {
      return this.px(this.flat(p));
    }
    pan(dx, dy) {
      // the point under the finger stays there
      const a = dx / this.scale,
        b = -dy / this.scale,
        { right, up, towards } = this;
      const forward = mix(towards, Math.cos(a), right, -Math.sin(a));
      this.up = unit3(mix(up, Math.cos(b), forward, Math.sin(b)));
      this.towards = unit3(mix(forward, Math.cos(b), up, -Math.sin(b)));
      const r = mix(right, Math.cos(a), towards, Math.sin(a));
      this.right = unit3(mix(mix(r, 1, this.up, -dot(r, this.up)), 1, this.towards, -dot(r, this.towards)));
      this.touched = true;
      this.draw();
    }
    zoom(factor) {
      this.scale *= factor;
      this.touched = true;
      this.draw();
    }
    runs(points, closed) {
      // cut at the limb
      const out = [],
        n = points.length;
      for (let i = 0; i < n + (closed && n ? 1 : 0); i++) {
        const p = points[i % n],
          near = this.near(p);
        if (i && near !== out[out.length - 1].near) {
          const q = points[i - 1],
            a = dot(this.towards, q),
            f = a / (a - dot(this.towards, p)),
            x = mix(q, 1 - f, p, f),
            cut = unit3(x);
          out[out.length - 1].points.push(this.flat(cut));
          out.push({ near, points: [this.flat(cut)] });
        } else if (!i) out.push({ near, points: [] });
        out[out.length - 1].points.push(this.flat(p));
      }
      return out;
    }
  }

  const label = (p, text, cls) => {
    const m = /^(\D+)(\d+)$/.exec(text),
      t = s(
        "text",
        { x: fix(p[0]), y: fix(p[1]), class: cls + " halo", "text-anchor": "middle", "dominant-baseline": "central" },
        m ? m[1] : text,
      );
    if (m) t.append(s("tspan", { dy: 5, "font-size": 11 }, m[2]));
    return t;
  };
  function arm(o, tip, cls, open) {
    const d = add(tip, o, -1),
      length = Math.hypot(...d);
    if (length < 9) return [s("path", { class: cls, d: pathOf([o, tip]) })];
    const u = [d[0] / length, d[1] / length],
      n = [-u[1], u[0]],
      foot = add(tip, u, -8);
    return [
      s("path", { class: cls, d: pathOf([o, foot]) }),
      s("path", {
        class: `${cls}-head${open ? " open" : ""}`,
        d: pathOf([tip, add(foot, n, 3.4), add(foot, n, -3.4)], true),
      }),
    ];
  }
  function attitude(view, stroke, bodies) {
    // y tip, x axis, z tip
    const [y, o, z] = stroke.points.map(p => view.seen(p)),
      task = stroke.role === "task",
      near = view.near(stroke.points[1]);
    if (!near) return s("g", { class: "far" }, s("path", { class: `s-${stroke.role}`, d: pathOf([y, o, z]) }));
    return s(
      "g",
      {},
      task ? s("path", { class: "s-task", d: pathOf([y, o, z]) }) : null,
      task && bodies
        ? null
        : [arm(o, y, task ? "s-task-arm" : "s-body", false), arm(o, z, task ? "s-task-arm" : "s-body", true)],
      task ? label(add(o, add(add(y, o, -1), add(z, o, -1)), -0.55), stroke.label, "task-label") : null,
    );
  }

  /// Where the label of p covers least of the points `taken`; it is one of them from then on. As label_places.hpp does
  /// it, for labels of one size that all weigh the same.
  function spot(p, taken) {
    const distance = 18, // of a label from its point, pixels
      directions = 12,
      firstAngle = Math.PI / 4,
      reach = 14; // pixels: what is this far from a label is not covered
    const places = Array.from({ length: directions }, (_, k) => {
      const angle = firstAngle + (k * 2 * Math.PI) / directions;
      return add(p, [distance * Math.cos(angle), -distance * Math.sin(angle)]);
    });
    const covered = at => taken.reduce((sum, q) => sum + Math.max(0, 1 - Math.hypot(...add(q, at, -1)) / reach), 0),
      costs = places.map(covered),
      best = places[costs.indexOf(Math.min(...costs))];
    taken.push(best);
    return best;
  }

  /// The elements of one drawing. `show(stroke)`: whether it is drawn; `hot`: id of a dyad to point out.
  function globe(view, sphere, show, hot, small) {
    const strokes = sphere.strokes.filter(show),
      first = strokes.find(t => t.role === "fixed_axis"),
      bodies = strokes.some(t => t.role === "body");
    const ink = t => `--c:var(--p${!first || t.dyad === first.dyad ? 0 : 2})`,
      rank = t => (t.pose > 1 ? "s-other" : "s-first") + (hot === t.dyad ? " hot" : "");
    const taken = small
      ? []
      : strokes
          .filter(t => t.pose <= 1 || t.role === "task")
          .flatMap(t => t.points.filter(q => view.near(q)).map(q => view.seen(q)));
    const c = view.px([0, 0]),
      out = [s("circle", { class: "globe-disc", cx: fix(c[0]), cy: fix(c[1]), r: fix(view.scale) })];
    const line = (points, closed, cls, style, near) =>
      view
        .runs(points, closed)
        .filter(r => r.near === near)
        .map(r => s("path", { class: cls + (near ? "" : " far"), style, d: pathOf(r.points.map(p => view.px(p))) }));
    if (!small) out.push(...GRATICULE.flatMap(g => line(g, false, "globe-grid", null, true)));
    for (const near of [false, true]) {
      for (const role of LINES)
        for (const later of [true, false])
          out.push(
            ...strokes
              .filter(t => t.role === role && t.pose > 1 === later)
              .flatMap(t => line(t.points, t.closed, `s-${role} ${rank(t)}`, ink(t), near)),
          );
      for (const role of small ? [] : ["task", "body"])
        out.push(
          ...strokes
            .filter(t => t.role === role && view.near(t.points[1]) === near)
            .map(t => attitude(view, t, bodies)),
        );
      for (const role of ["moving_axis", "fixed_axis"])
        out.push(
          ...strokes
            .filter(t => t.role === role && view.near(t.points[0]) === near)
            .map(t => {
              const p = view.seen(t.points[0]),
                r = (role === "fixed_axis" ? 5.5 : t.pose > 1 ? 2.6 : 4.5) * (small ? 0.5 : 1);
              return s(
                "g",
                { style: ink(t), class: near ? null : "far" },
                s("circle", { class: `s-${role} ${rank(t)}`, cx: fix(p[0]), cy: fix(p[1]), r }),
                near && !small && t.label && t.pose <= 1 ? label(spot(p, taken), t.label, "part-label") : null,
              );
            }),
        );
    }
    for (const [i, name] of ["x", "y", "z"].entries()) {
      const tip = [0, 0, 0];
      tip[i] = 1;
      if (small || !view.near(tip)) continue;
      const p = view.seen(tip);
      out.push(
        s("circle", { class: "axis-head", cx: fix(p[0]), cy: fix(p[1]), r: 2 }),
        label(add(p, [9, 9]), name, "axis-label"),
      );
    }
    return out;
  }
  function thumbnail(sphere, show) {
    const svg = s("svg", { class: "thumb", viewBox: "0 0 96 88", "aria-hidden": "true" }),
      view = Object.create(Globe.prototype);
    Object.assign(view, { w: 96, h: 88, scale: 38, centre: [0, 0] });
    view.aim(sphere.views[0]);
    svg.append(...globe(view, sphere, show, -1, true));
    return svg;
  }
  /// Longitude and latitude of an axis, longitude, latitude and roll of a quaternion; degrees.
  const place = a => [Math.atan2(a[1], a[0]) / degree, Math.atan2(a[2], Math.hypot(a[0], a[1])) / degree];
  function globeAngles(q) {
    const largest = Math.max(...q.map(Math.abs)),
      [w, x, y, z] = q.map(c => c / largest);
    const row = [2 * (z * x - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z];
    return [
      ...place([w * w + x * x - y * y - z * z, 2 * (x * y + w * z), row[0]]),
      Math.atan2(row[1], row[2]) / degree,
    ];
  }
  return { Globe, globe, thumbnail, place, globeAngles };
})();
