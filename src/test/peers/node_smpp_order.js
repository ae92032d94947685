// Drives the robot with node-smpp: node_smpp_order.js PORT NUMBER ROBOT ORDER
// Binds as a transceiver for NUMBER, submits ORDER to ROBOT with a receipt asked for, and prints
// "receipt STATE" and "reply TEXT" as they come; ends with 0 once both are there.
const smpp = require('smpp');

const [port, number, robot, order] = process.argv.slice(2);
const seen = new Set();
const session = smpp.connect({url: `smpp://127.0.0.1:${port}`});

session.on('error', error => {
  console.log('error', error.message);
  process.exit(1);
});
session.on('deliver_sm', pdu => {
  const text = pdu.short_message.message;
  if (pdu.esm_class & 0x04) {
    console.log('receipt', /stat:(\S+)/.exec(text)[1]);
    seen.add('receipt');
  } else {
    console.log('reply', text);
    seen.add('reply');
  }
  session.send(pdu.response());
  if (seen.size === 2) {
    session.unbind(() => process.exit(0));
  }
});
session.on('connect', () => {
  session.bind_transceiver({system_id: 'node-smpp', password: '', address_range: number}, bound => {
    if (bound.command_status !== 0) {
      console.log('bind refused', bound.command_status);
      process.exit(1);
    }
    session.submit_sm(
      {source_addr: number, destination_addr: robot, short_message: order, registered_delivery: 1},
      submitted => console.log('submitted', submitted.message_id));
  });
});
