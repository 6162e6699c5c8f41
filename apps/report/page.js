// The report page: the two figures, the player, and what the reader can press.
(() => {
  "use strict";
  const { $, h, s, clamp, add, unit, pathOf, copy, boxOf, View } = tools;
  const {
    result,
    drawing,
    poses,
    dyads,
    curves,
    linkages,
    spheres,
    spherical,
    state,
    colour,
    poseName,
    inBody,
    planar,
    dyadPoints,
  } = report;
  const { poseSymbol, drawLive, drawGhost, scaleBar, fixedFrame, frameAt, tracks, stops } = plane;
  const { drawDyad, drawFourBar } = plane;
  const drawn = new Map(
    [...(drawing.linkages || []), ...[...spheres.keys()].filter(id => id).map(id => ({ id }))].map(l => [
      l.id,
      plane.prepare(l),
    ]),
  );
  const poseBox = () =>
    boxOf(
      poses.map(p => p.origin),
      0.14,
    );
  function download() {
    const url = URL.createObjectURL(new Blob([JSON.stringify(result, null, 1) + "\n"], { type: "application/json" }));
    h("a", { href: url, download: "result.json" }).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  }

  // ---- figure 1: poses ------------------------------------------------------------------------------------------
  const shownStroke = t =>
    (t.pose <= 1 || t.role === "task" || $("show-ghosts").checked) &&
    (t.role !== "path" || $("show-path").checked) &&
    (!t.role.endsWith("_curve") || $("show-curves").checked);
  function drawSphere(view, svg, id) {
    if (spheres.has(id))
      svg.replaceChildren(
        ...sphereTools.globe(view, spheres.get(id), shownStroke, state.hot.size === 1 ? [...state.hot][0] : -1, false),
      );
  }
  function drawPoses() {
    if (spherical) return drawSphere(view1, $("svg-poses"), 0);
    const o = poses.map(p => view1.px(p.origin));
    const gaps = o
      .map((p, i) => Math.min(...o.filter((_, j) => j !== i).map(q => Math.hypot(...add(p, q, -1)))))
      .sort((a, b) => a - b);
    const size = clamp(0.45 * (gaps[gaps.length >> 1] || 100), 18, 46),
      out = fixedFrame(view1);
    if ($("show-curves").checked)
      for (const c of curves) {
        const put = (pts, cls) =>
          pts &&
          pts.length &&
          pts[0].length === 2 &&
          out.push(
            s("path", {
              class: cls,
              d: pathOf(
                pts.map(q => view1.px(q)),
                c.closed,
              ),
            }),
          );
        put(c.fixed, "curve-fixed");
        put(c.moving && c.moving.map(q => inBody(poses[0], q)), "curve-moving");
      }
    const shown = dyads.filter(d => planar(d) && ($("show-dyads").checked || state.hot.has(d.id)));
    if (state.candidate) out.push(drawFourBar(view1, state.candidate));
    out.push(
      ...shown.map(d => drawDyad(view1, d)),
      ...poses.map((p, i) => poseSymbol(view1, p, i, size)),
      scaleBar(view1),
    );
    $("svg-poses").replaceChildren(...out);
  }

  // ---- figure 2: the selected linkage ---------------------------------------------------------------------------
  const layer = { back: s("g", {}), live: s("g", {}) };
  const current = () => drawn.get(state.id);
  const motionNow = () => current() && current().motions[state.motion];
  function drawLinkage() {
    if (spherical) return drawSphere(view2, $("svg-linkage"), state.id);
    const l = current(),
      m = motionNow(),
      out = fixedFrame(view2);
    if (!l) return;
    if (m)
      for (const t of tracks(l, m))
        if ($(t.pivot ? "show-pivots" : "show-path").checked)
          out.push(s("path", { class: t.pivot ? "path pivot" : "path", d: pathOf(t.points.map(q => view2.px(q))) }));
    if ($("show-ghosts").checked) l.at_pose.forEach((shot, i) => out.push(drawGhost(view2, l, shot, i)));
    out.push(scaleBar(view2));
    layer.back.replaceChildren(...out);
    drawNow();
  }
  function drawNow() {
    if (spherical) return drawLinkage();
    const l = current(),
      m = motionNow(),
      shot = m ? frameAt(m, state.u) : l && l.at_pose[0];
    if (shot) layer.live.replaceChildren(...drawLive(view2, l, shot).filter(Boolean));
  }
  function setPosition(u) {
    const m = motionNow();
    if (!m) return;
    const slider = $("slider"),
      said = ((state.u = clamp(u, 0, m.frames.length - 1)), words.whereText(m, state.u));
    slider.value = state.u;
    slider.setAttribute("aria-valuetext", said);
    $("where").textContent = said;
    for (const b of $("ticks").children) b.classList.toggle("at", Math.abs(b.dataset.f - state.u) < 0.25);
    drawNow();
  }
  function setMotion(k) {
    const l = current(),
      m = l && l.motions[k];
    state.motion = k;
    state.direction = 1;
    $("player").hidden = !m;
    if (!m) return drawLinkage();
    $("slider").max = m.frames.length - 1;
    for (const b of $("motions").children) b.setAttribute("aria-pressed", +b.dataset.k === k);
    drawTicks();
    state.u = m.pose_frames.length ? m.pose_frames[0] : 0;
    drawLinkage();
    setPosition(state.u);
  }
  function drawTicks() {
    const m = motionNow(),
      width = $("ticks").clientWidth || 300;
    let last = -1e9,
      level = 0;
    $("ticks").replaceChildren(
      ...(m ? stops(m) : []).map(t => {
        const at = t.f / Math.max(1, m.frames.length - 1);
        level = at * width - last < 20 ? 1 - level : 0;
        last = at * width;
        return h(
          "button",
          {
            type: "button",
            "data-f": t.f,
            "data-level": level,
            style: `left:${100 * at}%;${colour(t.pose)}`,
            "aria-label": `Go to pose ${poseName(t.pose)}`,
            onclick: () => {
              play(false);
              setPosition(t.f);
            },
          },
          poseName(t.pose),
        );
      }),
    );
    $("ticks").style.height = [...$("ticks").children].some(b => b.dataset.level === "1") ? "40px" : "";
  }
  function select(id) {
    const info = linkages.find(l => l.id === id),
      l = drawn.get(id);
    if (!info || !l) return false;
    play(false);
    state.id = id;
    state.motion = 0;
    for (const c of $("cards").children) c.setAttribute("aria-pressed", +c.dataset.id === id);
    for (const r of document.querySelectorAll("tr[data-linkage]"))
      r.classList.toggle("chosen", +r.dataset.linkage === id);
    const note = words.motionNote(l),
      many = l.motions.length > 1;
    $("motion-note").textContent = note;
    $("motion-note").hidden = !note;
    $("motions").hidden = !many;
    $("motions").replaceChildren(
      ...l.motions.map((m, k) =>
        h(
          "button",
          {
            type: "button",
            "data-k": k,
            onclick: () => {
              play(false);
              setMotion(k);
            },
          },
          `${m.poses.length === 1 ? "pose" : "poses"} ${m.poses.map(i => poseName(i - 1)).join(", ")}`,
        ),
      ),
    );
    $("cap-linkage").replaceChildren(...words.caption(info));
    if (spherical) view2.aim(spheres.get(id).views[0]);
    view2.fit(view2.fits.fit());
    setMotion(0);
    return true;
  }
  function selectCandidate(c) {
    // draws a four-bar from the curves in figure 1
    state.candidate = c;
    for (const r of document.querySelectorAll("tr[data-candidate]"))
      r.classList.toggle("chosen", +r.dataset.candidate === c.rank);
    view1.fit(boxOf([...poses.map(p => p.origin), ...c.dyads.flatMap(dyadPoints)], 0.14));
  }
  function play(on) {
    const m = motionNow();
    state.playing = Boolean(on && m && m.frames.length > 1);
    $("play").setAttribute("aria-pressed", state.playing);
    $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
    if (!state.playing) return;
    let then = performance.now();
    const step = now => {
      if (!state.playing) return;
      const last = m.frames.length - 1,
        du = ((state.direction * Math.min(now - then, 100)) / 9000) * last;
      then = now;
      let u = state.u + du;
      if (m.closed) u = ((u % last) + last) % last;
      else if (u > last || u < 0) {
        state.direction = u < 0 ? 1 : -1;
        u = clamp(u, 0, last);
      }
      setPosition(u);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  function highlight(ids, linkage = null) {
    state.hot = new Set(ids);
    const touches = l => (linkage !== null ? l.id === linkage : l.dyads.some(d => state.hot.has(d)));
    for (const c of $("cards").children) c.classList.toggle("hot", touches(linkages.find(l => l.id === +c.dataset.id)));
    for (const r of document.querySelectorAll("tr[data-dyad]"))
      r.classList.toggle("hot", state.hot.has(+r.dataset.dyad));
    for (const r of document.querySelectorAll("tr[data-linkage]"))
      r.classList.toggle("hot", +r.dataset.linkage === linkage);
    drawPoses();
    drawNow();
  }
  const hover = (ids, linkage) => ({
    onmouseenter: () => highlight(ids, linkage),
    onmouseleave: () => highlight([]),
    onfocusin: () => highlight(ids, linkage),
    onfocusout: () => highlight([]),
  });

  // ---- set-up ---------------------------------------------------------------------------------------------------
  const reach = () => [
    ...poses.map(p => p.origin),
    ...dyads.filter(planar).flatMap(dyadPoints),
    ...curves.flatMap(c => [...(c.fixed || []), ...(c.moving || []).map(q => inBody(poses[0], q))]),
  ];
  const reachBox = () => boxOf(reach(), 0.06);
  function nearBox() {
    // what of it is within a size of the task from its middle
    const b = poseBox(),
      room = Math.max(b[2] - b[0], b[3] - b[1]);
    const near = k => p => Math.abs(p[k] - (b[k] + b[k + 2]) / 2) < room;
    return boxOf(reach().filter(near(0)).filter(near(1)), 0.06);
  }
  const view1 = spherical
    ? new sphereTools.Globe($("svg-poses"), drawPoses)
    : new View($("svg-poses"), drawPoses, { fit: poseBox, fit2: reachBox }, 46);
  const view2 = spherical
    ? new sphereTools.Globe($("svg-linkage"), drawLinkage)
    : new View(
        $("svg-linkage"),
        drawLinkage,
        { fit: () => (current() && current().window) || poseBox(), fit2: poseBox },
        56,
      );
  function setUpSpheres() {
    // buttons for the views instead of fitting
    for (const id of ["show-dyads-label", "show-pivots-label"]) $(id).hidden = true;
    const buttons = (view, id) =>
      spheres.get(id()).views.map((v, k) =>
        h(
          "button",
          {
            type: "button",
            title: `Look ${v.name}`,
            onclick: () => {
              view.aim(spheres.get(id()).views[k]);
              view.fit();
            },
          },
          ["mean", "x", "y", "z"][k],
        ),
      );
    for (const g of document.querySelectorAll(".group")) {
      const first = g.dataset.view === "poses",
        id = () => (first ? 0 : state.id || 0);
      for (const b of g.querySelectorAll("[data-act^=fit]")) b.remove();
      g.append(...buttons(first ? view1 : view2, id));
    }
    for (const [svg, name] of [
      ["svg-poses", "Task attitudes"],
      ["svg-linkage", "The selected linkage"],
    ])
      $(svg).setAttribute("aria-label", `${name} on the unit sphere. Arrow keys turn, plus and minus zoom, 0 fits.`);
    view1.aim(spheres.get(0).views[0]);
  }
  function setUp() {
    if (spherical) setUpSpheres();
    words.fillHead();
    words.fillEmpty(linkages.some(l => drawn.has(l.id)));
    tables.fillTables(
      drawn,
      hover,
      id => {
        select(id);
        $("linkages").scrollIntoView({ block: "start" });
      },
      c => {
        selectCandidate(c);
        $("fig-poses").scrollIntoView({ block: "start" });
      },
    );
    const figure = spherical || poses.length > 0;
    $("fig-poses").hidden = !figure;
    document.querySelector(".lead").classList.toggle("alone", !figure);
    $("show-curves-label").hidden = !curves.length;
    $("cards").append(...linkages.filter(l => drawn.has(l.id)).map(l => words.card(l, drawn.get(l.id), hover, select)));
    if (!spherical) $("svg-linkage").append(layer.back, layer.live);
    $("download").addEventListener("click", download);
    $("copy-result").addEventListener("click", () => copy(result, "result"));
    $("play").addEventListener("click", () => play(!state.playing));
    $("slider").addEventListener("input", e => {
      play(false);
      setPosition(+e.target.value);
    });
    for (const id of ["show-ghosts", "show-path", "show-pivots"]) $(id).addEventListener("change", drawLinkage);
    for (const id of ["show-dyads", "show-curves"]) $(id).addEventListener("change", drawPoses);
    for (const g of document.querySelectorAll(".group"))
      g.addEventListener("click", e => {
        if (e.target.dataset.act) (g.dataset.view === "poses" ? view1 : view2).act(e.target.dataset.act);
      });
    new ResizeObserver(drawTicks).observe($("ticks"));
    view1.resize();
    if (!spherical && curves.length) view1.fit(nearBox());
    view2.resize();
    const open = linkages.filter(l => drawn.has(l.id)),
      best =
        [open.filter(l => l.usable), open.filter(l => drawn.get(l.id).motions.length === 1), open].find(
          some => some.length,
        ) || [];
    const extent = l => {
      const w = drawn.get(l.id).window;
      return w ? Math.max(w[2] - w[0], w[3] - w[1]) : 0;
    };
    const first = best.reduce((a, b) => (!a || extent(b) < extent(a) ? b : a), null); // the most compact one shows best
    if (first) select(first.id);
    window.burmesterReport = {
      ready: true,
      select,
      selectCandidate: rank => selectCandidate(report.candidates.find(c => c.rank === rank)),
      setFraction: t => {
        const m = motionNow();
        play(false);
        if (m) setPosition(clamp(t, 0, 1) * (m.frames.length - 1));
      },
      setMotion: k => {
        play(false);
        if (current() && current().motions[k]) setMotion(k);
      },
      state: () => {
        const l = current(),
          m = motionNow();
        return {
          linkage: state.id,
          motion: state.motion,
          motions: l ? l.motions.length : 0,
          position: state.u,
          fraction: m ? state.u / Math.max(1, m.frames.length - 1) : 0,
          frames: m ? m.frames.length : 0,
          where: m ? words.whereText(m, state.u) : "",
          playing: state.playing,
          poses: poses.length,
          dyads: dyads.length,
          linkages: linkages.length,
        };
      },
    };
    document.documentElement.dataset.ready = "1";
  }
  setUp();
})();
