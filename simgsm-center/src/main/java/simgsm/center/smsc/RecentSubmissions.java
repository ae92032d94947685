package simgsm.center.smsc;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.UserData;
import simgsm.timer.BoundedMap;

/**
 * The latest submissions of mobiles, so that one repeated after a lost acknowledgement is not stored twice (TP-RD,
 * TS 23.040, 9.2.3.25). The standard compares with messages still held; this compares with delivered ones too, because an
 * order to a robot must not be executed twice.
 */
final class RecentSubmissions {
    static final long REMEMBERED_NANOS = Duration.ofHours(1).toNanos();
    static final int MAX_REMEMBERED = HeapShare.count(20_000, 500);

    /** Number of further messages of its sender after which a submission counts as new: references repeat after 256. */
    static final int MOST_SINCE = 128;

    /** The ticket of a submission that was stored before the centre started. */
    private static final long STORED = 0;

    private record Key(Msisdn from, Msisdn to, int reference, UserData userData) {}

    /** @param place the sender's number of submissions up to this one */
    private record Remembered(long ticket, long submittedNanos, long place) {}

    private final BoundedMap<Key, Remembered> recent = new BoundedMap<>(MAX_REMEMBERED);
    /** Number of submissions by sender. */
    private final BoundedMap<Msisdn, Long> sent = new BoundedMap<>(MAX_REMEMBERED);

    /** The ticket of the submission that this one repeats, if it is a repetition. */
    Optional<Long> original(Msisdn from, Msisdn to, SubmitTpdu submit, long nowNanos) {
        return Optional.ofNullable(recent.get(key(from, to, submit)))
                .filter(found -> nowNanos - found.submittedNanos <= REMEMBERED_NANOS
                        && sent.getOrDefault(from, 0L) - found.place <= MOST_SINCE)
                .map(Remembered::ticket);
    }

    /** @param messages accepted before the centre started, oldest first */
    void restore(List<ShortMessage> messages, Instant now, long nowNanos) {
        for (ShortMessage message : messages) {
            if (message.esme().isEmpty()) {
                long ageNanos = Duration.between(message.acceptedAt(), now).toNanos();
                remember(message.from(), message.to(), TransferUnits.submitOf(message), STORED, nowNanos - ageNanos);
            }
        }
    }

    void remember(Msisdn from, Msisdn to, SubmitTpdu submit, long ticket, long nowNanos) {
        long place = sent.merge(from, 1L, Long::sum);
        recent.putNewest(key(from, to, submit), new Remembered(ticket, nowNanos, place));
    }

    /** Forgets a submission that was not stored, so that its repetition is accepted. */
    void forget(Msisdn from, Msisdn to, SubmitTpdu submit) {
        recent.remove(key(from, to, submit));
    }

    private static Key key(Msisdn from, Msisdn to, SubmitTpdu submit) {
        return new Key(from, to, submit.reference(), submit.userData());
    }
}
