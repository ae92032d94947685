package simgsm.phone.handset;

import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Queue;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.phone.store.Mailbox;
import simgsm.station.StationCommands;
import simgsm.station.context.StationEvent;

/** Submits messages, and defers the station's events that arrive before the mailbox has the message. */
final class MessageSubmission {
    private final Mailbox mailbox;
    private final Queue<StationEvent> deferred = new ArrayDeque<>();
    private boolean isSubmitting;

    MessageSubmission(Mailbox mailbox) {
        this.mailbox = mailbox;
    }

    Optional<Refusal> submit(StationCommands station, Msisdn to, String text) {
        if (text.isEmpty()) {
            return Optional.of(Refusal.EMPTY_TEXT);
        }
        if (!station.snapshot().powered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        if (!station.snapshot().card().isReady()) {
            return Optional.of(Refusal.SIM_LOCKED);
        }
        isSubmitting = true;
        try {
            mailbox.submitted(station.sendMessage(to, text), to.toString(), text);
            return Optional.empty();
        } catch (IllegalArgumentException tooLong) {
            return Optional.of(Refusal.TEXT_TOO_LONG);
        } finally {
            isSubmitting = false;
        }
    }

    /** Keeps the event for {@link #release} while a message is being submitted. @return false if none is */
    boolean defers(StationEvent event) {
        return isSubmitting && deferred.add(event);
    }

    /** Passes the deferred events on, in their order. */
    void release(Consumer<StationEvent> receiver) {
        for (StationEvent event = deferred.poll(); event != null; event = deferred.poll()) {
            receiver.accept(event);
        }
    }
}
