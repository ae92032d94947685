// A page from http://localhost in Chromium, with roslib's browser build: prints what its paragraph shows once the robot has moved.
//   node ros_page.js URL
'use strict';
const fs = require('fs');
const puppeteer = require('puppeteer-core');

(async () => {
  const browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--headless=new'] });
  try {
    const page = await browser.newPage();
    await page.setRequestInterception(true);
    page.on('request', request => request.url().startsWith('https://cdn.jsdelivr.net/npm/')
      ? request.respond({ contentType: 'text/javascript', body: fs.readFileSync(require.resolve('roslib-1/build/roslib.min.js')) })
      : request.continue());
    page.on('pageerror', error => console.log('fault', error.message));
    await page.goto(process.argv[2]);
    await page.waitForFunction(() => parseFloat(document.querySelector('p').textContent) > 0.02);
    console.log('place', await page.evaluate(() => document.querySelector('p').textContent));
  } finally {
    await browser.close();
  }
})().catch(fault => {
  console.log(fault);
  process.exit(1);
});
