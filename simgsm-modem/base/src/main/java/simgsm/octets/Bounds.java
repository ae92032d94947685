package simgsm.octets;

/** Checks of the values of a message's fields. */
public final class Bounds {
    private Bounds() {}

    /**
     * Checks that {@code least <= value <= most}.
     *
     * @return the value
     * @throws IllegalArgumentException as "what 300 is not 0 to 255" otherwise
     */
    public static int check(String what, int value, int least, int most) {
        if (value < least || value > most) {
            throw new IllegalArgumentException(what + " " + value + " is not " + least + " to " + most);
        }
        return value;
    }

    /** Checks that the value fits one octet, 0 to 255. */
    public static int checkOctet(String what, int value) {
        return check(what, value, 0, 0xff);
    }
}
