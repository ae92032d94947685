package vericommand;

import java.util.Locale;
import java.util.Optional;

/** Course of an accepted order. */
public enum OrderCourse {
    /** No order is accepted: none has come, or it is being keyed, or it is refused or not valid. */
    NONE(""),
    UNDER_WAY(ReplyTone.EXECUTING),
    EXECUTED(ReplyTone.EXECUTED),
    COLLISION(ReplyTone.COLLISION),
    INFINITE_LOOP(ReplyTone.INFINITE_LOOP),
    /** A later instruction was not possible in the status that an earlier one had led to. */
    NOT_POSSIBLE(ReplyTone.NOT_POSSIBLE),
    /** Ended by the order {@code ###} or by the brake. */
    STOPPED("course.stopped"),
    /** Motors or robot were switched off, or the world has changed, or its process has failed or was ended. */
    BROKEN_OFF("course.broken-off"),
    /** Stopped, for the call that gave it has ended. */
    CALL_ENDED("course.call-ended");

    /** Of its words; empty if they are those of the tone. */
    private final String key;

    /** Null if no tone reports it. */
    private final ReplyTone tone;

    OrderCourse(String key) {
        this.key = key;
        tone = null;
    }

    OrderCourse(ReplyTone tone) {
        key = "";
        this.tone = tone;
    }

    static OrderCourse of(ProcessEnding ending) {
        return switch (ending) {
            case DONE -> EXECUTED;
            case COLLISION -> COLLISION;
            case FAILED, REPLACED -> BROKEN_OFF;
        };
    }

    /** The tone that reports it to the operator, if there is one. */
    public Optional<ReplyTone> tone() {
        return Optional.ofNullable(tone);
    }

    /** In words, empty for {@link #NONE}; those of the reply tone where there is one. */
    public String words(Locale locale) {
        if (tone != null) {
            return tone.words(locale);
        }
        return key.isEmpty() ? "" : VeriCommandTexts.text(locale, key);
    }
}
