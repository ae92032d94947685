package simgsm.modem.at.command;

import java.util.Locale;
import java.util.Optional;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.CmeError;
import simgsm.sim.PinLock;
import simgsm.sms.GsmAlphabet;
import simgsm.ss.ServiceCode;
import simgsm.ss.ServiceStatus;
import simgsm.station.context.StationEvent;

/** +CUSD: the network's part of a USSD dialogue (TS 27.007, 7.15). */
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
    /** The client that has dialled a code by ATD, answered regardless of its +CUSD. */
    private Optional<AtClient> dialling = Optional.empty();

    UssdCodes(AtModem modem) {
        this.modem = modem;
    }

    /** Sends a code or the reply to the network; the terminal itself answers the code for its identity. */
    void send(AtClient client, String text, boolean isDialled) throws AtException {
        if (text.equals(ServiceCode.IMEI)) {
            if (isDialled || client.settings().ussdMode == 1) {
                client.report("+CUSD: "
                        + text(
                                client,
                                OVER,
                                modem.terminal().station().identity().imei().digits()));
            }
            return;
        }
        if (PinLock.isCode(text)) {
            SimCommands.useCard(client, card -> card.perform(text));
            return;
        }
        try {
            if (!modem.terminal().sendUssd(text)) {
                throw new AtException(CmeError.OPERATION_NOT_ALLOWED);
            }
        } catch (IllegalArgumentException tooLong) {
            throw new AtException(CmeError.TEXT_TOO_LONG);
        }
        dialling = Optional.of(client).filter(asking -> isDialled);
    }

    void accept(StationEvent.OfUssd event) {
        for (AtClient client : modem.clients()) {
            if (client.settings().ussdMode == 1 || dialling.equals(Optional.of(client))) {
                client.report("+CUSD: " + code(client, event));
            }
        }
        if (!(event instanceof StationEvent.UssdReceived received && received.replyExpected())) {
            dialling = Optional.empty();
        }
    }

    private static String text(AtClient client, int state, String text) {
        String encoded = AtRequest.quoted(client.settings().characterSet.encode(text));
        return state + "," + encoded + "," + (GsmAlphabet.encodes(text) ? GSM : UCS2);
    }

    /** The service and its state, such as {@code forwarding unconditional: active, +5550299}. */
    private static String words(ServiceStatus status) {
        String service = status.service().name().toLowerCase(Locale.ROOT).replace('_', ' ');
        return service + ": " + status.state()
                + status.forwardedTo().map(number -> ", " + number).orElse("");
    }

    private static String code(AtClient client, StationEvent.OfUssd event) {
        if (event instanceof StationEvent.UssdReceived received) {
            return text(client, received.replyExpected() ? REPLY_EXPECTED : OVER, received.text());
        }
        if (event instanceof StationEvent.ServiceAnswered answer) {
            return text(client, OVER, words(answer.status()));
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
