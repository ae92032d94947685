package vericommand;

import java.util.Locale;

/** What becomes of an order that has been accepted. */
public enum OrderCourse {
    /** No order is accepted: none has come, or it is being keyed, or it is refused or not valid. */
    NONE(""),
    UNDER_WAY("tone.6"),
    EXECUTED("tone.3"),
    COLLISION("tone.4"),
    INFINITE_LOOP("tone.5"),
    /** A later instruction was not possible in the status that an earlier one had led to. */
    NOT_POSSIBLE("tone.8"),
    /** Ended by the order {@code ###} or by the brake. */
    STOPPED("course.stopped"),
    /** Motors or robot were switched off, or the world has changed, or its process has failed or was ended. */
    BROKEN_OFF("course.broken-off"),
    /** Stopped, for the call that gave it has ended. */
    CALL_ENDED("course.call-ended");

    private final String key;

    OrderCourse(String key) {
        this.key = key;
    }

    /** In words, empty for {@link #NONE}; those of the reply tone where there is one. */
    public String words(Locale locale) {
        return key.isEmpty() ? "" : VeriCommandTexts.text(locale, key);
    }
}
