package simgsm.center.msc;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.msc.call.CallView;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.subscriber.Subscriber;
import simgsm.event.EventLine;

/**
 * The exchange at one moment, for a window. Lists have at most {@link #MAX_ROWS} elements; the counts are complete.
 *
 * @param links open connections, registered or not
 * @param attached attached subscribers
 * @param waiting waiting messages and reports
 * @param ladder the latest signalling messages, oldest first
 * @param ladderCount signalling messages since the start, the number of the last entry of {@code ladder}
 * @param latest the latest call or short message
 * @param broadcasts repeated broadcasts
 * @param endedCalls the latest cleared calls, newest first
 */
public record ExchangeSnapshot(
        Instant time,
        int links,
        int attached,
        int waiting,
        long speechFrames,
        List<SubscriberRow> subscribers,
        List<CallView> calls,
        List<MessageRow> messages,
        List<LadderEntry> ladder,
        long ladderCount,
        Optional<Passing> latest,
        List<BroadcastView> broadcasts,
        List<CallView> endedCalls) {
    public static final int MAX_ROWS = 1_000;

    /**
     * Answer to {@code subscribers}: attached, detached or barred.
     *
     * @param imei empty before the first registration;
     * @param barred true if the operator has barred the subscriber
     */
    @EventLine("subscriber number= state=")
    public record SubscriberRow(Msisdn number, boolean attached, String imsi, String imei, boolean barred) {
        public static SubscriberRow of(Subscriber subscriber, boolean barred) {
            return new SubscriberRow(
                    subscriber.number(),
                    subscriber.isAttached(),
                    subscriber.imsi().digits(),
                    subscriber.imei().map(Imei::digits).orElse(""),
                    barred);
        }

        /** {@code attached}, {@code detached} or {@code barred}. */
        public String state() {
            return attached ? "attached" : barred ? "barred" : "detached";
        }

        /** A provisioned subscriber. */
        public SubscriberRow(Msisdn number, boolean attached, String imsi, String imei) {
            this(number, attached, imsi, imei, false);
        }
    }

    /** A message that waits, or has ended recently. */
    public record MessageRow(String text, MessageHistory history) {}

    /** @param text of a short message; for a call, the keys decoded so far, those of the called party in brackets */
    public record Passing(Msisdn from, String to, String text) {}
}
