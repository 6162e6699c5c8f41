// The report page: reads the embedded document {result, drawing}, draws the figures, fills the tables.
// All drawing happens in screen pixels: a View maps the fixed frame to the screen, symbols keep their size under zoom.
(() => {
"use strict";
const { $, h, s, clamp, add, unit, fix, pathOf, clip, resized, isNumber, plural, format, number, point, copy, col, table, boxOf, View } = tools;
const data = (() => { try { return JSON.parse($("data").textContent); } catch (e) { return {}; } })();
const result = data.result || { message: "This page holds no result." };
const drawing = data.drawing || {};
const poses = drawing.poses || [], dyads = result.dyads || [], curves = result.curves || [];
const linkages = result.linkages || [], units = result.units || {};
const ORDER = ["ground", "guide", "coupler", "link", "block", "moving_pivot", "fixed_pivot", "frame"];
const spheres = new Map((drawing.spheres || []).map(d => [d.linkage, d])), spherical = spheres.size > 0;   // then nothing is drawn in the plane
const drawn = new Map([...(drawing.linkages || []), ...[...spheres.keys()].filter(id => id).map(id => ({ id }))].map(l => [l.id, prepare(l)]));
const state = { id: null, motion: 0, u: 0, playing: false, direction: 1, hot: new Set() };
const colour = i => `--c:var(--p${i % 8})`;
const poseName = i => poses[i] ? poses[i].label : String(i + 1);
const angleUnit = () => units.angle === "rad" ? " rad" : "°";
const poseBox = () => boxOf(poses.map(p => p.origin), 0.14);
function download() {
  const url = URL.createObjectURL(new Blob([JSON.stringify(result, null, 1) + "\n"], { type: "application/json" }));
  h("a", { href: url, download: "result.json" }).click(); setTimeout(() => URL.revokeObjectURL(url), 1000);
}

// ---- symbols --------------------------------------------------------------------------------------------------
const text = (p, str, cls, anchor = "middle") => s("text", { x: fix(p[0]), y: fix(p[1]), class: cls + " halo", "text-anchor": anchor, "dominant-baseline": "central" }, str);
function arrow(o, d, length, cls, open) {
  const n = [-d[1], d[0]], tip = add(o, d, length), foot = add(tip, d, -8);
  return [s("path", { class: cls, d: pathOf([o, foot]) }),
    s("path", { class: `${cls}-head${open ? " open" : ""}`, d: pathOf([tip, add(foot, n, 3.4), add(foot, n, -3.4)], true) })];
}
function frameSymbol(o, dx, dy, length, label, attrs) {   // a full head on the x axis, an open one on the y axis
  const back = unit([0, 0], add(dx, dy));
  return s("g", attrs, arrow(o, dx, length, "pose"), arrow(o, dy, length, "pose", true), s("circle", { class: "pose-dot", cx: fix(o[0]), cy: fix(o[1]), r: 3 }),
    label ? text(add(o, back, -15), label, "pose-label") : null);
}
const poseSymbol = (view, pose, i, length) => frameSymbol(view.px(pose.origin), [pose.x_axis[0], -pose.x_axis[1]], [pose.y_axis[0], -pose.y_axis[1]],
  length, pose.label, { style: colour(i) });
function support(p, hot) {   // fixed pivot: pin, triangle and ground hatching
  const [x, y] = p, marks = [];
  for (let k = -12; k <= 8; k += 5) marks.push(`M${fix(x + k + 5)} ${fix(y + 17)}l-5 6`);
  return s("g", {}, s("path", { class: "hatch", d: marks.join("") }), s("path", { class: "support", d: pathOf([p, [x - 10, y + 17], [x + 10, y + 17]], true) }),
    s("path", { class: "bar-edge", style: "stroke-width:1.5", d: `M${fix(x - 14)} ${fix(y + 17)}h28` }), s("circle", { class: "pin" + hot, cx: fix(x), cy: fix(y), r: 4.5 }));
}
function guide(view, pts, still, hot) {   // a guide of the fixed link is hatched like the ground
  const seg = pts.length > 1 && clip(view, pts[0], pts[pts.length - 1]);
  if (!seg) return null;
  let d = unit(...seg), marks = ""; if (d[0] < 0) d = [-d[0], -d[1]];
  const start = d[0] === unit(...seg)[0] ? seg[0] : seg[1], length = Math.hypot(...add(seg[1], seg[0], -1));
  for (let k = 4; still && k < Math.min(length, 4000); k += 8) { const p = add(start, d, k); marks += pathOf([p, add(add(p, d, -5), [-d[1], d[0]], 6)]); }
  return s("g", {}, s("path", { class: "hatch", d: marks }), s("path", { class: "guide" + hot, d: pathOf(seg) }));
}
function partLabel(label, p) {
  if (!label || label.length > 4) return null;
  const m = /^(\D+)(\d+)$/.exec(label), t = text(add(p, [13, -13]), m ? m[1] : label, "part-label");
  if (m) t.append(s("tspan", { dy: 5, "font-size": 11 }, m[2]));
  return t;
}
function frameOfPart(pts, label, attrs) {
  if (pts.length < 3) return null;
  const size = clamp(Math.hypot(...add(pts[0], pts[1], -1)), 14, 44);
  return frameSymbol(pts[1], unit(pts[1], pts[0]), unit(pts[1], pts[2]), size, label, attrs);
}

// ---- mechanisms -----------------------------------------------------------------------------------------------
function prepare(l) {   // which parts stay put, closed motions end where they begin
  const shots = l.at_pose || [], same = (a, b) => a && b && JSON.stringify(a) === JSON.stringify(b);
  const parts = (l.parts || []).map((p, k) => ({ ...p, k, still: shots.every(f => same(f[k], shots[0][k])) }));
  const motions = (l.motions || []).filter(m => m.frames && m.frames.length).map(m => forward(m.closed && !same(m.frames[0], m.frames[m.frames.length - 1])
    ? { ...m, frames: [...m.frames, m.frames[0]] } : m));
  parts.sort((a, b) => ORDER.indexOf(a.role) - ORDER.indexOf(b.role));
  return { ...l, parts, motions, at_pose: shots };
}
function forward(m) {   // run the motion in the direction that meets its poses in the order of their numbers, if one does
  const list = stops(m).map(t => t.pose), last = m.frames.length - 1, k = list.indexOf(Math.min(...list)), n = list.length;
  const next = list[(k + 1) % n], previous = list[(k + n - 1) % n], second = Math.min(...list.filter((_, i) => i !== k));
  if (n < 2 || (m.closed ? next <= previous : list.indexOf(second) > k)) return m;
  return { ...m, frames: [...m.frames].reverse(), pose_frames: m.pose_frames.map(f => m.closed ? (last - f) % last : last - f) };
}
function drawLive(view, l, shot, small) {
  return l.parts.map(part => {
    const raw = shot[part.k]; if (!raw || !raw.length) return null;
    const p = raw.map(q => view.px(q)), hot = !small && state.hot.size === 1 && state.hot.has(part.dyad) ? " hot" : "", d = pathOf(p, part.closed);
    switch (part.role) {
      case "ground": return s("path", { class: "ground", d });
      case "guide": return guide(view, p, part.still, hot);
      case "coupler": return s("path", { class: "coupler", d });
      case "link": return s("g", {}, s("path", { class: "bar-edge", d }), s("path", { class: "bar-core" + hot, d }));
      case "block": return s("path", { class: "block" + hot, d: pathOf(small ? resized(p, 4, 7) : resized(p, 10, 20), true) });
      case "frame": return small ? null : frameOfPart(p, "", { class: "live-frame" });
      default: {
        const fixed = part.role === "fixed_pivot";
        if (small) return s("circle", { class: fixed ? "pin fixed" : "pin", cx: p[0][0], cy: p[0][1], r: 2.6 });
        return s("g", {}, fixed ? support(p[0], hot) : s("circle", { class: "pin" + hot, cx: fix(p[0][0]), cy: fix(p[0][1]), r: 4.5 }), partLabel(part.label, p[0]));
      }
    }
  });
}
function drawGhost(view, l, shot, i) {
  return s("g", { style: colour(i) }, l.parts.map(part => {
    const raw = shot[part.k]; if (!raw || !raw.length) return null;
    const p = raw.map(q => view.px(q)), d = pathOf(p, part.closed);
    if (part.role === "frame") return frameOfPart(p, poseName(i), {});
    if (part.role === "moving_pivot") return s("circle", { class: "ghost dot", cx: fix(p[0][0]), cy: fix(p[0][1]), r: 3 });
    if (part.role === "block") return s("path", { class: "ghost", d: pathOf(resized(p, 10, 20), true) });
    if (part.role === "guide" && !part.still) { const seg = clip(view, p[0], p[p.length - 1]); return seg && s("path", { class: "ghost", d: pathOf(seg) }); }
    return part.role === "link" || part.role === "coupler" ? s("path", { class: "ghost " + part.role, d }) : null;
  }));
}
function scaleBar(view) {
  const goal = Math.min(110, view.w / 4) / view.scale, p = 10 ** Math.floor(Math.log10(goal));
  const step = [5, 2, 1].find(k => k * p <= goal) * p, w = step * view.scale, y = view.h - 16;
  return s("g", {}, s("rect", { class: "scale-ground", x: 6, y: y - 11, width: fix(w + 76), height: 22 }),
    s("path", { class: "scale", d: `M14 ${y - 4}v8M14 ${y}h${fix(w)}m0 -4v8` }),
    text([22 + w, y], `${format(step, 3)}${units.length ? " " + units.length : ""}`, "scale-label", "start"));
}
function fixedFrame(view) {
  const o = view.px([0, 0]);
  if (o[0] < 0 || o[1] < 0 || o[0] > view.w || o[1] > view.h - (o[0] < 200 ? 44 : 0)) return [];
  return [...arrow(o, [1, 0], 46, "axis"), ...arrow(o, [0, -1], 46, "axis"), text(add(o, [54, 0]), "X", "axis-label"), text(add(o, [0, -54]), "Y", "axis-label")];
}
function frameAt(motion, u) {
  const f = motion.frames, i = clamp(Math.floor(u), 0, f.length - 1), t = u - i, a = f[i], b = f[Math.min(i + 1, f.length - 1)];
  return t < 1e-9 ? a : a.map((line, k) => line.map((p, j) => b[k] && b[k][j] ? add(p, add(b[k][j], p, -1), t) : p));
}
function tracks(l, motion) {   // paths of the coupler point and of the moving pivots
  const out = [];
  for (const part of l.parts) {
    const j = part.role === "frame" ? 1 : part.role === "moving_pivot" ? 0 : -1;
    if (j >= 0) out.push({ pivot: j === 0, points: motion.frames.map(f => f[part.k] && f[part.k][j]).filter(Boolean) });
  }
  return out;
}

// ---- figure 1: poses ------------------------------------------------------------------------------------------
const inBody = (pose, q) => add(add(pose.origin, pose.x_axis, q[0]), pose.y_axis, q[1]);
const planar = d => (d.fixed || d.moving) && [d.fixed, d.moving].every(p => !p || p.length === 2);
function dyadPoints(d) { return [d.fixed, d.moving && poses[0] && inBody(poses[0], d.moving)].filter(Boolean); }
function drawDyad(view, d) {
  const hot = state.hot.has(d.id) ? " hot" : "", g = s("g", {}), line = d.line && d.line.point;
  const a = line && d.line.angle * (units.angle === "rad" ? 1 : Math.PI / 180), dir = line && [Math.cos(a), Math.sin(a)];
  const far = 4 * (view.w + view.h) / view.scale;
  const ends = (p, v) => [view.px(add(p, v, -far)), view.px(add(p, v, far))];
  const near = (p, q) => add(q, p, -1)[0] * dir[0] + add(q, p, -1)[1] * dir[1];
  if (d.type === "PR" && line && d.moving) {
    const m = add(line, dir, near(line, inBody(poses[0], d.moving))); g.append(guide(view, ends(m, dir), true, hot) || "");
  } else if (d.type === "RP" && line) {
    const o = inBody(poses[0], line), v = add(inBody(poses[0], add(line, dir)), o, -1); g.append(guide(view, ends(o, v), false, hot) || "");
  } else if (d.fixed && d.moving) {
    const c = view.px(d.fixed), r = d.length * view.scale;
    if (r < 20000) g.append(s("circle", { class: "circle" + hot, cx: fix(c[0]), cy: fix(c[1]), r: fix(r) }));
    g.append(s("path", { class: "dyad" + hot, d: pathOf([c, view.px(inBody(poses[0], d.moving))]) }));
  }
  if (d.moving) poses.forEach((pose, i) => { const p = view.px(inBody(pose, d.moving));
    g.append(s("circle", { class: "pin", style: `fill:var(--p${i % 8})`, cx: fix(p[0]), cy: fix(p[1]), r: hot ? 5 : 4 })); });
  if (d.fixed) g.append(support(view.px(d.fixed), hot));
  g.append(text(add(view.px(d.fixed || inBody(poses[0], d.moving)), [10, -12]), `dyad ${d.id}`, "dyad-label", "start"));
  return g;
}
const shownStroke = t => (t.pose <= 1 || t.role === "task" || $("show-ghosts").checked) && (t.role !== "path" || $("show-path").checked)
  && (!t.role.endsWith("_curve") || $("show-curves").checked);
function drawSphere(view, svg, id) {
  if (spheres.has(id)) svg.replaceChildren(...sphereTools.globe(view, spheres.get(id), shownStroke, state.hot.size === 1 ? [...state.hot][0] : -1, false));
}
function drawPoses() {
  if (spherical) return drawSphere(view1, $("svg-poses"), 0);
  const o = poses.map(p => view1.px(p.origin));
  const gaps = o.map((p, i) => Math.min(...o.filter((_, j) => j !== i).map(q => Math.hypot(...add(p, q, -1))))).sort((a, b) => a - b);
  const size = clamp(0.45 * (gaps[gaps.length >> 1] || 100), 18, 46), out = fixedFrame(view1);
  if ($("show-curves").checked) for (const c of curves) {
    const put = (pts, cls) => pts && pts.length && pts[0].length === 2 && out.push(s("path", { class: cls, d: pathOf(pts.map(q => view1.px(q)), c.closed) }));
    put(c.fixed, "curve-fixed"); put(c.moving && c.moving.map(q => inBody(poses[0], q)), "curve-moving");
  }
  const shown = dyads.filter(d => planar(d) && ($("show-dyads").checked || state.hot.has(d.id)));
  out.push(...shown.map(d => drawDyad(view1, d)), ...poses.map((p, i) => poseSymbol(view1, p, i, size)), scaleBar(view1));
  $("svg-poses").replaceChildren(...out);
}

// ---- figure 2: the selected linkage ---------------------------------------------------------------------------
const layer = { back: s("g", {}), live: s("g", {}) };
const current = () => drawn.get(state.id);
const motionNow = () => current() && current().motions[state.motion];
function drawLinkage() {
  if (spherical) return drawSphere(view2, $("svg-linkage"), state.id);
  const l = current(), m = motionNow(), out = fixedFrame(view2);
  if (!l) return;
  if (m) for (const t of tracks(l, m)) if ($(t.pivot ? "show-pivots" : "show-path").checked)
    out.push(s("path", { class: t.pivot ? "path pivot" : "path", d: pathOf(t.points.map(q => view2.px(q))) }));
  if ($("show-ghosts").checked) l.at_pose.forEach((shot, i) => out.push(drawGhost(view2, l, shot, i)));
  out.push(scaleBar(view2));
  layer.back.replaceChildren(...out);
  drawNow();
}
function drawNow() {
  if (spherical) return drawLinkage();
  const l = current(), m = motionNow(), shot = m ? frameAt(m, state.u) : l && l.at_pose[0];
  if (shot) layer.live.replaceChildren(...drawLive(view2, l, shot).filter(Boolean));
}
function stops(m) { return m.pose_frames.map((f, k) => ({ f, pose: m.poses[k] - 1 })).sort((a, b) => a.f - b.f); }
function whereText(m) {
  const list = stops(m), at = list.find(t => Math.abs(t.f - state.u) < 0.25), name = t => poseName(t.pose);
  if (at) return `at pose ${name(at)}`;
  if (!list.length) return "";
  const before = list.filter(t => t.f < state.u).pop(), after = list.find(t => t.f > state.u), wrap = m.closed && list.length > 1;
  if (before && after) return `between poses ${name(before)} and ${name(after)}`;
  if (wrap) return `between poses ${name(list[list.length - 1])} and ${name(list[0])}`;
  return before ? `after pose ${name(before)}` : `before pose ${name(after)}`;
}
function setPosition(u) {
  const m = motionNow(); if (!m) return;
  const slider = $("slider"), said = (state.u = clamp(u, 0, m.frames.length - 1), whereText(m));
  slider.value = state.u; slider.setAttribute("aria-valuetext", said); $("where").textContent = said;
  for (const b of $("ticks").children) b.classList.toggle("at", Math.abs(b.dataset.f - state.u) < 0.25);
  drawNow();
}
function setMotion(k) {
  const l = current(), m = l && l.motions[k];
  state.motion = k; state.direction = 1;
  $("player").hidden = !m;
  if (!m) return drawLinkage();
  $("slider").max = m.frames.length - 1;
  for (const b of $("motions").children) b.setAttribute("aria-pressed", +b.dataset.k === k);
  drawTicks(); state.u = m.pose_frames.length ? m.pose_frames[0] : 0;
  drawLinkage(); setPosition(state.u);
}
function drawTicks() {
  const m = motionNow(), width = $("ticks").clientWidth || 300; let last = -1e9, level = 0;
  $("ticks").replaceChildren(...(m ? stops(m) : []).map(t => {
    const at = t.f / Math.max(1, m.frames.length - 1);
    level = at * width - last < 20 ? 1 - level : 0; last = at * width;
    return h("button", { type: "button", "data-f": t.f, "data-level": level, style: `left:${100 * at}%;${colour(t.pose)}`, "aria-label": `Go to pose ${poseName(t.pose)}`,
      onclick: () => { play(false); setPosition(t.f); } }, poseName(t.pose));
  }));
  $("ticks").style.height = [...$("ticks").children].some(b => b.dataset.level === "1") ? "40px" : "";
}
function motionNote(l) {
  if (spherical) return "";
  const seen = new Set(l.motions.flatMap(m => m.poses)), missing = poses.map((_, i) => i + 1).filter(i => !seen.has(i)).map(i => poseName(i - 1));
  if (!l.motions.length) return "No motion was sampled for this linkage; it is drawn in the task poses only.";
  return [l.motions.length > 1 ? "The poses are not all on one assembly circuit (sampled, not certified)." : "",
    missing.length ? `The sampled motion did not reach pose ${missing.join(", ")}.` : ""].filter(Boolean).join(" ");
}
function select(id) {
  const info = linkages.find(l => l.id === id), l = drawn.get(id);
  if (!info || !l) return false;
  play(false); state.id = id; state.motion = 0;
  for (const c of $("cards").children) c.setAttribute("aria-pressed", +c.dataset.id === id);
  for (const r of document.querySelectorAll("tr[data-linkage]")) r.classList.toggle("chosen", +r.dataset.linkage === id);
  const note = motionNote(l), many = l.motions.length > 1;
  $("motion-note").textContent = note; $("motion-note").hidden = !note; $("motions").hidden = !many;
  $("motions").replaceChildren(...l.motions.map((m, k) => h("button", { type: "button", "data-k": k, onclick: () => { play(false); setMotion(k); } },
    `${m.poses.length === 1 ? "pose" : "poses"} ${m.poses.map(i => poseName(i - 1)).join(", ")}`)));
  const facts = lengths(info).map(([k, v]) => `${k} ${format(v)}${spherical ? angleUnit() : ""}`).join(", ");
  $("cap-linkage").replaceChildren(h("b", {}, "Figure 2. "), `Linkage ${id}: ${kind(info)}, of dyads ${info.dyads.join(" and ")}`, facts ? `; ${facts}. ` : ". ",
    spherical ? "Strong: pose 1; thin: the other poses. Amber: task attitudes, red: the coupler and its attitudes. Dotted: path of the moving x axis. Drag to turn."
      : "Ghosts in colour: the linkage in the task poses. Thin curve: path of the origin of the moving frame.", info.verdict ? ` ${info.verdict}.` : "");
  if (spherical) view2.aim(spheres.get(id).views[0]);
  view2.fit(view2.fits.fit()); setMotion(0);
  return true;
}
function play(on) {
  const m = motionNow();
  state.playing = Boolean(on && m && m.frames.length > 1);
  $("play").setAttribute("aria-pressed", state.playing); $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
  if (!state.playing) return;
  let then = performance.now();
  const step = now => {
    if (!state.playing) return;
    const last = m.frames.length - 1, du = state.direction * Math.min(now - then, 100) / 9000 * last; then = now;
    let u = state.u + du;
    if (m.closed) u = ((u % last) + last) % last; else if (u > last || u < 0) { state.direction = u < 0 ? 1 : -1; u = clamp(u, 0, last); }
    setPosition(u); requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

// ---- words, tables, gallery -----------------------------------------------------------------------------------
const kind = l => l.class ? `${l.type}, ${l.class}` : l.type;
const lengths = l => Object.entries({ ...(l.links || {}), offset: l.links && isNumber(l.links.offset) ? l.links.offset : l.offset })
  .filter(([, v]) => isNumber(v));
const TYPES = { RR: "fixed pivot and moving pivot", PR: "slider on a fixed line, moving pivot", RP: "fixed pivot, slider on a moving line", PP: "two sliders" };
function highlight(ids, linkage = null) {
  state.hot = new Set(ids);
  const touches = l => linkage !== null ? l.id === linkage : l.dyads.some(d => state.hot.has(d));
  for (const c of $("cards").children) c.classList.toggle("hot", touches(linkages.find(l => l.id === +c.dataset.id)));
  for (const r of document.querySelectorAll("tr[data-dyad]")) r.classList.toggle("hot", state.hot.has(+r.dataset.dyad));
  for (const r of document.querySelectorAll("tr[data-linkage]")) r.classList.toggle("hot", +r.dataset.linkage === linkage);
  drawPoses(); drawNow();
}
const hover = (ids, linkage) => ({ onmouseenter: () => highlight(ids, linkage), onmouseleave: () => highlight([]),
  onfocusin: () => highlight(ids, linkage), onfocusout: () => highlight([]) });
const copier = (value, what) => h("button", { type: "button", "aria-label": `Copy ${what} as JSON`, onclick: () => copy(value, what) }, "Copy");
function reach(d) {
  if (d.line) return h("span", { class: "wide" }, "line through ", point(d.line.point), " at ", number(d.line.angle, 6, angleUnit()));
  if (isNumber(d.arc)) return number(d.arc, 6, angleUnit());
  return isNumber(d.length) ? h("span", {}, number(d.length), d.slider ? h("span", { class: "sub" }, `nearly the slider ${d.slider.type}`) : "")
    : isNumber(d.angle) ? h("span", {}, "coupler kept at ", number(d.angle, 6, angleUnit())) : null;
}
const angles = list => h("span", { class: "num" }, list.map(v => format(units.angle === "rad" ? v * Math.PI / 180 : v) + angleUnit()).join(", "));
const pivot = p => spherical && Array.isArray(p) ? h("span", {}, point(p), h("span", { class: "sub" }, "longitude, latitude ", angles(sphereTools.place(p)))) : point(p);
function fillTables() {
  const small = (v, digits) => isNumber(v) ? number(v, digits) : null, given = (result.poses || []).map((p, i) => ({ p, name: poseName(i) }));
  table("table-dyads", "Dyads", [
    col("Dyad", d => String(d.id)), col("Type", d => h("span", { title: TYPES[d.type] }, d.type)),
    col(spherical ? "Fixed axis" : "Fixed pivot", d => pivot(d.fixed)), col(spherical ? "Moving axis" : "Moving pivot", d => pivot(d.moving)),
    col(spherical ? "Arc" : "Length or line", reach),
    col("Residual", d => small(d.residual, 2), true), col("Condition", d => small(d.condition, 3), true),
    col("Certificate", certificate), col("", d => copier(d, `dyad ${d.id}`), true),
  ], dyads, d => ({ "data-dyad": d.id, ...hover([d.id]) }));
  const link = key => col(key[0].toUpperCase() + key.slice(1), l => small(Object.fromEntries(lengths(l))[key]), true);
  const show = l => { select(l.id); $("linkages").scrollIntoView({ block: "start" }); };
  table("table-linkages", spherical ? `Link arcs (${units.angle})` : "Link lengths", [
    col("Linkage", l => drawn.has(l.id) ? h("button", { type: "button", class: "id", title: "Show in figure 2", onclick: () => show(l) }, String(l.id)) : String(l.id)),
    col("Type", l => l.type), col("Class", l => l.class || null), col("Dyads", l => l.dyads.join(", ")),
    ...["ground", "input", "coupler", "output", "offset"].map(link), col("Verdict", l => l.verdict || null),
    col("Circuit of each pose", l => l.circuit_of_pose ? l.circuit_of_pose.map(c => c ?? "–").join(" ") : null), col("", l => copier(l, `linkage ${l.id}`), true),
  ], linkages, l => ({ "data-linkage": l.id, ...hover(l.dyads, l.id) }));
  table("table-poses", "Task poses", [
    col("Pose", r => r.name), col("x", r => small(r.p.x), true), col("y", r => small(r.p.y), true),
    col("Angle", r => isNumber(r.p.angle) ? number(r.p.angle, 6, angleUnit()) : null, true),
    col("Quaternion (w, x, y, z)", r => point(r.p.quaternion_wxyz)),
    col("Longitude, latitude, roll of the moving x axis", r => r.p.quaternion_wxyz ? angles(sphereTools.globeAngles(r.p.quaternion_wxyz)) : null), col("", r => copier(r.p, `pose ${r.name}`), true),
  ], given, () => ({}));
}
const roundedUp = x => { const unit = 10 ** (Math.floor(Math.log10(x)) - 1); return x > 0 ? Math.ceil(x / unit) * unit : x; };  // to two digits
function certificate(d) {
  const c = d.certificate; if (!c) return null;
  return c.certified ? h("span", { class: "num", title: `within ${c.radius} of the true dyad` }, isNumber(c.radius) ? `proved, ±${format(roundedUp(c.radius), 2)}` : "proved") : "not proved";
}
function thumbnail(l) {
  if (spherical) return sphereTools.thumbnail(spheres.get(l.id), t => t.pose <= 1 && t.role !== "path");
  const svg = s("svg", { class: "thumb", viewBox: "0 0 96 88", "aria-hidden": "true" }), shot = l.at_pose[0];
  if (!shot) return svg;
  const b = boxOf(l.parts.filter(p => p.role !== "guide").flatMap(p => shot[p.k] || [])), scale = Math.min(72 / (b[2] - b[0] || 1e-9), 64 / (b[3] - b[1] || 1e-9));
  const c = [(b[0] + b[2]) / 2, (b[1] + b[3]) / 2], view = { w: 96, h: 88, scale, px: p => [48 + (p[0] - c[0]) * scale, 44 - (p[1] - c[1]) * scale] };
  svg.append(...drawLive(view, l, shot, true).filter(Boolean));
  return svg;
}
function card(info) {
  const flag = info.usable === undefined || info.usable === null ? null : h("span", { class: info.usable ? "flag good" : "flag" }, info.usable ? "usable" : "defect");
  return h("button", { type: "button", class: "card", "data-id": info.id, "aria-pressed": "false", "aria-label": `Linkage ${info.id}, ${kind(info)}`,
    onclick: () => select(info.id), ...hover(info.dyads, info.id) }, thumbnail(drawn.get(info.id)),
  h("span", {}, h("b", {}, `${info.id}. ${info.type}`), h("span", { class: "kind" }, info.class || `dyads ${info.dyads.join(", ")}`),
    h("span", { class: "lengths" }, lengths(info).map(([k, v]) => [h("span", {}, k), h("span", { title: v }, format(v) + (spherical ? angleUnit() : ""))])), flag));
}
function dyadWords() {
  const n = result.solutions || {}, best = result.status === "approximate" ? "real best-fit dyad" : "real dyad", list = [];
  if (n.dimension > 0) list.push(`infinitely many: a family with ${n.dimension === 1 ? "one parameter" : `${n.dimension} parameters`}`);
  if (isNumber(n.real)) list.push(plural(n.real, best) + (isNumber(n.complex) ? ` (of ${n.complex} over the complex numbers)` : ""));
  if (!list.length || (isNumber(n.real) ? n.real !== dyads.length : dyads.length)) list.push(`${dyads.length} listed`);
  return list.join("; ") + (n.certified ? "; count proved" : "");
}
function fillHead() {
  const count = result.pose_count || poses.length, name = result.name || (count ? `Linkages through ${count} poses` : "Burmester report");
  $("name").textContent = name; document.title = `${name} · Burmester`;
  $("source").textContent = result.source || ""; $("source").hidden = !result.source;
  $("message").textContent = result.message ? result.message[0].toUpperCase() + result.message.slice(1).replace(/\.?$/, ".") : "";
  const usable = linkages.filter(l => l.usable).length, judged = linkages.some(l => typeof l.usable === "boolean");
  const rows = [["Status", result.status], ["Poses", isNumber(result.pose_count) ? `${result.pose_count}, ${result.geometry}` : null],
    ["Dyads", result.solutions ? dyadWords() : null], ["Linkages", result.linkages ? plural(linkages.length, "linkage") + (judged ? `, ${usable} usable` : "") : null],
    ["Units", [units.length, units.angle].filter(Boolean).join(", ")]];
  $("facts").append(...rows.filter(r => r[1]).flatMap(([k, v]) => [h("dt", {}, k), h("dd", {}, v)]));
  const w = (result.warnings || []).map(x => typeof x === "string" ? x : x.message || JSON.stringify(x));
  $("warnings").hidden = !w.length;
  $("warnings").append(w.length > 1 ? h("ul", {}, w.map(x => h("li", {}, x))) : h("p", {}, w[0] || ""));
  if (spherical) $("cap-poses").append(h("b", {}, "Figure 1. "), "The task attitudes: a dot where the moving x axis pierces the unit sphere, full arrowhead towards the y axis, open towards the z axis. Far side dashed. Drag to turn.",
    curves.length ? " Curves: fixed axes (black) and moving axes as they lie in pose 1 (red)." : "");
  else $("cap-poses").append(h("b", {}, "Figure 1. "), "The moving frame in the task poses; full arrowhead: x axis, open: y axis.",
    dyads.some(planar) ? " With “dyads” ticked: every dyad in pose 1, its moving pivot in all poses." : "",
    curves.length ? " Curves: fixed pivots (solid) and moving pivots as they lie in pose 1 (dashed)." : "");
}
function fillEmpty() {
  const open = linkages.some(l => drawn.has(l.id)), family = result.status === "family"; $("bench").hidden = !open; $("empty").hidden = open;
  if (open) return;
  const [head, why] = linkages.length ? ["No drawing of these linkages", `The ${result.geometry || ""} linkages are listed below.`]
    : family ? ["Infinitely many linkages", "Give fixed or moving pivots, or more poses, to single some out."]
    : result.status === "degenerate" ? ["No single linkage", "Isolated dyads, if there are any, are listed below."]
    : dyads.length ? ["No linkage", dyads.length === 1 ? "One dyad alone does not make a linkage: two are needed." : "The dyads are listed below."]
    : ["No real dyad exists", "No planar linkage of two dyads passes these poses.".replace("planar", result.geometry || "planar")];
  const message = $("message").textContent, echo = message.toLowerCase().replace(/\.$/, "") === head.toLowerCase();
  $("empty").append(h("p", {}, head), h("p", {}, echo ? why : `${message} ${why}`));
}

// ---- set-up ---------------------------------------------------------------------------------------------------
const reachBox = () => boxOf([...poses.map(p => p.origin), ...dyads.filter(planar).flatMap(dyadPoints)], 0.06);
const view1 = spherical ? new sphereTools.Globe($("svg-poses"), drawPoses) : new View($("svg-poses"), drawPoses, { fit: poseBox, fit2: reachBox }, 46);
const view2 = spherical ? new sphereTools.Globe($("svg-linkage"), drawLinkage) : new View($("svg-linkage"), drawLinkage, { fit: () => (current() && current().window) || poseBox(), fit2: poseBox }, 56);
function setUpSpheres() {   // buttons for the views instead of fitting
  for (const id of ["show-dyads-label", "show-pivots-label"]) $(id).hidden = true;
  const buttons = (view, id) => spheres.get(id()).views.map((v, k) => h("button", { type: "button", title: `Look ${v.name}`,
    onclick: () => { view.aim(spheres.get(id()).views[k]); view.fit(); } }, ["mean", "x", "y", "z"][k]));
  for (const g of document.querySelectorAll(".group")) {
    const first = g.dataset.view === "poses", id = () => first ? 0 : state.id || 0;
    for (const b of g.querySelectorAll("[data-act^=fit]")) b.remove();
    g.append(...buttons(first ? view1 : view2, id));
  }
  for (const [svg, name] of [["svg-poses", "Task attitudes"], ["svg-linkage", "The selected linkage"]])
    $(svg).setAttribute("aria-label", `${name} on the unit sphere. Arrow keys turn, plus and minus zoom, 0 fits.`);
  view1.aim(spheres.get(0).views[0]);
}
function setUp() {
  if (spherical) setUpSpheres();
  fillHead(); fillEmpty(); fillTables();
  const figure = spherical || poses.length > 0; $("fig-poses").hidden = !figure; document.querySelector(".lead").classList.toggle("alone", !figure);
  $("show-curves-label").hidden = !curves.length;
  $("cards").append(...linkages.filter(l => drawn.has(l.id)).map(card));
  if (!spherical) $("svg-linkage").append(layer.back, layer.live);
  $("download").addEventListener("click", download); $("copy-result").addEventListener("click", () => copy(result, "result"));
  $("play").addEventListener("click", () => play(!state.playing));
  $("slider").addEventListener("input", e => { play(false); setPosition(+e.target.value); });
  for (const id of ["show-ghosts", "show-path", "show-pivots"]) $(id).addEventListener("change", drawLinkage);
  for (const id of ["show-dyads", "show-curves"]) $(id).addEventListener("change", drawPoses);
  for (const g of document.querySelectorAll(".group")) g.addEventListener("click", e => {
    if (e.target.dataset.act) (g.dataset.view === "poses" ? view1 : view2).act(e.target.dataset.act);
  });
  new ResizeObserver(drawTicks).observe($("ticks"));
  view1.resize(); view2.resize();
  const open = linkages.filter(l => drawn.has(l.id)), best = [open.filter(l => l.usable), open.filter(l => drawn.get(l.id).motions.length === 1), open].find(some => some.length) || [];
  const extent = l => { const w = drawn.get(l.id).window; return w ? Math.max(w[2] - w[0], w[3] - w[1]) : 0; };
  const first = best.reduce((a, b) => !a || extent(b) < extent(a) ? b : a, null);  // the most compact one shows best
  if (first) select(first.id);
  window.burmesterReport = {
    ready: true, select,
    setFraction: t => { const m = motionNow(); play(false); if (m) setPosition(clamp(t, 0, 1) * (m.frames.length - 1)); },
    setMotion: k => { play(false); if (current() && current().motions[k]) setMotion(k); },
    state: () => { const l = current(), m = motionNow(); return { linkage: state.id, motion: state.motion, motions: l ? l.motions.length : 0, position: state.u,
      fraction: m ? state.u / Math.max(1, m.frames.length - 1) : 0, frames: m ? m.frames.length : 0, where: m ? whereText(m) : "", playing: state.playing,
      poses: poses.length, dyads: dyads.length, linkages: linkages.length }; },
  };
  document.documentElement.dataset.ready = "1";
}
setUp();
})();
