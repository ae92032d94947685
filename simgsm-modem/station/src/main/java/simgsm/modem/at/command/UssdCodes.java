package simgsm.modem.at.command;

import simgsm.modem.at.AtRequest;
import simgsm.sms.GsmAlphabet;
import simgsm.station.context.StationEvent;

/** +CUSD: what the network says in a USSD dialogue (TS 27.007, 7.15). */
final class UssdCodes {
    private static final int OVER = 0;
    private static final int REPLY_EXPECTED = 1;
    private static final int ENDED_BY_NETWORK = 2;
    private static final int NOT_SUPPORTED = 4;
    private static final int TIMEOUT = 5;

    /** Data coding schemes of cell broadcast: GSM alphabet without a language, UCS2 (TS 23.038, 5). */
    private static final int GSM = 15;

    private static final int UCS2 = 72;

    private final AtModem modem;

    UssdCodes(AtModem modem) {
        this.modem = modem;
    }

    void accept(StationEvent.OfUssd event) {
        for (AtClient client : modem.clients()) {
            if (client.settings().ussdMode == 1) {
                client.report("+CUSD: " + code(client, event));
            }
        }
    }

    private static String code(AtClient client, StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived received) {
            String text = AtRequest.quoted(client.settings().characterSet.encode(received.text()));
            int coding = GsmAlphabet.encodes(received.text()) ? GSM : UCS2;
            return (received.replyExpected() ? REPLY_EXPECTED : OVER) + "," + text + "," + coding;
        }
        if (event instanceof StationEvent.ServiceAnswered) {
            return Integer.toString(OVER);
        }
        int how = switch (((StationEvent.UssdEnded) event).how()) {
            case COMPLETED -> OVER;
            case REFUSED -> NOT_SUPPORTED;
            case NO_ANSWER -> TIMEOUT;
            case ENDED_BY_NETWORK, NO_SERVICE, CANCELLED -> ENDED_BY_NETWORK;
        };
        return Integer.toString(how);
    }
}
