package simgsm.center.journal;

/**
 * A part of a file without valid records.
 *
 * @param from its first octet
 * @param to the octet after its last one
 * @param isTail whether no valid record follows, as after a crash while a record was written
 */
record Damage(String file, long from, long to, boolean isTail) {
    @Override
    public String toString() {
        return isTail
                ? file + ": torn at octet " + from + "; the last " + (to - from) + " octets are cut off"
                : file + ": damaged from octet " + from + " to " + (to - 1) + "; the records around it are saved";
    }
}
