package vericommand;

import java.util.Locale;

/** The DTMF digit of a reply in a call: the paper's six, and two of this suite. */
public enum ReplyTone {
    CONNECTION_ACCEPTED,
    CONNECTION_DENIED,
    EXECUTED,
    COLLISION,
    INFINITE_LOOP,
    EXECUTING,
    NOT_VALID,
    NOT_POSSIBLE;

    /** 1..8. */
    public int number() {
        return ordinal() + 1;
    }

    /** The digit to send, {@code '1'..'8'}. */
    public char key() {
        return (char) ('0' + number());
    }

    /** The meaning, as the operator's phone shows it. */
    public String words(Locale locale) {
        return VeriCommandTexts.text(locale, "tone." + number());
    }
}
