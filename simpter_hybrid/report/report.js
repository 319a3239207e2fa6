"use strict";
(function () {
  const run = JSON.parse(document.getElementById("run").textContent);
  const names = { "-1": "backward", "0": "stuck", "1": "forward", "2": "off" };
  const slider = document.getElementById("time");
  const view = document.getElementById("view");
  const frames = run.t.length;

  // The view: everything is drawn in metres (or inches) with y upward.
  function shape(kind, attributes, parent) {
    const made = document.createElementNS(view.namespaceURI, kind);
    for (const name in attributes) made.setAttribute(name, attributes[name]);
    parent.appendChild(made);
    return made;
  }
  const points = (list) => list.map((p) => p[0] + "," + p[1]).join(" ");
  const moving = { links: [], tip: null, marks: [] };

  function drawPlane() {
    let x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    const see = (p) => {
      x0 = Math.min(x0, p[0]); x1 = Math.max(x1, p[0]);
      y0 = Math.min(y0, p[1]); y1 = Math.max(y1, p[1]);
    };
    run.tip.forEach(see);
    run.links.forEach((pose) => pose.forEach((line) => line.forEach(see)));
    const room = 0.05 * Math.max(x1 - x0, y1 - y0, 1e-6);
    const wide = x1 - x0 + 2 * room, high = y1 - y0 + 2 * room, thin = Math.max(wide, high) / 400;
    view.setAttribute("viewBox", [x0 - room, -y1 - room, wide, high].join(" "));
    const plane = shape("g", { transform: "scale(1,-1)", fill: "none", "stroke-linecap": "round",
      "stroke-linejoin": "round" }, view);
    shape("polyline", { points: points(run.path), stroke: "#8fd3bf", "stroke-width": 4 * thin }, plane);
    shape("polyline", { points: points(run.tip), stroke: "#0072b2", "stroke-width": 1.2 * thin }, plane);
    if (run.links.length) {
      run.links[0].forEach(() => moving.links.push(
        shape("polyline", { stroke: "#222222", "stroke-width": 3.5 * thin, opacity: 0.85 }, plane)));
      shape("circle", { cx: 0, cy: 0, r: 5 * thin, fill: "#ffffff", stroke: "#222222",
        "stroke-width": 2 * thin }, plane);
    }
    if (run.tip.length) {
      moving.tip = shape("circle", { r: 5 * thin, fill: "#0072b2", stroke: "#ffffff",
        "stroke-width": thin }, plane);
    }
  }

  // A device that cannot be drawn: each coordinate on its own scale.
  function drawTracks() {
    const rows = run.coordinates.length;
    view.setAttribute("viewBox", "0 0 400 " + 60 * rows);
    view.style.height = Math.min(400, 90 * rows) + "px";
    run.coordinates.forEach((coordinate, i) => {
      const low = Math.min(...coordinate.value), high = Math.max(...coordinate.value);
      const y = 60 * i + 34;
      shape("line", { x1: 20, x2: 380, y1: y, y2: y, stroke: "#b5b5b5", "stroke-width": 2 }, view);
      const text = (x, anchor, words) => {
        shape("text", { x: x, y: y + 18, "font-size": 11, "text-anchor": anchor }, view)
          .textContent = words;
      };
      text(20, "start", low.toPrecision(4));
      text(380, "end", high.toPrecision(4));
      shape("text", { x: 20, y: y - 14, "font-size": 13 }, view).textContent = coordinate.name;
      moving.marks.push({ low: low, span: high - low || 1, value: coordinate.value,
        dot: shape("circle", { cy: y, r: 7, fill: "#0072b2" }, view) });
    });
  }

  // The table of clutches and the ribbons.
  const rows = [];
  const body = document.querySelector("#lamps tbody");
  run.surfaces.forEach((name, i) => {
    const row = body.insertRow();
    row.insertCell().textContent = name;
    const lamp = document.createElement("span");
    lamp.className = "lamp";
    lamp.dataset.clutch = i + 1;
    row.insertCell().appendChild(lamp);
    rows.push({ lamp: lamp, cells: [0, 1, 2, 3].map(() => row.insertCell()) });
  });
  document.querySelectorAll(".torque-unit").forEach((unit) => {
    unit.textContent = run.units.torque;
  });
  document.querySelector(".slip-unit").textContent = run.units.slip;
  const ribbons = document.getElementById("ribbons");
  const share = (t) => 100 * t / (run.t_end || 1) + "%";
  function strip(kind) {
    const made = document.createElement("div");
    made.className = kind;
    ribbons.appendChild(made);
    made.addEventListener("click", (click) => {
      const box = made.getBoundingClientRect();
      goTo((click.clientX - box.left) / box.width * run.t_end);
    });
    return made;
  }
  const ticks = strip("ticks");
  run.events.forEach((event) => {
    const tick = document.createElement("i");
    tick.style.left = share(event.t);
    ticks.appendChild(tick);
  });
  run.spans.forEach((spans, i) => {
    const made = strip("ribbon");
    const label = document.createElement("span");
    label.textContent = run.surfaces[i];
    made.appendChild(label);
    spans.forEach((span) => {
      const piece = document.createElement("i");
      piece.className = names[span[2]];
      piece.style.left = share(span[0]);
      piece.style.width = share(span[1] - span[0]);
      made.appendChild(piece);
    });
  });
  const cursor = document.createElement("div");
  cursor.id = "cursor";
  ribbons.appendChild(cursor);

  function show(k) {
    const t = run.t[k];
    document.getElementById("now").textContent = "t = " + t.toFixed(4) + " s";
    cursor.style.left = share(t);
    moving.links.forEach((line, j) => line.setAttribute("points", points(run.links[k][j])));
    if (moving.tip) {
      moving.tip.setAttribute("cx", run.tip[k][0]);
      moving.tip.setAttribute("cy", run.tip[k][1]);
    }
    moving.marks.forEach((mark) =>
      mark.dot.setAttribute("cx", 20 + 360 * (mark.value[k] - mark.low) / mark.span));
    rows.forEach((row, i) => {
      const mode = names[run.mode[k][i]];
      row.lamp.className = "lamp " + mode;
      row.lamp.textContent = mode;
      row.cells[0].textContent = run.slip[k][i].toFixed(4);
      row.cells[1].textContent = run.tau[k][i].toFixed(3) + (run.unique[k][i] ? "" : " *");
      row.cells[2].textContent = run.limit[k][i].toFixed(3);
      row.cells[3].textContent = run.excitation[k][i].toFixed(3);
    });
    const here = run.events.filter((event) => Math.abs(event.t - t) < 1e-6);
    document.getElementById("happening").textContent = here.map((event) =>
      event.kind + (event.clutches.length ? ", clutch " + event.clutches.join(", ") : "")).join("; ");
  }

  function goTo(t) {
    let best = 0;
    for (let k = 1; k < frames; k++) {
      if (Math.abs(run.t[k] - t) < Math.abs(run.t[best] - t)) best = k;
    }
    slider.value = best;
    show(best);
  }

  // Playing.
  let playing = false, last = 0, at = 0;
  const play = document.getElementById("play");
  function tick(stamp) {
    if (!playing) return;
    at += (stamp - last) / 1000 * Number(document.getElementById("speed").value);
    last = stamp;
    goTo(Math.min(at, run.t_end));
    if (at >= run.t_end) return setPlaying(false);
    requestAnimationFrame(tick);
  }
  function setPlaying(on) {
    playing = on;
    play.textContent = on ? "❚❚ pause" : "▶ play";
    if (!on) return;
    at = run.t[Number(slider.value)];
    if (at >= run.t_end) at = 0;
    last = performance.now();
    requestAnimationFrame(tick);
  }
  function jump(direction) {
    const now = run.t[Number(slider.value)];
    const others = run.events.map((event) => event.t)
      .filter((t) => direction * (t - now) > 1e-6).sort((a, b) => direction * (a - b));
    if (others.length) goTo(others[0]);
  }

  if (run.coordinates.length) drawTracks(); else drawPlane();
  slider.max = frames - 1;
  slider.addEventListener("input", () => { setPlaying(false); show(Number(slider.value)); });
  play.addEventListener("click", () => setPlaying(!playing));
  document.getElementById("previous").addEventListener("click", () => jump(-1));
  document.getElementById("next").addEventListener("click", () => jump(1));
  document.querySelectorAll(".goto").forEach((button) => button.addEventListener("click", () => {
    goTo(Number(button.dataset.t));
    document.getElementById("motion").scrollIntoView();
  }));
  document.querySelectorAll(".why").forEach((button) => button.addEventListener("click", () => {
    const answer = button.closest("tr").nextElementSibling;
    answer.hidden = !answer.hidden;
  }));
  show(0);
})();
