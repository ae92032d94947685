package simgsm.sms;

/** Coding of the text of a user part, and the length that fits (TS 23.040, 9.2.3.24). */
public enum Alphabet {
    /** Septets, packed. */
    GSM_7BIT(160, 153),
    /** Data; as text it is read as ISO 8859-1, one character an octet. */
    OCTETS(140, 134),
    /** Two octets a character; a surrogate pair for a character beyond the first plane. */
    UCS2(70, 67);

    private final int unitsInOnePart;
    private final int unitsInEachOfMany;

    Alphabet(int unitsInOnePart, int unitsInEachOfMany) {
        this.unitsInOnePart = unitsInOnePart;
        this.unitsInEachOfMany = unitsInEachOfMany;
    }

    /** Septets, octets or two-octet characters in a message of one part. */
    public int unitsInOnePart() {
        return unitsInOnePart;
    }

    /** Units in each part of several, with a header of 6 octets. */
    public int unitsInEachOfMany() {
        return unitsInEachOfMany;
    }

    /** The alphabet with the fewest octets that codes this text without loss. */
    public static Alphabet of(String text) {
        return GsmAlphabet.encodes(text) ? GSM_7BIT : UCS2;
    }
}
