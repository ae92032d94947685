package simgsm.sms;

/**
 * The place of a user part in its message (TS 23.040, 9.2.3.24.1).
 *
 * @param reference 0 to 255, or to 65535 in the 16-bit form; the same in all parts of a message
 * @param total 1 to 255
 * @param part 1 to {@code total}
 */
public record Concatenation(int reference, int total, int part) {
    public static final int MAX_PARTS = 255;

    public Concatenation {
        if (reference < 0 || reference > 0xffff || total > MAX_PARTS || part < 1 || part > total) {
            throw new IllegalArgumentException(
                    "part " + part + " of " + total + " with reference " + reference + " is out of range");
        }
    }
}
