// The words of the page: its head, captions, the cards to choose a linkage from.
const words = (() => {
  "use strict";
  const { $, h, s, isNumber, plural, format, boxOf } = tools;
  const { result, poses, dyads, curves, linkages, candidates, lengths, units, spheres, spherical } = report;
  const { poseName, angleUnit, planar } = report;
  const kind = l => (l.class ? `${l.type}, ${l.class}` : l.type);
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
      ["From the curves", candidates.length ? plural(candidates.length, "linkage") : null],
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
        candidates.length ? " Press the rank of a linkage from the curves to see it here in pose 1." : "",
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
        ? [
            "Infinitely many linkages",
            (candidates.length ? "The best found from the curves are listed below. " : "") +
              `Give fixed or moving ${spherical ? "axes" : "pivots"}, or more poses, to single some out.`,
          ]
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
  return { fillHead, fillEmpty, card, motionNote, whereText, caption };
})();
