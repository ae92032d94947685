'use strict';
// Keys as sound (ITU-T Q.23) in frames of 20 ms A-law (G.711), and the far end's frames as sound.
const Sound = (() => {
  const RATE = 8000;
  const FRAME = 160;
  const FRAME_MILLIS = 20;
  const LOW = [697, 770, 852, 941];
  const HIGH = [1209, 1336, 1477];
  const KEYS = '123456789*0#';
  const AMPLITUDE = 7100; // about -10 dBm0 for each of the two tones
  const LEAST_TONE = 0.07 * RATE;
  const LEAST_PAUSE = 0.07 * RATE;
  const MOST_CATCH_UP = 10;
  const MOST_OWED_MILLIS = 2000;
  const RAMP = 16; // samples; softens the click at both ends

  const frequencies = key => [LOW[Math.floor(KEYS.indexOf(key) / 3)], HIGH[KEYS.indexOf(key) % 3]];

  function toALaw(sample) {
    const negative = sample < 0;
    let value = Math.min(32767, negative ? -sample - 1 : sample) >> 3;
    value = Math.max(0, value);
    let exponent = 0;
    if (value >= 32) {
      exponent = 1;
      while (value >> exponent > 31 && exponent < 7) {
        exponent++;
      }
    }
    const mantissa = exponent === 0 ? value >> 1 : (value >> exponent) & 15;
    return ((negative ? 0 : 0x80) | exponent << 4 | mantissa) ^ 0x55;
  }

  function fromALaw(octet) {
    const code = octet ^ 0x55;
    const exponent = code >> 4 & 7;
    const mantissa = (code & 15) << 4;
    const value = exponent === 0 ? mantissa + 8 : mantissa + 264 << exponent - 1;
    return code & 0x80 ? value : -value;
  }

  // The keys of one call: when each went down and up, in samples since the call's start.
  class KeySource {
    constructor(send) {
      this.send = send;
      this.begun = performance.now();
      this.framesSent = 0;
      this.keys = [];
      this.freeFrom = 0;
      this.timer = setInterval(() => this.tick(), 10);
    }

    // The time stops while a page that the browser has slowed down or suspended owes 2 s: its keys would wait for the rest.
    now() {
      this.begun = Math.max(this.begun, performance.now() - this.framesSent * FRAME_MILLIS - MOST_OWED_MILLIS);
      return (performance.now() - this.begun) * RATE / 1000;
    }

    down(key) {
      this.up();
      const start = Math.max(this.now(), this.freeFrom, this.framesSent * FRAME);
      this.keys.push({ key, start, end: Infinity });
    }

    up() {
      const last = this.keys[this.keys.length - 1];
      if (last && last.end === Infinity) {
        last.end = Math.max(this.now(), last.start + LEAST_TONE);
        this.freeFrom = last.end + LEAST_PAUSE;
      }
    }

    tick() {
      const due = Math.floor(this.now() / FRAME);
      for (let sent = 0; this.framesSent < due && sent < MOST_CATCH_UP; sent++) {
        this.send(this.frame());
        this.framesSent++;
      }
    }

    frame() {
      const octets = new Uint8Array(FRAME);
      const from = this.framesSent * FRAME;
      this.keys = this.keys.filter(each => each.end > from);
      for (let i = 0; i < FRAME; i++) {
        octets[i] = toALaw(Math.round(this.sample(from + i)));
      }
      return octets;
    }

    sample(at) {
      const tone = this.keys.find(each => each.start <= at && at < each.end);
      if (!tone) {
        return 0;
      }
      const ramp = Math.min(1, (at - tone.start) / RAMP, (tone.end - at) / RAMP);
      const seconds = (at - tone.start) / RATE;
      return frequencies(tone.key)
        .reduce((sum, hertz) => sum + AMPLITUDE * ramp * Math.sin(2 * Math.PI * hertz * seconds), 0);
    }

    stop() {
      clearInterval(this.timer);
    }
  }

  let context = null;
  let output = null; // the far end, without the own keys
  let next = 0;
  let oscillators = [];

  // To be called in every press: browsers let a page sound only then, and interrupt it after a call or a locked screen.
  function wake() {
    if (!context) {
      context = new (window.AudioContext || window.webkitAudioContext)();
      output = context.createGain();
      output.connect(context.destination);
    }
    if (context.state !== 'running') {
      context.resume();
    }
  }

  function play(octets) {
    if (!context || context.state !== 'running') {
      return;
    }
    if (next < context.currentTime + 0.005) {
      next = context.currentTime + 0.12;
    } else if (next > context.currentTime + 0.3) {
      return;
    }
    const buffer = context.createBuffer(1, octets.length, RATE);
    const samples = buffer.getChannelData(0);
    octets.forEach((octet, i) => { samples[i] = fromALaw(octet) / 32768; });
    const source = context.createBufferSource();
    source.buffer = buffer;
    source.connect(output);
    source.start(next);
    next += octets.length / RATE;
  }

  // The key as its user hears it: at once, beside the frames that leave.
  function sound(hertz, level) {
    silence();
    if (!context) {
      return;
    }
    const gain = context.createGain();
    gain.gain.value = level;
    gain.connect(context.destination);
    oscillators = hertz.map(each => {
      const oscillator = context.createOscillator();
      oscillator.frequency.value = each;
      oscillator.connect(gain);
      oscillator.start();
      return oscillator;
    });
  }

  function silence() {
    oscillators.forEach(each => each.stop());
    oscillators = [];
  }

  return { KeySource, wake, play, silence, keyTone: key => sound(frequencies(key), 0.1),
    ring: on => on ? sound([425], 0.05) : silence(), context: () => context, output: () => output, toALaw, fromALaw };
})();
