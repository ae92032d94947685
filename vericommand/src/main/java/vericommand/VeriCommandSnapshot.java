package vericommand;

import java.util.List;

/**
 * A window's data on a {@link VeriCommand}; the replies as sent, in the language of its settings.
 *
 * @param from the number of the current or last call or message, empty if unknown; a program's operator
 * @param inCall true during a call
 * @param underWay true while an order is being executed
 * @param keys the current or last order as received, without blanks; in a call also keys skipped after a fault
 * @param words the order in words, empty unless it is complete
 * @param verdictWord {@code accepted}, {@code refused}, {@code invalid}, {@link #UNFINISHED}, {@link #IDLE}, or empty
 *     while the order is being keyed
 * @param verdictText the verdict in words
 * @param course of an accepted order
 * @param failingPosition the offending key, counted from 1 in {@code keys}; 0 if none. One more than the number of
 *     keys: a key is missing
 * @param replies the last eight to this call, message or program, the newest last, as {@code 3 Done: ...}
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
    /** The verdict's word if the call ended within the order. */
    public static final String UNFINISHED = "unfinished";

    /** The verdict's word if the modem ended the call for want of keys. */
    public static final String IDLE = "idle";
}
