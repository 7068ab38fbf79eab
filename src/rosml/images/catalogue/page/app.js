// Which view is shown: the part of the address after # says it, so that every view can be linked to, and Back works.
"use strict";

(() => {
  const r = window.rosml;
  const main = document.getElementById("main");
  const KEY = "rosml-colours";

  function show(first) {
    const [path, text] = (window.location.hash.replace(/^#/, "") || "/").split("?");
    const [, name, ...rest] = path.split("/").map(decodeURIComponent);
    const known = r.views[name || "list"] ? name || "list" : "list";
    const { title, view } = r.views[known];
    main.replaceChildren();
    main.dataset.view = known;
    view(main, new URLSearchParams(text || ""), rest.join("/"));
    const words = typeof title === "string" ? title : title(rest.join("/"));
    document.title = `${words} · Catalogue of ROS images`;
    for (const link of document.querySelectorAll("nav a")) {
      if (link.dataset.view === known) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    if (!first) {
      window.scrollTo(0, 0);
      const heading = main.querySelector("h1");
      heading.tabIndex = -1;
      heading.focus();
    }
  }

  function stored() {
    try {
      return localStorage.getItem(KEY) || "";
    } catch {
      return ""; // no storage: as the system has it
    }
  }

  function paint(colours) {
    if (colours) document.documentElement.dataset.theme = colours;
    else delete document.documentElement.dataset.theme;
  }

  const theme = document.getElementById("theme");
  theme.value = stored();
  paint(theme.value);
  theme.addEventListener("change", () => {
    paint(theme.value);
    try {
      localStorage.setItem(KEY, theme.value);
    } catch {
      // it holds until the page is left
    }
  });

  const skip = document.querySelector(".skip");
  skip.addEventListener("click", (event) => {
    event.preventDefault();
    main.focus();
  });

  document.addEventListener("keydown", (event) => {
    const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(document.activeElement.tagName);
    const search = document.getElementById("search");
    if (event.key === "/" && !typing && search && !event.ctrlKey && !event.metaKey) {
      event.preventDefault();
      search.focus();
    }
  });

  const { catalogue } = r;
  const built = catalogue.images.filter((image) => image.status === "built").length;
  document.getElementById("where").textContent = catalogue.registry;
  document.getElementById("written").textContent =
    `Written ${catalogue.created.slice(0, 16).replace("T", " ")} UTC. ${r.count(built, "image")} of ${catalogue.images.length} published, as ${r.count(catalogue.sharing.images, "manifest")}: ${r.size(catalogue.sharing.stored)} in the registry, ${r.size(catalogue.sharing.apart)} without sharing.`;
  const source = document.getElementById("source");
  source.hidden = !(catalogue.source || "").startsWith("https://");
  if (!source.hidden) source.firstElementChild.href = catalogue.source;
  // The night writes this page anew. Where it does not run, images get no updates, and the page would not say so.
  const days = (Date.now() - Date.parse(catalogue.created)) / 86_400_000;
  const old = document.getElementById("old");
  old.hidden = !(days > 2);
  old.textContent = old.hidden ? "" : `This catalogue is ${Math.floor(days)} days old. No night has run since, or none got this far: images have no updates of these days.`;
  window.addEventListener("hashchange", () => show(false));
  show(true);
  document.documentElement.dataset.ready = "yes";
})();
