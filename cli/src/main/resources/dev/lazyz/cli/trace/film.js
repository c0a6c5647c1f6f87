"use strict";
(async () => {
  const figures = [...document.querySelectorAll(".order")];
  const { steps, most, speed } = Object.fromEntries(Object.entries(figures[0].dataset).map(([k, v]) => [k, Number(v)]));
  const find = (id) => document.getElementById(id);

  // A colour such as #c8c8c8 as a pixel of ImageData, which is red, green, blue, alpha in memory
  const pixel = (color) => {
    const [, r, g, b] = /^#(..)(..)(..)$/.exec(color).map((digits) => parseInt(digits, 16));
    return new Uint32Array(new Uint8Array([r, g, b, 255]).buffer)[0];
  };

  // Returns the pixels of all calls: twice the place, plus 1 if the call is discarded
  const decoded = async (text) => {
    const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    let at = 0;
    const number = () => {
      let value = 0;
      for (let factor = 1; ; factor *= 128) {
        const byte = bytes[at++];
        value += (byte % 128) * factor;
        if (byte < 128) return value;
      }
    };
    const runs = [];
    let place = 0;
    let size = 0;
    while (at < bytes.length) {
      const distance = number();
      const end = number();
      place += distance % 2 ? -(distance + 1) / 2 : distance / 2;
      const length = Math.floor(end / 2);
      runs.push([place, length, end % 2]);
      place += length;
      size += length;
    }
    const calls = new Uint32Array(size);
    let call = 0;
    for (const [first, length, discarded] of runs) {
      for (let i = 0; i < length; i++) calls[call++] = 2 * (first + i) + discarded;
    }
    return calls;
  };

  // Returns a function that draws the state after a number of steps
  const panel = async (figure) => {
    const calls = await decoded(figure.dataset.calls);
    const waiting = pixel(figure.dataset.waiting);
    const pink = pixel(figure.dataset.discarded);
    const canvas = figure.querySelector("canvas");
    const context = canvas.getContext("2d");
    const image = context.createImageData(canvas.width, canvas.height);
    const target = new Uint32Array(image.data.buffer);
    const shown = new Uint32Array(target.length);
    let done = 0;
    let discarded = 0;
    const reset = () => {
      shown.fill(0);
      for (const call of calls) if (call % 2 === 0) shown[call >>> 1] = waiting;
      done = 0;
      discarded = 0;
    };
    reset();
    const until = (step) => Math.min(Math.floor((most * step) / steps), calls.length);
    return (step) => {
      const end = until(step);
      if (end < done) reset();
      for (; done < end; done++) {
        const place = calls[done] >>> 1;
        if (calls[done] % 2 === 0) {
          shown[place] = 0;
        } else {
          discarded++;
          if (shown[place] !== 0) shown[place] = pink;
        }
      }
      target.set(shown);
      for (let call = until(step - 1); step > 0 && call < end; call++) {
        if (calls[call] % 2 === 1) target[calls[call] >>> 1] = pink;
      }
      context.putImageData(image, 0, 0);
      figure.querySelector(".calls").textContent = done.toLocaleString("en");
      figure.querySelector(".discarded").textContent = discarded.toLocaleString("en");
    };
  };

  const panels = await Promise.all(figures.map(panel));
  const slider = find("step");
  const play = find("play");
  let timer = 0;
  const pause = () => {
    clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
  };
  const show = (step) => {
    slider.value = step;
    slider.setAttribute("aria-valuetext", `step ${step} of ${steps}`);
    find("shown").textContent = `step ${step} of ${steps}`;
    for (const draw of panels) draw(step);
  };
  const go = (step) => {
    pause();
    show(Math.max(0, Math.min(step, steps)));
  };
  play.addEventListener("click", () => {
    if (timer) return pause();
    if (Number(slider.value) >= steps) show(0);
    play.textContent = "Pause";
    timer = setInterval(() => {
      show(Number(slider.value) + 1);
      if (Number(slider.value) >= steps) pause();
    }, 1000 / speed);
  });
  find("back").addEventListener("click", () => go(Number(slider.value) - 1));
  find("forward").addEventListener("click", () => go(Number(slider.value) + 1));
  slider.addEventListener("input", () => go(Number(slider.value)));
  document.querySelector(".controls").hidden = false;
})();
