package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;

/**
 * What has lately been handed in, so that a sender who lost the acknowledgement may send again without the message
 * arriving twice (TP-RD of TS 23.040, 9.2.3.25). The standard asks this only for messages still held; but a robot must
 * not drive an order twice because the first copy was delivered too fast.
 */
final class RecentSubmissions {
    static final long REMEMBERED_NANOS = Duration.ofHours(1).toNanos();
    static final int MAX_REMEMBERED = 20_000;

    /** Whoever has sent so many others since means a new message: references come round after 256. */
    static final int MOST_SINCE = 128;

    /** The ticket of a submission that was answered in an earlier life. */
    private static final long STORED = 0;

    private record Key(Msisdn from, Msisdn to, int reference, UserData userData) {}

    /** @param place how many its sender had sent before it */
    private record Remembered(long ticket, long submittedNanos, long place) {}

    private final Map<Key, Remembered> recent = new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Key, Remembered> eldest) {
            return size() > MAX_REMEMBERED;
        }
    };

    /** How many messages each sender has sent. */
    private final Map<Msisdn, Long> sent = new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Msisdn, Long> eldest) {
            return size() > MAX_REMEMBERED;
        }
    };

    /** The ticket of the submission that this one repeats, if it is a repetition. */
    Optional<Long> original(Msisdn from, Msisdn to, SubmitTpdu submit, long nowNanos) {
        Remembered found = recent.get(key(from, to, submit));
        boolean isTooOld = found == null
                || nowNanos - found.submittedNanos > REMEMBERED_NANOS
                || sent.getOrDefault(from, 0L) - found.place > MOST_SINCE;
        return isTooOld ? Optional.empty() : Optional.of(found.ticket);
    }

    /** @param messages accepted in an earlier life, oldest first */
    void restore(List<ShortMessage> messages, Instant now, long nowNanos) {
        for (ShortMessage message : messages) {
            if (message.esme().isEmpty()) {
                long ageNanos = Duration.between(message.acceptedAt(), now).toNanos();
                remember(message.from(), message.to(), TransferUnits.submitOf(message), STORED, nowNanos - ageNanos);
            }
        }
    }

    void remember(Msisdn from, Msisdn to, SubmitTpdu submit, long ticket, long nowNanos) {
        Key key = key(from, to, submit);
        long place = sent.merge(from, 1L, Long::sum);
        recent.remove(key);
        recent.put(key, new Remembered(ticket, nowNanos, place));
    }

    /** The submission came to nothing; a repetition is welcome. */
    void forget(Msisdn from, Msisdn to, SubmitTpdu submit) {
        recent.remove(key(from, to, submit));
    }

    private static Key key(Msisdn from, Msisdn to, SubmitTpdu submit) {
        return new Key(from, to, submit.reference(), submit.userData());
    }
}
