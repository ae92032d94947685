package simgsm.air;

/** Ciphering key sequence number (TS 24.008, 10.5.1.2): 0 to 6, or 7 for no key. */
final class KeySequence {
    private static final int NO_KEY = 7;

    private KeySequence() {}

    static void check(int keySequence) {
        if (keySequence < 0 || keySequence > NO_KEY) {
            throw new IllegalArgumentException("ciphering key sequence number " + keySequence + " is not 0 to 7");
        }
    }
}
