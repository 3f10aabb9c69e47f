"use strict";
// Rotatable view of the measured surface: one canvas, WebGL 2, no library and no network.
(function () {
  const data = JSON.parse(document.getElementById("scene").textContent);
  const canvas = document.getElementById("view"), labels = document.getElementById("labels");
  const gl = data && canvas.getContext("webgl2", { antialias: true });
  if (!gl) { document.getElementById("viewer").hidden = true; return; }
  document.getElementById("still").hidden = true;
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const points = new Int16Array(bytes(data.points)), values = new Int16Array(bytes(data.values)), corners = new Uint32Array(bytes(data.triangles));

  const vertexText = `#version 300 es
    layout(location=0) in vec3 point; layout(location=1) in float value;
    uniform mat3 turn; uniform vec3 shift; uniform vec2 zoom; uniform float scale;
    out vec3 place; out float deviation; out float missing;
    void main() {
      vec3 seen = turn * (point * scale) + shift;
      place = seen; missing = value < -32767.5 ? 1.0 : 0.0; deviation = value;
      gl_Position = vec4(seen.xy * zoom, -seen.z * 0.4, 1.0);
    }`;
  const fragmentText = `#version 300 es
    precision highp float;
    in vec3 place; in float deviation; in float missing; out vec4 colour;
    uniform float unit; uniform vec2 ends; uniform bool coloured; uniform vec3 ramp[128]; uniform float beyond;
    void main() {
      vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
      float light = 0.55 + 0.45 * abs(normal.z);
      float share = (deviation * unit - ends.x) / (ends.y - ends.x);
      vec3 scale = ramp[int(clamp(share * 127.0 + 0.5, 0.0, 127.0))] * (share < 0.0 || share > 1.0 ? beyond : 1.0);
      bool stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 12.0) < 6.0;
      if (coloured) colour = vec4(missing > 0.01 ? (stripe ? vec3(0.45, 0.47, 0.50) : vec3(0.86)) : scale * (0.86 + 0.14 * abs(normal.z)), 1.0);
      else colour = vec4(vec3(0.74, 0.78, 0.80) * light, 1.0);
    }`;
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, fragmentText]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text); gl.compileShader(shader); gl.attachShader(program, shader);
  }
  gl.linkProgram(program); gl.useProgram(program);
  const fill = (target, content) => { gl.bindBuffer(target, gl.createBuffer()); gl.bufferData(target, content, gl.STATIC_DRAW); };
  fill(gl.ARRAY_BUFFER, points); gl.enableVertexAttribArray(0); gl.vertexAttribPointer(0, 3, gl.SHORT, false, 0, 0);
  fill(gl.ARRAY_BUFFER, values); gl.enableVertexAttribArray(1); gl.vertexAttribPointer(1, 1, gl.SHORT, false, 0, 0);
  fill(gl.ELEMENT_ARRAY_BUFFER, corners);
  gl.enable(gl.DEPTH_TEST); gl.clearColor(1, 1, 1, 1);
  const at = (name) => gl.getUniformLocation(program, name);
  const range = document.getElementById("range"), said = document.getElementById("limit"), shown = document.getElementById("coloured");

  const start = () => ({ azimuth: -58, elevation: 34, zoom: 1, x: 0, y: 0 });
  let view = start(), selected = -1, waiting = false;

  function turnMatrix() { // rows: right, up, towards the viewer
    const a = view.azimuth * Math.PI / 180, e = view.elevation * Math.PI / 180;
    const right = [-Math.sin(a), Math.cos(a), 0], back = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
    const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
    return [right, up, back];
  }
  function draw() {
    waiting = false;
    const ratio = window.devicePixelRatio || 1, w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    gl.viewport(0, 0, w, h); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const m = turnMatrix(), least = Math.min(w, h), zoom = [view.zoom * least / w, view.zoom * least / h];
    gl.uniformMatrix3fv(at("turn"), false, [m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]]);
    gl.uniform3f(at("shift"), view.x, view.y, 0); gl.uniform2f(at("zoom"), zoom[0], zoom[1]); gl.uniform1f(at("scale"), 1 / 32767);
    gl.uniform1f(at("unit"), data.unit_mm); gl.uniform2f(at("ends"), ...ends()); gl.uniform1f(at("beyond"), data.scale.beyond); gl.uniform3fv(at("ramp"), ramp()); gl.uniform1i(at("coloured"), shown.checked ? 1 : 0);
    gl.drawElements(gl.TRIANGLES, corners.length, gl.UNSIGNED_INT, 0);
    data.flags.forEach((flag, k) => {
      const seen = m.map((axis) => axis[0] * flag.at[0] + axis[1] * flag.at[1] + axis[2] * flag.at[2]);
      const box = labels.children[k];
      box.style.left = ((seen[0] + view.x) * zoom[0] * 0.5 + 0.5) * canvas.clientWidth + "px";
      box.style.top = (0.5 - (seen[1] + view.y) * zoom[1] * 0.5) * canvas.clientHeight + "px";
      box.hidden = !(flag.always || k === selected);
      box.classList.toggle("chosen", k === selected);
    });
  }
  const redraw = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw); } };
  const ends = () => { // widened or narrowed about the middle; the tolerance band stays where it is
    const middle = (data.scale.low + data.scale.high) / 2, half = (data.scale.high - data.scale.low) / 2 * Math.pow(10, Number(range.value));
    return [middle - half, middle + half];
  };
  const between = (nodes, place) => {
    const spread = Math.max(0, Math.min(1, place)) * (nodes.length - 1), first = Math.min(Math.floor(spread), nodes.length - 2);
    return nodes[first].map((level, channel) => level + (spread - first) * (nodes[first + 1][channel] - level));
  };
  function ramp() {
    const [low, high] = ends(), scale = data.scale, made = new Float32Array(3 * 128);
    const [start, end] = scale.tolerance || [(low + high) / 2, (low + high) / 2];
    for (let k = 0; k < 128; k++) {
      const value = low + (high - low) * k / 127, step = (high - low) / (scale.steps || 1);
      const shown = scale.steps ? low + (Math.min(Math.floor((value - low) / step), scale.steps - 1) + 0.5) * step : value;
      const inside = value >= start && value <= end;
      const colour = scale.go ? scale.go[inside ? 0 : 1] : inside ? scale.band
        : value < start ? between(scale.below, (shown - low) / Math.max(start - low, 1e-12))
        : between(scale.above, (shown - end) / Math.max(high - end, 1e-12));
      colour.forEach((level, channel) => { made[3 * k + channel] = level / 255; });
    }
    return made;
  }
  const signed = (value) => (value > 0 ? "+" : value < 0 ? "−" : "") + Math.abs(value).toPrecision(2);
  function say() { said.textContent = ends().map(signed).join(" … ") + " mm"; redraw(); }

  function select(k, scroll) {
    selected = selected === k ? -1 : k;
    document.querySelectorAll("tr[data-flag]").forEach((row) => {
      const own = Number(row.dataset.flag) === selected;
      row.classList.toggle("chosen", own);
      if (own && scroll) row.scrollIntoView({ block: "nearest" });
    });
    redraw();
  }
  data.flags.forEach((flag, k) => {
    const box = document.createElement("button");
    box.className = "flag"; box.style.borderColor = flag.colour;
    flag.text.forEach((line, n) => { const part = document.createElement(n ? "span" : "b"); part.textContent = line; box.append(part); });
    box.addEventListener("click", () => select(k, true));
    labels.append(box);
  });
  document.querySelectorAll("tr[data-flag]").forEach((row) => {
    row.tabIndex = 0;
    row.addEventListener("click", () => { select(Number(row.dataset.flag), false); canvas.scrollIntoView({ block: "nearest" }); });
    row.addEventListener("keydown", (event) => { if (event.key === "Enter") select(Number(row.dataset.flag), false); });
  });

  let held = null;
  canvas.addEventListener("pointerdown", (event) => { held = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointerup", () => { held = null; });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    const dx = event.clientX - held[0], dy = event.clientY - held[1], least = Math.min(canvas.clientWidth, canvas.clientHeight);
    if (event.shiftKey || event.buttons === 4) { view.x += 2 * dx / least / view.zoom; view.y -= 2 * dy / least / view.zoom; }
    else { view.azimuth -= 0.4 * dx; view.elevation = Math.max(-89.9, Math.min(89.9, view.elevation + 0.4 * dy)); }
    held = [event.clientX, event.clientY]; redraw();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault(); view.zoom = Math.max(0.3, Math.min(40, view.zoom * Math.exp(-event.deltaY / 600))); redraw();
  }, { passive: false });
  canvas.addEventListener("dblclick", () => { view = start(); redraw(); });
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[event.key];
    if (!step) return;
    event.preventDefault(); view.azimuth += step[0]; view.elevation = Math.max(-89.9, Math.min(89.9, view.elevation + step[1])); redraw();
  });
  range.addEventListener("input", say); shown.addEventListener("change", redraw); window.addEventListener("resize", redraw);
  if (!data.coloured) { document.getElementById("scale").hidden = true; shown.checked = false; }
  say();
})();
