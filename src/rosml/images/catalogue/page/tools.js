// What all views share: elements, numbers, dates, copying. Every text goes into the page as text, never as markup.
"use strict";

window.rosml = {};

(() => {
  const SVG = "http://www.w3.org/2000/svg";

  function fill(node, attributes, children) {
    for (const [name, value] of Object.entries(attributes || {})) {
      if (value === null || value === undefined || value === false) continue;
      if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
      else if (name === "style") for (const [key, text] of Object.entries(value)) node.style.setProperty(key, text);
      else node.setAttribute(name, value === true ? "" : value);
    }
    node.append(...children.flat(3).filter((child) => child !== null && child !== undefined && child !== false));
    return node;
  }

  /** An element: el("a", {href: "#/"}, "text", otherElement). Handlers are attributes such as onclick. */
  function el(name, attributes, ...children) {
    return fill(document.createElement(name), attributes, children);
  }

  /** The same within a picture. */
  function svg(name, attributes, ...children) {
    return fill(document.createElementNS(SVG, name), attributes, children);
  }

  /** Bytes for people, in decimal units: 3.61 GB. */
  function size(bytes) {
    if (bytes === null || bytes === undefined) return "not counted";
    const units = ["B", "kB", "MB", "GB", "TB"];
    let value = bytes;
    let unit = 0;
    while (value >= 999.5 && unit < units.length - 1) {
      value /= 1000;
      unit += 1;
    }
    const digits = unit === 0 || value >= 100 ? 0 : value >= 10 ? 1 : 2;
    return `${value.toFixed(digits)} ${units[unit]}`;
  }

  function count(number, noun, several = `${noun}s`) {
    return `${number.toLocaleString("en")} ${number === 1 ? noun : several}`;
  }

  /** The day of a date; all of it is its title. */
  function day(date) {
    return date ? el("time", { datetime: date, title: date }, date.slice(0, 10)) : "unknown";
  }

  /** The dates of two builds, with their times if they are of one day. */
  function days(date, other) {
    const end = date.slice(0, 10) === other.slice(0, 10) ? 16 : 10;
    return [date, other].map((text) =>
      text ? el("time", { datetime: text, title: text }, text.slice(0, end).replace("T", " ")) : "unknown",
    );
  }

  /** The beginning of a digest; all of it is its title. */
  function digest(text) {
    return el("code", { class: "digest", title: text }, text.slice(0, 19));
  }

  let timer = 0;

  /** Says something at the page's edge, and to screen readers. */
  function tell(text) {
    const place = document.getElementById("told");
    place.textContent = text;
    place.classList.add("shown");
    clearTimeout(timer);
    timer = setTimeout(() => place.classList.remove("shown"), 3000);
  }

  function copyByHand(text) {
    const area = el("textarea", { class: "hidden", "aria-hidden": "true" });
    const focused = document.activeElement;
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    if (focused) focused.focus();
    return done;
  }

  /** Copies a text, and says so. */
  async function copy(text) {
    let done = false;
    try {
      await navigator.clipboard.writeText(text);
      done = true;
    } catch {
      done = copyByHand(text);
    }
    tell(done ? `Copied: ${text}` : `Your browser does not let this page copy. The text is: ${text}`);
  }

  /** A button that copies what `text` gives at that moment. */
  function copyButton(text, name, label) {
    return el("button", { type: "button", class: "copy", "aria-label": label, onclick: () => copy(text()) }, name);
  }

  /**
   * A table within a frame that scrolls sideways where the screen is narrow. A column's head is a text, or {text, className,
   * unseen}: one that only screen readers tell.
   */
  function table(caption, head, rows, options) {
    const cells = head.map((item) => {
      const { text, className, unseen } = typeof item === "string" ? { text: item } : item;
      return el(
        "th",
        { scope: "col", class: className || null },
        unseen ? el("span", { class: "hidden" }, text) : text,
      );
    });
    return el(
      "div",
      { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
      el(
        "table",
        { class: (options && options.class) || null },
        el("caption", { class: options && options.caption ? null : "hidden" }, caption),
        el("thead", null, el("tr", null, cells)),
        el("tbody", null, rows),
      ),
    );
  }

  /** A name and what it is, for a list of facts. */
  function fact(name, ...value) {
    return el("div", null, el("dt", null, name), el("dd", null, ...value));
  }

  /** The head of a part's row: its name, behind the colour of its kind. */
  function partHead(part) {
    return el(
      "th",
      { scope: "row" },
      el("span", { class: `key kind-${window.rosml.kind(part)}`, "aria-hidden": "true" }),
      part || "other",
    );
  }

  let tabsMade = 0;

  /**
   * Tabs, by keys as https://www.w3.org/WAI/ARIA/apg/patterns/tabs/ has them: arrows, Home and End choose one. A panel is made when
   * its tab is chosen.
   *
   * @param {{title: string, panel: () => Node[]}[]} items
   */
  function tabs(label, items) {
    tabsMade += 1;
    const id = `tabs-${tabsMade}`;
    const panel = el("div", { class: "panel", role: "tabpanel", id: `${id}-panel` });
    const buttons = items.map((item, index) =>
      el(
        "button",
        { type: "button", role: "tab", id: `${id}-${index}`, "aria-controls": `${id}-panel`, onclick: () => choose(index) },
        item.title,
      ),
    );
    let chosen = 0;

    function choose(index) {
      chosen = index;
      for (const [place, button] of buttons.entries()) {
        button.setAttribute("aria-selected", String(place === index));
        button.tabIndex = place === index ? 0 : -1;
      }
      panel.setAttribute("aria-labelledby", `${id}-${index}`);
      panel.replaceChildren(...items[index].panel());
    }

    const last = buttons.length - 1;
    const keys = {
      ArrowRight: () => (chosen === last ? 0 : chosen + 1),
      ArrowLeft: () => (chosen === 0 ? last : chosen - 1),
      Home: () => 0,
      End: () => last,
    };
    const onkeydown = (event) => {
      if (!(event.key in keys)) return;
      event.preventDefault();
      choose(keys[event.key]());
      buttons[chosen].focus();
    };
    choose(0);
    const node = el("div", { class: "tabs" }, el("div", { role: "tablist", "aria-label": label, onkeydown }, buttons), panel);
    return { node, again: () => choose(chosen) };
  }

  /** A text to be copied: one line, or a file with its name. */
  function snippet(text, label, name) {
    return el(
      "div",
      { class: "snippet" },
      name ? el("p", { class: "sub mono" }, name) : null,
      el("div", { class: "from" }, el("pre", { class: "line", tabindex: "0" }, text), copyButton(() => text, "Copy", label)),
    );
  }

  Object.assign(window.rosml, {
    el,
    tabs,
    snippet,
    svg,
    size,
    count,
    day,
    days,
    digest,
    copy,
    copyButton,
    table,
    fact,
    partHead,
  });
})();
