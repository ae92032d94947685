package vericommand;

import java.util.Locale;
import java.util.Optional;

/** Course of an accepted order. */
public enum OrderCourse {
    /** No order is accepted: none was given, or it is incomplete, refused or invalid. */
    NONE(""),
    UNDER_WAY(ReplyTone.EXECUTING),
    EXECUTED(ReplyTone.EXECUTED),
    COLLISION(ReplyTone.COLLISION),
    INFINITE_LOOP(ReplyTone.INFINITE_LOOP),
    /** A later instruction was not possible in the status reached by an earlier one. */
    NOT_POSSIBLE(ReplyTone.NOT_POSSIBLE),
    /** Ended by the order {@code ###} or by the brake. */
    STOPPED("course.stopped"),
    /** The motors or the robot were switched off, the world changed, or the process failed or was ended. */
    BROKEN_OFF("course.broken-off"),
    /** Stopped because the call that gave the order ended. */
    CALL_ENDED("course.call-ended");

    /** Key of the text; empty if the tone's words are used. */
    private final String key;

    /** Null if no tone reports this course. */
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

    /** The tone that reports this course to the operator. */
    public Optional<ReplyTone> tone() {
        return Optional.ofNullable(tone);
    }

    /** The course in words, by default the reply tone's; empty for {@link #NONE}. */
    public String words(Locale locale) {
        if (tone != null) {
            return tone.words(locale);
        }
        return key.isEmpty() ? "" : VeriCommandTexts.text(locale, key);
    }
}
