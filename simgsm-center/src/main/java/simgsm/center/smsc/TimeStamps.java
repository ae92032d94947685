package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;

/**
 * Service centre time stamps. On the air they count seconds (TP-SCTS; TS 23.040, 9.2.3.11), and a receiver that is given
 * the same originator, stamp and text once more takes it for the same message. So of several messages that are alike,
 * each is stamped at least a second after the one before.
 */
final class TimeStamps {
    /** A flood of messages that are all alike must not run away from the clock. */
    static final Duration MOST_AHEAD = Duration.ofHours(1);

    private static final int MAX_REMEMBERED = 20_000;

    private record Key(SmsAddress sender, Msisdn to, int protocolIdentifier, UserData userData) {}

    /** The last stamps, in whole seconds, in the order in which they were given. */
    private final Map<Key, Instant> last = new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, Instant> eldest) {
            return size() > MAX_REMEMBERED;
        }
    };

    /** The stamp of a message taken now. */
    Instant stamp(SmsAddress sender, Msisdn to, SubmitTpdu submit, Instant now) {
        Instant second = now.truncatedTo(ChronoUnit.SECONDS);
        forgetBefore(second);
        Key key = new Key(sender, to, submit.protocolIdentifier(), submit.userData());
        Instant before = last.remove(key);
        boolean isTaken = before != null && !before.isBefore(second);
        Instant next = isTaken ? before.plusSeconds(1) : now;
        Instant stamp = next.isAfter(now.plus(MOST_AHEAD)) ? before : next;
        last.put(key, stamp.truncatedTo(ChronoUnit.SECONDS));
        return stamp;
    }

    /** @param messages accepted in an earlier life, oldest first */
    void restore(List<ShortMessage> messages) {
        for (ShortMessage message : messages) {
            SubmitTpdu submit = TransferUnits.submitOf(message);
            Key key = new Key(message.sender(), message.to(), submit.protocolIdentifier(), submit.userData());
            last.remove(key);
            last.put(key, message.acceptedAt().truncatedTo(ChronoUnit.SECONDS));
        }
    }

    /** What was stamped before the present second stands in nobody's way. */
    private void forgetBefore(Instant second) {
        var eldest = last.values().iterator();
        while (eldest.hasNext() && eldest.next().isBefore(second)) {
            eldest.remove();
        }
    }
}
