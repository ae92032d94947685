// Types keys in a page of the gateway in Chromium, on a host name that makes it no secure context: in calls of 90 keys each, down
// for 90 ms, up for 80 ms. Never two * in turn, which would begin an order. Prints each key.   node browser_keys.js URL NUMBER COUNT
'use strict';
const puppeteer = require('puppeteer-core');

const [url, number, count] = process.argv.slice(2);
const KEYS = '123456789*0#';
const KEYS_A_CALL = 90;
const pause = millis => new Promise(done => setTimeout(done, millis));
let last = '*';
const next = () => {
  const choice = last === '*' ? KEYS.replace('*', '') : KEYS;
  last = choice[Math.floor(Math.random() * choice.length)];
  return last;
};

(async () => {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM,
    args: ['--no-sandbox', '--headless=new', '--mute-audio', '--host-resolver-rules=MAP phone.lan 127.0.0.1'],
  });
  try {
    const page = await browser.newPage();
    await page.goto(url.replace('127.0.0.1', 'phone.lan'));
    await page.waitForFunction(() => document.querySelector('#begin').textContent !== '');
    await page.click('#begin');
    await page.waitForSelector('#lamp.on');
    const phase = wanted => page.waitForFunction(name => document.body.dataset.phase === name, { timeout: 60000 }, wanted);
    for (let typed = 0; typed < count;) {
      await page.type('body', number);
      await page.keyboard.press('Enter');
      await phase('connected');
      await page.waitForSelector('#tones li');
      for (let i = 0; i < KEYS_A_CALL && typed < count; i++, typed++) {
        const key = next();
        console.log('key', key);
        await page.keyboard.down(key);
        await pause(90);
        await page.keyboard.up(key);
        await pause(80);
      }
      await pause(1000);
      await page.keyboard.press('Escape');
      await phase('idle');
    }
  } finally {
    await browser.close();
  }
})().catch(error => {
  console.log(error);
  process.exit(1);
});
