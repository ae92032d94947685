package simgsm.sim;

import simgsm.octets.Bounds;

/**
 * PIN and PUK of a card, CHV1 and its unblock code (TS 51.011, 9.3 and 11.3.1), as the SIM file keeps them.
 *
 * @param pin 4 to 8 digits
 * @param puk 8 digits
 * @param isEnabled true if the card asks for its PIN after power on
 * @param tries left for the PIN, 0 to 3; with 0 the card asks for its PUK
 * @param pukTries left for the PUK, 0 to 10; with 0 the card is blocked for ever
 */
public record CardPin(String pin, String puk, boolean isEnabled, int tries, int pukTries) {
    public static final int TRIES = 3;
    public static final int PUK_TRIES = 10;

    public CardPin {
        if (!isPin(pin)) {
            throw new IllegalArgumentException("expected pin= with 4 to 8 digits");
        }
        if (!isPuk(puk)) {
            throw new IllegalArgumentException("expected puk= with 8 digits");
        }
        Bounds.check("pin-tries", tries, 0, TRIES);
        Bounds.check("puk-tries", pukTries, 0, PUK_TRIES);
    }

    public static boolean isPin(String text) {
        return text.matches("[0-9]{4,8}");
    }

    public static boolean isPuk(String text) {
        return text.matches("[0-9]{8}");
    }

    CardPin withTries(int left, int pukLeft) {
        return new CardPin(pin, puk, isEnabled, left, pukLeft);
    }

    CardPin with(String newPin, boolean enabled) {
        return new CardPin(newPin, puk, enabled, tries, pukTries);
    }

    /** Without the codes, because logs may contain it. */
    @Override
    public String toString() {
        return "PIN" + (isEnabled ? "" : " off") + ", tries " + tries + " and " + pukTries;
    }
}
