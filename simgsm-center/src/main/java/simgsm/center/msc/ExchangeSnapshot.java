package simgsm.center.msc;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageHistory;

/**
 * The exchange at one moment, for a window. Lists are bounded by {@link #MAX_ROWS}; the counts tell all.
 *
 * @param links open connections, registered or not
 * @param attached subscribers who are attached
 * @param waiting messages and reports that wait for their receivers
 * @param ladder the latest signalling messages, oldest first
 * @param ladderCount how many have passed since the start; the last entry of {@code ladder} is number {@code ladderCount}
 * @param latest what began last: a call, or a short message
 * @param broadcasts those that are repeated
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
        List<BroadcastView> broadcasts) {
    public static final int MAX_ROWS = 1_000;

    /** @param imei empty until the subscriber has registered once; @param barred whether the operator lets him not register */
    public record SubscriberRow(Msisdn number, boolean attached, String imsi, String imei, boolean barred) {
        /** Of a subscriber who may register. */
        public SubscriberRow(Msisdn number, boolean attached, String imsi, String imei) {
            this(number, attached, imsi, imei, false);
        }
    }

    /** A message that waits, or one that has ended lately. */
    public record MessageRow(String text, MessageHistory history) {}

    /** @param text of a short message; of a call the keys heard so far, those of the called side in brackets */
    public record Passing(Msisdn from, String to, String text) {}
}
