package simgsm.modem.at.command;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntConsumer;
import simgsm.air.Msisdn;
import simgsm.modem.at.AtException;
import simgsm.modem.at.AtRequest;
import simgsm.modem.at.AtResult;
import simgsm.modem.at.CmsError;
import simgsm.octets.OctetString;
import simgsm.station.context.StationEvent;

/** Submitted messages without acknowledgement. */
final class Submissions {
    private record Submitted(AtRequest request, IntConsumer acknowledged) {}

    private final AtTerminal terminal;
    private final Map<Integer, Submitted> waiting = new HashMap<>();
    private boolean isSubmitting;
    /** Outcomes received before the submission has returned. */
    private final List<StationEvent.OfSubmittedMessage> early = new ArrayList<>();

    Submissions(AtTerminal terminal) {
        this.terminal = terminal;
    }

    /**
     * Submits a unit for a command, which ends when the network has answered.
     *
     * @param acknowledged receives the message reference before the command ends with OK
     */
    AtResult submit(AtRequest request, OctetString tpdu, Msisdn to, Msisdn serviceCenter, IntConsumer acknowledged)
            throws AtException {
        if (!terminal.station().snapshot().registered()) {
            throw AtException.ofMessage(CmsError.NO_NETWORK_SERVICE);
        }
        early.clear();
        isSubmitting = true;
        int id = terminal.station().submit(tpdu, to, serviceCenter);
        isSubmitting = false;
        waiting.put(id, new Submitted(request, acknowledged));
        early.stream().filter(event -> event.id() == id).toList().forEach(this::accept);
        return AtResult.PENDING;
    }

    void accept(StationEvent.OfSubmittedMessage event) {
        boolean isSent = event instanceof StationEvent.MessageSent;
        if (!isSent && !(event instanceof StationEvent.MessageFailed)) {
            return;
        }
        Submitted submitted = waiting.remove(event.id());
        if (submitted == null) {
            if (isSubmitting) {
                early.add(event);
            }
            return;
        }
        if (isSent) {
            submitted.acknowledged().accept(event.reference());
            submitted.request().finish(AtResult.OK);
        } else {
            int cause = ((StationEvent.MessageFailed) event).cause().code();
            submitted.request().finish(new AtResult.MessageError(cause));
        }
    }
}
