// Uses the centre's services with node-smpp: node_smpp_services.js PORT NUMBER PHONE
// Binds as a transceiver for NUMBER, refuses the first text "bad" with 0x58, and prints "got TEXT" for each deliver_sm.
// Submits "all" to PHONE and to letters in one submit_multi; "later" for 6 s from now; "now" for now; "old" for an hour from
// now, which it replaces by "new" for 1 s from now. Prints what is answered. Ends with 0 once all is answered and "bad" has
// come twice.
const smpp = require('smpp');

const [port, number, phone] = process.argv.slice(2);
const address = {source_addr_ton: 1, source_addr_npi: 1, source_addr: number};
const got = [];
let answers = 0;
const session = smpp.connect({url: `smpp://127.0.0.1:${port}`});

function end() {
  if (answers === 5 && got.filter(text => text === 'bad').length === 2) {
    session.unbind(() => process.exit(0));
  }
}

function answered(...words) {
  console.log(...words);
  answers++;
  end();
}

function submit(text, schedule, then) {
  session.submit_sm(
    {...address, destination_addr: phone, short_message: text, schedule_delivery_time: schedule},
    pdu => then(pdu));
}

session.on('error', error => {
  console.log('error', error.message);
  process.exit(1);
});
session.on('deliver_sm', pdu => {
  const text = pdu.short_message.message;
  console.log('got', text);
  got.push(text);
  const isRefused = text === 'bad' && got.indexOf('bad') === got.length - 1;
  session.send(pdu.response({command_status: isRefused ? smpp.ESME_RTHROTTLED : 0}));
  end();
});
session.on('connect', () => {
  session.bind_transceiver({system_id: 'node-smpp', password: '', address_range: number}, () => {
    session.submit_multi(
      {
        ...address,
        dest_address: [
          {dest_addr_ton: 1, dest_addr_npi: 1, destination_addr: phone},
          {dest_addr_ton: 5, dest_addr_npi: 0, destination_addr: 'Letters'},
        ],
        short_message: 'all',
      },
      pdu => answered(
        'multi', pdu.command_status,
        pdu.unsuccess_sme.map(each => `${each.destination_addr}:${each.error_status_code}`).join()));
    submit('later', '000000000006000R', pdu => answered('scheduled', pdu.command_status));
    submit('now', '', pdu => answered('submitted', pdu.command_status));
    submit('old', '000000010000000R', submitted => {
      answered('scheduled', submitted.command_status);
      session.replace_sm(
        {
          ...address,
          message_id: submitted.message_id,
          schedule_delivery_time: '000000000001000R',
          short_message: 'new',
        },
        pdu => answered('replaced', pdu.command_status));
    });
  });
});
