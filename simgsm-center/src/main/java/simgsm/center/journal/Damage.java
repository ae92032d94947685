package simgsm.center.journal;

/**
 * A stretch of a file that holds no records.
 *
 * @param to behind its last octet
 * @param isTail whether nothing good follows it: what a crash leaves of a record that was being written
 */
record Damage(String file, long from, long to, boolean isTail) {
    @Override
    public String toString() {
        return isTail
                ? file + ": torn at octet " + from + "; the last " + (to - from) + " octets are cut off"
                : file + ": damaged from octet " + from + " to " + (to - 1) + "; the records around it are saved";
    }
}
