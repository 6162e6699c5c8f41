// The words of the page: its head, the tables, the cards to choose a linkage from.
const words = (() => {
  "use strict";
  const { $, h, s, isNumber, plural, format, number, point, copy, col, table, boxOf } = tools;
  const { result, poses, dyads, curves, linkages, units, spheres, spherical, poseName, angleUnit, planar } = report;
  const kind = l => (l.class ? `${l.type}, ${l.class}` : l.type);
  const lengths = l =>
    Object.entries({
      ...(l.links || {}),
      offset: l.links && isNumber(l.links.offset) ? l.links.offset : l.offset,
    }).filter(([, v]) => isNumber(v));
  const TYPES = {
    RR: "fixed pivot and moving pivot",
    PR: "slider on a fixed line, moving pivot",
    RP: "fixed pivot, slider on a moving line",
    PP: "two sliders",
  };
  const copier = (value, what) =>
    h("button", { type: "button", "aria-label": `Copy ${what} as JSON`, onclick: () => copy(value, what) }, "Copy");
  function reach(d) {
    if (d.line)
      return h(
        "span",
        { class: "wide" },
        "line through ",
        point(d.line.point),
        " at ",
        number(d.line.angle, 6, angleUnit()),
      );
    if (isNumber(d.arc)) return number(d.arc, 6, angleUnit());
    return isNumber(d.length)
      ? h(
          "span",
          {},
          number(d.length),
          d.slider ? h("span", { class: "sub" }, `nearly the slider ${d.slider.type}`) : "",
        )
      : isNumber(d.angle)
        ? h("span", {}, "coupler kept at ", number(d.angle, 6, angleUnit()))
        : null;
  }
  const angles = list =>
    h(
      "span",
      { class: "num" },
      list.map(v => format(units.angle === "rad" ? (v * Math.PI) / 180 : v) + angleUnit()).join(", "),
    );
  const pivot = p =>
    spherical && Array.isArray(p)
      ? h("span", {}, point(p), h("span", { class: "sub" }, "longitude, latitude ", angles(sphereTools.place(p))))
      : point(p);
  /// drawn: the linkages that figure 2 can show; hover(ids, linkage): attributes of what stands for these dyads;
  /// choose(linkage): shows it.
  function fillTables(drawn, hover, choose) {
    const small = (v, digits) => (isNumber(v) ? number(v, digits) : null),
      given = (result.poses || []).map((p, i) => ({ p, name: poseName(i) }));
    table(
      "table-dyads",
      "Dyads",
      [
        col("Dyad", d => String(d.id)),
        col("Type", d => h("span", { title: TYPES[d.type] }, d.type)),
        col(spherical ? "Fixed axis" : "Fixed pivot", d => pivot(d.fixed)),
        col(spherical ? "Moving axis" : "Moving pivot", d => pivot(d.moving)),
        col(spherical ? "Arc" : "Length or line", reach),
        col("Residual", d => small(d.residual, 2), true),
        col("Condition", d => small(d.condition, 3), true),
        col("Certificate", certificate),
        col("", d => copier(d, `dyad ${d.id}`), true),
      ],
      dyads,
      d => ({ "data-dyad": d.id, ...hover([d.id]) }),
    );
    const link = key => col(key[0].toUpperCase() + key.slice(1), l => small(Object.fromEntries(lengths(l))[key]), true);
    table(
      "table-linkages",
      spherical ? `Link arcs (${units.angle})` : "Link lengths",
      [
        col("Linkage", l =>
          drawn.has(l.id)
            ? h(
                "button",
                { type: "button", class: "id", title: "Show in figure 2", onclick: () => choose(l.id) },
                String(l.id),
              )
            : String(l.id),
        ),
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
  function thumbnail(l) {
    // a linkage as prepared for drawing
    if (spherical) return sphereTools.thumbnail(spheres.get(l.id), t => t.pose <= 1 && t.role !== "path");
    const svg = s("svg", { class: "thumb", viewBox: "0 0 96 88", "aria-hidden": "true" }),
      shot = l.at_pose[0];
    if (!shot) return svg;
    const b = boxOf(l.parts.filter(p => p.role !== "guide").flatMap(p => shot[p.k] || [])),
      scale = Math.min(72 / (b[2] - b[0] || 1e-9), 64 / (b[3] - b[1] || 1e-9));
    const c = [(b[0] + b[2]) / 2, (b[1] + b[3]) / 2],
      view = { w: 96, h: 88, scale, px: p => [48 + (p[0] - c[0]) * scale, 44 - (p[1] - c[1]) * scale] };
    svg.append(...plane.drawLive(view, l, shot, true).filter(Boolean));
    return svg;
  }
  function card(info, linkage, hover, choose) {
    const flag =
      info.usable === undefined || info.usable === null
        ? null
        : h("span", { class: info.usable ? "flag good" : "flag" }, info.usable ? "usable" : "defect");
    return h(
      "button",
      {
        type: "button",
        class: "card",
        "data-id": info.id,
        "aria-pressed": "false",
        "aria-label": `Linkage ${info.id}, ${kind(info)}`,
        onclick: () => choose(info.id),
        ...hover(info.dyads, info.id),
      },
      thumbnail(linkage),
      h(
        "span",
        {},
        h("b", {}, `${info.id}. ${info.type}`),
        h("span", { class: "kind" }, info.class || `dyads ${info.dyads.join(", ")}`),
        h(
          "span",
          { class: "lengths" },
          lengths(info).map(([k, v]) => [
            h("span", {}, k),
            h("span", { title: v }, format(v) + (spherical ? angleUnit() : "")),
          ]),
        ),
        flag,
      ),
    );
  }
  function dyadWords() {
    const n = result.solutions || {},
      best = result.status === "approximate" ? "real best-fit dyad" : "real dyad",
      list = [];
    if (n.dimension > 0)
      list.push(`infinitely many: a family with ${n.dimension === 1 ? "one parameter" : `${n.dimension} parameters`}`);
    if (isNumber(n.real))
      list.push(plural(n.real, best) + (isNumber(n.complex) ? ` (of ${n.complex} over the complex numbers)` : ""));
    if (!list.length || (isNumber(n.real) ? n.real !== dyads.length : dyads.length))
      list.push(`${dyads.length} listed`);
    return list.join("; ") + (n.certified ? "; count proved" : "");
  }
  function fillHead() {
    const count = result.pose_count || poses.length,
      name = result.name || (count ? `Linkages through ${count} poses` : "Burmester report");
    $("name").textContent = name;
    document.title = `${name} · Burmester`;
    $("source").textContent = result.source || "";
    $("source").hidden = !result.source;
    $("message").textContent = result.message
      ? result.message[0].toUpperCase() + result.message.slice(1).replace(/\.?$/, ".")
      : "";
    const usable = linkages.filter(l => l.usable).length,
      judged = linkages.some(l => typeof l.usable === "boolean");
    const rows = [
      ["Status", result.status],
      ["Poses", isNumber(result.pose_count) ? `${result.pose_count}, ${result.geometry}` : null],
      ["Dyads", result.solutions ? dyadWords() : null],
      ["Linkages", result.linkages ? plural(linkages.length, "linkage") + (judged ? `, ${usable} usable` : "") : null],
      ["Units", [units.length, units.angle].filter(Boolean).join(", ")],
    ];
    $("facts").append(...rows.filter(r => r[1]).flatMap(([k, v]) => [h("dt", {}, k), h("dd", {}, v)]));
    const w = (result.warnings || []).map(x => (typeof x === "string" ? x : x.message || JSON.stringify(x)));
    $("warnings").hidden = !w.length;
    $("warnings").append(
      w.length > 1
        ? h(
            "ul",
            {},
            w.map(x => h("li", {}, x)),
          )
        : h("p", {}, w[0] || ""),
    );
    if (spherical)
      $("cap-poses").append(
        h("b", {}, "Figure 1. "),
        "The task attitudes: a dot where the moving x axis pierces the unit sphere, full arrowhead towards the " +
          "y axis, open towards the z axis. Far side dashed. Drag to turn.",
        curves.length ? " Curves: fixed axes (black) and moving axes as they lie in pose 1 (red)." : "",
      );
    else
      $("cap-poses").append(
        h("b", {}, "Figure 1. "),
        "The moving frame in the task poses; full arrowhead: x axis, open: y axis.",
        dyads.some(planar) ? " With “dyads” ticked: every dyad in pose 1, its moving pivot in all poses." : "",
        curves.length ? " Curves: fixed pivots (solid) and moving pivots as they lie in pose 1 (dashed)." : "",
      );
  }
  function fillEmpty(open) {
    // open: whether a linkage can be drawn
    const family = result.status === "family";
    $("bench").hidden = !open;
    $("empty").hidden = open;
    if (open) return;
    const [head, why] = linkages.length
      ? ["No drawing of these linkages", `The ${result.geometry || ""} linkages are listed below.`]
      : family
        ? ["Infinitely many linkages", "Give fixed or moving pivots, or more poses, to single some out."]
        : result.status === "degenerate"
          ? ["No single linkage", "Isolated dyads, if there are any, are listed below."]
          : dyads.length
            ? [
                "No linkage",
                dyads.length === 1
                  ? "One dyad alone does not make a linkage: two are needed."
                  : "The dyads are listed below.",
              ]
            : [
                "No real dyad exists",
                "No planar linkage of two dyads passes these poses.".replace("planar", result.geometry || "planar"),
              ];
    const message = $("message").textContent,
      echo = message.toLowerCase().replace(/\.$/, "") === head.toLowerCase();
    $("empty").append(h("p", {}, head), h("p", {}, echo ? why : `${message} ${why}`));
  }
  function motionNote(l) {
    if (spherical) return "";
    const seen = new Set(l.motions.flatMap(m => m.poses)),
      missing = poses
        .map((_, i) => i + 1)
        .filter(i => !seen.has(i))
        .map(i => poseName(i - 1));
    if (!l.motions.length) return "No motion was sampled for this linkage; it is drawn in the task poses only.";
    return [
      l.motions.length > 1 ? "The poses are not all on one assembly circuit (sampled, not certified)." : "",
      missing.length ? `The sampled motion did not reach pose ${missing.join(", ")}.` : "",
    ]
      .filter(Boolean)
      .join(" ");
  }
  function whereText(m, u) {
    // u: the position along the motion
    const list = plane.stops(m),
      at = list.find(t => Math.abs(t.f - u) < 0.25),
      name = t => poseName(t.pose);
    if (at) return `at pose ${name(at)}`;
    if (!list.length) return "";
    const before = list.filter(t => t.f < u).pop(),
      after = list.find(t => t.f > u),
      wrap = m.closed && list.length > 1;
    if (before && after) return `between poses ${name(before)} and ${name(after)}`;
    if (wrap) return `between poses ${name(list[list.length - 1])} and ${name(list[0])}`;
    return before ? `after pose ${name(before)}` : `before pose ${name(after)}`;
  }
  function caption(info) {
    // of figure 2
    const facts = lengths(info)
      .map(([k, v]) => `${k} ${format(v)}${spherical ? angleUnit() : ""}`)
      .join(", ");
    return [
      h("b", {}, "Figure 2. "),
      `Linkage ${info.id}: ${kind(info)}, of dyads ${info.dyads.join(" and ")}`,
      facts ? `; ${facts}. ` : ". ",
      spherical
        ? "Strong: pose 1; thin: the other poses. Amber: task attitudes, red: the coupler and its attitudes. " +
          "Dotted: path of the moving x axis. Drag to turn."
        : "Ghosts in colour: the linkage in the task poses. Thin curve: path of the origin of the moving frame.",
      info.verdict ? ` ${info.verdict}.` : "",
    ];
  }
  return { fillHead, fillEmpty, fillTables, card, motionNote, whereText, caption };
})();
