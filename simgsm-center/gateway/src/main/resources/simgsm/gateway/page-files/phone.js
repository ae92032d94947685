'use strict';
(() => {
  const LETTERS = { 2: 'abc', 3: 'def', 4: 'ghi', 5: 'jkl', 6: 'mno', 7: 'pqrs', 8: 'tuv', 9: 'wxyz', 0: '+' };
  const MOST_ROWS = 60;
  const FINAL = { 4001: 'closed.key', 4002: 'closed.full', 4003: 'closed.locked', 4004: 'closed.dropped', 4000: 'closed.elsewhere' };
  const $ = id => document.getElementById(id);
  const language = (navigator.language || 'en').startsWith('es') ? 'es' : 'en';
  const key = location.hash.slice(1);
  let words = {};
  let socket = null;
  let phase = 'idle';
  let entry = '';
  let keys = null;
  let held = null;
  let heldCode = null; // of the keyboard's key; a key that Shift made * or # may come up as another
  let remark = '';
  let peer = '';
  let connectedAt = 0;
  let ringing = null;
  let retry = 0;
  let robots = [];
  let chosen = '';
  // The place of the own number among all; with as many robots, each number has its own.
  let place = 0;
  let places = 0;
  let showsCamera = false;
  let isFinished = false;
  let calls = JSON.parse(sessionStorage.getItem('calls') || '[]');

  const word = (name, ...values) => values.reduce((text, value, i) => text.replace(`{${i}}`, () => value), words[name] || name);

  function time(millis) {
    const shown = document.createElement('time');
    shown.textContent = new Date(millis).toLocaleTimeString(language, { hourCycle: 'h23' });
    return shown;
  }

  function row(list, text, kind) {
    const item = document.createElement('li');
    item.textContent = text;
    if (kind) {
      item.className = kind;
    }
    list.append(item);
    while (list.children.length > MOST_ROWS) {
      list.firstElementChild.remove();
    }
    list.scrollTop = list.scrollHeight;
    return item;
  }

  const message = (text, kind, at) => row($('box'), text, kind).prepend(time(at || Date.now()), ' ');

  // Screen readers speak a status again when it is written again.
  function write(id, text) {
    if ($(id).textContent !== text) {
      $(id).textContent = text;
    }
  }

  function show(text, clock = '') {
    write('line', text);
    write('clock', clock);
  }

  function showEntry() {
    const shown = document.createElement('bdi');
    shown.textContent = entry;
    $('keyed').replaceChildren(shown);
  }

  function notice(text) {
    $('notice').hidden = !text;
    $('notice').textContent = text;
  }

  const send = message => {
    if (socket && socket.readyState === WebSocket.OPEN) {
      socket.send(JSON.stringify(message));
    }
  };

  // Calls.

  function begin(kind, number) {
    calls = calls.slice(1 - MOST_ROWS).concat({ kind, number, at: Date.now(), seconds: 0 });
    peer = number;
    showCalls();
  }

  function lastCall(news) {
    Object.assign(calls[calls.length - 1] || {}, news);
    showCalls();
  }

  function showCalls() {
    sessionStorage.setItem('calls', JSON.stringify(calls));
    $('past').replaceChildren();
    for (const past of calls) {
      const again = document.createElement('button');
      again.type = 'button';
      again.textContent = word('call.' + past.kind, past.number) + (past.seconds ? `  ${minutes(past.seconds)}` : '');
      again.addEventListener('click', () => { if (phase === 'idle') { entry = past.number; showEntry(); $('call').focus(); } });
      const item = row($('past'), '');
      item.append(time(past.at), again);
      $('past').prepend(item);
    }
  }

  const minutes = seconds => `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
  const callSeconds = () => Math.floor((Date.now() - connectedAt) / 1000);

  function setPhase(next) {
    phase = next;
    remark = '';
    document.body.dataset.phase = next;
    const inCall = next === 'connected';
    if (inCall && !keys) {
      keys = new Sound.KeySource(frame => socket && socket.readyState === WebSocket.OPEN && socket.send(frame));
    } else if (!inCall && keys) {
      release();
      keys.stop();
      keys = null;
    }
    clearInterval(ringing);
    Sound.silence();
    if (next === 'alerting' || next === 'ringing') {
      let beat = 0;
      ringing = setInterval(() => { Sound.ring(beat % 5 === 0); beat++; }, 1000);
    }
  }

  const heard = {
    welcome: event => {
      sessionStorage.setItem('token', event.token);
      $('own').textContent = event.number;
      place = Number(event.place);
      places = Number(event.places);
      chosen = '';
      $('robots').replaceChildren();
      retry = 0;
      $('box').replaceChildren();
      showLadder();
      notice('');
      setPhase('idle');
      show(word('searching'));
    },
    registered: () => { $('lamp').className = 'on'; if (phase === 'idle') { show(word('ready')); } },
    unregistered: () => { $('lamp').className = ''; show(word('searching')); },
    calling: event => { $('tones').replaceChildren(); begin('out', event.number); setPhase('calling'); show(word('calling', event.number)); },
    alerting: () => { setPhase('alerting'); show(word('alerting', peer)); },
    ringing: event => { $('tones').replaceChildren(); begin('missed', event.from || '?'); setPhase('ringing'); show(word('ringing', event.from)); },
    connected: event => {
      peer = event.number || peer;
      lastCall({ kind: phase === 'ringing' ? 'in' : 'out' });
      connectedAt = Date.now();
      entry = '';
      showEntry();
      setPhase('connected');
      chooseByNumber(peer);
    },
    released: event => {
      lastCall(phase === 'connected' ? { seconds: callSeconds() } : {});
      setPhase('idle');
      entry = '';
      showEntry();
      show(word('released', words['cause.' + event.cause] || event.text));
    },
    layer3: event => {
      const item = row($('rungs'), '', event.direction);
      const arrow = document.createElement('b');
      arrow.setAttribute('role', 'img');
      arrow.setAttribute('aria-label', word('ladder.' + event.direction));
      item.append(time(Number(event.millis)), arrow, event.name);
    },
    tone: event => {
      const item = row($('tones'), '');
      const chip = document.createElement('b');
      chip.textContent = event.key;
      item.append(chip, ' ' + (words['tone.' + event.key] || ''));
    },
    words: event => row($('tones'), event.text, 'said'),
    sms: event => { message(word('sms.from', event.from, event.text)); show(word('sms.new', event.from)); },
    'sms-sent': event => message(word('sms.sent', event.to), 'quiet'),
    'sms-delivered': event => message(word('sms.delivered', event.to), 'quiet'),
    'sms-failed': event => message(word('sms.failed', event.to, event.text)),
    'sms-undelivered': event => message(word('sms.failed', event.to, event.text)),
    message: event => message(word('sms.from', event.from, event.text), '', Number(event.millis)),
    error: event => {
      const text = words['error.' + event.text.split(':')[0]] || event.text;
      show(text);
      if (event.text.startsWith('sms:')) {
        message(text);
      }
    },
  };

  function call() {
    if (phase === 'ringing') {
      send({ do: 'answer' });
    } else if (phase === 'idle') {
      // Without a number the call key shows the last one that was called; the next press calls it.
      const last = calls.filter(past => past.kind === 'out').pop();
      if (entry) {
        peer = entry;
        send({ do: 'dial', number: entry });
      } else if (last) {
        entry = last.number;
        showEntry();
      }
    }
  }

  function end() {
    if (phase === 'idle') {
      entry = '';
      showEntry();
    } else {
      send({ do: 'hangup' });
    }
  }

  function press(name) {
    if (held === name || !Sound.context()) {
      return;
    }
    release();
    held = name;
    remark = '';
    button(name).classList.add('down');
    Sound.wake();
    Sound.keyTone(name);
    if (keys) {
      keys.down(name);
    }
    entry += name;
    showEntry();
  }

  function release() {
    if (held !== null) {
      button(held).classList.remove('down');
      held = null;
      heldCode = null;
      Sound.silence();
      if (keys) {
        keys.up();
      }
    }
  }

  // Without its focus the page does not hear a key come up.
  function leave() {
    if (held !== null) {
      remark = word('key.left', held);
      show(remark);
      release();
    }
  }

  const button = name => document.querySelector(`#keys [data-key="${name}"]`);

  function makeKeys() {
    for (const name of '123456789*0#') {
      const each = document.createElement('button');
      each.type = 'button';
      each.dataset.key = name;
      each.textContent = name;
      each.setAttribute('aria-label', { '*': word('key.star'), '#': word('key.hash') }[name] || name);
      const small = document.createElement('small');
      small.textContent = LETTERS[name] || '\u00a0';
      each.append(small);
      each.addEventListener('pointerdown', event => {
        event.preventDefault();
        each.setPointerCapture(event.pointerId);
        press(name);
      });
      for (const ending of ['pointerup', 'pointercancel', 'lostpointercapture']) {
        each.addEventListener(ending, () => held === name && release());
      }
      each.addEventListener('keydown', event => (event.key === ' ' || event.key === 'Enter') && !event.repeat && press(name));
      each.addEventListener('keyup', event => (event.key === ' ' || event.key === 'Enter') && release());
      each.addEventListener('contextmenu', event => event.preventDefault());
      $('keys').append(each);
    }
  }

  function onKeyboard(event) {
    const isTyping = /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName);
    // Some keyboards have * and # only with Option or AltGr, and AltGr may look like Ctrl and Alt.
    const isSign = event.key === '*' || event.key === '#';
    const isShortcut = event.metaKey || event.altKey && !isSign || event.ctrlKey && !(isSign && event.getModifierState('AltGraph'));
    if (isTyping || isShortcut || $('phone').hidden || isFinished) {
      return;
    }
    if (event.key.length === 1 && '0123456789*#'.includes(event.key)) {
      event.preventDefault();
      if (!event.repeat) {
        press(event.key);
        heldCode = event.code;
      }
    } else if (event.key === 'Enter' && event.target.tagName !== 'BUTTON') {
      call();
    } else if (event.key === 'Escape') {
      end();
    } else if (event.key === 'Backspace' && phase === 'idle') {
      entry = entry.slice(0, -1);
      showEntry();
    }
  }

  // The connection.

  function connect() {
    socket = new WebSocket(`ws${location.protocol === 'https:' ? 's' : ''}://${location.host}/phone`, ['simgsm.v1']);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => socket.send(JSON.stringify(
      { key, token: sessionStorage.getItem('token') || '', name: $('name').value.trim() }));
    socket.onmessage = message => {
      if (typeof message.data === 'string') {
        const event = JSON.parse(message.data);
        (heard[event.event] || (() => {}))(event);
      } else {
        Sound.play(new Uint8Array(message.data));
      }
    };
    socket.onclose = event => {
      setPhase('idle');
      $('lamp').className = '';
      if (FINAL[event.code]) {
        sessionStorage.removeItem('token');
        finish(word(FINAL[event.code]));
        return;
      }
      retry = Math.min(retry + 1, 5);
      let seconds = retry;
      const count = () => {
        notice(word('lost', seconds));
        if (seconds-- > 0) {
          setTimeout(count, 1000);
        } else {
          connect();
        }
      };
      count();
    };
  }

  // Nothing goes on until the page is loaded again.
  function finish(text) {
    isFinished = true;
    notice(text);
    const again = document.createElement('button');
    again.textContent = word('again');
    again.addEventListener('click', () => location.reload());
    $('notice').append(' ', again);
    document.querySelectorAll('main button, main input, main textarea, main select').forEach(each => { each.disabled = true; });
    show('');
  }

  // The robot.

  const fetchWithKey = path => fetch(path, { headers: { Authorization: 'Bearer ' + key }, cache: 'no-store' })
    .then(answer => answer.ok ? answer : Promise.reject(new Error(String(answer.status))));

  function chooseByNumber(number) {
    const robot = robots.find(each => each.number === number);
    if (robot) {
      chosen = robot.name;
      $('robots').value = chosen;
    }
  }

  async function refreshRobots() {
    try {
      robots = await (await fetchWithKey('/robots')).json();
    } catch {
      robots = [];
    }
    const names = robots.map(each => each.name);
    const shown = [...$('robots').options].map(each => each.value);
    if (names.join('\n') !== shown.join('\n')) {
      const own = names.length === places ? place : -1;
      $('robots').replaceChildren(...robots.map((each, i) => new Option(
        i === own ? word('robot.own', each.name, each.number) : `${each.name} (${each.number})`, each.name)));
      chosen = names.includes(chosen) ? chosen : names[Math.max(0, own)] || chosen;
      $('robots').value = chosen;
    }
    $('robot').hidden = names.length === 0;
    const robot = robots.find(each => each.name === chosen);
    if (robot) {
      write('state', word('robot.state', words['status.' + robot.status] || robot.status, robot.x.toFixed(2), robot.y.toFixed(2), Math.round(robot.heading)));
    }
  }

  async function refreshPicture() {
    if (!chosen || document.hidden) {
      return;
    }
    try {
      const map = robots.length === places ? 'lane.svg' : 'map.svg';
      const path = `/robots/${encodeURIComponent(chosen)}/${showsCamera ? 'camera.jpg' : map}`;
      const url = URL.createObjectURL(await (await fetchWithKey(path)).blob());
      const picture = $('picture');
      await new Promise(done => { picture.onload = picture.onerror = done; picture.src = url; });
      URL.revokeObjectURL(url);
      picture.alt = word(showsCamera ? 'robot.camera.of' : 'robot.map.of', chosen);
    } catch {
      // The next attempt follows.
    }
  }

  const repeat = async (action, millis) => {
    await action();
    if (!isFinished) {
      setTimeout(() => repeat(action, millis), millis);
    }
  };

  function showLadder() {
    $('rungs').replaceChildren();
    send({ do: 'ladder', state: $('ladder').open ? 'on' : 'off' });
  }

  // Start.

  async function start() {
    words = await (await fetch(`words-${language}.json`)).json();
    document.documentElement.lang = language;
    document.querySelectorAll('[data-word]').forEach(each => { each.textContent = word(each.dataset.word); });
    document.querySelectorAll('[data-label]').forEach(each => each.setAttribute('aria-label', word(each.dataset.label)));
    makeKeys();
    $('name').value = sessionStorage.getItem('name') || '';
    $('start').addEventListener('submit', event => {
      event.preventDefault();
      sessionStorage.setItem('name', $('name').value.trim());
      Sound.wake();
      $('start').hidden = true;
      $('phone').hidden = false;
      connect();
      repeat(refreshRobots, 1000);
      repeat(refreshPicture, 500);
    });
    $('call').addEventListener('click', () => { Sound.wake(); call(); });
    $('end').addEventListener('click', end);
    $('sms').addEventListener('click', () => { $('to').value ||= /^\d+$/.test(entry) ? entry : ''; $('messages').scrollIntoView(); $('to').focus(); });
    $('log').addEventListener('click', () => { $('calls').open = true; $('calls').scrollIntoView(); $('calls').firstElementChild.focus(); });
    $('ladder').addEventListener('toggle', showLadder);
    showCalls();
    $('robots').addEventListener('change', () => { chosen = $('robots').value; });
    $('view').addEventListener('click', () => {
      showsCamera = !showsCamera;
      $('view').textContent = word(showsCamera ? 'robot.map' : 'robot.camera');
    });
    $('write').addEventListener('submit', event => {
      event.preventDefault();
      if (!socket || socket.readyState !== WebSocket.OPEN) {
        message(word('sms.unsent'));
        return;
      }
      send({ do: 'sms', number: $('to').value.trim(), text: $('text').value });
      message(word('sms.mine', $('to').value.trim(), $('text').value));
      $('text').value = '';
    });
    document.addEventListener('keydown', onKeyboard);
    document.addEventListener('keyup', event => event.code === heldCode && release());
    window.addEventListener('blur', leave);
    document.addEventListener('visibilitychange', () => document.hidden && leave());
    setInterval(() => {
      if (phase === 'connected') {
        show(remark || word('connected', peer), minutes(callSeconds()));
      }
    }, 250);
  }

  start();
})();
