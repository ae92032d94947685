package simgsm.center.journal;

/**
 * A part of a file without valid records.
 *
 * @param from its first octet
 * @param to end, exclusive
 * @param isTail true if no valid record follows, as after a crash during a write
 */
record Damage(String file, long from, long to, boolean isTail) {
    /** The damage and its position in words. */
    String place() {
        return file + (isTail ? ": torn at octet " + from : ": damaged from octet " + from + " to " + (to - 1));
    }

    @Override
    public String toString() {
        return place()
                + (isTail ? "; the last " + (to - from) + " octets are cut off" : "; the records around it are saved");
    }
}
