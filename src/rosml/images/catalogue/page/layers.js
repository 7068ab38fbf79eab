// Which layers are in which images, and the bytes that sharing saves.
"use strict";

(() => {
  const r = window.rosml;
  const { el, svg } = r;

  /** Layers by position: size, part, and the numbers of the images that have them. */
  function users(images) {
    const found = new Map();
    images.forEach(({ found: platform }, number) => {
      for (const position of new Set(platform.layers)) {
        if (!found.has(position)) found.set(position, { layer: r.catalogue.layers[position], images: [] });
        found.get(position).images.push(number);
      }
    });
    return [...found.values()];
  }

  /** Numbers that follow one another, as [first, last]. */
  function runs(numbers) {
    const found = [];
    for (const number of numbers) {
      const last = found[found.length - 1];
      if (last && last[1] === number - 1) last[1] = number;
      else found.push([number, number]);
    }
    return found;
  }

  const KINDS = ["other", "ros", "cuda", "common", "torch", "tensorflow-cc", "tensorflow"];
  const NAMES = {
    other: "other",
    ros: "ROS and its system",
    cuda: "CUDA",
    common: "common Python",
    torch: "PyTorch",
    "tensorflow-cc": "TensorFlow, C++",
    tensorflow: "TensorFlow, Python",
  };

  /** A column for each image, a row for each layer, as high as it is large. */
  function picture(images, layers) {
    const sorted = [...layers].sort(
      (a, b) => KINDS.indexOf(r.kind(a.layer.part)) - KINDS.indexOf(r.kind(b.layer.part)) || a.images[0] - b.images[0],
    );
    const heights = sorted.map(({ layer }) => Math.max(1.5, Math.sqrt(layer.compressed / 1e6) / 1.6));
    let top = 0;
    const rows = sorted.map(({ layer, images: numbers }, index) => {
      const y = top;
      top += heights[index] + 0.6;
      const text = `${layer.part || "other"}, ${r.size(layer.compressed)}, in ${r.count(numbers.length, "image")}`;
      return svg(
        "g",
        { class: `kind-${r.kind(layer.part)}` },
        svg("title", null, text),
        runs(numbers).map(([first, last]) =>
          svg("rect", { x: first, y, width: last - first + 1, height: heights[index] }),
        ),
      );
    });
    return el(
      "div",
      {
        class: "picture",
        role: "img",
        "aria-label": `A picture of ${r.count(layers.length, "layer")} in ${r.count(images.length, "image")}; the table below says the same`,
      },
      svg(
        "svg",
        {
          viewBox: `0 0 ${images.length} ${top}`,
          preserveAspectRatio: "none",
          "aria-hidden": "true",
          style: { height: `${Math.min(560, Math.max(160, top * 1.6))}px` },
        },
        rows,
      ),
    );
  }

  function sum(title, bytes, all, kind) {
    return el(
      "div",
      { class: "sum" },
      el("span", { class: "sum-title" }, title),
      el(
        "span",
        { class: "track", "aria-hidden": "true" },
        el("span", { class: `level ${kind}`, style: { width: `${Math.max(0.3, (100 * bytes) / all)}%` } }),
      ),
      el("strong", null, r.size(bytes)),
    );
  }

  function partRows(layers, images) {
    const parts = new Map();
    for (const { layer, images: numbers } of layers) {
      if (!parts.has(layer.part)) parts.set(layer.part, { bytes: 0, saved: 0, images: new Set() });
      const part = parts.get(layer.part);
      part.bytes += layer.compressed;
      part.saved += layer.compressed * (numbers.length - 1);
      for (const number of numbers) part.images.add(number);
    }
    const most = Math.max(1, ...[...parts.values()].map((part) => part.saved));
    return [...parts.entries()]
      .sort(([, a], [, b]) => b.saved - a.saved)
      .map(([name, part]) =>
        el(
          "tr",
          null,
          r.partHead(name),
          el("td", { class: "number" }, r.size(part.bytes)),
          el(
            "td",
            null,
            el(
              "details",
              null,
              el("summary", null, r.count(part.images.size, "image")),
              el(
                "ul",
                { class: "links" },
                [...part.images].map((number) =>
                  el(
                    "li",
                    null,
                    el("a", { href: `#/image/${images[number].image.target}` }, images[number].image.target),
                  ),
                ),
              ),
            ),
          ),
          el("td", { class: "number" }, r.size(part.saved)),
          el(
            "td",
            { class: "gauge wide", "aria-hidden": "true" },
            el("span", { class: `level kind-${r.kind(name)}`, style: { width: `${(100 * part.saved) / most}%` } }),
          ),
        ),
      );
  }

  /** Where another platform is chosen. */
  function chooser(platforms, name) {
    const select = el(
      "select",
      {
        id: "platform",
        onchange: (event) => {
          window.location.hash = `#/layers?platform=${encodeURIComponent(event.target.value)}`;
        },
      },
      platforms.map((item) => el("option", { value: item, selected: item === name }, item)),
    );
    return el("p", { class: "choose" }, el("label", { for: "platform" }, "Platform"), select);
  }

  function view(main, query) {
    const platforms = [...new Set(r.catalogue.images.flatMap((image) => image.platforms))];
    const name = platforms.includes(query.get("platform")) ? query.get("platform") : platforms[0];
    const images = r.published(name);
    main.append(el("h1", null, "Shared layers"), chooser(platforms, name));
    if (!images.length) {
      main.append(el("p", { class: "notice" }, `Nothing is published for ${name} yet.`));
      return;
    }
    const layers = users(images);
    const stored = r.bytes(layers.map((item) => item.layer));
    const apart = layers.reduce((total, item) => total + item.layer.compressed * item.images.length, 0);
    const kinds = KINDS.filter((kind) => layers.some((item) => r.kind(item.layer.part) === kind));
    main.append(
      el(
        "p",
        { class: "lead" },
        `${r.count(images.length, "image")} consist of ${r.count(layers.length, "layer")}. Sharing them saves ${r.size(apart - stored)}, ${Math.floor((100 * (apart - stored)) / apart)} %.`,
      ),
      el(
        "div",
        { class: "sums" },
        sum("each image by itself", apart, apart, "apart"),
        sum("in the registry", stored, apart, "stored"),
      ),
      el("h2", null, "Which image has which layer"),
      el(
        "p",
        null,
        "A column is an image, in the order of the matrix; a row is a layer, the higher the larger. One line through many columns is stored once.",
      ),
      el(
        "p",
        { class: "keys" },
        kinds.map((kind) => el("span", null, el("span", { class: `key kind-${kind}` }), NAMES[kind])),
      ),
      picture(images, layers),
      el("h2", null, "What each part saves"),
      r.table(
        "Parts and what sharing them saves",
        [
          "Part",
          { text: "Stored", className: "number" },
          "In",
          { text: "Saved", className: "number" },
          { text: "Share of the most that one saves", className: "wide", unseen: true },
        ],
        partRows(layers, images),
      ),
    );
  }

  r.views.layers = { title: "Shared layers", view };
})();
