package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;
import simgsm.timer.BoundedMap;

/**
 * Service centre time stamps (TP-SCTS, TS 23.040, 9.2.3.11), in seconds on the air. A receiver regards two messages
 * with the same originator, stamp and text as one, so equal messages are stamped at least one second apart.
 */
final class TimeStamps {
    /** Largest lead of a stamp over the clock; further equal messages share it. */
    static final Duration MOST_AHEAD = Duration.ofHours(1);

    private static final int MAX_REMEMBERED = HeapShare.count(20_000, 500);

    private record Key(SmsAddress sender, Msisdn to, int protocolIdentifier, UserData userData) {}

    /** The last stamps, in whole seconds, in the order of assignment. */
    private final BoundedMap<Key, Instant> last = new BoundedMap<>(MAX_REMEMBERED);

    /** The stamp of a message accepted now. */
    Instant stamp(SmsAddress sender, Msisdn to, SubmitTpdu submit, Instant now) {
        Instant second = now.truncatedTo(ChronoUnit.SECONDS);
        forgetBefore(second);
        Key key = new Key(sender, to, submit.protocolIdentifier(), submit.userData());
        Instant before = last.get(key);
        // a later stamp predates a backward setting of the clock
        boolean isTaken = before != null && !before.isBefore(second) && !before.isAfter(now.plus(MOST_AHEAD));
        Instant next = isTaken ? before.plusSeconds(1) : now;
        Instant stamp = next.isAfter(now.plus(MOST_AHEAD)) ? before : next;
        last.putNewest(key, stamp.truncatedTo(ChronoUnit.SECONDS));
        return stamp;
    }

    /** @param messages accepted before the centre started, oldest first */
    void restore(List<ShortMessage> messages) {
        for (ShortMessage message : messages) {
            SubmitTpdu submit = TransferUnits.submitOf(message);
            Key key = new Key(message.sender(), message.to(), submit.protocolIdentifier(), submit.userData());
            last.putNewest(key, message.acceptedAt().truncatedTo(ChronoUnit.SECONDS));
        }
    }

    /** Stamps of earlier seconds can no longer be taken. */
    private void forgetBefore(Instant second) {
        var eldest = last.values().iterator();
        while (eldest.hasNext() && eldest.next().isBefore(second)) {
            eldest.remove();
        }
    }
}
