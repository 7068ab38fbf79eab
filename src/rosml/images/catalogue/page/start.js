// From four choices to an image that is published, and files to begin with.
"use strict";

(() => {
  const r = window.rosml;
  const { el } = r;
  const BLOCK = 512; // bytes of a block in a tar

  /** Images that one can build on: published, and with compilers. */
  function offered() {
    return r.catalogue.images.filter((image) => r.present(image) && !image.only_runs);
  }

  function drivers(images) {
    return [...new Set(images.map((image) => image.gpu.driver).filter(Boolean))].sort((a, b) => Number(b) - Number(a));
  }

  function onJetson(image) {
    return image.search.includes("jetson") && r.platforms(image).own.includes("linux/arm64");
  }

  /** Whether an image runs on a machine: with a driver, on a Jetson, or without a GPU. ROS alone runs on any. */
  function runs(image, machine) {
    if (!r.hasGpu(image)) return machine === "none" || image.framework === "none";
    return machine === "jetson" ? onJetson(image) : machine !== "none" && Number(image.gpu.driver) <= Number(machine);
  }

  /** The choices, in their order: the values that there are, what they are called, and which images they leave. */
  const CHOICES = {
    distribution: {
      title: "ROS distribution",
      values: (images) => [...new Set(images.map((image) => image.distribution))],
      name: (value) => {
        const { ros, os } = r.catalogue.distributions[value];
        return `${value}: ROS ${ros} on ${os}`;
      },
      fits: (image, value) => image.distribution === value,
    },
    component: {
      title: "Component",
      values: (images) => [...new Set(images.map((image) => image.component))],
      name: String,
      fits: (image, value) => image.component === value,
    },
    framework: {
      title: "Framework",
      values: (images) => [...new Set(images.map((image) => image.framework))],
      name: (value) => r.TITLES[value] || value,
      fits: (image, value) => image.framework === value,
    },
    gpu: {
      title: "GPU",
      values: (images) => [...drivers(images), ...(images.some(onJetson) ? ["jetson"] : []), "none"],
      name: (value) =>
        ({ none: "no NVIDIA GPU", jetson: "NVIDIA Jetson with JetPack 7" })[value] || `NVIDIA, driver ${value} or newer`,
      fits: runs,
    },
  };
  const NAMES = Object.keys(CHOICES);

  /** The distribution that is supported longest, if any of the long-term ones is there. */
  function usual(values) {
    const facts = r.catalogue.distributions;
    const lasting = values.filter((value) => facts[value].lts && !facts[value].experimental);
    return lasting.sort((a, b) => (facts[a].eol < facts[b].eol ? 1 : -1))[0] || values[0];
  }

  const WISHED = { distribution: usual, component: () => "base", framework: () => "torch", gpu: (values) => values[0] };

  /** Each choice with the values that are left by those before it, and the one that holds. */
  function chosen(query) {
    let images = offered();
    const found = {};
    for (const name of NAMES) {
      const { values, fits } = CHOICES[name];
      const left = values(images).filter((value) => images.some((image) => fits(image, value)));
      const value = [query.get(name), WISHED[name](left), left[0]].find((item) => left.includes(item));
      images = images.filter((image) => fits(image, value));
      found[name] = { left, value };
    }
    return { found, image: best(images) };
  }

  /** Of several, the one that needs the newest driver; of these the one with the short tags, or else the first. */
  function best(images) {
    const [newest] = drivers(images);
    const among = images.filter((image) => !newest || image.gpu.driver === newest);
    return among.find((image) => image.tags.some((tag) => tag.kind === "floating")) || among[0];
  }

  function field(bytes, text, start, length) {
    bytes.set(new TextEncoder().encode(text).slice(0, length), start);
  }

  function octal(number, length) {
    return number.toString(8).padStart(length - 1, "0");
  }

  /** The head of a file in a tar: https://www.gnu.org/software/tar/manual/html_node/Standard.html */
  function head(name, size) {
    const bytes = new Uint8Array(BLOCK);
    field(bytes, name, 0, 100);
    for (const [number, start, length] of [
      [0o644, 100, 8],
      [0, 108, 8],
      [0, 116, 8],
      [size, 124, 12],
      [Math.floor(Date.parse(r.catalogue.created) / 1000) || 0, 136, 12],
    ])
      field(bytes, octal(number, length), start, length);
    field(bytes, " ".repeat(8), 148, 8);
    field(bytes, "0ustar\u000000", 156, 9);
    const sum = bytes.reduce((total, byte) => total + byte, 0);
    field(bytes, `${octal(sum, 7)}\u0000 `, 148, 8);
    return bytes;
  }

  /** Files as a tar, which keeps names that begin with a point. */
  function tar(files) {
    const parts = Object.entries(files).flatMap(([name, text]) => {
      const content = new TextEncoder().encode(text);
      return [head(name, content.length), content, new Uint8Array((BLOCK - (content.length % BLOCK)) % BLOCK)];
    });
    return new Blob([...parts, new Uint8Array(2 * BLOCK)], { type: "application/x-tar" });
  }

  function download(name, blob) {
    const href = URL.createObjectURL(blob);
    const link = el("a", { href, download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(href), 60_000);
  }

  function result(image) {
    const reference = r.reference(image, r.mainTag(image));
    const files = r.usage.files(image, reference);
    return [
      el("h2", null, "Your image"),
      r.snippet(reference, "Copy the image's name"),
      el("p", { class: "badges" }, r.badgeNodes(image)),
      el("p", null, "For ", r.platforms(image).own.join(", "), ". ", el("a", { href: `#/image/${image.target}` }, "All about it")),
      el("h2", null, "Files for your package"),
      el("p", null, "Unpack them beside your package.xml, and put the names of your package and your node in."),
      el(
        "p",
        null,
        el("button", { type: "button", class: "download", onclick: () => download("rosml.tar", tar(files)) }, "Download rosml.tar"),
      ),
      r.snippet("tar -xf rosml.tar && docker compose run --rm --build detector", "Copy the command that unpacks and runs"),
      Object.entries(files).map(([name, text]) => el("details", null, el("summary", { class: "mono" }, name), r.snippet(text, `Copy ${name}`))),
    ].flat();
  }

  function chooser(name, found, onchange) {
    const select = el(
      "select",
      { id: `choose-${name}`, onchange },
      found.left.map((value) => el("option", { value, selected: value === found.value }, CHOICES[name].name(value))),
    );
    return el("div", { class: "step" }, el("label", { for: `choose-${name}` }, CHOICES[name].title), select);
  }

  function view(main, query) {
    main.append(el("h1", null, "Start"));
    if (!offered().length) {
      main.append(
        el("p", { class: "lead" }, `No image to build on is published in ${r.catalogue.registry} yet, so there is none to start from.`),
        el("p", null, "You can ", el("a", { href: "#/" }, "choose one of the images"), ": its page has the command that builds it."),
      );
      return;
    }
    const form = el("form", { class: "steps", onsubmit: (event) => event.preventDefault() });
    const told = el("p", { class: "hidden", role: "status" });
    const place = el("div");

    function show(wanted, focus) {
      const { found, image } = chosen(wanted);
      const onchange = (event) => {
        const next = new URLSearchParams(NAMES.map((name) => [name, document.getElementById(`choose-${name}`).value]));
        history.replaceState(null, "", `#/start?${next}`);
        show(next, event.target.id);
      };
      form.replaceChildren(...NAMES.map((name) => chooser(name, found[name], onchange)));
      place.replaceChildren(...result(image));
      told.textContent = `Your image: ${r.reference(image, r.mainTag(image))}`;
      if (focus) document.getElementById(focus).focus();
    }

    main.append(
      el("p", { class: "lead" }, "Four choices lead to an image that is published here, and to files for your package."),
      form,
      told,
      place,
    );
    show(query, "");
  }

  r.views.start = { title: "Start", view };
})();
