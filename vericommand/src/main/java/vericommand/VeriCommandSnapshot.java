package vericommand;

import java.util.List;

/**
 * What a window shows of a {@link VeriCommand}; the replies as they were sent, in the language of its settings.
 *
 * @param from the number of the current or last call or message, empty if unknown; of a program's order its operator
 * @param inCall whether a call is up
 * @param underWay whether an order is being executed
 * @param keys of the current or last order as received, without blanks; in a call also those skipped after a fault
 * @param words the order in words, empty unless it is complete
 * @param verdictWord {@code accepted}, {@code refused}, {@code invalid}, {@link #UNFINISHED}, {@link #IDLE}, or
 *     empty while the order is being keyed
 * @param verdictText the verdict in words
 * @param course what has become of an accepted order
 * @param failingPosition the offending key, counted from 1 in {@code keys}; 0 if none. One more than the number of keys: a
 *     key is missing
 * @param replies to this call, message or program so far, the newest last, as {@code 3 Done: ...}; at most the last eight
 */
public record VeriCommandSnapshot(
        String from,
        OrderSource source,
        boolean inCall,
        boolean underWay,
        String keys,
        LocalizedText words,
        String verdictWord,
        LocalizedText verdictText,
        OrderCourse course,
        int failingPosition,
        List<String> replies) {
    /** The verdict's word once the call has ended within the order. */
    public static final String UNFINISHED = "unfinished";

    /** The verdict's word once the modem has ended the call, for no key had come for too long. */
    public static final String IDLE = "idle";
}
