// A page of the gateway in Chromium, on a host name that makes it no secure context, as in a classroom: drives the robot by
// keyboard and by touch, and prints what was shown; writes what the page played (16 bit, mono, 8 kHz) and a picture of the
// projector's page.   node browser_order.js URL NUMBER SOUND.raw CODE.png
'use strict';
const fs = require('fs');
const puppeteer = require('puppeteer-core');

const [url, number, sound, code] = process.argv.slice(2);
const pause = millis => new Promise(done => setTimeout(done, millis));

(async () => {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM,
    args: ['--no-sandbox', '--headless=new', '--mute-audio', '--host-resolver-rules=MAP phone.lan 127.0.0.1'],
  });
  try {
    const page = await browser.newPage();
    const faults = [];
    page.on('console', message => message.type() === 'error' && faults.push(message.text()));
    page.on('pageerror', error => faults.push(error.message));
    page.on('request', request => new URL(request.url()).hostname !== 'phone.lan' && request.url().startsWith('http')
      && faults.push('a request to ' + request.url()));
    await page.setViewport({ width: 360, height: 740, hasTouch: true, isMobile: true });
    await page.goto(url.replace('127.0.0.1', 'phone.lan'));
    await page.waitForFunction(() => document.querySelector('#begin').textContent !== '');
    console.log('secure', await page.evaluate(() => window.isSecureContext));
    await page.type('#name', 'Ana');
    await page.click('#begin');
    await page.waitForSelector('#lamp.on');
    await page.evaluate(() => {
      // The longest block: Chromium loses one when the page's thread is busy for as long.
      const recorder = Sound.context().createScriptProcessor(16384, 1, 1);
      window.played = [];
      recorder.onaudioprocess = event => window.played.push(...event.inputBuffer.getChannelData(0));
      Sound.output().connect(recorder);
      recorder.connect(Sound.context().destination);
    });
    const keyboard = async keys => {
      for (const key of keys) {
        await page.keyboard.down(key);
        await pause(90);
        await page.keyboard.up(key);
        await pause(80);
      }
    };
    const touch = async keys => {
      for (const key of keys) {
        const box = await (await page.$(`#keys [data-key="${key}"]`)).boundingBox();
        const finger = await page.touchscreen.touchStart(box.x + box.width / 2, box.y + box.height / 2);
        await pause(90);
        await finger.end();
        await pause(80);
      }
    };
    const tones = count => page.waitForFunction(
      wanted => document.querySelectorAll('#tones li').length >= wanted, { timeout: 60000 }, count);
    const text = id => page.$eval(id, element => element.textContent);
    await page.keyboard.down('#');
    await page.keyboard.up('3');
    await page.keyboard.down('Alt');
    await page.keyboard.press('*');
    await page.keyboard.up('Alt');
    console.log('signs', await text('#keyed'), await page.$$eval('#keys .down', keys => keys.length));
    await page.keyboard.down('5');
    await page.evaluate(() => window.dispatchEvent(new Event('blur')));
    await page.keyboard.up('5');
    console.log('left', await text('#line'), await page.$$eval('#keys .down', keys => keys.length));
    await page.keyboard.press('Escape');
    console.log('frames after a minute', await page.evaluate(() => {
      let frames = 0;
      const keys = new Sound.KeySource(() => frames++);
      keys.begun -= 60000;
      for (let i = 0; i < 300; i++) {
        keys.tick();
      }
      keys.stop();
      return Math.round(frames / 10) * 10;
    }));
    await keyboard(number);
    await page.keyboard.press('Enter');
    await tones(1);
    await page.waitForFunction(() => document.querySelector('#clock').textContent !== '');
    console.log('line', await text('#line'));
    await keyboard('**#**20**');
    await tones(3);
    await touch('**#*#90**');
    await tones(5);
    console.log('tones', (await page.$eval('#tones', list => list.innerText)).replace(/\s+/g, ' '));
    await page.waitForFunction(() => /Stopped.* 270/.test(document.querySelector('#state').textContent));
    console.log('state', await page.$eval('#state', text => text.textContent.replace(/ +/g, ' ')));
    await page.waitForSelector('#tones .said');
    console.log('said', await text('#tones .said'));
    const heard = await page.evaluate(() => window.played.length + 2 * Sound.context().sampleRate);
    await page.waitForFunction(wanted => window.played.length >= wanted, { polling: 100 }, heard);
    await page.keyboard.press('Escape');
    await page.waitForFunction(() => document.body.dataset.phase === 'idle');
    await page.keyboard.press('Enter');
    console.log('redial', await page.$eval('#keyed', text => text.textContent));
    await page.click('#log');
    console.log('calls', await page.$eval('#past', list => list.innerText.replace(/\s+/g, ' ')));
    await page.click('#ladder summary');
    await page.waitForFunction(() => /Call Proceeding/.test(document.querySelector('#rungs').textContent));
    console.log('ladder', await page.$$eval('#rungs li', rungs => rungs.map(each => each.className + ' ' + each.lastChild.textContent).join(', ')));
    const rate = await page.evaluate(() => Sound.context().sampleRate);
    const played = await page.evaluate(() => window.played);
    const samples = Int16Array.from({ length: Math.floor(played.length * 8000 / rate) },
      (_, i) => Math.round(32767 * played[Math.floor(i * rate / 8000)]));
    fs.writeFileSync(sound, Buffer.from(samples.buffer));
    await page.setViewport({ width: 1280, height: 720 });
    await page.goto(url.replace('127.0.0.1', 'phone.lan').replace('/#', '/link.html#'));
    await page.waitForFunction(() => document.querySelector('#code').naturalWidth > 0);
    await page.screenshot({ path: code });
    console.log('faults', faults.length, faults.join(' | '));
  } finally {
    await browser.close();
  }
})().catch(error => {
  console.log(error);
  process.exit(1);
});
