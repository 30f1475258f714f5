"use strict";
// Reading values off the curves, and zoom. A picture's panels and their ranges stand in the attribute data-panels of its
// svg element (src/output/drawing/frames.c). Without this script the report has the same pictures, text and tables.
(function () {
  const NS = "http://www.w3.org/2000/svg";
  const near = 24; // px of the picture: a point of a curve within this distance is taken

  function panels(svg) {
    return (svg.dataset.panels || "").split(";").filter(Boolean).map(function (text) {
      const v = text.split(" ").map(Number);
      return { left: v[0], right: v[1], top: v[2], bottom: v[3], x0: v[4], x1: v[5], y0: v[6], y1: v[7], log: v[8] };
    });
  }
  function between(a, b, f, log) {
    return log ? a * Math.pow(b / a, f) : a + (b - a) * f;
  }
  function shown(value, a, b, log) { // with as many digits as the picture resolves
    const step = log ? Math.abs(value) * 1e-3 : Math.abs(b - a) * 1e-3;
    const digits = Math.ceil(Math.log10(Math.abs(value) / step)) + 1;
    return Number(value.toPrecision(Math.min(Math.max(digits, 2), 9))).toString();
  }
  // Vertices of the curves and the places of symbols, in px.
  function vertices(svg) {
    const list = [];
    svg.querySelectorAll("[id*=gnuplot_plot] path").forEach(function (path) {
      let x = 0, y = 0;
      (path.getAttribute("d") || "").replace(/([MLHVhvlm])?\s*(-?[\d.]+)(?:[ ,]+(-?[\d.]+))?/g, function (all, c, a, b) {
        if (b === undefined || c === "h" || c === "v" || c === "l" || c === "m") return all;
        x = Number(a); y = Number(b);
        list.push([x, y]);
        return all;
      });
    });
    svg.querySelectorAll("[id*=gnuplot_plot] use").forEach(function (use) {
      const at = /translate\(([-\d.]+)[ ,]+([-\d.]+)\)/.exec(use.getAttribute("transform") || "");
      if (at) list.push([Number(at[1]), Number(at[2])]);
    });
    return list;
  }

  function activate(figure) {
    const svg = figure.querySelector("svg"), plot = figure.querySelector(".plot"), out = figure.querySelector("output");
    const full = svg.viewBox.baseVal, whole = { x: full.x, y: full.y, w: full.width, h: full.height };
    const list = panels(svg), mark = document.createElementNS(NS, "circle");
    let view = Object.assign({}, whole), points = null, drag = null;

    figure.classList.add("active");
    mark.setAttribute("r", "4");
    mark.setAttribute("fill", "none");
    mark.setAttribute("stroke", "#000");
    mark.setAttribute("stroke-width", "1.5");
    mark.setAttribute("visibility", "hidden");
    mark.setAttribute("pointer-events", "none");
    svg.appendChild(mark);

    function show() {
      view.x = Math.min(Math.max(view.x, whole.x), whole.x + whole.w - view.w);
      view.y = Math.min(Math.max(view.y, whole.y), whole.y + whole.h - view.h);
      svg.setAttribute("viewBox", [view.x, view.y, view.w, view.h].join(" "));
      mark.setAttribute("r", String(4 * view.w / whole.w));
      mark.setAttribute("stroke-width", String(1.5 * view.w / whole.w));
      svg.style.cursor = view.w < whole.w ? "grab" : "";
      plot.style.touchAction = view.w < whole.w ? "none" : "";
    }
    function zoom(factor, cx, cy) {
      const w = Math.min(whole.w, Math.max(whole.w / 64, view.w / factor)), f = w / view.w;
      view = { x: cx - (cx - view.x) * f, y: cy - (cy - view.y) * f, w: w, h: whole.h * w / whole.w };
      show();
    }
    function middle(factor) {
      zoom(factor, view.x + view.w / 2, view.y + view.h / 2);
      say("enlarged " + (whole.w / view.w).toFixed(1) + " times");
    }
    function reset() {
      view = Object.assign({}, whole);
      show();
      say("whole picture");
    }
    function say(text) { out.textContent = text; }
    function place(event) {
      const p = svg.createSVGPoint();
      p.x = event.clientX; p.y = event.clientY;
      return p.matrixTransform(svg.getScreenCTM().inverse());
    }
    function read(event) {
      const at = place(event), panel = list.find(function (q) {
        return at.x >= q.left && at.x <= q.right && at.y >= q.top && at.y <= q.bottom;
      });
      mark.setAttribute("visibility", "hidden");
      if (!panel) { say(""); return; }
      points = points || vertices(svg);
      let best = null, least = Math.pow(near * view.w / whole.w, 2);
      points.forEach(function (q) {
        if (q[0] < panel.left - 1 || q[0] > panel.right + 1 || q[1] < panel.top - 1 || q[1] > panel.bottom + 1) return;
        const d = Math.pow(q[0] - at.x, 2) + Math.pow(q[1] - at.y, 2);
        if (d < least) { least = d; best = q; }
      });
      const u = best || [at.x, at.y];
      if (best) {
        mark.setAttribute("cx", best[0]); mark.setAttribute("cy", best[1]);
        mark.setAttribute("visibility", "visible");
      }
      const x = between(panel.x0, panel.x1, (u[0] - panel.left) / (panel.right - panel.left), panel.log & 1);
      const y = between(panel.y0, panel.y1, (panel.bottom - u[1]) / (panel.bottom - panel.top), panel.log & 2);
      say((best ? "curve: " : "") + "x = " + shown(x, panel.x0, panel.x1, panel.log & 1) + ", y = " + shown(y, panel.y0, panel.y1, panel.log & 2));
    }

    svg.addEventListener("pointermove", function (event) {
      if (drag) {
        const now = place(event);
        view.x += drag.x - now.x; view.y += drag.y - now.y;
        show();
      } else { read(event); }
    });
    svg.addEventListener("pointerdown", function (event) {
      if (view.w < whole.w) { drag = place(event); svg.setPointerCapture(event.pointerId); }
      else { read(event); }
    });
    ["pointerup", "pointercancel"].forEach(function (name) {
      svg.addEventListener(name, function () { drag = null; });
    });
    svg.addEventListener("pointerleave", function () { if (!drag) { mark.setAttribute("visibility", "hidden"); say(""); } });
    svg.addEventListener("dblclick", function (event) { const at = place(event); zoom(2, at.x, at.y); });
    svg.addEventListener("wheel", function (event) { // with Ctrl, so that the page still scrolls
      if (!event.ctrlKey) return;
      event.preventDefault();
      const at = place(event);
      zoom(Math.exp(-event.deltaY / 300), at.x, at.y);
    }, { passive: false });
    figure.querySelectorAll("button").forEach(function (button) {
      button.addEventListener("click", function () {
        if (button.value === "0") reset();
        else middle(button.value === "+" ? 1.6 : 1 / 1.6);
      });
    });
    plot.addEventListener("keydown", function (event) {
      const step = view.w / 10, move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (event.key === "+" || event.key === "=") middle(1.6);
      else if (event.key === "-") middle(1 / 1.6);
      else if (event.key === "0" || event.key === "Escape") reset();
      else if (move && view.w < whole.w) { view.x += move[0] * step; view.y += move[1] * step; show(); }
      else return;
      event.preventDefault();
    });
  }

  document.querySelectorAll("figure").forEach(function (figure) { if (figure.querySelector("svg")) activate(figure); });
  // Printed, all tables are open.
  window.addEventListener("beforeprint", function () {
    document.querySelectorAll("details").forEach(function (d) { d.open = true; });
  });
})();
