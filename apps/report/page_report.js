// What the page shows: the embedded document {result, drawing}, and what is selected.
const report = (() => {
  "use strict";
  const { $, add, isNumber } = tools;
  const data = (() => {
    try {
      return JSON.parse($("data").textContent);
    } catch (e) {
      return {};
    }
  })();
  const result = data.result || { message: "This page holds no result." };
  const drawing = data.drawing || {};
  const poses = drawing.poses || [],
    dyads = result.dyads || [],
    curves = result.curves || [];
  const linkages = result.linkages || [],
    candidates = result.candidates || [],
    units = result.units || {};
  const spheres = new Map((drawing.spheres || []).map(d => [d.linkage, d]));
  const spherical = spheres.size > 0; // then nothing is drawn in the plane
  const state = { id: null, motion: 0, u: 0, playing: false, direction: 1, hot: new Set(), candidate: null };
  const colour = i => `--c:var(--p${i % 8})`;
  const poseName = i => (poses[i] ? poses[i].label : String(i + 1));
  const angleUnit = () => (units.angle === "rad" ? " rad" : "°");
  const inBody = (pose, q) => add(add(pose.origin, pose.x_axis, q[0]), pose.y_axis, q[1]);
  const planar = d => (d.fixed || d.moving) && [d.fixed, d.moving].every(p => !p || p.length === 2);
  function dyadPoints(d) {
    return [d.fixed, d.moving && poses[0] && inBody(poses[0], d.moving)].filter(Boolean);
  }
  const lengths = l =>
    Object.entries({
      ...(l.links || {}),
      offset: l.links && isNumber(l.links.offset) ? l.links.offset : l.offset,
    }).filter(([, v]) => isNumber(v));
  return {
    result,
    drawing,
    poses,
    dyads,
    curves,
    linkages,
    candidates,
    units,
    spheres,
    spherical,
    state,
    colour,
    poseName,
    angleUnit,
    inBody,
    planar,
    dyadPoints,
    lengths,
  };
})();
