// Drawings in the plane: symbols, mechanisms, dyads. A View maps the fixed frame to the screen; symbols keep their size
// under zoom.
const plane = (() => {
  "use strict";
  const { s, clamp, add, unit, fix, pathOf, clip, resized, format } = tools;
  const { poses, units, state, colour, poseName, inBody } = report;
  const ORDER = ["ground", "guide", "coupler", "link", "block", "moving_pivot", "fixed_pivot", "frame"];

  // ---- symbols --------------------------------------------------------------------------------------------------
  const text = (p, str, cls, anchor = "middle") =>
    s(
      "text",
      { x: fix(p[0]), y: fix(p[1]), class: cls + " halo", "text-anchor": anchor, "dominant-baseline": "central" },
      str,
    );
  function arrow(o, d, length, cls, open) {
    const n = [-d[1], d[0]],
      tip = add(o, d, length),
      foot = add(tip, d, -8);
    return [
      s("path", { class: cls, d: pathOf([o, foot]) }),
      s("path", {
        class: `${cls}-head${open ? " open" : ""}`,
        d: pathOf([tip, add(foot, n, 3.4), add(foot, n, -3.4)], true),
      }),
    ];
  }
  function frameSymbol(o, dx, dy, length, label, attrs) {
    // a full head on the x axis, an open one on the y axis
    const back = unit([0, 0], add(dx, dy));
    return s(
      "g",
      attrs,
      arrow(o, dx, length, "pose"),
      arrow(o, dy, length, "pose", true),
      s("circle", { class: "pose-dot", cx: fix(o[0]), cy: fix(o[1]), r: 3 }),
      label ? text(add(o, back, -15), label, "pose-label") : null,
    );
  }
  const poseSymbol = (view, pose, i, length) =>
    frameSymbol(
      view.px(pose.origin),
      [pose.x_axis[0], -pose.x_axis[1]],
      [pose.y_axis[0], -pose.y_axis[1]],
      length,
      pose.label,
      { style: colour(i) },
    );
  function support(p, hot) {
    // fixed pivot: pin, triangle and ground hatching
    const [x, y] = p,
      marks = [];
    for (let k = -12; k <= 8; k += 5) marks.push(`M${fix(x + k + 5)} ${fix(y + 17)}l-5 6`);
    return s(
      "g",
      {},
      s("path", { class: "hatch", d: marks.join("") }),
      s("path", { class: "support", d: pathOf([p, [x - 10, y + 17], [x + 10, y + 17]], true) }),
      s("path", { class: "bar-edge", style: "stroke-width:1.5", d: `M${fix(x - 14)} ${fix(y + 17)}h28` }),
      s("circle", { class: "pin" + hot, cx: fix(x), cy: fix(y), r: 4.5 }),
    );
  }
  function guide(view, pts, still, hot) {
    // a guide of the fixed link is hatched like the ground
    const seg = pts.length > 1 && clip(view, pts[0], pts[pts.length - 1]);
    if (!seg) return null;
    let d = unit(...seg),
      marks = "";
    if (d[0] < 0) d = [-d[0], -d[1]];
    const start = d[0] === unit(...seg)[0] ? seg[0] : seg[1],
      length = Math.hypot(...add(seg[1], seg[0], -1));
    for (let k = 4; still && k < Math.min(length, 4000); k += 8) {
      const p = add(start, d, k);
      marks += pathOf([p, add(add(p, d, -5), [-d[1], d[0]], 6)]);
    }
    return s("g", {}, s("path", { class: "hatch", d: marks }), s("path", { class: "guide" + hot, d: pathOf(seg) }));
  }
  function partLabel(label, p) {
    if (!label || label.length > 4) return null;
    const m = /^(\D+)(\d+)$/.exec(label),
      t = text(add(p, [13, -13]), m ? m[1] : label, "part-label");
    if (m) t.append(s("tspan", { dy: 5, "font-size": 11 }, m[2]));
    return t;
  }
  function frameOfPart(pts, label, attrs) {
    if (pts.length < 3) return null;
    const size = clamp(Math.hypot(...add(pts[0], pts[1], -1)), 14, 44);
    return frameSymbol(pts[1], unit(pts[1], pts[0]), unit(pts[1], pts[2]), size, label, attrs);
  }

  // ---- mechanisms -----------------------------------------------------------------------------------------------
  function prepare(l) {
    // which parts stay put, closed motions end where they begin
    const shots = l.at_pose || [],
      same = (a, b) => a && b && JSON.stringify(a) === JSON.stringify(b);
    const parts = (l.parts || []).map((p, k) => ({ ...p, k, still: shots.every(f => same(f[k], shots[0][k])) }));
    const motions = (l.motions || [])
      .filter(m => m.frames && m.frames.length)
      .map(m =>
        forward(
          m.closed && !same(m.frames[0], m.frames[m.frames.length - 1])
            ? { ...m, frames: [...m.frames, m.frames[0]] }
            : m,
        ),
      );
    parts.sort((a, b) => ORDER.indexOf(a.role) - ORDER.indexOf(b.role));
    return { ...l, parts, motions, at_pose: shots };
  }
  function stops(m) {
    return m.pose_frames.map((f, k) => ({ f, pose: m.poses[k] - 1 })).sort((a, b) => a.f - b.f);
  }
  function forward(m) {
    // run the motion in the direction that meets its poses in the order of their numbers, if one does
    const list = stops(m).map(t => t.pose),
      last = m.frames.length - 1,
      k = list.indexOf(Math.min(...list)),
      n = list.length;
    const next = list[(k + 1) % n],
      previous = list[(k + n - 1) % n],
      second = Math.min(...list.filter((_, i) => i !== k));
    if (n < 2 || (m.closed ? next <= previous : list.indexOf(second) > k)) return m;
    return {
      ...m,
      frames: [...m.frames].reverse(),
      pose_frames: m.pose_frames.map(f => (m.closed ? (last - f) % last : last - f)),
    };
  }
  function drawLive(view, l, shot, small) {
    return l.parts.map(part => {
      const raw = shot[part.k];
      if (!raw || !raw.length) return null;
      const p = raw.map(q => view.px(q)),
        hot = !small && state.hot.size === 1 && state.hot.has(part.dyad) ? " hot" : "",
        d = pathOf(p, part.closed);
      switch (part.role) {
        case "ground":
          return s("path", { class: "ground", d });
        case "guide":
          return guide(view, p, part.still, hot);
        case "coupler":
          return s("path", { class: "coupler", d });
        case "link":
          return s("g", {}, s("path", { class: "bar-edge", d }), s("path", { class: "bar-core" + hot, d }));
        case "block":
          return s("path", { class: "block" + hot, d: pathOf(small ? resized(p, 4, 7) : resized(p, 10, 20), true) });
        case "frame":
          return small ? null : frameOfPart(p, "", { class: "live-frame" });
        default: {
          const fixed = part.role === "fixed_pivot";
          if (small) return s("circle", { class: fixed ? "pin fixed" : "pin", cx: p[0][0], cy: p[0][1], r: 2.6 });
          return s(
            "g",
            {},
            fixed
              ? support(p[0], hot)
              : s("circle", { class: "pin" + hot, cx: fix(p[0][0]), cy: fix(p[0][1]), r: 4.5 }),
            partLabel(part.label, p[0]),
          );
        }
      }
    });
  }
  function drawGhost(view, l, shot, i) {
    return s(
      "g",
      { style: colour(i) },
      l.parts.map(part => {
        const raw = shot[part.k];
        if (!raw || !raw.length) return null;
        const p = raw.map(q => view.px(q)),
          d = pathOf(p, part.closed);
        if (part.role === "frame") return frameOfPart(p, poseName(i), {});
        if (part.role === "moving_pivot")
          return s("circle", { class: "ghost dot", cx: fix(p[0][0]), cy: fix(p[0][1]), r: 3 });
        if (part.role === "block") return s("path", { class: "ghost", d: pathOf(resized(p, 10, 20), true) });
        if (part.role === "guide" && !part.still) {
          const seg = clip(view, p[0], p[p.length - 1]);
          return seg && s("path", { class: "ghost", d: pathOf(seg) });
        }
        return part.role === "link" || part.role === "coupler" ? s("path", { class: "ghost " + part.role, d }) : null;
      }),
    );
  }
  function scaleBar(view) {
    const goal = Math.min(110, view.w / 4) / view.scale,
      p = 10 ** Math.floor(Math.log10(goal));
    const step = [5, 2, 1].find(k => k * p <= goal) * p,
      w = step * view.scale,
      y = view.h - 16;
    return s(
      "g",
      {},
      s("rect", { class: "scale-ground", x: 6, y: y - 11, width: fix(w + 76), height: 22 }),
      s("path", { class: "scale", d: `M14 ${y - 4}v8M14 ${y}h${fix(w)}m0 -4v8` }),
      text([22 + w, y], `${format(step, 3)}${units.length ? " " + units.length : ""}`, "scale-label", "start"),
    );
  }
  function fixedFrame(view) {
    const o = view.px([0, 0]);
    if (o[0] < 0 || o[1] < 0 || o[0] > view.w || o[1] > view.h - (o[0] < 200 ? 44 : 0)) return [];
    return [
      ...arrow(o, [1, 0], 46, "axis"),
      ...arrow(o, [0, -1], 46, "axis"),
      text(add(o, [54, 0]), "X", "axis-label"),
      text(add(o, [0, -54]), "Y", "axis-label"),
    ];
  }
  function frameAt(motion, u) {
    const f = motion.frames,
      i = clamp(Math.floor(u), 0, f.length - 1),
      t = u - i,
      a = f[i],
      b = f[Math.min(i + 1, f.length - 1)];
    return t < 1e-9
      ? a
      : a.map((line, k) => line.map((p, j) => (b[k] && b[k][j] ? add(p, add(b[k][j], p, -1), t) : p)));
  }
  function tracks(l, motion) {
    // paths of the coupler point and of the moving pivots
    const out = [];
    for (const part of l.parts) {
      const j = part.role === "frame" ? 1 : part.role === "moving_pivot" ? 0 : -1;
      if (j >= 0)
        out.push({ pivot: j === 0, points: motion.frames.map(f => f[part.k] && f[part.k][j]).filter(Boolean) });
    }
    return out;
  }

  function drawDyad(view, d, name = `dyad ${d.id}`) {
    const hot = state.hot.has(d.id) ? " hot" : "",
      g = s("g", {}),
      line = d.line && d.line.point;
    const a = line && d.line.angle * (units.angle === "rad" ? 1 : Math.PI / 180),
      dir = line && [Math.cos(a), Math.sin(a)];
    const far = (4 * (view.w + view.h)) / view.scale;
    const ends = (p, v) => [view.px(add(p, v, -far)), view.px(add(p, v, far))];
    const near = (p, q) => add(q, p, -1)[0] * dir[0] + add(q, p, -1)[1] * dir[1];
    if (d.type === "PR" && line && d.moving) {
      const m = add(line, dir, near(line, inBody(poses[0], d.moving)));
      g.append(guide(view, ends(m, dir), true, hot) || "");
    } else if (d.type === "RP" && line) {
      const o = inBody(poses[0], line),
        v = add(inBody(poses[0], add(line, dir)), o, -1);
      g.append(guide(view, ends(o, v), false, hot) || "");
    } else if (d.fixed && d.moving) {
      const c = view.px(d.fixed),
        r = d.length * view.scale;
      if (r < 20000) g.append(s("circle", { class: "circle" + hot, cx: fix(c[0]), cy: fix(c[1]), r: fix(r) }));
      g.append(s("path", { class: "dyad" + hot, d: pathOf([c, view.px(inBody(poses[0], d.moving))]) }));
    }
    if (d.moving)
      poses.forEach((pose, i) => {
        const p = view.px(inBody(pose, d.moving));
        g.append(
          s("circle", { class: "pin", style: `fill:var(--p${i % 8})`, cx: fix(p[0]), cy: fix(p[1]), r: hot ? 5 : 4 }),
        );
      });
    if (d.fixed) g.append(support(view.px(d.fixed), hot));
    g.append(
      text(add(view.px(d.fixed || inBody(poses[0], d.moving)), [10, -12]), name, "dyad-label", "start"),
    );
    return g;
  }
  function drawFourBar(view, c) {
    // in pose 1: the coupler, with the origin of the moving frame, and both cranks
    const corners = [...c.dyads.map(d => inBody(poses[0], d.moving)), poses[0].origin];
    return s(
      "g",
      {},
      s("path", { class: "coupler", d: pathOf(corners.map(p => view.px(p)), true) }),
      c.dyads.map((d, k) => drawDyad(view, d, ["input", "output"][k])),
    );
  }
  return {
    poseSymbol,
    prepare,
    drawLive,
    drawGhost,
    scaleBar,
    fixedFrame,
    frameAt,
    tracks,
    stops,
    drawDyad,
    drawFourBar,
  };
})();
