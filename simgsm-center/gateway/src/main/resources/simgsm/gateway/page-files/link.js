'use strict';
// The projector's page: the link as a QR code and in letters, and who has joined.
(async () => {
  const $ = id => document.getElementById(id);
  const language = (navigator.language || 'en').startsWith('es') ? 'es' : 'en';
  const headers = { Authorization: 'Bearer ' + location.hash.slice(1) };
  const words = await (await fetch(`words-${language}.json`)).json();
  document.documentElement.lang = language;
  const refresh = async () => {
    try {
      const answer = await fetch('users', { headers, cache: 'no-store' });
      $('notice').hidden = answer.ok;
      $('notice').textContent = answer.ok ? '' : words[answer.status === 401 ? 'closed.key' : 'link.lost'];
      if (answer.status === 401) {
        return;
      }
      if (answer.ok) {
        const users = await answer.json();
        $('count').textContent = words['link.joined'].replace('{0}', users.length);
        $('joined').replaceChildren(...users.map(user => {
          const item = document.createElement('li');
          item.textContent = `${user.name} ${user.number}`.trim();
          return item;
        }));
      }
    } catch {
      $('notice').hidden = false;
      $('notice').textContent = words['link.lost'];
    }
    setTimeout(refresh, 1000);
  };
  const code = await fetch('link.svg', { headers });
  if (code.ok) {
    const svg = await code.text();
    $('code').src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    $('code').alt = words['link.code'];
    $('address').textContent = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement.getAttribute('aria-label');
  }
  const host = location.hostname;
  if (host === 'localhost' || host.startsWith('127.')) {
    $('hint').textContent = words['link.local'];
  } else {
    $('hint').textContent = words['link.scan'];
  }
  refresh();
})();
