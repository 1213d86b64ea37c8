// SPDX-License-Identifier: Apache-2.0
// The sweep's page: one scatter with its Pareto front, filters, growth curves, a table. Data: docs/sweep.md, "Report".
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const $ = (id) => document.getElementById(id);
  const palette = ["#2f6db3", "#c4472e", "#2b9a8b", "#e0a22c", "#8d5fb8", "#5a7d2a", "#b0447f", "#5c646f"];
  const labels = Object.fromEntries(data.figures.map((f) => [f.name, f.label]));
  const keys = data.axes.map((a) => a.key);
  const chosen = Object.fromEntries(data.axes.map((a) => [a.key, new Set(a.values)]));
  let plots = [];

  const option = (value, text) => Object.assign(document.createElement("option"), { value, textContent: text });
  const fill = (select, entries, value) => {
    select.replaceChildren(...entries.map(([v, t]) => option(v, t)));
    if (value !== undefined) select.value = value;
  };
  const cell = (name, text) => Object.assign(document.createElement(name), { textContent: text });
  const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]];
  const number = (v) => {
    if (v === undefined) return "–";
    if (v !== 0 && Math.abs(v) < 1e-3) return v.toExponential(2).replace("e-", "·10^-");
    const [unit, prefix] = prefixes.find(([u]) => Math.abs(v) >= u) ?? [1, ""];
    return `${+(v / unit).toPrecision(4)}${prefix && ` ${prefix}`}`;
  };

  /// Points of the scene that pass all filters and have both figures.
  const visible = () => data.points.filter((p) => p.scene === $("scene").value &&
    keys.every((k) => chosen[k].has(p.configuration[k])) && p.figures[$("x").value] !== undefined && p.figures[$("y").value] !== undefined);

  /// The same rule as host/sweep/front.hpp, over what is visible: what comes later in this order beats nothing before it.
  const frontOf = (points, names) => {
    const known = points.filter((p) => names.every((n) => p.figures[n] !== undefined));
    const difference = (a, b) => names.reduce((d, n) => d || a.figures[n] - b.figures[n], 0);
    const beats = (a, b) => names.every((n) => a.figures[n] <= b.figures[n]) && difference(a, b) !== 0;
    const front = [];
    for (const p of known.sort(difference)) if (!front.some((f) => beats(f, p))) front.push(p);
    return front;
  };

  /// Lowest and highest; a call with a value an argument would end at some 100,000.
  const ends = (values) => values.reduce(([low, high], v) => [Math.min(low, v), Math.max(high, v)], [Infinity, -Infinity]);
  const logarithmic = (values) => { const [low, high] = ends(values); return values.length > 1 && low > 0 && high / low > 8; };
  const scale = (values) => (logarithmic(values) ? { distr: 3 } : {});
  const range = (values) => {
    const [low, high] = ends(values);
    if (logarithmic(values)) return [low / 1.25, high * 1.25];
    const margin = (high - low || Math.abs(high) || 1) * 0.05;
    return [low - margin, high + margin];
  };
  /// On logarithmic axes 1, 2 and 5 of each decade, if there are any.
  const tickTexts = (u, ticks, axis) => {
    const round = (v) => u.scales[u.axes[axis].scale].distr !== 3 || [1, 2, 5].includes(+(v / 10 ** Math.floor(Math.log10(v) + 1e-9)).toPrecision(3));
    const any = ticks.some((v) => v !== null && round(v));
    return ticks.map((v) => (v === null || (any && !round(v)) ? "" : number(v)));
  };
  const axisStyle = (label) => {
    const style = getComputedStyle(document.documentElement);
    return { label, space: 70, values: tickTexts, stroke: style.getPropertyValue("--ink").trim(), grid: { stroke: style.getPropertyValue("--line").trim() }, ticks: { stroke: style.getPropertyValue("--line").trim() } };
  };

  const tip = $("tip");
  const showTip = (point, event) => {
    tip.replaceChildren();
    const list = document.createElement("dl");
    for (const [k, v] of [...keys.map((k) => [k, point.configuration[k]]), ...data.figures.map((f) => [f.label, number(point.figures[f.name])])])
      list.append(cell("dt", k), cell("dd", v));
    if (point.confirmed) list.append(cell("dt", "on the hardware"), cell("dd", point.confirmed));
    tip.append(list, cell("code", `gnomon run ${point.flags}`));
    tip.hidden = false;
    const box = tip.getBoundingClientRect();
    tip.style.left = `${Math.max(4, Math.min(event.clientX + 16, innerWidth - box.width - 8))}px`;
    tip.style.top = `${Math.max(4, Math.min(event.clientY + 16, innerHeight - box.height - 8))}px`;
  };

  /// Points in groups, a line through the front; one point is told apart by hovering.
  const scatter = (points, front, line, x, y) => {
    const colourKey = $("colour").value;
    const groups = colourKey ? data.axes.find((a) => a.key === colourKey).values.filter((v) => points.some((p) => p.configuration[colourKey] === v)) : [""];
    const onFront = new Set(front);
    const shown = $("dominated").checked ? points : front;
    const table = [null];
    const series = [{}];
    const ordered = [];
    groups.forEach((group, i) => {
      const members = shown.filter((p) => !colourKey || p.configuration[colourKey] === group);
      ordered.push(members);
      table.push([members.map((p) => p.figures[x]), members.map((p) => p.figures[y])]);
      series.push({ label: colourKey ? `${colourKey} ${group}` : "points", stroke: palette[i % palette.length], paths: (u, index) => {
        const d = u.data[index];
        u.ctx.save();
        u.ctx.beginPath();
        u.ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
        u.ctx.clip();
        members.forEach((p, k) => {
          const strong = onFront.has(p);
          u.ctx.globalAlpha = strong ? 1 : 0.35;
          u.ctx.fillStyle = palette[i % palette.length];
          u.ctx.beginPath();
          u.ctx.arc(u.valToPos(d[0][k], "x", true), u.valToPos(d[1][k], "y", true), (strong ? 5 : 3) * devicePixelRatio, 0, 2 * Math.PI);
          u.ctx.fill();
          if (p.mark) {
            u.ctx.globalAlpha = 1;
            u.ctx.strokeStyle = palette[i % palette.length];
            u.ctx.lineWidth = 2 * devicePixelRatio;
            u.ctx.beginPath();
            u.ctx.arc(u.valToPos(d[0][k], "x", true), u.valToPos(d[1][k], "y", true), 9 * devicePixelRatio, 0, 2 * Math.PI);
            u.ctx.stroke();
          }
        });
        u.ctx.restore();
        return null;
      } });
    });
    const xs = shown.map((p) => p.figures[x]), ys = shown.map((p) => p.figures[y]);
    const drawFront = (u) => {
      u.ctx.save();
      u.ctx.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue("--accent").trim();
      u.ctx.lineWidth = 1.5 * devicePixelRatio;
      u.ctx.beginPath();
      let before = null;
      for (const p of line) {
        const at = [u.valToPos(p.figures[x], "x", true), u.valToPos(p.figures[y], "y", true)];
        if (before === null) u.ctx.moveTo(...at); else { u.ctx.lineTo(at[0], before[1]); u.ctx.lineTo(...at); }
        before = at;
      }
      u.ctx.stroke();
      u.ctx.restore();
    };
    const box = $("front");
    box.replaceChildren();
    if (shown.length === 0) { box.append(cell("p", "no point passes the filters")); return; }
    const plot = new uPlot({
      mode: 2, width: box.clientWidth - 16, height: 460, cursor: { drag: { x: false, y: false }, points: { show: false } },
      legend: { show: groups.length > 1, live: false }, scales: { x: { time: false, ...scale(xs), range: () => range(xs) }, y: { ...scale(ys), range: () => range(ys) } },
      axes: [axisStyle(labels[x]), { ...axisStyle(labels[y]), size: 90, space: 30 }], series, hooks: { draw: [drawFront] },
    }, table, box);
    plot.over.addEventListener("mousemove", (event) => {
      let best = null, distance = 15 ** 2;
      ordered.flat().forEach((p) => {
        const d = (plot.valToPos(p.figures[x], "x") - event.offsetX) ** 2 + (plot.valToPos(p.figures[y], "y") - event.offsetY) ** 2;
        if (d < distance) { distance = d; best = p; }
      });
      if (best) showTip(best, event); else tip.hidden = true;
    });
    plot.over.addEventListener("mouseleave", () => { tip.hidden = true; });
    plots.push(plot);
  };

  const frontTable = (front, names) => {
    const head = document.createElement("tr");
    for (const text of [...names.map((n) => labels[n]), ...keys, "command"]) head.append(cell("th", text));
    const rows = front.map((p) => {
      const row = document.createElement("tr");
      row.append(cell("th", number(p.figures[names[0]])), ...names.slice(1).map((n) => cell("td", number(p.figures[n]))), ...keys.map((k) => cell("td", p.configuration[k])));
      const command = document.createElement("td");
      command.append(cell("code", `gnomon run ${p.flags}`));
      row.append(command);
      if (p.mark) row.className = "marked";
      return row;
    });
    const body = document.createElement("tbody"), top = document.createElement("thead");
    top.append(head);
    body.append(...rows);
    $("table").replaceChildren(top, body);
  };

  /// Geometric mean of the error at each value of the axis, a curve for each value of the series; slope by least squares of log2.
  const growth = (points, y) => {
    const axis = $("axis").value, by = $("series").value, box = $("growth");
    box.replaceChildren();
    $("slope").textContent = "";
    if (!axis) { $("growth-section").hidden = true; return; }
    const steps = data.axes.find((a) => a.key === axis).values.filter((v) => v !== "" && !Number.isNaN(+v));
    const curves = by ? data.axes.find((a) => a.key === by).values : [""];
    const mean = (list) => (list.length ? Math.exp(list.reduce((s, v) => s + Math.log(v), 0) / list.length) : null);
    const columns = curves.map((c) => steps.map((v) => mean(points.filter((p) => p.configuration[axis] === v && (!by || p.configuration[by] === c) && p.figures[y] > 0).map((p) => p.figures[y]))));
    const values = columns.flat().filter((v) => v !== null);
    if (values.length === 0) { box.append(cell("p", "nothing to show: no error above zero")); return; }
    const xs = steps.map(Number);
    const slopes = columns.map((column) => {
      const pairs = xs.map((v, i) => [v, column[i]]).filter((p) => p[1] !== null).map(([v, e]) => [v, Math.log2(e)]);
      const n = pairs.length, sx = pairs.reduce((s, p) => s + p[0], 0), sy = pairs.reduce((s, p) => s + p[1], 0);
      const sxx = pairs.reduce((s, p) => s + p[0] ** 2, 0), sxy = pairs.reduce((s, p) => s + p[0] * p[1], 0);
      return n > 1 ? (n * sxy - sx * sy) / (n * sxx - sx * sx) : null;
    });
    const theory = axis === "frac_bits" && xs.length > 1 ? xs.map((v) => mean(columns.map((c) => c[0]).filter((c) => c)) * 2 ** -(v - xs[0])).map((e) => (e < Math.min(...values) / 2 ? null : e)) : null;
    plots.push(new uPlot({
      width: box.clientWidth - 16, height: 400, scales: { x: { time: false }, y: { distr: 3, range: () => [Math.min(...values) / 1.5, Math.max(...values) * 1.2] } }, axes: [{ ...axisStyle(axis), ...(xs.every(Number.isInteger) ? { incrs: [1, 2, 5, 10, 20, 50, 100] } : {}) }, { ...axisStyle(labels[y]), size: 90, space: 30 }],
      series: [{ label: axis }, ...curves.map((c, i) => ({ label: by ? `${by} ${c}` : "mean", stroke: palette[i % palette.length], points: { show: true }, value: (u, v) => (v == null ? "–" : number(v)) })),
        ...(theory ? [{ label: "halved with each bit", stroke: "#888", dash: [6, 6], value: (u, v) => (v == null ? "–" : number(v)) }] : [])],
    }, [xs, ...columns, ...(theory ? [theory] : [])], box));
    $("slope").textContent = `log2 of the error a step of ${axis}: ${curves.map((c, i) => (slopes[i] === null ? null : `${by ? `${by} ${c}: ` : ""}${slopes[i].toFixed(2)}`)).filter((t) => t !== null).join(", ")}${theory ? "; theory: -1.00" : ""}`;
  };

  const draw = () => {
    plots.forEach((p) => p.destroy());
    plots = [];
    tip.hidden = true;
    const [x, y, z] = [$("x").value, $("y").value, $("z").value];
    const names = [...new Set([x, y, z].filter((n) => n))];
    const points = visible(), front = frontOf(points, names);
    scatter(points, front, frontOf(points, [x, y]), x, y);
    frontTable(front, names);
    growth(points, $("error").value);
    $("count").textContent = `${points.length} of ${data.points.filter((p) => p.scene === $("scene").value).length} points shown, ${front.length} on the front${data.points.some((p) => p.mark) ? "; ringed: the published encodings" : ""}`;
  };

  fill($("scene"), data.scenes.map((s) => [s, s]));
  fill($("x"), data.figures.map((f) => [f.name, f.label]), data.x);
  fill($("y"), data.figures.map((f) => [f.name, f.label]), data.y);
  fill($("z"), [["", "nothing else"], ...data.figures.map((f) => [f.name, f.label])], data.z);
  fill($("error"), data.figures.filter((f) => f.name.startsWith("errors.")).map((f) => [f.name, f.label]), ["errors.fixed.ground.boundary_displacement", data.y].find((n) => labels[n]));
  fill($("colour"), [["", "nothing"], ...keys.map((k) => [k, k])], keys.includes("technique") ? "technique" : keys[0] ?? "");
  const numeric = data.axes.filter((a) => a.values.length > 1 && a.values.every((v) => v !== "" && !Number.isNaN(+v))).map((a) => a.key);
  fill($("axis"), numeric.map((k) => [k, k]), numeric.includes("frac_bits") ? "frac_bits" : numeric[0]);
  fill($("series"), [["", "nothing"], ...keys.map((k) => [k, k])], ["technique", "slope_bits"].find((k) => keys.includes(k)) ?? "");
  $("filters").replaceChildren(...data.axes.map((axis) => {
    const set = document.createElement("fieldset");
    set.append(cell("legend", axis.key));
    for (const value of axis.values) {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: value });
      button.dataset.key = axis.key;
      button.dataset.value = value;
      button.setAttribute("aria-pressed", "true");
      button.addEventListener("click", () => {
        const on = !chosen[axis.key].delete(value);
        if (on) chosen[axis.key].add(value);
        button.setAttribute("aria-pressed", String(on));
        draw();
      });
      set.append(button);
    }
    return set;
  }));
  for (const id of ["scene", "x", "y", "z", "colour", "dominated", "error", "axis", "series"]) $(id).addEventListener("change", draw);
  let resized = 0;
  addEventListener("resize", () => { clearTimeout(resized); resized = setTimeout(draw, 150); });
  draw();
})();
