// The tables of the page, one for each list of the result.
const tables = (() => {
  "use strict";
  const { $, h, isNumber, format, number, rounded, copy, col, table } = tools;
  const { result, poses, dyads, linkages, candidates, lengths, units, spherical, poseName, angleUnit } = report;
  const zero = 1e-9 * (result.task_size || 0),
    point = p => tools.point(p, zero);
  const TYPES = spherical
    ? { RR: "fixed axis and moving axis", PR: "fixed axis and moving axis at right angles: a slider" }
    : {
        RR: "fixed pivot and moving pivot",
        PR: "slider on a fixed line, moving pivot",
        RP: "fixed pivot, slider on a moving line",
        PP: "two sliders",
      };
  const copier = (value, what) =>
    h("button", { type: "button", "aria-label": `Copy ${what} as JSON`, onclick: () => copy(value, what) }, "Copy");
  const line = l =>
    h("span", { class: "wide" }, "line through ", point(l.point), " at ", number(l.angle, 6, angleUnit()));
  function reach(d) {
    if (d.line) return line(d.line);
    const size = isNumber(d.arc) ? number(d.arc, 6, angleUnit()) : isNumber(d.length) ? number(d.length) : null;
    return size
      ? h("span", {}, size, d.slider ? h("span", { class: "sub" }, `nearly the slider ${d.slider.type}`) : "")
      : isNumber(d.angle)
        ? h("span", {}, "coupler kept at ", number(d.angle, 6, angleUnit()))
        : null;
  }
  const title = key => key[0].toUpperCase() + key.slice(1);
  const angles = list =>
    h(
      "span",
      { class: "num" },
      list.map(v => format(units.angle === "rad" ? (v * Math.PI) / 180 : v) + angleUnit()).join(", "),
    );
  const pivot = p =>
    spherical && Array.isArray(p)
      ? h(
          "span",
          {},
          point(p),
          h("span", { class: "sub" }, "longitude, latitude ", angles(sphereTools.place(rounded(p, zero)))),
        )
      : point(p);
  const small = (v, digits) => (isNumber(v) ? number(v, digits) : null);
  const shower = (name, figure, show) =>
    h("button", { type: "button", class: "id", title: `Show in figure ${figure}`, onclick: show }, String(name));
  const FIXED = spherical ? "Fixed axis" : "Fixed pivot",
    MOVING = spherical ? "Moving axis" : "Moving pivot";
  const DYAD = [
    col("Type", d => h("span", { title: TYPES[d.type] }, d.type)),
    col(FIXED, d => pivot(d.fixed)),
    col(MOVING, d => pivot(d.moving)),
    col(spherical ? "Arc" : "Length or line", reach),
    col(spherical ? "Residual (rad)" : "Residual", d => small(d.residual, 2), true),
    col("Condition", d => small(d.condition, 3), true),
  ];
  function fillFamily() {
    // what tells a family of dyads that is no curve
    const { poles = [], partners = [], samples = [] } = result,
      shown = Math.min(12, samples.length),
      some = Array.from({ length: shown }, (_, k) => samples[Math.floor((k * samples.length) / shown)]);
    table(
      "table-poles",
      "Poles",
      [
        col("Poses", p => p.poses.map(i => poseName(i - 1)).join(", ")),
        col("Angle", p => number(p.angle, 6, angleUnit()), true),
        col("In the fixed frame", p => pivot(p.fixed)),
        col("In the moving body", p => pivot(p.moving)),
        col("At infinity", p => (p.line ? h("span", {}, "of the ", line(p.line)) : null)),
        col("", p => copier(p, `pole of poses ${p.poses.join(" and ")}`), true),
      ],
      poles,
      () => ({}),
    );
    table(
      "table-partners",
      `Partners fill a ${spherical ? "great circle" : "line"}`,
      [
        col(FIXED, p => pivot(p.fixed)),
        col(MOVING, p => pivot(p.moving)),
        col("Its partners", p => (p.line ? line(p.line) : null)),
        col("Its partners are perpendicular to", p => pivot(p.normal)),
        col("", p => copier(p, "partners"), true),
      ],
      partners,
      () => ({}),
    );
    table(
      "table-samples",
      shown < samples.length ? `Samples: ${shown} of ${samples.length} in all` : "Samples",
      [...DYAD, col("", d => copier(d, "sample"), true)],
      some,
      () => ({}),
    );
  }
  function fillCandidates(choose) {
    const both = (c, cell) => c.dyads.map(d => h("div", {}, cell(d))),
      arcs = spherical ? ` (${units.angle})` : "";
    table(
      "table-candidates",
      `Linkages from the curves, best first${arcs}`,
      [
        col("Rank", c => (spherical ? String(c.rank) : shower(c.rank, 1, () => choose(c)))),
        col("Class", c => c.class || null),
        col("One branch", c => (c.one_branch ? "yes" : "no")),
        col("Ratio", c => number(c.link_ratio, 3), true),
        col(FIXED + "s", c => both(c, d => point(d.fixed))),
        col(MOVING + "s", c => both(c, d => point(d.moving))),
        ...["input", "ground", "coupler", "output"].map(k => col(title(k), c => small(c.links[k]), true)),
        col("", c => copier(c, `linkage of rank ${c.rank}`), true),
      ],
      candidates,
      c => ({ "data-candidate": c.rank }),
    );
  }
  /// drawn: the linkages that figure 2 can show; hover(ids, linkage): attributes of what stands for these dyads;
  /// choose(linkage): shows it; chooseCandidate(candidate): likewise, in figure 1.
  function fillTables(drawn, hover, choose, chooseCandidate) {
    const given = (result.poses || []).map((p, i) => ({ p, name: poseName(i) }));
    table(
      "table-dyads",
      "Dyads",
      [
        col("Dyad", d => String(d.id)),
        ...DYAD,
        col("Certificate", certificate),
        col("", d => copier(d, `dyad ${d.id}`), true),
      ],
      dyads,
      d => ({ "data-dyad": d.id, ...hover([d.id]) }),
    );
    fillFamily();
    const link = key => col(title(key), l => small(Object.fromEntries(lengths(l))[key]), true);
    table(
      "table-linkages",
      spherical ? `Link arcs (${units.angle})` : "Link lengths",
      [
        col("Linkage", l => (drawn.has(l.id) ? shower(l.id, 2, () => choose(l.id)) : String(l.id))),
        col("Type", l => l.type),
        col("Class", l => l.class || null),
        col("Dyads", l => l.dyads.join(", ")),
        ...["ground", "input", "coupler", "output", "offset"].map(link),
        col("Verdict", l => l.verdict || null),
        col("Circuit of each pose", l => (l.circuit_of_pose ? l.circuit_of_pose.map(c => c ?? "–").join(" ") : null)),
        col("", l => copier(l, `linkage ${l.id}`), true),
      ],
      linkages,
      l => ({ "data-linkage": l.id, ...hover(l.dyads, l.id) }),
    );
    fillCandidates(chooseCandidate);
    table(
      "table-poses",
      "Task poses",
      [
        col("Pose", r => r.name),
        col("x", r => small(r.p.x), true),
        col("y", r => small(r.p.y), true),
        col("Angle", r => (isNumber(r.p.angle) ? number(r.p.angle, 6, angleUnit()) : null), true),
        col("Quaternion (w, x, y, z)", r => point(r.p.quaternion_wxyz)),
        col("Longitude, latitude, roll of the moving x axis", r =>
          r.p.quaternion_wxyz ? angles(sphereTools.globeAngles(r.p.quaternion_wxyz)) : null,
        ),
        col("", r => copier(r.p, `pose ${r.name}`), true),
      ],
      given,
      () => ({}),
    );
  }
  const roundedUp = x => {
    const unit = 10 ** (Math.floor(Math.log10(x)) - 1);
    return x > 0 ? Math.ceil(x / unit) * unit : x;
  }; // to two digits
  function certificate(d) {
    const c = d.certificate;
    if (!c) return null;
    return c.certified
      ? h(
          "span",
          { class: "num", title: `within ${c.radius} of the true dyad` },
          isNumber(c.radius) ? `proved, ±${format(roundedUp(c.radius), 2)}` : "proved",
        )
      : "not proved";
  }
  return { fillTables };
})();
