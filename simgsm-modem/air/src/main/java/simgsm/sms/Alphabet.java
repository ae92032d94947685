package simgsm.sms;

/** How text stands in a user part, and how much of it fits (TS 23.040, 9.2.3.24). */
public enum Alphabet {
    /** Septets, packed. */
    GSM_7BIT(160, 153),
    /** Data; read as text it is Latin-1, one character an octet. */
    OCTETS(140, 134),
    /** Two octets a character; a character beyond the first plane takes a surrogate pair. */
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

    /** The same in each part of several, beside the header of 6 octets. */
    public int unitsInEachOfMany() {
        return unitsInEachOfMany;
    }

    /** The smallest alphabet that carries this text unharmed. */
    public static Alphabet of(String text) {
        return GsmAlphabet.encodes(text) ? GSM_7BIT : UCS2;
    }
}
