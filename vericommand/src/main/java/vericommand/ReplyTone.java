package vericommand;

import java.util.Locale;

/** The DTMF digit by which the robot replies in a call. */
public enum ReplyTone {
    CONNECTION_ACCEPTED(true),
    CONNECTION_DENIED(true),
    EXECUTED(true),
    COLLISION(true),
    INFINITE_LOOP(true),
    EXECUTING(true),
    NOT_VALID(false),
    NOT_POSSIBLE(false);

    private final boolean fromPaper;

    ReplyTone(boolean fromPaper) {
        this.fromPaper = fromPaper;
    }

    /** True for the paper's six tones, false for 7 and 8. */
    public boolean fromPaper() {
        return fromPaper;
    }

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
